//! Complex modes along a parameter: frequencies with lock-in, growth rates, the root locus, damping ratios.

#![deny(clippy::indexing_slicing, reason = "stored arrays may be of any length")]

use super::super::eigen::figure::{LARGEST, VERDICTS, bubble, by_verdict, frequency_axis, growth_axis};
use judder_numerics::complex::ElementaryComplex;
use judder_report::{Layer, Panel, Role};
use judder_study::pictures::{StoredArrays, SweptCoordinates, at, axis, codes, complexes};
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
pub(crate) fn eigen_sweep(dataset: &StoredArrays<'_>) -> Option<Vec<Panel>> {
    let swept = SweptCoordinates::of(dataset, "eigenvalue", 1)?;
    let (eigenvalues, verdicts) = (complexes(dataset, "eigenvalue")?, codes(dataset, "verdict")?);
    dataset.alike(&["eigenvalue", "verdict"])?;
    let count = *dataset.variable("eigenvalue")?.shape.last()?;
    let length = (count * swept.values.len()).max(1);
    let parts = eigenvalues.chunks(length).zip(verdicts.chunks(length));
    let curve = |(curve, (eigenvalues, verdicts)): (usize, (_, _))| CurveBranches {
        values: &swept.values,
        eigenvalues,
        verdicts,
        count,
        curve: swept.family.map(|_| (swept.role(curve), swept.label(curve, ""))),
    };
    let curves: Vec<CurveBranches<'_>> = parts.enumerate().map(curve).collect();
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
    /// The rows of the branch with this number: value, eigenvalue, verdict.
    fn branch(&self, branch: usize) -> impl Iterator<Item = (f64, Complex64, u8)> {
        let all = self.eigenvalues.iter().zip(self.verdicts).skip(branch).step_by(self.count.max(1));
        self.values.iter().zip(all).map(|(value, (eigenvalue, verdict))| (*value, *eigenvalue, *verdict))
    }

    /// Every point, value by value.
    fn points(&self) -> impl Iterator<Item = (f64, Complex64, u8)> {
        let values = self.values.iter().flat_map(|value| std::iter::repeat_n(*value, self.count));
        let all = self.eigenvalues.iter().zip(self.verdicts);
        values.zip(all).map(|(value, (eigenvalue, verdict))| (value, *eigenvalue, *verdict))
    }

    /// Every branch as a thin line: dashes and colours in turn, or the colour of the curve, which the first one names.
    fn lines(&self, x: Pick<'_>, y: Pick<'_>) -> Vec<Layer> {
        let line = |branch: usize| {
            let of = |pick: Pick<'_>| self.branch(branch).map(|(value, own, _)| pick(value, own)).collect();
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
        let unstable = self.points().filter(|(_, _, verdict)| *verdict == UNSTABLE);
        unstable.map(|(value, eigenvalue, _)| (value, eigenvalue))
    }

    /// A bubble for every eigenvalue; its area is the magnitude of the damping ratio.
    fn bubbles(&self) -> Vec<Layer> {
        let present: Vec<(f64, Complex64, u8)> =
            self.points().filter(|(_, eigenvalue, _)| eigenvalue.re.is_finite()).collect();
        let ratios: Vec<f64> = present.iter().map(|(_, own, _)| -own.re / own.modulus()).collect();
        let largest = ratios.iter().map(|ratio| ratio.abs()).fold(f64::MIN_POSITIVE, f64::max);
        // bubbles of neighbouring values shall stand side by side
        let diameter = (ACROSS / self.values.len() as f64).clamp(1.0, LARGEST);
        let verdicts: Vec<u8> = present.iter().map(|entry| entry.2).collect();
        by_verdict(
            &verdicts,
            &|k| present.get(k).map_or((f64::NAN, f64::NAN), |(value, own, _)| (*value, own.im / TAU)),
            Some(&|k| diameter * bubble(at(&ratios, k), largest)),
        )
    }
}

/// Squares where branches of any curve are unstable.
fn squares(unstable: &[(f64, Complex64)], x: Pick<'_>, y: Pick<'_>) -> Option<Layer> {
    if unstable.is_empty() {
        return None;
    }
    let of = |pick: Pick<'_>| unstable.iter().map(|(value, eigenvalue)| pick(*value, *eigenvalue)).collect();
    let (label, role) = *VERDICTS.get(usize::from(UNSTABLE))?;
    let style = if unstable.len() > FEW { role.crowded() } else { role.into() };
    Some(Layer::points(label, of(x), of(y), style))
}
