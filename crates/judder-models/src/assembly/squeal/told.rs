//! What is told of modes that grow and of their cycles: in the summary, as arrays, as rows.

use super::cures::ToldCures;
use super::cycle::{CycleInBand, CycleLoudness, SoughtMode};
use super::knocks::ToldKnocks;
use super::margin::SoughtMargins;
use super::margin_told::ToldMargins;
use super::settings::AssemblySqueal;
use crate::assembly::limit_cycle::settings::CycleMethod;
use crate::key_sweep::KeySweep;
use judder_store::{ByName, Results, Variable};
use std::f64::consts::TAU;

/// What is told of the modes that grow.
#[derive(Results)]
#[results(arrays(modes), columns(modes))]
pub(super) struct ToldSqueal {
    /// how cycles are computed
    method: &'static str,
    /// between which frequencies modes were sought, in Hz: of others nothing is known
    band_hz: [f64; 2],
    /// whether it is proven that the band has no other modes
    pub(super) complete: bool,
    /// modes of the band that grow
    pub(super) unstable: usize,
    /// those of which a cycle was found
    pub(super) found: usize,
    /// the level of the loudest cycle that is not known to be unstable, in dB re 1 µm/s²: no motion comes to an unstable one
    level_db: Option<f64>,
    /// its frequency, in Hz
    frequency_hz: Option<f64>,
    /// how far beyond their onsets along a key cycles reach
    #[result(optional)]
    pub(super) margin: Option<ToldMargins>,
    /// what becomes of knocks from steady sliding
    #[result(optional)]
    pub(super) knocks: Option<ToldKnocks>,
    /// what the growth rate of the mode that leads the ranking follows
    #[result(optional)]
    pub(super) cures: Option<ToldCures>,
    /// each mode that grows, by rising frequency
    #[result(rows)]
    pub(super) modes: Vec<SquealingMode>,
}

/// A mode that grows, and its cycle, of which all is missing where none was found.
#[derive(Clone, Results)]
#[results(
    rows = "mode",
    arrays(mode, mode_frequency, growth_rate, margin, frequency, level, left_out),
    columns(
        mode,
        place_by_level,
        rank_by_growth,
        margin,
        place_by_margin,
        mode_frequency,
        growth_rate,
        frequency,
        frequency_shift,
        level,
        stick_share,
        slip_share,
        open_share,
        stability,
        second_opinion,
        left_out,
        is_converged,
        reason
    )
)]
pub(super) struct SquealingMode {
    /// number of the mode among those of the band that grow, by rising frequency
    mode: i64,
    /// its place from the loudest cycle on, unstable ones behind all others
    rank_by_level: Option<usize>,
    #[result(hidden, column = "rank_by_level")]
    place_by_level: Option<f64>,
    /// its place from the fastest growing on
    rank_by_growth: i64,
    /// how far before the onset of the mode cycles of it exist already, of the value of the key there
    #[result(unit = "1")]
    margin: Option<f64>,
    /// its place from the largest margin on, one more than those that are larger whatever they may be off; none where it is not known what it may be off itself
    rank_by_margin: Option<usize>,
    #[result(hidden, column = "rank_by_margin")]
    place_by_margin: Option<f64>,
    /// margins of other modes that may be larger as well as smaller, for what they may be off
    tied_by_margin: Option<usize>,
    /// frequency of the mode about steady sliding
    #[result(summary = "mode_frequency_hz", unit = "Hz")]
    pub(super) mode_frequency: f64,
    /// growth rate of the mode about steady sliding
    #[result(summary = "mode_growth_rate", unit = "1/s")]
    growth_rate: f64,
    /// frequency of the cycle
    #[result(summary = "frequency_hz", unit = "Hz")]
    frequency: Option<f64>,
    /// by how much that lies above the frequency of the mode, over it
    frequency_shift: Option<f64>,
    /// level of the acceleration of the cycle at the observed point that is loudest, re 1 µm/s²
    #[result(summary = "level_db", unit = "dB")]
    level: Option<f64>,
    /// the levels of all observed points along each direction, over 1 µm/s²
    #[result(unit = "dB")]
    levels: ByName<Option<f64>>,
    /// share of the period in which contact points stick, on average over them
    stick_share: Option<f64>,
    /// in which they slide
    slip_share: Option<f64>,
    /// in which they have lifted off
    open_share: Option<f64>,
    /// whether motions of its shape nearby are drawn to it
    attracts: Option<bool>,
    /// whether all motions nearby are, where that is known
    stable: Option<bool>,
    /// the same in words, or why it is not known
    stability: String,
    /// whether Hill's method says the same of the stability, or why steps alone say it
    second_opinion: String,
    /// its harmonics
    harmonics: Option<usize>,
    /// the share of the swing of the contact forces beyond the harmonics of the cycle, as a root of energies
    #[result(unit = "1")]
    left_out: Option<f64>,
    /// whether that is no more than `left_out` of the case allows, or a tenth where the number of harmonics is given; none where there is no cycle
    pub(super) converged: Option<bool>,
    #[result(hidden, column = "converged")]
    is_converged: String,
    /// why there is no cycle, or why its harmonics leave more out
    pub(super) reason: String,
}

/// Codes of what is known of the stability of cycles, in the order in which they are drawn.
pub(super) const STABILITIES: [(u8, &str); 4] =
    [(0, "stable cycle"), (1, "unstable cycle"), (2, "cycle of unknown stability"), (3, "no cycle found")];

