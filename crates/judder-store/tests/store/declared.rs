//! Results declared once: summary, arrays and table from one struct.

use judder_store::{ByName, Complex64, Dataset, Declared, GridValues, Results, Rows, Table, Told, ValueKind};
use serde_json::{Value, json};

/// A row of a list.
#[derive(Clone, Results)]
#[results(rows = "burst", prefix = "burst_", arrays(time, frequency), columns(time, frequency, word))]
struct Burst {
    /// time of the peak
    #[result(summary = "time_s", unit = "s")]
    time: f64,
    /// frequency
    #[result(summary = "frequency_hz", unit = "Hz")]
    frequency: Option<f64>,
    word: &'static str,
}

#[derive(Results)]
#[results(along = "mode", arrays(shape, bursts, own), columns(frequency, bursts))]
struct All {
    #[result(attribute)]
    method: &'static str,
    frequency: Vec<f64>,
    /// shapes of modes
    #[result(hidden, along = "mode point")]
    shape: GridValues<Complex64>,
    #[result(rows)]
    bursts: Vec<Burst>,
    #[result(optional)]
    ended: Option<String>,
    fates: ByName<usize>,
    #[result(flatten)]
    own: Option<Own>,
}

#[derive(Results)]
#[results(along = "mode", arrays(error))]
struct Own {
    /// how far it is off
    #[result(unit = "s")]
    error: Vec<f64>,
}

fn all(own: Option<Own>) -> All {
    let burst = |time: f64, frequency: Option<f64>| Burst { time, frequency, word: "loud" };
    All {
        method: "film",
        frequency: vec![1.5, f64::INFINITY],
        shape: GridValues { shape: vec![2, 1], values: vec![Complex64::new(0.0, 1.0); 2] },
        bursts: vec![burst(0.5, Some(100.0)), burst(1.0, None)],
        ended: None,
        fates: [("cycle".to_owned(), 3)].into_iter().collect(),
        own,
    }
}

#[test]
fn a_summary_has_the_fields_in_their_order() {
    let own = Own { error: vec![0.1, 0.2] };
    let summary = Value::Object(all(Some(own)).scalars()).to_string();
    let bursts = r#"[{"time_s":0.5,"frequency_hz":100.0,"word":"loud"},{"time_s":1.0,"frequency_hz":null,"word":"loud"}]"#;
    let expected = format!(
        r#"{{"method":"film","frequency":[1.5,null],"bursts":{bursts},"fates":{{"cycle":3}},"error":[0.1,0.2]}}"#
    );
    assert_eq!(summary, expected);
}

#[test]
fn arrays_and_columns_are_those_that_are_named() {
    let dataset = all(Some(Own { error: vec![0.1, 0.2] })).add_arrays(Dataset::new()).unwrap();
    let told: Vec<_> = dataset
        .variables()
        .iter()
        .map(|own| (own.name.as_str(), own.dimensions.join(" "), own.units.as_str(), own.long_name.as_str()))
        .collect();
    let burst = "burst".to_owned();
    assert_eq!(
        told,
        [
            ("shape", "mode point".to_owned(), "1", "shapes of modes"),
            ("burst_time", burst.clone(), "s", "time of the peak"),
            ("burst_frequency", burst, "Hz", "frequency"),
            ("error", "mode".to_owned(), "s", "how far it is off"),
        ]
    );
    assert_eq!(dataset.attributes()["method"], "film");
    let without = all(None);
    assert!(without.add_arrays(Dataset::new()).unwrap().variable("error").is_none());
    assert_eq!(without.add_columns(Table::new()).unwrap().rows(), 2);
    assert_eq!(Rows::add_columns(&without.bursts[..1], Table::new()).unwrap().rows(), 1);
}

#[test]
fn what_is_declared_is_what_is_told() {
    let number = || ValueKind::Number;
    let key = |name: &str, kind: ValueKind| Declared::new(name, kind);
    let optional = |name: &str, kind: ValueKind| Declared { is_optional: true, ..key(name, kind) };
    let burst = ValueKind::Object(vec![
        key("time_s", number()),
        key("frequency_hz", number()),
        key("word", ValueKind::Word),
    ]);
    let declared = All::declared();
    let expected = [
        key("method", ValueKind::Word),
        key("frequency", number().list()),
        key("bursts", burst.list()),
        optional("ended", ValueKind::Word),
        key("fates", ValueKind::ByName(Box::new(ValueKind::Count))),
        Declared { unit: "s".to_owned(), ..optional("error", number().list()) },
    ];
    assert_eq!(declared, expected);
    let units: Vec<&str> = declared.iter().map(|key| key.unit.as_str()).collect();
    assert_eq!(units, ["", "", "", "", "1", "s"], "as declared, of counts plain, of others unknown");
    assert_eq!(["peak_m", "growth_per_s", "peak"].map(|name| key(name, number()).unit), ["m", "1/s", ""]);
    assert_eq!(All::kind(), ValueKind::Object(declared));
    assert_eq!((true.told(), <[bool; 1]>::kind()), (json!(true), ValueKind::Truth.list()));
}

#[test]
fn settings_leave_out_keys_and_give_names() {
    let left = Declared::without(All::declared(), &["ended", "time_s", "method", "frequency"]);
    let names: Vec<&str> = left.iter().map(|key| key.name.as_str()).collect();
    assert_eq!(names, ["bursts", "fates", "error"]);
    let ValueKind::List(burst) = &left[0].kind else { panic!() };
    let ValueKind::Object(keys) = &**burst else { panic!() };
    assert_eq!(keys.iter().map(|key| key.name.as_str()).collect::<Vec<_>>(), ["frequency_hz", "word"]);
    let named = Declared::named(left, "fates", &["cycle", "lost"]);
    let fates = ["cycle", "lost"].map(|name| Declared::new(name, ValueKind::Count));
    assert_eq!(named[1].kind, ValueKind::Object(fates.to_vec()));
}
