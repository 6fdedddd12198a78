//! The tables of motions: energy, multipliers, diagrams, fates.

use crate::swept_tables::{in_unit_of, numbers, table, told, word};
use judder_report::page::PageTable;
use judder_study::prefixed::PrefixedUnit;
use judder_study::registry::ToldAnalysis;
use serde_json::Value;

/// The works of a motion, what they are in words.
const WORKS: [(&str, &str); 7] = [
    ("substrate", "fed by the sliding track"),
    ("sliding", "lost in sliding"),
    ("friction", "work of the friction force"),
    ("normal", "work of the normal force"),
    ("damping", "work of the dampers"),
    ("change", "change of the stored energy"),
    ("residual", "what is left, over the largest"),
];

/// What a motion is, where its energy came from and went; of a cycle its multipliers too. `unit` is that of energies.
pub(crate) fn motion(analysis: ToldAnalysis<'_>, unit: &str) -> Vec<PageTable> {
    [quantities(analysis)].into_iter().chain(energies(analysis, unit)).chain(multipliers(analysis)).collect()
}

/// A part of the energy below this share of the largest is rounding.
const ROUNDING: f64 = 1e-12;

/// Works in SI where the case is written so, and in groups; what is left is relative. What rounding alone leaves of a part is no number of its own.
fn energies(analysis: ToldAnalysis<'_>, unit: &str) -> Option<PageTable> {
    let energy = analysis.results.get("energy")?;
    let in_si = analysis.results.get("energy_j");
    let part = |key: &str| energy[key].as_f64();
    let works = WORKS.iter().filter(|(key, _)| *key != "residual").filter_map(|(key, _)| part(key));
    let largest = works.fold(0.0, |most: f64, work| most.max(work.abs()));
    let joules = |in_si: &Value| {
        let works =
            WORKS.iter().filter(|(key, _)| *key != "residual").filter_map(|(key, _)| in_si[*key].as_f64());
        PrefixedUnit::of("J", works.fold(0.0, |most: f64, work| most.max(work.abs())))
    };
    let in_si = in_si.map(|own| (own, joules(own)));
    let rows = WORKS.iter().map(|(key, words)| {
        let is_rounding =
            *key != "residual" && part(key).is_some_and(|own| own != 0.0 && own.abs() <= ROUNDING * largest);
        let cell = |own: f64| if is_rounding { "0 within rounding".to_owned() } else { told(own) };
        let in_si = in_si
            .as_ref()
            .map(|(own, shown)| own[*key].as_f64().map_or_else(String::new, |own| cell(shown.factor * own)));
        [(*words).to_owned()].into_iter().chain(in_si).chain([cell(part(key).unwrap_or(f64::NAN))]).collect()
    });
    let rows = rows.collect();
    let of_si = in_si.as_ref().map(|(_, shown)| format!("in SI ({})", shown.name));
    let head: Vec<&str> = ["what"].into_iter().chain(of_si.as_deref()).chain([unit]).collect();
    Some(table("Energy".to_owned(), &head, rows))
}

/// What a motion is, its key in groups and in SI, and its unit in SI.
const QUANTITIES: [(&str, &str, &str, &str); 6] = [
    ("rms of x about its mean", "rms", "rms_m", "m"),
    ("mean of x", "mean", "mean_m", "m"),
    ("period", "period", "period_s", "s"),
    ("frequency", "", "frequency_hz", "Hz"),
    ("share of the time in stick (−)", "stick_fraction", "", ""),
    ("share of the time off the ground (−)", "lift_off_fraction", "", ""),
];

