//! `[matrices]`: M, C and K that another program assembled, as sums of files with factors.

use super::file_of_format;
use std::path::{Path, PathBuf};

use super::problem::StructureProblem;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Setting, Several, all, both};
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::expression::Expression;
use judder_keys::file_reference::{FileReference, find_folder, read_file_reference};
use judder_keys::problem::Placed;
use judder_keys::section::{Section, finite_number, list, wrong_type};
use judder_keys::{Choice, Settings};
use serde_json::{Value as Json, json};

/// M, C and K that another program assembled, as sums A = Σ fᵢ Aᵢ of files with factors.
#[derive(Debug, Clone, Settings)]
pub struct MatrixSums {
    /// The folder of the files, relative to the case file.
    #[key(unwritten)]
    folder: Option<String>,
    /// M.
    #[key(rule = TERMS, example = "[{ file = \"M.mtx\" }]")]
    pub mass: Vec<MatrixTerm>,
    /// C; zero by default.
    #[key(rule = TERMS, filled)]
    pub damping: Vec<MatrixTerm>,
    /// K.
    #[key(rule = TERMS, example = "[{ file = \"K.mtx\" }]")]
    pub stiffness: Vec<MatrixTerm>,
    /// A table with node, direction and place of every degree of freedom.
    pub freedoms: Option<FileReference>,
    /// What of a symmetric matrix a file holds whose term does not say.
    #[key(unwritten, default = StoredPart::Both)]
    triangle: StoredPart,
}

/// A matrix times a factor.
#[derive(Debug, Clone, Settings)]
#[settings(title = "a term of `{path}`")]
pub struct MatrixTerm {
    /// A matrix file, .mtx, .mat or .npz, relative to the folder.
    #[key(example = "\"…\", a path relative to the case file")]
    pub file: FileReference,
    /// A number or an expression of the parameters.
    #[key(default = MatrixFactor::constant(1.0))]
    pub factor: MatrixFactor,
    /// What of a symmetric matrix the file holds; what the matrices say where left out.
    pub triangle: Option<StoredPart>,
}

/// What of a matrix its file holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Choice)]
#[choice(what = "triangle")]
pub enum StoredPart {
    /// All of it, or what the file itself says of its symmetry.
    Both,
    /// The lower triangle of a symmetric matrix.
    Lower,
    /// The upper triangle of a symmetric matrix.
    Upper,
    /// All of it, also where one triangle is empty: friction couples some freedoms one way only.
    AsStored,
}

/// A factor: an expression of the parameters, compiled once they are known.
#[derive(Debug, Clone)]
pub struct MatrixFactor {
    /// The expression as the case has it; `1` where it gives none.
    pub text: String,
    expression: Expression,
    /// The parameters that it depends on: position and name.
    parameters: Vec<(usize, String)>,
    /// The file of its matrix, for errors.
    file: String,
}

const TERMS: Several<()> = Several { of: (), length: [1, usize::MAX] };

impl MatrixFactor {
    fn constant(value: f64) -> Self {
        let (text, expression) = (value.to_string(), Expression::constant(value));
        Self { text, expression, parameters: Vec::new(), file: String::new() }
    }

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
pub const MATRIX_ENDINGS: [&str; 3] = [".mtx", ".mat", ".npz"];

impl Setting for MatrixFactor {
    type Rule = ();

    fn form((): &()) -> Allowed {
        Allowed::Expression
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        match &node.data {
            // compiled when the parameters are known
            Data::Text(text) => Ok(Self { text: text.clone(), ..Self::constant(f64::NAN) }),
            Data::Number { .. } => finite_number(&section.path(key), node).map(Self::constant),
            _ => Err(wrong_type(&section.path(key), "a number or an expression in quotes", node)),
        }
    }

    fn write(&self, (): &()) -> Json {
        json!(self.text)
    }
}

impl MatrixSums {
    /// Finds the files, which are relative to `folder`, and compiles the factors, which are expressions of `parameters`.
    pub(crate) fn found(
        mut self,
        section: &Section<'_>,
        parameters: &[String],
        folder: &Path,
    ) -> Result<Self, Fault> {
        let base = self.find_folder(section, folder)?;
        let freedoms = section.get("freedoms").map(|_| read_file_reference(section, "freedoms", &base));
        let freedoms = freedoms.transpose().map(|found| self.freedoms = found);
        let usual = self.triangle;
        let sums =
            [("mass", &mut self.mass), ("damping", &mut self.damping), ("stiffness", &mut self.stiffness)];
        let found = sums.map(|(name, terms)| {
            let Some(node) = section.get(name) else { return Ok(()) };
            let path = section.path(name);
            let nodes = list(&path, node)?;
            if nodes.is_empty() {
                return Err(Cause::EmptyList { key: path }.at(node.place));
            }
            all(terms.iter_mut().zip(nodes).map(|(term, node)| {
                term.triangle.get_or_insert(usual);
                term.find(&Section::of_table(node, &path, "")?, parameters, &base)
            }))
            .map(drop)
        });
        both(all(found), freedoms).map(|_| self)
    }
}

impl MatrixSums {
    /// The folder of the files.
    fn find_folder(&self, section: &Section<'_>, folder: &Path) -> Result<PathBuf, Fault> {
        let (Some(given), Some(node)) = (&self.folder, section.get("folder")) else {
            return Ok(folder.to_owned());
        };
        find_folder(given, node, folder).map_err(|(path, fault)| {
            StructureProblem::Folder { key: section.path("folder"), path, fault }.at(node.place)
        })
    }
}

impl MatrixTerm {
    fn find(&mut self, section: &Section<'_>, parameters: &[String], base: &Path) -> Result<(), Fault> {
        let file = file_of_format(section, "file", base, &MATRIX_ENDINGS);
        let factor = self.factor.compile(section.get("factor"), parameters);
        let (file, ()) = both(file, factor)?;
        self.factor.file.clone_from(&file.given);
        self.file = file;
        Ok(())
    }

    /// What of the matrix its file holds.
    pub fn triangle(&self) -> StoredPart {
        self.triangle.unwrap_or(StoredPart::Both)
    }
}

impl MatrixFactor {
    /// Compiles what stands at `node`, where that is an expression.
    fn compile(&mut self, node: Option<&Node>, parameters: &[String]) -> Result<(), Fault> {
        let Some(node @ Node { data: Data::Text(text), .. }) = node else { return Ok(()) };
        self.expression = Expression::compile(text, parameters).map_err(|(problem, range)| {
            Cause::Expression { problem, parameters: parameters.to_vec() }.at(node.part(range))
        })?;
        let used = parameters.iter().enumerate().filter(|(index, _)| self.expression.depends_on(*index));
        self.parameters = used.map(|(index, name)| (index, name.clone())).collect();
        Ok(())
    }
}
