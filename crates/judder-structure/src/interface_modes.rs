//! Interface modes: the freedoms that a reduction keeps for contacts, reduced themselves.
//!
//! M. P. Castanier, Y.-C. Tan and C. Pierre, *Characteristic constraint modes for component mode synthesis*, AIAA Journal 39 (2001).

use crate::StructureError;
use crate::craig_bampton::CraigBampton;
use faer::Mat;
use judder_dense::product::product;
use judder_dense::symmetric::generalised;

/// A reduced structure whose interface freedoms follow from a few interface modes.
///
/// u_c = X ξ on the interface freedoms c, with K_cc X = M_cc X diag ω² of the reduced structure: how the interface swings while the other
/// kept freedoms and the fixed-interface modes are held, the lowest modes alone. What loads at the interface do beside these modes is
/// left out: unlike that of [`CraigBampton`] the static flexibility is too small.
#[derive(Debug, Clone)]
pub struct InterfaceModes {
    /// M in kg on the coordinates: the kept freedoms that are not of the interface in their order, ξ, the fixed-interface modes.
    pub mass: Mat<f64>,
    /// K in N/m, of the same shape.
    pub stiffness: Mat<f64>,
    /// T, all freedoms by coordinates.
    pub basis: Mat<f64>,
    /// X, interface freedoms in the order in which they were named by modes, in 1/√kg.
    pub shapes: Mat<f64>,
    /// Where ξ begins among the coordinates.
    pub first: usize,
}

impl InterfaceModes {
    /// Reduces interface freedoms, named by their places among the kept ones, to so many modes, or to all that there are.
    ///
    /// # Errors
    /// [`StructureError::KeptTwice`] for a place that is named twice or is not there, [`StructureError::NoModalForm`] where the mass on the
    /// interface is not positive definite.
    pub fn new(reduced: &CraigBampton, interface: &[usize], count: usize) -> Result<Self, StructureError> {
        let kept = reduced.kept;
        let mut is_interface = vec![false; kept];
        for freedom in interface {
            match is_interface.get_mut(*freedom) {
                Some(place @ false) => *place = true,
                _ => return Err(StructureError::KeptTwice { freedom: *freedom, freedoms: kept }),
            }
        }
        let on_interface = |matrix: &Mat<f64>| {
            Mat::from_fn(interface.len(), interface.len(), |i, j| matrix[(interface[i], interface[j])])
        };
        let modes = count.min(interface.len());
        let shapes = match modes {
            0 => Mat::zeros(interface.len(), 0),
            _ => {
                let eigen = generalised(on_interface(&reduced.stiffness), &on_interface(&reduced.mass));
                eigen.ok_or(StructureError::NoModalForm)?.vectors.subcols(0, modes).to_owned()
            }
        };
        let others: Vec<usize> = (0..kept).filter(|freedom| !is_interface[*freedom]).collect();
        let first = others.len();
        let (before, inner) = (reduced.basis.ncols(), reduced.basis.ncols() - kept);
        // how the coordinates of the reduced structure follow from the new ones
        let mut follow = Mat::<f64>::zeros(before, first + modes + inner);
        for (k, freedom) in others.iter().enumerate() {
            follow[(*freedom, k)] = 1.0;
        }
        for (row, freedom) in interface.iter().enumerate() {
            for mode in 0..modes {
                follow[(*freedom, first + mode)] = shapes[(row, mode)];
            }
        }
        for k in 0..inner {
            follow[(kept + k, first + modes + k)] = 1.0;
        }
        Ok(Self {
            mass: symmetrised(&product(
                follow.transpose(),
                product(reduced.mass.as_ref(), follow.as_ref()).as_ref(),
            )),
            stiffness: symmetrised(&product(
                follow.transpose(),
                product(reduced.stiffness.as_ref(), follow.as_ref()).as_ref(),
            )),
            basis: product(reduced.basis.as_ref(), follow.as_ref()),
            shapes,
            first,
        })
    }
}

