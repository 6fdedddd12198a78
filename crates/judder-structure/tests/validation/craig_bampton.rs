//! Reduced against full: the horizontal beam of the beams paper, on its 100 free top nodes and fixed-interface modes.

use super::modes::horizontal;
use judder_structure::StructureError;
use judder_structure::craig_bampton::CraigBampton;
use judder_structure::freedom::Direction;
use judder_structure::modes::{Mode, Wanted, modes};
use std::f64::consts::TAU;

fn frequencies(count: usize) -> (Vec<f64>, Vec<f64>) {
    let body = horizontal();
    let numbering = body.numbering(&body.held(&body.mesh.node_sets["start"]));
    let assembled = body.assembled(&numbering);
    let kept: Vec<usize> = body.mesh.node_sets["upper-corners"]
        .iter()
        .flat_map(|node| [Direction::X, Direction::Y].map(|direction| numbering.number(*node, direction)))
        .flatten()
        .collect();
    assert_eq!(kept.len(), 200);
    let reduced = CraigBampton::new(&assembled.stiffness, &assembled.mass, &kept, count).unwrap();
    let (values, _) = reduced.modal_form().unwrap();
    let full = modes(&assembled.stiffness, &assembled.mass, Wanted::Lowest(12)).unwrap();
    let of_reduced = values.iter().take(12).map(|value| value.sqrt() / TAU).collect();
    (of_reduced, full.modes.iter().map(Mode::frequency_hz).collect())
}

/// Our notes on the beams paper: with 20 modes the eighth bending mode comes out at 6916.5 Hz in place of 6909.
#[test]
fn the_papers_reduction_has_its_error() {
    let (reduced, full) = frequencies(20);
    println!("{reduced:?}\n{full:?}");
    assert!(
        (reduced[8] - 6916.5).abs() < 0.5 && (full[8] - 6909.2).abs() < 0.5,
        "{} {}",
        reduced[8],
        full[8]
    );
    // a subspace: every frequency comes from above
    assert!(reduced.iter().zip(&full).all(|(reduced, full)| *reduced > full * (1.0 - 1e-7)));
}

#[test]
fn the_error_falls_as_modes_are_added() {
    let errors = [5, 20, 60].map(|count| {
        let (reduced, full) = frequencies(count);
        reduced.iter().zip(&full).map(|(r, f)| r / f - 1.0).fold(0.0_f64, |a, b| a.max(b.abs()))
    });
    println!("{errors:?}");
    assert!(errors[0] > errors[1] && errors[1] > errors[2], "{errors:?}");
}

#[test]
fn a_freedom_is_kept_once() {
    let body = horizontal();
    let assembled = body.assembled(&body.numbering(&body.held(&body.mesh.node_sets["start"])));
    for wrong in [vec![3, 3], vec![1_000_000]] {
        let error = CraigBampton::new(&assembled.stiffness, &assembled.mass, &wrong, 2).unwrap_err();
        assert!(matches!(error, StructureError::KeptTwice { .. }));
    }
}
