//! What an engine has come to, measured over the last periods that it was followed.

use judder_oscillator::motion::laps::{Laps, Moments};

/// Periods of the cycle that an engine is followed, and the last of them, which are measured.
pub(super) const PERIODS: usize = 6;
const MEASURED: usize = 2;
/// Difference of the measured periods' rms, relative, below which they are one cycle.
const REPEATS: f64 = 1e-3;
/// Speed, over v_d, below which a motion without returns has come to rest.
const AT_REST: f64 = 1e-3;

/// What an engine has come to.
#[derive(Debug, Clone, Copy)]
pub(super) struct EngineReached {
    /// 0: a cycle, 1: irregular, 2: steady sliding, 3: lost.
    pub(super) becomes: u8,
    /// Over the measured periods; zero in steady sliding, NaN where the motion is lost.
    pub(super) rms: f64,
    /// The mean of the measured periods; NaN where there are none.
    pub(super) period: f64,
}

/// What an engine may come to.
pub(super) const BECOMES: [(u8, &str); 4] =
    [(0, "cycle"), (1, "irregular"), (2, "steady sliding"), (3, "lost")];
pub(super) const LOST: EngineReached = EngineReached { becomes: 3, rms: f64::NAN, period: f64::NAN };

impl EngineReached {
    pub(super) fn of(laps: &Laps, belt_velocity: f64) -> Self {
        if laps.laps.len() < PERIODS {
            let speed = laps.state[2].abs().max(laps.state[3].abs());
            let is_at_rest = speed < AT_REST * belt_velocity;
            return if is_at_rest { Self { becomes: 2, rms: 0.0, period: f64::NAN } } else { LOST };
        }
        let measured = &laps.laps[PERIODS - MEASURED..PERIODS];
        let whole = measured.iter().fold(Moments::default(), |sum, lap| sum + *lap);
        let rms = whole.rms();
        let differ = measured.iter().map(|lap| (lap.rms() / rms - 1.0).abs()).fold(0.0, f64::max);
        let becomes = u8::from(differ > REPEATS);
        Self { becomes, rms, period: whole.duration / MEASURED as f64 }
    }
}
