//! `eigen`: complex modes about steady sliding.

mod beyond_law;
mod run;
pub(super) mod tables;

use super::AssemblySubject;
use super::linear_size::of_modes;
use crate::assembly::case::AssemblyCase;
use crate::error::ModelError;
use crate::structure::eigen::{ToldRegion, figure, within};
use beyond_law::BeyondLaws;
use judder_keys::Settings;
use judder_keys::declared::{Number, NumberPair, Settings, Whole};
use judder_keys::dimension::Dimension;
use judder_store::{Declared, Results};
use judder_structure::asked_region::AskedRegion;
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Refusal, Task};
use judder_study::outcome::Outcome;
use judder_study::text::short;
use run::AssemblyModes;
pub(super) use run::{band, lowest};
use serde_json::{Map, Value as Json};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Complex modes about steady sliding.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct AssemblyEigen {
    /// Which modes are sought.
    #[key(flatten)]
    pub sought: SoughtModes,
    /// Whether structures are damped, and friction follows the velocity; without, what is left is the coupling of normal and friction forces.
    #[key(default = true)]
    pub damping: bool,
}

/// Which complex modes are sought.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub enum SoughtModes {
    /// So many, by rising frequency, where neither a band nor a region is given.
    #[key(rule = Whole { from: 1, to: 2000 }, default = 20)]
    Count(usize),
    /// All between two frequencies that grow or decay by less than half a radian a radian, in place of count.
    #[key(rule = BAND, symbol = "ω")]
    Band([f64; 2]),
    /// Which eigenvalues λ = re + i im are asked for, in place of count: those of a rectangle, or of frequencies with damping ratios.
    #[key(
        example = "{ frequency = [\"0 Hz\", \"8 kHz\"], damping_ratio = [-0.1, 0.1] }, or { re = […], im = […] } in 1/s and rad/s"
    )]
    Region(AskedRegion),
}

/// Two frequencies.
pub(super) const BAND: NumberPair = NumberPair {
    of: Number::non_negative(Dimension::ANGULAR_FREQUENCY),
    what: "two frequencies, from and to",
    is_ascending: true,
};

/// The kind.
pub(crate) const KIND: Kind<Option<AssemblyCase>, Arc<dyn Analysis<AssemblyCase>>> = Kind {
    name: "eigen",
    doc: "complex modes about steady sliding, each with its error, and what makes it grow",
    declared: AssemblyEigen::declarations,
    read: |_, section| Ok(Arc::new(AssemblyEigen::read_table(section)?)),
    picture: Some(Picture {
        draw: figure::eigen,
        caption: "All eigenvalues found about steady sliding; the axis of growth rates is logarithmic on both sides of zero. Damping ratios $ζ = −$Re $λ/|λ|$: a \
        bubble's area is their magnitude. Shapes of the fastest growing modes, which swing on the page, and how alike any two shapes are.",
    }),
};

impl Analysis<AssemblyCase> for AssemblyEigen {
    fn fits(&self, of: &AssemblySubject<'_>) -> Result<Result<(), Refusal>, ModelError> {
        Ok(of.slides())
    }

    fn memory(&self, of: &AssemblySubject<'_>) -> Result<NeededMemory, ModelError> {
        let count = match self.sought {
            SoughtModes::Count(count) => Some(count),
            SoughtModes::Band(_) | SoughtModes::Region(_) => None,
        };
        Ok(of_modes(of, count))
    }

    fn admit(&self, of: &AssemblySubject<'_>) -> Result<(), ModelError> {
        of.admit_steady()
    }

    fn run(&self, of: &AssemblySubject<'_>, _: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of, self)
    }

    fn summary_keys(&self) -> Vec<Declared> {
        let region = Declared::without(ToldRegion::declared(), &["diagnosis"]);
        [region, AssemblyModes::declared(), Option::<BeyondLaws>::declared()].concat()
    }

    fn estimate(&self, _: &AssemblySubject<'_>) -> Result<String, ModelError> {
        Ok(match self.sought {
            SoughtModes::Count(count) => format!("the lowest {count} complex modes"),
            SoughtModes::Band([from, to]) => {
                format!("complex modes from {} to {} Hz", short(from / TAU), short(to / TAU))
            }
            SoughtModes::Region(asked) => format!("complex modes, {}", within(&asked)),
        })
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
