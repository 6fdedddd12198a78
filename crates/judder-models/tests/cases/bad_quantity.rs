//! Quantities of sweeps that no result has: refused where the case is read.

use crate::cases::bad_study_sweep::{OVER, sweep};
use crate::cases::refused;

/// Refuses a quantity of a beam with two analyses.
fn of_a_beam(path: &str, message: &str, help: &str) {
    let place = format!("\"{path}\"");
    let text = format!(
        "model = \"structure\"\n[structure]\nbeam = {{ length = \"1 m\", thickness = \"1 cm\", elements = [10, 2] }}\n\
         material = {{ youngs_modulus = \"1 GPa\", poisson_ratio = 0.3, density = \"1000 kg/m^3\" }}\n\
         [[analysis]]\nkind = \"modes\"\n[[analysis]]\nname = \"squeal\"\nkind = \"eigen\"\nregion = {{ re = [-1.0, 1.0], im = [0.0, 9.0] }}\n\
         [[sweep]]\nname = \"s\"\nquantities = [{place}]\nover = [{{ key = \"structure.material.poisson_ratio\", values = [0.2, 0.3] }}]\n"
    );
    refused(&text, message, &place, help);
}

#[test]
fn names_that_the_results_do_not_have() {
    of_a_beam(
        "modes.frequencies.0",
        "`modes.frequencies.0`: there is no result `frequencies`",
        "did you mean `frequencies_hz`? results here: frequencies_hz, residuals, rigid_modes, counted, degrees_of_freedom, modes_of, damping_ratios, \
         reduced_hz, reduction_errors",
    );
    of_a_beam(
        "modes.counted.below",
        "`modes.counted.below`: there is no result `below`",
        "did you mean `below_hz`? results here: below_hz, modes",
    );
    of_a_beam(
        "squeal.eigenvalues.max",
        "`squeal.eigenvalues.max`: there is no result `max`",
        "results here: re, im, residual, left_residual, verdict, error, condition, defective, frequency_hz, damping_ratio",
    );
    of_a_beam(
        "squeal.diagnosis.energy.signs",
        "`squeal.diagnosis.energy.signs`: there is no result `signs`",
        "did you mean `sign`? results here: sign, share, error, growth_error",
    );
}

#[test]
fn paths_that_end_at_no_number() {
    let refused = |path: &str, reason: &str, help: &str| {
        of_a_beam(path, &format!("`{path}` is not the path of a number: {reason}"), help);
    };
    let of_list = "add the number of an item, from 0, or one of min, max, first, last, count";
    refused("modes.frequencies_hz", "it ends at a list", of_list);
    refused("squeal.eigenvalues.re", "it ends at a list", of_list);
    refused(
        "squeal.diagnosis.component_modes_of.max",
        "it reduces a list that is not one of numbers",
        of_list,
    );
    refused("modes.frequencies_hz.mean", "it goes on by a name behind a list without names", of_list);
    refused("modes.modes_of", "it ends at a word", "ask for a number");
    refused("squeal.eigenvalues.0.verdict.0", "it goes on behind a word", "ask for a number");
    refused("modes.rigid_modes.0", "it goes on behind a number", "end it at `modes.rigid_modes`");
    refused("modes.counted", "it ends where there are names", "add one of below_hz, modes");
    refused("modes.counted.0", "it goes on by a number where there are names", "add one of below_hz, modes");
}

#[test]
fn quantities_of_the_operating_point() {
    sweep(
        &format!("{OVER}quantities = [\"growth_rates\"]"),
        "no operating point of this model has a quantity `growth_rates`",
        "\"growth_rates\"",
        "did you mean `growth_rate`? quantities: growth_rate, frequency, verdict, mechanism, equivalent_damping, equivalent_damping_error, \
         growth_rate_error, marginal_within_law, equilibrium_x, equilibrium_y, indentation, contact_force, contact_area, viscoelastic_friction, \
         critical_shear_strength, critical_load, threshold_shear_strength, threshold_load",
    );
    of_a_beam(
        "growth_rate",
        "no operating point of this model has a quantity `growth_rate`",
        "this model has results of analyses alone: ANALYSIS.PATH, such as modes.frequencies_hz.0",
    );
}

#[test]
fn a_wall_time() {
    of_a_beam(
        "modes.seconds",
        "`modes.seconds` is not the path of a quantity: it is a wall time, which no two runs share",
        "write a name such as growth_rate, or ANALYSIS.PATH: cycle.rms, thresholds.full.0.min, modes.frequencies_hz.0",
    );
}
