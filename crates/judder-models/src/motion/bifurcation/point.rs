//! A point of the diagram.

use crate::motion::becomes::becomes;
use crate::motion::model::ContactMemory;
use judder_oscillator::cycle::Confirmed;
use judder_oscillator::motion::ContactState;
use judder_oscillator::motion::attractor::Settled;
use judder_oscillator::quasi_steady;
use serde::{Deserialize, Serialize};

/// What the motion at a point of the diagram settles to.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(crate) struct Settling {
    /// Its place in [`BECOMES`](crate::motion::becomes::BECOMES).
    pub(crate) becomes: u8,
    /// Of x about its mean.
    pub(crate) rms: f64,
    /// `None` where nothing moves.
    pub(crate) period: Option<f64>,
    pub(crate) stick_fraction: f64,
    pub(crate) lift_off_fraction: f64,
    /// Eq. (3) for its mean oscillation; `None` where nothing moves and for a contact without memory.
    pub(crate) quasi_steady_condition: Option<f64>,
    /// Its last meetings with the section.
    pub(crate) returns: Vec<Vec<f64>>,
    /// Its last state, from which the next motion starts.
    pub(crate) state: Vec<f64>,
}

impl Settling {
    pub(super) fn of<const N: usize>(confirmed: &Confirmed<N>, memory: Option<&ContactMemory>) -> Self {
        let attractor = &confirmed.attractor;
        let oscillations = match attractor.settled {
            Settled::SteadySliding => 0,
            Settled::Cycle { oscillations } => oscillations,
            Settled::Irregular => 1,
        };
        let moves = oscillations > 0;
        let measures = &attractor.measures;
        let measured = |value: f64| if moves { value } else { 0.0 };
        Self {
            becomes: becomes(confirmed),
            rms: measured(measures.rms()),
            period: moves.then_some(attractor.period),
            stick_fraction: measured(measures.fraction(ContactState::Stick)),
            lift_off_fraction: measured(measures.fraction(ContactState::LiftOff)),
            quasi_steady_condition: memory.filter(|_| moves).map(|memory| {
                let period = attractor.period / oscillations as f64;
                quasi_steady::in_motion(
                    period,
                    measures.amplitude(),
                    memory.belt_velocity,
                    memory.retardation_time,
                )
            }),
            returns: attractor.returns.iter().map(|state| state.to_vec()).collect(),
            state: attractor.state.to_vec(),
        }
    }
}

/// A point of the diagram: what the motion settles to, or why there is none.
pub(crate) type SettledPoint = Result<Settling, String>;