/// A motion in SI where its case is written in SI, and in groups.
fn quantities(analysis: ToldAnalysis<'_>) -> PageTable {
    let number = |key: &str| analysis.results.get(key).and_then(Value::as_f64);
    let has_si = number("rms_m").is_some();
    let rows = QUANTITIES.iter().filter(|(_, group, ..)| has_si || !group.is_empty());
    let with_prefix = |value: f64, unit: &str| {
        let shown = PrefixedUnit::of(unit, value);
        format!("{} {}", told(shown.factor * value), shown.name)
    };
    let rows = rows.map(|(what, group, si, unit)| {
        let in_si = number(si).map_or_else(String::new, |value| with_prefix(value, unit));
        let in_groups = number(group).map_or_else(String::new, told);
        [(*what).to_owned()].into_iter().chain(has_si.then_some(in_si)).chain([in_groups]).collect()
    });
    let head = ["what", "in SI", "in groups (−)"].into_iter().filter(|own| has_si || *own != "in SI");
    table("The motion".to_owned(), &head.collect::<Vec<_>>(), rows.collect())
}

/// The multipliers of a cycle, and what follows from them.
fn multipliers(analysis: ToldAnalysis<'_>) -> Option<PageTable> {
    let multipliers = analysis.results.get("floquet_multipliers")?;
    let verdict = match analysis.results.get("stable").and_then(Value::as_bool) {
        Some(true) => ": the cycle is stable",
        Some(false) => ": the cycle is unstable",
        None => "",
    };
    let rows = multipliers.as_array().into_iter().flatten().map(|own| {
        let parts = numbers(Some(own));
        let [re, im] = [0, 1].map(|k| parts.get(k).copied().unwrap_or(f64::NAN));
        [re, im, libm::hypot(re, im)].map(told).to_vec()
    });
    let head = ["real part (−)", "imaginary part (−)", "magnitude (−)"];
    Some(table(format!("Floquet multipliers{verdict}"), &head, rows.collect()))
}

/// What motions become along the swept key, range by range; where steady sliding loses its stability; the branches of cycles.
pub(crate) fn diagram(analysis: ToldAnalysis<'_>, swept: &str) -> Vec<PageTable> {
    let list = |key: &str| analysis.results.get(key).and_then(Value::as_array).filter(|own| !own.is_empty());
    let settled = settled(analysis, swept);
    let hopf = list("hopf_points").map(|points| {
        let has_si = points.iter().all(|own| own.get("frequency_hz").is_some());
        let rows = points.iter().map(|own| {
            let number = |key: &str| told(own[key].as_f64().unwrap_or(f64::NAN));
            let in_si = has_si.then(|| number("frequency_hz"));
            let rest = [number("frequency"), word(&own["criticality"]).to_owned()];
            [number("value")].into_iter().chain(in_si).chain(rest).collect()
        });
        let head = [Some(swept), has_si.then_some("frequency (Hz)")].into_iter().flatten();
        let head: Vec<&str> = head.chain(["frequency over the natural one (−)", "onset"]).collect();
        table("Where steady sliding loses its stability".to_owned(), &head, rows.collect())
    });
    let branches = list("branches").map(|branches| {
        let has_si = branches.iter().all(|own| own.get("rms_m").is_some());
        let metres = branches.iter().flat_map(|own| numbers(own.get("rms_m")));
        let metres = PrefixedUnit::of("m", largest(metres));
        let rows = branches.iter().map(|own| branch(own, has_si.then_some(metres.factor))).collect();
        let rms = format!("largest rms ({})", metres.name);
        let [from, to, folds] = ["from", "to", "folds at"].map(|head| in_unit_of(swept, head));
        let head = ["branch", &from, &to].into_iter().chain(has_si.then_some(rms.as_str()));
        let head: Vec<&str> = head.chain(["largest rms (−)", &folds, "ends because"]).collect();
        table(format!("Branches of cycles along: {swept}"), &head, rows)
    });
    settled.into_iter().chain(hopf).chain(branches).collect()
}

/// The largest of the numbers that are finite; −∞ of none.
fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().filter(|value| value.is_finite()).fold(f64::NEG_INFINITY, f64::max)
}

