//! `march`: explicit time integration of the coupled structures along the path.

use crate::sliding::case::SlidingCase;
use crate::sliding::case::motion::{PlaneAxis, check_course};
use crate::sliding::case::observe::{CONTACT_SIGNALS, PointQuantity, Signal};
use crate::sliding::case::problem::SlidingProblem;
use crate::sliding::case::signals::{Sampling, SoundSignals};
use judder_keys::cause::Cause;
use judder_keys::declared::{Named, Number, Whole, all, both};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_keys::{Choice, Settings};
use judder_sliding::march::{ContactMethod, Predictor};
use std::f64::consts::TAU;

/// The word of a method, before what belongs to it is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
#[choice(what = "method")]
pub enum MarchWord {
    /// Couplings of the rigid, a-priori motion.
    Subs,
    /// Couplings of the deformed structures.
    Ensubs,
    /// Forward increment Lagrange multipliers.
    Film,
    /// Exact between contacts.
    ResidualFlexibility,
}

impl MarchWord {
    /// The method of the word, `subs` without the static slope; the cut-off is that of `residual-flexibility`, rad/s.
    pub(crate) fn method(self, cut_off: Option<f64>) -> ContactMethod {
        match self {
            Self::Subs => ContactMethod::Subs { static_slope: false },
            Self::Ensubs => ContactMethod::EnSubs,
            Self::Film => ContactMethod::Film,
            Self::ResidualFlexibility => {
                ContactMethod::ResidualFlexibility { cut_off: cut_off.unwrap_or(CUT_OFF) / TAU }
            }
        }
    }
}

/// Whether the rigid, a-priori motion knows of the deformed track.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
#[choice(what = "slope")]
pub enum Slope {
    /// It does not.
    None,
    /// Its static slope is put in.
    Static,
}

/// A march along the path, or along a part of it.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = MarchAnalysis::complete)]
pub struct MarchAnalysis {
    /// How the coupled structures are integrated.
    #[key(name = "method")]
    pub word: MarchWord,
    /// Time step; where left out, 3e-7 s or 0.9 of the limit of stability, of `residual-flexibility` 3e-6 s or 0.75 of it, whichever is smaller.
    #[key(rule = Number::positive(Dimension::TIME), symbol = "h")]
    pub step: Option<f64>,
    /// Where it begins, and the ramps run; `motion.start` where left out.
    #[key(rule = POSITION, symbol = "s", filled)]
    pub from: f64,
    /// Where it ends; `motion.end` where left out.
    #[key(rule = POSITION, symbol = "s", filled)]
    pub to: f64,
    /// How signals are low-passed and decimated, 1/step ≥ sample_rate > 2 pass_band, and what is kept of the observed points.
    #[key(default)]
    pub signals: Sampling,
    /// The signal whose peak and bursts are told: `POINT.x` or `POINT.y`, an acceleration, `POINT.y.velocity`, `POINT.y.displacement`, `normal-force`, `tangential-force` or `sliding-velocity`; the first point's acceleration along y where left out.
    #[key(filled)]
    pub signal: Named<Signal>,
    /// Of `residual-flexibility`: modes above are replaced by their flexibility.
    #[key(rule = Number::positive(Dimension::ANGULAR_FREQUENCY), symbol = "ω_c", usual = CUT_OFF, omitted)]
    pub cut_off: Option<f64>,
    /// Of `subs`: whether the static slope of the deformed track is put in.
    #[key(usual = Slope::None, omitted)]
    pub slope: Option<Slope>,
    /// Of `ensubs` and `film`: the displacements of the next step that the geometry of the contact is taken from.
    #[key(usual = Predictor::WithForce, omitted)]
    pub predictor: Option<Predictor>,
    /// Leave the accelerations that are kept, and `signal`, as WAV, or these signals, each with its gain in the summary.
    #[key(default = SoundSignals::Accelerations)]
    pub sound: SoundSignals,
    /// Steps between two states that an interrupted march can go on from.
    #[key(rule = Whole { from: 1000, to: 1_000_000_000 }, default = 500_000)]
    pub checkpoint_steps: usize,
}

const POSITION: Number = Number::non_negative(Dimension::LENGTH);

/// Above which modes are replaced by their flexibility where the case does not say, rad/s.
pub const CUT_OFF: f64 = 60e3 * TAU;
/// The most steps of a march: weeks.
pub const STEPS: f64 = 1e12;

impl MarchAnalysis {
    /// How it integrates.
    pub fn method(&self) -> ContactMethod {
        match self.word {
            MarchWord::Subs => ContactMethod::Subs { static_slope: self.slope == Some(Slope::Static) },
            other => other.method(self.cut_off),
        }
    }

