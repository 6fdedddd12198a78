//! `[matrices]`: M, C and K that another program assembled, as sums of files with factors.

use std::path::{Path, PathBuf};

use super::problem::StructureProblem;
use judder_keys::cause::Cause;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::expression::Expression;
use judder_keys::file_reference::{FileReference, read_file_reference};
use judder_keys::problem::Placed;
use judder_keys::section::{Section, finite_number, list, text, wrong_type};

/// M, C and K as sums A = Σ fᵢ Aᵢ of files with factors.
#[derive(Debug, Clone)]
pub struct MatrixSums {
    /// The folder of the files as the case has it; empty where it is that of the case.
    pub folder: String,
    /// The terms of M.
    pub mass: Vec<MatrixTerm>,
    /// The terms of C; none where the case gives none.
    pub damping: Vec<MatrixTerm>,
    /// The terms of K.
    pub stiffness: Vec<MatrixTerm>,
    /// Node, direction and place of each degree of freedom, where there is a table of them.
    pub freedoms: Option<FileReference>,
}

/// A term of a sum: a matrix in a file, times a factor.
#[derive(Debug, Clone)]
pub struct MatrixTerm {
    /// The file of the matrix.
    pub file: FileReference,
    /// The factor.
    pub factor: Factor,
    /// What of the matrix the file holds.
    pub triangle: Triangle,
}

/// What of a matrix its file holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Triangle {
    /// All of it, or what the file itself says of its symmetry.
    Both,
    /// The lower triangle of a symmetric matrix.
    Lower,
    /// The upper triangle of a symmetric matrix.
    Upper,
    /// All of it, also where one triangle is empty: friction couples some freedoms one way only.
    AsStored,
}

impl Triangle {
    /// The choices with their names in a case file.
    pub const ALL: [(&'static str, Self); 4] =
        [("both", Self::Both), ("lower", Self::Lower), ("upper", Self::Upper), ("as-stored", Self::AsStored)];

    /// The name in a case file.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].0
    }
}

/// A factor: an expression of the parameters, compiled once.
#[derive(Debug, Clone)]
pub struct Factor {
    /// The expression as the case has it; `1` where it gives none.
    pub text: String,
    expression: Expression,
    /// The parameters that it depends on: position and name.
    parameters: Vec<(usize, String)>,
    /// The file of its matrix, for errors.
    file: String,
}

impl Factor {
    /// The value where the parameters are `values`, in the order of the case.
    ///
    /// # Errors
    /// [`StructureProblem::Factor`] for NaN and infinities.
    pub fn value(&self, values: &[f64]) -> Result<f64, Cause> {
        let value = self.expression.evaluate(values);
        if value.is_finite() {
            return Ok(value);
        }
        let known = |(index, name): &(usize, String)| Some(format!("{name} = {}", values.get(*index)?));
        let point: Vec<_> = self.parameters.iter().filter_map(known).collect();
        let (file, point) = (self.file.clone(), point.join(", "));
        Err(StructureProblem::Factor { file, value, point }.into())
    }

