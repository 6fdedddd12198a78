//! The shapes in which the two structures of a sliding case swing together, at any position of the contact, on all points of both.

use crate::error::ModelError;
use crate::made_once::MadeOnce;
use crate::sliding::case::SlidingCase;
use crate::sliding::locus::conditions::conditions as locus_conditions;
use crate::sliding::locus::settings::{Along, LocusAnalysis};
use crate::sliding::system::ReducedPair;
use faer::Mat;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::parallel;
use judder_sliding::locus::{Conditions, Configuration, contact, spectrum};
use judder_sliding::shape::{gap_residual, mode_shape};
use judder_sliding::spectrum::WantedEigenvalues;
use judder_study::case::file::CaseFile;
use judder_study::{Progress, Silent, StudyError};
use num_complex::Complex64;
use std::sync::Arc;

/// The pair of a sliding case with the shapes of its structures on all their points: made once, asked at many positions.
pub struct ShapedPair {
    case: SlidingCase,
    system: ReducedPair,
    /// Φ of slider and track on the displacements of all points: three rows a point, a column a mode.
    expansions: [Mat<f64>; 2],
}

/// Coupled modes at one position, on the points of the slider, then those of the track.
#[derive(Debug, Clone, PartialEq)]
pub struct SlidingShapes {
    /// Distance of the contact point, undeformed, from the track's first node, m.
    pub position: f64,
    /// Where the points lie undeformed, the slider where the position takes it, m.
    pub points: Vec<[f64; 3]>,
    /// How many of them are the slider's: the first.
    pub slider_points: usize,
    /// Lines that show the bodies, as pairs of points.
    pub lines: Vec<[usize; 2]>,
    /// The eigenvalues, 1/s, those of lowest frequency first.
    pub eigenvalues: Vec<Complex64>,
    /// The displacements of every point by mode, the largest of them 1.
    pub shapes: Vec<Vec<[Complex64; 3]>>,
    /// By how much each shape opens the contact, over what its parts would: rounding of an eigenvalue.
    pub gap_residuals: Vec<f64>,
}

impl ShapedPair {
    /// Builds, reduces and couples the structures of a sliding case.
    ///
    /// # Errors
    /// A case of another model, structures that cannot be built or coupled, or of which no one knows where their freedoms lie;
    /// [`ModelError::Interrupted`].
    pub fn new(file: &CaseFile, progress: &dyn Progress) -> Result<Self, ModelError> {
        let Some(case) = file.case.of::<SlidingCase>() else {
            return Err(ModelError::WrongModel { command: "explore", model: file.case.model() });
        };
        let system = ReducedPair::until(case, progress).map_err(|uncoupled| uncoupled.placed(file))?;
        let [slider, track] = bodies(case).map(|index| {
            progress.go_on()?;
            let part = &system.parts[index];
            let Some(layout) = &part.structure.layout else {
                let name = &case.structures[index].name;
                return Err(ModelError::Unsupported(format!(
                    "`{name}` has no places: a table of its freedoms says where they lie"
                )));
            };
            let shapes = part.shapes(case, index).map_err(|uncoupled| uncoupled.placed(file))?;
            let freedoms: Vec<Option<usize>> = layout.freedoms.iter().flatten().copied().collect();
            let at = |row: usize, mode: usize| freedoms[row].map_or(0.0, |freedom| shapes[(freedom, mode)]);
            Ok(Mat::from_fn(freedoms.len(), shapes.ncols(), at))
        });
        Ok(Self { case: case.clone(), expansions: [slider?, track?], system })
    }

