//! Figs. 3, 13 and 14 and the table of coefficients, from what is stored.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use super::computed_for;
use super::evidence::{CORRECTED, r_squared};
use super::exhibits::{FIT, LAW, MODULUS};
use crate::drawn::{StoredAnalysis, block};
use judder_contact::law::PerQuantity;
use judder_contact::{ContactLaw, FittedLaw, LawPoint};
use judder_report::figure::ValueMap;
use judder_report::page::PageTable;
use judder_report::palette::ColourMap;
use judder_report::{Axis, Figure, Layer, Legend, PageBlock, PageSection, Panel, Role};
use judder_store::{StudyFolder, Summary};
use judder_study::StudyError;
use judder_study::labels::short_number;
use judder_study::pictures::{StoredArrays, axis, picked, reals};
use serde_json::Value;

/// Rows of equal indentation that Fig. 3 draws as curves: one a decade.
const ROWS: usize = 4;
/// Fig. 14 draws so many points along each axis at most.
const DRAWN: usize = 14;

/// A quantity of the contact, in the order of Fig. 3, with its label and its colour scale.
struct ContactQuantity {
    name: &'static str,
    label: &'static str,
    pick: fn(PerQuantity<f64>) -> f64,
    is_logarithmic: bool,
}

const QUANTITIES: [ContactQuantity; 3] = [
    ContactQuantity {
        name: "friction",
        label: "Friction $μ_{visc}$ (−)",
        pick: |values| values.friction,
        is_logarithmic: false,
    },
    ContactQuantity {
        name: "area",
        label: "Contact area $Ã$ (−)",
        pick: |values| values.area,
        is_logarithmic: true,
    },
    ContactQuantity {
        name: "force",
        label: "Contact force $F̃_{k}$ (−)",
        pick: |values| values.force,
        is_logarithmic: true,
    },
];

impl ContactQuantity {
    fn axis(&self) -> Axis {
        if self.is_logarithmic { Axis::log(self.label) } else { Axis::linear(self.label) }
    }
}

