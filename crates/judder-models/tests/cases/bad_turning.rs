//! Assembly cases with bodies that cannot turn, and discs that are none.

use super::bad_assembly::{BLOCK, spoilt, unassembled};
use super::refused;

/// A ring that turns, seen from itself.
const RING: &str = include_str!("../../../../cases/assembly/rotating-ring.toml");

#[test]
fn discs_that_are_none() {
    let radii = "radii = [\"87.12 mm\", \"88 mm\"]";
    refused(
        &spoilt(RING, radii, "radii = [\"88 mm\", \"87.12 mm\"]"),
        "the range runs backwards: from 88 mm to 87.12 mm",
        "[\"88 mm\", \"87.12 mm\"]",
        "exchange its two ends",
    );
    refused(
        &spoilt(RING, radii, "radii = [\"0 mm\", \"88 mm\"]"),
        "`structure.ring.disc.radii` must be positive, but is 0 mm",
        "\"0 mm\"",
        "",
    );
    refused(
        &spoilt(RING, "disc = { ", "disc = { element = \"quad4\", "),
        "a disc is made of eight-node or twenty-node bricks, not of four-node quadrilaterals",
        "\"quad4\"",
        "give element = \"hexahedron8\" or \"hexahedron20\"",
    );
    refused(
        &spoilt(
            RING,
            "cells = [1, 160, 2]",
            "cells = [1, 160, 2], band = { radii = [\"80 mm\", \"88 mm\"], cells = 2 }",
        ),
        "the band is not within the disc, whose radii are 0.08712 and 0.088 m",
        "{ radii = [\"80 mm\", \"88 mm\"], cells = 2 }",
        "give radii between those of the disc",
    );
    refused(
        &spoilt(
            RING,
            "cells = [1, 160, 2]",
            "cells = [1, 160, 2], sector = { angles = [\"0 deg\", \"360 deg\"], cells = 2 }",
        ),
        "the sector is a turn or more, which leaves nothing of the disc beside it",
        "{ angles = [\"0 deg\", \"360 deg\"], cells = 2 }",
        "for even cells all around leave the sector out: `cells` has how many",
    );
    let (message, place) = unassembled(&spoilt(RING, "cells = [1, 160, 2]", "cells = [1, 2, 2]"));
    assert!(message.starts_with("there is no disc: it needs three cells around its axis"), "{message}");
    assert!(!place.is_empty());
}

#[test]
fn blocks_that_cannot_lie_so() {
    const PIN: &str = include_str!("../../../../cases/assembly/pin-on-disc.toml");
    refused(
        &spoilt(PIN, "axis = [0, 1, 0], angle", "axis = [0, 0, 0], angle"),
        "`structure.pin.block.orientation.axis` is an axis without a direction",
        "[0, 0, 0]",
        "give a number other than zero, as in axis = [0, 1, 0]",
    );
    let cells = "cells = [20, 10]";
    let leaning = "cells = [20, 10], orientation = { angle = \"4 deg\", axis = [1, 0, 0] }";
    refused(
        &spoilt(BLOCK, cells, leaning),
        "`structure.block.block.orientation.axis` would turn a block of the plane out of its plane",
        "[1, 0, 0]",
        "leave axis out: in the plane it is [0, 0, 1]",
    );
}

#[test]
fn bodies_that_cannot_turn() {
    refused(
        &spoilt(RING, "frame = ", "axis = [0, 0, 0], frame = "),
        "`structure.ring.rotation.axis` has no direction: all its numbers are zero",
        "[0, 0, 0]",
        "give a vector such as [0, 1] in the plane, [0, 0, 1] in space",
    );
    refused(
        &spoilt(RING, "\"12000 rpm\"", "\"12000 mm\""),
        "`structure.ring.rotation.speed` must be an angular frequency, but this is a length",
        "\"12000 mm\"",
        "write an angular frequency, such as \"40 rad/s\" or \"7 kHz\"",
    );
    refused(
        &spoilt(RING, "frame = \"rotating\"", "frame = \"moving\""),
        "unknown frame `moving`",
        "moving",
        "known: fixed, rotating",
    );
    let turning = "rotation = { speed = \"10 rpm\" }\nsupports = [{";
    refused(
        &spoilt(BLOCK, "supports = [{", turning),
        "a body of the plane cannot turn: gyroscopic and centrifugal terms are those of elements of space",
        "{ speed = \"10 rpm\" }",
        "",
    );
    let beam = "beam = { length = \"75 mm\", thickness = \"1.5 mm\", elements = [15, 1] }\nrotation = { speed = \"10 rpm\" }";
    let block = "block = { element = \"quad4\", size = [\"40 mm\", \"20 mm\"], cells = [20, 10] }";
    refused(
        &spoilt(BLOCK, block, beam),
        "a beam is a body of the plane, which cannot turn: gyroscopic and centrifugal terms are those of elements of space",
        "{ speed = \"10 rpm\" }",
        "",
    );
    refused(
        &spoilt(RING, "rotation = ", "masses = [{ set = \"r-max\", mass = \"2 g\" }]\nrotation = "),
        "`masses` has no meaning with structure.ring.rotation",
        "[{ set = \"r-max\", mass = \"2 g\" }]",
        "leave `masses` out",
    );
    // an axis beside the ring: no body of revolution about it, and out of balance
    let beside = "centre = [\"10 mm\", \"0 m\", \"0 m\"], frame = ";
    let (message, place) = unassembled(&spoilt(RING, "frame = ", beside));
    assert!(message.contains("the centrifugal force is not in balance"), "{message}");
    assert!(!place.is_empty());
    let standing = spoilt(&spoilt(RING, "frame = ", beside), "\"rotating\"", "\"fixed\"");
    let (message, _) = unassembled(&standing);
    assert!(message.starts_with("`ring` is no body of revolution about this axis"), "{message}");
}

#[test]
fn what_touches_a_body_that_is_seen_from_itself() {
    let foot = "[[contact]]\nname = \"sole\"\nslider = { structure = \"ring\", set = \"z-min\" }\ntrack = { plane = { normal = [0, 0, 1] } }\n\
        sliding = { velocity = \"1 m/s\", direction = [1, 0, 0] }\nfriction_coefficient = 0.1\n\n[[analysis]]";
    refused(
        &spoilt(RING, "[[analysis]]", foot),
        "in the frame that turns with this body the other side of the contact does not stand still; give its rotation frame = \"fixed\", for a body of revolution",
        "{ structure = \"ring\", set = \"z-min\" }",
        "",
    );
    refused(
        &spoilt(BLOCK, "friction_coefficient = ", "configuration = \"deformed\"\nfriction_coefficient = "),
        "`configuration` has no meaning with contact.sole.track.plane",
        "\"deformed\"",
        "leave `configuration` out",
    );
}
