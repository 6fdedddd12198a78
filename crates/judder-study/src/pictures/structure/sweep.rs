//! Complex modes along a parameter: frequencies with lock-in, growth rates, the root locus, damping ratios.

use super::eigen::{LARGEST, VERDICTS, bubble, by_verdict, frequency_axis, growth_axis};
use super::{codes, complexes, reals};
use crate::pictures::axis;
use judder_report::{Layer, Panel, Role};
use judder_store::Dataset;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Usual markers that stand side by side across a panel.
const ACROSS: f64 = 45.0;
/// More points than these crowd.
const FEW: usize = 30;
/// The code of an unstable eigenvalue.
const UNSTABLE: u8 = 2;

/// The branches of a sweep.
struct Branches<'a> {
    values: &'a [f64],
    eigenvalues: &'a [Complex64],
    verdicts: &'a [u8],
    count: usize,
}

/// Frequencies and growth rates over the parameter, the root locus, damping ratios.
pub(in crate::pictures) fn eigen_sweep(dataset: &Dataset) -> Option<Vec<Panel>> {
    let coordinate = dataset.variable("value")?;
    let branches = Branches {
        values: reals(dataset, "value")?,
        eigenvalues: complexes(dataset, "eigenvalue")?,
        verdicts: codes(dataset, "verdict")?,
        count: *dataset.variable("eigenvalue")?.shape.last()?,
    };
    let frequency = || frequency_axis(branches.eigenvalues);
    let (value, hertz) = (|v: f64, _: Complex64| v, |_: f64, l: Complex64| l.im / TAU);
    let growth = |_: f64, l: Complex64| l.re;
    let mut over_growth = vec![Layer::horizontal_rule(0.0, "")];
    over_growth.extend(branches.curves(&value, &growth));
    let mut locus = vec![Layer::vertical_rule(0.0, "")];
    locus.extend(branches.curves(&growth, &hertz));
    Some(vec![
        Panel::new(axis(coordinate), frequency(), branches.curves(&value, &hertz)).with_title("frequencies"),
        Panel::new(axis(coordinate), growth_axis(branches.eigenvalues), over_growth)
            .with_title("growth rates"),
        Panel::new(growth_axis(branches.eigenvalues), frequency(), locus).with_title("root locus"),
        Panel::new(axis(coordinate), frequency(), branches.bubbles()).with_title("damping ratios"),
    ])
}

type Pick<'p> = &'p dyn Fn(f64, Complex64) -> f64;

impl Branches<'_> {
    fn at(&self, row: usize, branch: usize) -> (Complex64, u8) {
        let place = row * self.count + branch;
        (self.eigenvalues[place], self.verdicts[place])
    }

    /// Every branch as a thin line, dashes and colours in turn; over them squares where one is unstable.
    fn curves(&self, x: Pick<'_>, y: Pick<'_>) -> Vec<Layer> {
        let mut layers = Vec::new();
        for branch in 0..self.count {
            let rows = 0..self.values.len();
            let of = |pick: Pick<'_>| {
                rows.clone().map(|row| pick(self.values[row], self.at(row, branch).0)).collect()
            };
            layers.push(Layer::line("", of(x), of(y), Role::Mode(branch)));
        }
        let unstable: Vec<(usize, usize)> = (0..self.values.len())
            .flat_map(|row| (0..self.count).map(move |branch| (row, branch)))
            .filter(|(row, branch)| self.at(*row, *branch).1 == UNSTABLE)
            .collect();
        if !unstable.is_empty() {
            let of = |pick: Pick<'_>| {
                unstable
                    .iter()
                    .map(|(row, branch)| pick(self.values[*row], self.at(*row, *branch).0))
                    .collect()
            };
            let (label, role) = VERDICTS[usize::from(UNSTABLE)];
            let style = if unstable.len() > FEW { role.crowded() } else { role.into() };
            layers.push(Layer::points(label, of(x), of(y), style));
        }
        layers
    }

    /// A bubble for every eigenvalue; its area is the magnitude of the damping ratio.
    fn bubbles(&self) -> Vec<Layer> {
        let present: Vec<(f64, Complex64, u8)> = (0..self.values.len())
            .flat_map(|row| (0..self.count).map(move |branch| (row, branch)))
            .map(|(row, branch)| (self.values[row], self.at(row, branch)))
            .filter(|(_, (value, _))| value.re.is_finite())
            .map(|(value, (eigenvalue, verdict))| (value, eigenvalue, verdict))
            .collect();
        let ratio = |k: usize| -present[k].1.re / present[k].1.norm();
        let largest = (0..present.len()).map(|k| ratio(k).abs()).fold(f64::MIN_POSITIVE, f64::max);
        // bubbles of neighbouring values shall stand side by side
        let diameter = (ACROSS / self.values.len() as f64).clamp(1.0, LARGEST);
        let verdicts: Vec<u8> = present.iter().map(|entry| entry.2).collect();
        by_verdict(
            &verdicts,
            &|k| (present[k].0, present[k].1.im / TAU),
            Some(&|k| diameter * bubble(ratio(k), largest)),
        )
    }
}
