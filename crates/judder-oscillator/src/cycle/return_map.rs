//! Once around a motion, from the section back to it.

use super::CycleError;
use crate::motion::measures::Measures;
use crate::motion::sliding_system::contact_change;
use crate::motion::{ContactState, SlidingSystem};
use judder_numerics::dense::product;
use judder_numerics::piecewise::tangent::{SquareMatrix, identity, onto_plane, saltation};
use judder_numerics::piecewise::{Advance, PiecewiseMarch, StepSettings};

/// A motion from the section to its return there.
#[derive(Debug, Clone, PartialEq)]
pub struct Return<const N: usize> {
    /// The state at the return.
    pub state: [f64; N],
    /// The time it took.
    pub time: f64,
    /// The derivative of the state after this time by the start, through all events.
    pub monodromy: SquareMatrix<N>,
    /// The derivative of the return by the start: the monodromy seen on the section.
    pub derivative: SquareMatrix<N>,
    /// The contact states in their order; where the last is the first again it is left out.
    pub pattern: Vec<ContactState>,
    /// Averages.
    pub measures: Measures,
}

/// Follows a motion from `start`, moved onto the section, for so many returns to it.
///
/// # Errors
/// The motion cannot be followed, or does not come back within `longest`.
pub fn return_map<const N: usize>(
    system: &impl SlidingSystem<N>,
    start: [f64; N],
    returns: usize,
    settings: StepSettings<N>,
    longest: f64,
) -> Result<Return<N>, CycleError> {
    let section = system.section();
    let centre = system.steady_sliding()[0];
    let mut monodromy = identity();
    let mut measures = Measures::default();
    let mut pattern = vec![system.contact_state(&section.project(&start))];
    let march = fly(system, start, returns, settings, longest, |advance| {
        if let Some(leg) = &advance.leg {
            monodromy = system.along_leg(leg, &monodromy);
            system.measure(leg, centre, &mut measures);
        }
        if let Some(crossing) = advance.crossing.filter(|crossing| crossing.to != crossing.from) {
            monodromy = product(&saltation(system, &crossing), &monodromy);
            if let Some(change) = contact_change(&crossing) {
                pattern.push(change.to);
                measures.changes += 1;
            }
        }
    })?;
    if pattern.len() > 1 && pattern.first() == pattern.last() {
        pattern.pop();
    }
    let field = system.field(march.mode(), &march.state());
    Ok(Return {
        state: march.state(),
        time: march.time(),
        derivative: onto_plane(&section.normal, &field, &monodromy),
        monodromy,
        pattern,
        measures,
    })
}

/// The state of [`return_map`] alone, at a fraction of its cost.
///
/// # Errors
/// As [`return_map`].
pub fn returned_state<const N: usize>(
    system: &impl SlidingSystem<N>,
    start: [f64; N],
    returns: usize,
    settings: StepSettings<N>,
    longest: f64,
) -> Result<[f64; N], CycleError> {
    fly(system, start, returns, settings, longest, |_| ()).map(|march| march.state())
}

/// A motion over so many returns, every advance shown to `watch`.
fn fly<S: SlidingSystem<N>, const N: usize>(
    system: &S,
    start: [f64; N],
    returns: usize,
    settings: StepSettings<N>,
    longest: f64,
    mut watch: impl FnMut(&Advance<S::Mode, N>),
) -> Result<PiecewiseMarch<'_, S, N>, CycleError> {
    let section = system.section();
    let start = section.project(&start);
    let mut march =
        PiecewiseMarch::new(system, system.starting_mode(&start), start, settings)?.with_section(section);
    let mut left = returns;
    while left > 0 {
        if march.time() >= longest {
            return Err(CycleError::NoReturn { time: longest });
        }
        let advance = system.advance(&mut march, longest)?;
        watch(&advance);
        left -= usize::from(advance.on_section);
    }
    Ok(march)
}
