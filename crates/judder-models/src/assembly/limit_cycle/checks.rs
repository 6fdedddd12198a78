//! What is checked of every cycle: its equations, and its energy over a period.

use judder_cycles::path::PathRule;
use judder_study::outcome::{CheckRecord, Disagreement};

/// Instants of a period that are stored, and at which contact laws are held against the bodies, at least.
pub(in crate::assembly) const INSTANTS: usize = 400;
/// What the balance of energy may be off, over what contacts and bodies exchange.
const BALANCE: f64 = 2e-4;

/// How far cycles are from their equations, and from a balance of their energy; `which` tells of which cycles.
pub(in crate::assembly) fn checks(
    which: &str,
    residuals: Disagreement,
    imbalances: Disagreement,
) -> Vec<CheckRecord> {
    vec![
        CheckRecord::new(
            "harmonics of the contact forces are those that the contact laws make of the motion",
            format!("largest residual over the largest normal force, {which}"),
            residuals,
            PathRule::default().tolerance,
        ),
        CheckRecord::new(
            "over a period friction gives the bodies what damping takes",
            format!(
                "contact laws at {INSTANTS} instants against the damping of the bodies, over what they exchange to and fro, {which}"
            ),
            imbalances,
            BALANCE,
        ),
    ]
}
