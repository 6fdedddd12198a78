//! How much of a complex mode a motion has.

use crate::march::March;
use faer::c64;
use judder_assembly::assembly::triplets;
use judder_assembly::linearised::Linearised;
use judder_structure::assembly::Sparse;

/// The amplitude of a mode in a deviation from steady sliding: a = yᴴ ((λ M + C) q + M q̇)/(yᴴ (2 λ M + C) x), with all damping, that of the
/// contacts too.
///
/// Of a motion a e^{λt} x it is a e^{λt}, and zero of every other mode; what belongs to closed rigid points drops out with y.
#[derive(Debug, Clone)]
pub struct ModeShare {
    /// Of the displacements, real and imaginary part, on the coordinates of a march.
    on_displacement: [Vec<f64>; 2],
    on_velocity: [Vec<f64>; 2],
    /// What steady sliding has of it.
    steady: c64,
}

impl ModeShare {
    /// That of a mode with the eigenvalue λ and these vectors on all freedoms about a steady state, in a march.
    #[must_use]
    pub fn new(
        march: &March<'_>,
        about: &Linearised,
        value: c64,
        [right, left]: [&[c64]; 2],
        steady: &[f64],
    ) -> Self {
        let [mass, damping, _] = &about.structures;
        let by_mass = transposed(mass, left);
        let mut by_damping = transposed(damping, left);
        let of_contacts = about.contacts.iter().filter(|own| !own.term.is_stiffness());
        let others = about.gyroscopic.iter().map(AsRef::as_ref).chain(of_contacts.map(|own| &own.matrix));
        for matrix in others {
            by_damping.iter_mut().zip(transposed(matrix, left)).for_each(|(sum, own)| *sum += own);
        }
        let pairs = || by_mass.iter().zip(&by_damping);
        let scale: c64 = pairs().zip(right).map(|((m, c), x)| (2.0 * value * m + c) * x).sum();
        let displacement: Vec<c64> = pairs().map(|(m, c)| (value * m + c) / scale).collect();
        let velocity: Vec<c64> = by_mass.iter().map(|m| m / scale).collect();
        let steady = displacement.iter().zip(steady).map(|(own, q)| own * *q).sum();
        let parts = |values: &[c64]| {
            [|value: &c64| value.re, |value: &c64| value.im]
                .map(|part| march.functional(&values.iter().map(part).collect::<Vec<_>>()))
        };
        Self { on_displacement: parts(&displacement), on_velocity: parts(&velocity), steady }
    }

    /// The amplitude at the beginning of the last step of the march.
    #[must_use]
    pub fn of(&self, march: &March<'_>) -> c64 {
        let part = |k: usize| march.middle(&self.on_displacement[k], &self.on_velocity[k]);
        c64::new(part(0), part(1)) - self.steady
    }
}

/// yᴴ A.
fn transposed(matrix: &Sparse, left: &[c64]) -> Vec<c64> {
    let mut sums = vec![c64::ZERO; matrix.ncols()];
    triplets(matrix).for_each(|entry| sums[entry.col] += left[entry.row].conj() * entry.val);
    sums
}
