//! The analyses of an oscillator case.

use crate::analysis::Kind;
use crate::cause::Cause;
use crate::engines_analysis::{self, ENGINES, EnginesSettings};
use crate::error::Fault;
use crate::keys::{Key, OscillatorKey};
use crate::motion_analysis::{
    BASIN, BIFURCATION, HISTORY, LIMIT_CYCLE, MotionAnalysis, MotionKeys, TIME_OF_OSCILLATOR, TimeKey,
    read_basin, read_bifurcation, read_history, read_limit_cycle,
};
use crate::read_sweep::{PlacedSweep, read_family, read_map, read_sweep, read_within};
use crate::section::Section;
use crate::sweep::{Family, StabilityMap, Sweep, Within};
use crate::swept_keys::{OscillatorKeys, SweptKeys};

/// What an analysis of an oscillator case computes.
#[derive(Debug, Clone, PartialEq)]
pub enum OscillatorAnalysis {
    /// `equivalent-damping`: ξ_eq along one key.
    EquivalentDamping(DampingCurves),
    /// `spectrum`: the eigenvalues along one key.
    Spectrum(SpectrumCurves),
    /// `critical-shear-strength`, `critical-load`: all thresholds along one key.
    Critical(CriticalThresholds),
    /// `stability-map`: the verdict over two keys.
    StabilityMap(StabilityMap<OscillatorKey>),
    /// `motion`, `limit-cycle`, `bifurcation`, `basin`: motion with stick, slip and lift-off.
    Motion(MotionAnalysis<OscillatorKey>),
    /// `engines`: one cycle by three engines.
    Engines(EnginesSettings),
}

/// ξ_eq along one key.
#[derive(Debug, Clone, PartialEq)]
pub struct DampingCurves {
    /// The swept key.
    pub sweep: Sweep<OscillatorKey>,
    /// One curve a value, where given.
    pub family: Option<Family<OscillatorKey>>,
}

/// The eigenvalues along one key.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectrumCurves {
    /// The swept key.
    pub sweep: Sweep<OscillatorKey>,
    /// One set of curves a value, where given.
    pub family: Option<Family<OscillatorKey>>,
}

/// All thresholds τ0,crit or F_n,crit along one key.
#[derive(Debug, Clone, PartialEq)]
pub struct CriticalThresholds {
    /// Of which quantity.
    pub sought: Sought,
    /// The swept key.
    pub sweep: Sweep<OscillatorKey>,
    /// Where thresholds are sought; τ0/E0* from 1e-6 to 1e3 by default, F_n/(E0* R²) from 1e-10 to 1.
    pub within: Within,
    /// One set of thresholds a value, where given.
    pub family: Option<Family<OscillatorKey>>,
    /// Whether the branch of cycles is followed from each threshold back to its fold.
    pub global_margin: bool,
}

/// Which quantity's thresholds are sought.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sought {
    /// τ0,crit.
    ShearStrength,
    /// F_n,crit.
    Load,
}

impl Sought {
    /// The key of the quantity.
    pub fn key(self) -> OscillatorKey {
        match self {
            Self::ShearStrength => OscillatorKey::ShearStrength,
            Self::Load => OscillatorKey::NormalLoad,
        }
    }

    /// The kind of analysis that seeks them.
    pub fn kind(self) -> &'static str {
        match self {
            Self::ShearStrength => "critical-shear-strength",
            Self::Load => "critical-load",
        }
    }

    /// Where they are sought where the case does not say, as a group.
    fn within(self) -> (f64, f64) {
        match self {
            Self::ShearStrength => SHEAR_STRENGTH_WITHIN,
            Self::Load => LOAD_WITHIN,
        }
    }
}

/// The default range of `critical-shear-strength`, τ0/E0*.
pub const SHEAR_STRENGTH_WITHIN: (f64, f64) = (1e-6, 1e3);

/// The default range of `critical-load`, F_n/(E0* R²).
pub const LOAD_WITHIN: (f64, f64) = (1e-10, 1e0);

/// Whether the branches of cycles are followed back to their folds where the case says nothing: for thresholds along one key
/// it takes a fraction of a second each, for a map up to a minute.
pub(crate) const MARGIN_OF_THRESHOLDS: bool = true;
pub(crate) const MARGIN_OF_MAP: bool = false;

fn read_global_margin(section: &Section<'_>, default: bool) -> Result<bool, Fault> {
    Ok(section.boolean("global_margin")?.unwrap_or(default))
}

