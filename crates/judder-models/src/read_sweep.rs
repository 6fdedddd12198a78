//! Reading of sweeps, root ranges and maps from the tables of an analysis.

use crate::sweep::{MAP_BYTES_LIMIT, MAP_BYTES_PER_POINT, MapOptions, StabilityMapAnalysis, Sweep, Within};
use crate::swept_keys::SweptKeys;
use judder_keys::cause::Cause;
use judder_keys::declared::{Allowed, Declaration, Scaled, Setting, Settings, Whole, both};
use judder_keys::document::Data;
use judder_keys::error::{Fault, Place};
use judder_keys::keys::Key;
use judder_keys::numeric_key::{Form, Range, Value};
use judder_keys::section::{Section, text, wrong_type};
use judder_keys::span::ascending;
use judder_study::case::scale::Spacing;
use serde_json::{Map, Value as Json, json};

/// A key of an analysis under which a key of the case goes over a range.
#[derive(Debug, Clone, Copy)]
pub(crate) struct AxisKey {
    pub(crate) name: &'static str,
    doc: &'static str,
    /// The points where it does not say.
    usual: Option<usize>,
    /// Keys of what may stand in its place.
    instead: &'static [&'static str],
}

/// What most analyses vary.
pub(crate) const SWEEP: AxisKey =
    AxisKey { name: "sweep", doc: "one key over a range", usual: None, instead: &[] };
/// The abscissa of a map.
const X: AxisKey = AxisKey { name: "x", doc: "the key along the abscissa, over a range", ..SWEEP };
/// The ordinate of a map.
const Y: AxisKey = AxisKey { name: "y", doc: "the key along the ordinate, over a range", ..SWEEP };

/// A key that must be given.
pub(crate) fn required(name: &'static str, doc: &'static str, form: Allowed) -> Declaration {
    Declaration { name, doc, symbol: "", default: None, is_required: true, alternative: None, form }
}

/// The names of keys.
pub(crate) fn names(keys: &[Declaration]) -> Vec<&'static str> {
    keys.iter().map(|key| key.name).collect()
}

impl AxisKey {
    /// This one, of so many points where it does not say.
    pub(crate) const fn of_points(self, usual: usize) -> Self {
        Self { usual: Some(usual), ..self }
    }

    /// This one, in whose place something with these keys may stand.
    pub(crate) const fn or(self, instead: &'static [&'static str]) -> Self {
        Self { instead, ..self }
    }

    /// The keys of its table.
    fn keys<S: SweptKeys>(&self) -> Vec<Declaration> {
        let most = (MAP_BYTES_LIMIT / MAP_BYTES_PER_POINT) as usize;
        let points = Allowed::Whole(Whole { from: 2, to: most });
        vec![
            required("key", "dotted path of the key", S::key_form()),
            required("from", "first value", S::value_form()),
            required("to", "last value", S::value_form()),
            Declaration {
                default: self.usual.map(Json::from),
                is_required: self.usual.is_none(),
                ..required("points", "number of points, both ends included", points)
            },
            Declaration {
                default: Some(json!(Spacing::Linear.name())),
                is_required: false,
                ..required("scale", "spacing of the points", <Spacing as Setting>::form(&()))
            },
        ]
    }

    /// What is said of it.
    pub(crate) fn declaration<S: SweptKeys>(&self) -> Declaration {
        required(self.name, self.doc, Allowed::Table { doc: self.doc, keys: self.keys::<S>() })
    }

    /// Puts it into a canonical form.
    pub(crate) fn write<S: SweptKeys>(&self, sweep: &Sweep<S::Key>, json: &mut Map<String, Json>) {
        let end = |number| S::write(sweep.key, Value { number, form: sweep.form });
        let own = json!({
            "key": sweep.path, "from": end(sweep.from), "to": end(sweep.to), "points": sweep.points,
            "scale": sweep.scale.name(),
        });
        json.insert(self.name.to_owned(), own);
    }
}

/// A sweep with the places that later checks point at.
pub(crate) struct PlacedSweep<K> {
    pub(crate) sweep: Sweep<K>,
    pub(crate) key: Place,
    pub(crate) points: Place,
    whole: Place,
}

impl<K: Copy> PlacedSweep<K> {
    pub(crate) fn ends(&self) -> [Value; 2] {
        [self.sweep.from, self.sweep.to].map(|number| Value { number, form: self.sweep.form })
    }
}

