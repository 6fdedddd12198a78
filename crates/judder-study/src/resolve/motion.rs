//! What `judder check` shows of analyses of motion, and of a belt case.

use super::{Estimate, Resolved, columns, cost, estimate_json, estimate_text, number, title};
use crate::analyses::belt;
use crate::error::StudyError;
use judder_case::{BELT_KEYS, BeltCase, CaseFile, EnginesSettings, Form, MotionAnalysis};
use judder_oscillator::motion::SlidingSystem;
use serde_json::json;

/// Time in which a motion usually settles, in radians.
const USUAL_TIME: f64 = 1000.0;

/// What an analysis of motion would take.
pub(super) fn estimate<K>(name: &str, kind: &MotionAnalysis<K>, radian: f64) -> Estimate {
    let settling = |duration: judder_case::Value| match duration.form {
        Form::Group => USUAL_TIME.min(duration.number),
        Form::Si => USUAL_TIME,
    };
    let (points, motions, time) = match kind {
        MotionAnalysis::History { following, points, .. } => match following.duration.form {
            Form::Group => (*points, 1, following.duration.number),
            Form::Si => (*points, 1, USUAL_TIME),
        },
        MotionAnalysis::LimitCycle { following, .. } => (1, 1, settling(following.duration)),
        MotionAnalysis::Bifurcation { sweep, direction, following, .. } => {
            let motions = sweep.points * direction.sweeps().len();
            (motions, motions, settling(following.duration))
        }
        MotionAnalysis::Basin { samples, following, .. } => {
            (*samples, *samples, settling(following.duration))
        }
    };
    let has_branches = matches!(kind, MotionAnalysis::Bifurcation { branches: true, .. });
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

/// What the comparison of the engines would take: nearly all of it the smallest steps of the time-stepping.
pub(super) fn engines(name: &str, settings: &EnginesSettings) -> Estimate {
    let points = settings.time_step.points + settings.width.points;
    let steps: f64 = match settings.time_step.form {
        Form::Group => settings.time_step.values().iter().map(|step| USUAL_TIME / step).sum(),
        Form::Si => settings.following.steps as f64,
    };
    let seconds = steps * cost::TIME_STEP + points as f64 * USUAL_TIME * cost::RADIAN + cost::FIGURE;
    Estimate { name: name.to_owned(), points, seconds, bytes: 0 }
}

pub(super) fn belt_case(file: &CaseFile, case: &BeltCase) -> Result<Resolved, StudyError> {
    let system = belt(&case.inputs)?;
    let estimates: Vec<Estimate> =
        case.analyses.iter().map(|a| estimate(&a.name, &a.kind, cost::RADIAN_ON_BELT)).collect();
    let keys = BELT_KEYS.iter().map(|key| vec![key.path.to_owned(), number(case.inputs.number(key.key))]);
    let mut text = format!("{}\n\n{}", title(&case.title), columns(&keys.collect::<Vec<_>>()));
    let damping = system.equivalent_damping();
    let [displacement, _] = system.steady_sliding();
    let verdict = match damping.total_cmp(&0.0) {
        std::cmp::Ordering::Less => "unstable",
        std::cmp::Ordering::Equal => "marginal",
        std::cmp::Ordering::Greater => "stable",
    };
    text.push_str("\nat the operating point\n");
    text.push_str(&columns(&[
        vec!["steady sliding".to_owned(), verdict.to_owned()],
        vec!["displacement".to_owned(), number(displacement)],
        vec!["equivalent damping".to_owned(), number(damping)],
    ]));
    text.push_str(&estimate_text(&estimates));
    let document = json!({
        "case": file.case.resolved(),
        "point": { "verdict": verdict, "displacement": displacement, "equivalent_damping": damping },
        "estimate": estimate_json(&estimates),
        "warnings": [],
    });
    Ok(Resolved { document, text })
}
