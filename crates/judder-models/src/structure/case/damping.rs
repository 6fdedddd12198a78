//! `[damping]`: the damping of a body.

use super::problem::StructureProblem;
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{Number, Several, Whole, conflict};
use judder_keys::dimension::Dimension;
use judder_keys::error::Fault;
use judder_keys::problem::Placed;
use judder_keys::section::Section;
use judder_structure::StructureError;
use judder_structure::damping::{MOST_FREEDOMS, ModalDamping};

/// The damping of a body.
#[derive(Debug, Clone, PartialEq, Default, Settings)]
pub enum Damping {
    /// None.
    #[default]
    None,
    /// C = α M + β K.
    Rayleigh(Rayleigh),
    /// C = η K/ω_r, which meets structural damping K (1 + iη) at one frequency.
    Structural(Structural),
    /// A ratio for each of the lowest modes.
    Ratios {
        /// Damping ratios of the lowest modes that swing, by rising frequency, each its own: C = M Φ diag(2 ζ_k ω_k) Φᵀ M; rigid motions and higher modes have none.
        #[key(rule = MODE_RATIOS, symbol = "ζ_k", example = "[0.01, 0.02]")]
        ratios: Vec<f64>,
    },
    /// The same ratio for so many.
    Ratio {
        /// Damping ratio of each of the lowest modes that swing, in place of ratios.
        #[key(rule = Number::non_negative(Dimension::NUMBER), symbol = "ζ")]
        ratio: f64,
        /// How many modes have it; rigid motions and higher modes have none.
        #[key(rule = Whole { from: 1, to: MOST_FREEDOMS })]
        modes: usize,
    },
}

/// C = α M + β K.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = Rayleigh::complete)]
pub struct Rayleigh {
    /// Damping in proportion to the mass, C = α M + β K.
    #[key(rule = Number::non_negative(Dimension::RATE), symbol = "α", default = 0.0)]
    pub alpha: f64,
    /// Damping in proportion to the stiffness.
    #[key(rule = Number::non_negative(Dimension::TIME), symbol = "β", default = 0.0)]
    pub beta: f64,
    /// Two damping ratios, in place of alpha and beta, which follow from them.
    #[key(rule = RATIOS, unwritten)]
    pub ratios: Option<Vec<RatioAt>>,
}

/// A frequency and its damping ratio.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
#[settings(title = "an entry of `{path}`")]
pub struct RatioAt {
    /// Frequency at which a damping ratio is given, in place of α and β.
    #[key(rule = FREQUENCY, symbol = "ω_k")]
    pub frequency: f64,
    /// The damping ratio there, ζ = α/(2ω) + βω/2.
    #[key(rule = Number::non_negative(Dimension::NUMBER), symbol = "ζ_k")]
    pub ratio: f64,
}

/// Structural damping, met at one frequency.
#[derive(Debug, Clone, Copy, PartialEq, Settings)]
pub struct Structural {
    /// Loss factor of structural damping, met by C = η K/ω_r at one frequency.
    #[key(rule = Number::non_negative(Dimension::NUMBER), symbol = "η")]
    pub loss_factor: f64,
    /// Frequency at which structural damping is met.
    #[key(rule = FREQUENCY, symbol = "ω_r")]
    pub reference_frequency: f64,
}

const FREQUENCY: Number = Number::positive(Dimension::ANGULAR_FREQUENCY);
const MODE_RATIOS: Several<Number> =
    Several { of: Number::non_negative(Dimension::NUMBER), length: [1, MOST_FREEDOMS] };
const RATIOS: Several<()> = Several { of: (), length: [2, 2] };

impl Damping {
    /// That by ratios of modes, where it is.
    ///
    /// # Errors
    /// [`StructureError::InvalidNumber`] for no ratio.
    pub(crate) fn modal(&self) -> Result<Option<ModalDamping>, StructureError> {
        match self {
            Self::Ratios { ratios } => ModalDamping::new(ratios.clone()).map(Some),
            Self::Ratio { ratio, modes } => ModalDamping::new(vec![*ratio; *modes]).map(Some),
            Self::None | Self::Rayleigh(_) | Self::Structural(_) => Ok(None),
        }
    }
}

impl Rayleigh {
    /// α and β from two damping ratios ζ = α/(2ω) + βω/2, where they are given.
    fn complete(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        let (Some(ratios), Some(node)) = (&self.ratios, section.get("ratios")) else { return Ok(()) };
        conflict(section, "alpha", "ratios")?;
        conflict(section, "beta", "ratios")?;
        let [mut first, mut second] = ratios[..] else {
            let (key, expected) = (section.path("ratios"), "two pairs of frequency and ratio");
            return Err(Cause::Length { key, expected, found: ratios.len() }.at(node.place));
        };
        if first.frequency > second.frequency {
            std::mem::swap(&mut first, &mut second);
        }
        if first.frequency == second.frequency {
            return Err(Cause::EmptyRange { from: first.frequency.into() }.at(node.place));
        }
        let spread = (second.frequency - first.frequency) * (second.frequency + first.frequency);
        let crossed = first.ratio * second.frequency - second.ratio * first.frequency;
        self.alpha = 2.0 * first.frequency * second.frequency * crossed / spread;
        self.beta = 2.0 * (second.ratio * second.frequency - first.ratio * first.frequency) / spread;
        if self.alpha >= 0.0 && self.beta >= 0.0 {
            return Ok(());
        }
        let (first_frequency, second_frequency) = (first.frequency, second.frequency);
        let (first, second) = (first.ratio, second.ratio);
        Err(StructureProblem::NegativeDamping { first, first_frequency, second, second_frequency }
            .at(node.place))
    }
}
