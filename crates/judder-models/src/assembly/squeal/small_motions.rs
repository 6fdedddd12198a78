//! What is known of small motions about steady sliding, and what becomes of a motion by it and by how its energy falls.

use crate::error::ModelError;
use crate::structure::solved_size::complex_mode_settings;
use judder_nonsmooth::energy::EnergyWindows;
use judder_structure::complex_modes::{ComplexModes, Eigenvalue, Verdict, all_complex_modes};
use judder_structure::quadratic::Quadratic;
use judder_study::text::short;
use std::f64::consts::TAU;

/// What becomes of a knock, by its code, in the order in which they are drawn.
pub(super) const FATES: [(u8, &str); 3] =
    [(SETTLES, "settles to steady sliding"), (VIBRATES, "keeps vibrating"), (OPEN, "undecided")];
pub(super) const SETTLES: u8 = 0;
pub(super) const VIBRATES: u8 = 1;
pub(super) const OPEN: u8 = 2;

/// What of the energy of the first half of the windows is left in the second at most where a motion falls,
const KEEPS: f64 = 0.95;
/// of its energy at first at most where it has settled while it falls,
const GONE: f64 = 1e-6;
/// and where it lies still but for rounding.
const STILL: f64 = 1e-12;
/// The share of the rate of small motions at which the energy of one that keeps vibrating may fall.
const SLOWER: f64 = 0.1;
/// By what power of e the energy of small motions falls over all windows at least, where a motion is told from them.
const LONG: f64 = 1.0;

/// What is known of small motions about steady sliding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct KnownSmallMotions {
    /// Between which angular frequencies all modes are known; none where they are at all.
    band: Option<[f64; 2]>,
    /// The mode that grows fastest, of those that are known.
    fastest: Option<Eigenvalue>,
    /// Whether others may grow: the modes there are not all known, or one swings that neither grows nor decays within its error.
    may_grow: bool,
    /// Whether all of them decay.
    decays: bool,
    /// The least rate at which the energy of one falls, in 1/s; none where one does not.
    slowest: Option<f64>,
    /// Whether the forces of some contact point that is closed bend about steady sliding while it slides, so that larger motions are none of the modes.
    bends: bool,
}

/// A motion towards its end.
#[derive(Debug, Clone, Copy)]
pub(super) struct LateMotion<'a> {
    /// Its energy at first, in J.
    pub(super) first: f64,
    pub(super) windows: &'a EnergyWindows,
    /// In s.
    pub(super) step: f64,
    /// Whether a contact point changes what it does,
    pub(super) changes: bool,
    /// or does something else than in steady sliding.
    pub(super) differs: bool,
}

impl KnownSmallMotions {
    /// The modes of a band, and those at all frequencies of problems that are small enough.
    pub(super) fn of(
        problem: &Quadratic,
        (band, in_band): ([f64; 2], &ComplexModes),
        bends: bool,
    ) -> Result<Self, ModelError> {
        let all = all_complex_modes(problem, &complex_mode_settings(problem.stiffness().val().len()))?;
        let of_band = values(in_band);
        Ok(match all.as_ref().map(|all| (values(all), all.complete())) {
            Some((of_all, true)) => Self::new(&of_all, None, true, bends),
            Some((of_all, false)) => {
                // what grows grows, proof or not
                let growing = of_all.into_iter().filter(|own| own.verdict() == Verdict::Unstable);
                let known: Vec<Eigenvalue> = of_band.into_iter().chain(growing).collect();
                Self::new(&known, Some(band), in_band.complete(), bends)
            }
            None => Self::new(&of_band, Some(band), in_band.complete(), bends),
        })
    }