pub(super) fn stabilities(modes: &[SquealingMode]) -> Variable {
    let code = |mode: &SquealingMode| match (mode.frequency, mode.stable) {
        (None, _) => 3,
        (_, Some(true)) => 0,
        (_, Some(false)) => 1,
        (_, None) => 2,
    };
    let codes: Vec<u8> = modes.iter().map(code).collect();
    let variable = Variable::classes("stability", &["mode"], &[codes.len()], codes, &STABILITIES);
    variable.long_name("whether motions nearby are drawn to the cycle of a mode")
}

/// The modes with their places by loudness and by growth.
pub(super) fn ranked(modes: &[SoughtMode]) -> Vec<SquealingMode> {
    let found = |own: &SoughtMode| own.1.as_ref().ok().and_then(CycleInBand::loudness);
    let ahead = |of: CycleLoudness| modes.iter().filter_map(found).filter(|own| own.is_ahead(of)).count();
    let faster = |than: f64| modes.iter().filter(|(value, _)| value.re > than).count();
    let told = modes.iter().enumerate().map(|(k, own)| {
        let (value, cycle) = own;
        let rank = found(own).map(|own| 1 + ahead(own));
        let cycle_or_none = cycle.as_ref().ok();
        let share = |k: usize| cycle_or_none.map(|own| own.shares[k]);
        let frequency = cycle_or_none.map(|own| own.frequency);
        let converged = cycle_or_none.map(|own| own.unconverged.is_none());
        SquealingMode {
            mode: 1 + k as i64,
            rank_by_level: rank,
            place_by_level: rank.map(|rank| rank as f64),
            rank_by_growth: 1 + faster(value.re) as i64,
            margin: None,
            rank_by_margin: None,
            place_by_margin: None,
            tied_by_margin: None,
            mode_frequency: value.im / TAU,
            growth_rate: value.re,
            frequency,
            frequency_shift: frequency.map(|own| TAU * own / value.im - 1.0),
            level: cycle_or_none.and_then(CycleInBand::level),
            levels: cycle_or_none.map(|own| own.levels.clone()).into_iter().flatten().collect(),
            stick_share: share(0),
            slip_share: share(1),
            open_share: share(2),
            attracts: cycle_or_none.and_then(|own| own.attracts),
            stable: cycle_or_none.and_then(|own| own.stable),
            stability: cycle_or_none.map_or_else(|| "no cycle".to_owned(), |own| own.stability.clone()),
            second_opinion: cycle_or_none.map_or_else(String::new, |own| own.second_opinion.clone()),
            harmonics: cycle_or_none.map(|own| own.harmonics),
            left_out: cycle_or_none.map(|own| own.left_out),
            converged,
            is_converged: match converged {
                None => String::new(),
                Some(true) => "yes".to_owned(),
                Some(false) => "no".to_owned(),
            },
            reason: match cycle {
                Ok(own) => own.unconverged.clone().unwrap_or_default(),
                Err(reason) => format!("no limit cycle: {reason}"),
            },
        }
    });
    told.collect()
}

impl ToldSqueal {
    pub(super) fn new(band: [f64; 2], complete: bool, modes: Vec<SquealingMode>) -> Self {
        // where all are unstable the first is one of them
        let loudest = modes.iter().find(|mode| mode.rank_by_level == Some(1) && mode.stable != Some(false));
        Self {
            method: CycleMethod::HarmonicBalance.name(),
            band_hz: band.map(|omega| omega / TAU),
            complete,
            unstable: modes.len(),
            found: modes.iter().filter(|mode| mode.frequency.is_some()).count(),
            level_db: loudest.and_then(|mode| mode.level),
            frequency_hz: loudest.and_then(|mode| mode.frequency),
            margin: None,
            knocks: None,
            cures: None,
            modes,
        }
    }

    /// The same with margins.
    pub(super) fn with_margins(
        mut self,
        asked: &AssemblySqueal,
        sweep: &KeySweep,
        found: &SoughtMargins,
    ) -> Self {
        let of_modes = found.of_modes(self.modes.len());
        for (mode, own) in self.modes.iter_mut().zip(of_modes) {
            let place = own.map(|(_, place)| place);
            mode.margin = own.map(|(margin, _)| margin.value);
            mode.rank_by_margin = place.and_then(|own| own.rank);
            mode.place_by_margin = mode.rank_by_margin.map(|rank| rank as f64);
            mode.tied_by_margin = place.map(|own| own.tied);
        }
        Self { margin: Some(ToldMargins::new(asked, sweep, found)), ..self }
    }

    /// That of all cycles found no motion comes to any.
    pub(super) fn all_unstable(&self) -> Option<String> {
        let cycles = || self.modes.iter().filter(|mode| mode.frequency.is_some());
        (self.found > 0 && cycles().all(|mode| mode.stable == Some(false))).then(|| {
            format!(
                "all {} cycles found are unstable, so that no motion comes to any of them: to what motions grow a march tells",
                self.found
            )
        })
    }

    /// The place of the mode that leads: the one with the loudest cycle, else the one that grows fastest.
    pub(super) fn leading(&self) -> Option<usize> {
        let first = |rank: &dyn Fn(&SquealingMode) -> bool| self.modes.iter().position(rank);
        first(&|mode| mode.rank_by_level == Some(1)).or_else(|| first(&|mode| mode.rank_by_growth == 1))
    }
}
