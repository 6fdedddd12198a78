//! Matrices that depend on parameters as sums: A = Σ fᵢ Aᵢ, with numbers fᵢ that the parameters set.

use crate::StructureError;
use crate::assembly::Sparse;
use crate::quadratic::{Quadratic, check};
use faer::sparse::SymbolicSparseColMat;

/// One matrix of a sum.
#[derive(Debug, Clone)]
pub struct Term {
    /// What it is called in reports.
    pub name: String,
    /// Aᵢ.
    pub matrix: Sparse,
}

/// Mass, damping and stiffness as sums of matrices with factors.
#[derive(Debug, Clone)]
pub struct AffineFamily {
    mass: Sum,
    damping: Sum,
    stiffness: Sum,
}

/// The factors fᵢ at one value of the parameters, in the order of the terms.
#[derive(Debug, Clone, PartialEq)]
pub struct Factors {
    /// Of the mass.
    pub mass: Vec<f64>,
    /// Of the damping.
    pub damping: Vec<f64>,
    /// Of the stiffness.
    pub stiffness: Vec<f64>,
}

/// Terms on the union of their patterns, so that every sum has the same pattern whatever the factors.
#[derive(Debug, Clone)]
struct Sum {
    terms: Vec<Term>,
    pattern: SymbolicSparseColMat<usize>,
    /// Of each term, where its entries lie in the union.
    places: Vec<Vec<usize>>,
}

impl AffineFamily {
    /// The terms of mass, damping and stiffness; a damping without terms is zero.
    ///
    /// # Errors
    /// [`StructureError::EmptyMatrix`] where mass or stiffness have no terms, [`StructureError::WrongShape`],
    /// [`StructureError::NotFinite`].
    pub fn new(mass: Vec<Term>, damping: Vec<Term>, stiffness: Vec<Term>) -> Result<Self, StructureError> {
        for (name, terms) in [("mass", &mass), ("stiffness", &stiffness)] {
            if terms.is_empty() {
                return Err(StructureError::EmptyMatrix { name: name.to_owned() });
            }
        }
        let rows = mass[0].matrix.nrows();
        for term in mass.iter().chain(&damping).chain(&stiffness) {
            check(&term.name, &term.matrix, rows)?;
        }
        let sum = |terms| Sum::new(terms, rows);
        Ok(Self { mass: sum(mass), damping: sum(damping), stiffness: sum(stiffness) })
    }

    /// Rows of the matrices.
    #[must_use]
    pub fn size(&self) -> usize {
        self.mass.pattern.nrows()
    }

    /// The terms of the mass.
    #[must_use]
    pub fn mass(&self) -> &[Term] {
        &self.mass.terms
    }

    /// The terms of the damping.
    #[must_use]
    pub fn damping(&self) -> &[Term] {
        &self.damping.terms
    }

    /// The terms of the stiffness.
    #[must_use]
    pub fn stiffness(&self) -> &[Term] {
        &self.stiffness.terms
    }

    /// The problem at these factors.
    ///
    /// # Errors
    /// [`StructureError::WrongFactors`] where their number is not that of the terms, [`StructureError::NotFinite`] for a factor
    /// that is no number, [`StructureError::EmptyMatrix`] where they make mass or stiffness zero.
    pub fn at(&self, factors: &Factors) -> Result<Quadratic, StructureError> {
        let [mass, damping, stiffness] = self.matrices(factors)?;
        Quadratic::new(mass, damping, stiffness)
    }

    /// M, C and K at these factors, any of which may be zero.
    ///
    /// # Errors
    /// [`StructureError::WrongFactors`] where their number is not that of the terms.
    pub fn matrices(&self, factors: &Factors) -> Result<[Sparse; 3], StructureError> {
        self.check(factors)?;
        Ok([
            self.mass.at(&factors.mass),
            self.damping.at(&factors.damping),
            self.stiffness.at(&factors.stiffness),
        ])
    }