/// A row of a branch; `metre` is what a metre of the rms is multiplied by, where the case is written in SI.
fn branch(own: &Value, metre: Option<f64>) -> Vec<String> {
    let [values, rms, folds] = ["value", "rms", "folds"].map(|key| numbers(own.get(key)));
    let end = |of: fn(f64, f64) -> f64| values.iter().copied().fold(f64::NAN, of);
    let folds: Vec<String> = folds.into_iter().map(told).collect();
    let in_si = metre.map(|factor| told(factor * largest(numbers(own.get("rms_m")))));
    let rest = [
        told(largest(rms)),
        if folds.is_empty() { "none".to_owned() } else { folds.join(", ") },
        word(&own["end"]).to_owned(),
    ];
    let first = [word(&own["from"]).to_owned(), told(end(f64::min)), told(end(f64::max))];
    first.into_iter().chain(in_si).chain(rest).collect()
}

/// What is told of motions in SI before the groups: its key, its unit, and the head of its column.
const IN_SI: [(&str, &str, &str); 2] = [("rms_m", "m", "rms"), ("period_s", "s", "period")];

/// Neighbouring values of a direction at which motions become the same, with the ranges of rms and period.
fn settled(analysis: ToldAnalysis<'_>, swept: &str) -> Option<PageTable> {
    let words = |key: &str| -> Vec<&str> {
        analysis.results.get(key).and_then(Value::as_array).into_iter().flatten().map(word).collect()
    };
    let (direction, becomes) = (words("direction"), words("becomes"));
    let [values, rms, period] = ["value", "rms", "period"].map(|key| numbers(analysis.results.get(key)));
    let in_si: Vec<(String, Vec<f64>)> = IN_SI
        .into_iter()
        .map(|(key, unit, head)| {
            let values = numbers(analysis.results.get(key));
            let shown = PrefixedUnit::of(unit, largest(values.iter().copied()));
            let values = values.into_iter().map(|value| shown.factor * value).collect::<Vec<_>>();
            (format!("{head} ({})", shown.name), values)
        })
        .filter(|(_, values)| values.len() == becomes.len())
        .collect();
    let lengths = [direction.len(), values.len(), rms.len(), period.len()];
    if lengths.iter().any(|length| *length != becomes.len()) {
        return None;
    }
    let mut rows = Vec::new();
    let mut first = 0;
    while first < becomes.len() {
        let is_same = |k: &usize| (direction[*k], becomes[*k]) == (direction[first], becomes[first]);
        let last = (first..becomes.len()).take_while(is_same).last().unwrap_or(first);
        let mut row = vec![
            direction[first].to_owned(),
            told(values[first]),
            told(values[last]),
            becomes[first].to_owned(),
        ];
        let measured = in_si.iter().map(|(_, values)| values).chain([&rms, &period]);
        row.extend(measured.map(|values| span(&values[first..=last])));
        rows.push(row);
        first = last + 1;
    }
    let [from, to] = ["from", "to"].map(|head| in_unit_of(swept, head));
    let mut head = vec!["direction", &from, &to, "motions become"];
    head.extend(in_si.iter().map(|(head, _)| head.as_str()).chain(["rms (−)", "period (−)"]));
    (!rows.is_empty()).then(|| table(format!("What motions become along: {swept}"), &head, rows))
}

/// The least and the largest of numbers, a dash where there are none.
fn span(values: &[f64]) -> String {
    let finite = || values.iter().copied().filter(|value| value.is_finite());
    let (least, most) = (finite().fold(f64::INFINITY, f64::min), finite().fold(f64::NEG_INFINITY, f64::max));
    match (least.is_finite(), told(least) == told(most)) {
        (false, _) => told(f64::NAN),
        (true, true) => told(least),
        (true, false) => format!("{} … {}", told(least), told(most)),
    }
}

