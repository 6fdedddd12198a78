//! Discs that cover a region, and what they say of each other.

use super::disc::{SAME, SearchedDisc};
use super::matching::one_to_one;
use crate::StructureError;
use crate::quadratic::{Quadratic, Region};
use faer::c64;
use judder_memory::HeldMemory;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::parallel;
use judder_numerics::words::{plain, plain_complex};
use std::fmt;

/// Why the eigenvalues of a region may not be all.
#[derive(Debug, Clone, PartialEq)]
pub enum Gap {
    /// A search from one side, for right or for left vectors, found an eigenvalue that the other did not.
    OneSided {
        /// Where.
        value: c64,
    },
    /// A disc lacks an eigenvalue that another found inside it.
    Overlap {
        /// Where.
        value: c64,
        /// The middle of the disc that lacks it.
        shift: c64,
    },
    /// The refinement of an eigenvalue ended at another place.
    Strayed {
        /// Where it was found.
        from: c64,
        /// Where it ended.
        to: c64,
    },
    /// A determinant is not that of the eigenvalues found: some are missing, or there too often.
    Unproved {
        /// How many were found inside the edge around the region.
        found: usize,
        /// Where the determinant was taken.
        place: c64,
    },
    /// A branch of a sweep begins or ends inside the region, beside a point that was solved in a basis.
    Torn {
        /// Where.
        value: c64,
    },
    /// No disc covers a part of the region, or more eigenvalues stand in one place than a search can count.
    Uncovered {
        /// Which part.
        part: Region,
    },
}

impl fmt::Display for Gap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OneSided { value } => {
                write!(f, "{} 1/s was found by its right or its left vector only", plain_complex(*value))
            }
            Self::Overlap { value, shift } => {
                let (value, shift) = (plain_complex(*value), plain_complex(*shift));
                write!(f, "{value} 1/s was not found from the shift {shift} 1/s, whose disc holds it")
            }
            Self::Strayed { from, to } => {
                let (from, to) = (plain_complex(*from), plain_complex(*to));
                write!(f, "what was found at {from} 1/s went to {to} 1/s when it was refined")
            }
            Self::Unproved { found, place } => write!(
                f,
                "the determinant of λ²M + λC + K at {} 1/s is not that of the {found} eigenvalues found: \
                 some may be missing, or too ill-conditioned to count",
                plain_complex(*place)
            ),
            Self::Torn { value } => write!(
                f,
                "the branch at {} 1/s begins or ends inside the region: the basis may lack an eigenvalue here",
                plain_complex(*value)
            ),
            Self::Uncovered { part } => write!(
                f,
                "no disc covers the part {} to {}, {} to {} of the region",
                plain(part.re[0]),
                plain(part.re[1]),
                plain(part.im[0]),
                plain(part.im[1])
            ),
        }
    }
}

/// Discs over a region.
pub(super) struct Cover {
    pub(super) discs: Vec<SearchedDisc>,
    /// Each eigenvalue once: its disc, and its place there.
    pub(super) members: Vec<(usize, usize)>,
    pub(super) gaps: Vec<Gap>,
}

/// A disc asks for so much more than its part needs: the overlap with its neighbours.
const MARGIN: f64 = 1.2;
/// How often a part is halved before it stays uncovered: as often as numbers can tell its ends apart.
const HALVINGS: usize = 48;
/// How many discs are searched before the parts that are left stay uncovered.
const SEARCHES: usize = 1000;
/// Within this share of a disc's radius it must know what others found.
const WELL_INSIDE: f64 = 0.97;

/// Covers a region by discs: by two, and where a search does not reach far enough by as many as it takes.
pub(super) fn cover(
    problem: &Quadratic,
    region: &Region,
    memory: &HeldMemory,
) -> Result<Cover, StructureError> {
    let (mut discs, mut gaps, mut searches) = (Vec::new(), Vec::new(), 0);
    let mut parts = region.halves().to_vec();
    for halving in 0..=HALVINGS {
        let search =
            |part: &Region| SearchedDisc::search(problem, part.centre(), MARGIN * part.radius(), memory);
        let searched: Vec<SearchedDisc> = parallel::try_each(&parts, search)?;
        searches += parts.len();
        let mut smaller = Vec::new();
        for (part, disc) in parts.iter().zip(searched) {
            let aside = (disc.factor.shift() - part.centre()).modulus();
            if disc.radius >= part.radius() + aside && !disc.crowded {
                discs.push(disc);
            } else if halving < HALVINGS && searches < SEARCHES {
                smaller.extend(part.halves());
            } else {
                gaps.push(Gap::Uncovered { part: *part });
                discs.push(disc);
            }
        }
        parts = smaller;
    }
    gaps.extend(
        discs.iter().flat_map(|disc| disc.lonely.iter().map(|value| Gap::OneSided { value: *value })),
    );
    let known: Vec<KnownDisc> = discs.iter().map(KnownDisc::of).collect();
    let (members, overlaps) = once_each(&known);
    gaps.extend(overlaps);
    Ok(Cover { discs, members, gaps })
}

