//! The analyses of an oscillator case.

use crate::motion::settings::MotionModel;
use crate::motion::{MotionAnalysis, MotionOf};
use crate::oscillator::Operated;
use crate::oscillator::case::swept_keys::OscillatorKeys;
use crate::oscillator::keys::OscillatorKey;
use crate::read_family::{family_declaration, read_family, write_family};
use crate::read_sweep::{
    PlacedSweep, SWEEP, map_declarations, read_map, read_within, within_declaration, write_map, write_within,
};
use crate::sweep::{Family, StabilityMapAnalysis, Sweep, Within};
use crate::swept_keys::SweptKeys;
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Declaration, Settings, both};
use judder_keys::error::Fault;
use judder_keys::keys::Keys;
use judder_keys::section::Section;
use serde_json::{Map, Value as Json};
use std::sync::Arc;

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
    pub sought: SoughtThresholds,
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
pub enum SoughtThresholds {
    /// τ0,crit.
    ShearStrength,
    /// F_n,crit.
    Load,
}

impl SoughtThresholds {
    /// The key of the quantity.
    pub fn key(self) -> OscillatorKey {
        match self {
            Self::ShearStrength => OscillatorKey::ShearStrength,
            Self::Load => OscillatorKey::NormalLoad,
        }
    }

    /// The kind of analysis that seeks them.
    pub const fn kind(self) -> &'static str {
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

/// How thresholds are told.
#[derive(Settings)]
struct ThresholdMargin {
    /// Follow the cycles beside every subcritical threshold back to [their fold](theory/motion.md#the-global-margin), and seek motions beyond: some seconds a threshold.
    #[key(default = true)]
    global_margin: bool,
}

/// How the points of a map are told.
#[derive(Settings)]
struct MapMargin {
    /// Tell the points at which a knock may start a motion apart from those at which none is known to: up to a minute.
    #[key(default = false)]
    global_margin: bool,
}

impl MotionModel for OscillatorKeys {
    const FREQUENCY: &'static str = "Frequency $ω$/$ω_{nx}$ (−)";
    const SECONDS: &'static str = "give `operation.velocity` or `operation.normal_load` in SI";

    fn has_seconds(&self) -> bool {
        OscillatorKeys::has_seconds(self)
    }

    type Analysis = Arc<dyn Operated>;

    fn of_motion<A: MotionOf<Self>>(analysis: A) -> Self::Analysis {
        Arc::new(MotionAnalysis(analysis))
    }
}

/// Puts curves along one key into a canonical form.
fn write_curves(
    sweep: &Sweep<OscillatorKey>,
    family: Option<&Family<OscillatorKey>>,
    json: &mut Map<String, Json>,
) {
    SWEEP.write::<OscillatorKeys>(sweep, json);
    write_family::<OscillatorKeys>(family, json);
}

impl DampingCurves {
    pub(super) fn read(keys: &OscillatorKeys, section: &Section<'_>) -> Result<Self, Fault> {
        let (sweep, family) = read_curves(keys, section)?;
        Ok(Self { sweep: sweep.sweep, family })
    }

    pub(super) fn write_table(&self, json: &mut Map<String, Json>) {
        write_curves(&self.sweep, self.family.as_ref(), json);
    }
}

impl SpectrumCurves {
    pub(super) fn read(keys: &OscillatorKeys, section: &Section<'_>) -> Result<Self, Fault> {
        let (sweep, family) = read_curves(keys, section)?;
        Ok(Self { sweep: sweep.sweep, family })
    }

    pub(super) fn write_table(&self, json: &mut Map<String, Json>) {
        write_curves(&self.sweep, self.family.as_ref(), json);
    }
}

impl CriticalThresholds {
    pub(super) fn write_table(&self, json: &mut Map<String, Json>) {
        write_curves(&self.sweep, self.family.as_ref(), json);
        write_within::<OscillatorKeys>(self.sought.key(), &self.within, json);
        ThresholdMargin { global_margin: self.global_margin }.write_table(json);
    }
}

/// What is said of a stability map.
pub(super) fn map_keys() -> Vec<Declaration> {
    [map_declarations::<OscillatorKeys>(), MapMargin::declarations()].concat()
}

impl StabilityMapAnalysis<OscillatorKey> {
    pub(super) fn read(keys: &OscillatorKeys, section: &Section<'_>) -> Result<Self, Fault> {
        let (map, margin) = both(read_map(keys, section), MapMargin::read_table(section))?;
        Ok(Self { global_margin: margin.global_margin, ..map })
    }

    pub(super) fn write_table(&self, json: &mut Map<String, Json>) {
        write_map::<OscillatorKeys>(self, json);
        MapMargin { global_margin: self.global_margin }.write_table(json);
    }
}

/// What is said of curves along one key.
pub(super) fn curves() -> Vec<Declaration> {
    vec![SWEEP.declaration::<OscillatorKeys>(), family_declaration::<OscillatorKeys>()]
}

/// What is said of thresholds along one key.
pub(super) fn thresholds(sought: SoughtThresholds) -> Vec<Declaration> {
    let mut keys = curves();
    keys.insert(1, within_declaration(sought.key().entry(), sought.within()));
    [keys, ThresholdMargin::declarations()].concat()
}

type WithFamily<S> = (S, Option<Family<OscillatorKey>>);

/// Reads the sweep of an analysis and its family.
fn read_curves(
    keys: &OscillatorKeys,
    section: &Section<'_>,
) -> Result<WithFamily<PlacedSweep<OscillatorKey>>, Fault> {
    let sweep = SWEEP.read(keys, section)?;
    let family = read_family(keys, section, &sweep)?;
    Ok((sweep, family))
}

/// Reads sweep and family of an analysis that seeks `sought`, which therefore can be neither.
fn read_threshold(
    keys: &OscillatorKeys,
    section: &Section<'_>,
    sought: OscillatorKey,
) -> Result<WithFamily<Sweep<OscillatorKey>>, Fault> {
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

impl CriticalThresholds {
    pub(super) fn read(
        keys: &OscillatorKeys,
        section: &Section<'_>,
        sought: SoughtThresholds,
    ) -> Result<Self, Fault> {
        let within = read_within(section, sought.key().entry(), sought.within());
        let own = both(within, ThresholdMargin::read_table(section));
        let ((sweep, family), (within, ThresholdMargin { global_margin })) =
            both(read_threshold(keys, section, sought.key()), own)?;
        Ok(Self { sought, sweep, within, family, global_margin })
    }
}
