//! `locus`: complex eigenvalues against the position of the contact, or against any key.
//!
//! - `positions`, `swept`: the two families of pairs.
//! - `traced`: eigenvalues and zones of either, with what could not be.
//! - `kept_values`: what of it an interrupted run keeps.
//! - `doubt`: a few values against full matrices.
//! - `results`: scalars, arrays, table.

pub(super) mod conditions;
mod doubt;
pub mod figure;
mod kept_values;
mod positions;
mod rest_state;
mod results;
mod run;
pub mod settings;
mod swept;
pub(crate) mod tables;
mod traced;

use super::pair_size::with_pair;
use super::{SlidingSubject, blame, cost};
use crate::error::ModelError;
use crate::estimate::{Estimate, cost::FIGURE, memory_of_points};
use crate::sliding::case::SlidingCase;
use judder_keys::declared::Settings;
use judder_store::Declared;
use judder_study::case::analysis::{Kind, Picture};
use judder_study::model::{Analysis, NeededMemory, Refusal, Task};
use judder_study::outcome::Outcome;
use serde_json::{Map, Value as Json};
use settings::{Along, LocusAnalysis};
use std::sync::Arc;

/// Bytes of an eigenvalue at a position, arrays, table, figure and report together: measured of twelve at 200 and at 20 000 positions.
const EIGENVALUE_BYTES: u128 = 600;

/// The kind.
pub(crate) const KIND: Kind<Option<SlidingCase>, Arc<dyn Analysis<SlidingCase>>> = Kind {
    name: "locus",
    doc: "complex eigenvalues against the position of the contact, or against any key, with located unstable zones",
    declared: LocusAnalysis::declarations,
    read: |case, section| {
        let own = LocusAnalysis::read_table(section)?;
        Ok(Arc::new(match case {
            Some(case) => own.admit(case, section)?,
            None => own,
        }))
    },
    picture: Some(Picture {
        draw: figure::locus,
        caption: "Complex eigenvalues of the coupled pair, dark to light along the axis: all of them with growth rates logarithmic on both sides of zero, and \
        their unstable side on even axes. Zones are located by the roots of the growth rate itself, however narrow; the markers stand where they \
        grow fastest. The last but one panel has the growth rates of the zones alone.",
    }),
};

impl Analysis<SlidingCase> for LocusAnalysis {
    fn steps(&self) -> usize {
        match &self.along {
            Along::Positions(positions) => positions.points,
            Along::Key { sweep, .. } => sweep.values.len(),
        }
    }

    fn admit(&self, of: &SlidingSubject<'_>) -> Result<(), ModelError> {
        let pair = &of.system.pair;
        match &self.along {
            Along::Positions(range) => {
                pair.edge_point(range.from)?;
                pair.edge_point(range.to)?;
            }
            Along::Key { at, .. } => {
                pair.edge_point(*at)?;
            }
        }
        Ok(())
    }

    fn summary_keys(&self) -> Vec<Declared> {
        results::summary_keys(&self.along)
    }

    fn run(&self, of: &SlidingSubject<'_>, task: Task<'_>) -> Result<Outcome, ModelError> {
        run::run(of.case, of.system, self, (task.own, task.progress))
    }

    fn blame(&self, error: &ModelError) -> Option<Refusal> {
        match &self.along {
            Along::Positions(_) => blame::off_track(error, "positions", None),
            Along::Key { at, .. } => blame::off_track(error, "at", Some(*at)),
        }
    }

    fn memory(&self, of: &SlidingSubject<'_>) -> Result<NeededMemory, ModelError> {
        let keys = &["positions.points", "sweep.points", "count"];
        let of_values = memory_of_points(self.steps() as u128, EIGENVALUE_BYTES * self.count as u128, keys);
        Ok(with_pair(of_values, of.system))
    }

    fn estimate(&self, of: &SlidingSubject<'_>) -> Result<Estimate, ModelError> {
        let modes = of.system.pair.modes() as f64;
        // structures that a swept key concerns are made again at every value
        let again = match &self.along {
            Along::Positions(_) => 0.0,
            Along::Key { sweep, .. } => {
                let concerned = (0..2).filter(|index| {
                    let own = format!("structure.{}.", of.case.structures[*index].name);
                    sweep.path.starts_with(&own) || sweep.path.starts_with("parameters.")
                });
                concerned.map(|index| cost::freedoms(of.system, index)).sum::<f64>() * cost::FREEDOM
            }
        };
        let (points, count) = (self.steps(), self.count as f64);
        let value = cost::VALUE * modes * count + again;
        let seconds = points as f64 * value + 3.0 * cost::DENSE * modes.powi(3) + FIGURE;
        Ok(Estimate { name: of.name.to_owned(), points, seconds, seconds_at_most: None })
    }

    fn write(&self, json: &mut Map<String, Json>) {
        self.write_table(json);
    }
}
