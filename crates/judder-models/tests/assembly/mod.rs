//! Assemblies end to end.

mod chamfers;
mod contributions;
mod cycles;
mod deformed;
mod driven;
mod expressions;
mod interface_modes;
mod interrupted_maps;
mod joined;
mod knocks;
mod marches;
mod meshes;
mod minimal;
mod onsets;
mod printed;
mod responses;
mod sphere;
mod squeal;
mod stored_cycles;
mod turning;

use crate::{case, number, run_into};

/// A pressure of 1 MPa on 50 × 40 mm presses with 2 kN, of which friction drags μ along: all of it, in the table point by point.
#[test]
fn a_pad_carries_its_load_and_says_so_point_by_point() {
    let folder = tempfile::tempdir().unwrap();
    let file = case("assembly/pad-on-disc-strip.toml", &[]);
    let results = run_into(folder.path(), &file, &["steady", "modes"]).summary.results;
    let lining = &results["steady"]["contacts"]["lining"];
    let friction = 0.35 + 0.1 * (-2.0_f64).exp();
    assert!((number(&lining["normal_force"]) - 2000.0).abs() < 1e-6);
    assert!((number(&lining["tangential_force"][0]) - 2000.0 * friction).abs() < 1e-6);
    assert_eq!(
        (number(&lining["points"]), number(&lining["closed"]), number(&lining["open"])),
        (22.0, 22.0, 0.0)
    );
    let table = std::fs::read_to_string(folder.path().join("steady.csv")).unwrap();
    let mut lines = table.lines();
    assert_eq!(
        lines.next().unwrap(),
        "contact,x_m,y_m,z_m,gap_m,normal_force_n,friction_force_n,pressure_pa,state"
    );
    let forces = lines.map(|line| line.split(',').nth(5).unwrap().parse::<f64>().unwrap());
    assert!((forces.sum::<f64>() - 2000.0).abs() < 1e-6);
    // what dampings and contacts add to a growth rate sums to it
    let modes = &results["modes"];
    assert_eq!(modes["complete"], true);
    let growing = modes["growing"].as_array().unwrap();
    assert!(!growing.is_empty());
    for told in growing {
        let mode = number(&told["mode"]) as usize;
        let rate = number(&modes["eigenvalues"][mode - 1]["re"]);
        let sum: f64 = told["growth"].as_object().unwrap().values().map(number).sum();
        assert!((sum - rate).abs() < 1e-4, "{sum} of {rate}");
    }
}

/// A surface in space is drawn by the pressure on its faces, with its unit; what has no partner beside them.
#[test]
fn pressures_on_surfaces_are_drawn_on_their_faces() {
    let folder = tempfile::tempdir().unwrap();
    let far = "structure.pad.block.origin=[\"95 mm\", \"-20 mm\", \"10 mm\"]";
    let file = case("assembly/pad-on-turning-disc.toml", &[&turning::COARSE[..], &[far]].concat());
    let report = run_into(folder.path(), &file, &["steady"]);
    assert!(report.complete, "{:?}", report.messages);
    let picture = std::fs::read_to_string(folder.path().join("figures/steady.svg")).unwrap();
    for expected in ["<image", "Pressure", "no partner"] {
        assert!(picture.contains(expected), "{expected}");
    }
}

/// With ever more fixed-interface modes the eigenvalues of a reduced block come to those of the whole one.
#[test]
fn reduced_blocks_come_to_the_whole_one() {
    let growth = |reduction: &str| {
        let folder = tempfile::tempdir().unwrap();
        let reduction = format!("structure.block.reduction={reduction}");
        let file = case("assembly/block-on-plane.toml", &[&reduction, "analysis.modes.count=4"]);
        let results = run_into(folder.path(), &file, &["modes"]).summary.results;
        number(&results["modes"]["eigenvalues"][0]["im"])
    };
    let whole = growth("\"none\"");
    let off = |count: usize| (growth(&format!("{{ count = {count} }}")) - whole).abs() / whole;
    let (few, many) = (off(4), off(40));
    assert!(many < 1e-4 && many < 0.1 * few, "{few} {many}");
}
