//! Whether steady sliding is the only one, in words of the case.

use crate::assembly::AssemblySubject;
use crate::error::ModelError;
use judder_assembly::compliance::Compliance;
use judder_assembly::contact_point::ContactPoint;
use judder_assembly::interface::Interface;
use judder_assembly::steady::{FrictionAmount, FrictionLimit, SteadySliding};
use judder_assembly::uniqueness::{
    FrictionOnset, Uniqueness, UniquenessProof, UniquenessVerdict, uniqueness,
};
use judder_report::page::PageTable;
use judder_store::{ByName, Results};
use judder_study::report_tables::short;
use serde_json::{Map, Value};

/// What is told of other states.
#[derive(Results)]
pub(super) struct ToldUniqueness {
    /// whether there are other states: `unique`, there is one whatever the loads; `unique-for-these-loads`; `several`; `not-proved`, neither was shown
    uniqueness: &'static str,
    /// how it was shown; none where it was not
    uniqueness_by: Option<&'static str>,
    /// how many states there are, where that was counted
    states: Option<usize>,
    /// with how much friction this begins to be lost
    friction_onsets: ByName<ToldFrictionOnset>,
}

/// Where something begins as all friction coefficients grow alike.
#[derive(Results)]
pub(super) struct ToldFrictionOnset {
    /// whether it was looked for
    known: bool,
    /// by what the friction coefficients are multiplied; none where that is for no friction coefficient, or not known, and of contacts without friction
    #[result(unit = "1")]
    factor: Option<f64>,
    /// the friction coefficient of the point where it begins; of contacts without friction that which all of them would have
    #[result(unit = "1")]
    friction_coefficient: Option<f64>,
    /// its contact
    contact: Option<String>,
    /// its place
    #[result(unit = "m")]
    place: Option<Vec<f64>>,
}

/// What begins, by the names of the summary.
const BEGINS: [(&str, &str); 4] = [
    ("closed-points", "the closed points move without a change of force"),
    ("any-points", "so do those of another set: for some loads there are other states"),
    ("one-point", "a closed point, were it the only one, digs in"),
    ("one-point-inertia", "a closed rigid point, were it the only one, locks by its inertia alone"),
];

impl ToldUniqueness {
    /// What is told, and what is a warning.
    pub(super) fn new(
        of: &AssemblySubject<'_>,
        compliance: &Compliance,
        steady: &SteadySliding,
    ) -> Result<(Self, Vec<String>), ModelError> {
        let Uniqueness { verdict, onsets } = uniqueness(&of.built.assembly, compliance, steady)?;
        let found = [
            of_closed_points(steady),
            (onsets.any_set, onsets.all_sets_known),
            (onsets.one_point, onsets.one_point_known),
            (onsets.one_point_inertia, onsets.inertia_known),
        ];
        let told = found.map(|(onset, known)| ToldFrictionOnset::new(of, onset, known));
        let mut warnings = Vec::new();
        if let UniquenessVerdict::Several { states, other } = &verdict {
            warnings.push(several(of, steady, (*states, other), onsets.any_set));
        }
        warnings.extend(told[3].locks());
        let by = |proof: UniquenessProof| match proof {
            UniquenessProof::Minors => "principal-minors",
            UniquenessProof::Definite => "definite",
            UniquenessProof::Dominant => "dominant",
            UniquenessProof::AllSets => "all-sets",
        };
        let (uniqueness, uniqueness_by, states) = match verdict {
            UniquenessVerdict::Unique(proof) => ("unique", Some(by(proof)), Some(1)),
            UniquenessVerdict::UniqueForLoads(proof) => ("unique-for-these-loads", Some(by(proof)), Some(1)),
            UniquenessVerdict::Several { states, .. } => {
                ("several", Some(by(UniquenessProof::AllSets)), Some(states))
            }
            UniquenessVerdict::NotProved => ("not-proved", None, None),
        };
        let names = BEGINS.map(|(name, _)| name.to_owned());
        let friction_onsets = names.into_iter().zip(told).collect();
        Ok((Self { uniqueness, uniqueness_by, states, friction_onsets }, warnings))
    }
}

/// Where the closed points begin to move without a change of force, and whether that was looked for.
pub(super) fn of_closed_points(steady: &SteadySliding) -> (Option<FrictionOnset>, bool) {
    match steady.friction_limit {
        FrictionLimit::At { friction, point } => (Some(FrictionOnset { friction, point }), true),
        FrictionLimit::None => (None, true),
        FrictionLimit::Unknown => (None, false),
    }
}

