//! Fields over the bodies on the freedoms of an assembly.

use super::{BuiltAssembly, BuiltBody};
use crate::error::ModelError;
use faer::Mat;
use judder_dense::general::solve;

/// A vector at every place.
pub(crate) type PlaceField<'a> = dyn Fn([f64; 3]) -> [f64; 3] + 'a;

impl BuiltAssembly {
    /// A field of displacements, or velocities, on the freedoms; of a reduced body the nearest that its coordinates can show, by the least
    /// squares over its nodes.
    ///
    /// # Errors
    /// [`ModelError::Unsupported`] where it is not finite, or bodies have no nodes at known places.
    pub(crate) fn on_freedoms(&self, field: &PlaceField<'_>) -> Result<Vec<f64>, ModelError> {
        let mut all = Vec::with_capacity(self.assembly.size());
        for body in self.bodies.iter() {
            all.extend(body.on_coordinates(field)?);
        }
        Ok(match &self.bond {
            None => all,
            Some(bond) => (0..self.assembly.size()).map(|left| all[bond.freedom(left)]).collect(),
        })
    }
}

impl BuiltBody {
    fn on_coordinates(&self, field: &PlaceField<'_>) -> Result<Vec<f64>, ModelError> {
        let Some(layout) = &self.structure.layout else {
            let name = &self.name;
            return Err(ModelError::Unsupported(format!(
                "`{name}` has no nodes at known places, so no field over them; start with a `mode`"
            )));
        };
        let mut values = vec![0.0; self.basis.as_ref().map_or(self.size(), Mat::nrows)];
        for (place, own) in layout.points.iter().zip(&layout.freedoms) {
            let vector = field(*place);
            if let Some(value) = vector.iter().find(|value| !value.is_finite()) {
                let [x, y, z] = place;
                return Err(ModelError::Unsupported(format!("the start is {value} at ({x}, {y}, {z}) m")));
            }
            for (freedom, value) in own.iter().zip(vector) {
                if let Some(freedom) = freedom {
                    values[*freedom] = value;
                }
            }
        }
        let Some(basis) = &self.basis else { return Ok(values) };
        let columns = basis.ncols();
        let dot = |i: usize, j: usize| (0..basis.nrows()).map(|k| basis[(k, i)] * basis[(k, j)]).sum::<f64>();
        let mut own = Mat::from_fn(columns, 1, |i, _| {
            (0..basis.nrows()).map(|k| basis[(k, i)] * values[k]).sum::<f64>()
        });
        match solve(Mat::from_fn(columns, columns, dot), &mut own) {
            Some(()) => Ok((0..columns).map(|k| own[(k, 0)]).collect()),
            None => Err(ModelError::Unsupported(format!(
                "the coordinates of `{}` depend on each other",
                self.name
            ))),
        }
    }
}