    fn new(modes: &[Eigenvalue], band: Option<[f64; 2]>, is_complete: bool, bends: bool) -> Self {
        let with = |verdict: Verdict| modes.iter().filter(move |own| own.verdict() == verdict);
        // what creeps away without swinging grows as well
        let fastest = with(Verdict::Unstable).max_by(|a, b| a.value.re.total_cmp(&b.value.re)).copied();
        let swings = with(Verdict::Marginal).any(|own| own.frequency_hz() != 0.0);
        // a body that rests beside its place moves no more
        let drifts = with(Verdict::Marginal).any(|own| own.defective);
        let rates = with(Verdict::Stable).map(|own| -2.0 * own.value.re);
        let is_stable = modes.iter().all(|own| own.verdict() == Verdict::Stable);
        Self {
            band,
            fastest,
            may_grow: !is_complete || swings,
            decays: is_complete && is_stable,
            slowest: rates.reduce(f64::min).filter(|_| !swings && !drifts),
            bends,
        }
    }

    /// Whether some grow.
    pub(super) fn grows(&self) -> bool {
        self.fastest.is_some()
    }

    /// Whether it is proven that none grows, at whatever frequency.
    pub(super) fn is_quiet(&self) -> bool {
        !self.grows() && !self.may_grow && self.band.is_none()
    }

    /// In words.
    pub(super) fn words(&self) -> String {
        let beyond = self.band.map(|band| {
            let [from, to] = band.map(|omega| short(omega / TAU));
            format!(" from {from} to {to} Hz; of modes beyond nothing is known")
        });
        let everywhere = beyond.unwrap_or_else(|| " at all frequencies".to_owned());
        match &self.fastest {
            Some(own) if own.frequency_hz() == 0.0 => "grow without swinging".to_owned(),
            Some(own) => format!("grow at {} Hz", short(own.frequency_hz())),
            None if self.may_grow => format!("not proven to decay{everywhere}"),
            None => format!("decay{everywhere}"),
        }
    }

    /// What is left open of all that is told of motions, where modes beyond the band are not known.
    pub(super) fn doubt(&self) -> Option<String> {
        (self.band.is_some() && !self.grows() && !self.may_grow).then(|| {
            let words = self.words();
            format!("what becomes of knocks is told but for modes beyond the band: small motions {words}, for all modes are sought of few freedoms alone")
        })
    }

    /// What would have to be otherwise where it is not clear what becomes of a motion of which every step was solved.
    pub(super) fn remedy(&self) -> String {
        let grows = self.grows();
        match self.may_grow && !grows {
            true => format!("small motions are {}, so that none is told to settle", self.words()),
            false if grows => {
                let words = self.words();
                format!("small motions {words}, so that none settles: they need a longer duration to be told to keep vibrating")
            }
            false if self.bends => {
                "they need a longer duration: where forces bend a motion that falls may fall to another motion, and is told to settle where a millionth of its energy is left".to_owned()
            }
            false => "they need a longer duration".to_owned(),
        }
    }

    /// What becomes of a motion of which every step was solved.
    pub(super) fn fate(&self, motion: &LateMotion<'_>) -> u8 {
        let [earlier, last] = motion.windows.halves();
        if !(earlier.is_finite() && last.is_finite()) {
            return OPEN;
        }
        let falls = last < KEEPS * earlier;
        if self.grows() {
            return if falls { OPEN } else { VIBRATES };
        }
        // such a motion is made of the modes, if all are known
        let is_linear = self.band.is_none() && !self.bends && !motion.differs;
        let is_gone = last <= GONE * motion.first;
        match self.may_grow {
            true => OPEN,
            _ if self.decays && is_linear && falls => SETTLES,
            // nothing of the kind comes back
            _ if is_gone && (falls || last <= STILL * motion.first) => SETTLES,
            _ if !falls && !is_gone && self.is_unlike(motion) => VIBRATES,
            _ => OPEN,
        }
    }

    /// Whether the energy of a motion does not fall as that of small ones, and something keeps it from that.
    fn is_unlike(&self, motion: &LateMotion<'_>) -> bool {
        let (Some(rate), Some(fall)) = (self.slowest, motion.windows.fastest_fall()) else { return false };
        let is_long = rate * motion.step * motion.windows.steps() as f64 >= LONG;
        is_long && (self.bends || motion.changes) && fall / motion.step <= SLOWER * rate
    }
}

