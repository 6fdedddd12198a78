//! Modes: beams against Euler and Bernoulli, rigid motions, modes that come in pairs, none missing.

use crate::Body;
use faer::sparse::Triplet;
use judder_structure::StructureError;
use judder_structure::assembly::Sparse;
use judder_structure::beam::Beam;
use judder_structure::craig_bampton::{CraigBampton, CutOff};
use judder_structure::element::ElementKind;
use judder_structure::freedom::Supports;
use judder_structure::grid::Grid;
use judder_structure::material::{Elastic, ElementSection};
use judder_structure::modes::{Mode, Modes, WantedModes, admit, below, modes};
use std::f64::consts::{PI, TAU};

/// The two beams of the beams paper, Tables 1 and 2, held at one end.
fn cantilever(length: f64, thickness: f64, width: f64, elements: usize, material: Elastic) -> Body {
    let beam = Beam { length, thickness, elements: [elements, 2], origin: [0.0; 2], angle: 0.0 };
    Body {
        mesh: beam.mesh("any").unwrap(),
        material,
        section: ElementSection::PlaneStress { thickness: width },
    }
}

pub(crate) fn horizontal() -> Body {
    cantilever(0.1, 0.002, 0.02, 100, Elastic::new(2.38e9, 0.4, 1200.0).unwrap())
}

pub(crate) fn oblique() -> Body {
    cantilever(0.075, 0.0015, 0.01, 75, Elastic::new(71e9, 0.33, 2770.0).unwrap())
}

fn lowest(body: &Body, supports: &Supports, wanted: WantedModes) -> Modes {
    let assembled = body.assembled(&body.numbering(supports));
    let found = modes(&assembled.stiffness, &assembled.mass, wanted).unwrap();
    for mode in &found.modes {
        assert!(mode.residual < 1e-11, "{} Hz: {:e}", mode.frequency_hz(), mode.residual);
    }
    found
}

fn nearest(found: &Modes, frequency: f64) -> f64 {
    let frequencies = found.modes.iter().map(Mode::frequency_hz);
    frequencies.min_by(|a, b| (a - frequency).abs().total_cmp(&(b - frequency).abs())).unwrap()
}

/// Our notes on the beams paper give the frequencies to half a percent.
#[test]
fn the_beams_of_the_paper_have_their_frequencies() {
    for (body, expected) in [
        (horizontal(), vec![45.5, 284.7, 794.7, 3523.0, 6909.0, 10567.0]),
        (oblique(), vec![218.0, 1365.0, 3810.0, 7433.0]),
    ] {
        let found = lowest(&body, &body.held(&body.mesh.node_sets["start"]), WantedModes::Lowest(14));
        println!("{:?}", found.modes.iter().map(Mode::frequency_hz).collect::<Vec<_>>());
        for frequency in expected {
            let nearest = nearest(&found, frequency);
            assert!((nearest / frequency - 1.0).abs() < 5e-3, "{frequency}: {nearest}");
        }
    }
}

/// ω = β² √(E I/(ρ A)) with cos βl cosh βl = −1, and ω = (k − ½) π/l √(E/ρ) along the axis.
#[test]
fn a_slender_cantilever_is_that_of_euler_and_bernoulli() {
    let (length, thickness) = (1.0, 0.002);
    let body = cantilever(length, thickness, 0.01, 300, Elastic::new(200e9, 0.0, 8000.0).unwrap());
    let found = lowest(&body, &body.held(&body.mesh.node_sets["start"]), WantedModes::Lowest(4));
    let speed = (200e9 / 8000.0_f64).sqrt();
    let radius = thickness / 12.0_f64.sqrt();
    for (mode, root) in found.modes.iter().zip([1.875_104_069, 4.694_091_133, 7.854_757_438, 10.995_540_73]) {
        let expected = (root / length).powi(2) * radius * speed / TAU;
        assert!((mode.frequency_hz() / expected - 1.0).abs() < 2e-4, "{expected}: {}", mode.frequency_hz());
    }
    let along = PI / 2.0 / length * speed / TAU;
    let band = lowest(
        &body,
        &body.held(&body.mesh.node_sets["start"]),
        WantedModes::Band(0.99 * along, 1.01 * along),
    );
    let best = nearest(&band, along);
    assert!((best / along - 1.0).abs() < 1e-5, "{along}: {best}");
}

