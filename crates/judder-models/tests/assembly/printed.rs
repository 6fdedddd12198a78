//! The table of printed numbers in the book is what the cases give.

use super::minimal::{damping_ratio, fastest, fastest_growth, results};
use super::responses::{damper, stop};
use super::turning::{critical_speed, ring};
use crate::{case, number, run_into};
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};

/// A number that somebody printed.
struct Printed {
    case: &'static str,
    source: &'static str,
    what: &'static str,
    printed: &'static str,
    found: f64,
    /// Whether it comes from matrices of thousands of rows, which leave fewer digits.
    is_of_meshes: bool,
}

impl Printed {
    fn row(&self) -> String {
        let Self { case, source, what, printed, found, is_of_meshes } = self;
        let of: f64 = printed.parse().unwrap();
        format!(
            "| `{case}` | {source} | {what} | {printed} | {} | {:+.1e} |\n",
            digits(*found, if *is_of_meshes { 5 } else { 8 }),
            found / of - 1.0
        )
    }
}

/// So many digits.
fn digits(value: f64, count: i32) -> String {
    let exponent = value.abs().log10().floor() as i32;
    match exponent {
        -3..=6 => format!("{value:.*}", (count - 1 - exponent).max(0) as usize),
        _ => format!("{value:.*e}", (count - 1) as usize),
    }
}

const HEAD: &str =
    "| case | source | number | printed | judder | difference |\n| --- | --- | --- | --- | --- | --- |\n";

/// The rows of minimal models, which take no time.
fn of_minimal_models() -> String {
    let belt = damping_ratio(&case("assembly/mass-on-belt.toml", &[]));
    let incline = results(&case("assembly/block-on-incline.toml", &[]));
    let incline = &incline["steady"]["contacts"]["incline"];
    let [x, y] = [0, 1].map(|axis| number(&incline["tangential_force"][axis]));
    let normal = number(&incline["normal_force"]);
    let held = normal * 20_f64.to_radians().sin() + x;
    let coupling = case("assembly/mode-coupling.toml", &[]);
    let (growth, merging) = (fastest_growth(&coupling), results(&coupling)["friction"]["onsets"][0].clone());
    let [merges, frequency] = ["value", "frequency_hz"].map(|key| number(&merging[key]));
    let strut = results(&case("assembly/sprag-slip.toml", &[]));
    let digs = number(&strut["steady"]["contacts"]["surface"]["normal_force"]) / 10.0;
    let locks = number(&strut["steady"]["friction_limit"]) * 0.4;
    let ([rms, beneath_the_fold], _) = stop();
    let [amplitude, resonance] = damper();
    let row = |case, source, what, printed, found| {
        Printed { case, source, what, printed, found, is_of_meshes: false }.row()
    };
    let hoffmann = "Hoffmann 2002, closed form";
    [
        row("mass-on-belt", "ANSYS VM274", "damping ratio", "4.98012e-4", belt),
        row("block-on-incline", "ANSYS VM29", "normal force", "95.942", normal),
        row("block-on-incline", "ANSYS VM29", "friction force", "28.783", x.hypot(y)),
        row("block-on-incline", "ANSYS VM29", "force that holds it", "5.76728", held),
        row("mode-coupling", hoffmann, "growth rate at μ = 1", "0.2020717688", growth),
        row("mode-coupling", hoffmann, "friction at which the modes merge", "0.75", merges),
        row("mode-coupling", hoffmann, "its frequency (Hz)", "0.2250790790", frequency),
        row("sprag-slip", "Spurr 1961, closed form", "normal force over load", "3.2554236981", digs),
        row("sprag-slip", "Spurr 1961, closed form", "friction at which it locks", "0.5773502692", locks),
        row("stop", "NLvib, example 3", "root mean square (m)", "1.01297", rms),
        row("stop", "NLvib, example 3", "its frequency (rad/s)", "0.75375", beneath_the_fold),
        row("friction-damper", "ANSYS VM320", "amplitude (m)", "1.50e-5", amplitude),
        row("friction-damper", "ANSYS VM320", "its frequency (rad/s)", "209", resonance),
    ]
    .concat()
}

