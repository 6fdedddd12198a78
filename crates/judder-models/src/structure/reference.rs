//! What the page says of structure cases.

use crate::structure::KINDS;
use crate::structure::case::body::BodyKeys;
use crate::structure::case::damping::Damping;
use crate::structure::case::reduction::Reduction;
use judder_keys::declared::Settings;
use judder_keys::reference::settings;
use judder_study::case::reference::kinds;

/// The section on structure cases.
pub(super) fn section() -> String {
    let mut page = HEAD.to_owned();
    for (name, keys) in [
        ("[structure]", BodyKeys::declarations()),
        ("[damping]", Damping::declarations()),
        ("[reduction]", Reduction::declarations()),
    ] {
        page += &settings(name, &keys);
    }
    page += MATRICES;
    page += "\n### Analyses of a structure case\n\n";
    page += &kinds(&KINDS);
    page + SETTINGS
}

const HEAD: &str = "
## Keys of a structure case

`model = \"structure\"` is one linear structure alone, M u″ + C u′ + K u = 0, from `[structure]` or from `[matrices]`.

`[structure]` takes one of

| key | what it is | sets of nodes |
| --- | --- | --- |
| `beam = { length, thickness, elements = [100, 2], angle, origin, start, end }` | a straight beam of eight-node quadrilaterals; `start` and `end` are `\"free\"`, `\"clamped\"` or `\"guided\"` \
(the end face keeps its shape, is held along x and moves as one along y) | `start`, `end`, `lower`, `upper`, `lower-corners`, `upper-corners`, and of one node each `start-lower`, `start-upper`, `end-lower`, `end-upper` |
| `block = { element, size = [\"1 m\", \"0.1 m\", \"0.1 m\"], cells = [20, 2, 2] }` | a rectangle or box of equal cells; `element` is one of `quad4`, `quad8` (the default in the plane), `triangle6`, \
`hexahedron8`, `hexahedron20` (the default in space), `tetrahedron10` | `x-min`, `x-max`, `y-min`, … |
| `mesh = \"part.msh\"` | a mesh file, Gmsh 4.1 (`.msh`) or Abaqus and CalculiX (`.inp`), lengths in m | those of the file |

and beside it what the table below has. `[damping]` takes `rayleigh` or `structural`; left out, there is none.

`[reduction]` keeps freedoms and fixed-interface modes (Craig and Bampton): `kept = [{ set = \"upper-corners\", directions = [\"y\"] }]` with all free directions where none are named, \
and `count` modes or all up to `cut_off`. Of matrices with a table of freedoms, `nodes = [1, 17]` stand in place of `set`.
";

const MATRICES: &str = "
`[matrices]` takes `mass`, `damping` (zero where left out) and `stiffness`, each a list of `{ file = \"K.mtx\", factor = \"speed^2 - 1\" }`: the sum of the files times their factors, which are numbers or expressions of \
`[parameters]` (1 where left out). Files are Matrix Market or Abaqus coordinate text (`.mtx`), MATLAB 5 (`.mat`) or SciPy (`.npz`), in `folder` (that of the case where left out; a folder given by `--set` is sought where the \
program runs first). `triangle = \"lower\"` or `\"upper\"`, of one term or of all, says that a file holds one triangle of a symmetric matrix, `\"as-stored\"` that a matrix with an empty triangle really is so. `freedoms = \"table.csv\"` names a table with node, direction and place of every \
degree of freedom.
";

const SETTINGS: &str = "
`modes`: of matrices that are not symmetric the modes are those without friction where the sums tell it, as matrices that are not symmetric and whose factors parameters set, else those of the symmetric part, which has half of the friction in it; a warning says which. `region = { re = [-50.0, 1000.0], im = [0.0, 20000.0] }` is a rectangle of λ = re + i im in 1/s and rad/s. The `sweep` of an `eigen-sweep` is `{ key = \"parameters.speed\", from = 1.0, to = 100.0, points = 100 }` or \
`{ key = \"parameters.speed\", values = [1.0, 2.0, 5.0] }`, with a `family` `{ key = \"parameters.load\", values = [ … ] }` there is one curve a value of another parameter; `method` is `\"full\"` (the default) or `\"projected\"`, which takes `tolerance`.
";
