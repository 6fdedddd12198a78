//! Meshes.

use super::{each_cut, written};
use crate::file;
use judder_exchange::FilePlace;
use judder_exchange::mesh_file::read_mesh;
use std::fs;

fn message(name: &str, content: impl AsRef<[u8]>) -> String {
    let (folder, path) = written(name, content);
    let said = read_mesh(&path).unwrap_err().to_string();
    said.replace(&format!("{}/", folder.path().display()), "")
}

fn sample(name: &str) -> Vec<u8> {
    fs::read(file("validation/meshes").join(name)).unwrap()
}

/// A text sample with the first of these words replaced.
fn replaced(name: &str, from: &str, to: &str) -> String {
    let text = String::from_utf8(sample(name)).unwrap();
    assert!(text.contains(from), "{from}");
    text.replacen(from, to, 1)
}

#[test]
fn meshes_of_gmsh_that_are_cut_are_refused_with_their_place() {
    for (name, is_text) in [
        ("quad4.msh", true),
        ("quad8_binary.msh", false),
        ("two_groups_22.msh", true),
        ("two_groups_22_binary.msh", false),
    ] {
        let whole = sample(name);
        // the last end of a line may be missing
        each_cut(name, &whole, 0..whole.len() - 1, |length, path| {
            let error = read_mesh(path).unwrap_err();
            let placed = matches!(error.place(), FilePlace::Line(_)) || !is_text;
            assert!(placed || error.to_string().contains("no elements"), "{length}: {error}");
        });
    }
}

#[test]
fn wrong_and_huge_counts_of_gmsh_are_refused() {
    let quad4 = |from, to| message("a.msh", replaced("quad4.msh", from, to));
    let (nodes, elements) = ("$Nodes\n9 15 1 15", "$Elements\n5 20 1 20");
    assert!(quad4(nodes, "$Nodes\n9 16 1 15").contains("says 16 nodes, holds 15"));
    assert!(quad4(elements, "$Elements\n5 21 1 20").contains("says 21 elements, holds 20"));
    let huge = quad4(elements, "$Elements\n5 9999999999 1 20");
    assert!(huge.contains("says 9999999999 elements") && huge.starts_with("a.msh: line "), "{huge}");
    assert!(quad4(nodes, "$Nodes\n18446744073709551615 15 1 15").contains("blocks of nodes"));
    assert!(quad4("$PhysicalNames\n5", "$PhysicalNames\n99").contains("says 99 physical names, holds 5"));
    assert!(
        quad4("$Entities\n5 4 1 0", "$Entities\n5 4 18446744073709551615 0")
            .contains("says 18446744073709551615 entities")
    );
}

#[test]
fn other_versions_and_forms_of_gmsh_are_refused_with_a_remedy() {
    let format = |line: &str| message("a.msh", replaced("quad4.msh", "4.1 0 8", line));
    assert!(format("2.0 0 8").contains(
        "line 2: is no mesh of Gmsh's format 4.1 or 2.2: its version is 2.0; save it anew with `gmsh"
    ));
    assert!(format("4.1 1 4").contains("its format line is `4.1 1 4`"));
    assert!(message("a.msh", "").contains("its first line is ``"));
    assert!(message("a.msh", "*NODE\n").contains("its first line is `*NODE`"));
    assert!(message("a.msh", sample("quad4.msh").split_off(6)).contains("its first line is"));
    assert!(message("a.stl", "").contains("there are .msh"));
}

#[test]
fn what_is_twice_or_not_there_or_no_number_is_named_in_gmsh() {
    let quad4 = |from, to| message("a.msh", replaced("quad4.msh", from, to));
    let twice = quad4("0 3 0 1\n2\n", "0 3 0 1\n1\n");
    assert!(twice.contains("node 1 is there twice"), "{twice}");
    let nan = quad4("0 3 0 1\n2\n2 0 0", "0 3 0 1\n2\nnan 0 0");
    assert!(nan.contains("`nan` is no finite number"), "{nan}");
    let linear = message("a.msh", LINEAR_TETRAHEDRON);
    assert!(
        linear.contains("the type of elements is 4") && linear.contains("Mesh.ElementOrder = 2"),
        "{linear}"
    );
    let unknown = message("a.msh", LINEAR_TETRAHEDRON.replace("1 1 2 3 4\n", "1 1 2 3 9\n"));
    assert!(unknown.contains("line 19: there is no node 9"), "{unknown}");
}

const LINEAR_TETRAHEDRON: &str = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n\
     0 0 1\n$EndNodes\n$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 3 4\n$EndElements\n";

