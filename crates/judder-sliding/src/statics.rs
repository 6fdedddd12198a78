//! The state of rest in steady sliding: the deformed configuration.

mod corner;

use crate::SlidingError;
use crate::coupling::{Coupling, SteadyFriction, product};
use crate::edge::Touch;
use crate::pair::Pair;
use crate::plane::{length, minus};

/// Both structures at rest under the load, sliding steadily.
#[derive(Debug, Clone, PartialEq)]
pub struct PairEquilibrium {
    /// Modal coordinates, √kg m.
    pub state: Vec<f64>,
    /// Normal force, N.
    pub normal_force: f64,
    /// How the contact point touches the deformed edge.
    pub touch: Touch,
}

/// How far the contact may still move in the last iteration, as a share of the track's length: some roundings of the places from which
/// its own is the difference.
const TOLERANCE: f64 = 1e-14;
const ITERATIONS: usize = 100;

impl PairEquilibrium {
    /// The linear coupling there, with all that follows the motion: the geometry, and a friction coefficient that falls.
    #[must_use]
    pub fn coupling(&self, pair: &Pair, sliding: SteadyFriction) -> Coupling {
        Coupling::new(pair, &self.touch, sliding)
            .with_falling_friction(pair, &self.touch, sliding, self.normal_force)
            .with_wandering(pair, &self.touch, sliding, self.normal_force)
    }

    /// The equilibrium at a position under a load in N: K q = F φ_A + e N with the gap closed, e and c those of the deformed
    /// contact.
    ///
    /// Where the normal jumps at a node, a contact that would leave either segment for the other rests on the node, with the normal of
    /// the cone between both segments' that leaves no distance along the edge either: a force along it is also what two contacts, one
    /// on each segment, make together.
    ///
    /// # Errors
    /// [`SlidingError::OffTrack`]; [`SlidingError::NoEquilibrium`] where a rigid motion is not held, or the load lifts the slider off;
    /// [`SlidingError::NoConvergence`] where after a hundred iterations the contact still moves by more than 1e-14 of the track's length.
    pub fn new(pair: &Pair, position: f64, load: f64, sliding: SteadyFriction) -> Result<Self, SlidingError> {
        let loaded = Loaded { pair, position, load, sliding };
        let tolerance = loaded.tolerance();
        let mut touch = pair.undeformed(position)?;
        let (mut before, mut moved) = (touch.at.segment, f64::INFINITY);
        for _ in 0..ITERATIONS {
            let (state, normal_force) = loaded.at(&touch)?;
            let next = pair.deformed(position, &state)?;
            let (here, there) = (touch.at.segment, next.at.segment);
            if here != there && there == before && pair.edge().has_corners() {
                return corner::about(&loaded, here.min(there));
            }
            before = here;
            moved = place_change(&touch, &next);
            touch = next;
            if moved <= tolerance {
                return Ok(Self { state, normal_force, touch });
            }
        }
        Err(SlidingError::NoConvergence { position, iterations: ITERATIONS, residual: moved })
    }

    /// The equilibrium on the undeformed geometry: linear.
    ///
    /// # Errors
    /// As of [`PairEquilibrium::new`], but that nothing iterates.
    pub fn undeformed(
        pair: &Pair,
        position: f64,
        load: f64,
        sliding: SteadyFriction,
    ) -> Result<Self, SlidingError> {
        let touch = pair.undeformed(position)?;
        let (state, normal_force) = Loaded { pair, position, load, sliding }.at(&touch)?;
        Ok(Self { state, normal_force, touch })
    }
}

/// A pair at a position, under a load, sliding.
#[derive(Clone, Copy)]
struct Loaded<'a> {
    pair: &'a Pair,
    position: f64,
    load: f64,
    sliding: SteadyFriction,
}

impl Loaded<'_> {
    /// How far the contact may still move in the last iteration, m.
    fn tolerance(&self) -> f64 {
        TOLERANCE * self.pair.length()
    }

    /// Modal coordinates and normal force for a given geometry: linear but for the one rigid motion that the contact may hold.
    fn at(&self, touch: &Touch) -> Result<(Vec<f64>, f64), SlidingError> {
        let Self { pair, position, load, sliding } = *self;
        let refuse = |reason| Err(SlidingError::NoEquilibrium { position, reason });
        let coupling = Coupling::new(pair, touch, sliding);
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

/// How far the contact point has moved on the edge, with the normal's turn over a segment, m.
fn place_change(old: &Touch, new: &Touch) -> f64 {
    let along = (new.at.segment as f64 - old.at.segment as f64) + new.at.fraction - old.at.fraction;
    (along.abs() + length(minus(new.normal, old.normal))) * new.stretch
}
