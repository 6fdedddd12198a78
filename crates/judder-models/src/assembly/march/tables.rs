//! The tables of a motion in the report.

use judder_report::page::PageTable;
use judder_study::report_tables::{short, uncertainty};
use serde_json::{Map, Value};

/// What each contact does on average, and where the energy goes.
pub(crate) fn report(results: &Map<String, Value>) -> Vec<PageTable> {
    let heads = [
        "contact",
        "points",
        "stick (−)",
        "slip (−)",
        "lift-off (−)",
        "largest error of a share (−)",
        "normal force (N)",
        "largest rms velocity (m/s)",
    ];
    let numbers = |told: &Value, key: &str| -> Vec<f64> {
        told[key].as_array().into_iter().flatten().filter_map(Value::as_f64).collect()
    };
    let row = |(name, told): (&String, &Value)| {
        let mean = |key: &str| {
            let own = numbers(told, key);
            if own.is_empty() { Value::Null } else { (own.iter().sum::<f64>() / own.len() as f64).into() }
        };
        let force = numbers(told, "normal_force_mean").iter().sum::<f64>();
        let rms = numbers(told, "tangential_velocity_rms");
        let most = (0..rms.len()).max_by(|a, b| rms[*a].total_cmp(&rms[*b])).unwrap_or(0);
        let rms =
            with_error(&told["tangential_velocity_rms"][most], &told["tangential_velocity_rms_error"][most]);
        let errors =
            ["stick_share_error", "slip_share_error", "open_share_error"].map(|key| numbers(told, key));
        let error = errors.into_iter().flatten().reduce(f64::max).map_or(Value::Null, Value::from);
        let shares = ["stick_share", "slip_share", "open_share"].map(|key| short(&mean(key)));
        let points = numbers(told, "x_m").len().to_string();
        [vec![name.clone(), points], shares.to_vec(), vec![known_error(&error), short(&force.into()), rms]]
            .concat()
    };
    let contacts = results.get("contacts").and_then(Value::as_object);
    let rows: Vec<Vec<String>> = contacts.into_iter().flatten().map(row).collect();
    let table = |caption: &str, head: Vec<String>, rows: Vec<Vec<String>>| {
        (!rows.is_empty()).then(|| PageTable { caption: caption.to_owned(), head, rows })
    };
    let power = results.get("power").and_then(Value::as_object);
    let powers: Vec<Vec<String>> =
        power.into_iter().flatten().map(|(name, value)| vec![name.clone(), short(value)]).collect();
    let shares = table(
        "Contacts, averages over points and time, with standard errors by batch means",
        heads.map(String::from).to_vec(),
        rows,
    );
    let powers =
        table("Power into the bodies, on average", vec!["from".to_owned(), "power (W)".to_owned()], powers);
    shares
        .into_iter()
        .chain(averages(results))
        .chain(powers)
        .chain(levels(results))
        .chain(modes(results))
        .collect()
}

/// A number, or that it is not known.
fn known(value: &Value) -> String {
    if value.is_null() { "unknown".to_owned() } else { short(value) }
}

/// By how much a number may be off, or that it is not known.
fn known_error(value: &Value) -> String {
    if value.is_null() { "unknown".to_owned() } else { uncertainty(value) }
}

fn with_error(value: &Value, error: &Value) -> String {
    format!("{} ± {}", short(value), known_error(error))
}

/// Frequency and forces with their standard errors.
fn averages(results: &Map<String, Value>) -> Option<PageTable> {
    results.get("steps")?;
    let rows = [
        ("strongest line (Hz)", "frequency_hz", "frequency_error_hz"),
        ("normal forces (N)", "normal_force_mean", "normal_force_mean_error"),
        ("friction forces (N)", "friction_force_mean", "friction_force_mean_error"),
    ];
    let of = |key: &str| results.get(key).unwrap_or(&Value::Null);
    Some(PageTable {
        caption: "The whole motion, with standard errors".to_owned(),
        head: ["", "average", "error"].map(String::from).to_vec(),
        rows: rows
            .map(|(name, key, error)| vec![name.to_owned(), known(of(key)), known_error(of(error))])
            .to_vec(),
    })
}

/// Levels of the observed points, a row an octave.
fn levels(results: &Map<String, Value>) -> Option<PageTable> {
    let levels = results.get("levels")?.as_object()?;
    let bands = levels.values().next()?["band_hz"].as_array()?;
    let row = |(k, band): (usize, &Value)| {
        let own = levels.values().map(|own| match own["level_db"][k].as_f64() {
            Some(level) => format!("{level:.1}"),
            None => known(&Value::Null),
        });
        std::iter::once(short(band)).chain(own).collect()
    };
    Some(PageTable {
        caption: "Levels of the accelerations after the transient in octaves".to_owned(),
        head: std::iter::once("octave about (Hz)".to_owned())
            .chain(levels.keys().map(|name| format!("{name} (dB re 1 µm/s²)")))
            .collect(),
        rows: bands.iter().enumerate().map(row).collect(),
    })
}

/// The modes about steady sliding beside what the motion has of them.
fn modes(results: &Map<String, Value>) -> Option<PageTable> {
    let heads = [
        "mode",
        "frequency (Hz)",
        "growth rate (1/s)",
        "in the motion (m/s)",
        "beside the loudest (dB)",
        "turning (Hz)",
        "promised",
        "came",
    ];
    let row = |told: &Value| {
        let keys = ["mode", "frequency_hz", "growth_rate", "velocity", "level_db", "turning_hz"];
        let promised = if told["unstable"].as_bool() == Some(true) { "grows" } else { "decays" };
        let came = match told["heard"].as_bool() {
            Some(true) => "heard",
            Some(false) => "not heard",
            None => "",
        };
        [keys.map(|key| short(&told[key])).to_vec(), vec![promised.to_owned(), came.to_owned()]].concat()
    };
    let rows: Vec<Vec<String>> =
        results.get("modes").and_then(Value::as_array).into_iter().flatten().map(row).collect();
    let caption = "Modes about steady sliding in the motion".to_owned();
    (!rows.is_empty()).then(|| PageTable { caption, head: heads.map(String::from).to_vec(), rows })
}
