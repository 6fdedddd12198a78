//! Operating points of any inputs as arrays: a value of every quantity at each.

use super::quantities::{OperatingState, QUANTITIES};
use crate::error::ModelError;
use crate::oscillator::inputs::OscillatorInputs;
use judder_numerics::parallel;
use judder_oscillator::Contact;
use judder_study::Progress;
use judder_study::model::OperatingQuantity;
use num_complex::Complex64;

/// Points that are solved between two looks at whether to end.
const STRETCH: usize = 1 << 10;

/// What was found at operating points, in their order.
#[derive(Debug, Clone, PartialEq)]
pub struct PointArrays {
    /// The quantities that were asked for.
    pub quantities: Vec<OperatingQuantity>,
    /// Their values, a row a point; not a number where there is none.
    pub values: Vec<Vec<f64>>,
    /// The four eigenvalues λ/ω_nx, sorted by imaginary, then real part; not a number where there is no steady sliding.
    pub eigenvalues: Vec<[Complex64; 4]>,
    /// Points without steady sliding.
    pub failed: Doubts,
    /// Points outside the range of the law.
    pub beyond: Doubts,
}

/// Points of which the same is told.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Doubts {
    /// How many.
    pub count: usize,
    /// The first, and what is told of it.
    pub first: Option<(usize, String)>,
}

impl Doubts {
    fn add(&mut self, index: usize, told: impl ToString) {
        self.count += 1;
        self.first.get_or_insert_with(|| (index, told.to_string()));
    }
}

/// What can be asked of operating points: all quantities, or those that need no search.
#[must_use]
pub fn quantities(with_sought: bool) -> Vec<OperatingQuantity> {
    QUANTITIES.into_iter().filter(|own| with_sought || !own.is_sought).collect()
}

/// The operating points of `count` inputs, solved side by side; the same bits at any number of threads.
///
/// # Errors
/// [`ModelError::Interrupted`].
pub fn point_arrays(
    contact: &Contact,
    inputs: &(dyn Fn(usize) -> OscillatorInputs + Sync),
    count: usize,
    quantities: Vec<OperatingQuantity>,
    progress: &dyn Progress,
) -> Result<PointArrays, ModelError> {
    const NONE: [Complex64; 4] = [Complex64::new(f64::NAN, f64::NAN); 4];
    progress.begin("operating points", count.div_ceil(STRETCH));
    let stretches: Vec<Vec<_>> = parallel::try_each_place(count.div_ceil(STRETCH), |stretch| {
        if progress.interrupted() {
            return Err(ModelError::Interrupted);
        }
        let points = stretch * STRETCH..count.min((stretch + 1) * STRETCH);
        let found = points.map(|index| {
            OperatingState::new(contact, &inputs(index))
                .map(|state| (state.eigenvalues(), state.values(&quantities), state.concern()))
        });
        let found = found.collect();
        progress.advance();
        Ok(found)
    })?;
    progress.end();
    let mut told = PointArrays {
        values: Vec::with_capacity(count),
        eigenvalues: Vec::with_capacity(count),
        failed: Doubts::default(),
        beyond: Doubts::default(),
        quantities,
    };
    for (index, found) in stretches.into_iter().flatten().enumerate() {
        match found {
            Ok((eigenvalues, values, concern)) => {
                told.eigenvalues.push(eigenvalues);
                told.values.push(values);
                if let Some(concern) = concern {
                    told.beyond.add(index, concern);
                }
            }
            Err(error) => {
                told.eigenvalues.push(NONE);
                told.values.push(vec![f64::NAN; told.quantities.len()]);
                told.failed.add(index, error);
            }
        }
    }
    Ok(told)
}
