//! What the page says of sweeps of the whole case.

use crate::case::study_sweep::Design;
use crate::case::study_sweep::design::POINTS_LIMIT;
use crate::case::study_sweep::quantity_path::Reduction;
use crate::case::study_sweep::read::{RESAMPLES_LIMITS, SEED, SENSITIVITY};
use judder_numerics::sampling::sobol::DIMENSIONS_LIMIT;

/// The section on sweeps of the whole case.
pub(super) fn section() -> String {
    let methods = Design::NAMES.map(|name| format!("`\"{name}\"`")).join(", ");
    let reductions = Reduction::ALL.map(|(name, _)| format!("`{name}`")).join(", ");
    let [fewest, most] = RESAMPLES_LIMITS;
    HEAD.to_owned()
        + &format!(
            "| `name` | required | under which results are kept, unique among sweeps and analyses |\n\
             | `method` | `\"grid\"` | how points are chosen: {methods} |\n\
             | `over` | required | the swept keys, see below; {DIMENSIONS_LIMIT} at most, half as many with `sensitivity` of `\"sobol\"` |\n\
             | `points` | required | of `\"latin-hypercube\"` and `\"sobol\"`: how many points; a power of two fills the ranges most evenly with `\"sobol\"` |\n\
             | `seed` | {SEED} | of these two: which of all such points; the same seed gives the same points |\n\
             | `quantities` | required | what is kept of every point, see below |\n\
             | `chunk` | chosen by the program | points of a unit of work |\n\
             | `sensitivity` | `false` | of these two: `true`, or `{{ confidence = {}, resamples = {} }}` ({fewest} to {most} resamples): first-order and total Sobol' indices of \
             every quantity with bootstrap intervals of this confidence, from `points` rows of k + 2 points for k keys |\n",
            SENSITIVITY.confidence, SENSITIVITY.resamples
        )
        + &format!(
            "\nA sweep has at most {POINTS_LIMIT:e} points. {KEYS}\n\
             A quantity without a dot is one of the operating point; with a dot it is `ANALYSIS.PATH`, a way into what `summary.json` holds under the name of an analysis: a \
             name leads into a table, and into every table of a list; a number picks an item of a list, counted from 0; as the last step {reductions} make one number of a list. \
             `cycle.rms`, `thresholds.full.min`, `modes.frequencies_hz.0`, `locus.unstable.max_growth_rate.max`. What no result has is refused when the case is read.\n"
        )
}

const HEAD: &str = "
## Sweeps of the whole case

An analysis asks something at one operating point, a sweep asks it at many. A case of any model takes `[[sweep]]` tables beside `[[analysis]]`:

```toml
[[sweep]]
name = \"robustness\"
method = \"sobol\"
points = 4096
over = [
  { key = \"operation.velocity\", from = \"0.1 mm/s\", to = \"10 mm/s\", scale = \"log\" },
  { key = \"contact.shear_strength\", from = 0.001, to = 0.1, scale = \"log\" },
]
quantities = [\"growth_rate\", \"cycle.rms\"]
sensitivity = true
```

| key | default | what it is |
| --- | --- | --- |
";

const KEYS: &str = "Any number of the case can be swept, by its dotted path; an item of a list goes by its name, an analysis without one by its kind: `operation.velocity`, \
`structure.oblique.beam.angle`, `analysis.cycle.tolerance`. Each point is the case read anew with the keys set, so whatever follows from them follows. Values are plain numbers, or \
quantities with units, and `scale` is `\"linear\"` (the default) or `\"log\"`.

| method | an entry of `over` | points |
| --- | --- | --- |
| `\"grid\"` | `{ key, from, to, points, scale }` or `{ key, values }` | all combinations, the last key fastest |
| `\"list\"` | `{ key, values }`, all of one length | the first values of all keys, then the second, … |
| `\"latin-hypercube\"` | `{ key, from, to, scale }` | each range in as many parts as there are points, one point in each part |
| `\"sobol\"` | `{ key, from, to, scale }` | a Sobol' sequence, scrambled |

When the case is read, the ends of every range, and a value between them, are tried on it. A point at which there is no such case all the same is kept as failed, with the reason.
";
