//! What analyses of motion would take.

use crate::estimate::{Estimate, cost};
use crate::motion::settings::MotionAnalysis;
use judder_keys::numeric_key::Form;

/// Time in which a motion usually settles, in radians.
pub(crate) const USUAL_TIME: f64 = 1000.0;

/// What an analysis of motion would take.
pub(crate) fn estimate<K>(name: &str, kind: &MotionAnalysis<K>, radian: f64) -> Estimate {
    let settling = |duration: judder_keys::numeric_key::Value| match duration.form {
        Form::Group => USUAL_TIME.min(duration.number),
        Form::Si => USUAL_TIME,
    };
    let (points, motions, time) = match kind {
        MotionAnalysis::History(asked) => match asked.duration.form {
            Form::Group => (asked.points, 1, asked.duration.number),
            Form::Si => (asked.points, 1, USUAL_TIME),
        },
        MotionAnalysis::LimitCycle(asked) => (1, 1, settling(asked.duration)),
        MotionAnalysis::Bifurcation(asked) => {
            let motions = asked.sweep.points * asked.diagram.direction.sweeps().len();
            (motions, motions, settling(asked.diagram.duration))
        }
        MotionAnalysis::Basin(asked) => (asked.samples, asked.samples, settling(asked.duration)),
    };
    let has_branches = matches!(kind, MotionAnalysis::Bifurcation(asked) if asked.diagram.branches);
    // what a branch costs is its flights, which take their radians
    let branches = if has_branches { cost::BRANCHES * radian / cost::RADIAN } else { 0.0 };
    /// Numbers that are kept of a point.
    const NUMBERS: u128 = 16;
    Estimate {
        name: name.to_owned(),
        points,
        seconds: motions as f64 * time * radian + branches + cost::FIGURE,
        bytes: points as u128 * 8 * NUMBERS,
    }
}
