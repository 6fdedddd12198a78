//! Onsets: where along a parameter modes begin or cease to grow.
//!
//! Between two values at which not the same modes grow lies an onset. It is halved until it holds one change alone, then the function
//! that vanishes there is followed to its root: of a mode that loses its damping the growth rate; of two undamped modes that lock in
//! the square of the difference of their eigenvalues, which runs smoothly through zero where the eigenvalues themselves have a
//! branch point; of one that diverges without damping the square of its eigenvalue. Where contact points open or close in between, or
//! pass a corner of their laws, the spectrum may jump, and what is found is a jump. A mode that leaves the region over its edge has no onset there. One that begins and
//! ceases to grow between two values at which stability is known leaves no trace at them, and is not seen.

mod crossing;
mod root;
mod search;

pub use crossing::Crossing;
pub use search::{StabilityOf, onsets_between};

use crate::complex_modes::Eigenvalue;
use std::fmt;

/// What is known of stability at one value.
#[derive(Debug, Clone, PartialEq)]
pub struct StabilityAt {
    /// The eigenvalues of the region, Im λ ≥ 0.
    pub eigenvalues: Vec<Eigenvalue>,
    /// The branch of each, which its vector tells; empty where they are not followed.
    pub branches: Vec<usize>,
    /// Whether it is proven that there are no more.
    pub complete: bool,
    /// On which smooth piece of its law each contact point is, an open one on zero; empty where nothing touches.
    pub pieces: Vec<usize>,
}

/// What happens at an onset.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OnsetKind {
    /// An oscillation begins to grow.
    Flutter,
    /// A motion without oscillation begins to grow.
    Divergence,
}

/// Where modes begin or cease to grow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Onset {
    /// The value of the parameter.
    pub value: f64,
    /// How far the onset may be from it.
    pub error: f64,
    /// The frequency there in Hz; zero of a divergence.
    pub frequency_hz: f64,
    /// What happens.
    pub kind: OnsetKind,
    /// Whether stability is gained with rising values.
    pub gains: bool,
    /// Whether the spectrum jumps there, for contact points open or close, or pass a corner of their laws.
    pub jumps: bool,
    /// The function that vanishes there; `None` where none does.
    pub crossing: Option<Crossing>,
}

/// The onsets between two values.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OnsetsBetween {
    /// By rising value.
    pub onsets: Vec<Onset>,
    /// Why there may be others.
    pub doubts: Vec<OnsetDoubt>,
}

/// Why onsets may be others than those that are told.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OnsetDoubt {
    /// Eigenvalues may be missing at this value, growing ones among them.
    Missing {
        /// The value.
        at: f64,
    },
    /// A growing mode comes so near to one that does not grow that they may change places between these values: an onset and an end
    /// of growth that hide each other.
    Alike {
        /// The lower value.
        from: f64,
        /// The higher value.
        to: f64,
        /// The frequency of the mode in Hz.
        frequency_hz: f64,
    },
}

impl fmt::Display for OnsetDoubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing { at } => write!(f, "eigenvalues may be missing at {at}"),
            Self::Alike { from, to, frequency_hz } => write!(
                f,
                "near {frequency_hz:.6} Hz a mode that grows cannot be told from one that does not between {from} and {to}"
            ),
        }
    }
}

impl OnsetKind {
    /// The word in summaries.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Flutter => "flutter",
            Self::Divergence => "divergence",
        }
    }
}

