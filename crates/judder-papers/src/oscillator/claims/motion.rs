//! Motion after the instability (section 5, Figs. 11, 12), from what is stored of it.

use crate::claim::Measured;
use crate::claim::{MeasuredClaim, measured, short, statement};
use crate::oscillator::measures::{state, strengths};
use crate::oscillator::motion_exhibits::{ComputedPart, LOAD, ReadingWay, STRENGTHS};
use crate::summary::is_done;
use judder_models::motion::becomes::{CYCLE, STEADY_SLIDING};
use judder_oscillator::hopf::hopf_point;
use judder_oscillator::motion::{ContactState, StickSlip};
use judder_oscillator::spectrum::{eigenvalues, growth_rate};
use judder_oscillator::{Contact, FrictionLoad, Groups};
use judder_store::{Dataset, StudyFolder, Summary};
use judder_study::StudyError;
use judder_study::pictures::{codes, reals};
use serde_json::{Map, Value};
use std::f64::consts::TAU;

/// The motions of one way to read section 5.
pub(in crate::oscillator) struct Motions {
    contact: Contact,
    velocity: f64,
    diagram: Dataset,
    weak: Dataset,
    strong: Dataset,
    /// What the summary has of the strong motion, and of the cycle beside it where one is sought.
    of_strong: Map<String, Value>,
    of_cycle: Option<Map<String, Value>>,
}

impl Motions {
    /// From a study folder; `None` where a motion is missing.
    pub(in crate::oscillator) fn stored(
        store: &StudyFolder,
        summary: &Summary,
        way: &ReadingWay,
    ) -> Result<Option<Self>, StudyError> {
        let name = |part: ComputedPart| part.name(way);
        let needed = [ComputedPart::Diagram, ComputedPart::Weak, ComputedPart::Strong].map(name);
        if !needed.iter().all(|name| is_done(summary, name)) {
            return Ok(None);
        }
        let [diagram, weak, strong] = needed;
        let scalars = |name: &str| summary.results.get(name).cloned();
        Ok(Some(Self {
            contact: way.contact(),
            velocity: way.velocity,
            of_strong: scalars(&strong).unwrap_or_default(),
            of_cycle: scalars(&name(ComputedPart::Cycle)),
            diagram: store.read_dataset(&diagram)?,
            weak: store.read_dataset(&weak)?,
            strong: store.read_dataset(&strong)?,
        }))
    }

    fn groups(&self, shear_strength: f64) -> Groups {
        Groups { velocity: self.velocity, normal_load: LOAD, shear_strength, ..Groups::default() }
    }

    /// Fig. 11: τ̃0 with the rms of both directions and what the motions have become.
    fn points(&self) -> Vec<DiagramPoint> {
        let of = |name: &str| reals(&self.diagram, name).unwrap_or_default();
        let (rms, becomes) = (of("rms"), codes(&self.diagram, "becomes").unwrap_or_default());
        let values =
            self.diagram.variable("rms").and_then(|rms| reals(&self.diagram, rms.dimensions.last()?));
        let values = values.unwrap_or_default();
        let pair = |k: usize| [k, k + values.len()];
        (0..values.len())
            .map(|k| DiagramPoint {
                shear_strength: values[k],
                rms: pair(k).map(|i| rms[i]),
                is_regular: pair(k).iter().all(|i| [STEADY_SLIDING, CYCLE].contains(&becomes[*i])),
            })
            .collect()
    }

    /// A number of the strong motion.
    fn of_strong(&self, name: &str) -> f64 {
        self.of_strong.get(name).and_then(Value::as_f64).unwrap_or(f64::NAN)
    }

    /// The threshold at which steady sliding loses its stability as τ̃0 grows.
    fn onset(&self) -> Option<f64> {
        let found = strengths(&self.contact, self.velocity, LOAD).full;
        found.last().copied().filter(|threshold| (STRENGTHS[0]..STRENGTHS[1]).contains(threshold))
    }
}

