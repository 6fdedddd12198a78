//! Matrices of other programs, read.

use super::{Structure, StructureLayout, Unbuilt};
use crate::structure::case::matrices::{MatrixSums, MatrixTerm, StoredPart};
use crate::structure::case::problem::StructureProblem;
use judder_exchange::freedom_table::read_freedoms;
use judder_exchange::matrix::{Matrix, Triangle, read_matrix, read_stored_matrix};
use judder_exchange::system::{NamedMatrix, SystemParts};
use judder_keys::cause::Cause;
use judder_memory::{HeldMemory, MemoryBudget, TakenMemory};
use judder_numerics::parallel;
use judder_structure::affine::{AffineFamily, Factors, Term};
use judder_structure::freedom::Freedom;
use judder_study::model::PROGRAM_BYTES;

/// Reads the files of all terms and makes sums of them.
pub(super) fn structure(sums: &MatrixSums) -> Result<Structure, Unbuilt> {
    let memory = HeldMemory::of(MemoryBudget::of_process_beside(PROGRAM_BYTES));
    let [mass, damping, stiffness] = sums.sums().map(|(name, terms)| read(name, terms, &memory));
    let ((mass, _of_mass), (damping, _of_damping), (stiffness, _of_stiffness)) =
        (mass?, damping?, stiffness?);
    let read = [mass, damping, stiffness];
    let table = match &sums.freedoms {
        None => None,
        Some(file) => Some(read_freedoms(&file.path).map_err(|error| {
            Unbuilt::new("matrices.freedoms", StructureProblem::File { reason: error.to_string() })
        })?),
    };
    check(sums, &read, table.as_deref())?;
    let [mass, damping, stiffness] = [0, 1, 2].map(|k| {
        let (name, own) = sums.sums()[k];
        terms(name, own, &read[k])
    });
    let family = AffineFamily::new(mass?, damping?, stiffness?)
        .map_err(|error| Unbuilt::because("matrices", &error))?;
    let layout = table.as_deref().map(StructureLayout::of_table);
    Ok(Structure { family, layout, elements: None, kept: Vec::new(), warnings: Vec::new() })
}

/// The factors of all terms where the parameters are `values`.
pub(super) fn factors(sums: &MatrixSums, values: &[f64]) -> Result<Factors, Cause> {
    let of = |terms: &[MatrixTerm]| -> Result<Vec<f64>, Cause> {
        terms.iter().map(|term| term.factor.value(values)).collect()
    };
    Ok(Factors { mass: of(&sums.mass)?, damping: of(&sums.damping)?, stiffness: of(&sums.stiffness)? })
}

/// The matrices of the files of a sum, and what of the memory they and the terms that are made of them hold.
fn read(
    name: &str,
    terms: &[MatrixTerm],
    memory: &HeldMemory,
) -> Result<(Vec<Matrix>, Vec<TakenMemory>), Unbuilt> {
    /// Bytes an entry: as it was read, as a term, and in what the terms make. Measured of two and of 18 diagonals of 2 000 000 entries 80 and 60.
    const ENTRY_BYTES: u64 = 70;
    let read = parallel::try_each_place(terms.len(), |index| {
        let path_of_term = || format!("matrices.{name}.{index}.file");
        let term = &terms[index];
        let path = &term.file.path;
        let mirrored = |triangle| read_stored_matrix(path).and_then(|matrix| matrix.mirrored(triangle));
        let matrix = match term.triangle() {
            StoredPart::Both => read_matrix(path),
            StoredPart::Lower => mirrored(Triangle::Lower),
            StoredPart::Upper => mirrored(Triangle::Upper),
            StoredPart::AsStored => read_stored_matrix(path),
        };
        let matrix = matrix.map_err(|error| {
            let reason = error.to_string();
            Unbuilt::new(path_of_term(), StructureProblem::File { reason })
        })?;
        let held = memory.take(ENTRY_BYTES * matrix.entries.len() as u64);
        let held =
            held.map_err(|source| Unbuilt::new(path_of_term(), StructureProblem::Memory { source }))?;
        Ok((matrix, held))
    });
    Ok(read?.into_iter().unzip())
}

/// Whether the matrices make one structure.
fn check(sums: &MatrixSums, read: &[Vec<Matrix>; 3], table: Option<&[Freedom]>) -> Result<(), Unbuilt> {
    fn parts<'a>(terms: &'a [MatrixTerm], matrices: &'a [Matrix]) -> Vec<NamedMatrix<'a>> {
        let part =
            |(term, matrix): (&'a MatrixTerm, &'a Matrix)| NamedMatrix { name: &term.file.given, matrix };
        terms.iter().zip(matrices).map(part).collect()
    }
    let [mass, damping, stiffness] = read;
    let parts = SystemParts {
        mass: parts(&sums.mass, mass),
        damping: parts(&sums.damping, damping),
        stiffness: parts(&sums.stiffness, stiffness),
    };
    parts.check(table).map(drop).map_err(|error| Unbuilt::because("matrices", &error))
}

/// The terms of a sum, named by their files.
fn terms(name: &str, terms: &[MatrixTerm], matrices: &[Matrix]) -> Result<Vec<Term>, Unbuilt> {
    let term = |(index, (term, matrix)): (usize, (&MatrixTerm, &Matrix))| {
        let failed = |error: &dyn std::fmt::Display| {
            Unbuilt::because(format!("matrices.{name}.{index}.file"), &error.to_string())
        };
        let matrix = matrix.to_sparse().map_err(|error| failed(&error))?;
        Ok(Term { name: term.file.given.clone(), matrix })
    };
    terms.iter().zip(matrices).enumerate().map(term).collect()
}
