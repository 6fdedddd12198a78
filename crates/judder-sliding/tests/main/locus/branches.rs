//! Which eigenvalue goes on as which, where modes leave those that are shown and others enter.

use judder_numerics::counter::uniform;
use judder_sliding::SlidingError;
use judder_sliding::characteristic::PairCharacteristic;
use judder_sliding::coupling::Coupling;
use judder_sliding::dense_forms::ThreeField;
use judder_sliding::locus::follow;
use num_complex::Complex64;

/// Modes whose contact turns as the parameter grows, some of them damped so much that they decay without oscillating.
struct Turning {
    eigenvalues: Vec<f64>,
    damping: Vec<f64>,
    rows: [Vec<f64>; 4],
}

impl Turning {
    fn new(seed: u64) -> Self {
        let modes = 6 + (seed % 4) as usize;
        let draw = |list: u64, k: usize| uniform(seed, 1000 * list + k as u64);
        let frequencies: Vec<f64> = (0..modes).map(|k| 1.0 + 9.0 * draw(1, k)).collect();
        let damping = (0..modes).map(|k| (0.02 + 2.4 * draw(2, k).powi(4)) * frequencies[k]).collect();
        let row = |list: u64| (0..modes).map(|k| 2.0 * draw(list, k) - 1.0).collect::<Vec<f64>>();
        let [one, other, aside] = [row(3), row(4), row(5)];
        let pushed = one.iter().zip(&aside).map(|(own, aside)| own + 0.3 * aside).collect();
        let eigenvalues = frequencies.iter().map(|frequency| frequency * frequency).collect();
        Self { eigenvalues, damping, rows: [one, other.clone(), pushed, other] }
    }

    fn coupling(&self, at: f64) -> Coupling {
        let turned = |one: &[f64], other: &[f64]| -> Vec<f64> {
            one.iter().zip(other).map(|(a, b)| at.cos() * a + at.sin() * b).collect()
        };
        let [one, other, pushed, aside] = &self.rows;
        Coupling {
            compatibility: turned(one, other),
            equilibrium: turned(pushed, aside),
            feedback: Vec::new(),
        }
    }

    fn at(&self, at: f64) -> Result<PairCharacteristic, SlidingError> {
        PairCharacteristic::new(&self.coupling(at), &self.eigenvalues, &self.damping)
    }

    /// All eigenvalues of the upper half plane, from full matrices.
    fn all(&self, at: f64) -> Vec<Complex64> {
        let fields = ThreeField::new(&self.coupling(at), &self.eigenvalues, &self.damping).unwrap();
        let spectrum = fields.primal_spectrum(0.37).unwrap();
        spectrum.into_iter().filter(|s| s.im >= -1e-7).collect()
    }

    /// Where each eigenvalue at one parameter goes by another, in steps so small that no other comes near it; `None` where one does.
    fn followed(&self, start: &[Complex64], [from, to]: [f64; 2]) -> Vec<Option<Complex64>> {
        const STEPS: usize = 200;
        let mut values: Vec<Option<Complex64>> = start.iter().copied().map(Some).collect();
        for k in 1..=STEPS {
            let all = self.all(from + (to - from) * k as f64 / STEPS as f64);
            for value in &mut values {
                *value = value.and_then(|value| clear(&all, value));
            }
        }
        values
    }
}

/// The one of `all` that is nearest, unless another or its own mirror image is near as well.
fn clear(all: &[Complex64], value: Complex64) -> Option<Complex64> {
    let away = |other: &Complex64| (other - value).norm();
    let nearest = *all.iter().min_by(|a, b| away(a).total_cmp(&away(b)))?;
    let near = 8.0 * away(&nearest);
    let is_alone = all.iter().filter(|other| away(other) <= near).count() == 1;
    let has_parted = nearest.im.abs() < 1e-7 || nearest.im > near;
    (is_alone && has_parted).then_some(nearest)
}

/// Few positions, fewer branches than modes: an eigenvalue that a branch has at one position goes by the next to what the branch has there,
/// or the branch has nothing there. What it goes to is followed with full matrices in steps a tenth as long and more.
#[test]
fn no_branch_goes_on_as_another() {
    const PARAMETERS: [f64; 5] = [0.1, 0.4, 0.7, 1.0, 1.3];
    const COUNT: usize = 3;
    let (mut compared, mut ended, mut decaying) = (0, 0, 0);
    for seed in 0..100 {
        let pair = Turning::new(seed);
        let pieces = [[0.1, 0.55], [0.55, 1.3]];
        let Ok(found) = follow(&|at: f64| pair.at(at), &PARAMETERS, &pieces, COUNT, 1e-3) else { continue };
        for k in 1..PARAMETERS.len() {
            let [before, after] = [&found.eigenvalues[k - 1], &found.eigenvalues[k]];
            let is_there = |branch: &usize| before[*branch].re.is_finite();
            let branches: Vec<usize> = (0..before.len()).filter(is_there).collect();
            assert_eq!(branches.len(), COUNT);
            let start: Vec<Complex64> = branches.iter().map(|branch| before[*branch]).collect();
            decaying += start.iter().filter(|value| value.im == 0.0).count();
            let followed = pair.followed(&start, [PARAMETERS[k - 1], PARAMETERS[k]]);
            for (branch, value) in branches.into_iter().zip(followed) {
                let Some(value) = value else { continue };
                if after[branch].re.is_finite() {
                    let distance = (after[branch] - value).norm();
                    assert!(
                        distance < 1e-6 * (1.0 + value.norm()),
                        "{seed}, {k}: {} or {value}",
                        after[branch]
                    );
                    compared += 1;
                } else {
                    assert!(!after.iter().any(|other| (other - value).norm() < 1e-6), "{seed}, {k}: {value}");
                    ended += 1;
                }
            }
        }
    }
    assert!(compared > 1000 && ended > 20 && decaying > 20, "{compared}, {ended}, {decaying}");
}
