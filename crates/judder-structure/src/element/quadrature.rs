//! Quadrature over an element's own coordinates.

use super::kind::{ElementKind, ShapeFamily};
use judder_numerics::quadrature::gauss_legendre;

/// A place in an element and its weight.
pub type IntegrationPoint = ([f64; 3], f64);

/// The points of a kind's stiffness and of its mass.
///
/// Gauss–Legendre with 2 points a direction for linear kinds and 3 for serendipity ones; on simplices rules of degree 2 for the
/// stiffness and 5 for the mass (A. H. Stroud, *Approximate Calculation of Multiple Integrals*, T2:5-1, T3:5-1). All are exact
/// where the sides are straight and parallel.
#[must_use]
pub fn points(kind: ElementKind) -> (Vec<IntegrationPoint>, Vec<IntegrationPoint>) {
    let dimension = kind.dimension();
    match (kind.family(), dimension) {
        (ShapeFamily::Linear, _) => twice(products(&gauss_legendre::<2>(), dimension)),
        (ShapeFamily::Serendipity, _) => twice(products(&gauss_legendre::<3>(), dimension)),
        (ShapeFamily::Simplex, 2) => (orbit_of_triangle(1.0 / 6.0, 1.0 / 6.0), triangle_of_degree_5()),
        (ShapeFamily::Simplex, _) => {
            (orbit_of_tetrahedron((5.0 - 5.0_f64.sqrt()) / 20.0, 1.0 / 24.0), tetrahedron_of_degree_5())
        }
    }
}

fn twice(points: Vec<IntegrationPoint>) -> (Vec<IntegrationPoint>, Vec<IntegrationPoint>) {
    (points.clone(), points)
}

/// Products of a rule on [0, 1], moved to [−1, 1]ᵈ.
fn products(rule: &[(f64, f64)], dimension: usize) -> Vec<IntegrationPoint> {
    let mut points = vec![([0.0; 3], 1.0)];
    for k in 0..dimension {
        points = points
            .iter()
            .flat_map(|(place, weight)| {
                rule.iter().map(move |(node, share)| {
                    let mut place = *place;
                    place[k] = 2.0 * node - 1.0;
                    (place, 2.0 * share * weight)
                })
            })
            .collect();
    }
    points
}

/// The three points with two barycentric coordinates equal to `a`.
fn orbit_of_triangle(a: f64, weight: f64) -> Vec<IntegrationPoint> {
    let b = 1.0 - 2.0 * a;
    vec![([a, a, 0.0], weight), ([b, a, 0.0], weight), ([a, b, 0.0], weight)]
}

fn triangle_of_degree_5() -> Vec<IntegrationPoint> {
    let root = 15.0_f64.sqrt();
    let third = 1.0 / 3.0;
    let mut points = vec![([third, third, 0.0], 9.0 / 80.0)];
    points.extend(orbit_of_triangle((6.0 - root) / 21.0, (155.0 - root) / 2400.0));
    points.extend(orbit_of_triangle((6.0 + root) / 21.0, (155.0 + root) / 2400.0));
    points
}

/// The four points with three barycentric coordinates equal to `a`.
fn orbit_of_tetrahedron(a: f64, weight: f64) -> Vec<IntegrationPoint> {
    let b = 1.0 - 3.0 * a;
    vec![([a, a, a], weight), ([b, a, a], weight), ([a, b, a], weight), ([a, a, b], weight)]
}

fn tetrahedron_of_degree_5() -> Vec<IntegrationPoint> {
    let root = 15.0_f64.sqrt();
    let mut points = vec![([0.25; 3], 8.0 / 405.0)];
    points.extend(orbit_of_tetrahedron((7.0 - root) / 34.0, (2665.0 + 14.0 * root) / 226_800.0));
    points.extend(orbit_of_tetrahedron((7.0 + root) / 34.0, (2665.0 - 14.0 * root) / 226_800.0));
    // two barycentric coordinates a, two b
    let (a, b) = ((10.0 - 2.0 * root) / 40.0, (10.0 + 2.0 * root) / 40.0);
    let places = [[a, a, b], [a, b, a], [b, a, a], [b, b, a], [b, a, b], [a, b, b]];
    points.extend(places.map(|place| (place, 5.0 / 567.0)));
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    fn integral(points: &[IntegrationPoint], powers: [i32; 3]) -> f64 {
        points
            .iter()
            .map(|(p, w)| w * p[0].powi(powers[0]) * p[1].powi(powers[1]) * p[2].powi(powers[2]))
            .sum()
    }

    /// ∫ x^a y^b z^c over the simplex is a! b! c!/(a + b + c + d)!, over [−1, 1]ᵈ a product of 2/(a + 1) for even a.
    fn exact(kind: ElementKind, powers: [i32; 3]) -> f64 {
        let factorial = |n: i32| f64::from((1..=n).product::<i32>());
        if kind.family() == ShapeFamily::Simplex {
            let all: f64 = powers.iter().map(|p| factorial(*p)).product();
            return all / factorial(powers.iter().sum::<i32>() + kind.dimension() as i32);
        }
        let along = |p: &i32| if p % 2 == 0 { 2.0 / f64::from(p + 1) } else { 0.0 };
        powers[..kind.dimension()].iter().map(along).product()
    }

    #[test]
    fn monomials_up_to_their_degree_are_exact() {
        for kind in ElementKind::ALL {
            let (stiffness, mass) = points(kind);
            let degrees = match kind.family() {
                ShapeFamily::Linear => (3, 3),
                ShapeFamily::Serendipity => (5, 5),
                ShapeFamily::Simplex => (2, 5),
            };
            for (points, degree) in [(stiffness, degrees.0), (mass, degrees.1)] {
                for a in 0..=degree {
                    for b in 0..=degree - a {
                        for c in 0..=(if kind.dimension() == 3 { degree - a - b } else { 0 }) {
                            let (found, expected) = (integral(&points, [a, b, c]), exact(kind, [a, b, c]));
                            assert!(
                                (found - expected).abs() < 1e-14 * (1.0 + expected),
                                "{kind} {a} {b} {c}: {found} {expected}"
                            );
                        }
                    }
                }
            }
        }
    }
}