#[test]
fn a_free_body_has_its_rigid_motions_at_zero() {
    for (kind, rigid) in
        [(ElementKind::Quad8, 3), (ElementKind::Hexahedron8, 6), (ElementKind::Tetrahedron10, 6)]
    {
        let grid = Grid { kind, size: [0.3, 0.2, 0.1], cells: [4, 3, 2] };
        let section =
            if rigid == 3 { ElementSection::PlaneStress { thickness: 0.01 } } else { ElementSection::Solid };
        let body = Body {
            mesh: grid.mesh("any", |p| p).unwrap(),
            material: Elastic::new(2e11, 0.3, 7800.0).unwrap(),
            section,
        };
        let found = lowest(&body, &Supports::default(), WantedModes::Lowest(rigid + 4));
        let first = found.modes[rigid].eigenvalue;
        assert!(found.modes[..rigid].iter().all(|mode| mode.eigenvalue.abs() < 1e-9 * first), "{kind}");
        assert!(found.modes[rigid].frequency_hz() > 100.0);
    }
}

/// A square that is held all round has modes in pairs; one start of Lanczos' method sees one of each.
#[test]
fn modes_that_come_in_pairs_are_both_found() {
    let grid = Grid { kind: ElementKind::Quad8, size: [1.0; 3], cells: [8, 8, 1] };
    let body = Body {
        mesh: grid.mesh("any", |p| p).unwrap(),
        material: Elastic::new(1.0, 0.3, 1.0).unwrap(),
        section: ElementSection::PlaneStrain { thickness: 1.0 },
    };
    let sides: Vec<usize> = body.mesh.node_sets.values().flatten().copied().collect();
    let found = lowest(&body, &body.held(&sides), WantedModes::Lowest(20));
    assert_eq!(found.modes.len(), 20);
    let values: Vec<f64> = found.modes.iter().map(|mode| mode.eigenvalue).collect();
    let pairs = values.windows(2).filter(|pair| (pair[1] / pair[0] - 1.0).abs() < 1e-9).count();
    assert!(pairs >= 5, "{values:?}");
    // between any two that stand apart a count finds as many below as were found
    let assembled = body.assembled(&body.numbering(&body.held(&sides)));
    for (k, pair) in values.windows(2).enumerate().filter(|(_, pair)| pair[1] / pair[0] > 1.0 + 1e-6) {
        let middle = 0.5 * (pair[0] + pair[1]);
        assert_eq!(below(&assembled.stiffness, &assembled.mass, middle).unwrap(), k + 1, "{values:?}");
    }
    let (limit, count) = found.counted;
    assert!(values.iter().filter(|value| **value < limit).count() <= count && limit > values[19]);
}

#[test]
fn shapes_are_orthogonal_in_mass_and_stiffness() {
    let body = horizontal();
    let assembled = body.assembled(&body.numbering(&body.held(&body.mesh.node_sets["start"])));
    let found = modes(&assembled.stiffness, &assembled.mass, WantedModes::Lowest(8)).unwrap().modes;
    for a in &found {
        let (inertial, elastic) = (
            judder_structure::statics::product(&assembled.mass, &a.shape),
            judder_structure::statics::product(&assembled.stiffness, &a.shape),
        );
        for b in &found {
            let along = |force: &[f64]| force.iter().zip(&b.shape).map(|(f, u)| f * u).sum::<f64>();
            let expected = f64::from(u8::from(a == b));
            assert!((along(&inertial) - expected).abs() < 1e-10, "{}", along(&inertial));
            let scale = (a.eigenvalue * b.eigenvalue).sqrt();
            assert!((along(&elastic) / scale - expected).abs() < 1e-7, "{}", along(&elastic) / scale);
        }
    }
}

/// Springs in a row, of which as many modes are asked as there are freedoms: ω² = 2 − 2 cos(k π/(n + 1)).
#[test]
fn all_modes_of_a_small_structure_are_found() {
    for size in 1..=9_usize {
        let entries = |diagonal: f64, beside: f64| {
            let row = move |i: usize| {
                let next = (i + 1 < size).then_some([(i, i + 1, beside), (i + 1, i, beside)]);
                std::iter::once((i, i, diagonal)).chain(next.into_iter().flatten())
            };
            let triplets: Vec<_> = (0..size).flat_map(row).map(|(i, j, v)| Triplet::new(i, j, v)).collect();
            Sparse::try_new_from_triplets(size, size, &triplets).unwrap()
        };
        let found = modes(&entries(2.0, -1.0), &entries(1.0, 0.0), WantedModes::Lowest(size)).unwrap();
        assert_eq!(found.modes.len(), size);
        for (k, mode) in found.modes.iter().enumerate() {
            let expected = 2.0 - 2.0 * ((k + 1) as f64 * PI / (size + 1) as f64).cos();
            assert!((mode.eigenvalue - expected).abs() < 1e-13, "{size} {k}: {}", mode.eigenvalue);
        }
    }
}