/// The sections of the contact computation; none where it has no result.
pub(super) fn sections(store: &StudyFolder, summary: &Summary) -> Result<Vec<PageSection>, StudyError> {
    let mut sections = Vec::new();
    let stored = |name: &str| StoredAnalysis::read(store, summary, name);
    if let Some((law, fit)) = stored(LAW).zip(stored(FIT)) {
        let functions = Functions::of(summary);
        let curves =
            |arrays: &[StoredArrays<'_>]| figure_3(arrays.first()?, &functions, computed_for(summary));
        let mut blocks = block(store, "fig-3", &[&fit], curves)?;
        blocks.extend(block(store, "fig-3-maps", &[&law], |arrays| figure_3_maps(arrays.first()?))?);
        sections.push(PageSection::new("Fig. 3", blocks));
        let scatter = |arrays: &[StoredArrays<'_>]| figure_14(arrays.first()?, &functions);
        let mut blocks = block(store, "fig-14", &[&fit], scatter)?;
        blocks.extend(coefficients(summary).map(PageBlock::Table));
        sections.push(PageSection::new("Fig. 14", blocks));
    }
    if let Some(modulus) = stored(MODULUS) {
        let blocks = block(store, "fig-13", &[&modulus], |arrays| figure_13(arrays.first()?))?;
        sections.insert(sections.len().min(1), PageSection::new("Fig. 13", blocks));
    }
    Ok(sections)
}

/// The three functions as printed, with the corrected axis, and fitted anew.
struct Functions {
    all: Vec<(&'static str, FittedLaw, Role)>,
}

impl Functions {
    fn of(summary: &Summary) -> Self {
        let ours = fitted(summary).map(|law| ("our fit", law, Role::Series(0)));
        let others = [
            ("printed fit, corrected axis", FittedLaw::oscillator_paper_corrected(), Role::Series(2)),
            ("printed fit, as printed", FittedLaw::oscillator_paper(), Role::Series(1)),
        ];
        Self { all: ours.into_iter().chain(others).collect() }
    }
}

/// The law of the stored fit.
fn fitted(summary: &Summary) -> Option<FittedLaw> {
    fn numbers<const N: usize>(result: &serde_json::Map<String, Value>, name: &str) -> Option<[f64; N]> {
        let list = result.get(name)?.get("coefficients")?.as_array()?;
        list.iter().map(Value::as_f64).collect::<Option<Vec<f64>>>()?.try_into().ok()
    }
    let result = summary.results.get(FIT)?;
    Some(FittedLaw {
        force: numbers(result, "force")?,
        area: numbers(result, "area")?,
        friction: numbers(result, "friction")?,
        log10_velocity_scale: CORRECTED,
    })
}

fn values(law: &FittedLaw, velocity: f64, indentation: f64) -> PerQuantity<f64> {
    let found = law.evaluate(&LawPoint::new(velocity, indentation));
    PerQuantity { force: found.force.value, area: found.area.value, friction: found.friction.value }
}

/// A quantity over the plane of speeds and indentations.
fn over_plane<'a>(arrays: &StoredArrays<'a>, name: &str) -> Option<&'a [f64]> {
    arrays.over(name, &["indentation", "velocity"])?;
    reals(arrays, name)
}

/// Computed points and the fitted functions over speed, at four indentations.
fn figure_3(fit: &StoredArrays<'_>, functions: &Functions, computed_for: &str) -> Option<Figure> {
    let (velocities, indentations) = (reals(fit, "velocity")?, reals(fit, "indentation")?);
    let last = indentations.len().checked_sub(1)?;
    let rows: Vec<usize> = (0..ROWS).map(|k| k * last / (ROWS - 1)).collect();
    let mut panels = Vec::new();
    for quantity in &QUANTITIES {
        let computed = over_plane(fit, quantity.name)?;
        let mut layers = Vec::new();
        for (name, law, role) in functions.all.iter().rev() {
            for row in &rows {
                let depth = *indentations.get(*row)?;
                let curve = velocities.iter().map(|v| (quantity.pick)(values(law, *v, depth))).collect();
                let label = if *row == 0 { *name } else { "" };
                let style = if *name == "our fit" { role.solid() } else { role.dashed() };
                layers.push(Layer::line(label, velocities.to_vec(), curve, style));
            }
        }
        for row in &rows {
            let points = computed.chunks(velocities.len().max(1)).nth(*row)?.to_vec();
            let label = if *row == 0 { "computed" } else { "" };
            layers.push(Layer::points(label, velocities.to_vec(), points, Role::FullBoundary));
        }
        let panel = Panel::new(axis(fit.variable("velocity")?), quantity.axis(), layers);
        panels.push(panel.with_legend(Legend::Below));
    }
    let depths: Vec<String> =
        rows.iter().filter_map(|row| indentations.get(*row)).map(|d| short_number(*d)).collect();
    let caption = format!(
        "Points: the law computed for {} at the points of the case. Solid: the functions (34), (36), (38) fitted to it at all of them. Dashed: the paper's own fit, with the corrected axis and as \
         printed. $δ$/$R$ = {}, each panel from bottom to top.",
        computed_for,
        depths.join(", ")
    );
    Some(
        Figure::new("fig-3", "Friction, area and force over speed, the paper's Fig. 3", panels)
            .with_caption(caption),
    )
}

/// The computed quantities over speed and indentation, and where the contacts were solved.
fn figure_3_maps(law: &StoredArrays<'_>) -> Option<Figure> {
    let (velocities, indentations) = (reals(law, "velocity")?, reals(law, "indentation")?);
    // the ends are logarithms there and back
    let within = |value: f64, list: &[f64]| {
        let ends = list.first().zip(list.last());
        ends.is_some_and(|(first, last)| value > 0.999 * first && value < 1.001 * last)
    };
    law.alike(&["sample_velocity", "sample_indentation"])?;
    let (solved_v, solved_y) = (reals(law, "sample_velocity")?, reals(law, "sample_indentation")?);
    let places = solved_v.iter().copied().zip(solved_y.iter().copied());
    let (x_dots, y_dots): (Vec<f64>, Vec<f64>) =
        places.filter(|(v, y)| within(*v, velocities) && within(*y, indentations)).unzip();
    let mut panels = Vec::new();
    for quantity in &QUANTITIES {
        let map = ValueMap {
            x: velocities.to_vec(),
            y: indentations.to_vec(),
            z: over_plane(law, quantity.name)?.to_vec(),
            bar: quantity.axis(),
            colours: ColourMap::Sequential,
        };
        let dots = Layer::points("", x_dots.clone(), y_dots.clone(), Role::FullBoundary);
        let (x, y) = (axis(law.variable("velocity")?), axis(law.variable("indentation")?));
        panels.push(Panel::new(x, y, vec![Layer::Values(map), dots]));
    }
    Some(
        Figure::new("fig-3-maps", "Friction, area and force over speed and indentation", panels).with_caption(
            "The computed law. Points: contacts that were solved; where the indenter is a paraboloid, a sphere below $δ$/$R$ = 0.01, the law \
             follows from $v τ$/($R δ$)^{1/2} alone.",
        ),
    )
}

/// Fitted against computed values, with r² of each.
fn figure_14(fit: &StoredArrays<'_>, functions: &Functions) -> Option<Figure> {
    let (velocities, indentations) = (reals(fit, "velocity")?, reals(fit, "indentation")?);
    let places: Vec<(f64, f64)> =
        indentations.iter().flat_map(|y| velocities.iter().map(move |v| (*v, *y))).collect();
    let (across, up) = (velocities.len().div_ceil(DRAWN), indentations.len().div_ceil(DRAWN));
    let shown = |k: &usize| {
        (k % velocities.len()).is_multiple_of(across) && (k / velocities.len()).is_multiple_of(up)
    };
    let shown: Vec<usize> = (0..places.len()).filter(shown).collect();
    let mut panels = Vec::new();
    for name in ["force", "area", "friction"] {
        let quantity = QUANTITIES.iter().find(|quantity| quantity.name == name)?;
        let computed = over_plane(fit, name)?;
        let largest = computed.iter().copied().fold(0.0, f64::max);
        let mut layers = vec![Layer::line("", vec![0.0, largest], vec![0.0, largest], Role::Reference)];
        let mut r2 = Vec::new();
        for (label, law, role) in functions.all.iter().rev() {
            let all: Vec<f64> = places.iter().map(|(v, y)| (quantity.pick)(values(law, *v, *y))).collect();
            r2.push(format!("{:.4}", r_squared(computed, &all)).replace('-', "−"));
            layers.push(Layer::points(*label, picked(computed, &shown), picked(&all, &shown), *role));
        }
        let title = format!("$r^{{2}}$ = {}", r2.join("; "));
        let x = Axis::linear(format!("{}, computed", quantity.label.trim_end_matches(" (−)")));
        let y = Axis::linear(format!("{}, fitted", quantity.label.trim_end_matches(" (−)")));
        panels.push(Panel::new(x, y, layers).with_title(title).with_legend(Legend::Below));
    }
    Some(
        Figure::new("fig-14", "Computed against fitted, the paper's Fig. 14", panels).with_caption(
            "At most 14 speeds and indentations of the plane; on the line the fit is exact. Above each panel $r^{2}$ of all its points: as printed, \
             with the corrected axis, our fit. The paper gives 0.9999, 0.9995, 0.9957.",
        ),
    )
}

/// Storage and loss modulus and loss tangent over frequency.
fn figure_13(modulus: &StoredArrays<'_>) -> Option<Figure> {
    let panels = judder_models::contact::MODEL.panels_of(modulus);
    let figure = Figure::new("fig-13", "Modulus and loss tangent, the paper's Fig. 13", panels).with_caption(
        "One retardation time $τ$ = 10 ms, $E_{0}$ = 1 MPa, $E_{∞}$ = 10 MPa: the material that the contacts are computed for.",
    );
    (!figure.panels.is_empty()).then_some(figure)
}

/// The fourteen coefficients beside the paper's.
fn coefficients(summary: &Summary) -> Option<PageTable> {
    let result = summary.results.get(FIT)?;
    let intervals: Vec<Value> = ["force", "area", "friction"]
        .iter()
        .filter_map(|name| result.get(*name)?.get("intervals")?.as_array().cloned())
        .flatten()
        .collect();
    let number = |value: Option<&Value>, digits: usize| {
        format!("{:.digits$}", value.and_then(Value::as_f64).unwrap_or(f64::NAN)).replace('-', "−")
    };
    let row = |(line, interval): (&Value, &Value)| {
        let off = line.get("relative_deviation").and_then(Value::as_f64).unwrap_or(f64::NAN);
        vec![
            line.get("name").and_then(Value::as_str).unwrap_or_default().to_owned(),
            number(line.get("paper"), 3),
            number(line.get("value"), 3),
            format!("{} … {}", number(interval.get(0), 3), number(interval.get(1), 3)),
            number(line.get("deviation"), 3),
            format!("{:.1}", 100.0 * off).replace('-', "−"),
        ]
    };
    let lines = result.get("beside_the_paper")?.as_array()?;
    Some(PageTable {
        caption: "The coefficients on the corrected axis, beside the paper's. The intervals say how well the points determine them, not how well the \
                  functions describe the contact."
            .to_owned(),
        head: ["coefficient", "paper (−)", "ours (−)", "95 % interval (−)", "difference (−)", "difference (%)"]
            .map(str::to_owned)
            .to_vec(),
        rows: lines.iter().zip(&intervals).map(row).collect(),
    })
}
