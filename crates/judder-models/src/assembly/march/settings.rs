//! `march`: how a motion is integrated, from where, and what is kept of it.

use super::driven::settings::DrivenSettings;
use super::field::PlaceExpression;
use crate::assembly::case::AssemblyCase;
use crate::assembly::case::problem::AssemblyProblem;
use crate::sliding::case::signals::Hertz;
use judder_keys::cause::Cause;
use judder_keys::declared::{Number, Settings as _, Several, Whole};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::numeric_key::Range;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_keys::{Choice, Settings};
use judder_nonsmooth::gauss_seidel::ContactAccuracy;
use judder_nonsmooth::march::NonsmoothSettings;
use judder_nonsmooth::scheme::ContactScheme;
use judder_numerics::words::plain;
use judder_study::text::short;

/// The word of a scheme.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
#[choice(what = "method")]
pub enum SchemeWord {
    /// Implicit, on velocities, with impacts, after Moreau and Jean.
    Moreau,
    /// Explicit, on places: forward increment Lagrange multipliers.
    Film,
    /// As `film` where sliding is known to go on, so that points lift off but none sticks: the enriched substructuring of the beams paper.
    Ensubs,
    /// Explicit, springs and dampers in place of the contact, to doubt the others.
    Smoothed,
}

impl SchemeWord {
    /// What it stands for.
    pub(in crate::assembly) fn march(self, step: f64) -> NonsmoothSettings {
        let scheme = match self {
            Self::Moreau => ContactScheme::MoreauJean { restitution: 0.0, implicitness: IMPLICITNESS },
            Self::Film => ContactScheme::ForwardIncrement,
            Self::Ensubs => ContactScheme::KnownSliding,
            Self::Smoothed => ContactScheme::Smoothed,
        };
        NonsmoothSettings { scheme, step, accuracy: ContactAccuracy::default(), cut_off: None }
    }
}

/// A motion through stick, slip and lift-off.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = AssemblyMarch::check)]
pub struct AssemblyMarch {
    /// How the motion is integrated.
    #[key(default = SchemeWord::Moreau)]
    pub method: SchemeWord,
    /// The time step.
    #[key(rule = STEP, symbol = "h")]
    pub step: f64,
    /// How long it takes.
    #[key(rule = STEP)]
    pub duration: f64,
    /// What of its beginning is left out of shares, means and frequencies.
    #[key(rule = Number::non_negative(Dimension::TIME), default = 0.0)]
    pub transient: f64,
    /// How it begins, beside steady sliding; at rest there where left out.
    #[key(omitted)]
    pub start: Option<AssemblyStart>,
    /// Of `moreau`: how much of the velocity with which a point meets the track it leaves it with.
    #[key(rule = RESTITUTION, symbol = "e", usual = 0.0, omitted)]
    pub restitution: Option<f64>,
    /// Of `moreau`: how far in a step forces are taken; above 0.5 the scheme takes energy from swinging within a step, and is of first order.
    #[key(rule = IMPLICITNESSES, symbol = "θ", usual = IMPLICITNESS, omitted)]
    pub implicitness: Option<f64>,
    /// Of the explicit methods: modes of the bodies from this frequency on only yield, and do not bound the step.
    #[key(symbol = "2π f_c", omitted)]
    pub cut_off: Option<Hertz>,
    /// How many of the lowest complex modes about steady sliding are looked for in the motion.
    #[key(rule = Whole { from: 0, to: 500 }, default = 12)]
    pub modes: usize,
    /// What changes over time.
    #[key(flatten)]
    pub driven: DrivenSettings,
    /// Samples of signals and of the states of the contact that are kept, at least.
    #[key(symbol = "2π f_s", default = Hertz(400e3))]
    pub sample_rate: Hertz,
    /// Steps between two states that an interrupted march can go on from, at most; one is kept every ten seconds besides.
    #[key(rule = Whole { from: 1000, to: 1_000_000_000 }, usual = CHECKPOINT_STEPS, omitted)]
    pub checkpoint_steps: Option<usize>,
}

const STEP: Number = Number::positive(Dimension::TIME);
const RESTITUTION: Number = Number { dimension: Dimension::NUMBER, range: Range::Fraction };
const IMPLICITNESSES: Number =
    Number { dimension: Dimension::NUMBER, range: Range::Closed { from: 0.5, to: 1.0 } };
/// θ where the case does not say: of second order.
const IMPLICITNESS: f64 = 0.5;
/// Steps between two states that are kept where the case does not say.
const CHECKPOINT_STEPS: usize = 500_000;
/// The most steps: hours.
const STEPS: f64 = 1e10;