/// The block of a free body with its frequencies between two of its own, against all that a band from zero has.
#[test]
fn a_band_holds_all_between_its_counts_and_rigid_motions_only_from_zero() {
    let grid = Grid { kind: ElementKind::Hexahedron8, size: [0.6, 0.2, 0.1], cells: [9, 3, 2] };
    let body = Body {
        mesh: grid.mesh("any", |p| p).unwrap(),
        material: Elastic::new(2e11, 0.3, 7800.0).unwrap(),
        section: ElementSection::Solid,
    };
    let band = |from, to| {
        let found = lowest(&body, &Supports::default(), WantedModes::Band(from, to));
        assert_eq!(found.modes.len(), found.counted.1 - found.counted_from.1, "{from} to {to} Hz");
        found
    };
    let all = band(0.0, 8_000.0);
    let frequencies: Vec<f64> = all.modes.iter().map(Mode::frequency_hz).collect();
    let rigid: Vec<f64> = all.modes[..7].iter().map(|mode| mode.eigenvalue).collect();
    println!("{frequencies:?}, {rigid:?}, rigid up to {:e}", all.rigid_limit);
    assert_eq!((all.counted_from.1, all.rigid_modes()), (0, 6));
    assert!(all.modes.len() >= 15, "{frequencies:?}");
    let same = |found: &Modes, expected: &[f64]| {
        let found: Vec<f64> = found.modes.iter().map(Mode::frequency_hz).collect();
        assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
        assert!(
            found.iter().zip(expected).all(|(a, b)| (a / b - 1.0).abs() < 1e-10),
            "{found:?} {expected:?}"
        );
    };
    let from_one = band(1.0, 8_000.0);
    assert_eq!((from_one.counted_from.1, from_one.rigid_modes()), (6, 0));
    same(&from_one, &frequencies[6..]);
    // inside: between modes, from and to modes themselves, beside one, and where there is none
    let middle = |k: usize| 0.5 * (frequencies[k] + frequencies[k + 1]);
    same(&band(middle(8), middle(13)), &frequencies[9..14]);
    same(&band(frequencies[9], frequencies[13]), &frequencies[9..14]);
    same(&band(frequencies[9] * (1.0 + 1e-7), frequencies[13]), &frequencies[10..14]);
    same(&band(frequencies[9] * (1.0 + 1e-7), frequencies[10] * (1.0 - 1e-7)), &[]);
    // without frequencies that rounding leaves
    same(&band(1e-9, 1e-8), &[]);
    let assembled = body.assembled(&body.numbering(&Supports::default()));
    for (from, to) in [(2.0, 1.0), (1.0, 1.0), (0.0, f64::NAN), (f64::NAN, 1.0), (0.0, f64::INFINITY)] {
        let refused = modes(&assembled.stiffness, &assembled.mass, WantedModes::Band(from, to)).unwrap_err();
        assert!(matches!(refused, StructureError::InvalidNumber { .. }), "{from} {to}: {refused}");
    }
}

/// A row of springs of which every second node has a mass: condensed, it is a row of half the stiffness, λ = 1 − cos(k π/(m + 1)).
#[test]
fn where_freedoms_have_no_mass_all_modes_are_those_of_the_others() {
    let masses = 6_usize;
    let size: usize = 2 * masses + 1;
    let stiffness: Vec<_> = (0..size)
        .flat_map(|i| [(i, i, 2.0), (i, (i + 1) % size, -1.0), ((i + 1) % size, i, -1.0)])
        .filter(|(i, j, _)| i.abs_diff(*j) <= 1)
        .map(|(i, j, value)| Triplet::new(i, j, value))
        .collect();
    let mass: Vec<_> = (0..masses).map(|k| Triplet::new(2 * k + 1, 2 * k + 1, 1.0)).collect();
    let [stiffness, mass] =
        [stiffness, mass].map(|entries| Sparse::try_new_from_triplets(size, size, &entries).unwrap());
    for wanted in [masses - 1, masses, masses + 1, size, 2 * size] {
        let found = modes(&stiffness, &mass, WantedModes::Lowest(wanted)).unwrap();
        assert_eq!(found.modes.len(), wanted.min(masses), "{wanted}");
        for (k, mode) in found.modes.iter().enumerate() {
            let expected = 1.0 - ((k + 1) as f64 * PI / (masses + 1) as f64).cos();
            assert!((mode.eigenvalue - expected).abs() < 1e-13, "{wanted} {k}: {}", mode.eigenvalue);
        }
    }
    // and a band beyond them all
    let found = modes(&stiffness, &mass, WantedModes::Band(0.1, 10.0)).unwrap();
    assert_eq!(found.modes.len(), found.counted.1 - found.counted_from.1);
    assert_eq!(found.counted.1, masses);
    // a reduction to one mass has the modes of the others, and with all of them no error
    for (count, left_out) in [(masses - 2, true), (masses - 1, false), (masses, false), (size, false)] {
        let reduced = CraigBampton::new(&stiffness, &mass, &[1], CutOff::Count(count)).unwrap();
        assert_eq!(reduced.fixed_interface.len(), count.min(masses - 1));
        assert_eq!(reduced.error().unwrap().limit_hz(1e-4).is_finite(), left_out, "{count}");
    }
}

