//! The sliding case.

use serde_json::{Value as Json, json};

use super::structure::{body, matrices, parameters, reduction, si};
use super::{declared, named};
use crate::declared::Setting;
use crate::dimension::Dimension;
use crate::sliding::SlidingCase;
use crate::sliding::analysis::SlidingAnalysis;
use crate::sliding::contact::{Friction, NodesOf, SlidingContact};
use crate::sliding::growth::Growth;
use crate::sliding::locus::{Along, Locus};
use crate::sliding::march::{March, MarchMethod, MarchWord};
use crate::sliding::motion::SlidingMotion;
use crate::sliding::observe::ObservedPoint;
use crate::sliding::signals::Sound;
use crate::sliding::spectrogram::Spectrogram;
use crate::sliding::structure::SlidingStructure;
use crate::structure::StructureSource;
use crate::structure::reduction::KeptNodes;

pub(super) fn case(case: &SlidingCase) -> Json {
    json!({
        "model": "sliding",
        "title": case.title,
        "parameters": parameters(&case.parameters),
        "structure": case.structures.iter().map(structure).collect::<Vec<_>>(),
        "contact": contact(case, &case.contact),
        "motion": motion(&case.motion),
        "observe": { "points": case.points.iter().map(|point| observed(case, point)).collect::<Vec<_>>() },
        "analysis": case.analyses.iter().map(|a| named(a, |kind| analysis(case, kind))).collect::<Vec<_>>(),
    })
}

fn structure(structure: &SlidingStructure) -> Json {
    let mut json = match &structure.source {
        StructureSource::Body(source) => {
            let mut json = body(source);
            json["damping"] = Setting::write(&structure.damping, &());
            json
        }
        StructureSource::Matrices(sums) => json!({ "matrices": matrices(sums) }),
    };
    json["name"] = json!(structure.name);
    json["reduction"] = reduction(&structure.reduction);
    json
}

/// Adds nodes to a table that names them.
fn add_nodes(json: &mut Json, nodes: &KeptNodes) {
    match nodes {
        KeptNodes::Set(set) => json["set"] = json!(set),
        KeptNodes::Numbers(nodes) => json["nodes"] = json!(nodes),
        KeptNodes::Near(place) => json["at"] = json!(place.map(|x| si(x, Dimension::LENGTH))),
    }
}

fn nodes_of(case: &SlidingCase, nodes: &NodesOf) -> Json {
    let mut json = json!({ "structure": case.structures[nodes.structure].name });
    add_nodes(&mut json, &nodes.nodes);
    json
}

fn contact(case: &SlidingCase, contact: &SlidingContact) -> Json {
    let friction = match &contact.friction {
        Friction::Constant(coefficient) => json!(coefficient),
        Friction::Table { velocity, coefficient } => {
            let speeds = velocity.iter().map(|speed| si(*speed, Dimension::SPEED));
            json!({ "velocity": speeds.collect::<Vec<_>>(), "coefficient": coefficient })
        }
    };
    json!({
        "slider": nodes_of(case, &contact.slider), "track": nodes_of(case, &contact.track),
        "friction_coefficient": friction, "interpolation": contact.interpolation.name(),
        "initial_gap": si(contact.initial_gap, Dimension::LENGTH),
    })
}

fn motion(motion: &SlidingMotion) -> Json {
    let time = |time: f64| si(time, Dimension::TIME);
    let mut load = json!({ "direction": motion.load.direction.name(), "force": si(motion.load.force, Dimension::FORCE) });
    add_nodes(&mut load, &motion.load.nodes);
    let initial = motion.initial_damping.map(|initial| {
        json!({
            "alpha": si(initial.alpha, Dimension::RATE), "beta": time(initial.beta),
            "hold": time(initial.hold), "release": time(initial.release),
        })
    });
    json!({
        "start": si(motion.start, Dimension::LENGTH), "end": si(motion.end, Dimension::LENGTH),
        "velocity": si(motion.velocity, Dimension::SPEED), "load": load,
        "ramps": {
            "velocity": time(motion.ramps.velocity), "load": time(motion.ramps.load),
            "friction": time(motion.ramps.friction), "gap": time(motion.ramps.gap),
        },
        "initial_damping": initial,
        "noise": { "force": si(motion.noise.force, Dimension::FORCE), "seed": motion.noise.seed },
    })
}

