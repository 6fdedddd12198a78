//! A stability map: coarse at once, exact after, then what the errors of the law leave of it, then its boundaries.

use super::oscillator;
use crate::body::JsonBody;
use crate::frame::FrameInTheMaking;
use crate::refusal::RequestRefusal;
use crate::reporter::Reporter;
use crate::scheduler::Pace;
use crate::site::SharedSite;
use crate::subject::ViewedCase;
use crate::view::View;
use axum::extract::State;
use axum::response::Response;
use judder_keys::keys::Keys;
use judder_models::key_plane::{KeyAxis, KeyPlane};
use judder_models::oscillator::keys::OscillatorKey;
use judder_models::oscillator::{BoundaryKind, STANDINGS, boundary_curves};
use judder_models::sweep::{StabilityMapAnalysis, Sweep};
use judder_oscillator::map::{CoarseMap, DecisionMethod, StabilityMap};
use judder_oscillator::mechanism::StabilityClass;
use judder_store::Variable;
use judder_study::{Progress, StudyError};
use serde::Deserialize;
use std::sync::Arc;

/// A view whose analysis is a stability map, and the boundaries that are wanted over it.
#[derive(Debug, Deserialize)]
pub(crate) struct WantedMap {
    #[serde(flatten)]
    view: View,
    #[serde(default)]
    boundaries: Vec<String>,
}

/// Answers `/api/map`.
pub(crate) async fn answer(
    State(site): SharedSite,
    JsonBody(wanted): JsonBody<WantedMap>,
) -> Result<Response, RequestRefusal> {
    wanted.view.check()?;
    let kinds = kinds(&wanted.boundaries)?;
    let subject = Arc::clone(&site.subject);
    let slot = wanted.view.slot.clone();
    site.scheduler
        .stream(Pace::Quick, slot, Box::new(move |reporter| draw(&subject, &wanted.view, &kinds, reporter)))
        .await
}

/// The kinds that are named, each once.
fn kinds(names: &[String]) -> Result<Vec<BoundaryKind>, RequestRefusal> {
    let mut kinds = Vec::new();
    for name in names {
        let kind = kind(name)?;
        if kinds.contains(&kind) {
            return Err(RequestRefusal::wrong(format!(
                "the boundary `{}` is asked for more than once; once is enough",
                kind.name()
            )));
        }
        kinds.push(kind);
    }
    Ok(kinds)
}

fn kind(name: &str) -> Result<BoundaryKind, RequestRefusal> {
    BoundaryKind::ALL.into_iter().find(|kind| kind.name() == name).ok_or_else(|| {
        let known = BoundaryKind::ALL.map(BoundaryKind::name).join(", ");
        RequestRefusal::wrong(format!("there is no boundary `{name}`; there are {known}"))
    })
}

fn draw(
    subject: &ViewedCase,
    view: &View,
    kinds: &[BoundaryKind],
    reporter: &Reporter,
) -> Result<(), RequestRefusal> {
    let file = view.case(subject)?;
    let case = oscillator(&file)?;
    let Some(settings) =
        case.analyses.first().and_then(|analysis| analysis.settings::<StabilityMapAnalysis<OscillatorKey>>())
    else {
        return Err(RequestRefusal::wrong(
            "the analysis of a map is another; its `kind` is \"stability-map\"",
        ));
    };
    let ready = subject.laws.ready(case, reporter).map_err(|error| reporter.refusal(error))?;
    let contact = &ready.contact.contact;
    let plane = KeyPlane { inputs: ready.case.inputs, x: side(&settings.x), y: side(&settings.y) };
    let mut show =
        |coarse: CoarseMap| reporter.send(coarse_frame(&plane, settings, coarse, reporter.seconds()));
    let interrupted = || reporter.interrupted();
    let Some(map) = plane.decide_in_stages(contact, &mut show, &interrupted) else {
        return Err(reporter.refusal(StudyError::Interrupted));
    };
    reporter.send(exact_frame(&plane, settings, map.clone(), reporter.seconds()));
    if !contact.law.is_formula() {
        let Some(codes) = plane.within_law(contact, &map, DecisionMethod::Adaptive, &interrupted) else {
            return Err(reporter.refusal(StudyError::Interrupted));
        };
        let codes = Variable::classes("within_law", &["y", "x"], &[map.rows, map.columns], codes, &STANDINGS);
        reporter.send(FrameInTheMaking::new("within-law").with("seconds", reporter.seconds()).array(&codes));
    }
    for kind in kinds {
        if reporter.interrupted() {
            return Err(reporter.refusal(StudyError::Interrupted));
        }
        if let Some(curves) = boundary_curves(*kind, &ready.case, contact, settings) {
            let along =
                |name: &str, values: Vec<f64>| Variable::new(name, &["point"], &[values.len()], values);
            let frame = FrameInTheMaking::new("boundary").with("name", kind.name());
            reporter.send(
                frame
                    .array(&along("x", curves.x))
                    .array(&along("y", curves.y))
                    .array(&along("frequency", curves.frequency).units("1").long_name("frequency ω/ω_nx")),
            );
        }
    }
    Ok(())
}

fn side(sweep: &Sweep<OscillatorKey>) -> KeyAxis {
    KeyAxis { key: sweep.key, form: sweep.form, values: sweep.values() }
}

fn coarse_frame(
    plane: &KeyPlane,
    settings: &StabilityMapAnalysis<OscillatorKey>,
    coarse: CoarseMap,
    seconds: f64,
) -> FrameInTheMaking {
    let at = |values: &[f64], lines: &[usize]| lines.iter().map(|line| values[*line]).collect();
    let frame = FrameInTheMaking::new("map").with("stage", "coarse").with("seconds", seconds);
    let (x, y) = (at(&plane.x.values, &coarse.columns), at(&plane.y.values, &coarse.rows));
    ShownMap { x, y, classes: coarse.classes }.over(settings, frame)
}

fn exact_frame(
    plane: &KeyPlane,
    settings: &StabilityMapAnalysis<OscillatorKey>,
    map: StabilityMap,
    seconds: f64,
) -> FrameInTheMaking {
    let frame = FrameInTheMaking::new("map")
        .with("stage", "exact")
        .with("seconds", seconds)
        .with("decisions", map.decisions)
        .with("unstable_fraction", map.unstable_fraction())
        .with("unresolved", map.count(StabilityClass::Unresolved));
    ShownMap { x: plane.x.values.clone(), y: plane.y.values.clone(), classes: map.classes }
        .over(settings, frame)
}

/// The classes of a map at its grid.
struct ShownMap {
    x: Vec<f64>,
    y: Vec<f64>,
    /// Row by row.
    classes: Vec<u8>,
}

impl ShownMap {
    /// As arrays of a frame, over the axes of the settings.
    fn over(
        self,
        settings: &StabilityMapAnalysis<OscillatorKey>,
        frame: FrameInTheMaking,
    ) -> FrameInTheMaking {
        let shape = [self.y.len(), self.x.len()];
        let axis = |name: &str, sweep: &Sweep<OscillatorKey>, values: Vec<f64>| {
            Variable::coordinate(name, values).long_name(&sweep.key.entry().label(sweep.form))
        };
        let (x, y) = (axis("x", &settings.x, self.x), axis("y", &settings.y, self.y));
        let meanings = StabilityClass::ALL.map(|class| (class as u8, class.name()));
        let classes = Variable::classes("classes", &["y", "x"], &shape, self.classes, &meanings);
        frame.array(&x).array(&y).array(&classes)
    }
}