/// What a disc knows.
struct KnownDisc {
    shift: c64,
    radius: f64,
    values: Vec<c64>,
}

impl KnownDisc {
    fn of(disc: &SearchedDisc) -> Self {
        let values = disc.triples.iter().map(|triple| triple.value).collect();
        Self { shift: disc.factor.shift(), radius: disc.radius, values }
    }

    fn holds(&self, value: c64) -> bool {
        (value - self.shift).modulus() <= WELL_INSIDE * self.radius
    }
}

/// Each eigenvalue of overlapping discs once, in the disc that found it first, and what one disc lacks of another.
fn once_each(discs: &[KnownDisc]) -> (Vec<(usize, usize)>, Vec<Gap>) {
    let (mut members, mut values, mut gaps) = (Vec::new(), Vec::<c64>::new(), Vec::new());
    for (number, disc) in discs.iter().enumerate() {
        let farthest = disc.values.iter().map(|value| (value - disc.shift).modulus()).fold(0.0, f64::max);
        let same = one_to_one(&values, &disc.values, SAME * disc.radius.min(farthest));
        let known: Vec<usize> = same.iter().map(|(i, _)| *i).collect();
        let seen: Vec<usize> = same.iter().map(|(_, j)| *j).collect();
        for (_, value) in values.iter().enumerate().filter(|(i, _)| !known.contains(i)) {
            if disc.holds(*value) {
                gaps.push(Gap::Overlap { value: *value, shift: disc.shift });
            }
        }
        for (place, value) in disc.values.iter().enumerate().filter(|(j, _)| !seen.contains(j)) {
            for other in discs[..number].iter().filter(|other| other.holds(*value)) {
                gaps.push(Gap::Overlap { value: *value, shift: other.shift });
            }
            members.push((number, place));
            values.push(*value);
        }
    }
    (members, gaps)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn disc(shift: f64, values: &[f64]) -> KnownDisc {
        let values = values.iter().map(|v| c64::new(0.0, *v)).collect();
        KnownDisc { shift: c64::new(0.0, shift), radius: 10.0, values }
    }

    #[test]
    fn an_eigenvalue_that_two_discs_hold_counts_once() {
        let (members, gaps) =
            once_each(&[disc(0.0, &[-3.0, 4.0, 8.0]), disc(10.0, &[4.0 + 1e-6, 8.0, 15.0])]);
        assert_eq!(members, [(0, 0), (0, 1), (0, 2), (1, 2)]);
        assert!(gaps.is_empty());
    }

    #[test]
    fn a_hidden_eigenvalue_shows_as_a_gap_whichever_disc_lacks_it() {
        let whole = [disc(0.0, &[-3.0, 4.0]), disc(10.0, &[4.0, 15.0])];
        assert!(once_each(&whole).1.is_empty());
        let (_, gaps) = once_each(&[disc(0.0, &[-3.0]), disc(10.0, &[4.0, 15.0])]);
        assert_eq!(gaps, [Gap::Overlap { value: c64::new(0.0, 4.0), shift: c64::new(0.0, 0.0) }]);
        let (members, gaps) = once_each(&[disc(0.0, &[-3.0, 4.0]), disc(10.0, &[15.0])]);
        assert_eq!(gaps, [Gap::Overlap { value: c64::new(0.0, 4.0), shift: c64::new(0.0, 10.0) }]);
        assert_eq!(members.len(), 3);
    }

    #[test]
    fn of_a_double_eigenvalue_both_count() {
        let (members, gaps) = once_each(&[disc(0.0, &[4.0, 4.0]), disc(10.0, &[4.0])]);
        assert_eq!((members.len(), gaps.len()), (2, 1));
    }
}
