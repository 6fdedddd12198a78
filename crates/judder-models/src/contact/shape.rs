//! The shape of the indenter of a contact case.

use std::path::Path;

use crate::contact::problem::ContactProblem;
use judder_contact::indenter::Roughness;
use judder_keys::Settings;
use judder_keys::cause::Cause;
use judder_keys::declared::{
    Allowed, Declaration, Number, Setting, Settings, UNLIMITED, Whole, both, declared_table,
};
use judder_keys::dimension::Dimension;
use judder_keys::document::{Data, Node};
use judder_keys::error::Fault;
use judder_keys::file_reference::{FileReference, read_file_reference};
use judder_keys::numeric_key::Range;
use judder_keys::problem::Placed;
use judder_keys::section::{Section, word};
use serde_json::{Value as Json, json};

/// The shape of the indenter.
#[derive(Debug, Clone, PartialEq)]
pub enum ShapeSettings {
    /// h = r²/2R.
    Paraboloid,
    /// h = R − √(R² − r²).
    Sphere,
    /// h = x²/2R, infinitely long across the sliding direction: a line contact.
    Cylinder,
    /// Heights from a file.
    Heights(HeightFile),
    /// A generated self-affine surface, periodic.
    Rough(GeneratedSurface),
}

/// A height map; lengths in m.
#[derive(Debug, Clone, PartialEq, Settings)]
pub struct HeightFile {
    /// The file: npy, a text matrix or NetCDF; a path relative to the case file.
    #[key(
        name = "heights",
        example = "\"file.npy\", or rough = { … }, or shape = \"paraboloid\", \"sphere\" or \"cylinder\""
    )]
    pub file: FileReference,
    /// Distance of neighbouring heights; may be left out where the file has coordinates.
    #[key(rule = LENGTH, symbol = "h")]
    pub spacing: Option<f64>,
    /// The variable of a file that holds several.
    pub variable: Option<String>,
    /// The length that a height of 1 in the file stands for.
    #[key(rule = LENGTH, default = 1.0)]
    pub unit: f64,
    /// Whether the surface repeats itself at its edges.
    #[key(default = false)]
    pub periodic: bool,
    /// Whether large heights point towards the substrate, as in a measured topography, so that its peaks touch first.
    #[key(default = false)]
    pub turned_over: bool,
}

/// A generated self-affine surface; lengths in m.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = GeneratedSurface::complete)]
pub struct GeneratedSurface {
    /// Side of the periodic square.
    #[key(rule = LENGTH, symbol = "L", example = "\"1 mm\"")]
    pub period: f64,
    /// Cells along a side.
    #[key(rule = Whole { from: ROUGH_CELLS[0], to: ROUGH_CELLS[1] }, example = "256, along a side")]
    pub cells: usize,
    /// The Hurst exponent of the self-affine part.
    #[key(rule = HURST, symbol = "H", example = "0.8")]
    pub hurst: f64,
    /// Longest wave of the self-affine part; the period where left out.
    #[key(rule = LENGTH, symbol = "λ_r")]
    roll_off: Option<f64>,
    /// Shortest wave; four cells where left out.
    #[key(rule = LENGTH, symbol = "λ_s")]
    cut_off: Option<f64>,
    /// Root mean square of the heights; or give `rms_slope`.
    #[key(rule = LENGTH, symbol = "h_rms", omitted)]
    rms_height: Option<f64>,
    /// Root mean square of the slope, in place of that of the heights.
    #[key(rule = Number::positive(Dimension::NUMBER), symbol = "g_rms", omitted)]
    rms_slope: Option<f64>,
    /// The seed of its phases.
    #[key(rule = Whole { from: 0, to: UNLIMITED }, default = 0)]
    pub seed: usize,
}

const LENGTH: Number = Number::positive(Dimension::LENGTH);
const HURST: Number =
    Number { dimension: Dimension::NUMBER, range: Range::Interval { above: 0.0, up_to: 1.0 } };

/// The cells along a side that a rough surface may have.
const ROUGH_CELLS: [usize; 2] = [8, 4096];

impl ShapeSettings {
    /// The shapes that are words.
    pub const WORDS: [(&'static str, Self); 3] =
        [("paraboloid", Self::Paraboloid), ("sphere", Self::Sphere), ("cylinder", Self::Cylinder)];

    /// Whether the surface repeats itself at its edges.
    pub fn is_periodic(&self) -> bool {
        matches!(self, Self::Rough(_) | Self::Heights(HeightFile { periodic: true, .. }))
    }

    /// The name of the shape in messages and results.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Paraboloid => "paraboloid",
            Self::Sphere => "sphere",
            Self::Cylinder => "cylinder",
            Self::Heights(_) => "heights",
            Self::Rough(_) => "rough",
        }
    }

