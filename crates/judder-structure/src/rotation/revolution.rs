//! Whether a body is one of revolution.

use super::Rotation;
use crate::element::ElementKind;
use crate::mesh::Mesh;
use std::collections::BTreeMap;

/// How much of a body's surface the material crosses as the body turns, over all of it: ∫ |n·v|/|v| dA/∫ dA, zero for a body of revolution about the axis.
///
/// Sides of elements count as flat: the facets of a round surface have their middles where the material goes along them.
#[must_use]
pub fn crossed_surface(mesh: &Mesh, rotation: &Rotation) -> f64 {
    // a side of two elements is inside
    let mut outer: BTreeMap<Vec<usize>, Option<Vec<usize>>> = BTreeMap::new();
    for block in mesh.blocks.iter().filter(|block| block.kind.dimension() == 3) {
        for element in block.connectivity.chunks_exact(block.kind.nodes()) {
            for side in block.kind.sides() {
                let corners: Vec<usize> = side[..corners(block.kind)].iter().map(|k| element[*k]).collect();
                let mut key = corners.clone();
                key.sort_unstable();
                outer.entry(key).and_modify(|other| *other = None).or_insert(Some(corners));
            }
        }
    }
    let (mut crossed, mut all) = (0.0, 0.0);
    for side in outer.into_values().flatten() {
        let (area, middle) = area_and_middle(mesh, &side);
        let velocity = rotation.velocity(middle);
        let (size, speed) = (length(area), length(velocity));
        all += size;
        if speed > 0.0 {
            crossed += (0..3).map(|k| area[k] * velocity[k]).sum::<f64>().abs() / speed;
        }
    }
    if all > 0.0 { crossed / all } else { 0.0 }
}

/// Corners of a side.
fn corners(kind: ElementKind) -> usize {
    if kind == ElementKind::Tetrahedron10 { 3 } else { 4 }
}

/// The area vector of a polygon, and the mean of its corners.
fn area_and_middle(mesh: &Mesh, corners: &[usize]) -> ([f64; 3], [f64; 3]) {
    let place = |k: usize| mesh.nodes[corners[k % corners.len()]];
    let middle = std::array::from_fn(|axis| {
        (0..corners.len()).map(|k| place(k)[axis]).sum::<f64>() / corners.len() as f64
    });
    let area = (0..corners.len()).fold([0.0; 3], |sum: [f64; 3], k| {
        let [a, b]: [[f64; 3]; 2] =
            [place(k), place(k + 1)].map(|end| std::array::from_fn(|axis| end[axis] - middle[axis]));
        let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        std::array::from_fn(|axis| sum[axis] + 0.5 * cross[axis])
    });
    (area, middle)
}

fn length(vector: [f64; 3]) -> f64 {
    libm::hypot(libm::hypot(vector[0], vector[1]), vector[2])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::disc::Disc;
    use crate::grid::Grid;

    #[test]
    fn a_ring_is_one_of_revolution_about_its_own_axis_alone_and_a_box_about_none() {
        let about = |centre| Rotation { angular_velocity: [0.0, 0.0, 7.0], centre };
        for kind in [ElementKind::Hexahedron8, ElementKind::Hexahedron20] {
            let ring = Disc::even(kind, [0.1, 0.2], 0.05, [2, 16, 1]).mesh("m", |place| place).unwrap();
            assert!(crossed_surface(&ring, &about([0.0; 3])) < 1e-15);
            assert!(crossed_surface(&ring, &about([0.02, 0.0, 0.0])) > 0.01);
        }
        let cube = Grid { kind: ElementKind::Hexahedron8, size: [1.0; 3], cells: [4, 4, 4] };
        let centred = cube.mesh("m", |place| place.map(|x| x - 0.5)).unwrap();
        assert!(crossed_surface(&centred, &about([0.0; 3])) > 0.2);
    }
}
