//! The forms of travelling points as sums of rows that stay, and the compliance between all points.

use super::StepView;
use super::edge::NearNodes;
use crate::bodies::MovingBodies;
use crate::contact_problem::Delassus;
use judder_sliding::edge::STENCIL;
use judder_sliding::plane::{PlaneVector, dot, plus};

/// A point at its place: its directions along normal and slip, and the nodes of the track beside it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PointForm {
    pub(super) directions: [PlaneVector; 2],
    pub(super) near: NearNodes,
}

/// Rows and the forms on them: along normal and slip of each point, d·(u − Σ w_k u_k) of one that travels, rows 2p and 2p + 1 of a point p that stays.
#[derive(Debug, Clone)]
pub(super) struct TravelForms {
    rows: usize,
    /// H A⁻¹ Hᵀ of the rows, column after column, in 1/kg.
    pub(super) compliance: Vec<f64>,
    /// Of the step before, with the impulses there; of those that stay `None`.
    now: Vec<Option<PointForm>>,
    /// Of this step.
    pub(super) next: Vec<Option<PointForm>>,
    /// The impulses of the step before along the rows of each point, in N s.
    impulses: Vec<PlaneVector>,
    /// z, v and v without contact by rows, each taken once a step.
    seen: Vec<[f64; 3]>,
    stamps: Vec<u64>,
    stamp: u64,
    /// A column of the compliance of the rows by a form; impulses on the rows.
    column: Vec<f64>,
    on_rows: Vec<f64>,
}

impl TravelForms {
    pub(super) fn new(points: usize, rows: usize) -> Self {
        Self {
            rows,
            compliance: Vec::new(),
            now: vec![None; points],
            next: vec![None; points],
            impulses: vec![[0.0; 2]; points],
            seen: vec![[0.0; 3]; rows],
            stamps: vec![0; rows],
            stamp: 0,
            column: vec![0.0; rows],
            on_rows: vec![0.0; rows],
        }
    }

    /// The form of a point after the last step, or where it starts; of one that stays none.
    pub(super) fn now(&self, point: usize) -> Option<&PointForm> {
        self.now[point].as_ref()
    }

    /// Begins a step.
    pub(super) fn begin(&mut self, impulses: &[f64]) {
        self.stamp += 1;
        for (point, own) in self.impulses.iter_mut().enumerate() {
            let parts = [impulses[2 * point], impulses[2 * point + 1]];
            *own = match &self.now[point] {
                Some(form) => form.vector(parts),
                None => parts,
            };
        }
    }

    /// z, v and v without contact of a row.
    fn see(&mut self, bodies: &MovingBodies, view: StepView<'_>, row: usize) -> [f64; 3] {
        if self.stamps[row] != self.stamp {
            self.stamps[row] = self.stamp;
            let of_row = |state: &[f64]| {
                let mut out = [0.0];
                bodies.seen(state, row, 1, &mut out);
                out[0]
            };
            self.seen[row] = view.states.map(of_row);
        }
        self.seen[row]
    }

    /// The displacements along two rows when the step ends without contact.
    pub(super) fn predicted(
        &mut self,
        bodies: &MovingBodies,
        view: StepView<'_>,
        first: usize,
    ) -> PlaneVector {
        [first, first + 1].map(|row| {
            let [z, before, after] = self.see(bodies, view, row);
            z + (view.shares[0] * before + view.shares[1] * after)
        })
    }

    /// Those of the nodes of a track.
    pub(super) fn predicted_nodes(
        &mut self,
        bodies: &MovingBodies,
        view: StepView<'_>,
        near: &NearNodes,
    ) -> [PlaneVector; STENCIL] {
        std::array::from_fn(|k| match k < near.count {
            true => self.predicted(bodies, view, near.row + 2 * k),
            false => [0.0; 2],
        })
    }

    /// The same with what the impulses of the step before add, that of point `own` where it would act on these nodes.
    pub(super) fn pushed_nodes(
        &mut self,
        bodies: &MovingBodies,
        view: StepView<'_>,
        own: usize,
        near: &NearNodes,
    ) -> [PlaneVector; STENCIL] {
        let predicted = self.predicted_nodes(bodies, view, near);
        std::array::from_fn(|k| match k < near.count {
            true => plus(predicted[k], view.shares[1], self.pushed(near.row + 2 * k, Some((own, near)))),
            false => [0.0; 2],
        })
    }

