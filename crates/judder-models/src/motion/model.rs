//! The models whose motion is followed.

use crate::axis;
use crate::belt::case::{BeltCase, BeltKey};
use crate::belt::inputs::BeltInputs;
use crate::bridge;
use crate::friction::FrictionCurve;
use crate::motion::settings::{Following, MotionStart};
use crate::motion::si::SiUnits;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use crate::sweep::Sweep;
use judder_keys::numeric_key::{Form, Value};
use judder_numerics::piecewise::StepSettings;
use judder_oscillator::motion::attractor::distance;
use judder_oscillator::motion::history::StateSample;
use judder_oscillator::motion::{BeltOscillator, SlidingSystem, StickSlip};
use judder_oscillator::{Contact, OscillatorError};
use judder_study::axis::SweptAxis;

/// How far from steady sliding, in its scales, a motion starts at least that is followed to where it settles.
const NUDGE: f64 = 1e-3;

/// A quantity of a history: name of its array, what it is, what stands at an axis.
#[derive(Clone, Copy)]
pub(crate) struct Coordinate {
    pub(crate) name: &'static str,
    pub(crate) long_name: &'static str,
    pub(crate) label: &'static str,
}

/// How the time of a model is called.
pub(crate) struct Clock {
    /// In labels.
    pub(crate) symbol: &'static str,
    /// What it is.
    pub(crate) time: &'static str,
    /// What a frequency of it is.
    pub(crate) frequency: &'static str,
}

/// What eq. (3) compares: ṽ_d and τ̃.
pub(crate) struct ContactMemory {
    pub(crate) belt_velocity: f64,
    pub(crate) retardation_time: f64,
}

/// A model at an operating point.
pub(crate) struct Operating<S> {
    pub(crate) system: S,
    /// The model's time units in a second; times of a model without seconds are plain numbers.
    per_second: f64,
    /// Its units of length in a metre; lengths of a model without metres are plain numbers.
    per_metre: f64,
    /// What its units are in SI, where the case is written in SI.
    pub(crate) si: Option<SiUnits>,
}

impl<S> Operating<S> {
    /// A time of the case in the model's own.
    pub(crate) fn time(&self, time: Value) -> f64 {
        match time.form {
            Form::Group => time.number,
            Form::Si => time.number * self.per_second,
        }
    }

    /// A coordinate of a state of the case in the model's own units.
    pub(crate) fn coordinate<const N: usize>(&self, index: usize, value: Value) -> f64 {
        match value.form {
            Form::Group => value.number,
            Form::Si if index < N / 2 => value.number * self.per_metre,
            Form::Si => value.number * self.per_metre / self.per_second,
        }
    }

    /// How a motion is stepped: to a tolerance relative to the state and to the magnitudes of steady sliding.
    pub(crate) fn settings<const N: usize>(&self, following: &Following) -> StepSettings<N>
    where
        S: SlidingSystem<N>,
    {
        /// A fraction of a radian longer would hide a dip of a guard between the ends of a step.
        const LONGEST_STEP: f64 = 1.0;
        let Following { tolerance, steps, .. } = *following;
        let absolute = self.system.scales().map(|scale| tolerance * scale);
        StepSettings { relative: tolerance, absolute, longest_step: LONGEST_STEP, steps }
    }

    /// A start that is not at rest: nearer to steady sliding than [`NUDGE`] it would stay there, however unstable that were.
    pub(crate) fn off_rest<const N: usize>(&self, mut start: [f64; N]) -> [f64; N]
    where
        S: SlidingSystem<N>,
    {
        let (rest, scales) = (self.system.steady_sliding(), self.system.scales());
        if distance(&start, &rest, &scales) < NUDGE {
            start = rest;
            start[0] += NUDGE * scales[0];
        }
        start
    }

