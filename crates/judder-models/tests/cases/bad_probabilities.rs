//! Conditions whose probability no sweep can tell: the message, the place and what would be right.

use super::bad_study_sweep::{OVER, QUANTITIES, sweep};

#[test]
fn probabilities_that_cannot_be() {
    let bound = "name one of the `quantities` of this sweep, growth_rate, verdict, with a bound, { quantity = \"growth_rate\", above = 0 }, or of a class which it is";
    sweep(
        &format!("probabilities = [{{ quantity = \"growth_rate\", above = 0 }}]\n{OVER}{QUANTITIES}"),
        "`probabilities` have no meaning with method = \"grid\"",
        "[{ quantity = \"growth_rate\", above = 0 }]",
        "leave it out, or use method = \"sobol\" or \"latin-hypercube\", whose points fill the ranges evenly",
    );
    let drawn = |condition: &str, message: &str| {
        let over = "over = [{ key = \"operation.velocity\", from = 1e-4, to = 1e-2 }]";
        let quantities = "quantities = [\"growth_rate\", \"verdict\"]";
        let settings = format!(
            "method = \"sobol\"\npoints = 8\n{over}\n{quantities}\nprobabilities = [{{ {condition} }}]\n"
        );
        sweep(&settings, message, &format!("{{ {condition} }}"), bound);
    };
    drawn("above = 0", "an entry of `probabilities` names no `quantity`");
    drawn(
        "quantity = \"frequency\", above = 0",
        "no probability of `frequency`: it is not among the `quantities` of this sweep",
    );
    drawn(
        "quantity = \"growth_rate\", is = \"unstable\"",
        "no probability of `growth_rate`: it is no class: give `above` or `below`",
    );
    drawn(
        "quantity = \"growth_rate\", above = 1, below = 1",
        "no probability of `growth_rate`: nothing lies above `above` and below `below`",
    );
    drawn(
        "quantity = \"verdict\", above = 0",
        "no probability of `verdict`: it is a class: say is = \"stable\", or \"marginal\", or \"unstable\"",
    );
    drawn(
        "quantity = \"verdict\", is = \"loud\"",
        "no probability of `verdict`: it is one of stable, marginal, unstable, and never loud",
    );
}
