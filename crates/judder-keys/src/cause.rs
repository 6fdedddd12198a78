//! Every way in which a case can be wrong, one variant a cause, with what would be right.

use std::path::PathBuf;

use thiserror::Error;

use crate::dimension::Dimension;
use crate::expression::ExpressionError;
use crate::file_reference::PathFault;
use crate::problem::words::Problem;
use crate::quantity::{CELSIUS_ZERO, QuantityError, WrittenNumber};
use crate::range::Range;

/// What is wrong with a case. The fields are what a caller needs in order to act.
#[derive(Debug, Error)]
pub enum Cause {
    /// The case file does not exist.
    #[error("there is no file `{}`", path.display())]
    Missing {
        /// The path as given.
        path: PathBuf,
    },
    /// The path is a folder.
    #[error("`{}` is a folder, not a case file", path.display())]
    Folder {
        /// The path as given.
        path: PathBuf,
    },
    /// The path is a device, a pipe or a socket, whose end may never come.
    #[error("`{}` is a device, pipe or socket, not a case file", path.display())]
    NotAFile {
        /// The path as given.
        path: PathBuf,
    },
    /// The file is larger than any case file.
    #[error("`{}` has {size} bytes, but a case file has at most {limit} ({} MiB)", path.display(), limit >> 20)]
    TooLong {
        /// The path as given.
        path: PathBuf,
        /// The size of the file, bytes.
        size: u64,
        /// The limit, bytes.
        limit: u64,
    },
    /// The file could not be read.
    #[error("cannot read `{}`", path.display())]
    Unreadable {
        /// The path as given.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// The file is not UTF-8 text.
    #[error("`{name}` is not a text file: the byte at offset {offset} is not UTF-8")]
    Binary {
        /// The name of the file.
        name: String,
        /// The offset of the first byte that is not text.
        offset: usize,
    },
    /// The file holds nothing but blanks and comments.
    #[error("`{name}` is empty")]
    Empty {
        /// The name of the file.
        name: String,
    },
    /// The text is not TOML.
    #[error("this is not TOML: {message}")]
    Syntax {
        /// What the TOML parser says.
        message: String,
    },
    /// A `--set` option without `key=value`.
    #[error("`--set {option}` is not of the form key=value")]
    OverrideForm {
        /// The option as given.
        option: String,
    },
    /// A key that a section does not have.
    #[error("unknown key `{key}` in {section}")]
    UnknownKey {
        /// The key as written.
        key: String,
        /// The section as an error names it.
        section: String,
        /// The keys that the section has.
        known: Vec<String>,
    },
    /// A key that must be there.
    #[error("{section} lacks the key `{key}`")]
    MissingKey {
        /// The key that is missing.
        key: String,
        /// The section as an error names it.
        section: String,
        /// What the value would be.
        expected: String,
    },
    /// A value of the wrong type.
    #[error("`{key}` is {found}, but must be {expected}")]
    WrongType {
        /// The key.
        key: String,
        /// What the value must be.
        expected: String,
        /// What it is.
        found: &'static str,
    },
    /// A word that is not among the known ones: a model, a law, a kind, a swept key.
    #[error("unknown {what} `{name}`")]
    UnknownName {
        /// What the word should name.
        what: &'static str,
        /// The word as written.
        name: String,
        /// The words that are known.
        known: Vec<String>,
    },
    /// A parameter that is varied, and that stands in no expression of the case.
    #[error("nothing in the case follows `{path}`")]
    UnusedParameter {
        /// The dotted path.
        path: String,
    },
    /// An analysis of another model.
    #[error("the analysis kind `{name}` belongs to another model")]
    OtherModel {
        /// The kind as written.
        name: String,
        /// The kinds of this model.
        known: Vec<String>,
    },
    /// A text that is not a quantity.
    #[error("`{key}` is not {dimension}: {problem}")]
    Quantity {
        /// The key.
        key: String,
        /// What is expected.
        dimension: Dimension,
        /// Why the text is not a quantity.
        problem: QuantityError,
    },
    /// A unit of the wrong dimension.
    #[error("`{key}` must be {expected}, but this is {found}")]
    WrongDimension {
        /// The key.
        key: String,
        /// The dimension of the key.
        expected: Dimension,
        /// The dimension that was given.
        found: Dimension,
        /// The symbol of the group that a plain number would be, where there is one.
        group: Option<&'static str>,
    },
    /// Ends of a range in different dimensions: which of them is wrong the range does not say.
    #[error("`{first}` is {of_first}, but `{second}` is {of_second}")]
    MixedDimensions {
        /// The key of the first end.
        first: String,
        /// Its dimension.
        of_first: Dimension,
        /// The key of the second end.
        second: String,
        /// Its dimension.
        of_second: Dimension,
    },
    /// A plain number where only a quantity with a unit has a meaning.
    #[error("`{key}` needs a unit: it has no dimensionless form")]
    NeedsUnit {
        /// The key.
        key: String,
        /// The dimension of the key.
        dimension: Dimension,
    },
    /// NaN, an infinity, or a number beyond the range of `f64`.
    #[error("`{key}` is not a finite number")]
    NotFinite {
        /// The key.
        key: String,
    },
    /// A number outside the range of its key.
    #[error("`{key}` must be {}, but is {number}", allowed(*range, number))]
    OutOfRange {
        /// The key.
        key: String,
        /// The number as written.
        number: WrittenNumber,
        /// What is allowed.
        range: Range,
    },
    /// Two keys that say the same thing.
    #[error("`{second}` together with `{first}`: both say the same thing")]
    Conflict {
        /// The key that comes first.
        first: String,
        /// The key that contradicts it.
        second: String,
    },
    /// A key of the case that is not numeric and so cannot be swept.
    #[error("`{key}` is not numeric, so it cannot be swept")]
    NotNumeric {
        /// The key.
        key: String,
        /// The keys that can be swept.
        known: Vec<String>,
    },
    /// A sweep that begins where it ends.
    #[error("the range is empty: from and to are both {from}")]
    EmptyRange {
        /// Both ends.
        from: WrittenNumber,
    },
    /// A range in which roots are sought that runs backwards.
    #[error("the range runs backwards: from {from} to {to}")]
    Backwards {
        /// The first end.
        from: WrittenNumber,
        /// The second end.
        to: WrittenNumber,
    },
    /// A transient that leaves no time to average over.
    #[error("the transient of {transient:?} leaves nothing of the duration of {duration:?}")]
    NothingMeasured {
        /// The transient, in the form of the case.
        transient: f64,
        /// The duration, in the form of the case.
        duration: f64,
    },
    /// A sweep of fewer than two points.
    #[error("a sweep has at least 2 points, not {points}")]
    TooFewPoints {
        /// The number of points asked for.
        points: i64,
    },
    /// A logarithmic range that touches or passes zero.
    #[error("a logarithmic range cannot touch or pass zero: {from} to {to}")]
    LogThroughZero {
        /// The first end.
        from: WrittenNumber,
        /// The second end.
        to: WrittenNumber,
    },
    /// A plain number beside a quantity with a unit.
    #[error("{keys} mix plain numbers with units")]
    MixedForms {
        /// The keys, each in backquotes.
        keys: String,
    },
    /// One key that an analysis varies twice, or both sweeps and seeks.
    #[error("`{key}` stands for both the {first} and the {second} of this analysis")]
    KeyTwice {
        /// The key.
        key: String,
        /// Its first part.
        first: &'static str,
        /// Its second part.
        second: &'static str,
    },
    /// More points than the memory limit allows.
    #[error("{shape} points need {} of memory", gibibytes(*bytes))]
    TooLarge {
        /// The number, with its factors where there are several: `40000 × 25000 = 1000000000`.
        shape: String,
        /// The number of points.
        points: u128,
        /// The memory they would need, bytes.
        bytes: u128,
        /// The limit, bytes.
        limit: u128,
        /// The most points that it allows.
        most: u128,
    },
    /// A list that must not be empty.
    #[error("`{key}` is an empty list")]
    EmptyList {
        /// The key.
        key: String,
    },
    /// An analysis name that does not serve as a file name.
    #[error("`{name}` cannot name an analysis")]
    BadName {
        /// The name as written.
        name: String,
    },
    /// Two analyses of one name.
    #[error("there are two analyses named `{name}`")]
    DuplicateName {
        /// The name; names that differ only in case count as one.
        name: String,
    },
    /// A parameter name that an expression could not use.
    #[error("`{name}` cannot name a parameter")]
    ParameterName {
        /// The name as written.
        name: String,
    },
    /// A matrix that is not two rows of two entries.
    #[error("`{key}` must be two rows of two entries")]
    MatrixShape {
        /// The key of the matrix.
        key: String,
    },
    /// An expression that cannot be read.
    #[error("{problem}")]
    Expression {
        /// What is wrong with it.
        problem: ExpressionError,
        /// The names of the parameters.
        parameters: Vec<String>,
    },
    /// An expression that gives NaN or an infinity at the point asked for.
    #[error("{matrix}[{row}][{column}] is {value}{}{point}", if point.is_empty() { "" } else { ", at " })]
    NotFiniteEntry {
        /// `mass`, `damping` or `stiffness`.
        matrix: &'static str,
        /// Row, 0 or 1.
        row: usize,
        /// Column, 0 or 1.
        column: usize,
        /// What the expression gave.
        value: f64,
        /// The parameters that the entry depends on, as in `mu = 0.5`; empty where there are none.
        point: String,
    },
    /// An expression in the place of a number that gives NaN or an infinity.
    #[error("`{key}` is {value}{}{point}", if point.is_empty() { "" } else { ", at " })]
    NotFiniteExpression {
        /// The key.
        key: String,
        /// What the expression gave.
        value: f64,
        /// The parameters that it depends on, as in `mu = 0.5`; empty where there are none.
        point: String,
    },
    /// An expression in the place of a quantity, as a text without its unit.
    #[error("`{key}` is an expression without a unit")]
    ExpressionWithoutUnit {
        /// The key.
        key: String,
        /// The expression.
        text: String,
        /// What the quantity is.
        dimension: Dimension,
        /// What a number without a unit is there; nothing where none may stand.
        group: Option<&'static str>,
    },
    /// A file that the case names and that is not to be had.
    #[error("`{key}` names `{}`, which {fault}", path.display())]
    File {
        /// The key.
        key: String,
        /// Where the file was looked for.
        path: PathBuf,
        /// Why not.
        fault: PathFault,
    },
    /// Two keys of which one decides the other.
    #[error("`{first}` and `{second}` cannot both be given: one follows from the other")]
    OneOfTwo {
        /// The first key.
        first: String,
        /// The second key.
        second: String,
    },
    /// A number of things outside its limits.
    #[error("`{key}` must be a whole number from {from} to {to}, but is {found}")]
    Count {
        /// The key.
        key: String,
        /// The smallest.
        from: usize,
        /// The largest.
        to: usize,
        /// What was given.
        found: i64,
    },
    /// Degrees Celsius where a difference of temperatures is meant.
    #[error("`{key}` is a difference of temperatures, but degrees Celsius have their own zero")]
    Difference {
        /// The key.
        key: String,
        /// A difference as it should be written.
        example: String,
    },
    /// A key that another choice of its analysis leaves without meaning.
    #[error("`{key}` has no meaning with {with}")]
    Meaningless {
        /// The key.
        key: &'static str,
        /// The other choice, as the case writes it.
        with: String,
    },
    /// A text that is not an amount of memory, or too little.
    #[error("`{key}` is not an amount of memory of 1 MiB at least")]
    NotMemory {
        /// The key.
        key: String,
    },
    /// A list of another length.
    #[error("`{key}` has {found} entries, but must have {expected}")]
    Length {
        /// The key.
        key: String,
        /// What it must have.
        expected: &'static str,
        /// What it has.
        found: usize,
    },
    /// What a part of the case says of itself.
    #[error("{0}")]
    Problem(Box<dyn Problem>),
    /// No template of this name.
    #[error("there is no template `{name}`")]
    UnknownTemplate {
        /// The name asked for.
        name: String,
        /// The templates there are.
        known: Vec<String>,
    },
}

/// What a number may be, in words that go with how it was written: the zero of degrees Celsius is not that of the range.
fn allowed(range: Range, number: &WrittenNumber) -> String {
    match range {
        Range::Positive if number.is_celsius() => format!("above absolute zero, {} °C", -CELSIUS_ZERO),
        _ => range.to_string(),
    }
}

/// Bytes in the unit in which memory limits are told.
pub fn gibibytes(bytes: u128) -> String {
    format!("{:.1} GiB", bytes as f64 / f64::from(1 << 30))
}