struct DiagramPoint {
    shear_strength: f64,
    rms: [f64; 2],
    is_regular: bool,
}

/// Below this share of the largest amplitude it is “about 0”, and what varies by less is constant.
const ABOUT_ZERO: f64 = 0.01;
/// The text's bound of stable steady sliding.
const STABLE_UP_TO: f64 = 2e-3;

const ABOUT_NOTHING: MeasuredClaim<Motions> = statement(
    "§5, Fig. 11",
    "For $τ̃_{0}$ ≲ 2 × 10^{−3} the amplitude is about 0",
    |m| {
        let points = m.points();
        let largest = |wanted: &dyn Fn(f64) -> bool| {
            let rms = points.iter().filter(|p| wanted(p.shear_strength)).flat_map(|p| p.rms);
            rms.fold(0.0, f64::max)
        };
        let below = largest(&|strength| strength <= STABLE_UP_TO);
        let above = largest(&|strength| strength > STABLE_UP_TO);
        measured(format!("rms up to {}", short(below)), below < ABOUT_ZERO * above)
    },
    "Largest rms of $x̃$ up to there, forward and backward; agreement allows 1 % of the largest beyond. With $F_{n} μ_{visc}$ friction does not end \
     where contact does, and motions at the lowest shear strengths bounce.",
);

const INCREASES: MeasuredClaim<Motions> = statement(
    "§5, Fig. 11",
    "For larger $τ̃_{0}$ the amplitude strongly increases with it",
    |m| {
        let points = m.points();
        let rms: Vec<f64> =
            points.iter().filter(|p| p.shear_strength > 1.15 * STABLE_UP_TO).map(|p| p.rms[0]).collect();
        let (first, last) = (rms.first().copied().unwrap_or(0.0), rms.last().copied().unwrap_or(0.0));
        let falls = rms.windows(2).any(|pair| pair[1] < 0.9 * pair[0]);
        measured(format!("{} → {}", short(first), short(last)), last > 10.0 * first && !falls)
    },
    "rms of $x̃$ at the first point beyond 2.3 × 10^{−3} and at 5 × 10^{−2}: tenfold at least, without a fall of 10 % between neighbours.",
);

const ONE_AMPLITUDE: MeasuredClaim<Motions> = statement(
    "Fig. 11",
    "One amplitude for every $τ̃_{0}$",
    |m| {
        let apart = |[a, b]: [f64; 2]| if a == b { 0.0 } else { (a - b).abs() / a.max(b) };
        let points = m.points();
        let largest = |regular: bool| {
            points.iter().filter(|p| p.is_regular == regular).map(|p| apart(p.rms)).fold(0.0, f64::max)
        };
        let (regular, irregular) = (largest(true), largest(false));
        let shown =
            format!("apart by {:.1} % where regular, {:.0} % where not", 100.0 * regular, 100.0 * irregular);
        measured(shown, regular < ABOUT_ZERO && irregular < 0.2)
    },
    "rms of $x̃$ as $τ̃_{0}$ goes up against that as it goes down: steady sliding and cycles must have the same, irregular motions within 20 %, which is \
     what averages over a finite time leave.",
);

const NO_JUMP: MeasuredClaim<Motions> = statement(
    "§5, Fig. 11",
    "From the threshold on the amplitude grows from zero",
    |m| {
        let Some(onset) = m.onset() else { return measured("no threshold", false) };
        let lyapunov = m.groups(onset).coefficients().ok().and_then(|coefficients| {
            let system = StickSlip::new(m.contact.clone(), coefficients).ok()?;
            hopf_point(&system).ok()
        });
        let Some(hopf) = lyapunov else { return measured("no mode", false) };
        let kind = if hopf.is_subcritical() { "subcritical" } else { "supercritical" };
        measured(format!("{kind} at {}", short(onset)), !hopf.is_subcritical())
    },
    "Sign of the first Lyapunov coefficient at the threshold: supercritical means small stable cycles beyond it and none beside stable sliding.",
);