    /// # Errors
    /// [`StructureError::WrongFactors`].
    pub(crate) fn check(&self, factors: &Factors) -> Result<(), StructureError> {
        let sums = [
            ("mass", &self.mass, &factors.mass),
            ("damping", &self.damping, &factors.damping),
            ("stiffness", &self.stiffness, &factors.stiffness),
        ];
        for (name, sum, factors) in sums {
            if sum.terms.len() != factors.len() {
                return Err(StructureError::WrongFactors {
                    name,
                    found: factors.len(),
                    terms: sum.terms.len(),
                });
            }
        }
        Ok(())
    }
}

impl Sum {
    fn new(terms: Vec<Term>, rows: usize) -> Self {
        let mut start = vec![0];
        let mut union: Vec<usize> = Vec::new();
        for column in 0..rows {
            let first = union.len();
            union.extend(terms.iter().flat_map(|term| term.matrix.row_idx_of_col(column)));
            union[first..].sort_unstable();
            let mut kept = first;
            for k in first..union.len() {
                if kept == first || union[kept - 1] != union[k] {
                    union[kept] = union[k];
                    kept += 1;
                }
            }
            union.truncate(kept);
            start.push(kept);
        }
        let pattern = SymbolicSparseColMat::new_checked(rows, rows, start, None, union);
        let places = terms.iter().map(|term| places(&term.matrix, &pattern)).collect();
        Self { terms, pattern, places }
    }

    fn at(&self, factors: &[f64]) -> Sparse {
        let mut values = vec![0.0; self.pattern.row_idx().len()];
        for ((term, places), factor) in self.terms.iter().zip(&self.places).zip(factors) {
            for (place, value) in places.iter().zip(term.matrix.val()) {
                values[*place] += factor * value;
            }
        }
        Sparse::new(self.pattern.clone(), values)
    }
}

/// Where a matrix's entries lie in a pattern that holds them all.
fn places(matrix: &Sparse, pattern: &SymbolicSparseColMat<usize>) -> Vec<usize> {
    let mut places = Vec::with_capacity(matrix.val().len());
    let mut of_row = vec![0; matrix.nrows()];
    for column in 0..matrix.ncols() {
        let range = pattern.col_range(column);
        for (row, place) in pattern.row_idx_of_col(column).zip(range) {
            of_row[row] = place;
        }
        places.extend(matrix.row_idx_of_col(column).map(|row| of_row[row]));
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::sparse::Triplet;

    fn term(name: &str, entries: &[(usize, usize, f64)]) -> Term {
        let triplets: Vec<_> = entries.iter().map(|(i, j, v)| Triplet::new(*i, *j, *v)).collect();
        Term { name: name.to_owned(), matrix: Sparse::try_new_from_triplets(2, 2, &triplets).unwrap() }
    }

    fn family() -> AffineFamily {
        let mass = vec![term("mass", &[(0, 0, 1.0), (1, 1, 2.0)])];
        let stiffness = vec![term("springs", &[(0, 0, 4.0), (1, 1, 9.0)]), term("friction", &[(0, 1, 1.0)])];
        AffineFamily::new(mass, vec![], stiffness).unwrap()
    }

    #[test]
    fn a_sum_is_the_sum_of_its_terms() {
        let factors = Factors { mass: vec![1.0], damping: vec![], stiffness: vec![2.0, -3.0] };
        let problem = family().at(&factors).unwrap();
        assert_eq!(problem.stiffness().get(0, 0), Some(&8.0));
        assert_eq!(problem.stiffness().get(0, 1), Some(&-3.0));
        assert_eq!(problem.stiffness().get(1, 0), None);
        assert_eq!(problem.damping().val().len(), 0);
    }

    #[test]
    fn factors_that_do_not_fit_are_refused() {
        let short = Factors { mass: vec![1.0], damping: vec![], stiffness: vec![1.0] };
        let said = family().at(&short).unwrap_err().to_string();
        assert!(said.contains("1 factors for the 2 matrices of the stiffness"), "{said}");
        let zero = Factors { mass: vec![0.0], damping: vec![], stiffness: vec![1.0, 1.0] };
        assert!(matches!(family().at(&zero), Err(StructureError::EmptyMatrix { .. })));
    }
}
