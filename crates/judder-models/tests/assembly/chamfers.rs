//! Chamfered pads: what is left of their contact, and what a chamfer does to a mode that grows.

use crate::{number, run_into};

/// A stiff pad whose back is loaded evenly; at its leading edge 3 of 20 mm are cut off, at its trailing edge 2 mm.
const PAD: &str = r#"
model = "assembly"
[[structure]]
name = "pad"
block = { element = "quad4", size = ["20 mm", "10 mm"], cells = [10, 4], chamfer = { face = "y-min", x-min = { length = "3 mm", depth = "6 um", cells = 2 }, x-max = { length = "2 mm", depth = "1 mm", cells = 1 } } }
section = "plane-strain"
width = "10 mm"
material = { youngs_modulus = "200 GPa", poisson_ratio = 0.3, density = "7800 kg/m^3" }
supports = [{ set = "x-max-y-max", fixed = ["x"] }]
[[contact]]
name = "face"
slider = { structure = "pad", set = "y-min" }
track = { plane = { normal = [0, 1] } }
sliding = { velocity = "1 m/s", direction = [1, 0] }
normal = { stiffness = "3e11 N/m^3" }
friction_coefficient = 0.0
[[load]]
structure = "pad"
set = "y-max"
pressure = "1 MPa"
[[analysis]]
name = "steady"
kind = "steady-sliding"
"#;

/// The columns of the contact points of a contact: x, gap, force, pressure.
fn points(text: &str, contact: &str) -> Vec<[f64; 4]> {
    let folder = tempfile::tempdir().unwrap();
    let file = judder_models::parse("case.toml", text, &[]).unwrap();
    let report = run_into(folder.path(), &file, &["steady"]);
    assert!(report.complete, "{:?}", report.messages);
    let table = std::fs::read_to_string(folder.path().join("steady.csv")).unwrap();
    let rows = table.lines().skip(1).map(|line| line.split(',').collect::<Vec<_>>());
    let of_contact = rows.filter(|row| row[0] == contact);
    of_contact.map(|row| [1, 4, 5, 7].map(|column| row[column].parse().unwrap())).collect()
}

/// The load is carried by what the chamfers leave of the face, point by point on its own area, between their edges.
#[test]
fn a_chamfered_pad_presses_on_what_its_chamfers_leave() {
    let found = points(PAD, "face");
    assert_eq!(found.len(), 10 - 3 + 1);
    assert!((found[0][0] - 3e-3).abs() < 1e-12 && (found[7][0] - 18e-3).abs() < 1e-12, "{found:?}");
    let force: f64 = found.iter().map(|[_, _, force, _]| force).sum();
    assert!((force - 200.0).abs() < 1e-6, "{force}");
    let area: f64 = found.iter().map(|[_, _, force, pressure]| force / pressure).sum();
    assert!((area - 15e-3 * 10e-3).abs() < 1e-13, "{area}");
    // in the middle of the load, and not of what is left of the face
    let mean: f64 = found.iter().map(|[x, _, force, _]| x * force).sum::<f64>() / force;
    assert!((mean - 10e-3).abs() < 1e-8, "{mean}");
}

/// With its flanks the face is a set of its own, whose contact begins with the gaps as meshed: a shallow flank closes under load, a deep one does not.
#[test]
fn flanks_that_touch_are_in_contact_with_the_whole_face() {
    let text = PAD.replace(
        "slider = { structure = \"pad\", set = \"y-min\" }",
        "slider = { structure = \"pad\", set = \"y-min-whole\" }",
    );
    let found = points(&text, "face");
    assert_eq!(found.len(), 11);
    // from the edge of the face on the flank rises by 3 µm a cell
    let rises = [found[0][1] - found[1][1], found[1][1] - found[2][1]];
    assert!(rises.iter().all(|own| (own / 3e-6 - 1.0).abs() < 0.1), "{found:?}");
    let closed = |points: &[[f64; 4]]| points[..3].iter().filter(|[_, _, force, _]| *force > 0.0).count();
    assert_eq!(closed(&found), 2, "{found:?}");
    let deep = points(&text.replace("6 um", "1 mm"), "face");
    assert_eq!(closed(&deep), 1, "{deep:?}");
}