const LINEARLY_STABLE: MeasuredClaim<Motions> = statement(
    "§5, Fig. 12",
    "For $τ̃_{0}$ = 10^{−4} the system is linearly stable",
    |m| {
        let growth = state(&m.contact, m.groups(STRENGTHS[0]))
            .and_then(|(_, linearisation)| linearisation.system().reduced().ok())
            .and_then(|system| eigenvalues(&system).ok())
            .map_or(f64::NAN, |values| growth_rate(&values));
        measured(format!("max Re $λ$ = {}", short(growth)), growth < 0.0)
    },
    "Largest growth rate, in units of $ω_{nx}$.",
);

const CONSTANT: MeasuredClaim<Motions> = statement(
    "§5, Fig. 12",
    "For $τ̃_{0}$ = 10^{−4} $x̃$, $Ã$ and $τ̃_{0}$ are constant",
    |m| {
        let late = |name: &str| -> Vec<f64> {
            let values = reals(&m.weak, name).unwrap_or_default();
            values[values.len() / 2..].to_vec()
        };
        let varies = ["x", "contact_area", "relative_velocity"].map(|name| variation(&late(name)));
        let largest = varies.into_iter().fold(0.0, f64::max);
        measured(format!("vary by {}", short(largest)), largest < ABOUT_ZERO)
    },
    "Half the range over the mean of $x̃$, $Ã$ and $ṽ_{rel}$, the largest of them, over the second half of the motion. $τ̃_{0}$ is a parameter; \
     the figure shows $ṽ_{rel}$.",
);

/// Half the range of values over the magnitude of their mean.
fn variation(values: &[f64]) -> f64 {
    let (least, most) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| {
        (least.min(*value), most.max(*value))
    });
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    0.5 * (most - least) / mean.abs()
}

const LIMIT_CYCLE: MeasuredClaim<Motions> = statement(
    "§5, Fig. 12",
    "For $τ̃_{0}$ = 5 × 10^{−2} a high-amplitude limit cycle develops",
    |m| {
        let repeats = m.of_strong.get("repeats") == Some(&Value::Bool(true));
        let word = if repeats { "periodic" } else { "irregular" };
        let motion = format!(
            "{word}, rms {}, mean period {}",
            short(m.of_strong("rms")),
            short(m.of_strong("period"))
        );
        measured(motion + &m.of_cycle.as_ref().map(beside).unwrap_or_default(), repeats)
    },
    "The amplitude is high, but the motion does not repeat itself. Beside it is a cycle, found by shooting, that is unstable: its largest Floquet \
     multiplier is above 1 in magnitude. Over the few periods of a figure the motion may pass for it.",
);

/// The cycle beside an irregular motion.
fn beside(cycle: &Map<String, Value>) -> String {
    let of = |name: &str| cycle.get(name).and_then(Value::as_f64).unwrap_or(f64::NAN);
    let multipliers: Vec<[f64; 2]> = cycle
        .get("floquet_multipliers")
        .and_then(|m| serde_json::from_value(m.clone()).ok())
        .unwrap_or_default();
    let sizes = multipliers.iter().filter(|m| **m != [1.0, 0.0]).map(|[re, im]| libm::hypot(*re, *im));
    format!(
        "; cycle: rms {}, period {}, |multiplier| {}",
        short(of("rms")),
        short(of("period")),
        short(sizes.fold(0.0, f64::max))
    )
}

const STICK_SLIP: MeasuredClaim<Motions> = statement(
    "§5, Fig. 12",
    "It is characterised by stick–slip-like motion",
    |m| {
        let (stick, off) = (m.of_strong("stick_fraction"), m.of_strong("lift_off_fraction"));
        let shown = format!("stick {:.1} % of the time, off {:.2} %", 100.0 * stick, 100.0 * off);
        measured(shown, stick > 0.1 && stick < 1.0)
    },
    "Shares of the time at $τ̃_{0}$ = 5 × 10^{−2}; agreement asks for a tenth in stick. Between stick and stick the indenter also leaves the substrate.",
);