/// The kinds of an oscillator case.
pub(crate) const KINDS: [Kind<OscillatorKeys, OscillatorAnalysis>; 10] = [
    Kind {
        name: "equivalent-damping",
        keys: &["sweep", "family"],
        declared: None,
        doc: "the equivalent damping ratio along one key",
        read: |keys, section| {
            let (sweep, family) = read_curves(keys, section)?;
            Ok(OscillatorAnalysis::EquivalentDamping(DampingCurves { sweep: sweep.sweep, family }))
        },
    },
    Kind {
        name: "spectrum",
        keys: &["sweep", "family"],
        declared: None,
        doc: "the eigenvalues along one key",
        read: |keys, section| {
            let (sweep, family) = read_curves(keys, section)?;
            Ok(OscillatorAnalysis::Spectrum(SpectrumCurves { sweep: sweep.sweep, family }))
        },
    },
    Kind {
        name: "critical-shear-strength",
        keys: &["sweep", "within", "family", "global_margin"],
        declared: None,
        doc: "the critical shear strengths along one key",
        read: |keys, section| read_critical(keys, section, Sought::ShearStrength),
    },
    Kind {
        name: "critical-load",
        keys: &["sweep", "within", "family", "global_margin"],
        declared: None,
        doc: "the critical loads along one key",
        read: |keys, section| read_critical(keys, section, Sought::Load),
    },
    Kind {
        name: "stability-map",
        keys: &["x", "y", "method", "boundaries", "global_margin"],
        declared: None,
        doc: "stable and unstable points over two keys",
        read: |keys, section| {
            let global_margin = read_global_margin(section, MARGIN_OF_MAP)?;
            let map = StabilityMap { global_margin, ..read_map(keys, section)? };
            Ok(OscillatorAnalysis::StabilityMap(map))
        },
    },
    HISTORY.kind(|keys, section| read_history(keys, section).map(OscillatorAnalysis::Motion)),
    LIMIT_CYCLE.kind(|keys, section| read_limit_cycle(keys, section).map(OscillatorAnalysis::Motion)),
    BIFURCATION.kind(|keys, section| read_bifurcation(keys, section).map(OscillatorAnalysis::Motion)),
    BASIN.kind(|keys, section| read_basin(keys, section).map(OscillatorAnalysis::Motion)),
    ENGINES.kind(|_, section| engines_analysis::read(section).map(OscillatorAnalysis::Engines)),
];

impl MotionKeys for OscillatorKeys {
    const COORDINATES: &'static [&'static str] = &["x", "y", "velocity_x", "velocity_y"];

    fn time() -> &'static Key<TimeKey> {
        &TIME_OF_OSCILLATOR
    }
}

type Curves<S> = (S, Option<Family<OscillatorKey>>);

/// Reads the sweep of an analysis and its family.
fn read_curves(
    keys: &OscillatorKeys,
    section: &Section<'_>,
) -> Result<Curves<PlacedSweep<OscillatorKey>>, Fault> {
    let sweep = read_sweep(keys, section, "sweep", None)?;
    let family = read_family(keys, section, &sweep)?;
    Ok((sweep, family))
}

/// Reads sweep and family of an analysis that seeks `sought`, which therefore can be neither.
fn read_threshold(
    keys: &OscillatorKeys,
    section: &Section<'_>,
    sought: OscillatorKey,
) -> Result<Curves<Sweep<OscillatorKey>>, Fault> {
    let twice = |first| Cause::KeyTwice { key: keys.path(sought), first, second: "sought quantity" };
    let (placed, family) = read_curves(keys, section)?;
    if placed.sweep.key == sought {
        return Err(twice("sweep").at(placed.key));
    }
    match (&family, section.get("family")) {
        (Some(family), Some(node)) if family.key == sought => Err(twice("family").at(node.place)),
        _ => Ok((placed.sweep, family)),
    }
}

/// Reads an analysis of thresholds.
fn read_critical(
    keys: &OscillatorKeys,
    section: &Section<'_>,
    sought: Sought,
) -> Result<OscillatorAnalysis, Fault> {
    let (sweep, family) = read_threshold(keys, section, sought.key())?;
    let within = read_within(section, sought.key(), sought.within())?;
    let global_margin = read_global_margin(section, MARGIN_OF_THRESHOLDS)?;
    Ok(OscillatorAnalysis::Critical(CriticalThresholds { sought, sweep, within, family, global_margin }))
}
