//! The reference page of the book: every key and every kind of analysis, from the tables that read them.

mod sliding;
mod structure;
mod sweep;

use crate::case::analysis::Kind;
use crate::models::belt::case as belt_case;
use crate::models::belt::case::BELT_KEYS;
use crate::models::contact;
use crate::models::contact::case::IndenterKeys;
use crate::models::oscillator;
use crate::models::oscillator::inputs::{FrictionLoad, LawName};
use crate::models::oscillator::keys::KEYS;
use crate::models::substrate::SubstrateKeys;
use crate::models::two_degrees::case as two_degrees;
use judder_keys::declared::Settings;
use judder_keys::reference::{row, settings, without_repetition};

/// The page, as Markdown.
pub fn reference() -> String {
    let mut page = String::from(
        "# Case files\n\n\
         A case is a TOML file. A plain number is the paper's dimensionless group, a string carries a unit (`\"30 mm/s\"`, `\"0.2 N\"`, `\"1 MPa\"`, \
         `\"30 deg\"`). Keys left out take the values below; the keys of a table, as `sweep.from`, stand where it comes first. `judder schema` prints the JSON Schema, `judder new` a commented case. \
         A case is a file of at most 1 MiB.\n\n\
         ## Keys of an oscillator case\n\n\
         | key | symbol | a plain number is | a string is | default | allowed | what it is |\n\
         | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    for key in &KEYS {
        page += &row(key);
    }
    let laws: Vec<String> = LawName::ALL.iter().map(|(name, _)| format!("`{name}`")).collect();
    let loads: Vec<String> = FrictionLoad::ALL.iter().map(|(name, _)| format!("`{name}`")).collect();
    page += &format!(
        "\n`contact.law` is one of {}, or `{{ file = \"law.json\" }}`, a law that a contact case has left, or `{{ computed = true, accuracy = 3e-3 }}`; `contact.friction_load` is one of {}. \
         The law `bem` is computed for the case's own substrate under a paraboloid, to an accuracy of 1e-2, or as accurately as the last form says.\n",
        laws.join(", "),
        loads.join(", ")
    );
    page += SUBSTRATE;
    page += &settings("[substrate]` beside moduli, times and `poisson_ratio", &SubstrateKeys::declarations());
    page += "\n## Analyses of an oscillator case\n\n";
    page += &kinds(&oscillator::KINDS);
    page += OSCILLATOR;
    page += CONTACT;
    page += &settings("[indenter]` beside `radius", &IndenterKeys::declarations());
    page += "\n### Analyses of a contact case\n\n";
    page += &kinds(&contact::KINDS);
    page += CONTACT_RANGES;
    page += BELT;
    for key in &BELT_KEYS {
        page += &row(key);
    }
    page += "\n### Analyses of a belt case\n\n";
    page += &kinds(&belt_case::KINDS);
    page += "\n## Analyses of a two-degrees case\n\n\
             `[parameters]` holds numbers by name; `[matrices]` holds `mass` (identity by default), `damping` (zero by default) and `stiffness` as 2 × 2 \
             arrays of numbers or expressions of the parameters. Swept keys are `parameters.NAME`.\n\n";
    page += &kinds(&two_degrees::KINDS);
    page += &structure::section();
    page += &sliding::section();
    page += "\nA sweep within an analysis is `{ key = \"operation.velocity\", from = 1e-8, to = 1e2, points = 21, scale = \"log\" }` (`scale` is `linear` where left out), a \
             `family` is `{ key = \"…\", values = [ … ] }`, one curve a value, and `within` is `{ from = 1e-6, to = 1e3 }`. `method` is `adaptive` (the \
             default) or `every-point`; `boundaries = false` leaves the curves out.\n";
    page + &sweep::section()
}

/// How the relaxation of a substrate is given.
const SUBSTRATE: &str = "
The relaxation of the substrate is given in one of these ways. A *retardation* time belongs to creep at constant stress, a *relaxation* time to the \
decay of stress at constant strain; for one term the second is E0/E∞ of the first.

