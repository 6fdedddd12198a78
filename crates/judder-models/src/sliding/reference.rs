//! What the page says of sliding cases.

use crate::sliding::KINDS;
use crate::sliding::case::SystemKeys;
use judder_keys::declared::Settings;
use judder_keys::reference::settings;
use judder_study::case::reference::kinds;

/// The section on sliding cases.
pub(super) fn section() -> String {
    let mut page = HEAD.to_owned();
    page += &settings("[contact]`, `[motion]` and `[observe]", &SystemKeys::declarations());
    page += "\n### Analyses of a sliding case\n\n";
    page += &kinds(&KINDS);
    page + SETTINGS
}

const HEAD: &str = "
## Keys of a sliding case

`model = \"sliding\"` is one structure, the slider, whose contact point C slides along an edge of another, the track. `judder new beams-paper` prints the case of the beams paper with every key.

`[[structure]]` stands twice. Each has a `name` of letters, digits, `_` and `-`, and the keys of a [structure case](#keys-of-a-structure-case) in one table: `beam`, `block` or `mesh` with `section`, `width`, `material`, `materials`, `supports`, or \
`matrices = { mass, damping, stiffness, freedoms }`, whose factors are expressions of `[parameters]`; `damping` and `reduction` as tables within. A reduction keeps the freedoms that contact, load and observed points need by itself, `kept` adds others; left out, it keeps 20 fixed-interface modes.

Nodes are named by a `set` of a body; of matrices by `nodes = [17]`, as their table of freedoms numbers them; an observed point by one of them or by its place `at = [\"50 mm\", \"1 mm\"]`. Seven points of the slider at most can be observed, six of the track (four with `hermite`).

The path leads from `motion.start` to `motion.end`; where `end` lies before `start`, towards the first node of the track, the velocity is negative. The slider stands where C meets the track at `start`: a `beam.origin` of it has no effect. It lies on that side of the track on which its own middle lies then. Nodes of the track that do not follow each other in their set are taken in their order along the edge, towards +x (or +y), with a warning; `judder check` shows all of it. The damping matrix of imported matrices has to be α M + β K, to 1e-8 of its largest entry.

An item of a list goes by its name in `--set` and in swept keys: `structure.oblique.beam.angle`, `observe.points.T.set`, `analysis.ensubs.step`; an analysis without a name goes by its kind.
";

const SETTINGS: &str = "
A `locus` runs over `positions`, or holds the contact `at = \"74 mm\"` and takes `sweep = { key = \"contact.friction_coefficient\", from = 0.0, to = 1.0, points = 101 }`; \
`from`, `to` and the entries of `values = [ … ]` in place of them are plain numbers, or quantities with units. Where a value has no pair, because the slider locks or nothing holds it, the result says so and the others are computed all the same; then the exit code is 1.

A march by `\"ensubs\"` or `\"film\"` takes the geometry of the contact from displacements predicted for the next step: with `predictor = \"printed\"` without the contact's force, as equation (16) of the beams paper has them.

A `march` leaves every acceleration that it keeps, and its `signal`, as WAV; with `sound = false` none, with `sound = [\"T.y\", \"T.y.velocity\", \"normal-force\"]` these signals, each with its gain in the summary, an offset included.
";
