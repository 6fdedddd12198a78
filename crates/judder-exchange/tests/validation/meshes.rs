//! Meshes of Gmsh (`meshes/write.py`) and decks, by volumes, masses and places.

use crate::file;
use judder_exchange::mesh_file::{MeshFile, UNNAMED, Units, read_mesh};
use judder_structure::assembly::assemble;
use judder_structure::element::ElementKind;
use judder_structure::freedom::{Direction, Numbering, Supports};
use judder_structure::material::{Elastic, ElementSection};
use judder_structure::mesh::Mesh;
use std::collections::BTreeMap;
use std::f64::consts::PI;

fn read(name: &str) -> MeshFile {
    read_mesh(&file("validation/meshes").join(name)).unwrap()
}

/// The mass of a mesh: that of a rigid motion along x. It needs all nodes of all elements in their order.
fn mass(mesh: &Mesh, materials: &BTreeMap<String, (Elastic, ElementSection)>) -> f64 {
    let dimension = mesh.blocks[0].kind.dimension();
    let numbering = Numbering::new(mesh, dimension, &Supports::default()).unwrap();
    let mass = assemble(mesh, materials, &numbering).unwrap().mass;
    let along: Vec<usize> =
        (0..mesh.nodes.len()).filter_map(|node| numbering.number(node, Direction::X)).collect();
    along.iter().flat_map(|i| along.iter().map(|j| mass.get(*i, *j).copied().unwrap_or(0.0))).sum()
}

/// Area or volume of a mesh.
fn content(file: &MeshFile) -> f64 {
    let section = if file.dimension() == 2 {
        ElementSection::PlaneStrain { thickness: 1.0 }
    } else {
        ElementSection::Solid
    };
    let elastic = Elastic::new(1.0, 0.3, 1.0).unwrap();
    let names = file.mesh.blocks.iter().map(|block| (block.material.clone(), (elastic, section)));
    mass(&file.mesh, &names.collect())
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() < tolerance * expected.abs(), "{found} is not {expected}");
}

/// Three quarters of π is the ring's area; straight edges miss some of it.
#[test]
fn a_ring_of_gmsh_has_its_area_and_its_edges() {
    // four chords of a quarter circle of radius r enclose 2 r² sin(π/8)
    let straight = 2.0 * (4.0 - 1.0) * (PI / 8.0).sin();
    for (name, kind, elements, area, tolerance) in [
        ("quad4.msh", ElementKind::Quad4, 8, straight, 1e-12),
        ("quad8.msh", ElementKind::Quad8, 8, 0.75 * PI, 2e-4),
        ("quad8_binary.msh", ElementKind::Quad8, 8, 0.75 * PI, 2e-4),
        ("quad8_22.msh", ElementKind::Quad8, 8, 0.75 * PI, 2e-4),
        ("quad8_22_binary.msh", ElementKind::Quad8, 8, 0.75 * PI, 2e-4),
        ("triangle6.msh", ElementKind::Triangle6, 16, 0.75 * PI, 2e-4),
    ] {
        let file = read(name);
        assert_eq!(file.mesh.blocks.len(), 1, "{name}");
        let block = &file.mesh.blocks[0];
        assert_eq!((block.kind, block.material.as_str(), file.mesh.elements()), (kind, "ring", elements));
        assert_eq!(file.mesh.element_sets["ring"].len(), elements);
        close(content(&file), area, tolerance);
        for (set, radius) in [("inner", 1.0), ("outer", 2.0)] {
            let nodes = &file.mesh.node_sets[set];
            assert_eq!(nodes.len(), if kind == ElementKind::Quad4 { 5 } else { 9 }, "{name} {set}");
            let places = nodes.iter().map(|node| file.mesh.nodes[*node]);
            places.clone().for_each(|[x, y, _]| close(x.hypot(y), radius, 1e-12));
            let angles: Vec<f64> = places.map(|[x, y, _]| y.atan2(x)).collect();
            let order = (angles[1] - angles[0]).signum();
            assert!(
                angles.windows(2).all(|pair| (pair[1] - pair[0]) * order > 0.0),
                "{name} {set}: {angles:?}"
            );
            assert_eq!(file.mesh.side_sets[set].len(), 4, "{name} {set}");
        }
        let start = file.nodes_of("start").unwrap();
        assert!(start.iter().all(|node| file.mesh.nodes[*node][1].abs() < 1e-12));
    }
}