    /// Where a motion starts.
    pub(crate) fn start<const N: usize>(&self, start: &MotionStart) -> [f64; N]
    where
        S: SlidingSystem<N>,
    {
        let mut state = self.system.steady_sliding();
        if let MotionStart::Disturbance(share) = start {
            /// Of the scale: steady sliding that has no more has none, and a share of it would be no disturbance.
            const NONE: f64 = 1e-12;
            let (size, scale) = (state[0].abs(), self.system.scales()[0]);
            state[0] += share * if size > NONE * scale { size } else { scale };
        }
        for (k, (place, given)) in state.iter_mut().zip(start.state::<N>()).enumerate() {
            *place = given.map_or(*place, |given| self.coordinate::<N>(k, given));
        }
        state
    }
}

/// A model whose motion can be followed at any value of its keys.
pub(crate) trait Moving<const N: usize>: Sync {
    /// A key that can be swept.
    type Key: Copy + Sync + Send;
    /// The oscillator.
    type System: SlidingSystem<N>;

    /// The name of the analysis, after which files are called.
    fn name(&self) -> &str;

    /// Its time.
    const CLOCK: Clock;
    /// The coordinates of a state.
    const COORDINATES: [Coordinate; N];
    /// What is shown of a motion besides.
    const FURTHER: &'static [Coordinate];

    /// The model where a swept key has this value.
    fn operating(
        &self,
        set: Option<(&Sweep<Self::Key>, f64)>,
    ) -> Result<Operating<Self::System>, OscillatorError>;

    /// The values of [`Moving::FURTHER`].
    fn further(system: &Self::System, sample: &StateSample<N>) -> Vec<f64>;

    /// What eq. (3) compares; `None` for a contact without memory.
    fn memory(system: &Self::System) -> Option<ContactMemory>;

    /// How a state lies beyond what is known of friction and contact.
    fn concern(operating: &Operating<Self::System>, state: &[f64; N]) -> Option<String>;

    /// A swept key as an axis.
    fn axis(sweep: &Sweep<Self::Key>) -> SweptAxis;
}

/// The oscillator of a case.
pub(crate) struct OscillatorModel<'a> {
    /// Of the analysis.
    pub(crate) name: &'a str,
    pub(crate) inputs: &'a OscillatorInputs,
    pub(crate) contact: &'a Contact,
}

impl Moving<4> for OscillatorModel<'_> {
    type Key = OscillatorKey;
    type System = StickSlip;

    fn name(&self) -> &str {
        self.name
    }

    const CLOCK: Clock = Clock { symbol: "θ", time: "time θ = ω_nx t", frequency: "frequency ω/ω_nx" };
    const COORDINATES: [Coordinate; 4] = [
        Coordinate {
            name: "x", long_name: "displacement x/x0 along sliding", label: "Displacement $x̃$ (−)"
        },
        Coordinate {
            name: "y",
            long_name: "displacement y/x0 into the substrate",
            label: "Displacement $ỹ$ (−)",
        },
        Coordinate {
            name: "velocity_x", long_name: "velocity dx̃/dθ", label: "Velocity d$x̃$/d$θ$ (−)"
        },
        Coordinate {
            name: "velocity_y", long_name: "velocity dỹ/dθ", label: "Velocity d$ỹ$/d$θ$ (−)"
        },
    ];
    const FURTHER: &'static [Coordinate] = &[
        Coordinate {
            name: "relative_velocity",
            long_name: "velocity of the indenter less that of the substrate, over x0 ω_nx",
            label: "Relative velocity $ṽ_{rel}$ (−)",
        },
        Coordinate {
            name: "contact_area",
            long_name: "contact area A/R²",
            label: "Contact area $A$/$R$² (−)",
        },
        Coordinate {
            name: "normal_force",
            long_name: "contact force F_k over the load F_n",
            label: "Contact force $F_{k}$/$F_{n}$ (−)",
        },
    ];

    fn operating(
        &self,
        set: Option<(&Sweep<OscillatorKey>, f64)>,
    ) -> Result<Operating<StickSlip>, OscillatorError> {
        let mut inputs = *self.inputs;
        if let Some((sweep, value)) = set {
            sweep.set(&mut inputs, value);
        }
        let coefficients = bridge::groups(&inputs).coefficients()?;
        let per_metre = coefficients.radius() / inputs.number(OscillatorKey::Radius);
        Ok(Operating {
            system: StickSlip::new(self.contact.clone(), coefficients)?,
            per_second: inputs.number(OscillatorKey::NaturalFrequency),
            per_metre,
            si: inputs.si_units(),
        })
    }

    fn further(system: &StickSlip, sample: &StateSample<4>) -> Vec<f64> {
        let relative = system.relative_velocity(&sample.state);
        let response = system.response(sample.contact_state, &sample.state);
        let force = response.force.value / system.coefficients().normal_load;
        vec![relative, response.area.value, force]
    }

    fn memory(system: &StickSlip) -> Option<ContactMemory> {
        let c = system.coefficients();
        Some(ContactMemory { belt_velocity: system.belt_velocity(), retardation_time: c.retardation_time })
    }

    fn concern(operating: &Operating<StickSlip>, state: &[f64; 4]) -> Option<String> {
        operating.system.concern(state).map(|concern| concern.to_string())
    }

    fn axis(sweep: &Sweep<OscillatorKey>) -> SweptAxis {
        axis::of_key(sweep)
    }
}