fn values(modes: &ComplexModes) -> Vec<Eigenvalue> {
    modes.modes.iter().map(|mode| mode.eigenvalue).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_complex::Complex64;

    fn mode(re: f64, im: f64) -> Eigenvalue {
        Eigenvalue {
            value: Complex64::new(re, im),
            residual: 0.0,
            left_residual: 0.0,
            condition: 1.0,
            error: 1e-9,
            defective: false,
        }
    }

    /// Energies over 1000 steps of 1 ms, of the whole at first.
    fn fate(small: &KnownSmallMotions, energy: impl Fn(f64) -> f64, [changes, differs]: [bool; 2]) -> u8 {
        let mut windows = EnergyWindows::new(1000);
        (0..1000_u64).for_each(|step| windows.add(step, energy(1e-3 * step as f64)));
        small.fate(&LateMotion { first: 1.0, windows: &windows, step: 1e-3, changes, differs })
    }

    const SAME: [bool; 2] = [false; 2];

    /// A motion that shrinks to a cycle loses as much in the windows as one that decays: only forces without bends tell them apart.
    #[test]
    fn a_motion_that_falls_settles_only_where_it_is_one_of_the_modes_or_gone() {
        let to_cycle = |t: f64| 0.3 + 0.2 * (-2.0 * t).exp();
        let [straight, bent] =
            [false, true].map(|bends| KnownSmallMotions::new(&[mode(-2.0, 500.0)], None, true, bends));
        assert_eq!(fate(&straight, to_cycle, SAME), SETTLES);
        assert_eq!(fate(&bent, to_cycle, SAME), OPEN);
        // points that lie still elsewhere than they slide
        assert_eq!(fate(&straight, to_cycle, [false, true]), OPEN);
        let gone = |t: f64| 1e-7 * (-4.0 * t).exp();
        assert_eq!(fate(&bent, gone, [true, true]), SETTLES);
        // a small motion that stays is not gone
        assert_eq!(fate(&bent, |_| 1e-7, SAME), OPEN);
        assert_eq!(fate(&bent, |_| 1e-15, SAME), SETTLES);
    }

    #[test]
    fn a_motion_that_stays_vibrates_where_forces_bend_or_points_change() {
        let stays = |_: f64| 0.3;
        let [straight, bent] =
            [false, true].map(|bends| KnownSmallMotions::new(&[mode(-2.0, 500.0)], None, true, bends));
        assert_eq!(fate(&straight, stays, SAME), OPEN);
        assert_eq!(fate(&straight, stays, [true, true]), VIBRATES);
        assert_eq!(fate(&bent, stays, SAME), VIBRATES);
        // too short to be told from small motions
        let slow = KnownSmallMotions::new(&[mode(-0.2, 500.0)], None, true, true);
        assert_eq!(fate(&slow, stays, SAME), OPEN);
    }

    /// Growing, neither growing nor decaying, and unknown small motions settle nothing; a body that rests beside its place moves no more.
    #[test]
    fn nothing_settles_where_modes_grow_or_may_grow() {
        let gone = |t: f64| 1e-7 * (-4.0 * t).exp();
        let with = |other: Eigenvalue, is_complete: bool| {
            let band = Some([100.0, 600.0]).filter(|_| !is_complete);
            KnownSmallMotions::new(&[mode(-2.0, 500.0), other], band, is_complete, false)
        };
        let growing = with(mode(0.1, 900.0), true);
        assert!(fate(&growing, gone, SAME) == OPEN && fate(&growing, |_| 0.3, SAME) == VIBRATES);
        assert!(growing.words().starts_with("grow at 143.2") && !growing.is_quiet());
        for unknown in [with(mode(0.0, 900.0), true), with(mode(-1.0, 550.0), false)] {
            assert!(fate(&unknown, gone, SAME) == OPEN && fate(&unknown, |_| 0.3, [true; 2]) == OPEN);
            assert!(unknown.remedy().contains("not proven to decay") && !unknown.is_quiet());
        }
        let beside = with(mode(0.0, 0.0), true);
        assert!(fate(&beside, gone, SAME) == SETTLES && beside.is_quiet());
    }
}
