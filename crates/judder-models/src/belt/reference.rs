//! What the page of the reference says of belt cases.

use super::case::{BELT_KEYS, KINDS};
use judder_keys::reference::row;
use judder_study::case::reference::kinds;

/// The section on them.
pub(super) fn section() -> String {
    let mut page = BELT.to_owned();
    for key in &BELT_KEYS {
        page += &row(key);
    }
    page += "\n### Analyses of a belt case\n\n";
    page += &kinds(&KINDS);
    page
}

/// What a belt case has, before the table of its numbers.
const BELT: &str = "
## Keys of a belt case

`model = \"belt\"` is one mass on a moving belt, x″ + 2ξ x′ + x = −sgn(v_rel) N μ(|v_rel|) with v_rel = x′ − v and μ(v) = μ_∞ + (μ_0 − μ_∞) e^(−|v|/v_0). Mass \
and natural frequency are the units.

| key | symbol | a plain number is | a string is | default | allowed | what it is |
| --- | --- | --- | --- | --- | --- | --- |
";