fn observed(case: &SlidingCase, point: &ObservedPoint) -> Json {
    let mut json = nodes_of(case, &point.node);
    json["name"] = json!(point.name);
    json
}

fn analysis(case: &SlidingCase, kind: &SlidingAnalysis) -> Json {
    match kind {
        SlidingAnalysis::Modes(own) => {
            let mut json = declared("modes", &own.modes);
            json["structure"] = json!(case.structures[own.structure].name);
            json
        }
        SlidingAnalysis::Locus(settings) => locus(settings),
        SlidingAnalysis::March(settings) => march(case, settings),
        SlidingAnalysis::Growth(settings) => growth(settings),
        SlidingAnalysis::Spectrogram(settings) => spectrogram(case, settings),
    }
}

fn locus(locus: &Locus) -> Json {
    let position = |position: f64| si(position, Dimension::LENGTH);
    let mut json = json!({
        "kind": "locus", "configuration": locus.configuration.name(), "damping": locus.damping, "count": locus.count,
    });
    match &locus.along {
        Along::Positions(range) => {
            json["positions"] =
                json!({ "from": position(range.from), "to": position(range.to), "points": range.points });
        }
        Along::Key { at, sweep } => {
            let values = sweep.values.iter().map(|value| match sweep.dimension.is_number() {
                true => json!(value),
                false => si(*value, sweep.dimension),
            });
            json["at"] = position(*at);
            json["sweep"] = json!({
                "key": sweep.path, "values": values.collect::<Vec<_>>(), "scale": sweep.scale.name(),
            });
        }
    }
    json
}

/// Adds a method, what belongs to it, and its step.
fn add_method(json: &mut Json, method: MarchMethod, step: Option<f64>) {
    json["method"] = json!(method.name());
    json["step"] = step.map_or(Json::Null, |step| si(step, Dimension::TIME));
    match method {
        MarchMethod::Subs { static_slope } => {
            json["slope"] = json!(if static_slope { "static" } else { "none" });
        }
        MarchMethod::ResidualFlexibility { cut_off } => {
            json["cut_off"] = si(cut_off, Dimension::ANGULAR_FREQUENCY);
        }
        MarchMethod::Ensubs | MarchMethod::Film => {}
    }
}

fn march(case: &SlidingCase, march: &March) -> Json {
    let frequency = |angular: f64| si(angular, Dimension::ANGULAR_FREQUENCY);
    let sound = match &march.sound {
        Sound::Nothing => json!(false),
        Sound::Accelerations => json!(true),
        Sound::Signals(heard) => heard.iter().map(|signal| signal.name(&case.points)).collect(),
    };
    let mut json = json!({
        "kind": "march", "from": si(march.from, Dimension::LENGTH), "to": si(march.to, Dimension::LENGTH),
        "signals": {
            "pass_band": frequency(march.signals.pass_band),
            "sample_rate": frequency(march.signals.sample_rate * std::f64::consts::TAU),
            "quantities": march.quantities.iter().map(|quantity| quantity.name()).collect::<Vec<_>>(),
        },
        "signal": march.signal.name(&case.points), "sound": sound,
        "checkpoint_steps": march.checkpoint_steps,
    });
    if let Some(predictor) = march.predictor {
        json["predictor"] = json!(predictor.name());
    }
    add_method(&mut json, march.method, march.step);
    json
}

fn growth(growth: &Growth) -> Json {
    let mut json = declared("growth", growth);
    if growth.word == MarchWord::Subs {
        json["slope"] = json!("none");
    }
    json
}

fn spectrogram(case: &SlidingCase, spectrogram: &Spectrogram) -> Json {
    json!({
        "kind": "spectrogram", "of": spectrogram.of, "signal": spectrogram.signal.name(&case.points),
        "window": spectrogram.window.name(), "length": si(spectrogram.length, Dimension::TIME),
        "overlap": spectrogram.overlap,
        "reference": si(spectrogram.reference, spectrogram.signal.dimension()),
        "range": spectrogram.range, "locus": spectrogram.locus,
    })
}