impl AxisKey {
    /// Reads it where the analysis varies nothing else, and checks its ends.
    pub(crate) fn read_alone<S: SweptKeys>(
        &self,
        keys: &S,
        analysis: &Section<'_>,
    ) -> Result<Sweep<S::Key>, Fault> {
        let sweep = self.read(keys, analysis)?;
        check_ends(keys, &sweep)?;
        Ok(sweep.sweep)
    }

    /// Reads it; conditions between keys are left to [`crate::read_family`] and [`read_map`], which know what else varies.
    pub(crate) fn read<S: SweptKeys>(
        &self,
        keys: &S,
        analysis: &Section<'_>,
    ) -> Result<PlacedSweep<S::Key>, Fault> {
        let name = self.name;
        let expected = || format!("{name} = {{ key = …, from = …, to = …, points = … }}");
        let section = analysis.inner(name)?.ok_or_else(|| analysis.missing(name, &expected()))?;
        let strangers = section.refuse_others(&[names(&self.keys::<S>()), self.instead.to_vec()].concat());
        let scale = section.choice("scale", "scale", &Spacing::ALL);
        let scale = scale.map(|scale| scale.unwrap_or(Spacing::Linear));
        let varied = read_varied(keys, &section);
        let given = both(varied, both(scale, self.read_points(&section)));
        let ((), ((varied, [from, to]), (scale, points))) = both(strangers, given)?;
        same_form(ends_of(&section), from.form, to.form, section.place_of(&["to"]))?;
        let (from, to, form) = (from.number, to.number, from.form);
        if from == to {
            return Err(Cause::EmptyRange { from: section.written("from", from) }.at(section.place));
        }
        if scale == Spacing::Log && (from == 0.0 || to == 0.0 || (from < 0.0) != (to < 0.0)) {
            let (from, to) = (section.written("from", from), section.written("to", to));
            return Err(Cause::LogThroughZero { from, to }.at(section.place));
        }
        let (key, key_place) = varied;
        let sweep = Sweep { key, path: keys.path(key), from, to, points, scale, form };
        let points = section.place_of(&["points"]);
        Ok(PlacedSweep { sweep, key: key_place, points, whole: section.place })
    }

    /// The number of points, which must be few enough.
    fn read_points(&self, section: &Section<'_>) -> Result<usize, Fault> {
        let points = match (section.get("points"), self.usual) {
            (None, Some(points)) => points,
            _ => read_points(section)?,
        };
        check_size(&[(points, section.place_of(&["points"]))]).map(|()| points)
    }
}

pub(crate) fn check_ends<S: SweptKeys>(keys: &S, sweep: &PlacedSweep<S::Key>) -> Result<(), Fault> {
    sweep
        .ends()
        .into_iter()
        .try_for_each(|end| keys.check(&[(sweep.sweep.key, end)]).map_err(|cause| cause.at(sweep.whole)))
}

/// The keys of a range of roots.
fn within_keys<K>(sought: &Key<K>) -> Vec<Declaration> {
    let of = Scaled { range: Range::Positive, ..sought.rule };
    let end = |name, doc| required(name, doc, Allowed::Scaled(of));
    vec![end("from", "lower end"), end("to", "upper end")]
}

/// What is said of the range in which an analysis seeks roots of `sought`; `default` is in groups.
pub(crate) fn within_declaration<K>(sought: &Key<K>, default: (f64, f64)) -> Declaration {
    let doc = "where roots are sought";
    let form = Allowed::Table { doc, keys: within_keys(sought) };
    let default = Some(json!({ "from": default.0, "to": default.1 }));
    Declaration { default, is_required: false, ..required("within", doc, form) }
}

/// Puts a range of roots into a canonical form.
pub(crate) fn write_within<S: SweptKeys>(sought: S::Key, within: &Within, json: &mut Map<String, Json>) {
    let end = |number| S::write(sought, Value { number, form: within.form });
    json.insert("within".to_owned(), json!({ "from": end(within.from), "to": end(within.to) }));
}

