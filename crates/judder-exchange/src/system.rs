//! Whether matrices of files make one structure.

use crate::cause::FileCause;
use crate::error::ExchangeError;
use crate::matrix::Matrix;
use judder_structure::freedom::Freedom;

/// A matrix of a file with the name by which messages call it.
#[derive(Debug, Clone, Copy)]
pub struct NamedMatrix<'a> {
    /// Its file, say.
    pub name: &'a str,
    /// The matrix.
    pub matrix: &'a Matrix,
}

/// The files of which the matrices of a structure are sums.
#[derive(Debug, Clone, Default)]
pub struct SystemParts<'a> {
    /// Of M.
    pub mass: Vec<NamedMatrix<'a>>,
    /// Of C.
    pub damping: Vec<NamedMatrix<'a>>,
    /// Of K.
    pub stiffness: Vec<NamedMatrix<'a>>,
}

impl SystemParts<'_> {
    /// The rows of all these matrices.
    ///
    /// # Errors
    /// [`FileCause::Missing`] without mass or stiffness, [`FileCause::NotSquare`], [`FileCause::SizesDiffer`], [`FileCause::NoMass`] where the
    /// masses leave rows empty, [`FileCause::TableDiffers`] where the table of freedoms has other rows.
    pub fn check(&self, freedoms: Option<&[Freedom]>) -> Result<usize, ExchangeError> {
        let first = *self.mass.first().ok_or(FileCause::Missing { what: "mass" })?;
        if self.stiffness.is_empty() {
            return Err(FileCause::Missing { what: "stiffness" }.into());
        }
        for part in self.mass.iter().chain(&self.damping).chain(&self.stiffness) {
            check_size(first, *part)?;
        }
        let rows = first.matrix.rows;
        self.check_mass(rows)?;
        match freedoms {
            Some(table) if table.len() != rows => {
                Err(FileCause::TableDiffers { freedoms: table.len(), rows }.into())
            }
            _ => Ok(rows),
        }
    }

    fn check_mass(&self, rows: usize) -> Result<(), FileCause> {
        let mut has_mass = vec![false; rows];
        for (row, _, value) in self.mass.iter().flat_map(|part| &part.matrix.entries) {
            has_mass[*row] |= *value != 0.0;
        }
        match has_mass.iter().position(|has| !has) {
            Some(first) => {
                let count = has_mass.iter().filter(|has| !**has).count();
                Err(FileCause::NoMass { count, rows, first: first + 1 })
            }
            None => Ok(()),
        }
    }
}

fn check_size(first: NamedMatrix<'_>, part: NamedMatrix<'_>) -> Result<(), FileCause> {
    let (rows, columns) = (part.matrix.rows, part.matrix.columns);
    if rows != columns {
        return Err(FileCause::NotSquare { name: part.name.to_owned(), rows, columns });
    }
    if rows != first.matrix.rows {
        return Err(FileCause::SizesDiffer {
            first: first.name.to_owned(),
            first_rows: first.matrix.rows,
            second: part.name.to_owned(),
            second_rows: rows,
        });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::matrix::Symmetry;
    use judder_structure::freedom::Direction;

    fn diagonal(values: &[f64]) -> Matrix {
        let entries = values.iter().enumerate().map(|(k, value)| (k, k, *value)).collect();
        Matrix { rows: values.len(), columns: values.len(), entries, symmetry: Symmetry::General }
    }

    fn part<'a>(name: &'a str, matrix: &'a Matrix) -> Vec<NamedMatrix<'a>> {
        vec![NamedMatrix { name, matrix }]
    }

    #[test]
    fn matrices_that_fit_pass_and_others_are_named() {
        let (two, three, gap) = (diagonal(&[1.0, 2.0]), diagonal(&[1.0; 3]), diagonal(&[1.0, 0.0]));
        let check = |mass, stiffness, table: Option<&[Freedom]>| {
            let parts = SystemParts { mass, stiffness, damping: part("c.mtx", &two) };
            parts.check(table).map_err(|error| error.to_string())
        };
        assert_eq!(check(part("m.mtx", &two), part("k.mtx", &two), None), Ok(2));
        let message = |result: Result<usize, String>| result.unwrap_err();
        assert!(message(check(vec![], part("k.mtx", &two), None)).contains("no mass matrix"));
        assert!(message(check(part("m.mtx", &two), vec![], None)).contains("no stiffness matrix"));
        let differ = message(check(part("m.mtx", &two), part("k.mtx", &three), None));
        assert!(differ.contains("m.mtx has 2 rows, k.mtx has 3"), "{differ}");
        let oblong = Matrix { columns: 5, ..two.clone() };
        assert!(
            message(check(part("m.mtx", &oblong), part("k.mtx", &two), None))
                .contains("2 rows and 5 columns")
        );
        assert!(
            message(check(part("m.mtx", &gap), part("k.mtx", &two), None)).contains("the first is row 2")
        );
        let one = [Freedom { node: 0, direction: Direction::X, place: [0.0; 3] }];
        assert!(message(check(part("m.mtx", &two), part("k.mtx", &two), Some(&one))).contains("has 1 rows"));
    }
}
