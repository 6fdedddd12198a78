//! What the page of the reference says of two-degrees cases.

use super::case::KINDS;
use judder_study::case::reference::kinds;

/// The section on them.
pub(super) fn section() -> String {
    let mut page = String::new();
    page += "\n## Analyses of a two-degrees case\n\n\
             `[parameters]` holds numbers by name; `[matrices]` holds `mass` (identity by default), `damping` (zero by default) and `stiffness` as 2 × 2 \
             arrays of numbers or expressions of the parameters. Swept keys are `parameters.NAME`.\n\n";
    page += &kinds(&KINDS);
    page
}