/// Reads the range in which an analysis seeks roots of `sought`; `default` is in groups.
pub(crate) fn read_within<K: Copy>(
    analysis: &Section<'_>,
    sought: &Key<K>,
    default: (f64, f64),
) -> Result<Within, Fault> {
    let Some(section) = analysis.inner("within")? else {
        return Ok(Within { from: default.0, to: default.1, form: Form::Group });
    };
    let strangers = section.refuse_others(&names(&within_keys(sought)));
    let of = Scaled { range: Range::Positive, ..sought.rule };
    let end = |end: &str| {
        let node = section.required(end, &format!("{end} = …, the value at this end"))?;
        Ok((of.read(&section.path(end), node)?, node.place))
    };
    let ((), ((from, _), (to, to_place))) = both(strangers, both(end("from"), end("to")))?;
    same_form(ends_of(&section), from.form, to.form, to_place)?;
    let (from, to, form) = (from.number, to.number, from.form);
    let written = || [section.written("from", from), section.written("to", to)];
    ascending([from, to], written, section.place)?;
    Ok(Within { from, to, form })
}

/// What is said of a stability map.
pub(crate) fn map_declarations<S: SweptKeys>() -> Vec<Declaration> {
    let axes = vec![X.declaration::<S>(), Y.declaration::<S>()];
    [axes, MapOptions::declarations()].concat()
}

/// Puts a stability map into a canonical form.
pub(crate) fn write_map<S: SweptKeys>(map: &StabilityMapAnalysis<S::Key>, json: &mut Map<String, Json>) {
    X.write::<S>(&map.x, json);
    Y.write::<S>(&map.y, json);
    map.options.write_table(json);
}

/// Reads a stability map.
pub(crate) fn read_map<S: SweptKeys>(
    keys: &S,
    analysis: &Section<'_>,
) -> Result<StabilityMapAnalysis<S::Key>, Fault> {
    let axes = both(X.read(keys, analysis), Y.read(keys, analysis));
    let ((x, y), options) = both(axes, MapOptions::read_table(analysis))?;
    if keys.same(x.sweep.key, y.sweep.key) {
        return Err(key_twice(y.sweep.path, X.name, Y.name).at(y.key));
    }
    check_size(&[(x.sweep.points, x.points), (y.sweep.points, y.points)])?;
    for x_end in x.ends() {
        for y_end in y.ends() {
            keys.check(&[(x.sweep.key, x_end), (y.sweep.key, y_end)]).map_err(|cause| cause.at(y.whole))?;
        }
    }
    Ok(StabilityMapAnalysis { x: x.sweep, y: y.sweep, options, global_margin: false })
}

pub(crate) fn read_key<S: SweptKeys>(keys: &S, section: &Section<'_>) -> Result<(S::Key, Place), Fault> {
    let node = section.required("key", "the dotted path of a numeric key, key = \"…\"")?;
    let path = text(&section.path("key"), node)?;
    let place = node.part(0..path.len());
    keys.find(path).map(|key| (key, place)).map_err(|cause| cause.at(place))
}

/// A key with its place, and the ends of its range.
type Varied<K> = ((K, Place), [Value; 2]);

/// Reads a key and its range; what the ends may be is not known without the key.
fn read_varied<S: SweptKeys>(keys: &S, section: &Section<'_>) -> Result<Varied<S::Key>, Fault> {
    let given = |end: &str| section.required(end, &format!("{end} = …, the value at this end"));
    let (from, to) = (given("from"), given("to"));
    match read_key(keys, section) {
        Ok((key, place)) => {
            let value = |end: &str, node| keys.read(key, &section.path(end), node);
            let ends = both(from.and_then(|node| value("from", node)), to.and_then(|node| value("to", node)));
            ends.map(|(from, to)| ((key, place), [from, to]))
        }
        Err(fault) => Err(beside(fault, both(from, to).map(drop))),
    }
}

/// A fault with another one beside it, where there is one.
pub(crate) fn beside(fault: Fault, other: Result<(), Fault>) -> Fault {
    match other {
        Ok(()) => fault,
        Err(other) => fault.and(other),
    }
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

pub(crate) fn key_twice(key: String, first: &'static str, second: &'static str) -> Cause {
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
            let (limit, most) = (MAP_BYTES_LIMIT, MAP_BYTES_LIMIT / MAP_BYTES_PER_POINT);
            Err(Cause::TooLarge { shape, points, bytes, limit, most }.at(*place))
        }
        _ => Ok(()),
    }
}
