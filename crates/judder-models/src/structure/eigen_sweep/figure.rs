//! Complex modes along a parameter: frequencies with lock-in, growth rates, the root locus, damping ratios.

use super::super::eigen::figure::{LARGEST, VERDICTS, bubble, by_verdict, frequency_axis, growth_axis};
use judder_numerics::complex::ElementaryComplex;
use judder_report::{Layer, Panel, Role};
use judder_store::Dataset;
use judder_study::pictures::{SweptCoordinates, axis, codes, complexes};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Usual markers that stand side by side across a panel.
const ACROSS: f64 = 45.0;
/// More points than these crowd.
const FEW: usize = 30;
/// The code of an unstable eigenvalue.
const UNSTABLE: u8 = 2;

/// The branches of one curve.
struct CurveBranches<'a> {
    values: &'a [f64],
    eigenvalues: &'a [Complex64],
    verdicts: &'a [u8],
    count: usize,
    /// How its lines look and what they are called, where there are several curves.
    curve: Option<(Role, String)>,
}

/// Frequencies and growth rates over the parameter, the root locus; damping ratios, a panel for each curve.
pub(crate) fn eigen_sweep(dataset: &Dataset) -> Option<Vec<Panel>> {
    let swept = SweptCoordinates::of(dataset, "eigenvalue")?;
    let (eigenvalues, verdicts) = (complexes(dataset, "eigenvalue")?, codes(dataset, "verdict")?);
    let count = *dataset.variable("eigenvalue")?.shape.last()?;
    let length = count * swept.values.len();
    let curve = |curve: usize| CurveBranches {
        values: &swept.values,
        eigenvalues: &eigenvalues[curve * length..][..length],
        verdicts: &verdicts[curve * length..][..length],
        count,
        curve: swept.family.map(|_| (swept.role(curve), swept.label(curve, ""))),
    };
    let curves: Vec<CurveBranches<'_>> = (0..swept.curves()).map(curve).collect();
    let frequency = || frequency_axis(eigenvalues);
    let (value, hertz) = (|v: f64, _: Complex64| v, |_: f64, l: Complex64| l.im / TAU);
    let growth = |_: f64, l: Complex64| l.re;
    let unstable: Vec<(f64, Complex64)> = curves.iter().flat_map(CurveBranches::unstable).collect();
    let all = |x: Pick<'_>, y: Pick<'_>| -> Vec<Layer> {
        let lines = curves.iter().flat_map(|curve| curve.lines(x, y));
        lines.chain(squares(&unstable, x, y)).collect()
    };
    let mut over_growth = vec![Layer::horizontal_rule(0.0, "")];
    over_growth.extend(all(&value, &growth));
    let mut locus = vec![Layer::vertical_rule(0.0, "")];
    locus.extend(all(&growth, &hertz));
    let mut panels = vec![
        Panel::new(axis(swept.axis), frequency(), all(&value, &hertz)).with_title("frequencies"),
        Panel::new(axis(swept.axis), growth_axis(eigenvalues), over_growth).with_title("growth rates"),
        Panel::new(growth_axis(eigenvalues), frequency(), locus).with_title("root locus"),
    ];
    panels.extend(curves.iter().map(|curve| {
        let of_curve = curve.curve.as_ref().map_or_else(String::new, |(_, label)| format!(", {label}"));
        Panel::new(axis(swept.axis), frequency(), curve.bubbles())
            .with_title(format!("damping ratios{of_curve}"))
    }));
    Some(panels)
}

type Pick<'p> = &'p dyn Fn(f64, Complex64) -> f64;

impl CurveBranches<'_> {
    fn at(&self, row: usize, branch: usize) -> (Complex64, u8) {
        let place = row * self.count + branch;
        (self.eigenvalues[place], self.verdicts[place])
    }

    /// Every branch as a thin line: dashes and colours in turn, or the colour of the curve, which the first one names.
    fn lines(&self, x: Pick<'_>, y: Pick<'_>) -> Vec<Layer> {
        let line = |branch: usize| {
            let of = |pick: Pick<'_>| {
                (0..self.values.len()).map(|row| pick(self.values[row], self.at(row, branch).0)).collect()
            };
            match &self.curve {
                None => Layer::line("", of(x), of(y), Role::Mode(branch)),
                Some((role, label)) => {
                    let label = if branch == 0 { label.as_str() } else { "" };
                    Layer::line(label, of(x), of(y), *role)
                }
            }
        };
        (0..self.count).map(line).collect()
    }

    /// Where a branch is unstable.
    fn unstable(&self) -> impl Iterator<Item = (f64, Complex64)> {
        (0..self.values.len())
            .flat_map(|row| (0..self.count).map(move |branch| (row, branch)))
            .map(|(row, branch)| (self.values[row], self.at(row, branch)))
            .filter(|(_, (_, verdict))| *verdict == UNSTABLE)
            .map(|(value, (eigenvalue, _))| (value, eigenvalue))
    }

    /// A bubble for every eigenvalue; its area is the magnitude of the damping ratio.
    fn bubbles(&self) -> Vec<Layer> {
        let present: Vec<(f64, Complex64, u8)> = (0..self.values.len())
            .flat_map(|row| (0..self.count).map(move |branch| (row, branch)))
            .map(|(row, branch)| (self.values[row], self.at(row, branch)))
            .filter(|(_, (value, _))| value.re.is_finite())
            .map(|(value, (eigenvalue, verdict))| (value, eigenvalue, verdict))
            .collect();
        let ratio = |k: usize| -present[k].1.re / present[k].1.modulus();
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

/// Squares where branches of any curve are unstable.
fn squares(unstable: &[(f64, Complex64)], x: Pick<'_>, y: Pick<'_>) -> Option<Layer> {
    if unstable.is_empty() {
        return None;
    }
    let of = |pick: Pick<'_>| unstable.iter().map(|(value, eigenvalue)| pick(*value, *eigenvalue)).collect();
    let (label, role) = VERDICTS[usize::from(UNSTABLE)];
    let style = if unstable.len() > FEW { role.crowded() } else { role.into() };
    Some(Layer::points(label, of(x), of(y), style))
}