    /// Finds its file, which is relative to a folder.
    pub(crate) fn found(mut self, indenter: &Section<'_>, folder: &Path) -> Result<Self, Fault> {
        if let (Self::Heights(heights), Some(node)) = (&mut self, indenter.get("shape")) {
            let section = Section::of_table(node, "indenter.shape", "`indenter.shape`")?;
            heights.file = read_file_reference(&section, "heights", folder)?;
        }
        Ok(self)
    }
}

/// A paraboloid where it is left out.
impl Setting for ShapeSettings {
    type Rule = ();
    const IS_OPTIONAL: bool = true;

    fn absent() -> Option<Self> {
        Some(Self::Paraboloid)
    }

    fn form((): &()) -> Allowed {
        let words = Self::WORDS.map(|(word, _)| word);
        let rough: Declaration = SurfaceSettings::declarations().remove(0);
        let schema = json!({
            "anyOf": [
                { "enum": words, "default": words[0], "description": "shape of the indenter" },
                declared_table("a height map", &HeightFile::declarations()),
                declared_table("a rough surface", std::slice::from_ref(&rough)),
            ],
            "default": words[0],
        });
        let words = words.map(|word| format!("`\"{word}\"`")).join(", ");
        let keys = HeightFile::declarations().into_iter().chain([rough]).collect();
        Allowed::Told { schema, words: format!("{words}, or a table with `heights` or `rough`"), keys }
    }

    fn read(section: &Section<'_>, key: &str, node: &Node, (): &()) -> Result<Self, Fault> {
        let path = section.path(key);
        if matches!(node.data, Data::Text(_)) {
            let index = word(&path, "shape", node, &[0, 1, 2].map(|index| (Self::WORDS[index].0, index)))?;
            return Ok(Self::WORDS[index].1.clone());
        }
        let table = Section::of_table(node, &path, &format!("`{path}`"))?;
        match (table.get("heights"), table.get("rough")) {
            (Some(_), Some(node)) => {
                let (first, second) = (table.path("heights"), table.path("rough"));
                Err(Cause::OneOfTwo { first, second }.at(node.place))
            }
            (None, Some(_)) => {
                SurfaceSettings::read(section, key, node, &()).map(|surface| Self::Rough(surface.rough))
            }
            _ => HeightFile::read(section, key, node, &()).map(Self::Heights),
        }
    }

    fn write(&self, (): &()) -> Json {
        match self {
            Self::Heights(heights) => Setting::write(heights, &()),
            Self::Rough(rough) => json!({ "rough": Setting::write(rough, &()) }),
            word => json!(word.name()),
        }
    }
}

/// The table of a generated surface.
#[derive(Debug, Clone, PartialEq, Settings)]
struct SurfaceSettings {
    /// A generated self-affine surface.
    rough: GeneratedSurface,
}

impl GeneratedSurface {
    /// Fills in the waves that are left out, and refuses those that do not descend, and two measures or none.
    fn complete(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        (self.roll_off, self.cut_off) = (Some(self.roll_off()), Some(self.cut_off()));
        let finest = 2.0 * self.period / self.cells as f64;
        let (period, roll_off, cut_off) = (self.period, self.roll_off(), self.cut_off());
        let wrong = [
            ("period", period, "roll_off", roll_off, period < roll_off),
            ("roll_off", roll_off, "cut_off", cut_off, roll_off <= cut_off),
            ("cut_off", cut_off, "two cells", finest, cut_off < finest),
        ];
        let waves = match wrong.into_iter().find(|(.., is_wrong)| *is_wrong) {
            Some((longer, from, shorter, to, _)) => {
                let problem = ContactProblem::WaveLengths { longer, from, shorter, to };
                Err(problem.at(section.place))
            }
            None => Ok(()),
        };
        let measure = match (self.rms_height, self.rms_slope) {
            (Some(_), Some(_)) => {
                let (first, second) = (section.path("rms_height"), section.path("rms_slope"));
                let problem = Cause::OneOfTwo { first, second };
                Err(problem.at(section.place))
            }
            (None, None) => Err(section.missing("rms_height", "rms_height = \"1 um\", or rms_slope = 0.1")),
            _ => Ok(()),
        };
        both(waves, measure).map(drop)
    }

    /// Longest wave of the self-affine part.
    pub fn roll_off(&self) -> f64 {
        self.roll_off.unwrap_or(self.period)
    }

    /// Shortest wave.
    pub fn cut_off(&self) -> f64 {
        self.cut_off.unwrap_or(4.0 * self.period / self.cells as f64)
    }

    /// How high or steep it is.
    pub fn roughness(&self) -> Roughness {
        match (self.rms_height, self.rms_slope) {
            (Some(height), _) => Roughness::Height(height),
            (None, slope) => Roughness::Slope(slope.unwrap_or_default()),
        }
    }
}
