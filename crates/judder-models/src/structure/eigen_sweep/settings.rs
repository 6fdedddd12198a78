//! What a case says of complex modes along a parameter.

use crate::read_family::{PlacedFamily, family_declaration, read_placed_family, write_family};
use crate::read_sweep::{SWEEP, check_size, required};
use crate::structure::case::problem::StructureProblem;
use crate::structure::case::scope::StructureScope;
use crate::structure::case::{Matrices, StructureSource};
use crate::structure::eigen::EigenAnalysis;
use crate::sweep::{Family, ParameterKey};
use crate::swept_keys::{ParameterKeys, SweptKeys};
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Declaration, Number, Setting, Settings, all, both};
use judder_keys::dimension::Dimension;
use judder_keys::document::Node;
use judder_keys::error::{Fault, Place};
use judder_keys::numeric_key::Range;
use judder_keys::problem::Placed;
use judder_keys::section::{Section, finite_number, list, text};
use judder_keys::{Choice, Settings};
use judder_structure::asked_region::AskedRegion;
use judder_structure::eigen_sweep::SweepMethod;
use judder_study::case::scale::Spacing;
use serde_json::{Map, Value as Json, json};

/// Complex modes along a parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct EigenSweep {
    /// The parameter and its values.
    pub sweep: ParameterValues,
    /// One curve for each value of another parameter.
    pub family: Option<Family<ParameterKey>>,
    /// Which eigenvalues are asked for.
    pub region: AskedRegion,
    /// How each value is solved.
    pub method: SweepMethod,
}

/// A parameter with the values that it takes one after the other.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterValues {
    /// The parameter.
    pub key: ParameterKey,
    /// Its dotted path.
    pub path: String,
    /// The values, two at least, ascending or descending.
    pub values: Vec<f64>,
    /// How they are spaced, for the axis of figures.
    pub scale: Spacing,
}

/// How the points are solved, as a case says it.
#[derive(Debug, Clone, PartialEq, Settings)]
#[settings(check = MethodKeys::has_meaning)]
pub(crate) struct MethodKeys {
    /// How each point is solved.
    #[key(default = MethodWord::Full)]
    method: MethodWord,
    /// Relative error that the method `projected` may leave.
    #[key(rule = TOLERANCE, symbol = "ε", default = 1e-6)]
    tolerance: f64,
}

/// The word of a method.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
#[choice(what = "method")]
enum MethodWord {
    /// On the full matrices.
    Full,
    /// On a basis of the modes of a few points.
    Projected,
}

const TOLERANCE: Number =
    Number { dimension: Dimension::NUMBER, range: Range::Interval { above: 0.0, up_to: 0.1 } };

impl MethodKeys {
    /// Refuses a tolerance that means nothing to the method.
    fn has_meaning(&mut self, section: &Section<'_>) -> Result<(), Fault> {
        match section.get("tolerance") {
            Some(node) if self.method == MethodWord::Full => {
                let with = "method = \"full\"".to_owned();
                let problem = Cause::Meaningless { key: "tolerance", with };
                Err(problem.at(node.place))
            }
            _ => Ok(()),
        }
    }

    pub(crate) fn method(&self) -> SweepMethod {
        match self.method {
            MethodWord::Full => SweepMethod::Full,
            MethodWord::Projected => SweepMethod::Projected { tolerance: self.tolerance },
        }
    }
}

/// The keys of a sweep of listed values.
fn listed() -> Vec<Declaration> {
    let values = Allowed::List { of: Box::new(ParameterKeys::value_form()), length: [2, usize::MAX] };
    vec![
        required("key", "dotted path of the parameter", ParameterKeys::key_form()),
        required("values", "values one after the other, ascending or descending", values),
    ]
}

/// The keys of either way, each once; one that the other lacks may be left out.
fn keys_of(ways: &[Declaration; 2]) -> Vec<Declaration> {
    let [range, listed] = ways.each_ref().map(|way| way.form.keys());
    let has = |keys: &[Declaration], name: &str| keys.iter().any(|key| key.name == name);
    let only = listed.iter().filter(|key| !has(range, key.name));
    let own = range.iter().chain(only).cloned();
    own.map(|key| {
        let is_required = key.is_required && has(range, key.name) && has(listed, key.name);
        Declaration { is_required, ..key }
    })
    .collect()
}

/// What is said of complex modes along a parameter.
pub(super) fn declarations() -> Vec<Declaration> {
    let doc = "a parameter over a range, or with a list of values";
    let listed =
        required("sweep", "a parameter with a list of values", Allowed::Table { doc, keys: listed() });
    let ways = [SWEEP.declaration::<ParameterKeys>(), listed];
    let words = "a table `{ key, from, to, points, scale }` or `{ key, values }`".to_owned();
    let schema = json!({ "oneOf": ways.each_ref().map(Declaration::schema) });
    let sweep = required("sweep", doc, Allowed::Told { schema, words, keys: keys_of(&ways) });
    let varied = vec![sweep, family_declaration::<ParameterKeys>()];
    [varied, EigenAnalysis::declarations(), MethodKeys::declarations()].concat()
}

