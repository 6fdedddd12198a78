//! One engine along its steps or widths, against the cycle by events.

use super::reached::{BECOMES, EngineReached};
use judder_store::{Dataset, Results, StoreError, Variable};
use judder_study::outcome::CheckRecord;

/// Relative error of rms and period below which an engine is on the same cycle: coarser, it may fall to another one.
const SAME_CYCLE: f64 = 1e-3;
/// The finest points, all on the same cycle, that an order takes.
const FINEST: usize = 3;
/// What an order may be off 1: terms of the second order are felt at the coarser points.
const ORDER_LIMIT: f64 = 0.2;
/// What the rms of the two finest points, extrapolated, may be off, relative.
const EXTRAPOLATED_LIMIT: f64 = 1e-5;

/// An engine beside the event-driven one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Engine {
    /// Moreau's.
    TimeStepping,
    /// tanh(v_rel/ε) for the sign.
    Smoothed,
}

impl Engine {
    /// Its name in results.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::TimeStepping => "time_stepping",
            Self::Smoothed => "smoothed",
        }
    }

    /// The same in words.
    fn words(self) -> &'static str {
        match self {
            Self::TimeStepping => "time-stepping",
            Self::Smoothed => "the smoothed sign",
        }
    }

    /// What is varied: its name, what it is, what stands at an axis.
    fn varied(self) -> [&'static str; 3] {
        match self {
            Self::TimeStepping => ["time_step", "time step ω_nx Δt", "Time step $h$ (−)"],
            Self::Smoothed => ["width", "width ε of the smoothed sign over v_d", "Width $ε$/$ṽ_{d}$ (−)"],
        }
    }
}

/// The points of one engine, by rising step or width.
pub(super) struct EngineLadder {
    pub(super) engine: Engine,
    pub(super) values: Vec<f64>,
    pub(super) reached: Vec<EngineReached>,
}

/// A row of the table.
pub(super) struct LadderRow {
    pub(super) engine: &'static str,
    pub(super) value: f64,
    pub(super) becomes: &'static str,
    pub(super) rms: f64,
    pub(super) period: f64,
    pub(super) errors: [f64; 2],
}

/// What is told of the points of an engine.
#[derive(Results)]
pub(super) struct ToldConvergence {
    #[result(unit = "1")]
    rms_error: Vec<f64>,
    #[result(unit = "1")]
    period_error: Vec<f64>,
    /// points on the same cycle
    points: usize,
    /// how fast the errors fall
    #[result(unit = "1")]
    order: Option<f64>,
    /// error of the two finest points, extrapolated
    #[result(unit = "1")]
    extrapolated: Option<f64>,
}

/// What the finest points of a ladder tell.
struct Convergence {
    /// Points that are on the same cycle.
    points: usize,
    /// The slope of log |error of the rms| over log step or width, by least squares over the finest of them.
    order: f64,
    /// The error of the rms extrapolated to zero from the two finest.
    extrapolated: f64,
}

impl EngineLadder {
    /// Errors of rms and period at every point, relative, with their signs.
    fn errors(&self, [rms, period]: [f64; 2]) -> Vec<[f64; 2]> {
        self.reached.iter().map(|r| [r.rms / rms - 1.0, r.period / period - 1.0]).collect()
    }

    /// How the points on the same cycle, from the finest on, go to it; `None` where they are too few.
    fn convergence(&self, reference: [f64; 2]) -> Option<Convergence> {
        let errors = self.errors(reference);
        let is_near =
            |errors: &[f64; 2]| errors.iter().all(|error| error.abs() < SAME_CYCLE && *error != 0.0);
        let points = errors.iter().take_while(|errors| is_near(errors)).count();
        if points < FINEST {
            return None;
        }
        let logs = || {
            self.values.iter().zip(&errors).take(FINEST).map(|(v, e)| (libm::log(*v), libm::log(e[0].abs())))
        };
        let mean = |pick: fn((f64, f64)) -> f64| logs().map(pick).sum::<f64>() / FINEST as f64;
        let (x_mean, y_mean) = (mean(|p| p.0), mean(|p| p.1));
        let covariance: f64 = logs().map(|(x, y)| (x - x_mean) * (y - y_mean)).sum();
        let variance: f64 = logs().map(|(x, _)| (x - x_mean).powi(2)).sum();
        let ratio = self.values[1] / self.values[0];
        let extrapolated = (ratio * errors[0][0] - errors[1][0]) / (ratio - 1.0);
        Some(Convergence { points, order: covariance / variance, extrapolated })
    }

