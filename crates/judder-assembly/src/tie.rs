//! Ties: bodies that are bonded to each other.

use crate::AssemblyError;
use crate::assembly::{Assembly, Gyroscopic};
use crate::contact_point::ContactPoint;
use crate::null_basis::NullBasis;
use crate::row::Row;
use faer::c64;
use judder_structure::assembly::Sparse;
use std::sync::Arc;

/// The freedoms that ties leave: q = B z with r B = 0 for every form r that ties hold at zero.
#[derive(Debug, Clone)]
pub struct Bond {
    basis: NullBasis,
}

impl Assembly {
    /// The assembly on the freedoms that ties leave, which hold each of these forms at zero: Bᵀ M B, Bᵀ C B, Bᵀ K B, Bᵀ f and the forms of
    /// the contact points times B. The forces of the bond do no work.
    ///
    /// # Errors
    /// [`AssemblyError::RedundantTie`] for a form that follows from those before it.
    pub fn tied(self, forms: &[Row]) -> Result<(Self, Bond), AssemblyError> {
        let basis =
            NullBasis::new(self.size(), forms, None).map_err(|form| AssemblyError::RedundantTie { form })?;
        let projected = |matrix: &Sparse| NullBasis::projected(&basis, matrix, &basis).map(Arc::new);
        let (mass, damping) = (projected(&self.mass)?, projected(&self.damping)?);
        let stiffness = projected(&self.stiffness)?;
        let load = basis.transposed(&self.load);
        let mut interfaces = self.interfaces;
        let of_body = |own: Gyroscopic| Ok(Gyroscopic { matrix: projected(&own.matrix)?, ..own });
        let gyroscopic = self.gyroscopic.into_iter().map(of_body).collect::<Result<_, AssemblyError>>()?;
        let bond = Bond { basis };
        for point in interfaces.iter_mut().flat_map(|interface| &mut interface.points) {
            bond.bind(point);
        }
        Ok((Self { mass, damping, stiffness, gyroscopic, load, interfaces }, bond))
    }
}

impl Bond {
    /// Takes the forms of a contact point, which are on the freedoms of the bodies, on those that are left.
    pub fn bind(&self, point: &mut ContactPoint) {
        let convected = point.convected.iter_mut();
        let slopes = point.foot.iter_mut().flat_map(|foot| &mut foot.slopes);
        let forms = std::iter::once(&mut point.relative).chain(convected).chain(slopes).flatten();
        forms.for_each(|row| *row = self.basis.form(row));
    }

    /// A form on the freedoms of the bodies on those that are left.
    #[must_use]
    pub fn form(&self, row: &Row) -> Row {
        self.basis.form(row)
    }

    /// Forces on the freedoms of the bodies on those that are left, Bᵀ f.
    #[must_use]
    pub fn forces(&self, forces: &[f64]) -> Vec<f64> {
        self.basis.transposed(forces)
    }

    /// q = B z.
    #[must_use]
    pub fn expanded(&self, z: &[c64]) -> Vec<c64> {
        self.basis.expanded(z)
    }

    /// The freedom of the bodies that a freedom which is left is.
    #[must_use]
    pub fn freedom(&self, left: usize) -> usize {
        self.basis.freedom(left)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::from_triplets;
    use faer::sparse::Triplet;

    /// Two masses on springs of their own, bonded: one mass of both on the sum of the springs.
    #[test]
    fn bonded_masses_are_one() {
        let diagonal = |values: [f64; 2]| {
            let entries = [0, 1].map(|k| Triplet::new(k, k, values[k]));
            from_triplets(2, 2, &entries).unwrap()
        };
        let assembly = Assembly {
            mass: diagonal([1.0, 2.0]).into(),
            damping: diagonal([0.1, 0.2]).into(),
            stiffness: diagonal([30.0, 70.0]).into(),
            gyroscopic: Vec::new(),
            load: vec![5.0, 6.0],
            interfaces: Vec::new(),
        };
        let form = Row::new(vec![(0, 1.0), (1, -1.0)]);
        let (one, bond) = assembly.clone().tied(std::slice::from_ref(&form)).unwrap();
        let entries = [&one.mass, &one.damping, &one.stiffness].map(|matrix| *matrix.get(0, 0).unwrap());
        assert_eq!((entries, one.load.as_slice()), ([3.0, 0.1 + 0.2, 100.0], &[11.0][..]));
        assert_eq!(bond.expanded(&[c64::new(1.0, 0.0)]), [c64::new(1.0, 0.0); 2]);
        let twice = assembly.tied(&[form.clone(), form]);
        assert_eq!(twice.map(drop), Err(AssemblyError::RedundantTie { form: 1 }));
    }
}