/// What becomes of the starts.
pub(crate) fn fates(analysis: ToldAnalysis<'_>) -> Vec<PageTable> {
    let samples = analysis.results.get("samples").and_then(Value::as_f64).unwrap_or(f64::NAN);
    let fates = analysis.results.get("fates").and_then(Value::as_object);
    let of = |fates: &serde_json::Map<String, Value>| {
        let rows = fates.iter().map(|(fate, count)| {
            let share = 100.0 * count.as_f64().unwrap_or(f64::NAN) / samples;
            vec![fate.replace('_', " "), count.to_string(), told(share)]
        });
        table("What becomes of the starts".to_owned(), &["fate", "starts", "share (%)"], rows.collect())
    };
    fates.map(of).into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn what_rounding_leaves_of_a_part_is_no_energy() {
        let results = json!({
            "energy": { "substrate": 2.0, "sliding": -1.0, "friction": 1.0, "normal": 0.0, "damping": -1.0, "change": 3e-17, "residual": 2e-10 },
            "energy_j": { "substrate": 2e-3, "sliding": -1e-3, "friction": 1e-3, "normal": 0.0, "damping": -1e-3, "change": 3e-20 },
        });
        let asked = Value::Null;
        let told = ToldAnalysis { asked: &asked, results: results.as_object().unwrap() };
        let table = energies(told, "energy (−)").unwrap();
        assert_eq!(table.head, ["what", "in SI (mJ)", "energy (−)"]);
        assert_eq!(table.rows[2], ["work of the friction force", "1", "1"]);
        assert_eq!(table.rows[3][1..], ["0", "0"]);
        assert_eq!(table.rows[5], ["change of the stored energy", "0 within rounding", "0 within rounding"]);
        assert_eq!(table.rows[6][2], "2e−10");
    }

    #[test]
    fn a_motion_in_si_is_told_in_si_first() {
        let asked = Value::Null;
        let results = json!({ "rms": 0.5, "mean": 1.0, "period": 6.0, "rms_m": 5e-4, "mean_m": 1e-3, "period_s": 0.6, "frequency_hz": 1.0 / 0.6 });
        let table = quantities(ToldAnalysis { asked: &asked, results: results.as_object().unwrap() });
        assert_eq!(table.head, ["what", "in SI", "in groups (−)"]);
        assert_eq!(table.rows[0], ["rms of x about its mean", "500 µm", "0.5"]);
        let results = json!({ "rms": 0.5, "mean": 1.0, "period": 6.0 });
        let table = quantities(ToldAnalysis { asked: &asked, results: results.as_object().unwrap() });
        assert_eq!((table.head.len(), table.rows[0].len()), (2, 2));
    }

    #[test]
    fn a_diagram_is_told_by_its_ranges() {
        let results = json!({
            "direction": ["forward", "forward", "forward", "backward"],
            "value": [1.0, 2.0, 3.0, 3.0],
            "becomes": ["steady sliding", "cycle", "cycle", "cycle"],
            "rms": [0.0, 0.5, 0.7, 0.7],
            "period": [null, 6.0, 6.0, 6.0],
        });
        let asked = Value::Null;
        let told = ToldAnalysis { asked: &asked, results: results.as_object().unwrap() };
        let tables = diagram(told, "key");
        let rows = &tables[0].rows;
        assert_eq!(rows.len(), 3);
        assert_eq!(rows[0], ["forward", "1", "1", "steady sliding", "0", "–"]);
        assert_eq!(rows[1], ["forward", "2", "3", "cycle", "0.5 … 0.7", "6"]);
        assert_eq!(tables.len(), 1);
        let mut in_si = results;
        in_si["rms_m"] = json!([0.0, 0.5e-3, 0.7e-3, 0.7e-3]);
        in_si["period_s"] = json!([null, 0.6, 0.6, 0.6]);
        let told = ToldAnalysis { asked: &asked, results: in_si.as_object().unwrap() };
        let table = &diagram(told, "key")[0];
        assert_eq!(table.head[4..], ["rms (µm)", "period (ms)", "rms (−)", "period (−)"]);
        assert_eq!(table.rows[1][4..], ["500 … 700", "600", "0.5 … 0.7", "6"]);
    }
}
