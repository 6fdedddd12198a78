//! The shape of the indenter of a contact case.

use std::path::Path;

use crate::cause::Cause;
use crate::contact_keys::ContactKey;
use crate::contact_problem::ContactProblem;
use crate::document::{Data, Node};
use crate::error::Fault;
use crate::file_reference::{FileReference, read_file_reference};
use crate::section::Section;
use crate::swept_keys::read_value;

/// The shape of the indenter.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// h = r²/2R.
    Paraboloid,
    /// h = R − √(R² − r²).
    Sphere,
    /// h = x²/2R, infinitely long across the sliding direction: a line contact.
    Cylinder,
    /// Heights from a file.
    Heights(HeightFile),
    /// A generated self-affine surface, periodic.
    Rough(RoughSurface),
}

/// Heights from a file; lengths in m.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightFile {
    /// The file: npy, a text matrix, or NetCDF.
    pub file: FileReference,
    /// Distance of neighbouring heights; `None` where the file's coordinates say it.
    pub spacing: Option<f64>,
    /// The variable of a file that holds several.
    pub variable: Option<String>,
    /// The length that a height of 1 stands for.
    pub unit: f64,
    /// Whether the surface repeats itself at its edges.
    pub periodic: bool,
    /// Whether large heights point towards the substrate, as in a measured topography, so that its peaks touch first.
    pub turned_over: bool,
}

/// A generated self-affine rough surface; lengths in m.
#[derive(Debug, Clone, PartialEq)]
pub struct RoughSurface {
    /// Side of the periodic square.
    pub period: f64,
    /// Cells along a side.
    pub cells: usize,
    /// Hurst exponent.
    pub hurst: f64,
    /// Longest wave of the self-affine part.
    pub roll_off: f64,
    /// Shortest wave.
    pub cut_off: f64,
    /// How high or steep it is.
    pub roughness: Roughness,
    /// The seed of its phases.
    pub seed: u64,
}

/// The measure to which a rough surface is scaled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Roughness {
    /// Root mean square of the heights, m.
    Height(f64),
    /// Root mean square of the slope.
    Slope(f64),
}

impl Shape {
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
}

/// The cells along a side that a rough surface may have.
pub(crate) const ROUGH_CELLS: [usize; 2] = [8, 4096];

/// Reads `shape` of `[indenter]`; a paraboloid where it is left out.
pub(crate) fn read_shape(indenter: &Section<'_>, folder: &Path) -> Result<Shape, Fault> {
    let Some(node) = indenter.get("shape") else { return Ok(Shape::Paraboloid) };
    if matches!(node.data, Data::Text(_)) {
        let words: [(&str, usize); 3] = [0, 1, 2].map(|index| (Shape::WORDS[index].0, index));
        let index = indenter.choice("shape", "shape", &words)?.unwrap_or(0);
        return Ok(Shape::WORDS[index].1.clone());
    }
    let has = |key: &str| matches!(&node.data, Data::Table(table) if table.get(key).is_some());
    let mut known = Vec::new();
    if has("heights") || !has("rough") {
        known.extend(["heights", "spacing", "variable", "unit", "periodic", "turned_over"]);
    }
    if has("rough") {
        known.push("rough");
    }
    let section = Section::open(node, "indenter.shape", "`indenter.shape`", &known)?;
    match (section.get("heights"), section.get("rough")) {
        (Some(_), Some(node)) => {
            let (first, second) = (section.path("heights"), section.path("rough"));
            Err(Cause::Contact { problem: ContactProblem::OneOfTwo { first, second } }.at(node.place))
        }
        (None, Some(node)) => read_rough(node).map(Shape::Rough),
        (_, None) => read_heights(&section, folder).map(Shape::Heights),
    }
}

fn read_heights(section: &Section<'_>, folder: &Path) -> Result<HeightFile, Fault> {
    let expected =
        "heights = \"file.npy\", or rough = { … }, or shape = \"paraboloid\", \"sphere\" or \"cylinder\"";
    section.required("heights", expected)?;
    let length = |key: ContactKey| {
        let entry = key.entry();
        section.get(entry.name()).map(|node| read_value(entry, entry.path, node)).transpose()
    };
    let unit = length(ContactKey::HeightUnit)?.map_or(1.0, |value| value.number);
    Ok(HeightFile {
        file: read_file_reference(section, "heights", folder)?,
        spacing: length(ContactKey::Spacing)?.map(|value| value.number),
        variable: section.text("variable")?.map(str::to_owned),
        unit,
        periodic: section.boolean("periodic")?.unwrap_or(false),
        turned_over: section.boolean("turned_over")?.unwrap_or(false),
    })
}

fn read_rough(node: &Node) -> Result<RoughSurface, Fault> {
    let known = ["period", "cells", "hurst", "roll_off", "cut_off", "rms_height", "rms_slope", "seed"];
    let section = Section::open(node, "indenter.shape.rough", "`indenter.shape.rough`", &known)?;
    let optional = |key: ContactKey| {
        let entry = key.entry();
        let value = section.get(entry.name()).map(|node| read_value(entry, entry.path, node)).transpose()?;
        Ok::<_, Fault>(value.map(|value| value.number))
    };
    let required = |key: ContactKey, example: &str| {
        section.required(key.entry().name(), &format!("{} = {example}", key.entry().name()))?;
        Ok::<_, Fault>(optional(key)?.unwrap_or_default())
    };
    let period = required(ContactKey::Period, "\"1 mm\"")?;
    section.required("cells", "cells = 256, along a side")?;
    let [fewest, most] = ROUGH_CELLS;
    let cells = section.whole("cells", fewest, most)?.unwrap_or(fewest);
    let hurst = required(ContactKey::Hurst, "0.8")?;
    let roll_off = optional(ContactKey::RollOff)?.unwrap_or(period);
    let cut_off = optional(ContactKey::CutOff)?.unwrap_or(4.0 * period / cells as f64);
    for (longer, from, shorter, to, fine) in [
        ("period", period, "roll_off", roll_off, period >= roll_off),
        ("roll_off", roll_off, "cut_off", cut_off, roll_off > cut_off),
        (
            "cut_off",
            cut_off,
            "two cells",
            2.0 * period / cells as f64,
            cut_off >= 2.0 * period / cells as f64,
        ),
    ] {
        if !fine {
            let problem = ContactProblem::WaveLengths { longer, from, shorter, to };
            return Err(Cause::Contact { problem }.at(node.place));
        }
    }
    let roughness = match (optional(ContactKey::RmsHeight)?, optional(ContactKey::RmsSlope)?) {
        (Some(height), None) => Roughness::Height(height),
        (None, Some(slope)) => Roughness::Slope(slope),
        (None, None) => {
            section.required("rms_height", "rms_height = \"1 um\", or rms_slope = 0.1")?;
            Roughness::Height(0.0)
        }
        (Some(_), Some(_)) => {
            let (first, second) = (section.path("rms_height"), section.path("rms_slope"));
            return Err(Cause::Contact { problem: ContactProblem::OneOfTwo { first, second } }.at(node.place));
        }
    };
    let seed = section.whole("seed", 0, usize::MAX)?.unwrap_or(0) as u64;
    Ok(RoughSurface { period, cells, hurst, roll_off, cut_off, roughness, seed })
}