/// The rows of bodies that are meshes.
fn of_meshes() -> String {
    let ([two, three, against, along], critical) = (ring([1, 160, 2]), critical_speed());
    let [width, pressure] = cylinders();
    let near = "analysis.modes.band=[\"2 kHz\", \"2.5 kHz\"]";
    let [_, locked] = fastest(&case("assembly/pin-on-disc.toml", &[near]));
    let row = |case, source, what, printed, found| {
        Printed { case, source, what, printed, found, is_of_meshes: true }.row()
    };
    [
        row("cattaneo-mindlin", "ANSYS VM272, pressed", "half-width (mm)", "0.68078", width * 1e3),
        row("cattaneo-mindlin", "ANSYS VM272, pressed", "largest pressure (MPa)", "9.3514", pressure / 1e6),
        row("pin-on-disc", "ANSYS VM275", "unstable mode (Hz)", "2215", locked / TAU),
        row("critical-speed", "ANSYS VM301", "critical speed (rpm)", "2650", critical),
        row("rotating-ring", "ANSYS VM302", "two waves at rest (Hz)", "75.30", two),
        row("rotating-ring", "ANSYS VM302", "three waves at rest (Hz)", "209.93", three),
        row("rotating-ring", "ANSYS VM302", "two waves against the turning (Hz)", "91.54", against),
        row("rotating-ring", "ANSYS VM302", "two waves along it (Hz)", "411.54", along),
    ]
    .concat()
}

/// Half the width of what is closed between two cylinders in m, by the areas that its nodes stand for, and the largest pressure in Pa.
fn cylinders() -> [f64; 2] {
    const THICKNESS: f64 = 1e-3;
    let folder = tempfile::tempdir().unwrap();
    let file = case("assembly/cattaneo-mindlin.toml", &[]);
    let results = run_into(folder.path(), &file, &["steady"]).summary.results;
    let table = std::fs::read_to_string(folder.path().join("steady.csv")).unwrap();
    let closed = table.lines().filter(|line| line.ends_with(",closed"));
    let column = |line: &str, place: usize| line.split(',').nth(place).unwrap().parse::<f64>().unwrap();
    let area: f64 = closed.map(|line| column(line, 5) / column(line, 7)).sum();
    [0.5 * area / THICKNESS, number(&results["steady"]["contacts"]["line"]["pressure_max"])]
}

/// The page of the book: what stands before the table, the table, what stands after it.
fn page() -> (PathBuf, [String; 3]) {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src/theory/assemblies.md");
    let text = std::fs::read_to_string(&page).unwrap();
    let (before, rest) = text.split_once("<!-- printed numbers -->\n").unwrap();
    let (own, after) = rest.split_once("<!-- end -->").unwrap();
    let parts = [before, own, after].map(str::to_owned);
    (page, parts)
}

fn is_to_be_written() -> bool {
    std::env::var("JUDDER_GOLDEN").is_ok_and(|word| word == "write")
}

#[test]
fn printed_numbers_of_minimal_models_are_those_of_the_cases() {
    let (_, [_, own, _]) = page();
    let expected = format!("{HEAD}{}", of_minimal_models());
    assert!(
        is_to_be_written() || own.starts_with(&expected),
        "JUDDER_GOLDEN=write and --run-ignored all write it:\n{expected}{own}"
    );
}

#[test]
#[ignore = "expensive: run by make validate"]
fn printed_numbers_of_the_book_are_those_of_the_cases() {
    let (page, [before, own, after]) = page();
    let table = format!("{HEAD}{}{}", of_minimal_models(), of_meshes());
    if is_to_be_written() {
        let text = format!("{before}<!-- printed numbers -->\n{table}<!-- end -->{after}");
        std::fs::write(&page, text).unwrap();
        return;
    }
    assert_eq!(own, table, "JUDDER_GOLDEN=write writes it");
}
