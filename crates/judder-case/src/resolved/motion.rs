//! The resolved analyses of motion, and the resolved belt case.

use serde_json::{Map, Value as Json, json};

use super::{Dimensioned, named, number, span, sweep};
use crate::belt_case::{BELT_KEYS, BeltCase, BeltKey, BeltKeys};
use crate::dimension::Dimension;
use crate::engines_analysis::{ENGINES, EnginesSettings, TIME_STEP, WIDTH};
use crate::keys::Value;
use crate::motion_analysis::{
    BASIN, BIFURCATION, Following, HISTORY, LIMIT_CYCLE, MotionAnalysis, MotionKeys, MotionStart,
};
use crate::swept_keys::OscillatorKeys;

impl Dimensioned for BeltKey {
    fn dimension(self) -> Dimension {
        Dimension::NUMBER
    }
}

pub(super) fn belt(case: &BeltCase) -> Json {
    let mut json = json!({
        "model": "belt",
        "title": case.title,
        "analysis": case
            .analyses
            .iter()
            .map(|analysis| named(analysis, motion::<BeltKeys>))
            .collect::<Vec<_>>(),
    });
    for entry in &BELT_KEYS {
        json[entry.section()][entry.name()] = json!(case.inputs.number(entry.key));
    }
    json
}

pub(super) fn motion<S: MotionKeys>(kind: &MotionAnalysis<S::Key>) -> Json
where
    S::Key: Dimensioned,
{
    match kind {
        MotionAnalysis::History { start: from, following: how, transient, points } => {
            let own = json!({ "start": start::<S>(from), "transient": time(*transient), "points": points });
            together(HISTORY.name, own, how)
        }
        MotionAnalysis::LimitCycle { start: from, following: how } => {
            together(LIMIT_CYCLE.name, json!({ "start": start::<S>(from) }), how)
        }
        MotionAnalysis::Bifurcation {
            sweep: axis,
            direction,
            start: from,
            following: how,
            transient,
            branches,
        } => {
            let own = json!({
                "sweep": sweep(axis), "direction": direction.name(), "start": start::<S>(from),
                "transient": time(*transient), "branches": branches,
            });
            together(BIFURCATION.name, own, how)
        }
        MotionAnalysis::Basin { within, samples, seed, following: how } => {
            let own = json!({ "within": by_name::<S, _>(within, |(from, to)| json!([from, to])), "samples": samples, "seed": seed });
            together(BASIN.name, own, how)
        }
    }
}

pub(super) fn engines(settings: &EnginesSettings) -> Json {
    let own = json!({
        "start": start::<OscillatorKeys>(&settings.start), "time_step": span(&settings.time_step, TIME_STEP.dimension),
        "width": span(&settings.width, WIDTH.dimension),
    });
    together(ENGINES.name, own, &settings.following)
}

fn together(kind: &str, mut own: Json, following: &Following) -> Json {
    own["kind"] = json!(kind);
    own["duration"] = time(following.duration);
    own["tolerance"] = json!(following.tolerance);
    own["steps"] = json!(following.steps);
    own
}

fn time(value: Value) -> Json {
    number(value.number, value.form, Dimension::TIME)
}

fn start<S: MotionKeys>(start: &MotionStart) -> Json {
    match start {
        MotionStart::Disturbance(share) => json!({ "disturbance": share }),
        MotionStart::State(state) => by_name::<S, _>(state, Json::from),
    }
}

/// What is given of each coordinate, under its name.
fn by_name<S: MotionKeys, T: Copy>(given: &[Option<T>], json: impl Fn(T) -> Json) -> Json {
    let entries = S::COORDINATES.iter().zip(given);
    let known = entries.filter_map(|(name, value)| value.map(|value| ((*name).to_owned(), json(value))));
    Json::Object(known.collect::<Map<_, _>>())
}