| key of `[substrate]` | what it says |
| --- | --- |
| `retardation_time` | one retardation time, with both moduli |
| `relaxation_time` | one relaxation time, with both moduli |
| `prony = [{ time = \"10 ms\", compliance = \"0.9e-6 1/Pa\" }, …]` | retardation times and creep compliances; 1/E∞ = 1/E0 − Σ C_k follows |
| `relaxation = [{ time = \"1 ms\", modulus = \"9 MPa\" }, …]` | relaxation times and moduli; E∞ = E0 + Σ E_j follows |
| `continuous = { log_normal = { median = \"10 ms\", width = 1 } }` | a continuous spectrum 𝒞(τ) between both moduli; or `power_law = { from = \"1 us\", to = \"1 s\", exponent = 0.3 }`, or `samples = [{ time = \"1 ms\", density = \"1e-5 1/Pa/s\" }, …]`, from which the glassy modulus follows |
| `dma = { file = \"data.csv\", terms = \"auto\" }` | a series fitted to measured storage and loss moduli; the glassy modulus follows, and the rubbery one unless it is given |

A continuous spectrum, 1/E(ω) = 1/E∞ + ∫ 𝒞(τ)/(1 + iωτ) dτ, is taken apart into as few retardation times as keep E(ω) within `accuracy` (1e-3 where \
left out) at every frequency, or into as many as `terms` says; `judder check` and every result show the error. Log-normal means that τ𝒞 is a Gaussian in \
log₁₀ τ, a power law 𝒞 ∝ τ^(m − 1); between samples τ𝒞 is linear in ln τ.

Times ascend. Where there are several, the τ of the groups (v τ/R, ω τ) is the mean retardation time Σ C_k τ_k/Σ C_k. The fitted laws know one time \
only. `temperature = \"40 degC\"` with `shift = { wlf = { c1 = 17.4, c2 = \"51.6 K\", reference_temperature = \"25 degC\" } }` or \
`shift = { arrhenius = { activation_energy = \"80 kJ/mol\", reference_temperature = \"25 degC\" } }` moves all times. A path is relative to the case file.
";

/// What is said of the analyses of an oscillator besides.
const OSCILLATOR: &str = "
With `global_margin` a map is followed along `contact.shear_strength` or `operation.normal_load` where one of them is an axis (`y` before `x`), otherwise along `y`; on 30 lines at most.

### Analyses of motion

`motion`, `limit-cycle`, `bifurcation`, `basin` and `engines` follow the motion through [stick, slip and lift-off](theory/motion.md). A `start` is a `disturbance` or the other keys of it, \
a state: what is left out stands as in steady sliding, as it does in `within`. Each motion of a `bifurcation` starts where the one before has ended.
";

/// What a belt case has, before the table of its numbers.
const BELT: &str = "
## Keys of a belt case

`model = \"belt\"` is one mass on a moving belt, x″ + 2ξ x′ + x = −sgn(v_rel) N μ(|v_rel|) with v_rel = x′ − v and μ(v) = μ_∞ + (μ_0 − μ_∞) e^(−|v|/v_0). Mass \
and natural frequency are the units.

| key | symbol | a plain number is | a string is | default | allowed | what it is |
| --- | --- | --- | --- | --- | --- | --- |
";

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

fn kinds<S, T>(kinds: &[Kind<S, T>]) -> String {
    let mut table =
        String::from("| kind | keys beside `name` and `kind` | what it computes |\n| --- | --- | --- |\n");
    for kind in kinds {
        let Kind { name, doc, .. } = kind;
        let keys: Vec<String> = kind.keys().iter().map(|key| format!("`{key}`")).collect();
        table += &format!("| `{name}` | {} | {doc} |\n", keys.join(", "));
    }
    let declared = kinds.iter().map(|kind| settings(kind.name, &(kind.declared)()));
    without_repetition(&declared.fold(table, |page, own| page + &own))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `JUDDER_BLESS=1` writes the page anew.
    #[test]
    fn the_page_of_the_book_is_this_one() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/src/case-files.md");
        if std::env::var_os("JUDDER_BLESS").is_some() {
            std::fs::write(path, reference()).unwrap();
        }
        assert_eq!(std::fs::read_to_string(path).unwrap(), reference(), "run this test with JUDDER_BLESS=1");
    }
}
