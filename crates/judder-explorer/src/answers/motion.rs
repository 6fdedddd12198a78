//! A motion, shown while it is computed.

use super::analysis;
use crate::body::JsonBody;
use crate::frame::FrameInTheMaking;
use crate::refusal::RequestRefusal;
use crate::site::SharedSite;
use crate::view::View;
use axum::extract::State;
use axum::response::Response;
use judder_oscillator::motion::ContactState;
use judder_store::Variable;
use judder_study::model::SampleBlock;

/// Answers `/api/motion`.
pub(crate) async fn answer(
    State(site): SharedSite,
    JsonBody(view): JsonBody<View>,
) -> Result<Response, RequestRefusal> {
    analysis::stream(&site, view, |reporter, block| reporter.send(frame(block))).await
}

fn frame(block: SampleBlock) -> FrameInTheMaking {
    let SampleBlock { time, numbers, classes } = block;
    let over = |name: &str, values: Vec<f64>| Variable::new(name, &["time"], &[values.len()], values);
    let frame = FrameInTheMaking::new("block").array(&Variable::coordinate("time", time).units("1"));
    let frame = numbers.into_iter().fold(frame, |frame, (name, values)| frame.array(&over(name, values)));
    let shape = [classes.len()];
    frame.array(&Variable::classes("contact_state", &["time"], &shape, classes, &ContactState::CODES))
}
