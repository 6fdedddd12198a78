//! A user's own meshes of Gmsh, in millimetres.

use super::minimal::results;
use crate::{number, run_into};
use judder_study::case::file::CaseFile;
use std::fmt::Write;
use std::path::Path;

/// The pad on a strip, whose bodies are blocks.
const PAD: &str = include_str!("../../../../cases/assembly/pad-on-disc-strip.toml");

/// A rectangle of equal cells as a mesh of Gmsh 4.1, lengths in millimetres, its sides named as those of a block.
fn written(size: [f64; 2], cells: [usize; 2], origin: [f64; 2]) -> String {
    let [columns, rows] = cells.map(|cells| cells + 1);
    let node = |column: usize, row: usize| 1 + row * columns + column;
    let mut text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n5\n1 1 \"y-min\"\n1 2 \"x-max\"\n1 3 \"y-max\"\n\
        1 4 \"x-min\"\n2 5 \"body\"\n$EndPhysicalNames\n$Entities\n0 4 1 0\n"
        .to_owned();
    let [x, y] = [0, 1].map(|axis| [origin[axis], origin[axis] + size[axis]]);
    let sides = [[x, [y[0]; 2]], [[x[1]; 2], y], [x, [y[1]; 2]], [[x[0]; 2], y]];
    for (k, [[x0, x1], [y0, y1]]) in sides.iter().enumerate() {
        writeln!(text, "{tag} {x0} {y0} 0 {x1} {y1} 0 1 {tag} 0", tag = k + 1).unwrap();
    }
    writeln!(text, "1 {} {} 0 {} {} 0 1 5 4 1 2 3 4\n$EndEntities", x[0], y[0], x[1], y[1]).unwrap();
    let count = columns * rows;
    writeln!(text, "$Nodes\n1 {count} 1 {count}\n2 1 0 {count}").unwrap();
    (1..=count).for_each(|tag| writeln!(text, "{tag}").unwrap());
    for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
        let place = |axis: usize, own: usize| origin[axis] + size[axis] * own as f64 / cells[axis] as f64;
        writeln!(text, "{} {} 0", place(0, column), place(1, row)).unwrap();
    }
    let along: Vec<[usize; 2]> = (0..cells[0]).map(|k| [k, k + 1]).collect();
    let up: Vec<[usize; 2]> = (0..cells[1]).map(|k| [k, k + 1]).collect();
    let edges = |ends: &[[usize; 2]], of: &dyn Fn(usize) -> usize| {
        ends.iter().map(|pair| pair.map(of).to_vec()).collect::<Vec<_>>()
    };
    let quads = (0..cells[1]).flat_map(|row| (0..cells[0]).map(move |column| (column, row)));
    let quads = quads.map(|(c, r)| vec![node(c, r), node(c + 1, r), node(c + 1, r + 1), node(c, r + 1)]);
    let blocks = [
        (1, 1, 1, edges(&along, &|k| node(k, 0))),
        (1, 2, 1, edges(&up, &|k| node(columns - 1, k))),
        (1, 3, 1, edges(&along, &|k| node(k, rows - 1))),
        (1, 4, 1, edges(&up, &|k| node(0, k))),
        (2, 1, 3, quads.collect()),
    ];
    let all: usize = blocks.iter().map(|(.., own)| own.len()).sum();
    writeln!(text, "$EndNodes\n$Elements\n5 {all} 1 {all}").unwrap();
    let mut tag = 0;
    for (dimension, entity, kind, own) in &blocks {
        writeln!(text, "{dimension} {entity} {kind} {}", own.len()).unwrap();
        for nodes in own {
            tag += 1;
            let nodes: Vec<String> = nodes.iter().map(usize::to_string).collect();
            writeln!(text, "{tag} {}", nodes.join(" ")).unwrap();
        }
    }
    text + "$EndElements\n"
}

/// The pad and the strip as mesh files in a folder; `unit` is what each mesh says of its lengths.
fn meshed(folder: &Path, unit: &str) -> CaseFile {
    std::fs::write(folder.join("strip.msh"), written([120.0, 8.0], [60, 3], [0.0; 2])).unwrap();
    std::fs::write(folder.join("pad.msh"), written([50.0, 12.0], [21, 5], [35.0, 8.0])).unwrap();
    let mut lines: Vec<String> = PAD.lines().map(str::to_owned).collect();
    for (k, name) in ["strip", "pad"].iter().enumerate() {
        let blocks: Vec<usize> = (0..lines.len()).filter(|l| lines[*l].starts_with("block = ")).collect();
        assert_eq!(blocks.len(), 2 - k);
        lines[blocks[0]] = format!("mesh = \"{name}.msh\"{unit}");
    }
    let path = folder.join("case.toml");
    std::fs::write(&path, lines.join("\n")).unwrap();
    judder_models::read(path, &[]).unwrap()
}

/// Meshes in millimetres have the forces and the modes of blocks of the same cells.
#[test]
fn meshes_in_millimetres_are_the_blocks_that_they_mesh() {
    let folder = tempfile::tempdir().unwrap();
    let [own, blocks] = [
        results(&meshed(folder.path(), "\nunit = \"mm\"")),
        results(&crate::case("assembly/pad-on-disc-strip.toml", &[])),
    ];
    let [a, b] = [&own, &blocks].map(|of| &of["steady"]["contacts"]["lining"]);
    assert_eq!((a["points"].as_u64(), a["closed"].as_u64()), (Some(22), b["closed"].as_u64()));
    for key in ["normal_force", "pressure_max"] {
        assert!((number(&a[key]) / number(&b[key]) - 1.0).abs() < 1e-9, "{a} {b}");
    }
    let [a, b] = [&own, &blocks].map(|of| of["modes"]["eigenvalues"].as_array().unwrap());
    assert!(a.len() == b.len() && a.len() > 3);
    for (a, b) in a.iter().zip(b) {
        let off = (number(&a["re"]) - number(&b["re"])).hypot(number(&a["im"]) - number(&b["im"]));
        assert!(off < 1e-8 * number(&b["im"]), "{a} {b}");
    }
}

/// Without its unit a strip of 120 mm is one of 120 m, and a pad of 50 mm one of 50 m: both are doubted, with the remedy.
#[test]
fn a_forgotten_unit_of_a_mesh_is_doubted() {
    let folder = tempfile::tempdir().unwrap();
    let file = meshed(folder.path(), "");
    let out = tempfile::tempdir().unwrap();
    let messages = run_into(out.path(), &file, &["steady"]).messages.join("\n");
    for doubt in ["`strip` is 120 m long", "`pad` is 50 m long"] {
        let expected = format!("{doubt}: is its mesh in another unit of length? unit = \"mm\" says so");
        assert!(messages.contains(&expected), "{messages}");
    }
}
