//! `basin`: from which share of the starts steady sliding is reached.

use crate::error::ModelError;
use crate::motion::becomes::{BECOMES, LOST, STEADY_SLIDING, UNCONFIRMED, becomes};
use crate::motion::doubts;
use crate::motion::model::{Moving, Operating};
use crate::motion::settings::Following;
use judder_numerics::counter::uniform;
use judder_numerics::parallel;
use judder_numerics::piecewise::MarchError;
use judder_numerics::share::wilson;
use judder_oscillator::cycle::{Confirmed, settle_confirmed};
use judder_oscillator::motion::SlidingSystem;
use judder_oscillator::motion::attractor::{Patience, Settled};
use judder_store::{ByName, Dataset, Declared, Results, Table, Variable};
use judder_study::Progress;
use judder_study::kept::{KeptLines, KeptResults};
use judder_study::outcome::{CheckRecord, Disagreement, Outcome};
use serde::{Deserialize, Serialize};

/// Which starts are drawn.
pub(crate) struct Draw<'a> {
    pub(crate) within: &'a [Option<[f64; 2]>],
    pub(crate) samples: usize,
    pub(crate) seed: u64,
}

impl Draw<'_> {
    /// The start of a sample: it depends on the seed and on the sample alone.
    fn start<const N: usize>(&self, sample: usize, steady: [f64; N]) -> [f64; N] {
        let mut state = steady;
        for (k, (place, range)) in state.iter_mut().zip(self.within).enumerate() {
            if let Some([from, to]) = range {
                *place = from + (to - from) * uniform(self.seed, (sample * N + k) as u64);
            }
        }
        state
    }
}

/// Samples that are followed again, more exactly.
const REPEATED: usize = 50;
/// By how much more exactly.
const FINER: f64 = 1e-2;
/// The share of them whose fate may change: those on the border of the basin.
const CHANGED_LIMIT: f64 = 0.02;

/// What became of one sample.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
struct SampledStart {
    sample: usize,
    /// Its place in [`BECOMES`].
    fate: u8,
    /// When that was clear; `None` where the motion is lost.
    time: Option<f64>,
    /// The rms of x of what it settles to; `None` where the motion is lost.
    rms: Option<f64>,
}

pub(crate) fn run<M: Moving<N>, const N: usize>(
    model: &M,
    draw: &Draw<'_>,
    following: &Following,
    kept: KeptLines<'_>,
    progress: &dyn Progress,
) -> Result<Outcome, ModelError> {
    let operating = model.operating(None)?;
    let kept = KeptResults::of("starts", kept);
    let samples: Vec<SampledStart> = parallel::try_each_place(draw.samples, |index| {
        let sample = kept.at(index as u64, || follow(&operating, draw, following, index, progress))?;
        progress.advance();
        Ok::<_, ModelError>(sample)
    })?;
    let basin = SampledBasin { samples: &samples, draw, operating: &operating };
    let lost = basin.count(LOST);
    let warning = basin.first_lost().map(|sample| {
        let why = settled(&operating, draw, following, sample, progress).err();
        let why = why.map_or_else(String::new, |error| format!("; the first: {error}"));
        format!("{lost} of {} motions cannot be followed{why}", draw.samples)
    });
    let beyond = doubts::beyond_law::<M, N>(&operating, &[]);
    let open = basin.count(UNCONFIRMED);
    let unconfirmed = (open > 0).then(|| {
        format!(
            "what becomes of {open} of {} starts is not confirmed: within `duration` the motions have not settled, finer tolerances tell something \
             else each time, or all motions nearby are cycles",
            draw.samples
        )
    });
    Ok(Outcome {
        scalars: basin.told::<M, N>().scalars(),
        dataset: basin.dataset::<M, N>()?,
        table: Some(basin.table::<M, N>()?),
        checks: vec![repeated(&operating, draw, following, &samples, progress)?],
        warnings: beyond.into_iter().chain(warning).chain(unconfirmed).collect(),
        missing: lost,
        ..Outcome::default()
    })
}

/// What the motion from a sample settles to.
fn settled<S: SlidingSystem<N>, const N: usize>(
    operating: &Operating<S>,
    draw: &Draw<'_>,
    following: &Following,
    sample: usize,
    progress: &dyn Progress,
) -> Result<Confirmed<N>, MarchError> {
    let time = operating.time(following.duration);
    let patience = Patience { time, transient: 0.5 * time, ..Patience::default() };
    let start = draw.start(sample, operating.system.steady_sliding());
    let settings = operating.settings(following);
    settle_confirmed(&operating.system, start, settings, &patience, &|| progress.interrupted())
}