    /// What the impulses of the step before add to the velocity of a point of the slider, in m/s.
    pub(super) fn pushed_slider(&self, point: usize) -> PlaneVector {
        self.pushed(2 * point, None)
    }

    /// The same along two rows; the nodes on which one of the points acts may be others.
    fn pushed(&self, first: usize, other: Option<(usize, &NearNodes)>) -> PlaneVector {
        let by = |row: usize, [x, y]: PlaneVector| {
            let of = |column: usize| &self.compliance[column * self.rows..(column + 1) * self.rows];
            let (a, b) = (of(row), of(row + 1));
            [first, first + 1].map(|k| a[k] * x + b[k] * y)
        };
        let mut sum = [0.0; 2];
        for (point, impulse) in self.impulses.iter().enumerate().filter(|(_, own)| **own != [0.0; 2]) {
            sum = plus(sum, 1.0, by(2 * point, *impulse));
            let Some(form) = &self.now[point] else { continue };
            let near = match other {
                Some((own, near)) if own == point => near,
                _ => &form.near,
            };
            for (k, weight) in near.weights.iter().enumerate().take(near.count) {
                sum = plus(sum, -weight, by(near.row + 2 * k, *impulse));
            }
        }
        sum
    }

    /// Takes the forms of this step, with the compliance between their points.
    pub(super) fn go_on(&mut self, delassus: &mut Delassus) {
        self.now.copy_from_slice(&self.next);
        let Self { rows, compliance, now, column, .. } = self;
        let (rows, components) = (*rows, 2 * now.len());
        let near = || now.iter().flatten().map(|own| &own.near);
        let first = near().map(|own| own.row).min().unwrap_or(components);
        let last = near().map(|own| own.row + 2 * own.count).max().unwrap_or(components);
        delassus.set(|entries| {
            for (component, own) in entries.chunks_exact_mut(components).enumerate() {
                for range in [0..components, first..last] {
                    let column = &mut column[range.clone()];
                    column.fill(0.0);
                    terms(now, component, |row, share| {
                        let of_row = &compliance[row * rows + range.start..row * rows + range.end];
                        column.iter_mut().zip(of_row).for_each(|(sum, entry)| *sum += share * entry);
                    });
                }
                for (other, entry) in own.iter_mut().enumerate() {
                    *entry = 0.0;
                    terms(now, other, |row, share| *entry += share * column[row]);
                }
            }
        });
    }

    /// What the components of all points see of z, v, or v without contact, by `which`.
    pub(super) fn relative(
        &mut self,
        bodies: &MovingBodies,
        view: StepView<'_>,
        which: usize,
        out: &mut [f64],
    ) {
        for point in 0..self.now.len() {
            let mut vector = [2 * point, 2 * point + 1].map(|row| self.see(bodies, view, row)[which]);
            if let Some(PointForm { directions, near }) = self.now[point] {
                for (k, weight) in near.weights.iter().enumerate().take(near.count) {
                    let first = near.row + 2 * k;
                    let node = [first, first + 1].map(|row| self.see(bodies, view, row)[which]);
                    vector = plus(vector, -weight, node);
                }
                vector = directions.map(|direction| dot(direction, vector));
            }
            out[2 * point..2 * point + 2].copy_from_slice(&vector);
        }
    }

    /// Impulses of the components on the rows.
    pub(super) fn on_rows(&mut self, impulses: &[f64]) -> &[f64] {
        let Self { on_rows, now, .. } = self;
        on_rows.fill(0.0);
        for (component, impulse) in impulses.iter().enumerate() {
            terms(now, component, |row, share| on_rows[row] += share * impulse);
        }
        on_rows
    }
}

impl PointForm {
    /// The vector with these parts along normal and slip.
    fn vector(&self, parts: [f64; 2]) -> PlaneVector {
        let [normal, slip] = self.directions;
        plus(normal.map(|part| parts[0] * part), parts[1], slip)
    }
}

/// The rows of a component with what it takes of each.
#[inline]
fn terms(forms: &[Option<PointForm>], component: usize, mut take: impl FnMut(usize, f64)) {
    let Some(PointForm { directions, near }) = &forms[component / 2] else { return take(component, 1.0) };
    let (direction, first) = (directions[component % 2], component - component % 2);
    (0..2).for_each(|k| take(first + k, direction[k]));
    for (node, weight) in near.weights.iter().enumerate().take(near.count) {
        (0..2).for_each(|k| take(near.row + 2 * node + k, -weight * direction[k]));
    }
}