/// A diagonal matrix.
fn diagonal(values: &[f64]) -> Sparse {
    let entries: Vec<_> = values.iter().enumerate().map(|(k, value)| Triplet::new(k, k, *value)).collect();
    Sparse::try_new_from_triplets(values.len(), values.len(), &entries).unwrap()
}

/// That modes of two matrices are refused for a reason, before they are searched and when they are.
fn refused(stiffness: &Sparse, mass: &Sparse, wanted: WantedModes, expected: &StructureError) {
    assert_eq!(admit(stiffness, mass, wanted, f64::INFINITY).as_ref().unwrap_err(), expected);
    assert_eq!(modes(stiffness, mass, wanted).as_ref().unwrap_err(), expected);
}

/// Whatever is asked for, near zero or far from it, one motion among few or many.
#[test]
fn an_indefinite_mass_has_no_modes() {
    let stiffness = diagonal(&[1.0, 4.0, 9.0, 16.0]);
    let expected = StructureError::IndefiniteMass { negative: 1, size: 4 };
    for of_last in [-1.0, -1e-9, -1e-30] {
        let mass = diagonal(&[1.0, 1.0, 1.0, of_last]);
        for wanted in [WantedModes::Lowest(4), WantedModes::Lowest(1), WantedModes::Band(0.1, 1.0)] {
            refused(&stiffness, &mass, wanted, &expected);
        }
        let reduced = CraigBampton::new(&stiffness, &mass, &[3], CutOff::Count(3)).unwrap_err();
        assert_eq!(reduced, expected);
    }
    let body = horizontal();
    let assembled = body.assembled(&body.numbering(&body.held(&body.mesh.node_sets["start"])));
    let mut mass = assembled.mass;
    let size = mass.nrows();
    // a coupling that is larger than what it couples has
    let column = size / 2;
    let place = mass.row_idx_of_col(column).position(|row| row == column).unwrap();
    mass.val_of_col_mut(column)[place] *= 0.05;
    let expected = StructureError::IndefiniteMass { negative: 1, size };
    refused(&assembled.stiffness, &mass, WantedModes::Lowest(3), &expected);
}

#[test]
fn an_indefinite_stiffness_has_no_modes_from_the_lowest_on() {
    let (stiffness, mass) = (diagonal(&[-1.0, 4.0, -9.0, 16.0]), diagonal(&[1.0; 4]));
    let expected = StructureError::IndefiniteStiffness { negative: 2, size: 4 };
    for wanted in [WantedModes::Lowest(4), WantedModes::Lowest(1), WantedModes::Band(0.0, 1.0)] {
        refused(&stiffness, &mass, wanted, &expected);
    }
    // a band above zero passes over what grows
    let band = WantedModes::Band(0.1, 1.0);
    admit(&stiffness, &mass, band, f64::INFINITY).unwrap();
    let found = modes(&stiffness, &mass, band).unwrap();
    let values: Vec<f64> = found.modes.iter().map(|mode| mode.eigenvalue.round()).collect();
    assert_eq!((values, found.counted_from.1), (vec![4.0, 16.0], 2));
}

#[test]
fn matrices_without_a_scale_or_without_both_in_one_motion_are_refused() {
    let (ones, huge) = (diagonal(&[1.0; 4]), diagonal(&[1e308; 4]));
    let name = "the trace of the stiffness";
    let expected = StructureError::NotPositive { name, value: f64::INFINITY };
    refused(&huge, &ones, WantedModes::Lowest(4), &expected);
    let half = diagonal(&[1.0, 1.0, 0.0, 1.0]);
    refused(&half, &half, WantedModes::Lowest(2), &StructureError::Singular { rows: 4 });
    // without mass in some motions there are fewer modes
    admit(&ones, &half, WantedModes::Lowest(4), f64::INFINITY).unwrap();
    assert_eq!(modes(&ones, &half, WantedModes::Lowest(4)).unwrap().modes.len(), 3);
}
