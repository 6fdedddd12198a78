//! Why heights are not read.

use crate::npy::NpyError;
use judder_numerics::words::plain;
use thiserror::Error;

/// Why the heights of a file cannot be had.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum HeightsError {
    /// The ending of the file's name says nothing about its form.
    #[error(
        "the ending {ending:?} says nothing about the form of the heights; they are read from .npy, from text matrices (.txt, .csv, \
         .tsv, .dat, .asc) and from NetCDF (.nc, .nc4, .cdf)"
    )]
    UnknownEnding {
        /// What follows the last point of the name, in small letters; empty where it has none.
        ending: String,
    },
    /// The file has no bytes.
    #[error("the file is empty; a matrix of heights is needed")]
    Empty,
    /// A `.npy` file that is damaged, or none.
    #[error("the .npy file {source}; {remedy}")]
    Npy {
        /// What is wrong.
        source: NpyError,
        /// What would be right.
        remedy: &'static str,
    },
    /// Numbers of a `.npy` file that are not floating-point ones of four or eight bytes.
    #[error(
        "the .npy file holds numbers of type {found}, and only f4 and f8 are read; save it as array.astype('f8')"
    )]
    NpyNumbers {
        /// Their type, as NumPy writes it.
        found: String,
    },
    /// An array that is no matrix.
    #[error(
        "the .npy file holds an array of shape {}; a matrix of shape (rows, columns) is needed",
        tuple(shape)
    )]
    NpyShape {
        /// Its shape.
        shape: Vec<usize>,
    },
    /// A number of a text matrix cannot be read.
    #[error(
        "line {line}, entry {entry} of the text matrix is {text:?}, not a finite number with a decimal point; mend it, or fill the \
         gap first"
    )]
    NotANumber {
        /// Line of the file, from 1.
        line: usize,
        /// Entry of the line, from 1.
        entry: usize,
        /// What stands there.
        text: String,
    },
    /// An entry of a text matrix is empty.
    #[error("line {line}, entry {entry} of the text matrix is empty; every height must be given")]
    MissingEntry {
        /// Line of the file, from 1.
        line: usize,
        /// Entry of the line, from 1.
        entry: usize,
    },
    /// Rows of different lengths.
    #[error(
        "line {line} of the text matrix has {found} entries, the lines above have {expected}; all rows must be equally long"
    )]
    RaggedRow {
        /// Line of the file, from 1.
        line: usize,
        /// Entries in this line.
        found: usize,
        /// Entries in the lines above.
        expected: usize,
    },
    /// Commas that may separate or be decimal.
    #[error(
        "line {line} of the text matrix has both commas and {other}, and the comma may be decimal; write decimal points"
    )]
    AmbiguousComma {
        /// Line of the file, from 1.
        line: usize,
        /// The other separator.
        other: &'static str,
    },
    /// The text is not UTF-8.
    #[error(
        "the text matrix is not UTF-8 text: the byte at offset {byte} is none; save numbers as plain text, or as .npy"
    )]
    NotText {
        /// Position of the first such byte.
        byte: usize,
    },
    /// The NetCDF reader fails.
    #[error(
        "the file cannot be read as NetCDF: {reason}; if it is such a file, `nccopy -k classic in.nc out.nc` writes a plain copy"
    )]
    NetCdf {
        /// What the reader says.
        reason: String,
    },
    /// No variable of a NetCDF file has two dimensions.
    #[error(
        "no variable of the NetCDF file has two dimensions, as heights over y and x do; it holds {}",
        listed(variables)
    )]
    NoMatrix {
        /// The variables that there are.
        variables: Vec<String>,
    },
    /// Several variables of a NetCDF file have two dimensions.
    #[error(
        "several variables of the NetCDF file could be the heights; set `variable` to one of {}",
        listed(variables)
    )]
    SeveralMatrices {
        /// The candidates.
        variables: Vec<String>,
    },
    /// The named variable does not exist or is not a matrix.
    #[error(
        "the NetCDF file has no variable {name:?} with two dimensions; set `variable` to one of {}",
        listed(variables)
    )]
    NoSuchVariable {
        /// The name asked for.
        name: String,
        /// The variables with two dimensions.
        variables: Vec<String>,
    },
    /// A variable was named for a file that holds one array without a name.
    #[error("`variable` is {name:?}, but the file holds one array without a name; leave `variable` out")]
    VariableWithoutNames {
        /// The name asked for.
        name: String,
    },
    /// Coordinates that do not rise or fall by equal steps.
    #[error(
        "the coordinate {name:?} has no equal steps: the first is {first}, step {step} is {other}; interpolate the heights to \
         equal steps first"
    )]
    UnequalSteps {
        /// The coordinate.
        name: String,
        /// The first step.
        first: f64,
        /// The step that differs most.
        other: f64,
        /// Where that is, from 1.
        step: usize,
    },
    /// Steps along x and y differ.
    #[error(
        "the steps of the coordinates along x ({x}) and y ({y}) differ; interpolate the heights to square cells first"
    )]
    NotSquare {
        /// Step along x.
        x: f64,
        /// Step along y.
        y: f64,
    },
    /// Heights and coordinates in different units.
    #[error(
        "the heights are in {heights:?}, the coordinate {coordinate:?} is in {coordinates:?}; \
         bring them to one unit, or leave the coordinates out and give `spacing`"
    )]
    UnitsDiffer {
        /// Unit of the heights.
        heights: String,
        /// The coordinate.
        coordinate: String,
        /// Its unit.
        coordinates: String,
    },
    /// The length of the file's unit is none.
    #[error("the length unit of the heights is {value}: it must be a positive number")]
    Unit {
        /// The length \[m\].
        value: f64,
    },
    /// The file's coordinates contradict the spacing that is given.
    #[error(
        "the coordinates of the file have steps of {in_file} m, `spacing` is {given} m; leave `spacing` out, or mend `unit`",
        in_file = plain(*.in_file), given = plain(*.given),
    )]
    SpacingDisagrees {
        /// From the file \[m\].
        in_file: f64,
        /// As given \[m\].
        given: f64,
    },
    /// Neither the file nor the caller says the spacing.
    #[error("the file has no coordinates; give `spacing`, the distance of neighbouring heights")]
    SpacingMissing,
}

fn listed(names: &[String]) -> String {
    if names.is_empty() {
        return String::from("none");
    }
    let quoted: Vec<String> = names.iter().map(|name| format!("{name:?}")).collect();
    quoted.join(", ")
}

/// A shape as Python writes it.
fn tuple(shape: &[usize]) -> String {
    match shape {
        [length] => format!("({length},)"),
        _ => format!("({})", shape.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")),
    }
}
