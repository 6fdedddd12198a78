//! What the errors of a contact law leave of equivalent damping, growth rate and verdict.
//!
//! C and K hang on the *slopes* of the law over speed and depth, which are known far worse than its values. Each of its nine numbers may be off by
//! what [`ContactLaw::doubt`] says, each on its own: to first order the entries of (20) are off by the sum of what every number adds, and by
//! what follows from the depth, which the values move through (15). So the entries lie in a box, and what holds in all of it holds
//! whatever the law's errors are. The box is looked at on a grid of its middle, its faces and its corners.

use crate::Contact;
use crate::characteristic::Characteristic;
use crate::conservative::discriminant_share;
use crate::equilibrium::Equilibrium;
use crate::error::OscillatorError;
use crate::friction::friction_force;
use crate::groups::Coefficients;
use crate::linear_system::ReducedSystem;
use crate::linearisation::Linearisation;
use crate::spectrum::{eigenvalues, growth_rate};
use judder_contact::{ContactLaw, ContactResponse, LawPoint, WithDerivatives};

/// The largest error of ln ŷ_e for which first order is enough.
const FARTHEST: f64 = 0.5;

/// How far the entries of C and K may be off by the errors of the law.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct EntryErrors {
    /// Of c11.
    pub c11: f64,
    /// Of c21.
    pub c21: f64,
    /// Of k12c.
    pub k12c: f64,
    /// Of k22.
    pub k22: f64,
}

/// Steady sliding with the errors of its law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WithinLaw {
    linearisation: Linearisation,
    errors: EntryErrors,
}

impl WithinLaw {
    /// About an equilibrium; `None` where the errors of the law are not known, or move the depth too far for first order.
    #[must_use]
    pub fn new(contact: &Contact, c: &Coefficients, state: &Equilibrium) -> Option<Self> {
        let at = LawPoint::new(c.velocity, state.indentation);
        let doubt = contact.law.doubt(&at)?;
        let linearisation = Linearisation::new(contact.friction_load, c, &state.response);
        let off = |response: &ContactResponse| {
            EntryErrors::between(&linearisation, &Linearisation::new(contact.friction_load, c, response))
        };
        let mut errors = EntryErrors::default();
        let mut load = 0.0;
        let carried = |response: &ContactResponse| {
            c.coupling_ratio * friction_force(contact.friction_load, c, response).value + response.force.value
        };
        for moved in each_moved(&state.response, &doubt) {
            errors = errors.plus(&off(&moved));
            load += (carried(&moved) - carried(&state.response)).abs();
        }
        if load > 0.0 {
            let friction = friction_force(contact.friction_load, c, &state.response);
            let slope = c.spring * c.stiffness
                + c.coupling_ratio * friction.by_indentation
                + state.response.force.by_indentation;
            let deeper = load / (slope.abs() * state.indentation);
            let is_near = deeper <= FARTHEST;
            if !is_near {
                return None;
            }
            let [up, down] = [deeper, -deeper].map(|by| {
                let at = LawPoint::at_ln_indentation(at.velocity, at.ln_velocity, at.ln_indentation + by);
                off(&contact.law.evaluate(&at))
            });
            errors = errors.plus(&up.larger(&down));
        }
        errors.is_finite().then_some(Self { linearisation, errors })
    }

    /// How far ξ_eq may be off.
    #[must_use]
    pub fn equivalent_damping_error(&self) -> f64 {
        0.5 * self.errors.c11
    }

    /// The smallest and the largest growth rate in the box.
    ///
    /// # Errors
    /// As of [`eigenvalues`].
    pub fn growth_rates(&self) -> Result<(f64, f64), OscillatorError> {
        self.systems().try_fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), system| {
            let growth = growth_rate(&eigenvalues(&system)?);
            Ok((growth.min(least), growth.max(most)))
        })
    }

    /// Whether the verdict is the same in the whole box; where it is not, steady sliding is marginal within the law.
    #[must_use]
    pub fn is_decided(&self) -> bool {
        self.is_same(|system| Characteristic::new(system).stability_sign())
    }

    /// Whether the modes without damping have merged, or have not, in the whole box.
    #[must_use]
    pub fn is_merging_decided(&self) -> bool {
        self.is_same(|system| discriminant_share(&system.stiffness).signum())
    }

    fn is_same(&self, sign: impl Fn(&ReducedSystem) -> f64) -> bool {
        let own = sign(&reduced(&self.linearisation));
        self.systems().all(|system| sign(&system) == own)
    }

    /// The systems of the grid; one alone of a law without errors.
    fn systems(&self) -> impl Iterator<Item = ReducedSystem> + use<> {
        let Self { linearisation: own, errors } = *self;
        let places = |value: f64, error: f64| {
            let count = if error > 0.0 { 3 } else { 1 };
            [value, value - error, value + error].into_iter().take(count)
        };
        places(own.c11, errors.c11).flat_map(move |c11| {
            places(own.c21, errors.c21).flat_map(move |c21| {
                places(own.k12c, errors.k12c).flat_map(move |k12c| {
                    places(own.k22, errors.k22)
                        .map(move |k22| reduced(&Linearisation { c11, c21, k12c, k22, ..own }))
                })
            })
        })
    }
}

fn reduced(linearisation: &Linearisation) -> ReducedSystem {
    ReducedSystem { damping: linearisation.damping(), stiffness: linearisation.stiffness() }
}

/// The response with one of its nine numbers moved by its error, for each of them.
fn each_moved(
    response: &ContactResponse,
    doubt: &ContactResponse,
) -> impl Iterator<Item = ContactResponse> + use<> {
    type NumberOf = fn(&mut WithDerivatives) -> &mut f64;
    type QuantityOf = fn(&mut ContactResponse) -> &mut WithDerivatives;
    const NUMBERS: [NumberOf; 3] = [|q| &mut q.value, |q| &mut q.by_velocity, |q| &mut q.by_indentation];
    const QUANTITIES: [QuantityOf; 3] = [|r| &mut r.force, |r| &mut r.area, |r| &mut r.friction];
    let (response, mut doubt) = (*response, *doubt);
    QUANTITIES.into_iter().flat_map(|quantity| NUMBERS.map(|number| (quantity, number))).map(
        move |(quantity, number)| {
            let mut moved = response;
            *number(quantity(&mut moved)) += *number(quantity(&mut doubt));
            moved
        },
    )
}

impl EntryErrors {
    fn between(a: &Linearisation, b: &Linearisation) -> Self {
        Self {
            c11: (a.c11 - b.c11).abs(),
            c21: (a.c21 - b.c21).abs(),
            k12c: (a.k12c - b.k12c).abs(),
            k22: (a.k22 - b.k22).abs(),
        }
    }

    fn combined(&self, other: &Self, of: impl Fn(f64, f64) -> f64) -> Self {
        Self {
            c11: of(self.c11, other.c11),
            c21: of(self.c21, other.c21),
            k12c: of(self.k12c, other.k12c),
            k22: of(self.k22, other.k22),
        }
    }

    fn plus(&self, other: &Self) -> Self {
        self.combined(other, |a, b| a + b)
    }

    fn larger(&self, other: &Self) -> Self {
        self.combined(other, f64::max)
    }

    fn is_finite(&self) -> bool {
        [self.c11, self.c21, self.k12c, self.k22].into_iter().all(f64::is_finite)
    }
}