/// A point, by its place in the order of all interfaces, and its interface.
fn point_of<'a>(of: &AssemblySubject<'a>, place: usize) -> Option<(&'a Interface, &'a ContactPoint)> {
    let interfaces = of.built.assembly.interfaces.iter();
    interfaces.flat_map(|own| own.points.iter().map(move |point| (own, point))).nth(place)
}

fn coordinates(place: &[f64]) -> String {
    let each: Vec<String> = place.iter().map(f64::to_string).collect();
    format!("({})", each.join(", "))
}

/// That there are other states, where another one differs, and what leaves one alone.
fn several(
    of: &AssemblySubject<'_>,
    steady: &SteadySliding,
    (states, other): (usize, &[usize]),
    any_set: Option<FrictionOnset>,
) -> String {
    let count = steady.points.len();
    let differs = (0..count).find(|k| steady.points[*k].is_closed != other.contains(k));
    let at = differs.and_then(|k| Some((k, point_of(of, k)?)));
    let at = at.map_or_else(String::new, |(k, (interface, point))| {
        let does = if other.contains(&k) { "presses" } else { "is open" };
        format!(", and the point of `{}` at {} m {does}", interface.name, coordinates(&point.place))
    });
    let remedy = match any_set {
        Some(FrictionOnset { friction: FrictionAmount::Factor(factor), .. }) => {
            format!("below {factor:.6} times the friction coefficients there is one state alone")
        }
        _ => "with less friction there may be one alone".to_owned(),
    };
    format!(
        "there are {states} states of steady sliding under these loads: in another one {} of {count} contact points are closed{at}; {remedy}",
        other.len(),
    )
}

impl ToldFrictionOnset {
    fn new(of: &AssemblySubject<'_>, onset: Option<FrictionOnset>, known: bool) -> Self {
        let at = onset.and_then(|onset| point_of(of, onset.point));
        let coefficient = at.and_then(|(interface, point)| {
            Some(interface.law.friction()?.at(point.slip_speed()).coefficient)
        });
        let friction_coefficient = match onset.map(|onset| onset.friction) {
            Some(FrictionAmount::Factor(factor)) => coefficient.map(|own| factor * own),
            Some(FrictionAmount::Coefficient(own)) => Some(own),
            None => None,
        };
        Self {
            known,
            factor: onset.and_then(|onset| onset.friction.factor()),
            friction_coefficient,
            contact: at.map(|(interface, _)| interface.name.clone()),
            place: at.map(|(_, point)| point.place.to_vec()),
        }
    }

    /// That a point has locked.
    fn locks(&self) -> Option<String> {
        let (factor, contact, place) = (self.factor?, self.contact.as_ref()?, self.place.as_ref()?);
        (factor <= 1.0).then(|| {
            format!(
                "a point of `{contact}` at {} m locks: at {factor:.6} times the friction coefficients its inertia alone no longer lets it go on sliding",
                coordinates(place),
            )
        })
    }
}

/// What is told of other states.
pub(super) fn table(results: &Map<String, Value>) -> Option<PageTable> {
    let onsets = results.get("friction_onsets")?.as_object()?;
    let verdict = match results.get("uniqueness")?.as_str()? {
        "unique" => "there is one state of steady sliding, whatever the loads",
        "unique-for-these-loads" => "there is one state of steady sliding under these loads",
        "several" => "there are other states of steady sliding under these loads",
        _ => "not shown that there is one state of steady sliding alone",
    };
    let row = |(name, what): (&str, &str)| {
        let told = onsets.get(name)?;
        let numbers = match (&told["factor"], &told["friction_coefficient"], &told["known"]) {
            (Value::Null, Value::Null, Value::Bool(true)) => {
                ["for no friction coefficient".to_owned(), String::new()]
            }
            (Value::Null, Value::Null, _) => ["not known".to_owned(), String::new()],
            (Value::Null, coefficient, _) => ["there is no friction".to_owned(), short(coefficient)],
            (factor, coefficient, _) => [short(factor), short(coefficient)],
        };
        let place = told["place"].as_array().into_iter().flatten().map(short).collect::<Vec<_>>().join(", ");
        let contact = told["contact"].as_str().unwrap_or_default().to_owned();
        Some([vec![what.to_owned()], numbers.to_vec(), vec![contact, place]].concat())
    };
    let head = [
        "what begins as friction grows",
        "times the friction (−)",
        "friction coefficient (−)",
        "contact",
        "place (m)",
    ];
    let by = results.get("uniqueness_by").and_then(Value::as_str);
    Some(PageTable {
        caption: match by {
            Some(by) => format!("Other states: {verdict} (by {by})"),
            None => format!("Other states: {verdict}"),
        },
        head: head.map(String::from).to_vec(),
        rows: BEGINS.into_iter().filter_map(row).collect(),
    })
}
