//! The state of rest in steady sliding: the deformed configuration.

use crate::SlidingError;
use crate::coupling::{Coupling, Sliding, product};
use crate::edge::{EdgePoint, Touch};
use crate::pair::Pair;
use crate::plane::{length, minus, plus};

/// Both structures at rest under the load, sliding steadily.
#[derive(Debug, Clone, PartialEq)]
pub struct Equilibrium {
    /// Modal coordinates, √kg m.
    pub state: Vec<f64>,
    /// Normal force, N.
    pub normal_force: f64,
    /// How the contact point touches the deformed edge.
    pub touch: Touch,
}

/// How the contact point may still move in the last iteration, m.
const TOLERANCE: f64 = 1e-15;
/// What rounding may leave of that, as a share of a segment; asked only of an iteration that has had its time.
const ROUNDING: f64 = 1e-9;
const ITERATIONS: usize = 100;
/// After so many iterations a contact that still goes to and fro between two segments rests on the node between them.
const HESITATION: usize = 20;

impl Equilibrium {
    /// The linear coupling there, with all that follows the motion: the geometry, and a friction coefficient that falls.
    #[must_use]
    pub fn coupling(&self, pair: &Pair, sliding: Sliding) -> Coupling {
        Coupling::new(pair, &self.touch, sliding)
            .with_falling_friction(pair, &self.touch, sliding, self.normal_force)
            .with_wandering(pair, &self.touch, sliding, self.normal_force)
    }

    /// The equilibrium at a position under a load in N: K q = F φ_A + e N with the gap closed, e and c those of the deformed
    /// contact.
    ///
    /// Where the normal jumps at a node, a contact that would leave either segment for the other rests on the node, with the normal of the
    /// segment before it.
    ///
    /// # Errors
    /// [`SlidingError::OffTrack`]; [`SlidingError::NoEquilibrium`] where a rigid motion is not held, or the load lifts the slider off;
    /// [`SlidingError::NoConvergence`].
    pub fn new(pair: &Pair, position: f64, load: f64, sliding: Sliding) -> Result<Self, SlidingError> {
        let mut touch = pair.undeformed(position)?;
        let mut moved = f64::INFINITY;
        let mut held = None;
        for iteration in 0..ITERATIONS {
            let coupling = Coupling::new(pair, &touch, sliding);
            let (state, normal_force) = Self::at_touch(pair, (position, load), &touch, &coupling)?;
            let next = match held {
                Some(at) => held_touch(pair, position, at, &state),
                None => pair.deformed(position, &state)?,
            };
            let (before, after) = (touch.at.segment, next.at.segment);
            if iteration >= HESITATION && before.abs_diff(after) == 1 {
                held = Some(EdgePoint { segment: before.min(after), fraction: 1.0 });
            }
            moved = place_change(&touch, &next);
            touch = next;
            if moved <= TOLERANCE || (iteration >= HESITATION && moved <= ROUNDING * touch.stretch) {
                return Ok(Self { state, normal_force, touch });
            }
        }
        Err(SlidingError::NoConvergence { position, iterations: ITERATIONS, residual: moved })
    }

    /// The equilibrium on the undeformed geometry: linear.
    ///
    /// # Errors
    /// As of [`Equilibrium::new`], but that nothing iterates.
    pub fn undeformed(pair: &Pair, position: f64, load: f64, sliding: Sliding) -> Result<Self, SlidingError> {
        let touch = pair.undeformed(position)?;
        let coupling = Coupling::new(pair, &touch, sliding);
        let (state, normal_force) = Self::at_touch(pair, (position, load), &touch, &coupling)?;
        Ok(Self { state, normal_force, touch })
    }

    /// The state for a given geometry: linear but for the one rigid motion that the contact may hold.
    fn at_touch(
        pair: &Pair,
        (position, load): (f64, f64),
        touch: &Touch,
        coupling: &Coupling,
    ) -> Result<(Vec<f64>, f64), SlidingError> {
        let refuse = |reason| Err(SlidingError::NoEquilibrium { position, reason });
        let eigenvalues = pair.eigenvalues();
        let (c, e) = (&coupling.compatibility, &coupling.equilibrium);
        let loads: Vec<f64> = {
            let of_slider = pair.slider().load.iter().map(|row| row * load);
            of_slider.chain(std::iter::repeat_n(0.0, pair.track().body.modes())).collect()
        };
        let rigid: Vec<usize> = (0..eigenvalues.len()).filter(|k| eigenvalues[*k] == 0.0).collect();
        let flexible = |factors: &[f64]| -> Vec<f64> {
            let yields = |(f, value): (&f64, &f64)| if *value == 0.0 { 0.0 } else { f / value };
            factors.iter().zip(&eigenvalues).map(yields).collect()
        };
        let (by_load, by_force) = (flexible(&loads), flexible(e));
        // n·(x_C − P) on the nodes of this touch where nothing is deformed
        let places = pair.stencil(touch.at.segment, |_| [0.0; 2]);
        let rigid_gap = pair.edge().touch_at(pair.rigid_place(position), touch.at, &places);
        let offset =
            minus(pair.rigid_place(position), crate::edge::combined(&rigid_gap.weights.value, &places));
        let open = crate::plane::dot(touch.normal, offset) + product(c, &by_load);
        let (force, raised) = match rigid[..] {
            [] => (-open / product(c, &by_force), None),
            [mode] => {
                let force = -loads[mode] / e[mode];
                (force, Some((mode, -(open + force * product(c, &by_force)) / c[mode])))
            }
            _ => return refuse("it has more than one rigid motion, and one contact holds only one"),
        };
        if !force.is_finite() {
            return refuse("its rigid motion is not across the contact");
        }
        if force < 0.0 {
            return refuse("the load pulls the slider off the track");
        }
        let mut state: Vec<f64> = by_load.iter().zip(&by_force).map(|(a, b)| a + force * b).collect();
        if let Some((mode, value)) = raised {
            state[mode] = value;
        }
        Ok((state, force))
    }
}

/// How the contact point touches the deformed edge at a given place of it.
fn held_touch(pair: &Pair, position: f64, at: EdgePoint, state: &[f64]) -> Touch {
    let (of_slider, of_track) = state.split_at(pair.slider().body.modes());
    let point = plus(pair.rigid_place(position), 1.0, pair.slider().contact.displacement(of_slider));
    let places = pair.stencil(at.segment, |node| pair.track().nodes[node].displacement(of_track));
    pair.edge().touch_at(point, at, &places)
}

/// How far the contact point has moved on the edge, with the normal's turn over a segment, m.
fn place_change(old: &Touch, new: &Touch) -> f64 {
    let along = (new.at.segment as f64 - old.at.segment as f64) + new.at.fraction - old.at.fraction;
    (along.abs() + length(minus(new.normal, old.normal))) * new.stretch
}