    /// Refuses what means nothing to the method, and fills in what does and is left out.
    fn complete(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        // Subs knows the geometry beforehand; the march with residual flexibility comes to the force of the step itself
        let refused: &[&'static str] = match self.word {
            MarchWord::Subs => &["cut_off", "predictor"],
            MarchWord::Ensubs | MarchWord::Film => &["slope", "cut_off"],
            MarchWord::ResidualFlexibility => &["slope", "predictor"],
        };
        all(refused.iter().map(|key| refuse_with(section, key, self.word)))?;
        match self.word {
            MarchWord::Subs => drop(self.slope.get_or_insert(Slope::None)),
            MarchWord::Ensubs | MarchWord::Film => drop(self.predictor.get_or_insert(Predictor::WithForce)),
            MarchWord::ResidualFlexibility => drop(self.cut_off.get_or_insert(CUT_OFF)),
        }
        self.signals.check(self.step).map_err(|problem| problem.at(section.place_of(&["signals"])))
    }

    /// Finds the signals, and refuses a march that is no part of the motion of the case.
    pub(crate) fn admit(mut self, case: &SlidingCase, section: &Section<'_>) -> Result<Self, Fault> {
        let signal = Signal::named(section, "signal", &case.points).map(|found| self.signal = found);
        let sound = self.sound.admit(section.get("sound"), &case.points);
        both(both(self.take_path(case, section), signal), sound)?;
        Ok(self)
    }

    /// The part of the path that is marched.
    fn take_path(&mut self, case: &SlidingCase, section: &Section<'_>) -> Result<(), Fault> {
        let [start, end] = [case.motion.start, case.motion.end];
        for (key, position, usual) in [("from", &mut self.from, start), ("to", &mut self.to, end)] {
            match section.get(key) {
                None => *position = usual,
                Some(node) if !(start.min(end)..=start.max(end)).contains(position) => {
                    let (key, position) = (key.to_owned(), *position);
                    return Err(SlidingProblem::OutsidePath { key, position, start, end }.at(node.place));
                }
                Some(_) => (),
            }
        }
        check_course([self.from, self.to], case.motion.velocity)
            .map_err(|problem| problem.at(section.place_of(&["to", "from"])))?;
        let time = (self.to - self.from) / case.motion.velocity + case.motion.ramps.velocity;
        match self.step.map(|step| time / step) {
            Some(steps) if steps > STEPS => {
                let problem = SlidingProblem::TooManySteps { steps, limit: STEPS };
                Err(problem.at(section.place_of(&["step"])))
            }
            _ => Ok(()),
        }
    }
}

impl MarchAnalysis {
    /// The signals that are kept: the quantities of so many observed points, those of the contact, what is told, what is heard.
    pub fn kept(&self, points: usize) -> Vec<Signal> {
        let of_point = |point: usize| {
            let all = self.signals.quantities.iter();
            all.flat_map(move |&quantity| {
                PlaneAxis::ALL.map(|(_, axis)| Signal::Point { point, axis, quantity })
            })
        };
        let mut kept: Vec<Signal> = (0..points).flat_map(of_point).collect();
        kept.extend(CONTACT_SIGNALS.map(|(_, signal)| signal));
        let heard = match &self.sound {
            SoundSignals::Signals(signals) => &signals[..],
            SoundSignals::Nothing | SoundSignals::Accelerations => &[],
        };
        for signal in std::iter::once(&self.signal).chain(heard) {
            if !kept.contains(signal) {
                kept.push(**signal);
            }
        }
        kept
    }

    /// The signals that are left as sound, of so many observed points.
    pub fn heard(&self, points: usize) -> Vec<Signal> {
        let is_acceleration =
            |signal: &Signal| matches!(signal, Signal::Point { quantity: PointQuantity::Acceleration, .. });
        match &self.sound {
            SoundSignals::Nothing => Vec::new(),
            SoundSignals::Signals(signals) => signals.iter().map(|signal| **signal).collect(),
            SoundSignals::Accelerations => {
                let mut kept = self.kept(points);
                kept.retain(|signal| *signal == *self.signal || is_acceleration(signal));
                kept
            }
        }
    }
}

/// Refuses a key that means nothing to a method.
pub(crate) fn refuse_with(section: &Section<'_>, key: &'static str, method: MarchWord) -> Result<(), Fault> {
    let Some(node) = section.get(key) else { return Ok(()) };
    let with = format!("method = \"{}\"", method.name());
    Err(Cause::Meaningless { key, with }.at(node.place))
}
