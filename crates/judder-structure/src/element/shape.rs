//! Shape functions and their gradients in an element's own coordinates.

use super::kind::{ElementKind, ShapeFamily};

/// The most nodes of an element.
pub const MOST_NODES: usize = 20;

/// The shape functions at a place: values, and gradients by the element's own coordinates.
#[derive(Debug, Clone, Copy)]
pub struct ShapeFunctions {
    /// N of each node; beyond the element's nodes zero.
    pub values: [f64; MOST_NODES],
    /// ∂N/∂ξ of each node.
    pub gradients: [[f64; 3]; MOST_NODES],
}

impl ShapeFunctions {
    /// The functions of a kind at a place.
    ///
    /// Linear: N = Π (1 + ξₖpₖ)/2 with the node's place p. Serendipity: at corners times (Σ ξₖpₖ − d + 1), at the middle of an edge
    /// along m Π (1 + ξₖpₖ)/2 times (1 − ξₘ²) in place of the factor m. Simplex: λ(2λ − 1) at corners, 4λᵢλⱼ between them, with
    /// the barycentric coordinates λ. O. C. Zienkiewicz and R. L. Taylor, *The Finite Element Method*, vol. 1, ch. 8.
    #[must_use]
    pub fn at(kind: ElementKind, place: &[f64; 3]) -> Self {
        let dimension = kind.dimension();
        let mut shape = Self { values: [0.0; MOST_NODES], gradients: [[0.0; 3]; MOST_NODES] };
        for (k, node) in kind.node_places().iter().enumerate() {
            let (value, gradient) = match kind.family() {
                ShapeFamily::Linear => product(&linear_factors(node, place), dimension),
                ShapeFamily::Serendipity => serendipity(node, place, dimension),
                ShapeFamily::Simplex => simplex(node, place, dimension),
            };
            shape.values[k] = value;
            shape.gradients[k] = gradient;
        }
        shape
    }
}

/// A factor of one coordinate with its derivative.
type ShapeFactor = (f64, f64);

fn linear_factors(node: &[f64; 3], place: &[f64; 3]) -> [ShapeFactor; 3] {
    std::array::from_fn(|k| (0.5 * (1.0 + place[k] * node[k]), 0.5 * node[k]))
}

fn product(factors: &[ShapeFactor; 3], dimension: usize) -> (f64, [f64; 3]) {
    let value = factors[..dimension].iter().map(|(value, _)| value).product();
    let gradient = std::array::from_fn(|k| {
        if k >= dimension {
            return 0.0;
        }
        (0..dimension).map(|j| if j == k { factors[j].1 } else { factors[j].0 }).product()
    });
    (value, gradient)
}

fn serendipity(node: &[f64; 3], place: &[f64; 3], dimension: usize) -> (f64, [f64; 3]) {
    let mut factors = linear_factors(node, place);
    if let Some(along) = (0..dimension).find(|k| node[*k] == 0.0) {
        factors[along] = (1.0 - place[along] * place[along], -2.0 * place[along]);
        return product(&factors, dimension);
    }
    let (value, gradient) = product(&factors, dimension);
    let excess = (0..dimension).map(|k| place[k] * node[k]).sum::<f64>() - (dimension as f64 - 1.0);
    (value * excess, std::array::from_fn(|k| gradient[k] * excess + value * node[k]))
}

fn simplex(node: &[f64; 3], place: &[f64; 3], dimension: usize) -> (f64, [f64; 3]) {
    // barycentric coordinates with their gradients: the first corner is the origin
    let barycentric = |corner: usize| -> (f64, [f64; 3]) {
        if corner == 0 {
            let slope = std::array::from_fn(|k| if k < dimension { -1.0 } else { 0.0 });
            return (1.0 - place[..dimension].iter().sum::<f64>(), slope);
        }
        (place[corner - 1], std::array::from_fn(|k| f64::from(u8::from(k == corner - 1))))
    };
    let shares =
        std::iter::once(1.0 - node[..dimension].iter().sum::<f64>()).chain(node[..dimension].iter().copied());
    let corners: Vec<usize> = shares.enumerate().filter(|(_, share)| *share > 0.0).map(|(k, _)| k).collect();
    let (a, slope_a) = barycentric(corners[0]);
    match corners.get(1) {
        None => (a * (2.0 * a - 1.0), slope_a.map(|s| s * (4.0 * a - 1.0))),
        Some(other) => {
            let (b, slope_b) = barycentric(*other);
            (4.0 * a * b, std::array::from_fn(|k| 4.0 * (slope_a[k] * b + a * slope_b[k])))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn inside(kind: ElementKind) -> Vec<[f64; 3]> {
        let flat = |p: [f64; 3]| if kind.dimension() == 2 { [p[0], p[1], 0.0] } else { p };
        [[0.1, 0.2, 0.3], [0.25, 0.05, 0.4], [0.6, 0.2, 0.1]].map(flat).to_vec()
    }

    #[test]
    fn a_function_is_one_at_its_node_and_zero_at_the_others() {
        for kind in ElementKind::ALL {
            for (a, place) in kind.node_places().iter().enumerate() {
                let shape = ShapeFunctions::at(kind, place);
                for b in 0..kind.nodes() {
                    let expected = f64::from(u8::from(a == b));
                    assert!((shape.values[b] - expected).abs() < 1e-15, "{kind} {a} {b}");
                }
            }
        }
    }

    #[test]
    fn they_sum_to_one_carry_a_linear_field_and_have_the_gradients_of_differences() {
        const STEP: f64 = 1e-5;
        for kind in ElementKind::ALL {
            for place in inside(kind) {
                let shape = ShapeFunctions::at(kind, &place);
                assert!((shape.values.iter().sum::<f64>() - 1.0).abs() < 1e-14);
                for k in 0..kind.dimension() {
                    let carried: f64 =
                        kind.node_places().iter().zip(&shape.values).map(|(p, n)| p[k] * n).sum();
                    assert!((carried - place[k]).abs() < 1e-14, "{kind}");
                    let moved = |by: f64| {
                        let mut there = place;
                        there[k] += by;
                        ShapeFunctions::at(kind, &there)
                    };
                    let (above, below) = (moved(STEP), moved(-STEP));
                    for a in 0..kind.nodes() {
                        let slope = (above.values[a] - below.values[a]) / (2.0 * STEP);
                        assert!((slope - shape.gradients[a][k]).abs() < 1e-9, "{kind} {a} {k}");
                    }
                }
            }
        }
    }

    #[test]
    fn sides_turn_to_the_left_seen_from_outside() {
        for kind in ElementKind::ALL {
            let places = kind.node_places();
            let middle = |nodes: &[usize]| -> [f64; 3] {
                std::array::from_fn(|k| nodes.iter().map(|n| places[*n][k]).sum::<f64>() / nodes.len() as f64)
            };
            let centre = middle(&(0..kind.nodes()).collect::<Vec<_>>());
            for side in kind.sides() {
                let edge = |from: usize, to: usize| -> [f64; 3] {
                    std::array::from_fn(|k| places[side[to]][k] - places[side[from]][k])
                };
                let (a, b) = (edge(0, 1), if kind.dimension() == 3 { edge(0, 2) } else { [0.0, 0.0, 1.0] });
                let normal =
                    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
                let outward = middle(side);
                let along: f64 = (0..3).map(|k| normal[k] * (outward[k] - centre[k])).sum();
                assert!(along > 0.0, "{kind} {side:?}");
            }
        }
    }
}
