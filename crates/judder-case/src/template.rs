//! The commented case files that `judder new` prints; the sections are generated from the table of keys.

use crate::cause::Cause;
use crate::error::CaseError;
use crate::inputs::OscillatorInputs;
use crate::keys::{Form, KEYS, Key};
use crate::oscillator_case::SECTIONS;

/// The names of the templates; the first is the default of `judder new`.
pub const TEMPLATES: [&str; 2] = ["oscillator", "two-degrees"];

/// The commented case file of this name.
///
/// # Errors
/// [`Cause::UnknownTemplate`] names the known ones.
pub fn template(name: &str) -> Result<String, CaseError> {
    match name {
        "oscillator" => Ok(oscillator()),
        "two-degrees" => Ok(TWO_DEGREES.to_owned()),
        _ => {
            let known = TEMPLATES.map(String::from).to_vec();
            Err(CaseError::without_place(Cause::UnknownTemplate { name: name.to_owned(), known }, name))
        }
    }
}

fn oscillator() -> String {
    let mut text = OSCILLATOR_HEAD.to_owned();
    for section in SECTIONS {
        text.push_str("\n[");
        text.push_str(section);
        text.push_str("]\n");
        if section == "contact" {
            text.push_str(CONTACT_CHOICES);
        }
        for entry in KEYS.iter().filter(|entry| entry.section() == section) {
            text.push_str(&line(entry));
        }
    }
    text + OSCILLATOR_ANALYSES
}

/// `velocity = 1e-4  # v_d τ/R, or with a unit ("30 mm/s"): driving speed`; a key
/// without a default shows, as a comment, the value that follows from the others.
fn line(entry: &Key) -> String {
    let (mark, value) = match entry.default {
        Some((text, value)) if value.form == Form::Group => ("", text.to_owned()),
        Some((text, _)) => ("", format!("\"{text}\"")),
        None => {
            let number = OscillatorInputs::default().number(entry.key);
            ("# ", format!("\"{number} {}\"", entry.dimension.unit()))
        }
    };
    let symbol = match entry.group {
        Some(group) if !entry.dimension.is_number() => {
            format!("{group}, or {} (\"{}\")", entry.dimension, entry.dimension.example())
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
law = \"oscillator-paper\"          # as printed; or \"oscillator-paper-corrected\", \"hertz\"
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
sweep = { key = \"operation.velocity\", from = 1e-8, to = 1e2, points = 101, scale = \"log\" }
within = { from = 1e-6, to = 1e3 } # where roots are sought
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
