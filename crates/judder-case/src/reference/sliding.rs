//! What the page says of sliding cases.

use super::{kinds, row};
use crate::sliding::analysis::KINDS;
use crate::sliding_keys::SLIDING_KEYS;

/// The section on sliding cases.
pub(super) fn section() -> String {
    let mut page = HEAD.to_owned();
    for key in &SLIDING_KEYS {
        page += &row(key);
    }
    page += "\n### Analyses of a sliding case\n\n";
    page += &kinds(&KINDS);
    page + SETTINGS
}

const HEAD: &str = "
## Keys of a sliding case

`model = \"sliding\"` is one structure, the slider, whose contact point C slides along an edge of another, the track. `judder new beams-paper` prints the case of the beams paper with every key.

`[[structure]]` stands twice. Each has a `name` of letters, digits, `_` and `-`, and the keys of a [structure case](#keys-of-a-structure-case) in one table: `beam`, `block` or `mesh` with `section`, `width`, `material`, `materials`, `supports`, or \
`matrices = { mass, damping, stiffness, freedoms }`, whose factors are expressions of `[parameters]`; `damping` and `reduction` as tables within. A reduction keeps the freedoms that contact, load and observed points need by itself, `kept` adds others; left out, it keeps 20 fixed-interface modes.

| key | what it is |
| --- | --- |
| `contact.slider = { structure, set }` | the slider, and C, a set of one node; of matrices `nodes = [17]` in place of `set` |
| `contact.track = { structure, set }` | the other structure, and the nodes of its edge in their order: positions count from the first |
| `contact.friction_coefficient` | a number, or `{ velocity = [\"0 mm/s\", \"10 mm/s\"], coefficient = [0.4, 0.3] }` against the sliding speed: linear between, constant beyond |
| `contact.interpolation` | of the edge between its nodes: `\"linear\"` (the default) or `\"hermite\"`, of continuous slope |
| `motion.load = { set, direction, force }` | the force on the slider, along `\"x\"` or `\"y\"` (the default), on a node or on nodes that move as one |
| `motion.ramps = { velocity, load, friction, gap }` | times of half a cosine from zero; 0 is at once |
| `motion.initial_damping = { alpha, beta, hold, release }` | damping of both structures at the start, which then gives way to their own; left out, they have their own from the start on |
| `motion.noise = { force, seed }` | a random force on C; the same seed (1 where left out) gives the same force |
| `observe.points = [{ name, structure, set }]` | points whose motion along x and y a march keeps: their acceleration, on request velocity and displacement; instead of `set`, `nodes` of matrices, or the place `at = [\"50 mm\", \"1 mm\"]`, whose nearest node is taken; seven points of the slider at most, six of the track (four with `hermite`) |

The path leads from `motion.start` to `motion.end`; where `end` lies before `start`, towards the first node of the track, the velocity is negative. The slider stands where C meets the track at `start`: a `beam.origin` of it has no effect. It lies on that side of the track on which its own middle lies then. Nodes of the track that do not follow each other in their set are taken in their order along the edge, towards +x (or +y), with a warning; `judder check` shows all of it. The damping matrix of imported matrices has to be α M + β K, to 1e-8 of its largest entry.

An item of a list goes by its name in `--set` and in swept keys: `structure.oblique.beam.angle`, `observe.points.T.set`, `analysis.ensubs.step`; an analysis without a name goes by its kind.

| key | symbol | a plain number is | a string is | default | allowed | what it is |
| --- | --- | --- | --- | --- | --- | --- |
";

const SETTINGS: &str = "
`modes` takes the `structure`, and `count` or `band` as above.

A `locus` follows the `count` lowest eigenvalues (20 where left out) at each value, by the larger of imaginary and absolute real part, in the `configuration` `\"undeformed\"` (the default) or `\"deformed\"`, with `damping = false` without damping. It runs over `positions = { from, to, points }` (the path of the motion and 1000 points where left out), or \
holds the contact `at = \"74 mm\"` and takes `sweep = { key = \"contact.friction_coefficient\", from = 0.0, to = 1.0, points = 101 }` of any number of `structure`, `contact`, `motion` or `parameters`; \
`from`, `to` and the entries of `values = [ … ]` in place of them are plain numbers, or quantities with units. Each value is a case of its own. Where a value has no pair, because the slider locks or nothing holds it, the result says so and the others are computed all the same; then the exit code is 1.

The `method` of a `march` or a `growth` is `\"subs\"` (couplings of the rigid motion; with `slope = \"static\"` a march puts the static slope of the deformed track in), `\"ensubs\"` (couplings of the deformed structures), `\"film\"` (forward increment Lagrange multipliers) or `\"residual-flexibility\"` \
(exact between contacts, modes above `cut_off` replaced by their flexibility). In a `growth`, `\"subs\"` means the undeformed configuration, the others the deformed one. A march by `\"ensubs\"` or `\"film\"` takes the geometry of the contact from displacements predicted for the next step: with `predictor = \"printed\"` without the contact's force, \
as equation (16) of the beams paper has them; with `\"with-force\"` (the default) under the force of the last step.

A `march` goes `from` one position `to` another, the whole path where left out; the ramps run at its start. `signals = { pass_band, sample_rate }` says how signals are low-passed and decimated: 1/step ≥ sample_rate > 2 pass_band; `quantities = [\"acceleration\", \"velocity\", \"displacement\"]` in it what of every observed point is kept, along x and y: \"acceleration\" alone where left out. `signal` is the one whose peak and bursts are told: `\"T.y\"`, the acceleration of the point T along y, \
`\"T.y.velocity\"`, `\"T.y.displacement\"`, `\"normal-force\"`, `\"tangential-force\"`, `\"sliding-velocity\"`; the first point's acceleration along y where left out. A march leaves every acceleration that it keeps, and that signal, as WAV; with `sound = false` none, with `sound = [\"T.y\", \"T.y.velocity\", \"normal-force\"]` these signals, each with its gain in the summary, an offset included. Every `checkpoint_steps` steps (500000 where left out) an interrupted march can go on from.

A `spectrogram` takes `of`, the name of a march that stands above, a `signal` as above, `window` (`\"hann\"`, the default, `\"hamming\"`, `\"blackman\"` or `\"rectangular\"`), `reference`, the amplitude of 0 dB with a unit of the signal (1 of the SI unit where left out), `range = [-60.0, 40.0]` in dB, and `locus`, the name of a locus over positions that stands \
above and whose unstable zones are laid over.
";