/// The mass on a belt of a case.
pub struct BeltModel<'a> {
    /// Of the analysis.
    name: &'a str,
    inputs: &'a BeltInputs,
    /// The friction coefficient, where it is none of the keys.
    curve: Option<&'a FrictionCurve<true>>,
}

impl<'a> BeltModel<'a> {
    /// The seconds of a unit of its time, where the case is in SI.
    pub(crate) fn second(&self) -> Option<f64> {
        self.inputs.si_units().map(|units| units.second)
    }

    /// That of a case, for the analysis of this name.
    pub fn new(case: &'a BeltCase, name: &'a str) -> Self {
        Self { name, inputs: &case.inputs, curve: case.curve.as_ref() }
    }
}

impl Moving<2> for BeltModel<'_> {
    type Key = BeltKey;
    type System = BeltOscillator;

    fn name(&self) -> &str {
        self.name
    }

    const CLOCK: Clock = Clock { symbol: "t", time: "time t", frequency: "frequency ω" };
    const COORDINATES: [Coordinate; 2] = [
        Coordinate { name: "x", long_name: "displacement", label: "Displacement $x$ (−)" },
        Coordinate { name: "velocity_x", long_name: "velocity", label: "Velocity d$x$/d$t$ (−)" },
    ];
    const FURTHER: &'static [Coordinate] = &[Coordinate {
        name: "relative_velocity",
        long_name: "velocity of the mass less that of the belt",
        label: "Relative velocity $v_{rel}$ (−)",
    }];

    fn operating(
        &self,
        set: Option<(&Sweep<BeltKey>, f64)>,
    ) -> Result<Operating<BeltOscillator>, OscillatorError> {
        let mut inputs = *self.inputs;
        if let Some((sweep, value)) = set {
            sweep.set(&mut inputs, value);
        }
        let number = |key: BeltKey| inputs.in_units(key);
        let [damping, normal_force, velocity] =
            [BeltKey::Damping, BeltKey::NormalForce, BeltKey::Velocity].map(number);
        let friction = inputs.friction(self.curve)?;
        let system = BeltOscillator::new(damping, normal_force, velocity, friction)?
            .with_cubic_stiffness(number(BeltKey::CubicStiffness))?;
        let si = inputs.si_units();
        let [per_second, per_metre] = [si.map(|units| units.second), si.map(|units| units.metre)]
            .map(|own| own.map_or(f64::NAN, f64::recip));
        Ok(Operating { system, per_second, per_metre, si })
    }

    fn further(system: &BeltOscillator, sample: &StateSample<2>) -> Vec<f64> {
        vec![system.relative_velocity(&sample.state)]
    }

    fn memory(_: &BeltOscillator) -> Option<ContactMemory> {
        None
    }

    fn concern(operating: &Operating<BeltOscillator>, state: &[f64; 2]) -> Option<String> {
        let beyond = operating.system.beyond(state)?;
        Some(match operating.si {
            Some(units) => beyond.scaled(units.metre / units.second).text("m/s"),
            None => beyond.text(""),
        })
    }

    fn axis(sweep: &Sweep<BeltKey>) -> SweptAxis {
        axis::of_key(sweep)
    }
}