const AREA_FALLS: MeasuredClaim<Motions> = statement(
    "§5, Fig. 12c",
    "In slip the contact area falls rapidly, and with it the Coulomb part of the friction",
    |m| {
        let areas = reals(&m.strong, "contact_area").unwrap_or_default();
        let states = codes(&m.strong, "contact_state").unwrap_or_default();
        let of = |wanted: ContactState| {
            let number = wanted.number();
            areas.iter().zip(states).filter(move |(_, state)| **state == number).map(|(area, _)| *area)
        };
        let in_stick: Vec<f64> = of(ContactState::Stick).collect();
        let mean = in_stick.iter().sum::<f64>() / in_stick.len() as f64;
        let least = of(ContactState::SlipBehind).fold(f64::INFINITY, f64::min);
        measured(format!("to {} of that in stick", short(least / mean)), least < 0.5 * mean)
    },
    "Smallest area in slip over the mean in stick, on the grid of times; agreement asks for a half. By (5) the Coulomb part is $τ_{0} A$.",
);

const SUPPRESSED: MeasuredClaim<Motions> = statement(
    "§5",
    "A vanishing $τ̃_{0}$ suppresses the effect of the contact area, which grows with it",
    |m| {
        let share = |strength: f64| {
            state(&m.contact, m.groups(strength)).map_or(f64::NAN, |(e, _)| {
                let adhesive = strength * e.response.area.value;
                let carried = match m.contact.friction_load {
                    FrictionLoad::NormalLoad => LOAD,
                    FrictionLoad::ContactForce => e.response.force.value,
                };
                adhesive / (adhesive + carried * e.response.friction.value)
            })
        };
        let [weak, strong] = STRENGTHS.map(share);
        let shown = format!("{:.1} % → {:.0} %", 100.0 * weak, 100.0 * strong);
        measured(shown, weak < 0.1 && strong > 0.5)
    },
    "Share of $τ_{0} A$ in the friction of steady sliding at $τ̃_{0}$ = 10^{−4} and 5 × 10^{−2}: below a tenth, above a half.",
);

const QUASI_STEADY: MeasuredClaim<Motions> = statement(
    "Eq. (3), §5",
    "A law of steady sliding serves where $|(ω − v_{d}/A_{x}) τ|$ ≪ 1",
    |m| {
        let largest = m
            .of_strong
            .get("quasi_steady")
            .and_then(|q| q.get("largest"))
            .and_then(Value::as_f64)
            .unwrap_or(f64::NAN);
        let slip = (1.0 - m.of_strong("stick_fraction")) * m.of_strong("period");
        let over_slip = TAU / slip * Groups::default().retardation_time;
        measured(format!("{}; over a slip {}", short(largest), short(over_slip)), largest < 0.1)
    },
    "Largest over the oscillations at $τ̃_{0}$ = 5 × 10^{−2}, by the paper's own measure, which is judged: below 0.1. A slip is much shorter than a period: \
     2π$τ$ over the time that is not stick says how fast it is, and there the law is used beyond its range.",
);

/// All claims about the motions, in the order of the paper.
pub(in crate::oscillator) const MOTION_CLAIMS: [MeasuredClaim<Motions>; 11] = [
    QUASI_STEADY,
    SUPPRESSED,
    ABOUT_NOTHING,
    INCREASES,
    ONE_AMPLITUDE,
    NO_JUMP,
    LINEARLY_STABLE,
    CONSTANT,
    LIMIT_CYCLE,
    STICK_SLIP,
    AREA_FALLS,
];

/// What is found where motions are missing.
pub(in crate::oscillator) fn missing() -> Measured {
    measured("missing", false)
}