#[test]
fn text_and_binary_are_the_same_mesh() {
    for name in ["quad8", "hexahedron20", "quad8_22", "two_groups_22"] {
        same(&read(&format!("{name}.msh")), read(&format!("{name}_binary.msh")));
    }
}

/// Texts hold sixteen digits.
fn same(text: &MeshFile, mut other: MeshFile) {
    assert_eq!(text.mesh.nodes.len(), other.mesh.nodes.len());
    for (place, other) in text.mesh.nodes.iter().zip(&mut other.mesh.nodes) {
        assert!((0..3).all(|axis| (place[axis] - other[axis]).abs() < 1e-14));
        *other = *place;
    }
    assert_eq!(*text, other);
}

/// The format 2.2 has no entities: an element of two groups stands there twice, and would have twice its mass.
#[test]
fn both_formats_of_gmsh_are_the_same_mesh() {
    for (name, elements) in [("quad8", 8), ("tetrahedron10", 12), ("two_groups", 8)] {
        let (four, mut two) = (read(&format!("{name}.msh")), read(&format!("{name}_22.msh")));
        assert_eq!(two.mesh.elements(), elements, "{name}");
        close(content(&two), content(&four), 1e-14);
        // elements are numbered anew in files of format 2.2
        two.element_labels.clone_from(&four.element_labels);
        same(&four, two);
    }
    let both = read("two_groups_22.msh");
    assert_eq!(both.mesh.element_sets["all"], both.mesh.element_sets["ring"]);
    assert_eq!(both.mesh.side_sets["rim"], both.mesh.side_sets["outer"]);
}

/// Middles of edges in the wrong order would change the volume or fold the elements.
#[test]
fn a_box_of_gmsh_has_its_volume_and_its_faces() {
    for (name, kind) in [
        ("hexahedron8.msh", ElementKind::Hexahedron8),
        ("hexahedron20.msh", ElementKind::Hexahedron20),
        ("hexahedron20_binary.msh", ElementKind::Hexahedron20),
        ("hexahedron20_22_binary.msh", ElementKind::Hexahedron20),
        ("tetrahedron10.msh", ElementKind::Tetrahedron10),
        ("tetrahedron10_22.msh", ElementKind::Tetrahedron10),
    ] {
        let file = read(name);
        assert_eq!((file.mesh.blocks.len(), file.mesh.blocks[0].kind), (1, kind));
        assert_eq!(file.mesh.blocks[0].material, "volume-7");
        close(content(&file), 6.0, 1e-12);
        middles_are_in_the_middle(&file.mesh);
        for (set, x) in [("left", 0.0), ("right", 3.0)] {
            let of_sides: BTreeMap<String, _> =
                [(String::from(set), file.mesh.side_sets[set].clone())].into();
            let only_sides = MeshFile {
                mesh: Mesh { node_sets: BTreeMap::new(), side_sets: of_sides, ..file.mesh.clone() },
                ..MeshFile::default()
            };
            let nodes = only_sides.nodes_of(set).unwrap();
            assert_eq!(nodes, file.mesh.node_sets[set], "{name} {set}");
            assert!(nodes.iter().all(|node| file.mesh.nodes[*node][0] == x), "{name} {set}");
            let there = file.mesh.nodes.iter().filter(|place| place[0] == x).count();
            assert_eq!(nodes.len(), there, "{name} {set}");
        }
        let corner = &file.mesh.node_sets["corner"];
        assert_eq!(corner.iter().map(|node| file.mesh.nodes[*node]).collect::<Vec<_>>(), [[0.0; 3]]);
        let edge = file.mesh.node_sets["edge"].iter().map(|node| file.mesh.nodes[*node][0]);
        assert!(edge.collect::<Vec<f64>>().is_sorted());
    }
}

/// Gmsh divides curves to this accuracy.
const GMSH: f64 = 1e-10;