#[test]
fn decks_that_are_no_mesh_are_refused_with_their_line() {
    let pad = |from, to| message("a.inp", replaced("pad.inp", from, to));
    assert_eq!(pad("1,  1,  2, 12, 11", "1,  1,  2, 12, 44"), "a.inp: line 14: there is no node 44");
    assert!(
        pad("1,  1,  2, 12, 11", "1,  1,  2, 12")
            .starts_with("a.inp: line 14: a four-node quadrilateral takes 4 nodes, found are 3")
    );
    assert!(
        pad("5,  2,  3, 13, 12", "1,  2,  3, 13, 12")
            .starts_with("a.inp: line 15: element 1 is there twice, first in line 14")
    );
    assert!(
        pad("      2,           1.", "      1,           1.")
            .starts_with("a.inp: line 7: node 1 is there twice, first at")
    );
    assert!(
        pad("2,           1.", "2,  NaN").contains("line 7: `NaN` is no finite number (a place of a node)")
    );
    assert!(
        pad(" 1, 3, 1", " 1, 18446744073709551615, 1")
            .contains("line 17: says 18446744073709551615 node, holds 7")
    );
    assert!(pad(" 1, 3, 1", " 3, 1, 1").contains("it goes from 3 to 1"));
    assert!(pad(" 1, 3, 1", " 1, 3, 0").contains("`0` is no whole number from 1 on (a step)"));
    assert!(pad("CPS4I", "S4R").contains("line 13: the type of elements is `S4R`; read is CPS4"));
    assert!(pad("CPS4I", "C3D8").contains("a eight-node brick takes 8 nodes"));
    assert!(pad("_Rim_S2, S2", "_Rim_S2, S5").contains("has the sides S1 to S4, not S5"));
    assert!(pad("_Rim_S2, S2", "_Rim_S2, SPOS").contains("the side of a surface is `SPOS`"));
    assert!(pad("material=STEEL", "material=Copper").contains("there is no material Copper"));
    assert!(
        pad("elset=PLATE, material", "elset=Lining, material")
            .contains("the section of element 1 is there twice")
    );
    assert!(pad("elset=PLATE, material", "elset=Plates, material").contains("there is no set Plates"));
    assert!(pad("2.1D11, 0.3", "2.1D11, 0.5").contains("Poisson's ratio is 0.5"));
    assert!(pad("2.1D11, 0.3", "2.1D11, 0.3\n2.0D11, 0.3, 100.").contains("takes one line, found are 2"));
    assert!(pad("type=ISOTROPIC", "type=ORTHOTROPIC").contains("not isotropic"));
    assert!(pad("0.01,", "-0.01,").contains("must be positive"));
}

#[test]
fn keywords_that_change_the_meaning_are_refused() {
    for (keyword, word) in [
        ("*Include, input=other.inp", "takes in another file"),
        ("*Tie, name=a", "ties displacements together"),
        ("*Equation", "ties displacements together"),
        ("*Nfill", "makes or moves nodes"),
        ("*Beam Section, elset=a", "no counterpart"),
        ("*Hyperelastic", "not isotropic"),
        ("*Part, name=Second", "several parts"),
        ("*Node, system=C", "not rectangular"),
        ("*Node, input=nodes.txt", "in another file"),
        ("*Elset", "needs the parameter ELSET"),
        ("*Surface, name=s, type=CYLINDER", "the type of the surface is `CYLINDER`"),
    ] {
        let said = message("a.inp", replaced("pad.inp", "*Assembly, name=Assembly", keyword));
        assert!(said.starts_with("a.inp: line 29: ") && said.contains(word), "{keyword}: {said}");
    }
    let moved = replaced("pad.inp", "part=Pad\n*End", "part=Pad\n1., 0., 0.\n*End");
    assert!(message("a.inp", moved).contains("or one that is moved"));
}

#[test]
fn decks_of_nothing_and_of_bytes_are_refused() {
    assert!(message("a.inp", "").contains("it has no keywords"));
    assert!(message("a.inp", "1, 2\n").contains("line 1: is no input deck"));
    assert!(message("a.inp", sample("quad8_binary.msh")).contains("a.inp: line"));
    assert_eq!(message("a.inp", "*NODE\n1, 0, 0\n"), "a.inp: has no elements of the plane or of space");
    assert!(message("a.inp", "*NODE\n1\n").contains("a node takes its number and its place"));
    let off = replaced("pad.inp", "12,           1.,           1.", "12, 1., 1., 0.5");
    assert_eq!(
        message("a.inp", off),
        "a.inp: node 12 lies at z = 0.5; a mesh of the plane has all its nodes at z = 0"
    );
}

/// Sets that name sets could fill any memory.
#[test]
fn sets_cannot_grow_without_end() {
    let mut deck = replaced("pad.inp", "*End Assembly", "*End Assembly\n*Nset, nset=s0\n 1, 2, 3\n@");
    let growing: String =
        (0..60).map(|k| format!("*Nset, nset=s{}\n s{k}, s{k}, s{k}, s{k}\n", k + 1)).collect();
    deck = deck.replacen('@', &growing, 1);
    let said = message("a.inp", deck);
    assert!(said.contains("do sets name each other again and again?"), "{said}");
}