/// The derivative of the growth rate by a chamfer is that of whole solutions with other chamfers, of steps that differ.
#[test]
fn what_a_chamfer_does_to_a_mode_is_told() {
    let text = include_str!("../small/assembly-cycle.toml").replace(
        "cells = [4, 2] }",
        "cells = [6, 3], chamfer = { face = \"y-min\", x-min = { length = \"3 mm\", depth = \"1 mm\", cells = 1 } } }",
    );
    let chamfer = "structure.foot.block.chamfer.x-min";
    let cures = format!("cures = [\"{chamfer}.length\", \"{chamfer}.depth\"]");
    let modes = "\n[[analysis]]\nname = \"modes\"\nkind = \"eigen\"\nband = [\"1 kHz\", \"8 kHz\"]\n";
    let line = text.lines().find(|line| line.starts_with("cures")).unwrap().to_owned();
    let knocks = text.lines().find(|line| line.starts_with("knocks")).unwrap().to_owned();
    let margin = text.lines().find(|line| line.starts_with("margin =")).unwrap().to_owned();
    let margins = text.lines().find(|line| line.starts_with("margin_harmonics")).unwrap().to_owned();
    let mut text = text.replace(&line, &cures) + modes;
    for own in [knocks, margin, margins] {
        text = text.replace(&format!("{own}\n"), "");
    }
    let growing = |set: &[String]| {
        let file = judder_models::parse("case.toml", &text, set).unwrap();
        let report = run_into(tempfile::tempdir().unwrap().path(), &file, &["modes"]);
        let values = report.summary.results["modes"]["eigenvalues"].as_array().unwrap().clone();
        values.iter().map(|own| [number(&own["re"]), number(&own["im"])]).collect::<Vec<_>>()
    };
    let file = judder_models::parse("case.toml", &text, &[]).unwrap();
    let report = run_into(tempfile::tempdir().unwrap().path(), &file, &["squeal"]);
    let told = &report.summary.results["squeal"]["cures"];
    let frequency = std::f64::consts::TAU * number(&told["frequency_hz"]);
    // of the same mode
    let growth = |key: &str, value: f64| {
        let values = growing(&[format!("{chamfer}.{key}=\"{value} mm\"")]);
        let nearest =
            values.into_iter().min_by(|a, b| (a[1] - frequency).abs().total_cmp(&(b[1] - frequency).abs()));
        nearest.unwrap()[0]
    };
    let keys = told["keys"].as_array().unwrap();
    assert_eq!(keys.len(), 2, "{told:?}");
    assert!(keys.iter().any(|own| own["growth_rate_at_change"].is_f64()), "{told:?}");
    for (key, value) in [("length", 3.0_f64), ("depth", 1.0)] {
        let own = keys.iter().find(|own| own["key"] == format!("{chamfer}.{key}")).unwrap();
        assert_eq!(own["smooth"], true, "{own}");
        // what the change does is what a whole solution with it has
        if let (Some(change), Some(found)) = (own["change"].as_f64(), own["growth_rate_at_change"].as_f64()) {
            let values = growing(&[format!("{chamfer}.{key}=\"{:?} mm\"", value * (1.0 + change))]);
            assert!(
                values.iter().any(|other| (other[0] - found).abs() < 1e-5 * found.abs()),
                "{own} {values:?}"
            );
        }
        let by_change = |step: f64| {
            (growth(key, value * (1.0 + step)) - growth(key, value * (1.0 - step))) / (2.0 * step)
        };
        let told = number(&own["growth_by_change"]);
        for (step, bar) in [(0.02, 1e-2), (5e-3, 1e-3)] {
            assert!((told / by_change(step) - 1.0).abs() < bar, "{own} {} {step}", by_change(step));
        }
    }
}
