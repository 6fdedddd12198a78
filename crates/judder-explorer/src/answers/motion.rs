//! A motion, shown while it is computed.

use super::analysis::tell;
use crate::desk::Pace;
use crate::frame::Frame;
use crate::refusal::Refusal;
use crate::routes::{Asked, SharedSite};
use crate::view::View;
use axum::extract::State;
use axum::response::Response;
use judder_store::Variable;
use judder_study::analyses::{self, MotionBlock};
use std::sync::Arc;

/// Answers `/api/motion`.
pub(crate) async fn answer(State(site): SharedSite, Asked(view): Asked<View>) -> Result<Response, Refusal> {
    view.check()?;
    let subject = Arc::clone(&site.subject);
    site.desk
        .stream(
            Pace::Slow,
            view.slot.clone(),
            Box::new(move |reporter| {
                let file = view.case(&subject)?;
                if file.case.analysis_names().is_empty() {
                    return Err(Refusal::wrong("no motion is asked for; give an analysis of kind `motion`"));
                }
                let mut show = |block: MotionBlock| reporter.tell(frame(block));
                let outcome = analyses::run_watched(&file.case, 0, reporter, &mut show);
                tell(reporter, "motion", &outcome.map_err(|error| reporter.refusal(error))?)
            }),
        )
        .await
}

fn frame(block: MotionBlock) -> Frame {
    let MotionBlock { time, coordinates, contact_state } = block;
    let over = |name: &str, values: Vec<f64>| Variable::new(name, &["time"], &[values.len()], values);
    let frame = Frame::new("block").array(&Variable::coordinate("time", time).units("1"));
    let frame = coordinates.into_iter().fold(frame, |frame, (name, values)| frame.array(&over(name, values)));
    frame.array(&Variable::new("contact_state", &["time"], &[contact_state.len()], contact_state))
}