    /// Length of the track, m: positions lie between 0 and it.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.system.pair.length()
    }

    /// The `count` lowest modes at a position, as many as a locus counts where none is given, and one more where it swings with the last of
    /// them: of two that lock in one may grow. An analysis of kind `locus` says under which
    /// conditions; beside any other, the pair is damped and deformed by its load.
    ///
    /// # Errors
    /// [`StudyError::UnknownAnalysis`]; a locus over a key, a position off the track, no state of rest there, eigenvalues that are not found;
    /// [`ModelError::Interrupted`].
    pub fn at(
        &self,
        analysis: &str,
        position: f64,
        count: Option<usize>,
        progress: &dyn Progress,
    ) -> Result<SlidingShapes, ModelError> {
        progress.go_on()?;
        let pair = &self.system.pair;
        let (conditions, own) = self.conditions(analysis)?;
        let most = pair.modes().saturating_sub(1).max(1);
        let count = count.unwrap_or(own).clamp(1, most);
        let found = spectrum(pair, &conditions, position, WantedEigenvalues::Lowest((count + 1).min(most)))?
            .eigenvalues;
        let eigenvalues = lowest(found, count);
        let (coupling, _) = contact(pair, &conditions, position)?;
        let damping = if conditions.is_damped { pair.damping() } else { vec![0.0; pair.modes()] };
        let own = pair.eigenvalues();
        let shapes: Vec<(Vec<[Complex64; 3]>, f64)> = parallel::try_each(&eigenvalues, |s| {
            progress.go_on()?;
            let shape = mode_shape(&coupling, &own, &damping, *s);
            let shape = if shape.iter().all(|q| q.is_finite()) { shape } else { pole(&own, &damping, *s) };
            Ok::<_, StudyError>((self.displacements(&shape), gap_residual(&coupling, &shape)))
        })?;
        let (shapes, gap_residuals) = shapes.into_iter().unzip();
        let (points, slider_points, lines) = self.picture(position);
        Ok(SlidingShapes { position, points, slider_points, lines, eigenvalues, shapes, gap_residuals })
    }

    /// Under what the pair slides in an analysis, and how many modes are looked at.
    fn conditions(&self, analysis: &str) -> Result<(Conditions, usize), ModelError> {
        let found = self.case.analyses.iter().find(|own| own.name == analysis);
        match found.map(|own| own.settings::<LocusAnalysis>()) {
            Some(Some(settings)) if matches!(settings.along, Along::Key { .. }) => {
                Err(ModelError::Unsupported(format!(
                    "the locus `{analysis}` is over a key, and shapes are drawn at positions; ask for those of a locus over positions"
                )))
            }
            Some(Some(settings)) => Ok((locus_conditions(&self.case, settings), settings.count)),
            Some(None) => {
                let (velocity, load) = (self.case.motion.velocity, self.case.motion.load.force);
                let configuration = Configuration::Deformed;
                Ok((Conditions { configuration, is_damped: true, velocity, load }, COUNT))
            }
            None => {
                let known = self.case.analyses.iter().map(|own| own.name.clone()).collect();
                Err(StudyError::UnknownAnalysis { name: analysis.to_owned(), known }.into())
            }
        }
    }

    /// The displacements of all points in a shape of modal coordinates, the largest 1.
    fn displacements(&self, shape: &[Complex64]) -> Vec<[Complex64; 3]> {
        let (of_slider, of_track) = shape.split_at(self.expansions[0].ncols().min(shape.len()));
        let mut moved: Vec<Complex64> = Vec::new();
        for (expansion, shape) in self.expansions.iter().zip([of_slider, of_track]) {
            moved.extend((0..expansion.nrows()).map(|row| {
                shape.iter().enumerate().map(|(mode, q)| expansion[(row, mode)] * q).sum::<Complex64>()
            }));
        }
        let largest = moved.iter().copied().reduce(|a, b| if b.modulus() > a.modulus() { b } else { a });
        let scale = largest.filter(|value| value.modulus() > 0.0).map_or(Complex64::ONE, |value| 1.0 / value);
        let (points, _) = moved.as_chunks::<3>();
        points.iter().map(|point| point.map(|u| u * scale)).collect()
    }

    /// Points of both bodies with the slider at a position, how many are the slider's, and the lines between them.
    fn picture(&self, position: f64) -> (Vec<[f64; 3]>, usize, Vec<[usize; 2]>) {
        let [slider, track] =
            bodies(&self.case).map(|index| self.system.parts[index].structure.layout.as_ref());
        let pair = &self.system.pair;
        let (to, from) = (pair.rigid_place(position), pair.slider().contact.place);
        let moved = |[x, y, z]: &[f64; 3]| [x + to[0] - from[0], y + to[1] - from[1], *z];
        let mut points: Vec<[f64; 3]> =
            slider.iter().flat_map(|layout| layout.points.iter().map(moved)).collect();
        let first = points.len();
        points.extend(track.iter().flat_map(|layout| layout.points.iter().copied()));
        let mut lines: Vec<[usize; 2]> =
            slider.iter().flat_map(|layout| layout.lines.iter().copied()).collect();
        lines.extend(
            track.iter().flat_map(|layout| layout.lines.iter().map(|line| line.map(|end| end + first))),
        );
        (points, first, lines)
    }
}

/// Modes that are looked at where no locus says how many.
const COUNT: usize = 20;
/// Two modes swing together whose frequencies differ by less, as a share.
const TOGETHER: f64 = 1e-2;

/// The structures of slider and track by their places in the case.
fn bodies(case: &SlidingCase) -> [usize; 2] {
    [*case.contact.slider.structure, *case.contact.track.structure]
}

/// The shape of a mode that the contact does not touch: its eigenvalue is that of one of the structures.
fn pole(eigenvalues: &[f64], damping: &[f64], s: Complex64) -> Vec<Complex64> {
    let departures: Vec<f64> =
        eigenvalues.iter().zip(damping).map(|(value, d)| (s * s + d * s + value).modulus()).collect();
    let nearest = (0..departures.len()).min_by(|a, b| departures[*a].total_cmp(&departures[*b]));
    (0..departures.len())
        .map(|mode| if Some(mode) == nearest { Complex64::ONE } else { Complex64::ZERO })
        .collect()
}

/// Shapes at one position of a case: what [`ShapedPair`] gives, made for this once.
///
/// # Errors
/// As of [`ShapedPair`].
pub fn sliding_shapes(
    file: &CaseFile,
    analysis: &str,
    position: f64,
    count: Option<usize>,
) -> Result<SlidingShapes, ModelError> {
    ShapedPair::new(file, &Silent)?.at(analysis, position, count, &Silent)
}

/// The pair of one case, made once for all who ask for its shapes.
pub struct SharedPair(MadeOnce<Arc<ShapedPair>>);

impl SharedPair {
    /// Not made yet.
    #[must_use]
    pub const fn new() -> Self {
        // there is one, and the last that was made is remembered
        Self(MadeOnce::new(0))
    }

    /// The pair of the case, made now where it was not: who asks meanwhile waits, for as long as he likes.
    ///
    /// # Errors
    /// As of [`ShapedPair::new`].
    pub fn get(&self, file: &CaseFile, progress: &dyn Progress) -> Result<Arc<ShapedPair>, ModelError> {
        self.0.get("", progress, || Ok((Arc::new(ShapedPair::new(file, progress)?), 0)))
    }
}

impl Default for SharedPair {
    fn default() -> Self {
        Self::new()
    }
}

/// The first `count` in the order of their frequencies, and the next one where its frequency is that of the last.
fn lowest(mut found: Vec<Complex64>, count: usize) -> Vec<Complex64> {
    let pair = found.get(count - 1).zip(found.get(count));
    let together = pair.is_some_and(|(last, next)| next.im - last.im < TOGETHER * next.im);
    found.truncate(if together { count + 1 } else { count });
    found
}