fn follow<S: SlidingSystem<N>, const N: usize>(
    operating: &Operating<S>,
    draw: &Draw<'_>,
    following: &Following,
    sample: usize,
    progress: &dyn Progress,
) -> Result<SampledStart, ModelError> {
    let (fate, time, rms) = match settled(operating, draw, following, sample, progress) {
        Err(MarchError::Interrupted { .. }) => return Err(ModelError::Interrupted),
        Err(_) => (LOST, None, None),
        Ok(confirmed) => {
            let attractor = &confirmed.attractor;
            let is_at_rest = attractor.settled == Settled::SteadySliding;
            let rms = if is_at_rest { 0.0 } else { attractor.measures.rms() };
            (becomes(&confirmed), Some(attractor.time), Some(rms))
        }
    };
    Ok(SampledStart { sample, fate, time, rms })
}

/// Some samples followed again at a smaller tolerance: their fates must stay, but for those on the border.
fn repeated<S: SlidingSystem<N>, const N: usize>(
    operating: &Operating<S>,
    draw: &Draw<'_>,
    following: &Following,
    samples: &[SampledStart],
    progress: &dyn Progress,
) -> Result<CheckRecord, ModelError> {
    let finer = Following { tolerance: (FINER * following.tolerance).max(1e-12), ..*following };
    let some: Vec<&SampledStart> = samples.iter().take(REPEATED).collect();
    let changed: Vec<bool> = parallel::try_each(&some, |sample| {
        let again = follow(operating, draw, &finer, sample.sample, progress)?;
        Ok::<_, ModelError>(again.fate != sample.fate)
    })?;
    Ok(CheckRecord::new(
        "the fates stay when the motions are followed more exactly",
        format!("share of {} samples whose fate changes at a hundredth of the tolerance", some.len()),
        Disagreement::share(changed),
        CHANGED_LIMIT,
    ))
}

/// What is told of a basin.
#[derive(Results)]
pub(crate) struct ToldBasin {
    /// of the starts that return to steady sliding
    #[result(unit = "1")]
    fraction: f64,
    /// its 95 % interval
    #[result(unit = "1")]
    interval: [f64; 2],
    samples: usize,
    seed: u64,
    distribution: &'static str,
    /// where starts were drawn, coordinate by coordinate
    within: ByName<[f64; 2]>,
    /// that in m and m/s
    #[result(optional)]
    within_si: Option<ByName<[f64; 2]>>,
    /// how many starts became what
    fates: ByName<usize>,
}

/// The keys of the summary.
pub(crate) fn summary_keys() -> Vec<Declared> {
    let fates = BECOMES.map(|(_, word)| key(word));
    Declared::named(ToldBasin::declared(), "fates", &fates)
}

/// The words of what a motion becomes as a key.
fn key(word: &str) -> String {
    word.replace([' ', '-'], "_")
}

struct SampledBasin<'a, S> {
    samples: &'a [SampledStart],
    draw: &'a Draw<'a>,
    operating: &'a Operating<S>,
}

