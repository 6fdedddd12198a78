//! How long an explicit step may be.

use super::NonsmoothMarch;
use crate::NonsmoothError;
use crate::scheme::{ContactScheme, SmoothContact};

impl NonsmoothMarch<'_> {
    /// Whether an explicit step is short enough where the points are.
    pub(super) fn check_step(&self) -> Result<(), NonsmoothError> {
        if self.settings.scheme.implicitness() > 0.0 {
            return Ok(());
        }
        if (0..self.contact.points.len()).any(|point| self.contact.largest_stiffness(point).is_infinite()) {
            return Err(NonsmoothError::UnboundedStiffness);
        }
        let step = self.settings.step;
        let [omega, damping] = self.fastest;
        // springs at the points stiffen the bodies by no more than the largest row sum of √k W √k
        let stiffness = |point: usize| self.contact.largest_stiffness(point).sqrt();
        let points = 0..self.contact.points.len();
        let row = |point: usize| -> f64 {
            let entry = |other: usize| {
                let column = self.delassus.column(other * self.contact.dimension);
                stiffness(other) * column[point * self.contact.dimension].abs()
            };
            stiffness(point) * points.clone().map(entry).sum::<f64>()
        };
        let added = points.clone().map(row).fold(0.0, f64::max);
        let squared = omega * omega + added;
        // h² ω² + 2 h d ≤ 4; so written it is right where either is zero
        let limit = 4.0 / ((damping * damping + 4.0 * squared).sqrt() + damping);
        if step > limit || limit.is_nan() {
            return Err(NonsmoothError::StepOverLimit { step, limit });
        }
        Ok(())
    }

    /// Where points travel, looks anew at what hangs on the compliance between them: springs that a step still follows, and whether it is short enough.
    pub(super) fn look_at_compliance(&mut self) -> Result<(), NonsmoothError> {
        if self.travel.is_none() || self.settings.scheme.implicitness() > 0.0 {
            return Ok(());
        }
        if self.settings.scheme == ContactScheme::Smoothed {
            self.smooth = SmoothContact::new(&self.delassus, self.settings.step);
        }
        let yields = (0..self.gap.len()).any(|point| self.contact.is_compliant(point));
        if yields { self.check_step() } else { Ok(()) }
    }
}
