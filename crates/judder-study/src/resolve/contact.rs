//! What `judder check` shows of a contact case.

use super::{Resolved, columns, number, title};
use crate::analyses::contact::{Asked, band_warning, cells_of_law, lattice, loading, usual_contacts};
use crate::door;
use crate::error::StudyError;
use crate::material::{self, ContactScales};
use crate::spectrum_source::temperature_warning;
use judder_case::{
    Analysis, CaseFile, ContactAnalysis, ContactCase, ContactSettings, Form, LawSettings, Memory,
    OscillatorKey, Shape,
};
use judder_contact::kernel::sliding::SlidingOperator;
use judder_contact::unilateral::Loading;
use serde_json::{Value, json};

/// Seconds that a contact on 256 × 256 cells takes on one core, all coarser grids counted; good to a factor of a few.
const SECONDS_AT_256: f64 = 0.3;
/// What an analysis would take.
struct Estimate {
    name: String,
    /// What is asked, in groups.
    asked: String,
    contacts: usize,
    cells: usize,
    rows: usize,
}

impl Estimate {
    /// Seconds: a contact's cost grows as its cells times their logarithm.
    fn seconds(&self) -> f64 {
        let size = |cells: f64, rows: f64| cells * rows * cells.ln();
        let own = size(self.cells.max(2) as f64, self.rows.max(1) as f64);
        self.contacts as f64 * SECONDS_AT_256 * own / size(256.0, 256.0)
    }

    fn bytes(&self) -> u64 {
        if self.cells == 0 { 0 } else { SlidingOperator::memory_bytes(self.cells, self.rows) }
    }
}

pub(super) fn resolve(file: &CaseFile, case: &ContactCase) -> Result<Resolved, StudyError> {
    door::check(file, |_| true)?;
    let scales = ContactScales::new(case)?;
    let estimates = case
        .analyses
        .iter()
        .map(|analysis| estimate(case, analysis, &scales))
        .collect::<Result<Vec<Estimate>, StudyError>>()?;
    let mut warnings: Vec<String> = temperature_warning(&case.substrate)?.into_iter().collect();
    for analysis in &case.analyses {
        let told = band_warning(case, &analysis.kind, &scales)?;
        warnings.extend(told.map(|told| format!("{}: {told}", analysis.name)));
    }
    let mut text = format!("{}\n\nindenter: {}\n\n", title(&case.title), case.shape.name());
    text.push_str(&columns(&key_rows(case, &scales)));
    text.push_str("\nthe substrate\n");
    let spectrum = &scales.material.spectrum;
    let rows = [
        ("E∞/E0", spectrum.contrast(), ""),
        ("retardation times", spectrum.terms().len() as f64, ""),
        ("τ, the time of the groups", scales.time, "s"),
        ("E0* = E0/(1 − ν²)", scales.scales.reduced_modulus, "Pa"),
        ("speed at v τ/R = 1", scales.scales.radius / scales.time, "m/s"),
        ("force at F/(E0* R²) = 1", scales.force_unit(), "N"),
    ];
    let shown = rows.map(|(name, value, unit)| vec![name.to_owned(), number(value), unit.to_owned()]);
    text.push_str(&columns(&shown));
    if let Some(found) = &scales.material.discretisation {
        let (terms, error) = (found.spectrum.terms().len(), found.error);
        let line = format!(
            "\nthe continuous spectrum as {terms} terms: E(ω) is within {error:.1e} at every frequency\n"
        );
        text.push_str(&line);
    }
    text.push_str(&estimate_text(&estimates));
    for warning in &warnings {
        text.push_str(&format!("\nwarning: {warning}\n"));
    }
    let document = json!({
        "case": material::with_used(&file.case, file.case.resolved())?,
        "groups": {
            "contrast": spectrum.contrast(),
            "terms": spectrum.terms().len(),
            "time_second": scales.time,
            "spectrum_error": scales.material.discretisation.as_ref().map(|found| found.error),
            "reduced_modulus_pascal": scales.scales.reduced_modulus,
        },
        "estimate": estimates.iter().map(estimate_json).collect::<Vec<Value>>(),
        "warnings": warnings,
    });
    Ok(Resolved { document, text })
}

/// The numeric keys as they are taken, with what the material says where it decides them.
fn key_rows(case: &ContactCase, scales: &ContactScales) -> Vec<Vec<String>> {
    let inputs = scales.material.told_to(&case.inputs);
    ContactCase::KEYS
        .into_iter()
        .filter(|key| case.substrate.has(*key))
        .map(OscillatorKey::entry)
        .map(|key| {
            let value = inputs.get(key.key);
            let unit = if value.form == Form::Si { key.dimension.unit() } else { String::new() };
            vec![key.path.to_owned(), number(value.number), unit]
        })
        .collect()
}

fn estimate(
    case: &ContactCase,
    analysis: &Analysis<ContactAnalysis>,
    scales: &ContactScales,
) -> Result<Estimate, StudyError> {
    let (asked, contacts, [cells, rows]) = match &analysis.kind {
        ContactAnalysis::Contact(settings) => {
            (asked_of_contact(case, settings, scales), 1, lattice(case, settings, scales)?)
        }
        ContactAnalysis::ContactLaw(law) | ContactAnalysis::Fit { law, .. } => {
            (asked_of_law(law), usual_contacts(law.method), [cells_of_law(law); 2])
        }
        ContactAnalysis::Modulus { .. } => ("E(ω)".to_owned(), 0, [0; 2]),
        ContactAnalysis::Transient(settings) => {
            let asked = Asked::new(&case.shape, settings, scales);
            (asked.words(settings), asked.steps(settings.cells), [settings.cells; 2])
        }
    };
    Ok(Estimate { name: analysis.name.clone(), asked, contacts, cells, rows })
}

fn asked_of_contact(case: &ContactCase, settings: &ContactSettings, scales: &ContactScales) -> String {
    let velocity = scales.velocity(settings.velocity);
    match loading(&case.shape, settings, scales) {
        Loading::Indentation(depth) => format!(
            "v τ/R = {}, δ/R = {}, v τ/√(R δ) = {}",
            number(velocity),
            number(depth),
            number(velocity / depth.sqrt())
        ),
        Loading::Load(force) => {
            let group = if case.shape == Shape::Cylinder { "F/(E0* R)" } else { "F/(E0* R²)" };
            format!("v τ/R = {}, {group} = {}", number(velocity), number(force))
        }
    }
}

fn asked_of_law(law: &LawSettings) -> String {
    let (method, accuracy) = (law.method.name(), law.accuracy);
    format!("{method}, {} × {} points, accuracy {accuracy:e}", law.velocity.points, law.indentation.points)
}

fn estimate_text(estimates: &[Estimate]) -> String {
    if estimates.is_empty() {
        return "\nno analyses\n".to_owned();
    }
    let rows: Vec<Vec<String>> = estimates
        .iter()
        .map(|e| {
            let size = match e.contacts {
                0 => "no contact".to_owned(),
                contacts => format!("{contacts} × {} × {} cells", e.cells, e.rows),
            };
            vec![
                e.name.clone(),
                e.asked.clone(),
                size,
                format!("about {:.1} s", e.seconds()),
                Memory { bytes: e.bytes() }.to_string(),
            ]
        })
        .collect();
    format!(
        "\nanalyses: what is asked, likely contacts and grid, time and memory on one core\n{}",
        columns(&rows)
    )
}

fn estimate_json(e: &Estimate) -> Value {
    json!({
        "name": e.name, "asked": e.asked, "contacts": e.contacts, "cells": e.cells,
        "seconds": e.seconds(), "bytes": e.bytes(),
    })
}
