//! Reading of sweeps, families, root ranges and maps from the tables of an analysis.

use crate::cause::Cause;
use crate::document::Data;
use crate::error::{Fault, Place};
use crate::keys::{Form, OscillatorKey, Range, Value};
use crate::section::{Section, list, text, wrong_type};
use crate::sweep::{
    Family, MAP_BYTES_LIMIT, MAP_BYTES_PER_POINT, MapMethod, Scale, StabilityMap, Sweep, Within,
};
use crate::swept_keys::{SweptKeys, read_value};

/// A sweep with the places that later checks point at.
pub(crate) struct PlacedSweep<K> {
    pub(crate) sweep: Sweep<K>,
    pub(crate) key: Place,
    points: Place,
    whole: Place,
}

impl<K: Copy> PlacedSweep<K> {
    fn ends(&self) -> [Value; 2] {
        [self.sweep.from, self.sweep.to].map(|number| Value { number, form: self.sweep.form })
    }
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

/// Reads the sweep `name` of an analysis; `default_points` stands in where the case gives none.
///
/// Conditions between keys are left to [`read_family`] and [`read_map`], which know what else varies.
pub(crate) fn read_sweep<S: SweptKeys>(
    keys: &S,
    analysis: &Section<'_>,
    name: &str,
    default_points: Option<usize>,
) -> Result<PlacedSweep<S::Key>, Fault> {
    let node = analysis.required(name, &format!("{name} = {{ key = …, from = …, to = …, points = … }}"))?;
    let section = Section::open(node, name, &format!("`{name}`"), &["key", "from", "to", "points", "scale"])?;
    let (key, key_place) = read_key(keys, &section)?;
    let ends = |end: &str| {
        let value = section.required(end, &format!("{end} = …, the value at this end"))?;
        keys.read(key, &section.path(end), value)
    };
    let (from, to) = (ends("from")?, ends("to")?);
    let place_of = |key: &str| section.get(key).map_or(section.place, |node| node.place);
    same_form(ends_of(&section), from.form, to.form, place_of("to"))?;
    let (from, to, form) = (from.number, to.number, from.form);
    if from == to {
        return Err(Cause::EmptyRange { from }.at(section.place));
    }
    let scale = section.choice("scale", "scale", &Scale::ALL)?.unwrap_or(Scale::Linear);
    if scale == Scale::Log && (from == 0.0 || to == 0.0 || (from < 0.0) != (to < 0.0)) {
        return Err(Cause::LogThroughZero { from, to }.at(section.place));
    }
    let points = match (section.get("points"), default_points) {
        (None, Some(points)) => points,
        _ => read_points(&section)?,
    };
    let sweep = Sweep { key, path: keys.path(key), from, to, points, scale, form };
    let placed = PlacedSweep { sweep, key: key_place, points: place_of("points"), whole: section.place };
    check_size(&[(points, placed.points)])?;
    Ok(placed)
}

/// Reads the sweep of an analysis that varies nothing else, and checks its ends.
pub(crate) fn read_checked_sweep<S: SweptKeys>(
    keys: &S,
    analysis: &Section<'_>,
) -> Result<Sweep<S::Key>, Fault> {
    let sweep = read_sweep(keys, analysis, "sweep", None)?;
    check_ends(keys, &sweep)?;
    Ok(sweep.sweep)
}

fn check_ends<S: SweptKeys>(keys: &S, sweep: &PlacedSweep<S::Key>) -> Result<(), Fault> {
    sweep
        .ends()
        .into_iter()
        .try_for_each(|end| keys.check(&[(sweep.sweep.key, end)]).map_err(|cause| cause.at(sweep.whole)))
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
    for (number, place) in family.values.iter().zip(&places) {
        let value = Value { number: *number, form: family.form };
        for end in sweep.ends() {
            keys.check(&[(family.key, value), (sweep.sweep.key, end)]).map_err(|cause| cause.at(*place))?;
        }
    }
    check_size(&[(family.values.len(), whole), (sweep.sweep.points, sweep.points)])?;
    Ok(Some(family))
}

/// Reads the family of an analysis that sweeps `swept`; whether its values go together with the sweep is left to the caller.
pub(crate) fn read_placed_family<S: SweptKeys>(
    keys: &S,
    analysis: &Section<'_>,
    swept: S::Key,
) -> Result<Option<PlacedFamily<S::Key>>, Fault> {
    let Some(node) = analysis.get("family") else { return Ok(None) };
    let section = Section::open(node, "family", "`family`", &["key", "values"])?;
    let (key, key_place) = read_key(keys, &section)?;
    if keys.same(key, swept) {
        return Err(key_twice(keys.path(key), "sweep", "family").at(key_place));
    }
    let values_node = section.required("values", "values = [ … ], one curve each")?;
    let nodes = list("family.values", values_node)?;
    let (mut values, mut places) = (Vec::with_capacity(nodes.len()), Vec::with_capacity(nodes.len()));
    let mut form = None;
    for node in nodes {
        let value = keys.read(key, "family.values", node)?;
        same_form("`family.values`".to_owned(), *form.get_or_insert(value.form), value.form, node.place)?;
        values.push(value.number);
        places.push(node.place);
    }
    let Some(form) = form else {
        return Err(Cause::EmptyList { key: "family.values".to_owned() }.at(values_node.place));
    };
    let family = Family { key, path: keys.path(key), values, form };
    Ok(Some(PlacedFamily { family, key: key_place, places, whole: values_node.place }))
}

/// Reads the range in which an analysis seeks roots of `sought`; `default` is in groups.
pub(crate) fn read_within(
    analysis: &Section<'_>,
    sought: OscillatorKey,
    default: (f64, f64),
) -> Result<Within, Fault> {
    let Some(node) = analysis.get("within") else {
        return Ok(Within { from: default.0, to: default.1, form: Form::Group });
    };
    let section = Section::open(node, "within", "`within`", &["from", "to"])?;
    let ends = |end: &str| {
        let node = section.required(end, &format!("{end} = …, the value at this end"))?;
        let path = section.path(end);
        let value = read_value(sought.entry(), &path, node)?;
        if value.number > 0.0 {
            return Ok((value, node.place));
        }
        Err(Cause::OutOfRange { key: path, number: value.number, range: Range::Positive }.at(node.place))
    };
    let ((from, _), (to, to_place)) = (ends("from")?, ends("to")?);
    same_form(ends_of(&section), from.form, to.form, to_place)?;
    let (from, to, form) = (from.number, to.number, from.form);
    match from.total_cmp(&to) {
        std::cmp::Ordering::Less => Ok(Within { from, to, form }),
        std::cmp::Ordering::Equal => Err(Cause::EmptyRange { from }.at(section.place)),
        std::cmp::Ordering::Greater => Err(Cause::Backwards { from, to }.at(section.place)),
    }
}

/// Reads a stability map.
pub(crate) fn read_map<S: SweptKeys>(
    keys: &S,
    analysis: &Section<'_>,
) -> Result<StabilityMap<S::Key>, Fault> {
    let x = read_sweep(keys, analysis, "x", None)?;
    let y = read_sweep(keys, analysis, "y", None)?;
    if keys.same(x.sweep.key, y.sweep.key) {
        return Err(key_twice(y.sweep.path, "x", "y").at(y.key));
    }
    check_size(&[(x.sweep.points, x.points), (y.sweep.points, y.points)])?;
    for x_end in x.ends() {
        for y_end in y.ends() {
            keys.check(&[(x.sweep.key, x_end), (y.sweep.key, y_end)]).map_err(|cause| cause.at(y.whole))?;
        }
    }
    let method = analysis.choice("method", "method", &MapMethod::ALL)?.unwrap_or(MapMethod::Adaptive);
    let boundaries = analysis.boolean("boundaries")?.unwrap_or(true);
    Ok(StabilityMap { x: x.sweep, y: y.sweep, method, boundaries, global_margin: false })
}

fn read_key<S: SweptKeys>(keys: &S, section: &Section<'_>) -> Result<(S::Key, Place), Fault> {
    let node = section.required("key", "the dotted path of a numeric key, key = \"…\"")?;
    let path = text(&section.path("key"), node)?;
    let place = node.part(0..path.len());
    keys.find(path).map(|key| (key, place)).map_err(|cause| cause.at(place))
}

fn read_points(section: &Section<'_>) -> Result<usize, Fault> {
    let node = section.required("points", "the number of points, both ends included")?;
    let Data::Number { whole: Some(points), .. } = node.data else {
        return Err(wrong_type(&section.path("points"), "an integer", node));
    };
    match usize::try_from(points) {
        Ok(count) if count >= 2 => Ok(count),
        _ => Err(Cause::TooFewPoints { points }.at(node.place)),
    }
}

/// Refuses a value of another form than the first, at its place.
pub(crate) fn same_form(keys: String, first: Form, second: Form, place: Place) -> Result<(), Fault> {
    if first == second { Ok(()) } else { Err(Cause::MixedForms { keys }.at(place)) }
}

/// The ends of a range as an error names them together.
fn ends_of(section: &Section<'_>) -> String {
    format!("`{}` and `{}`", section.path("from"), section.path("to"))
}

fn key_twice(key: String, first: &'static str, second: &'static str) -> Cause {
    Cause::KeyTwice { key, first, second }
}

/// Refuses a product of point counts that would not fit into the memory limit, at the largest factor.
pub(crate) fn check_size(factors: &[(usize, Place)]) -> Result<(), Fault> {
    let points = factors.iter().fold(1, |product: u128, (count, _)| product.saturating_mul(*count as u128));
    let bytes = points.saturating_mul(MAP_BYTES_PER_POINT);
    match factors.iter().max_by_key(|(count, _)| *count) {
        Some((_, place)) if bytes > MAP_BYTES_LIMIT => {
            let counts: Vec<_> = factors.iter().map(|(count, _)| count.to_string()).collect();
            let product = if counts.len() > 1 { format!(" = {points}") } else { String::new() };
            let shape = counts.join(" × ") + &product;
            Err(Cause::TooLarge { shape, points, bytes, limit: MAP_BYTES_LIMIT }.at(*place))
        }
        _ => Ok(()),
    }
}