impl<S> SampledBasin<'_, S> {
    fn first_lost(&self) -> Option<usize> {
        self.samples.iter().find(|sample| sample.fate == LOST).map(|sample| sample.sample)
    }

    fn count(&self, fate: u8) -> usize {
        self.samples.iter().filter(|sample| sample.fate == fate).count()
    }

    fn told<M: Moving<N, System = S>, const N: usize>(&self) -> ToldBasin {
        let decided = self.samples.len() - self.count(LOST);
        let returned = self.count(STEADY_SLIDING);
        let interval = wilson(returned, decided);
        let within = M::COORDINATES
            .iter()
            .zip(self.draw.within)
            .filter_map(|(coordinate, range)| Some((coordinate.name.to_owned(), (*range)?)));
        let fates = BECOMES.iter().map(|(code, word)| (key(word), self.count(*code)));
        ToldBasin {
            fraction: returned as f64 / decided as f64,
            interval,
            samples: self.samples.len(),
            seed: self.draw.seed,
            distribution: "uniform and independent; other coordinates as in steady sliding",
            within_si: self.operating.si.map(|units| {
                let in_si = |(name, [from, to]): (String, [f64; 2])| {
                    let ends = [units.coordinate(&name, from), units.coordinate(&name, to)];
                    (name, ends)
                };
                within.clone().map(in_si).collect()
            }),
            within: within.collect(),
            fates: fates.collect(),
        }
    }

    /// The start of every sample, coordinate by coordinate.
    fn starts<M: Moving<N, System = S>, const N: usize>(&self) -> Vec<Vec<f64>>
    where
        S: SlidingSystem<N>,
    {
        let steady = self.operating.system.steady_sliding();
        let states: Vec<[f64; N]> =
            self.samples.iter().map(|sample| self.draw.start(sample.sample, steady)).collect();
        (0..N).map(|k| states.iter().map(|state| state[k]).collect()).collect()
    }

    fn dataset<M: Moving<N, System = S>, const N: usize>(&self) -> Result<Dataset, ModelError>
    where
        S: SlidingSystem<N>,
    {
        let count = self.samples.len();
        let over =
            |name: &str, values: Vec<f64>| Variable::new(name, &["sample"], &[count], values).units("1");
        let fates = self.samples.iter().map(|sample| sample.fate).collect();
        let value = |value: fn(&SampledStart) -> Option<f64>| {
            self.samples.iter().map(|sample| value(sample).unwrap_or(f64::NAN)).collect::<Vec<_>>()
        };
        let clear = format!("time {} after which that was clear", M::CLOCK.symbol);
        let mut dataset = Dataset::new()
            .with(
                Variable::classes("fate", &["sample"], &[count], fates, &BECOMES)
                    .long_name("what becomes of the start"),
            )?
            .with(over("settling_time", value(|s| s.time)).long_name(&clear))?
            .with(over("rms", value(|s| s.rms)).long_name("rms of x of what it settles to"))?;
        let mut drawn = Vec::new();
        for ((coordinate, values), range) in
            M::COORDINATES.iter().zip(self.starts::<M, N>()).zip(self.draw.within)
        {
            let name = format!("start_{}", coordinate.name);
            dataset = dataset.with(
                over(&name, values).long_name(coordinate.long_name).attribute("label", coordinate.label),
            )?;
            if range.is_some() {
                drawn.push(name);
            }
        }
        let dataset = dataset.attribute("drawn", drawn)?;
        match self.operating.si {
            Some(units) => units.told_in(dataset),
            None => Ok(dataset),
        }
    }

    fn table<M: Moving<N, System = S>, const N: usize>(&self) -> Result<Table, ModelError>
    where
        S: SlidingSystem<N>,
    {
        let mut table = Table::new();
        for (coordinate, values) in M::COORDINATES.iter().zip(self.starts::<M, N>()) {
            table = table.column(coordinate.name, "1", values)?;
        }
        let words: Vec<String> =
            self.samples.iter().map(|sample| BECOMES[usize::from(sample.fate)].1.to_owned()).collect();
        let value = |value: fn(&SampledStart) -> Option<f64>| {
            self.samples.iter().map(|sample| value(sample).unwrap_or(f64::NAN)).collect::<Vec<_>>()
        };
        let (times, rms) = (value(|s| s.time), value(|s| s.rms));
        table = table.column("fate", "", words)?.column("settling_time", "1", times.clone())?;
        table = table.column("rms", "1", rms.clone())?;
        if let Some(units) = self.operating.si {
            for (coordinate, values) in M::COORDINATES.iter().zip(self.starts::<M, N>()) {
                table = units.add_column(table, coordinate.name, &values)?;
            }
            table = units.add_column(table, "settling_time", &times)?;
            table = units.add_column(table, "rms", &rms)?;
        }
        Ok(table)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_start_is_drawn_within_its_ranges_and_nowhere_else() {
        let within = [Some([-2.0, 2.0]), None];
        let draw = Draw { within: &within, samples: 1000, seed: 3 };
        let starts: Vec<[f64; 2]> = (0..1000).map(|sample| draw.start(sample, [0.7, 0.1])).collect();
        assert!(starts.iter().all(|start| (-2.0..2.0).contains(&start[0]) && start[1] == 0.1));
        assert!(starts.iter().any(|start| start[0] < -1.9) && starts.iter().any(|start| start[0] > 1.9));
    }
}
