//! What `transient` asks, in groups: the path of the indenter and what presses it.

use crate::contact::shape::ShapeSettings;
use crate::contact::single::run::pressed;
use crate::contact::transient::settings::{IndenterMotion, OscillationSettings, TransientSettings};
use crate::material::ContactScales;
use judder_contact::steady::profile::Profile;
use judder_contact::transient::{
    Before, CreepingSubstrate, IndenterPath, NormalCourse, PathCourse, TransientQuestion,
};
use judder_contact::unilateral::Loading;
use std::f64::consts::TAU;

/// The question of the settings in groups.
pub(crate) struct AskedTransient {
    /// R and τ are the units.
    pub(crate) path: IndenterPath,
    /// t/τ.
    pub(crate) duration: f64,
    /// Period of the motion or of the depth, over τ.
    pub(super) period: Option<f64>,
    /// ω τ of the depth.
    pub(super) depth_frequency: Option<f64>,
    /// v τ/R of a start.
    pub(super) velocity: Option<f64>,
    pub(super) loading: Loading,
    before: Before,
}

impl AskedTransient {
    pub(crate) fn new(shape: &ShapeSettings, settings: &TransientSettings, scales: &ContactScales) -> Self {
        let wave = |wave: &OscillationSettings| {
            (scales.length(wave.amplitude), scales.angular_frequency(wave.frequency))
        };
        let loading = pressed(shape, settings.loading(), scales);
        let oscillation = settings.oscillation.as_ref().map(wave);
        let normal = match (loading, oscillation) {
            (Loading::Indentation(mean), Some((amplitude, frequency))) => {
                NormalCourse::Indentation(PathCourse::sine(mean, amplitude, frequency))
            }
            (Loading::Indentation(depth), None) => NormalCourse::Indentation(PathCourse::Constant(depth)),
            (Loading::Load(force), _) => NormalCourse::Load(PathCourse::Constant(force)),
        };
        let (mut frequency, mut velocity) = (oscillation.map(|(_, frequency)| frequency), None);
        let path = match settings.motion() {
            IndenterMotion::Rest => IndenterPath::at_rest(normal),
            IndenterMotion::Start(speed) => {
                let speed = scales.velocity(speed);
                velocity = Some(speed);
                IndenterPath::start_of_sliding(speed, 0.0, normal)
            }
            IndenterMotion::Reciprocation(motion) => {
                let (amplitude, angular_frequency) = wave(&motion);
                frequency = Some(angular_frequency);
                IndenterPath::reciprocation(amplitude, angular_frequency, normal)
            }
        };
        let is_relaxation = settings.motion() == IndenterMotion::Rest && oscillation.is_none();
        Self {
            path,
            duration: scales.over_time(settings.duration),
            period: frequency.map(|frequency| TAU / frequency),
            depth_frequency: oscillation.map(|(_, frequency)| frequency),
            velocity,
            loading,
            before: if is_relaxation { Before::Untouched } else { Before::Settled },
        }
    }

    /// The question of a contact in time.
    pub(crate) fn question<'a>(
        &'a self,
        substrate: &'a CreepingSubstrate,
        profile: &'a dyn Profile,
        settings: &TransientSettings,
    ) -> TransientQuestion<'a> {
        let mut question = TransientQuestion::new(substrate, profile, &self.path, self.duration);
        question.before = self.before;
        question.grid.cells = settings.cells;
        question.grid.memory_limit = settings.memory.bytes;
        question.energy = true;
        question
    }

    /// The largest δ/R of an imposed indentation; zero under a load.
    pub(crate) fn largest_depth(&self) -> f64 {
        match &self.path.normal {
            NormalCourse::Indentation(course) => course.range(self.duration)[1],
            NormalCourse::Load(_) => 0.0,
        }
    }

    /// What presses the indenter down, in groups.
    pub(crate) fn loading(&self) -> Loading {
        self.loading
    }

    /// ω τ of the largest speed over a half length of the contact, and of what swings.
    pub(crate) fn frequencies(&self, half_length: f64) -> Vec<f64> {
        let swing = self.period.map(|period| TAU / period);
        [Some(self.path.position.largest_rate() / half_length), swing].into_iter().flatten().collect()
    }

    /// What is asked, in groups, in words.
    pub(crate) fn words(&self, settings: &TransientSettings) -> String {
        format!("{}, t/τ = {}", settings.word.name(), judder_study::text::number(self.duration))
    }

    /// Steps that motion and frequencies will take over cells of a side.
    pub(crate) fn steps(&self, cells: usize) -> usize {
        let depth = match self.loading {
            Loading::Indentation(depth) => depth,
            Loading::Load(force) => libm::pow(0.75 * force, 2.0 / 3.0),
        };
        let cell = 2.0 * (2.0 * depth).sqrt() / cells as f64;
        let rate = (self.path.position.largest_rate() / cell).max(self.period.map_or(0.0, |p| 24.0 / p));
        // the decay of the first moments takes a few dozen
        50 + (self.duration * rate) as usize
    }
}
