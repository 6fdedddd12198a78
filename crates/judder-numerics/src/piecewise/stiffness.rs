//! When a leg is stiff.

/// What is remembered to tell a stiff leg: how often the explicit step was as long as its stability allows.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Stiffness {
    limited: u32,
    free: u32,
    is_stiff: bool,
}

impl Stiffness {
    pub(super) fn is_stiff(self) -> bool {
        self.is_stiff
    }

    /// Takes note of a step's length times the rate of the field (Hairer, Nørsett, Wanner, *Solving …* II, IV.2).
    pub(super) fn observe(&mut self, step_times_rate: f64) {
        const BOUNDARY: f64 = 3.25;
        if step_times_rate > BOUNDARY {
            self.free = 0;
            self.limited += 1;
            self.is_stiff = self.limited >= 15;
        } else {
            self.free += 1;
            if self.free >= 6 {
                self.limited = 0;
            }
        }
    }
}
