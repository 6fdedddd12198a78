//! Settings that analyses of motion share.

use super::MotionOf;
use crate::read_sweep::same_form;
use crate::swept_keys::SweptKeys;
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Declaration, Number, Scaled, Settings, Whole};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::numeric_key::{Range, Value};
use judder_keys::section::Section;

/// Where a motion starts.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub enum MotionStart {
    /// Steady sliding with x moved by this share of its magnitude, or of the scale of a motion where steady sliding has no x.
    #[key(rule = ANY, example = "0.2, or x = …, the coordinates of the start")]
    Disturbance(f64),
    /// A state: what is left out stands as in steady sliding.
    State {
        /// Displacement; a plain number is in units of x0 = F_n/k_x for the oscillator.
        #[key(rule = DISPLACEMENT, omitted)]
        x: Option<Value>,
        /// Normal displacement; in the air where it is not above zero.
        #[key(rule = DISPLACEMENT, omitted)]
        y: Option<Value>,
        /// Velocity along x; a plain number is in units of x0 ω_nx for the oscillator.
        #[key(rule = COORDINATE_VELOCITY, omitted)]
        velocity_x: Option<Value>,
        /// Velocity along y.
        #[key(rule = COORDINATE_VELOCITY, omitted)]
        velocity_y: Option<Value>,
    },
}

/// How a motion is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Following {
    /// How long, as ω_nx t or in s.
    pub duration: Value,
    /// Local error of a step, relative to the magnitudes of steady sliding.
    pub tolerance: f64,
    /// The most steps of one motion.
    pub steps: usize,
}

const ANY: Number = Number::any(Dimension::NUMBER);
pub(super) const DISPLACEMENT: Scaled =
    Scaled { range: Range::Any, ..Scaled::positive(Dimension::LENGTH, "x/x0") };
pub(super) const COORDINATE_VELOCITY: Scaled =
    Scaled { range: Range::Any, ..Scaled::positive(Dimension::SPEED, "dx/dt / (x0 ω_nx)") };
pub(crate) const DURATION: Scaled = Scaled::positive(Dimension::TIME, "ω_nx t");
pub(super) const TRANSIENT: Scaled = Scaled { range: Range::NonNegative, ..DURATION };
pub(crate) const TOLERANCE: Number =
    Number { dimension: Dimension::NUMBER, range: Range::Interval { above: 1e-14, up_to: 1e-2 } };
pub(crate) const STEPS: Whole = Whole { from: 1, to: 1_000_000_000_000 };

/// The time within which a motion settles where the case does not say, ω_nx t.
pub(crate) const SETTLING_DURATION: Value = Value::group(2e4);
/// The tolerance of cycles where the case does not say.
pub(crate) const CYCLE_TOLERANCE: f64 = 1e-10;
/// The steps of a motion where the case does not say.
pub(crate) const MOTION_STEPS: usize = 10_000_000;

/// Settings that say how a motion is followed.
macro_rules! followed {
    ($settings:ty) => {
        impl $settings {
            /// How a motion is followed.
            pub fn following(&self) -> $crate::motion::settings::Following {
                $crate::motion::settings::Following {
                    duration: self.duration,
                    tolerance: self.tolerance,
                    steps: self.steps,
                }
            }
        }
    };
}
pub(crate) use followed;

impl MotionStart {
    /// Where a motion starts where the case does not say.
    pub const USUAL: Self = Self::Disturbance(0.2);

    /// What is given of the coordinates of a state: displacements, then their velocities.
    pub fn state<const N: usize>(&self) -> [Option<Value>; N] {
        match *self {
            Self::Disturbance(_) => [None; N],
            Self::State { x, y, velocity_x, velocity_y } => in_order([x, y], [velocity_x, velocity_y]),
        }
    }
}

/// What is given of the coordinates of a state, half of which are displacements.
pub(super) fn in_order<T: Copy, const N: usize>(
    displacements: [Option<T>; 2],
    velocities: [Option<T>; 2],
) -> [Option<T>; N] {
    std::array::from_fn(|k| {
        let (given, k) = if k < N / 2 { (displacements, k) } else { (velocities, k - N / 2) };
        given.get(k).copied().flatten()
    })
}

/// Refuses a transient that leaves nothing of the duration; it is half of it where the case does not say.
pub(super) fn leave_some(transient: &mut Value, duration: Value, section: &Section<'_>) -> Result<(), Fault> {
    let Some(node) = section.get("transient") else {
        *transient = Value { number: 0.5 * duration.number, ..duration };
        return Ok(());
    };
    same_form("`duration` and `transient`".to_owned(), duration.form, transient.form, node.place)?;
    if transient.number < duration.number {
        return Ok(());
    }
    let (transient, duration) = (transient.number, duration.number);
    Err(Cause::NothingMeasured { transient, duration }.at(node.place))
}

/// A model with motion.
pub(crate) trait MotionModel: SweptKeys + Sized {
    /// What stands at an axis of frequencies.
    const FREQUENCY: &'static str;

    /// What gives its cases seconds.
    const SECONDS: &'static str;

    /// Whether the case has seconds; of one in which something is wrong that is not known, and it has.
    fn has_seconds(&self) -> bool;

    /// The analyses of its cases.
    type Analysis;

    /// One of motion among them.
    fn of_motion<A: MotionOf<Self>>(analysis: A) -> Self::Analysis;

    /// What it has of the settings of an analysis of motion.
    fn own(declared: Vec<Declaration>) -> Vec<Declaration> {
        declared
    }

    /// Refuses what a case does not have.
    fn refuse_others(&self, _: &Section<'_>, _: &[Declaration]) -> Result<(), Fault> {
        Ok(())
    }
}

/// The kinds of analyses of motion of a model, each in its folder.
pub(crate) struct MotionKinds<S>(std::marker::PhantomData<S>);

/// What a model has of these settings.
pub(super) fn declared<S: MotionModel, T: Settings>() -> Vec<Declaration> {
    S::own(T::declarations())
}

/// Reads these settings of an analysis of a model.
pub(super) fn read<S: MotionModel, T: Settings>(keys: &S, section: &Section<'_>) -> Result<T, Fault> {
    keys.refuse_others(section, &declared::<S, T>())?;
    T::read_table(section)
}