    pub(super) fn told(&self, reference: [f64; 2]) -> ToldConvergence {
        let convergence = self.convergence(reference);
        let errors = self.errors(reference);
        let column = |k: usize| errors.iter().map(|errors| errors[k]).collect();
        ToldConvergence {
            rms_error: column(0),
            period_error: column(1),
            points: convergence.as_ref().map_or(0, |c| c.points),
            order: convergence.as_ref().map(|c| c.order),
            extrapolated: convergence.as_ref().map(|c| c.extrapolated),
        }
    }

    pub(super) fn add_to(&self, dataset: Dataset, reference: [f64; 2]) -> Result<Dataset, StoreError> {
        let [dimension, long_name, label] = self.engine.varied();
        let (engine, words, count) = (self.engine.name(), self.engine.words(), self.values.len());
        let over = |name: &str, what: &str, values: Vec<f64>| {
            Variable::new(&format!("{engine}_{name}"), &[dimension], &[count], values)
                .units("1")
                .long_name(&format!("{what}, {words}"))
        };
        let errors = self.errors(reference);
        let error = |k: usize| errors.iter().map(|errors| errors[k]).collect();
        let coordinate = Variable::coordinate(dimension, self.values.clone()).units("1").long_name(long_name);
        let becomes = self.reached.iter().map(|r| r.becomes).collect();
        let becomes =
            Variable::classes(&format!("{engine}_becomes"), &[dimension], &[count], becomes, &BECOMES);
        dataset
            .with(coordinate.attribute("label", label).attribute("scale", "log"))?
            .with(over("rms", "rms of x about its mean", self.reached.iter().map(|r| r.rms).collect()))?
            .with(over("period", "period", self.reached.iter().map(|r| r.period).collect()))?
            .with(over("rms_error", "relative error of the rms", error(0)))?
            .with(over("period_error", "relative error of the period", error(1)))?
            .with(becomes.long_name(&format!("what the motion settles to, {words}")))
    }

    pub(super) fn rows(&self, reference: [f64; 2]) -> Vec<LadderRow> {
        let row = |((value, reached), errors): ((&f64, &EngineReached), [f64; 2])| LadderRow {
            engine: self.engine.words(),
            value: *value,
            becomes: BECOMES[usize::from(reached.becomes)].1,
            rms: reached.rms,
            period: reached.period,
            errors,
        };
        self.values.iter().zip(&self.reached).zip(self.errors(reference)).map(row).collect()
    }

    /// Points whose motion could not be followed.
    pub(super) fn lost(&self) -> usize {
        self.reached.iter().filter(|reached| reached.rms.is_nan()).count()
    }

    pub(super) fn checks(&self, reference: [f64; 2]) -> Vec<CheckRecord> {
        let Some(Convergence { order, extrapolated, .. }) = self.convergence(reference) else {
            return Vec::new();
        };
        let (words, [varied, ..]) = (self.engine.words(), self.engine.varied());
        let varied = varied.replace('_', " ");
        vec![
            CheckRecord::new(
                format!("{words} comes to the motion by events"),
                format!(
                    "rms of the cycle, extrapolated from the two finest of {}, relative",
                    self.values.len()
                ),
                extrapolated.abs().into(),
                EXTRAPOLATED_LIMIT,
            ),
            CheckRecord::new(
                format!("the error of {words} falls with its {varied}"),
                format!("slope of its logarithm against 1, over the {FINEST} finest points"),
                (order - 1.0).abs().into(),
                ORDER_LIMIT,
            ),
        ]
    }

    pub(super) fn warnings(&self, reference: [f64; 2]) -> Vec<String> {
        let (words, [varied, ..], lost) = (self.engine.words(), self.engine.varied(), self.lost());
        let mut warnings = Vec::new();
        if lost > 0 {
            warnings.push(format!("{words}: {lost} of {} motions cannot be followed", self.values.len()));
        }
        if self.convergence(reference).is_none() {
            warnings.push(format!(
                "{words}: fewer than {FINEST} points are within {SAME_CYCLE} of the cycle; with smaller values of `{varied}` its order could be told"
            ));
        }
        warnings
    }
}
