//! What the page of the reference says of oscillator cases.

use super::KINDS;
use super::inputs::{FrictionLoad, LawName};
use super::keys::KEYS;
use crate::substrate::SubstrateKeys;
use judder_keys::declared::Settings;
use judder_keys::reference::{row, settings};
use judder_study::case::reference::kinds;

/// The section on them.
pub(super) fn section() -> String {
    let mut page = String::from(
        "## Keys of an oscillator case\n\n\
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
    page += &kinds(&KINDS);
    page += OSCILLATOR;
    page
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
