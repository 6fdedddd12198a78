//! Reading of the family of an analysis: one curve for each value of another key than the swept one.

use crate::read_sweep::{
    PlacedSweep, beside, check_ends, check_size, key_twice, names, read_key, required, same_form,
};
use crate::sweep::Family;
use crate::swept_keys::SweptKeys;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Declaration, all, both};
use judder_keys::document::Node;
use judder_keys::error::{Fault, Place};
use judder_keys::numeric_key::{Form, Value};
use judder_keys::section::{Section, list};
use serde_json::{Map, Value as Json, json};

/// The keys of a family.
fn family_keys<S: SweptKeys>() -> Vec<Declaration> {
    let values = Allowed::List { of: Box::new(S::value_form()), length: [1, usize::MAX] };
    vec![required("key", "dotted path of the key", S::key_form()), required("values", "its values", values)]
}

/// What is said of the family of an analysis.
pub(crate) fn family_declaration<S: SweptKeys>() -> Declaration {
    let doc = "one curve for each value of another key";
    let form = Allowed::Table { doc, keys: family_keys::<S>() };
    Declaration { is_required: false, ..required("family", doc, form) }
}

/// Puts a family into a canonical form.
pub(crate) fn write_family<S: SweptKeys>(family: Option<&Family<S::Key>>, json: &mut Map<String, Json>) {
    let own = family.map(|family| {
        let value = |number: &f64| S::write(family.key, Value { number: *number, form: family.form });
        json!({ "key": family.path, "values": family.values.iter().map(value).collect::<Vec<_>>() })
    });
    json.insert("family".to_owned(), json!(own));
}

/// A family with the places that later checks point at.
pub(crate) struct PlacedFamily<K> {
    pub(crate) family: Family<K>,
    pub(crate) key: Place,
    /// Of each value.
    pub(crate) places: Vec<Place>,
    /// Of all values.
    pub(crate) whole: Place,
}

/// Reads the family of an analysis that sweeps `sweep`, one curve a value, and checks the ends of every curve.
pub(crate) fn read_family<S: SweptKeys>(
    keys: &S,
    analysis: &Section<'_>,
    sweep: &PlacedSweep<S::Key>,
) -> Result<Option<Family<S::Key>>, Fault> {
    let Some(placed) = read_placed_family(keys, analysis, sweep.sweep.key)? else {
        return check_ends(keys, sweep).map(|()| None);
    };
    let PlacedFamily { family, places, whole, .. } = placed;
    let checked = all(family.values.iter().zip(&places).map(|(number, place)| {
        let value = Value { number: *number, form: family.form };
        let mut ends = sweep.ends().into_iter();
        ends.try_for_each(|end| keys.check(&[(family.key, value), (sweep.sweep.key, end)]))
            .map_err(|cause| cause.at(*place))
    }));
    let size = check_size(&[(family.values.len(), whole), (sweep.sweep.points, sweep.points)]);
    both(checked, size).map(|_| Some(family))
}

/// Reads the family of an analysis that sweeps `swept`; whether its values go together with the sweep is left to the caller.
pub(crate) fn read_placed_family<S: SweptKeys>(
    keys: &S,
    analysis: &Section<'_>,
    swept: S::Key,
) -> Result<Option<PlacedFamily<S::Key>>, Fault> {
    let Some(section) = analysis.inner("family")? else { return Ok(None) };
    let strangers = section.refuse_others(&names(&family_keys::<S>()));
    let listed = section.required("values", "values = [ … ], one curve each");
    let listed = listed.and_then(|node| Ok((list("family.values", node)?, node.place)));
    let (key, key_place) = match read_key(keys, &section) {
        Ok(key) => key,
        Err(fault) => return Err(beside(fault, both(strangers, listed).map(drop))),
    };
    let other = match keys.same(key, swept) {
        true => Err(key_twice(keys.path(key), "sweep", "family").at(key_place)),
        false => Ok(()),
    };
    let values = listed.and_then(|(nodes, whole)| read_family_values(keys, key, nodes, whole));
    let ((), ((), (values, form, places, whole))) = both(strangers, both(other, values))?;
    let family = Family { key, path: keys.path(key), values, form };
    Ok(Some(PlacedFamily { family, key: key_place, places, whole }))
}

/// The values of a family in their form, each with its place, and the place of all.
type FamilyValues = (Vec<f64>, Form, Vec<Place>, Place);

fn read_family_values<S: SweptKeys>(
    keys: &S,
    key: S::Key,
    nodes: &[Node],
    whole: Place,
) -> Result<FamilyValues, Fault> {
    let values = all(nodes.iter().map(|node| keys.read(key, "family.values", node)))?;
    let Some(form) = values.first().map(|value| value.form) else {
        return Err(Cause::EmptyList { key: "family.values".to_owned() }.at(whole));
    };
    let places: Vec<Place> = nodes.iter().map(|node| node.place).collect();
    let alike = values.iter().zip(&places);
    all(alike.map(|(value, place)| same_form("`family.values`".to_owned(), form, value.form, *place)))?;
    Ok((values.iter().map(|value| value.number).collect(), form, places, whole))
}
