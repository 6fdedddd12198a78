//! What the page of the reference says of contact cases.

use super::KINDS;
use super::case::IndenterKeys;
use judder_keys::declared::Settings;
use judder_keys::reference::settings;
use judder_study::case::reference::kinds;

/// The section on them.
pub(super) fn section() -> String {
    let mut page = CONTACT.to_owned();
    page += &settings("[indenter]` beside `radius", &IndenterKeys::declarations());
    page += "\n### Analyses of a contact case\n\n";
    page += &kinds(&KINDS);
    page += CONTACT_RANGES;
    page
}

/// What a contact case has, before the table of its numbers.
const CONTACT: &str = "
## Keys of a contact case

`model = \"contact\"` takes `[substrate]` as above, `[indenter]` with `radius` and `shape`, and analyses. `shape` is `\"paraboloid\"` (the default), \
`\"sphere\"`, `\"cylinder\"` (a line contact: forces are per length), a height map `{ heights = \"file.npy\", spacing = \"1 um\" }`, or a generated surface \
`{ rough = { period = \"1 mm\", cells = 256, hurst = 0.8, rms_height = \"1 um\", seed = 1 } }`.

`memory_limit = \"4 GiB\"`, of the case or of one analysis, is what the largest grid of one contact may take (4 GiB where left out; units TiB, GiB, MiB, KiB, \
TB, GB, MB, kB). A law solves as many contacts at a time as there are threads. A grid that needs more is refused before it is made.
";

/// What follows the analyses of a contact case.
const CONTACT_RANGES: &str = "
A `contact` takes `velocity` and either `indentation` or `load`. In the kinds `contact-law`, `fit` and `modulus`, `velocity`, `indentation` and `frequency` are ranges \
with equal ratios between their points. The method `collapse` is one curve over v τ/√(R δ), exact for a paraboloid. \
A law is `converged` where the errors of its interpolation and of its contacts together are within its accuracy, which is that of the force.

A `transient` takes `motion`, `duration`, and either `indentation` or `load`. `motion = \"start\"` takes `velocity`, at which the indenter slides from time 0 on; \
`\"reciprocation\"` takes `amplitude` and `frequency` of its position; `\"rest\"` neither. `oscillation = { amplitude = 1e-3, frequency = 0.4 }` adds a wave to the \
`indentation` at rest or after a start. Before time 0 the contact has rested for ever; at rest without `oscillation` the indenter presses on an untouched \
substrate at time 0.
";
