//! What `judder check` shows of a contact case.

use super::ContactSubject;
use crate::contact::case::ContactCase;
use crate::error::ModelError;
use crate::estimate::{title, with_memory};
use crate::material::ContactScales;
use crate::oscillator::check::line_rows;
use crate::oscillator::keys::OscillatorKey;
use crate::spectrum_source::temperature_warning;
use judder_keys::keys::Keys;
use judder_keys::numeric_key::Form;
use judder_study::case::text::CaseText;
use judder_study::model::{NeededMemory, estimates};
use judder_study::resolve::Resolved;
use judder_study::text::{columns, number};
use serde_json::{Value, json};

/// Seconds that a contact on 256 × 256 cells takes on one core, all coarser grids counted; good to a factor of a few.
const SECONDS_AT_256: f64 = 0.3;

/// What an analysis would take.
pub struct ContactEstimate {
    pub name: String,
    /// What is asked, in groups.
    pub asked: String,
    /// Likely contacts.
    pub contacts: usize,
    /// Columns and rows of the likely grid; none where nothing touches.
    pub lattice: [usize; 2],
}

impl ContactEstimate {
    /// Seconds: a contact's cost grows as its cells times their logarithm.
    fn seconds(&self) -> f64 {
        let [cells, rows] = self.lattice;
        let size = |cells: f64, rows: f64| cells * rows * libm::log(cells);
        let own = size(cells.max(2) as f64, rows.max(1) as f64);
        self.contacts as f64 * SECONDS_AT_256 * own / size(256.0, 256.0)
    }
}

pub(super) fn resolve(file: &CaseText, case: &ContactCase, resolved: Value) -> Result<Resolved, ModelError> {
    let scales = ContactScales::new(case)?;
    let subject = ContactSubject::new(case, &scales, "");
    subject.profile()?;
    let estimates = estimates(case, file, |name| subject.of(name))?;
    let mut of_bands = Vec::new();
    for own in &case.analyses {
        let told = subject.of(&own.name).band_warning(&*own.kind)?;
        of_bands.extend(told.map(|told| format!("{}: {told}", own.name)));
    }
    let mut warnings: Vec<String> = temperature_warning(&case.substrate)?.into_iter().collect();
    warnings.extend(of_bands);
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
        "case": resolved,
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
    ["substrate", "indenter"]
        .into_iter()
        .flat_map(OscillatorKey::of_section)
        .filter(|key| case.substrate.has(key.key))
        .map(|key| {
            let value = inputs.get(key.key);
            let unit = if value.form == Form::Si { key.rule.dimension.unit() } else { String::new() };
            vec![key.path.to_owned(), number(value.number), unit]
        })
        .chain(line_rows(case.substrate.thickness, case.length))
        .collect()
}

fn estimate_text(estimates: &[(ContactEstimate, NeededMemory)]) -> String {
    if estimates.is_empty() {
        return "\nno analyses\n".to_owned();
    }
    let rows: Vec<Vec<String>> = estimates
        .iter()
        .map(|(e, memory)| {
            let size = match e.contacts {
                0 => "no contact".to_owned(),
                contacts => format!("{contacts} × {} × {} cells", e.lattice[0], e.lattice[1]),
            };
            vec![e.name.clone(), e.asked.clone(), size, format!("about {:.1} s", e.seconds()), memory.words()]
        })
        .collect();
    format!(
        "\nanalyses: what is asked, likely contacts and grid, time and memory on one core\n{}",
        columns(&rows)
    )
}

fn estimate_json((e, memory): &(ContactEstimate, NeededMemory)) -> Value {
    let entry = json!({
        "name": e.name, "asked": e.asked, "contacts": e.contacts, "cells": e.lattice[0], "seconds": e.seconds(),
    });
    with_memory(entry, memory)
}