/// (A + Aᵀ)/2 of what is symmetric but for rounding.
fn symmetrised(a: &Mat<f64>) -> Mat<f64> {
    Mat::from_fn(a.nrows(), a.ncols(), |i, j| 0.5 * (a[(i, j)] + a[(j, i)]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::Sparse;
    use crate::craig_bampton::CutOff;
    use crate::modes::{WantedModes, modes};
    use faer::sparse::Triplet;

    /// Masses 1 to n on springs one after the other, the first to the ground.
    fn chain(masses: usize) -> [Sparse; 2] {
        let matrix = |entries: &[Triplet<usize, usize, f64>]| {
            Sparse::try_new_from_triplets(masses, masses, entries).unwrap()
        };
        let mut stiffness = Vec::new();
        for k in 0..masses {
            stiffness.push(Triplet::new(k, k, 100.0));
            if k > 0 {
                stiffness.push(Triplet::new(k - 1, k - 1, 100.0));
                stiffness.push(Triplet::new(k - 1, k, -100.0));
                stiffness.push(Triplet::new(k, k - 1, -100.0));
            }
        }
        let mass: Vec<_> = (0..masses).map(|k| Triplet::new(k, k, 1.0 + k as f64)).collect();
        [matrix(&stiffness), matrix(&mass)]
    }

    /// ω² of a reduced structure by rising size.
    fn values(reduced: &InterfaceModes) -> Vec<f64> {
        generalised(reduced.stiffness.clone(), &reduced.mass).unwrap().values
    }

    /// With all of its modes nothing is lost; with fewer the frequencies come down to those of the whole (Rayleigh and Ritz).
    #[test]
    fn frequencies_come_down_to_those_of_the_whole() {
        let [stiffness, mass] = chain(12);
        let kept = [2, 5, 6, 7, 8, 11];
        let reduced = CraigBampton::new(&stiffness, &mass, &kept, CutOff::Count(6)).unwrap();
        let whole = modes(&stiffness, &mass, WantedModes::Lowest(3)).unwrap().modes;
        let off = |count: usize| -> Vec<f64> {
            let own = InterfaceModes::new(&reduced, &[1, 2, 3, 4], count).unwrap();
            assert_eq!((own.first, own.mass.nrows()), (2, 2 + count.min(4) + 6));
            let found = values(&own);
            whole.iter().zip(found).map(|(mode, value)| value / mode.eigenvalue - 1.0).collect()
        };
        let [one, two, all] = [1, 2, 9].map(off);
        for mode in 0..3 {
            assert!(all[mode].abs() < 1e-11, "{all:?}");
            assert!(two[mode] < one[mode] && one[mode] > 0.0 && two[mode] > -1e-12, "{one:?} {two:?}");
        }
    }

    /// A displacement of the interface is X ξ, as the basis has it.
    #[test]
    fn the_basis_has_the_shapes_on_the_interface() {
        let [stiffness, mass] = chain(9);
        let reduced = CraigBampton::new(&stiffness, &mass, &[1, 4, 8], CutOff::Count(3)).unwrap();
        let own = InterfaceModes::new(&reduced, &[2, 1], 1).unwrap();
        assert_eq!(
            (own.basis[(8, own.first)], own.basis[(4, own.first)]),
            (own.shapes[(0, 0)], own.shapes[(1, 0)])
        );
        assert_eq!(own.basis[(1, 0)], 1.0);
        let none = InterfaceModes::new(&reduced, &[], 3).unwrap();
        assert_eq!((none.first, none.mass.nrows(), none.shapes.ncols()), (3, 6, 0));
        for twice in [[1, 1], [0, 3]] {
            assert!(matches!(
                InterfaceModes::new(&reduced, &twice, 1),
                Err(StructureError::KeptTwice { .. })
            ));
        }
    }
}