impl fmt::Display for OnsetKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::StructureError;
    use crate::assembly::Sparse;
    use crate::complex_modes::{ComplexMode, ComplexModeSettings, Region, complex_modes};
    use crate::quadratic::Quadratic;
    use faer::c64;
    use faer::sparse::Triplet;
    use std::f64::consts::TAU;

    fn matrix(rows: [[f64; 2]; 2]) -> Sparse {
        let entries = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(i, j)| Triplet::new(i, j, rows[i][j]));
        Sparse::try_new_from_triplets(2, 2, &entries).unwrap()
    }

    /// M = 1, C = diag(c₁, c₂) and K of the parameter; uncoupled modes are followed by where they swing.
    fn searched(
        damping: impl Fn(f64) -> [f64; 2],
        values: &[f64],
        stiffness: fn(f64) -> [[f64; 2]; 2],
    ) -> OnsetsBetween {
        let is_followed = values.iter().all(|value| stiffness(*value)[0][1] == 0.0);
        let region = Region { re: [-5.0, 5.0], im: [-1e-9, 10.0] };
        let mut at = |value: f64, within: &Region| -> Result<StabilityAt, StructureError> {
            let [a, b] = damping(value);
            let problem = Quadratic::new(
                matrix([[1.0, 0.0], [0.0, 1.0]]),
                matrix([[a, 0.0], [0.0, b]]),
                matrix(stiffness(value)),
            )?;
            let found = complex_modes(&problem, within, &ComplexModeSettings::default())?;
            let eigenvalues = found.modes.iter().map(|mode| mode.eigenvalue).collect();
            let branch = |mode: &ComplexMode| usize::from(mode.right[1].norm() > mode.right[0].norm());
            let branches = if is_followed { found.modes.iter().map(branch).collect() } else { Vec::new() };
            Ok(StabilityAt { eigenvalues, branches, complete: found.complete(), pieces: Vec::new() })
        };
        let known: Vec<_> = values.iter().map(|value| (*value, at(*value, &region).unwrap())).collect();
        let mut all = OnsetsBetween::default();
        for pair in known.windows(2) {
            let OnsetsBetween { onsets, doubts } =
                onsets_between(&pair[0], &pair[1], &region, &mut at).unwrap();
            all.onsets.extend(onsets);
            all.doubts.extend(doubts);
        }
        all
    }

    /// The same with constant damping, beyond doubt.
    fn found(damping: [f64; 2], values: &[f64], stiffness: fn(f64) -> [[f64; 2]; 2]) -> Vec<Onset> {
        let OnsetsBetween { onsets, doubts } = searched(|_| damping, values, stiffness);
        assert!(doubts.is_empty(), "{doubts:?}");
        onsets
    }

    /// Two modes of stiffness 1 and 2 with a skew coupling s meet where s = 1/2.
    #[test]
    fn a_lock_in_without_damping_is_located() {
        let found = found([0.0; 2], &[0.0, 0.3, 0.9], |s| [[1.0, s], [-s, 2.0]]);
        let [onset] = found[..] else { panic!("{found:?}") };
        assert!((onset.value - 0.5).abs() < 1e-9, "{}", onset.value);
        assert!(onset.kind == OnsetKind::Flutter && !onset.gains && !onset.jumps);
        assert!((onset.frequency_hz * TAU - 1.5_f64.sqrt()).abs() < 1e-3);
    }

    /// With dampings c₁ and c₂ Routh and Hurwitz have the Hopf point of (s² + c₁ s + 1)(s² + c₂ s + 2) + S² at
    /// a₁ a₂ a₃ = a₃² + a₁² a₄.
    #[test]
    fn a_hopf_point_is_located() {
        let (c1, c2): (f64, f64) = (0.02, 0.05);
        let found = found([c1, c2], &[0.0, 0.4, 0.8], |s| [[1.0, s], [-s, 2.0]]);
        let [onset] = found[..] else { panic!("{found:?}") };
        let (a1, a2, a3) = (c1 + c2, 3.0 + c1 * c2, 2.0 * c1 + c2);
        let expected = ((a1 * a2 * a3 - a3 * a3) / (a1 * a1) - 2.0).sqrt();
        assert!((onset.value - expected).abs() < 1e-9, "{} {expected}", onset.value);
    }

    /// A stiffness 1 − p becomes negative at p = 1, with damping and without.
    #[test]
    fn a_divergence_is_located_and_one_that_ends_gains() {
        for damping in [[0.0; 2], [0.1, 0.1]] {
            let found = found(damping, &[0.0, 1.7, 4.0], |p| [[(p - 1.0) * (p - 3.0), 0.0], [0.0, 50.0]]);
            let [begins, ends] = found[..] else { panic!("{found:?}") };
            assert!((begins.value - 1.0).abs() < 1e-9 && (ends.value - 3.0).abs() < 1e-9, "{found:?}");
            assert!(begins.kind == OnsetKind::Divergence && !begins.gains && ends.gains);
        }
    }

    /// An unstable mode whose frequency rises over the upper edge of the region.
    #[test]
    fn a_mode_that_leaves_the_region_has_no_onset() {
        let found = found([-0.1, 0.1], &[0.0, 1.0], |p| [[81.0 + 40.0 * p, 0.0], [0.0, 2.0]]);
        assert!(found.is_empty(), "{found:?}");
    }

    /// Of two modes within a part in two hundred of each other one begins to grow and one ceases to: one grows at either end.
    #[test]
    fn an_onset_and_an_end_of_growth_at_like_frequencies_do_not_hide_each_other() {
        for [ends, begins] in [[0.37, 0.61], [0.61, 0.37]] {
            let damping = |p: f64| [0.1 * (p - ends), 0.1 * (begins - p)];
            let OnsetsBetween { onsets, doubts } =
                searched(damping, &[0.0, 1.0], |_| [[25.0, 0.0], [0.0, 25.2]]);
            assert!(doubts.is_empty(), "{doubts:?}");
            let mut values: Vec<f64> = onsets.iter().map(|onset| onset.value).collect();
            values.sort_by(f64::total_cmp);
            assert!((values[0] - 0.37).abs() < 1e-9 && (values[1] - 0.61).abs() < 1e-9, "{onsets:?}");
            assert!(onsets.iter().all(|onset| onset.gains == ((onset.value - ends).abs() < 1e-9)));
        }
    }

    /// Two modes of one frequency change places at one value.
    #[test]
    fn modes_that_cannot_be_told_apart_are_told() {
        let damping = |p: f64| [0.1 * (p - 0.5001), 0.1 * (0.5001 - p)];
        let OnsetsBetween { onsets, doubts } = searched(damping, &[0.0, 1.0], |_| [[25.0, 0.0], [0.0, 25.0]]);
        let told = |doubt: &OnsetDoubt| matches!(doubt, OnsetDoubt::Alike { from, to, .. } if *from < 0.5001 && *to > 0.5001);
        assert!(onsets.is_empty() && doubts.iter().any(told), "{onsets:?} {doubts:?}");
    }

    /// Eigenvalues may be missing at one end.
    #[test]
    fn what_may_be_missing_puts_onsets_in_doubt() {
        let none =
            StabilityAt { eigenvalues: Vec::new(), branches: Vec::new(), complete: true, pieces: Vec::new() };
        let open = StabilityAt { complete: false, ..none.clone() };
        let region = Region { re: [-5.0, 5.0], im: [0.0, 10.0] };
        let found = onsets_between(&(0.0, none), &(1.0, open), &region, &mut |_, _| Err("not asked"));
        assert_eq!(found.unwrap().doubts, [OnsetDoubt::Missing { at: 1.0 }]);
    }

    /// A mode whose frequency doubles while it ceases to grow, alone and among modes that do not: it leaves the part of the region that is
    /// looked at, and comes to where others were.
    #[test]
    fn a_mode_that_moves_far_is_followed_to_its_onset() {
        let rising = |p: f64| [[25.0 * (1.0 + p).powi(2), 0.0], [0.0, 81.0]];
        for values in [&[0.0, 1.0][..], &[0.0, 0.25, 0.5, 0.75, 1.0]] {
            for other in [0.3, 1e-3] {
                let found = searched(|p| [0.2 * (p - 0.57), other], values, rising);
                let [onset] = found.onsets[..] else { panic!("{found:?}") };
                assert!((onset.value - 0.57).abs() < 1e-9 && onset.gains, "{found:?}");
                assert!((onset.frequency_hz * TAU - 5.0 * 1.57).abs() < 1e-3);
            }
        }
    }

    /// The same where a third mode grows throughout and moves by more than those lie apart.
    #[test]
    fn a_growing_mode_beside_them_hides_no_exchange() {
        let region = Region { re: [-5.0, 5.0], im: [-1e-9, 12.0] };
        let mode = |value: c64| Eigenvalue {
            value,
            residual: 0.0,
            left_residual: 0.0,
            condition: 1.0,
            error: 1e-12,
            defective: false,
        };
        let mut at = |p: f64, within: &Region| -> Result<StabilityAt, StructureError> {
            let all = [
                c64::new(0.05 * (0.37 - p), 5.0),
                c64::new(0.05 * (p - 0.61), 5.02),
                c64::new(0.1, 9.0 * (1.0 + 0.1 * p).sqrt()),
            ];
            let inside = (0..3).filter(|k| within.contains(all[*k], 0.0));
            let (eigenvalues, branches) = inside.map(|k| (mode(all[k]), k)).unzip();
            Ok(StabilityAt { eigenvalues, branches, complete: true, pieces: Vec::new() })
        };
        let ends = [0.0, 1.0].map(|value| (value, at(value, &region).unwrap()));
        let found = onsets_between(&ends[0], &ends[1], &region, &mut at).unwrap();
        let values: Vec<f64> = found.onsets.iter().map(|onset| onset.value).collect();
        assert!(found.doubts.is_empty() && values.len() == 2, "{found:?}");
        assert!((values[0] - 0.37).abs() < 1e-9 && (values[1] - 0.61).abs() < 1e-9, "{found:?}");
    }

    /// Eigenvalues of large errors, one of a damped mode that begins to grow at 0.37: that is where its growth rate vanishes, not where it
    /// grows beyond doubt; a few values suffice, and the error is what eigenvalues leave open. So too where an end is in doubt.
    #[test]
    fn an_onset_is_known_as_well_as_its_eigenvalue() {
        const ERROR: f64 = 1e-4;
        let region = Region { re: [-5.0, 5.0], im: [-1e-9, 12.0] };
        let modes = [2.0, 4.95, 5.0, 9.0];
        let mut asked = 0;
        let mut at = |p: f64, within: &Region| -> Result<StabilityAt, StructureError> {
            asked += 1;
            let growth = |k: usize| if k == 2 { 0.05 * (p - 0.37) * (2.0 + p) } else { -0.3 };
            let of = |k: usize| Eigenvalue {
                value: c64::new(growth(k), modes[k]),
                residual: 0.0,
                left_residual: 0.0,
                condition: 1.0,
                error: ERROR,
                defective: false,
            };
            let eigenvalues = (0..4).map(of).filter(|own| within.contains(own.value, 0.0)).collect();
            Ok(StabilityAt { eigenvalues, branches: Vec::new(), complete: true, pieces: Vec::new() })
        };
        let slope = 0.05 * 2.37;
        for ends in [[0.0, 1.0], [0.37 - 0.5 * ERROR / slope, 1.0], [0.37 + 0.5 * ERROR / slope, 1.0]] {
            let known = ends.map(|value| (value, at(value, &region).unwrap()));
            let OnsetsBetween { onsets, doubts } =
                onsets_between(&known[0], &known[1], &region, &mut at).unwrap();
            let [onset] = onsets[..] else { panic!("{onsets:?}") };
            assert!(doubts.is_empty() && (onset.value - 0.37).abs() <= onset.error, "{onset:?}");
            assert!(onset.error < 2.0 * ERROR / slope, "{onset:?}");
            assert_eq!(onset.frequency_hz, modes[2] / TAU);
        }
        assert!(asked <= 6 + 10, "{asked}");
    }
}