impl EigenSweep {
    pub(super) fn read(scope: &StructureScope, section: &Section<'_>) -> Result<Self, Fault> {
        if let Some(StructureSource::Body(_)) = scope.source {
            return Err(StructureProblem::NothingToSweep.at(section.place));
        }
        let solved = both(MethodKeys::read_table(section), EigenAnalysis::read_table(section));
        let ((sweep, family), (method, eigen)) = both(read_varied(scope, section), solved)?;
        Ok(Self { sweep, family, region: eigen.region, method: method.method() })
    }

    /// Its canonical form.
    pub(super) fn write_table(&self, json: &mut Map<String, Json>) {
        let Self { sweep, family, region, method } = self;
        json.insert("region".to_owned(), Setting::write(region, &()));
        json.insert("method".to_owned(), json!(method.to_string()));
        let sweep = json!({ "key": sweep.path, "values": sweep.values, "scale": sweep.scale.name() });
        json.insert("sweep".to_owned(), sweep);
        write_family::<ParameterKeys>(family.as_ref(), json);
        if let SweepMethod::Projected { tolerance } = method {
            json.insert("tolerance".to_owned(), json!(tolerance));
        }
    }
}

/// The parameter with its values, and the family; of matrices that are not known only what holds of any.
fn read_varied(
    scope: &StructureScope,
    section: &Section<'_>,
) -> Result<(ParameterValues, Option<Family<ParameterKey>>), Fault> {
    let expected = "sweep = { key = \"parameters.NAME\", from = …, to = …, points = … }";
    let node = section.required("sweep", expected)?;
    let sweep = read_values(&scope.keys, section, node)?;
    let family = read_placed_family(&scope.keys, section, sweep.key);
    let Some(matrices) = scope.matrices() else { return Ok((sweep, family?.map(|placed| placed.family))) };
    let ((), family) = both(check_effect(scope, matrices, sweep.key, node.place), family)?;
    if let Some(placed) = &family {
        let size =
            check_size(&[(placed.family.values.len(), placed.whole), (sweep.values.len(), node.place)]);
        both(check_effect(scope, matrices, placed.family.key, placed.key), size)?;
    }
    check_values(scope, matrices, &sweep, node.place, family.as_ref())?;
    Ok((sweep, family.map(|placed| placed.family)))
}

/// Refuses a parameter that no factor and no entry contains.
fn check_effect(
    scope: &StructureScope,
    matrices: &Matrices,
    key: ParameterKey,
    place: Place,
) -> Result<(), Fault> {
    let index = key.index();
    if matrices.depends_on(index) {
        return Ok(());
    }
    Err(StructureProblem::IdleParameter { name: scope.keys.0[index].clone() }.at(place))
}

/// Refuses values at which a factor has none, at the value of the family or, without one, at the sweep.
fn check_values(
    scope: &StructureScope,
    matrices: &Matrices,
    sweep: &ParameterValues,
    place: Place,
    family: Option<&PlacedFamily<ParameterKey>>,
) -> Result<(), Fault> {
    let along = |mut values: Vec<f64>, place: Place| {
        sweep.values.iter().try_for_each(|value| {
            values[sweep.key.index()] = *value;
            matrices.check(&values).map_err(|cause| cause.at(place))
        })
    };
    let Some(placed) = family else { return along(scope.values.clone(), place) };
    placed.family.values.iter().zip(&placed.places).try_for_each(|(value, place)| {
        let mut values = scope.values.clone();
        values[placed.family.key.index()] = *value;
        along(values, *place)
    })
}

/// The parameter that a table names.
fn read_key(keys: &ParameterKeys, table: &Section<'_>) -> Result<ParameterKey, Fault> {
    let node = table.required("key", "the dotted path of a parameter, key = \"parameters.NAME\"")?;
    keys.find(text("sweep.key", node)?).map_err(|cause| cause.at(node.place))
}

/// The values of `sweep`: a range as in every sweep, or a list.
fn read_values(keys: &ParameterKeys, section: &Section<'_>, node: &Node) -> Result<ParameterValues, Fault> {
    let table = Section::of_table(node, "sweep", "`sweep` with `values`")?;
    let Some(list_node) = table.get("values") else {
        let sweep = SWEEP.or(&["values"]).read(keys, section)?.sweep;
        let values = sweep.values();
        return Ok(ParameterValues { key: sweep.key, path: sweep.path, values, scale: sweep.scale });
    };
    let strangers = table.refuse_others(&["key", "values"]);
    let values = list("sweep.values", list_node)
        .and_then(|items| all(items.iter().map(|item| finite_number("sweep.values", item))));
    let ((), (key, values)) = both(strangers, both(read_key(keys, &table), values))?;
    if values.len() < 2 {
        return Err(Cause::TooFewPoints { points: values.len() as i64 }.at(list_node.place));
    }
    // branches are followed from one value to the next
    let monotone = values.is_sorted_by(|a, b| a < b) || values.is_sorted_by(|a, b| a > b);
    if !monotone {
        return Err(StructureProblem::UnsortedValues.at(list_node.place));
    }
    Ok(ParameterValues { key, path: keys.path(key), values, scale: Spacing::Linear })
}
