//! The commented case files that `judder new` prints; the sections are generated from the table of keys.

use crate::belt::case::{BeltKey, BeltSections};
use crate::oscillator::case::OscillatorSections;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::keys::OscillatorKey;
use judder_keys::cause::Cause;
use judder_keys::declared::Settings;
use judder_keys::error::CaseError;
use judder_keys::keys::{Key, Keys};
use judder_keys::numeric_key::Form;

/// The names of the templates; the first is the default of `judder new`.
pub const TEMPLATES: [&str; 6] = ["oscillator", "contact", "belt", "two-degrees", "structure", "beams-paper"];

/// The commented case file of this name.
///
/// # Errors
/// [`Cause::UnknownTemplate`] names the known ones.
pub fn template(name: &str) -> Result<String, CaseError> {
    match name {
        "oscillator" => Ok(oscillator()),
        "contact" => Ok(contact()),
        "belt" => Ok(belt()),
        "two-degrees" => Ok(TWO_DEGREES.to_owned()),
        "structure" => Ok(STRUCTURE.to_owned()),
        "beams-paper" => Ok(BEAMS_PAPER.to_owned()),
        _ => {
            let known = TEMPLATES.map(String::from).to_vec();
            Err(CaseError::without_place(Cause::UnknownTemplate { name: name.to_owned(), known }, name))
        }
    }
}

fn oscillator() -> String {
    let mut text = OSCILLATOR_HEAD.to_owned();
    for section in OscillatorSections::keys() {
        text.push_str("\n[");
        text.push_str(section);
        text.push_str("]\n");
        if section == "contact" {
            text.push_str(CONTACT_CHOICES);
        }
        OscillatorKey::of_section(section).for_each(|entry| text.push_str(&line(entry)));
    }
    text + OSCILLATOR_ANALYSES
}

fn belt() -> String {
    let mut text = BELT_HEAD.to_owned();
    for section in BeltSections::keys() {
        text.push_str(&format!("\n[{section}]\n"));
        for entry in BeltKey::of_section(section) {
            let value = entry.default.unwrap_or_default();
            let setting = format!("{} = {value}", entry.name());
            text.push_str(&format!("{setting:<34}# {}: {}\n", entry.symbol, entry.doc));
        }
    }
    text + BELT_ANALYSES
}

fn contact() -> String {
    let mut text = CONTACT_HEAD.to_owned();
    for section in ["substrate", "indenter"] {
        text.push_str(&format!("\n[{section}]\n"));
        OscillatorKey::of_section(section).for_each(|entry| text.push_str(&line(entry)));
        text.push_str(if section == "substrate" { SUBSTRATE_CHOICES } else { SHAPE_CHOICES });
    }
    text + CONTACT_ANALYSES
}

/// `velocity = 1e-4  # v_d τ/R, or with a unit ("30 mm/s"): driving speed`; a key
/// without a default shows, as a comment, the value that follows from the others.
fn line(entry: &Key<OscillatorKey>) -> String {
    let dimension = entry.rule.dimension;
    let (mark, value) = match entry.default.zip(entry.usual_value()) {
        Some((text, value)) if value.form == Form::Group => ("", text.to_owned()),
        Some((text, _)) => ("", format!("\"{text}\"")),
        None => {
            let number = OscillatorInputs::default().number(entry.key);
            ("# ", format!("\"{number} {}\"", dimension.unit()))
        }
    };
    let symbol = match entry.rule.group {
        Some(group) if !dimension.is_number() => {
            format!("{group}, or {dimension} (\"{}\")", dimension.example())
        }
        _ => entry.symbol.to_owned(),
    };
    let setting = format!("{mark}{} = {value}", entry.name());
    format!("{setting:<34}# {symbol}: {}\n", entry.doc)
}

const OSCILLATOR_HEAD: &str = "\
# A case of judder: an oscillator with two degrees of freedom on a viscoelastic substrate.
# A plain number is the oscillator paper's dimensionless group; a string carries a unit. Every key that is left
# out takes the value shown here, which is the paper's.

title = \"An oscillator on rubber\"
model = \"oscillator\"
";

