//! A motion, shown while it is computed.

use super::analysis;
use crate::body::Asked;
use crate::frame::Frame;
use crate::refusal::Refusal;
use crate::site::SharedSite;
use crate::view::View;
use axum::extract::State;
use axum::response::Response;
use judder_oscillator::motion::ContactState;
use judder_store::Variable;
use judder_study::model::MotionBlock;

/// Answers `/api/motion`.
pub(crate) async fn answer(State(site): SharedSite, Asked(view): Asked<View>) -> Result<Response, Refusal> {
    analysis::stream(&site, view, |reporter, block| reporter.send(frame(block))).await
}

fn frame(block: MotionBlock) -> Frame {
    let MotionBlock { time, coordinates, contact_state } = block;
    let over = |name: &str, values: Vec<f64>| Variable::new(name, &["time"], &[values.len()], values);
    let frame = Frame::new("block").array(&Variable::coordinate("time", time).units("1"));
    let frame = coordinates.into_iter().fold(frame, |frame, (name, values)| frame.array(&over(name, values)));
    let shape = [contact_state.len()];
    frame.array(&Variable::classes("contact_state", &["time"], &shape, contact_state, &ContactState::CODES))
}
