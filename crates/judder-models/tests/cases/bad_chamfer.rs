//! Chamfers that are refused.

use super::bad_structure::body;
use super::refused;

/// A block of 50 × 12 × 20 mm, or of 50 × 12 mm, with a chamfer.
fn chamfered(dimension: usize, chamfer: &str) -> String {
    let [size, cells] = match dimension {
        2 => ["\"50 mm\", \"12 mm\"", "12, 4"],
        _ => ["\"50 mm\", \"12 mm\", \"20 mm\"", "12, 4, 5"],
    };
    body(&format!("block = {{ size = [{size}], cells = [{cells}], chamfer = {chamfer} }}"))
}

#[test]
fn chamfers_of_sides_that_are_not_there() {
    let cut = "{ length = \"5 mm\", depth = \"2 mm\", cells = 2 }";
    refused(
        &chamfered(2, &format!("{{ face = \"z-min\", x-min = {cut} }}")),
        "a block of the plane has no side z-min",
        "\"z-min\"",
        "its sides are x-min, x-max, y-min, y-max",
    );
    refused(
        &chamfered(2, "{ face = \"y-min\" }"),
        "nothing is cut off the face y-min",
        "{ face = \"y-min\" }",
        "give a chamfer where it ends, at x-min, x-max, as in x-min = { length = \"5 mm\", depth = \"2 mm\", cells = 2 }",
    );
    refused(
        &chamfered(3, &format!("{{ face = \"y-min\", y-max = {cut} }}")),
        "the face y-min does not end at y-max",
        cut,
        "it ends at x-min, x-max, z-min, z-max",
    );
    refused(
        &chamfered(3, &format!("{{ face = \"y-min\", x-max = {cut}, z-min = {cut} }}")),
        "the face y-min is cut at x-max and at z-min: chamfers that meet in a corner have no grid",
        cut,
        "cut it at x-min, x-max or at z-min, z-max; a mesh file may have any shape",
    );
    refused(
        &chamfered(2, &format!("{{ face = \"y-mid\", x-min = {cut} }}")),
        "unknown side of a block `y-mid`",
        "y-mid",
        "did you mean `y-min`? known: x-min, x-max, y-min, y-max, z-min, z-max",
    );
}

#[test]
fn chamfers_that_would_fold_elements() {
    let cut = |length: &str, depth: &str, cells: &str| {
        format!("{{ length = {length}, depth = {depth}, cells = {cells} }}")
    };
    let at_both = |first: &str, second: &str| {
        chamfered(2, &format!("{{ face = \"y-min\", x-min = {first}, x-max = {second} }}"))
    };
    let usual = cut("\"5 mm\"", "\"2 mm\"", "2");
    refused(
        &at_both(&usual, &cut("\"5 mm\"", "\"12 mm\"", "2")),
        "the chamfer at x-max is 12 mm deep, and the block 12 mm high across y-min: it would fold elements",
        "\"12 mm\"",
        "give a depth below 12 mm",
    );
    refused(
        &at_both(&usual, &cut("\"45 mm\"", "\"2 mm\"", "2")),
        "50 mm of the face y-min are cut off, and it is 50 mm long: the chamfers would fold elements",
        "\"45 mm\"",
        "give lengths that are below 50 mm together",
    );
    refused(
        &at_both(&usual, &cut("\"5 mm\"", "\"2 mm\"", "10")),
        "chamfers take 12 cells of the face y-min, which has 12 that way: none is left between them",
        "10",
        "give chamfers at most 11 cells together, or the block more",
    );
    refused(
        &at_both(&cut("\"0 mm\"", "\"2 mm\"", "2"), &usual),
        "`structure.block.chamfer.x-min.length` must be positive, but is 0 mm",
        "\"0 mm\"",
        "",
    );
    refused(
        &chamfered(2, "{ face = \"y-min\", x-min = { length = \"5 mm\", depth = \"2 mm\" } }"),
        "`structure.block.chamfer.x-min` lacks the key `cells`",
        "{ length = \"5 mm\", depth = \"2 mm\" }",
        "give cells = 2",
    );
}

/// Where two are too long together, or one has too many cells, the larger is marked, whichever comes first.
#[test]
fn the_larger_of_two_chamfers_is_marked() {
    let both = |first: &str, second: &str| {
        chamfered(2, &format!("{{ face = \"y-min\", x-min = {first}, x-max = {second} }}"))
    };
    let usual = "{ length = \"5 mm\", depth = \"2 mm\", cells = 2 }";
    refused(
        &both("{ length = \"6 cm\", depth = \"2 mm\", cells = 2 }", usual),
        "6.5 cm of the face y-min are cut off, and it is 5 cm long: the chamfers would fold elements",
        "\"6 cm\"",
        "give lengths that are below 5 cm together",
    );
    refused(
        &both("{ length = \"5 mm\", depth = \"2 mm\", cells = 11 }", usual),
        "chamfers take 13 cells of the face y-min, which has 12 that way: none is left between them",
        "11",
        "give chamfers at most 11 cells together, or the block more",
    );
}

/// Elements with a hundredth of the Jacobian at one end of what they have at the other are none to be reckoned with.
#[test]
fn chamfers_that_would_leave_slivers() {
    let cut = |length: &str, depth: &str| {
        chamfered(
            2,
            &format!("{{ face = \"y-min\", x-max = {{ length = {length}, depth = {depth}, cells = 2 }} }}"),
        )
    };
    // 0.1/(0.1 + 11.9/2)
    refused(
        &cut("\"5 mm\"", "\"11.9 mm\""),
        "at the end of the chamfer at x-max an element would have 1.653 % of what there is beside it: slivers",
        "\"11.9 mm\"",
        "give a depth of at most 11.79 mm, or more cells along the chamfer",
    );
    refused(
        &cut("\"0.1 mm\"", "\"2 mm\""),
        "elements along the chamfer at x-max would have 1.2 % of what there is beside it: slivers",
        "\"0.1 mm\"",
        "give a length of at least 0.2779 mm, or fewer cells along the chamfer",
    );
    refused(
        &cut("\"49.9 mm\"", "\"2 mm\""),
        "elements that are left of the face y-min would have 0.24 % of what there is beside it: slivers",
        "\"49.9 mm\"",
        "give lengths that are at most 48.59 mm together",
    );
    assert!(super::parse(&cut("\"5 mm\"", "\"11.79 mm\""), &[]).is_ok());
}
