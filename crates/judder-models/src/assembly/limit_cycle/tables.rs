//! The tables of a limit cycle in the report.

use judder_report::page::PageTable;
use judder_study::report_tables::short;
use serde_json::{Map, Value};

/// What the cycle is, what each contact does over a period, of which modes it is made up, where its energy comes from, how loud it is.
pub(crate) fn report(results: &Map<String, Value>) -> Vec<PageTable> {
    [cycle(results), contacts(results), modes(results), power(results), levels(results)]
        .into_iter()
        .flatten()
        .collect()
}

/// A number, or that it is not known.
fn known(value: &Value) -> String {
    if value.is_null() { "unknown".to_owned() } else { short(value) }
}

fn table(caption: &str, head: &[&str], rows: Vec<Vec<String>>) -> Option<PageTable> {
    let head = head.iter().map(|own| (*own).to_owned()).collect();
    (!rows.is_empty()).then(|| PageTable { caption: caption.to_owned(), head, rows })
}

/// Frequency and kind of the cycle beside its mode, and how well it is known.
fn cycle(results: &Map<String, Value>) -> Option<PageTable> {
    results.get("frequency_hz")?.as_f64()?;
    let rows = [
        ("frequency (Hz)", "frequency_hz"),
        ("of the mode (Hz)", "mode_frequency_hz"),
        ("shift, over that (−)", "frequency_shift"),
        ("growth rate of the mode (1/s)", "mode_growth_rate"),
        ("motions of this shape are drawn to it", "attracts"),
        ("motions nearby, by the Floquet multipliers", "stability"),
        ("what they become", "motion"),
        ("Floquet multipliers, second opinion", "second_opinion"),
        ("largest multipliers apart by both (−)", "multipliers_apart"),
        ("converged", "converged"),
        ("harmonics", "harmonics"),
        ("left out of the swing of the forces (−)", "left_out"),
        ("largest difference from a contact law, over the largest normal force (−)", "between_samples"),
    ];
    let of = |key: &str| results.get(key).unwrap_or(&Value::Null);
    let row = |(name, key): (&str, &str)| {
        let told = match of(key) {
            Value::Bool(is_so) => if *is_so { "yes" } else { "no" }.to_owned(),
            Value::String(words) => words.clone(),
            number => known(number),
        };
        vec![name.to_owned(), told]
    };
    table("The limit cycle", &["", ""], rows.map(row).to_vec())
}

/// What each contact does, on average over points and the period.
fn contacts(results: &Map<String, Value>) -> Option<PageTable> {
    let row = |(name, told): (&String, &Value)| {
        let numbers = |key: &str| -> Vec<f64> {
            told[key].as_array().into_iter().flatten().filter_map(Value::as_f64).collect()
        };
        let mean = |key: &str| {
            let own = numbers(key);
            short(&(own.iter().sum::<f64>() / own.len().max(1) as f64).into())
        };
        let sum = |key: &str| short(&numbers(key).iter().sum::<f64>().into());
        let rms = numbers("tangential_velocity_rms").into_iter().fold(0.0, f64::max);
        let shares = ["stick_share", "slip_share", "open_share"].map(mean);
        let points = numbers("x_m").len().to_string();
        let forces = ["normal_force_mean", "friction_force_mean"].map(sum);
        [vec![name.clone(), points], shares.to_vec(), forces.to_vec(), vec![short(&rms.into())]].concat()
    };
    let heads = [
        "contact",
        "points",
        "stick (−)",
        "slip (−)",
        "lift-off (−)",
        "normal force (N)",
        "friction (N)",
        "largest rms velocity (m/s)",
    ];
    let rows = results.get("contacts").and_then(Value::as_object).into_iter().flatten().map(row).collect();
    table("Contacts over a period, averages over points", &heads, rows)
}

fn power(results: &Map<String, Value>) -> Option<PageTable> {
    let power = results.get("power").and_then(Value::as_object).into_iter().flatten();
    let rows = power.map(|(name, value)| vec![name.clone(), short(value)]).collect();
    table("Power into the bodies over a period, on average", &["from", "power (W)"], rows)
}

/// Of which modes the cycle is made up; those with a hundredth of a per cent or less stay in the arrays.
fn modes(results: &Map<String, Value>) -> Option<PageTable> {
    /// A share that is not shown.
    const SMALL: f64 = 1e-4;
    let modes = results.get("mode_contributions").and_then(Value::as_array).into_iter().flatten();
    let row = |own: &Value| vec![short(&own["frequency_hz"]), short(&own["share"])];
    let shown = modes.filter(|own| own["share"].as_f64().is_some_and(|share| share > SMALL));
    let left_over = results.get("contributions_left_over").filter(|own| !own.is_null());
    let rows = shown.map(row).chain(left_over.map(|own| vec!["left over".to_owned(), short(own)]));
    table(
        "Modes of frictionless contact that make up the cycle, by their shares in the kinetic energy of its swing",
        &["mode (Hz)", "share (−)"],
        rows.collect(),
    )
}

fn levels(results: &Map<String, Value>) -> Option<PageTable> {
    let levels = results.get("levels").and_then(Value::as_object).into_iter().flatten();
    let row = |(name, own): (&String, &Value)| {
        vec![name.clone(), short(&own["acceleration_rms"]), known(&own["level_db"])]
    };
    table(
        "Accelerations of the observed points",
        &["point", "rms (m/s²)", "level (dB re 1 µm/s²)"],
        levels.map(row).collect(),
    )
}