/// In meshes with straight edges.
fn middles_are_in_the_middle(mesh: &Mesh) {
    for block in &mesh.blocks {
        let places = block.kind.node_places();
        let corners = if block.kind == ElementKind::Tetrahedron10 { 4 } else { 8 };
        for own in block.connectivity.chunks(block.kind.nodes()) {
            for (k, middle) in places.iter().enumerate().skip(corners) {
                let is_between = |(a, b): &(usize, usize)| {
                    (0..3).all(|axis| 0.5 * (places[*a][axis] + places[*b][axis]) == middle[axis])
                };
                let mut pairs = (0..corners).flat_map(|a| (a + 1..corners).map(move |b| (a, b)));
                let (a, b) = pairs.find(is_between).unwrap();
                let (p, q, m) = (mesh.nodes[own[a]], mesh.nodes[own[b]], mesh.nodes[own[k]]);
                assert!((0..3).all(|axis| (0.5 * (p[axis] + q[axis]) - m[axis]).abs() < GMSH));
            }
        }
    }
}

#[test]
fn a_deck_of_abaqus_has_its_sections_and_sets() {
    let file = read("pad.inp");
    let names: Vec<&str> = file.mesh.blocks.iter().map(|block| block.material.as_str()).collect();
    assert_eq!(names, ["Lining", "Plate"]);
    assert_eq!(file.node_labels, [1, 2, 3, 11, 12, 13]);
    assert_eq!(file.element_labels, [1, 5]);
    let materials = file.materials_of_blocks().unwrap();
    assert_eq!(materials["Plate"].0, Elastic::new(2.1e11, 0.3, 7800.0).unwrap());
    assert_eq!(materials["Plate"].1, ElementSection::PlaneStress { thickness: 0.01 });
    assert_eq!(materials["Lining"].1, ElementSection::PlaneStress { thickness: 0.02 });
    close(mass(&file.mesh, &materials), 2500.0 * 0.02 + 7800.0 * 0.01, 1e-12);
    assert_eq!(file.mesh.node_sets["Bottom"], [0, 1, 2]);
    assert_eq!(file.mesh.node_sets["Both"], [0, 1, 2, 5, 4, 3]);
    assert_eq!(file.nodes_of("Rim").unwrap(), [0, 2, 3, 5]);
    assert_eq!(file.nodes_of("Plate").unwrap(), [1, 2, 4, 5]);
    assert_eq!(file.nodes_of("bottom"), None);
    let warnings: Vec<String> = file.warnings.iter().map(ToString::to_string).collect();
    assert!(warnings[0].ends_with("*EXPANSION is passed over"), "{warnings:?}");
    assert!(warnings[1].contains("*STEP is passed over"), "{warnings:?}");
    assert!(warnings[2].contains("the first is 99"), "{warnings:?}");
    assert_eq!(warnings.len(), 3, "{warnings:?}");
}

#[test]
fn a_deck_of_calculix_has_its_brick() {
    let file = read("block.inp");
    close(mass(&file.mesh, &file.materials_of_blocks().unwrap()), 2.0 * 7800.0, 1e-12);
    middles_are_in_the_middle(&file.mesh);
    assert_eq!(file.mesh.node_sets["OfElements"].len(), 20);
    // S4 is 2 6 7 3: the face at x = 2
    let face = file.nodes_of("Face").unwrap();
    assert_eq!(face.len(), 8);
    assert!(face.iter().all(|node| file.mesh.nodes[*node][0] == 2.0));
    assert!(file.warnings[0].to_string().contains("full integration"));
    assert_ne!(file.mesh.blocks[0].material, UNNAMED);
}

/// In mm, t and s a mass is a thousand times its number, a modulus a million times.
#[test]
fn units_are_turned_into_si() {
    let file = read("pad.inp");
    let before = mass(&file.mesh, &file.materials_of_blocks().unwrap());
    let si = file.in_si(Units::MILLIMETRE_TONNE_SECOND);
    let materials = si.materials_of_blocks().unwrap();
    close(mass(&si.mesh, &materials), 1e3 * before, 1e-12);
    close(materials["Plate"].0.youngs_modulus, 2.1e17, 1e-12);
}
