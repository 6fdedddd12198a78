//! Whether motions nearby are drawn to the cycles of a margin's branch: of a few of them, spread over it.

use crate::assembly::cycles_along_key::CyclesAlongKey;
use crate::assembly::limit_cycle::stability::KnownStability;
use crate::error::ModelError;
use judder_cycles::balance::HarmonicBalance;
use judder_cycles::branch::{AssemblyCycleBranch, CycleAtKey};
use judder_numerics::parallel;

/// The most cycles that are looked at on either side of an onset: multipliers of all would take longer than the branch.
pub(super) const LOOKED_AT: usize = 2;

/// What is known of cycles of a branch.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct StabilityOnBranch {
    /// In the order along the branch; none where it was not asked for.
    pub(super) cycles: Vec<CycleOnBranch>,
}

/// A cycle of the branch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CycleOnBranch {
    pub(super) value: f64,
    /// Whether it lies where steady sliding is stable.
    pub(super) is_beyond: bool,
    pub(super) stable: Option<bool>,
}

impl StabilityOnBranch {
    /// That of a branch within a range of the key; `beyond` is how far a value lies on the side of an onset on which steady sliding is stable.
    pub(super) fn of(
        along: &CyclesAlongKey<'_>,
        balance: &HarmonicBalance<'_>,
        branch: &AssemblyCycleBranch,
        [from, to]: [f64; 2],
        beyond: impl Fn(f64) -> f64 + Sync,
    ) -> Result<Self, ModelError> {
        let inside = || branch.cycles.iter().filter(|own| (from..=to).contains(&own.parameter));
        let sides = [true, false].map(|is_beyond| {
            let own: Vec<&CycleAtKey> =
                inside().filter(|own| (beyond(own.parameter) > 0.0) == is_beyond).collect();
            spread(own.len()).map(|place| own[place]).collect::<Vec<_>>()
        });
        let chosen: Vec<&CycleAtKey> =
            inside().filter(|own| sides.iter().flatten().any(|other| std::ptr::eq(*own, *other))).collect();
        let known = |cycle: &&CycleAtKey| -> Result<CycleOnBranch, ModelError> {
            let assembly = along.assembly(cycle.parameter)?;
            let stability = KnownStability::of(&balance.of(&assembly)?, &cycle.motion, true, along.progress)?;
            let (value, is_beyond) = (cycle.parameter, beyond(cycle.parameter) > 0.0);
            Ok(CycleOnBranch { value, is_beyond, stable: stability.is_stable() })
        };
        Ok(Self { cycles: parallel::try_each(&chosen, known)? })
    }

    /// Those where steady sliding is stable.
    pub(super) fn beyond(&self) -> impl Iterator<Item = &CycleOnBranch> {
        self.cycles.iter().filter(|own| own.is_beyond)
    }

    /// Whether all that were looked at beyond the onset are left by motions nearby.
    pub(super) fn is_left_beyond(&self) -> bool {
        self.beyond().count() > 0 && self.beyond().all(|own| own.stable == Some(false))
    }

    /// In words.
    pub(super) fn words(&self) -> String {
        let sides = [(true, "beyond the onset"), (false, "where the mode grows")];
        let of = |(is_beyond, place): (bool, &str)| {
            let own = || self.cycles.iter().filter(|own| own.is_beyond == is_beyond);
            let count = |stable: Option<bool>| own().filter(|own| own.stable == stable).count();
            (own().count() > 0).then(|| {
                let [stable, unstable, unknown] = [Some(true), Some(false), None].map(count);
                format!("{place} {stable} stable, {unstable} unstable, {unknown} unknown")
            })
        };
        let told: Vec<String> = sides.into_iter().filter_map(of).collect();
        if told.is_empty() { "unknown: of no cycle was it looked at".to_owned() } else { told.join("; ") }
    }
}

/// The places of a few of so many, spread over them and away from their ends.
fn spread(count: usize) -> impl Iterator<Item = usize> {
    let few = count.min(LOOKED_AT);
    (0..few).map(move |k| (2 * k + 1) * count / (2 * few))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_are_spread_and_all_of_few_are_taken() {
        let places = |count: usize| spread(count).collect::<Vec<_>>();
        assert_eq!(places(0), [0; 0]);
        assert_eq!(places(2), [0, 1]);
        assert_eq!(places(40), [10, 30]);
    }

    #[test]
    fn words_count_each_side() {
        let cycle =
            |value: f64, stable: Option<bool>| CycleOnBranch { value, is_beyond: value > 0.0, stable };
        let own = StabilityOnBranch {
            cycles: vec![cycle(1.0, Some(false)), cycle(2.0, None), cycle(-1.0, Some(true))],
        };
        assert_eq!(
            own.words(),
            "beyond the onset 0 stable, 1 unstable, 1 unknown; where the mode grows 1 stable, 0 unstable, 0 unknown"
        );
        assert!(!own.is_left_beyond());
        assert!(StabilityOnBranch { cycles: vec![cycle(1.0, Some(false))] }.is_left_beyond());
        let none = StabilityOnBranch::default();
        assert!(!none.is_left_beyond() && none.words() == "unknown: of no cycle was it looked at");
    }
}
