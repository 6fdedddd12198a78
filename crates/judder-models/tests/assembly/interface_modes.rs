//! Bodies whose contact freedoms are reduced to interface modes.

use crate::{case, number, run_into};
use serde_json::Value;

/// Steady sliding and modes of the pad on the strip, both reduced to 40 fixed-interface modes and some interface modes.
fn reduced(interface_modes: Option<usize>) -> [Value; 2] {
    let interface = interface_modes.map_or(String::new(), |count| format!(", interface_modes = {count}"));
    let of = |body: &str| format!("structure.{body}.reduction={{ count = 40{interface} }}");
    let (pad, strip) = (of("pad"), of("strip"));
    let folder = tempfile::tempdir().unwrap();
    let file = case("assembly/pad-on-disc-strip.toml", &[&pad, &strip]);
    let results = run_into(folder.path(), &file, &["steady", "modes"]).summary.results;
    ["steady", "modes"].map(|name| Value::Object(results[name].clone()))
}

fn frequencies(modes: &Value) -> Vec<f64> {
    let all = modes["eigenvalues"].as_array().unwrap();
    all.iter().map(|own| number(&own["im"])).collect()
}

/// The error that is told is that of the frequencies and forces, it falls with more modes, and with all of them nothing is left of it.
#[test]
fn interface_modes_tell_their_error() {
    let [steady, modes] = reduced(None);
    assert!(steady.get("interface_modes_error").is_none() && modes.get("interface_modes_error").is_none());
    let exact = frequencies(&modes);
    let mut before = [f64::INFINITY; 2];
    for count in [12, 24, 200] {
        let [steady, modes] = reduced(Some(count));
        let told = [&steady, &modes].map(|own| number(&own["interface_modes_error"]));
        assert!(told[0] < before[0] && told[1] < before[1], "{count}: {told:?} {before:?}");
        let off =
            frequencies(&modes).iter().zip(&exact).map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max);
        assert!(off < 1.1 * told[1] + 1e-9, "{count}: {off} {told:?}");
        // the load is carried whatever the modes are
        let carried = number(&steady["contacts"]["lining"]["normal_force"]);
        assert!((carried / 2000.0 - 1.0).abs() < 0.05, "{carried}");
        before = told;
    }
    assert!(before[0] < 1e-7 && before[1] < 1e-7, "{before:?}");
}