/// Whether a march may have this step and this duration, both in s; in words why not.
pub(in crate::assembly) fn check_steps(step: f64, duration: f64) -> Result<(), String> {
    match duration / step {
        steps if steps > STEPS => {
            Err(format!("{steps:.1e} steps are more than the {STEPS:.0e} that a march may have"))
        }
        steps if steps < 1.0 => {
            let [step, duration] = [step, duration].map(short);
            Err(format!("a step of {step} s is longer than the duration of {duration} s"))
        }
        _ => Ok(()),
    }
}

/// What a motion begins with.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = AssemblyStart::check)]
pub struct AssemblyStart {
    /// Velocities along x, y and z beside steady sliding, in m/s: numbers or expressions of the place x, y, z in m.
    #[key(rule = VELOCITY, example = "[\"1e-3*(1 - y/0.02)\", \"0\"], in m/s", omitted)]
    pub velocity: Option<Vec<PlaceExpression>>,
    /// In place of velocity: a complex mode about steady sliding, by its number as `eigen` lists them.
    #[key(rule = Whole { from: 1, to: 2000 }, omitted)]
    pub mode: Option<usize>,
    /// The largest displacement of the mode.
    #[key(rule = Number::positive(Dimension::LENGTH), omitted)]
    pub amplitude: Option<f64>,
}

const VELOCITY: Several<()> = Several { of: (), length: [2, 3] };

impl AssemblyMarch {
    /// Reads a march of a case, whose structures and folder are known where it is.
    pub(super) fn of(case: Option<&AssemblyCase>, section: &Section<'_>) -> Result<Self, Fault> {
        let mut own = Self::read_table(section)?;
        match case {
            Some(case) => own.driven.found(section, case).map(|()| own),
            None => Ok(own),
        }
    }

    fn check(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        let is_implicit = self.method == SchemeWord::Moreau;
        let meanings =
            [("restitution", is_implicit), ("implicitness", is_implicit), ("cut_off", !is_implicit)];
        for (key, has_meaning) in meanings {
            if let (Some(node), false) = (section.get(key), has_meaning) {
                let with = format!("method = \"{}\"", self.method.name());
                return Err(Cause::Meaningless { key, with }.at(node.place));
            }
        }
        let refused = |key: &'static str, reason: String| {
            Err(AssemblyProblem::Refused { reason }.at(section.place_of(&[key])))
        };
        let (restitution, implicitness) = self.of_impacts();
        if implicitness * (1.0 + restitution) > 1.0 {
            let most = plain(1.0 / (1.0 + restitution));
            let reason = format!(
                "impacts with `restitution` {restitution} would give energy: `implicitness` is 1/(1 + restitution) = {most} at most"
            );
            return refused("implicitness", reason);
        }
        let [all, transient] = self.steps();
        if transient >= all && all > 0 {
            return refused(
                "transient",
                "the transient takes the whole duration: nothing is left to look at".to_owned(),
            );
        }
        check_steps(self.step, self.duration).or_else(|reason| refused("step", reason))
    }

    /// How the motion is integrated.
    pub(super) fn march(&self) -> NonsmoothSettings {
        let settings = self.method.march(self.step);
        let scheme = match settings.scheme {
            ContactScheme::MoreauJean { .. } => {
                let (restitution, implicitness) = self.of_impacts();
                ContactScheme::MoreauJean { restitution, implicitness }
            }
            explicit => explicit,
        };
        NonsmoothSettings { scheme, cut_off: self.cut_off.map(|own| own.0), ..settings }
    }

    /// e and θ.
    fn of_impacts(&self) -> (f64, f64) {
        (self.restitution.unwrap_or(0.0), self.implicitness.unwrap_or(IMPLICITNESS))
    }

    /// Steps between two states that are kept, at most.
    pub(super) fn block(&self) -> u64 {
        self.checkpoint_steps.unwrap_or(CHECKPOINT_STEPS) as u64
    }

    /// Steps in all, and those of the transient.
    pub(super) fn steps(&self) -> [u64; 2] {
        [self.duration, self.transient].map(|time| (time / self.step).round() as u64)
    }
}

impl AssemblyStart {
    fn check(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        if let (Some(field), Some(node)) = (&self.velocity, section.get("velocity"))
            && !(2..=3).contains(&field.len())
        {
            let (key, found) = (section.path("velocity"), field.len());
            let expected = "two or three numbers or expressions, along x, y and z";
            return Err(Cause::Length { key, expected, found }.at(node.place));
        }
        let problem = match (&self.velocity, self.mode, self.amplitude) {
            (Some(_), None, None) | (None, Some(_), Some(_)) => return Ok(()),
            (None, Some(_), None) => "a mode needs an `amplitude`, its largest displacement",
            (None, None, Some(_)) => "an `amplitude` is that of a `mode`",
            (None, None, None) => "a start has a `velocity`, or a `mode` with an `amplitude`",
            (Some(_), _, _) => "a start has either a `velocity` or a `mode` with an `amplitude`",
        };
        Err(AssemblyProblem::Refused { reason: problem.to_owned() }.at(section.place))
    }
}
