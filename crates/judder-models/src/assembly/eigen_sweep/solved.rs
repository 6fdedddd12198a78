//! The eigenvalues of a sweep, and where modes begin or cease to grow.

use crate::assembly::swept::{SlidingState, SweptAssembly};
use crate::error::ModelError;
use crate::structure::eigen_sweep::kept_points::KeptPoints;
use crate::structure::eigen_sweep::onsets::LocatedOnsets;
use judder_numerics::parallel;
use judder_structure::complex_modes::Region;
use judder_structure::eigen_sweep::{PreparedSweep, SolvedPoint, SweepMethod, SweptEigenvalues, followed};
use judder_structure::onset::StabilityAt;
use judder_study::{Progress, StudyError};

/// Eigenvalues at all values, followed, and where modes begin or cease to grow.
pub(in crate::assembly) struct SolvedSweep {
    /// Steady sliding at each value, or why there is none.
    pub(in crate::assembly) states: Vec<Result<SlidingState, String>>,
    pub(in crate::assembly) sweep: SweptEigenvalues,
    pub(in crate::assembly) onsets: LocatedOnsets,
}

impl SolvedSweep {
    pub(in crate::assembly) fn new(
        family: &SweptAssembly<'_>,
        values: &[f64],
        method: SweepMethod,
        region: &Region,
        (kept, progress): (&KeptPoints<'_>, &dyn Progress),
    ) -> Result<Self, ModelError> {
        let states = parallel::try_each(values, |value| {
            progress.go_on()?;
            Ok::<_, StudyError>(family.state(&[*value]).map_err(|error| error.to_string()))
        })?;
        let groups = HeldGroup::of_states(&states);
        let prepared = groups
            .iter()
            .map(|group| {
                PreparedSweep::new(family, group.points(&states), region, family.searching.clone(), method)
            })
            .collect::<Result<Vec<_>, _>>()?;
        // who runs analyses takes the last step of each
        (1..values.len()).filter(|number| kept.has(*number)).for_each(|_| progress.advance());
        let solve = |number: usize| {
            progress.go_on()?;
            if number > 0 && !kept.has(number) {
                progress.advance();
            }
            let Ok(state) = &states[number] else { return Ok(SolvedPoint::unsolved()) };
            let (group, place) = HeldGroup::place(&groups, number);
            let solved = prepared[group].point(place)?;
            if groups.len() == 1 { Ok(solved) } else { family.expanded(state, solved) }
        };
        let sweep = followed(0..values.len(), region, &solve, kept)?;
        let known: Vec<Option<StabilityAt>> = states
            .iter()
            .zip(&sweep.points)
            .map(|(state, point)| Some(point.stability(state.as_ref().ok()?.pieces.clone())))
            .collect();
        let onsets = LocatedOnsets::new(values, &known, region, &|value, within| {
            progress.go_on()?;
            let state = family.state(&[value])?;
            let solved = match groups.iter().position(|group| group.held == state.held) {
                Some(group) => prepared[group].within(&state, within)?,
                None => family.solved_alone(&state, within)?,
            };
            Ok(solved.stability(state.pieces))
        })?;
        drop(prepared);
        Ok(Self { states, sweep, onsets })
    }

    /// Whether some point is open at some value.
    pub(in crate::assembly) fn has_open_points(&self) -> bool {
        self.states.iter().flatten().any(|state| state.closed_points() < state.steady.points.len())
    }
}

/// Values at which the same points are held: those of a finite stiffness may open and close within it.
struct HeldGroup {
    held: Vec<bool>,
    numbers: Vec<usize>,
}

impl HeldGroup {
    fn of_states(states: &[Result<SlidingState, String>]) -> Vec<Self> {
        let mut groups: Vec<Self> = Vec::new();
        for (number, state) in states.iter().enumerate() {
            let Ok(state) = state else { continue };
            match groups.iter_mut().find(|group| group.held == state.held) {
                Some(group) => group.numbers.push(number),
                None => groups.push(Self { held: state.held.clone(), numbers: vec![number] }),
            }
        }
        groups
    }

    fn points<'s>(&self, states: &'s [Result<SlidingState, String>]) -> Vec<&'s SlidingState> {
        self.numbers.iter().filter_map(|number| states[*number].as_ref().ok()).collect()
    }

    /// The group of a value, and its place in that.
    fn place(groups: &[Self], number: usize) -> (usize, usize) {
        let places = groups.iter().enumerate();
        let mut found =
            places.filter_map(|(k, group)| Some((k, group.numbers.iter().position(|own| *own == number)?)));
        found.next().unwrap_or_default()
    }
}
