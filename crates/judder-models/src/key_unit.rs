//! Results that have the unit of a swept key: which one that is the settings of their analysis know alone.

use crate::key_sweep::KeySweep;
use crate::sweep::Sweep;
use crate::swept_keys::SweptKeys;
use judder_keys::dimension::Dimension;
use judder_keys::numeric_key::Form;
use judder_store::{Declared, ValueKind};
use judder_study::labels::any_key;

/// The unit of the values of any key of a case.
pub(crate) fn unit_of_any(sweep: &KeySweep) -> String {
    any_key(&sweep.path, sweep.dimension).unit
}

/// The unit of the values of a key of a model, `1` of groups.
pub(crate) fn unit_of<S: SweptKeys>(sweep: &Sweep<S::Key>) -> String {
    let dimension = match sweep.form {
        Form::Group => Dimension::NUMBER,
        Form::Si => S::dimension(sweep.key),
    };
    any_key(&sweep.path, dimension).unit
}

/// These keys of a summary, of which the numbers with one of these names, wherever they are, have this unit where they declare none.
pub(crate) fn in_unit(mut keys: Vec<Declared>, unit: &str, names: &[&str]) -> Vec<Declared> {
    for key in &mut keys {
        match innermost(&mut key.kind) {
            ValueKind::Object(own) => *own = in_unit(std::mem::take(own), unit, names),
            ValueKind::Number if key.unit.is_empty() && names.contains(&key.name.as_str()) => {
                unit.clone_into(&mut key.unit);
            }
            _ => {}
        }
    }
    keys
}

/// What lists hold, or what stands under names.
fn innermost(kind: &mut ValueKind) -> &mut ValueKind {
    match kind {
        ValueKind::List(own) | ValueKind::ByName(own) => innermost(own),
        own => own,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn keys(text: &str) -> Vec<Declared> {
        crate::parse("case.toml", text, &[]).unwrap().case.summary_keys(0)
    }

    fn unit(keys: &[Declared], path: &[&str]) -> String {
        let (first, rest) = path.split_first().unwrap();
        let key = keys.iter().find(|key| key.name == *first).unwrap();
        match innermost(&mut key.kind.clone()) {
            ValueKind::Object(own) if !rest.is_empty() => unit(own, rest),
            _ => key.unit.clone(),
        }
    }

    #[test]
    fn values_of_a_key_have_its_unit() {
        let of_belt = |sweep: &str| {
            keys(&format!(
                "model = \"belt\"\n[[analysis]]\nkind = \"bifurcation\"\nbranches = true\nsweep = {{ key = \"operation.velocity\", {sweep} }}\n"
            ))
        };
        let group = of_belt("from = 0.5, to = 2.0, points = 3");
        for path in [&["value"][..], &["hopf_points", "value"], &["branches", "folds"]] {
            assert_eq!(unit(&group, path), "1", "{path:?}");
        }
        let thresholds = keys(
            "model = \"oscillator\"\n[[analysis]]\nkind = \"critical-load\"\n\
             sweep = { key = \"operation.velocity\", from = \"1 mm/s\", to = \"1 m/s\", points = 3, scale = \"log\" }\n",
        );
        assert_eq!(unit(&thresholds, &["value"]), "m/s");
        assert_eq!(unit(&thresholds, &["full"]), "1", "thresholds are of another quantity");
    }
}