    /// Whether it depends on the parameter at `index`.
    pub fn depends_on(&self, index: usize) -> bool {
        self.parameters.iter().any(|(used, _)| *used == index)
    }
}

impl MatrixSums {
    /// M, C and K with their names.
    pub fn sums(&self) -> [(&'static str, &[MatrixTerm]); 3] {
        [("mass", &self.mass), ("damping", &self.damping), ("stiffness", &self.stiffness)]
    }

    /// All files.
    pub(crate) fn files(&self) -> Vec<&FileReference> {
        let terms = self.mass.iter().chain(&self.damping).chain(&self.stiffness);
        terms.map(|term| &term.file).chain(&self.freedoms).collect()
    }

    /// Refuses factors that are not finite where the parameters are `values`.
    pub(crate) fn check(&self, values: &[f64]) -> Result<(), Cause> {
        self.sums()
            .iter()
            .flat_map(|(_, terms)| *terms)
            .try_for_each(|term| term.factor.value(values).map(drop))
    }
}

/// The endings of matrix files that are read.
pub const MATRIX_ENDINGS: &str = ".mtx, .mat, .npz";

/// The keys of matrices.
pub(crate) const KEYS: [&str; 6] = ["folder", "mass", "damping", "stiffness", "freedoms", "triangle"];

/// Reads the matrices that `section` describes, whose factors are expressions of `parameters`.
pub(crate) fn read_matrices(
    section: &Section<'_>,
    parameters: &[String],
    folder: &Path,
) -> Result<MatrixSums, Fault> {
    let (given, base) = read_folder(section, folder)?;
    let usual = section.choice("triangle", "triangle", &Triangle::ALL)?.unwrap_or(Triangle::Both);
    let scope = Scope { parameters, base: &base, usual };
    section.required("mass", "mass = [{ file = \"M.mtx\" }]")?;
    section.required("stiffness", "stiffness = [{ file = \"K.mtx\" }]")?;
    let freedoms = section.get("freedoms").map(|_| read_file_reference(section, "freedoms", &base));
    Ok(MatrixSums {
        folder: given,
        mass: read_sum(section, "mass", &scope)?,
        damping: read_sum(section, "damping", &scope)?,
        stiffness: read_sum(section, "stiffness", &scope)?,
        freedoms: freedoms.transpose()?,
    })
}

/// What the terms need to know.
struct Scope<'a> {
    parameters: &'a [String],
    base: &'a Path,
    usual: Triangle,
}

/// The folder of the files, as given and as found; one of a `--set` option is sought where the program runs first, as whoever types
/// it there means it.
fn read_folder(section: &Section<'_>, folder: &Path) -> Result<(String, PathBuf), Fault> {
    let Some(node) = section.get("folder") else { return Ok((String::new(), folder.to_owned())) };
    let key = section.path("folder");
    let given = text(&key, node)?;
    let here = PathBuf::from(given);
    let path = if node.place.is_option() && here.is_dir() { here } else { folder.join(given) };
    let what = match std::fs::metadata(&path) {
        Ok(metadata) if metadata.is_dir() => return Ok((given.to_owned(), path)),
        Ok(_) => "is not a folder",
        Err(_) => "does not exist",
    };
    Err(StructureProblem::Folder { key, path, what }.at(node.place))
}

fn read_sum(section: &Section<'_>, name: &str, scope: &Scope<'_>) -> Result<Vec<MatrixTerm>, Fault> {
    let Some(node) = section.get(name) else { return Ok(Vec::new()) };
    let path = section.path(name);
    let nodes = list(&path, node)?;
    if nodes.is_empty() {
        return Err(Cause::EmptyList { key: path }.at(node.place));
    }
    nodes.iter().map(|node| read_term(&path, node, scope)).collect()
}

fn read_term(path: &str, node: &Node, scope: &Scope<'_>) -> Result<MatrixTerm, Fault> {
    let term = Section::open(node, path, &format!("a term of `{path}`"), &["file", "factor", "triangle"])?;
    let file = read_file_reference(&term, "file", scope.base)?;
    let ending = file.path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    if !["mtx", "mat", "npz"].contains(&ending.to_ascii_lowercase().as_str()) {
        let place = term.get("file").map_or(term.place, |node| node.place);
        let (key, known) = (term.path("file"), MATRIX_ENDINGS);
        return Err(StructureProblem::Format { key, path: file.path, known }.at(place));
    }
    let factor = read_factor(&term, &file.given, scope.parameters)?;
    let triangle = term.choice("triangle", "triangle", &Triangle::ALL)?.unwrap_or(scope.usual);
    Ok(MatrixTerm { file, factor, triangle })
}

fn read_factor(term: &Section<'_>, file: &str, parameters: &[String]) -> Result<Factor, Fault> {
    let constant = |value: f64| Factor {
        text: value.to_string(),
        expression: Expression::constant(value),
        parameters: Vec::new(),
        file: file.to_owned(),
    };
    let Some(node) = term.get("factor") else { return Ok(constant(1.0)) };
    let key = term.path("factor");
    let text = match &node.data {
        Data::Text(text) => text,
        Data::Number { .. } => return finite_number(&key, node).map(constant),
        _ => return Err(wrong_type(&key, "a number or an expression in quotes", node)),
    };
    let expression = Expression::compile(text, parameters).map_err(|(problem, range)| {
        Cause::Expression { problem, parameters: parameters.to_vec() }.at(node.part(range))
    })?;
    let used = parameters.iter().enumerate().filter(|(index, _)| expression.depends_on(*index));
    let used = used.map(|(index, name)| (index, name.clone())).collect();
    Ok(Factor { text: text.clone(), expression, parameters: used, file: file.to_owned() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stand_at_their_index() {
        assert!(Triangle::ALL.iter().all(|(name, triangle)| triangle.name() == *name));
    }
}
