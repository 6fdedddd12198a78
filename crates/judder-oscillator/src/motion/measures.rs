//! What a motion did over a time: averages, fractions, work.

use super::ContactState;
use judder_numerics::piecewise::Leg;
use judder_numerics::quadrature::gauss_legendre;
use std::sync::LazyLock;

/// Exact for the squares of the quartics along a step.
static NODES: LazyLock<[(f64, f64); 5]> = LazyLock::new(gauss_legendre::<5>);

/// Where energy enters and leaves the oscillator, each as the power into it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Powers {
    /// Of the friction force: what the moving substrate feeds in less what sliding costs.
    pub friction: f64,
    /// Of that what the moving substrate feeds in, F_μ v_d; the rest is lost where v_rel is not zero.
    pub substrate: f64,
    /// Of the substrate's normal force.
    pub normal: f64,
    /// Of the dampers, never positive.
    pub damping: f64,
}

/// Integrals along a motion, added leg by leg.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measures {
    /// Time covered.
    pub duration: f64,
    first_moment: f64,
    second_moment: f64,
    /// Times in the four contact states, in the order of [`ContactState::ALL`].
    times: [f64; 4],
    /// Smallest and largest x at the ends of steps.
    pub range: (f64, f64),
    /// Changes of the contact state.
    pub changes: usize,
    /// Work done on the oscillator.
    pub work: Powers,
}

impl Default for Measures {
    fn default() -> Self {
        Self {
            duration: 0.0,
            first_moment: 0.0,
            second_moment: 0.0,
            times: [0.0; 4],
            range: (f64::INFINITY, f64::NEG_INFINITY),
            changes: 0,
            work: Powers::default(),
        }
    }
}

impl Measures {
    /// Adds a leg, with the powers in each of its states; moments are taken about `centre`, which keeps the digits of a small motion
    /// about a distant place.
    pub fn add<M: Copy + Into<ContactState>, const N: usize>(
        &mut self,
        leg: &Leg<M, N>,
        centre: f64,
        powers: impl Fn(&[f64; N]) -> Powers,
    ) {
        self.duration += leg.step;
        self.times[usize::from(leg.mode.into().number())] += leg.step;
        for (node, weight) in NODES.iter() {
            let state = leg.at(*node);
            let (x, share) = (state[0] - centre, weight * leg.step);
            self.first_moment += share * x;
            self.second_moment += share * x * x;
            let powers = powers(&state);
            self.work.friction += share * powers.friction;
            self.work.substrate += share * powers.substrate;
            self.work.normal += share * powers.normal;
            self.work.damping += share * powers.damping;
        }
        for x in [leg.dense[0][0], leg.end[0]] {
            self.range = (self.range.0.min(x), self.range.1.max(x));
        }
    }

    /// The mean of x about the centre.
    #[must_use]
    pub fn mean(&self) -> f64 {
        self.first_moment / self.duration
    }

    /// The root mean square of x about its mean.
    #[must_use]
    pub fn rms(&self) -> f64 {
        (self.second_moment / self.duration - self.mean() * self.mean()).max(0.0).sqrt()
    }

    /// The share of the time in a contact state.
    #[must_use]
    pub fn fraction(&self, contact_state: ContactState) -> f64 {
        self.times[usize::from(contact_state.number())] / self.duration
    }

    /// Half the distance between the smallest and the largest x.
    #[must_use]
    pub fn amplitude(&self) -> f64 {
        0.5 * (self.range.1 - self.range.0)
    }
}