const CONTACT_CHOICES: &str = "\
law = \"oscillator-paper\"          # as printed; or \"oscillator-paper-corrected\", \"hertz\", \"bem\", { file = \"law.json\" }
friction_load = \"normal-load\"     # F_n μ_visc as printed; or \"contact-force\", F_k μ_visc
";

const OSCILLATOR_ANALYSES: &str = "
# A swept key is any numeric key above, by its dotted path. Each analysis has a name of its own.

[[analysis]]
name = \"map\"
kind = \"stability-map\"            # stable and unstable points over two keys
x = { key = \"operation.velocity\", from = 1e-8, to = 1e2, points = 400, scale = \"log\" }
y = { key = \"contact.shear_strength\", from = 1e-4, to = 1.0, points = 400, scale = \"log\" }
method = \"adaptive\"               # or \"every-point\"
boundaries = true                 # trace the boundary curves as well
global_margin = false             # true: where steady sliding is stable, but a knock starts a cycle

[[analysis]]
name = \"eigenvalues\"
kind = \"spectrum\"                 # the eigenvalues along one key
sweep = { key = \"contact.shear_strength\", from = 1e-4, to = 1.0, points = 200, scale = \"log\" }
family = { key = \"operation.velocity\", values = [1e-6, 1e-4, 1e-2] }   # optional: one set of curves a value

[[analysis]]
name = \"damping\"
kind = \"equivalent-damping\"       # ξ_eq along one key
sweep = { key = \"operation.velocity\", from = 1e-8, to = 1e2, points = 200, scale = \"log\" }

[[analysis]]
name = \"thresholds\"
kind = \"critical-shear-strength\"  # all roots along one key; likewise \"critical-load\"
sweep = { key = \"operation.velocity\", from = 1e-8, to = 1e2, points = 21, scale = \"log\" }
within = { from = 1e-6, to = 1e3 } # where roots are sought
global_margin = false             # true: how far beside each threshold a knock starts a motion, some seconds each

[[analysis]]
name = \"motion\"
kind = \"motion\"                   # stick, slip, lift-off over time
duration = 2000                   # ω_nx t, or a time (\"50 s\"); averages leave out the first half, or `transient`
# start = { x = 0.1, y = 1.0, velocity_x = 0.0, velocity_y = 0.0 }   # in x0 and ω_nx; or { disturbance = 0.2 }, of |x_e|

[[analysis]]
name = \"diagram\"
kind = \"bifurcation\"              # what motions settle to along one key, up and down; likewise \"limit-cycle\" at one point
sweep = { key = \"contact.shear_strength\", from = 1e-3, to = 1e-1, points = 20, scale = \"log\" }
direction = \"both\"                # or \"forward\", \"backward\"
branches = false                  # true: follow the branches of cycles, stable and unstable

[[analysis]]
name = \"knocks\"
kind = \"basin\"                    # from which share of the starts steady sliding is reached
within = { velocity_x = [-0.05, 0.05] }   # drawn evenly; what is left out stands as in steady sliding
samples = 200
seed = 1

[[analysis]]
name = \"engines\"
kind = \"engines\"                  # the cycle by events, by time-stepping and with a smoothed sign, for a doubt of your own
time_step = { from = 1e-3, to = 1e-1, points = 7 }   # ω_nx t, or times
width = { from = 1e-3, to = 1.0, points = 7 }        # ε of the smoothed sign, over v_d

# The whole study at many points, as many as you like: `judder run` computes them chunk by chunk and goes on where it was stopped.
# [[sweep]]
# name = \"robustness\"
# method = \"sobol\"                # or \"grid\", \"list\", \"latin-hypercube\"
# points = 1024
# sensitivity = true                # which key decides: Sobol' indices with intervals
# over = [
#   { key = \"operation.velocity\", from = 1e-6, to = 1e-2, scale = \"log\" },
#   { key = \"oscillator.damping_x\", from = 0.005, to = 0.05 },
# ]
# quantities = [\"growth_rate\", \"verdict\"]   # or of an analysis above: \"motion.rms\"
";

const BELT_HEAD: &str = "\
# A case of judder: one mass on a moving belt, x″ + 2ξ x′ + x = −sgn(v_rel) N μ(|v_rel|), v_rel = x′ − v. Mass and natural
# frequency are the units. Every key that is left out takes the value shown here.

title = \"A mass on a belt\"
model = \"belt\"
";

const BELT_ANALYSES: &str = "
[[analysis]]
name = \"motion\"
kind = \"motion\"                   # stick and slip over time
start = { x = 1.0, velocity_x = 1.0 }
duration = 200
transient = 100                   # averages leave it out

[[analysis]]
name = \"cycle\"
kind = \"limit-cycle\"              # the cycle that the motion settles to, with its Floquet multipliers
start = { x = 1.0, velocity_x = 1.0 }

[[analysis]]
name = \"diagram\"
kind = \"bifurcation\"              # up and down, each motion from the end of the one before
sweep = { key = \"operation.velocity\", from = 0.5, to = 2.0, points = 31 }
start = { x = 1.0, velocity_x = 1.0 }

[[analysis]]
name = \"basin\"
kind = \"basin\"                    # from which share of the starts steady sliding is reached
within = { x = [-2.0, 2.0], velocity_x = [0.0, 2.0] }
samples = 200
seed = 1
";

const CONTACT_HEAD: &str = "\
# A case of judder: a rigid indenter that slides steadily on a viscoelastic substrate.
# A plain number is a dimensionless group; a string carries a unit. Every key that is left out takes the value shown
# here, which is the oscillator paper's.

title = \"A paraboloid on rubber\"
model = \"contact\"
";

const SUBSTRATE_CHOICES: &str = "\
# In place of the time and the glassy modulus, one of:
# prony = [{ time = \"10 ms\", compliance = \"0.9e-6 1/Pa\" }]       # retardation times, ascending, and compliances
# relaxation = [{ time = \"1 ms\", modulus = \"9 MPa\" }]             # relaxation times, ascending, and moduli
# continuous = { log_normal = { median = \"10 ms\", width = 1 } }     # a continuous spectrum between both moduli
# dma = { file = \"data.csv\", terms = \"auto\" }                     # a series fitted to measured moduli
# The temperature, and how it moves all times:
# temperature = \"40 degC\"
# shift = { wlf = { c1 = 17.4, c2 = \"51.6 K\", reference_temperature = \"25 degC\" } }
";

const SHAPE_CHOICES: &str = "\
shape = \"paraboloid\"            # or \"sphere\", \"cylinder\", { heights = \"file.npy\", spacing = \"1 um\" },
                                  # where turned_over = true lets the largest heights touch first,
                                  # { rough = { period = \"1 mm\", cells = 256, hurst = 0.8, rms_height = \"1 um\", seed = 1 } }
";

const CONTACT_ANALYSES: &str = "
[[analysis]]
name = \"modulus\"
kind = \"modulus\"                  # storage and loss modulus, loss tangent
# frequency = { from = \"1 Hz\", to = \"1 kHz\", points = 200 }

[[analysis]]
name = \"contact\"
kind = \"contact\"                  # one contact: force, area, friction, fields
velocity = 1e-2                   # v τ/R, or a speed (\"30 mm/s\")
indentation = 1e-2                # δ/R, or a length; or in its place load = 1e-4, F/(E0* R²), or a force
accuracy = 1e-3                   # relative, of the force

[[analysis]]
name = \"law\"
kind = \"contact-law\"              # force, area, friction over speed and indentation; leaves law.json for an oscillator
velocity = { from = 1e-6, to = 1e4, points = 51 }
indentation = { from = 1e-4, to = 1e-1, points = 16 }
accuracy = 1e-2
method = \"collapse\"               # exact for a paraboloid; or \"sweep\"

[[analysis]]
name = \"fit\"
kind = \"fit\"                      # the three functions of the oscillator paper
velocity = { from = 1e-6, to = 1e4, points = 51 }
indentation = { from = 1e-4, to = 1e-1, points = 16 }
velocity_scale = 0.01             # factor of v τ/R at which the functions are read
";

const TWO_DEGREES: &str = "\
# A case of judder: two degrees of freedom with matrices of your own. This one is the minimal model of mode
# coupling: friction makes K unsymmetric, and at mu = 0.75 two frequencies merge.

title = \"The minimal mode-coupling model\"
model = \"two-degrees\"

[parameters]                      # plain numbers that expressions use and sweeps vary
mu = 0.5

[matrices]                        # 2×2, numbers or expressions: + - * / ^ ( ), pi, sin, cos, exp, sqrt, …
mass = [[1, 0], [0, 1]]           # the default
damping = [[0, 0], [0, 0]]        # the default
stiffness = [[2, \"1 - 4*mu/3\"], [1, 2]]

[[analysis]]
name = \"eigenvalues\"
kind = \"spectrum\"                 # the eigenvalues along one parameter
sweep = { key = \"parameters.mu\", from = 0.0, to = 1.5, points = 151 }

[[analysis]]
name = \"onset\"
kind = \"critical\"                 # the values at which stability changes
sweep = { key = \"parameters.mu\", from = 0.0, to = 1.5 }
";

/// The case of the beams paper with every reading of what it does not print.
const BEAMS_PAPER: &str = include_str!("template/beams-paper.toml");

const STRUCTURE: &str = "\
# A case of judder: one linear structure alone. This one is the horizontal beam of the beams paper, held at one end.

title = \"A cantilever\"
model = \"structure\"

[structure]                       # in place of the beam: block = { … } or mesh = \"file.msh\", see below
beam = { length = \"100 mm\", thickness = \"2 mm\", elements = [100, 2], angle = \"0 deg\", start = \"clamped\", end = \"free\" }
section = \"plane-stress\"          # or \"plane-strain\"; without meaning in space
width = \"20 mm\"                   # across the plane
material = { youngs_modulus = \"2.38 GPa\", poisson_ratio = 0.4, density = \"1200 kg/m^3\" }
# supports = [{ set = \"end\", tied = [\"y\"] }]                        # of any set of nodes: fixed, or moving as one

# In place of the beam, one of:
# block = { element = \"hexahedron20\", size = [\"1 m\", \"0.1 m\", \"0.1 m\"], cells = [20, 2, 2] }   # sets x-min, x-max, y-min, …
# mesh = \"part.msh\"                # Gmsh 4.1 (physical names are sets) or Abaqus/CalculiX .inp, relative to this file
# materials = { steel = { youngs_modulus = \"210 GPa\", poisson_ratio = 0.3, density = \"7850 kg/m^3\" } }   # by the mesh's names
#
# In place of [structure] and [damping], what another program assembled, with factors of [parameters]:
# [parameters]
# speed = 6.28
# [matrices]
# folder = \"matrices\"
# mass      = [{ file = \"M.mtx\" }]
# damping   = [{ file = \"D.mtx\" }, { file = \"G.mtx\", factor = \"speed\" }]
# stiffness = [{ file = \"K.mtx\", triangle = \"lower\" }, { file = \"KR.mtx\" }]
# freedoms  = \"freedoms.csv\"      # node, direction, x, y, z of every degree of freedom

[damping]                         # C = α M + β K; or structural = { loss_factor = 0.02, reference_frequency = \"1 kHz\" }
rayleigh = { alpha = \"40 1/s\", beta = \"4e-8 s\" }

[reduction]                       # Craig and Bampton: freedoms that are kept, modes with these held
kept = [{ set = \"upper-corners\" }]
count = 20                        # or cut_off = \"20 kHz\"

[[analysis]]
name = \"modes\"
kind = \"modes\"                    # undamped modes
count = 12                        # from the lowest on; or band = [\"1 kHz\", \"10 kHz\"]

[[analysis]]
name = \"reduced\"
kind = \"reduction\"                # reduced against full
count = 12

[[analysis]]
name = \"damped\"
kind = \"eigen\"                    # complex modes in a region: growth rates in 1/s, angular frequencies in rad/s
region = { re = [-500.0, 100.0], im = [0.0, 50000.0] }
";
