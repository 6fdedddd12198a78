//! Modes that are too fast for the law of a sphere: eq. (3) of the oscillator paper, mode by mode.

use crate::assembly::AssemblySubject;
use judder_assembly::steady::SteadySliding;
use judder_numerics::complex::ElementaryComplex;
use judder_oscillator::quasi_steady::QuasiSteady;
use judder_store::Results;
use judder_structure::complex_modes::ComplexMode;
use judder_study::text::short;

/// What is told of laws of steady sliding in small motions.
#[derive(Results)]
pub(super) struct BeyondLaws {
    /// modes for which eq. (3), on which the law of a sphere stands in motion, is broken
    beyond_quasi_steady: Vec<BeyondLaw>,
}

/// A mode for which the law of a sphere does not hold.
#[derive(Clone, Results)]
struct BeyondLaw {
    /// number of the mode, by rising frequency
    mode: usize,
    /// contact of the sphere
    contact: String,
    /// ω τ with the natural frequency of the mode, ω = |λ|, and the mean retardation time, to be small against 1
    #[result(unit = "1")]
    quasi_steady_figure: f64,
    /// ω τ_k with the longest time that has a hundredth of the compliance
    #[result(unit = "1")]
    quasi_steady_longest: f64,
    /// ω T with the time by which the contact is behind
    #[result(unit = "1")]
    quasi_steady_memory: f64,
}

/// Modes that a warning names.
const NAMED: usize = 8;

impl BeyondLaws {
    /// Those of an assembly that has spheres, and the sentences that tell of them.
    pub(super) fn of(
        of: &AssemblySubject<'_>,
        steady: &SteadySliding,
        modes: &[ComplexMode],
    ) -> (Option<Self>, Vec<String>) {
        let (mut all, mut warnings) = (Vec::new(), Vec::new());
        for (index, sphere, state) in of.built.sliding_spheres(steady) {
            let contact = &of.built.assembly.interfaces[index].name;
            let broken = (1..).zip(modes).filter_map(|(mode, own)| {
                let condition = sphere.condition(&state, own.eigenvalue.value.modulus())?;
                condition.is_broken().then(|| BeyondLaw::new(mode, contact, condition.figures))
            });
            let broken: Vec<BeyondLaw> = broken.collect();
            warnings.extend(warning(contact, &broken));
            all.extend(broken);
        }
        let has_spheres = of.built.spheres.iter().any(Option::is_some);
        (has_spheres.then_some(Self { beyond_quasi_steady: all }), warnings)
    }
}

impl BeyondLaw {
    fn new(mode: usize, contact: &str, figures: QuasiSteady) -> Self {
        let QuasiSteady { figure, longest, memory } = figures;
        Self {
            mode,
            contact: contact.to_owned(),
            quasi_steady_figure: figure,
            quasi_steady_longest: longest,
            quasi_steady_memory: memory,
        }
    }
}

/// That eq. (3) is broken, in words; `None` where it is not.
fn warning(contact: &str, broken: &[BeyondLaw]) -> Option<String> {
    let named = broken.iter().take(NAMED).map(|own| {
        let [figure, memory] = [own.quasi_steady_figure, own.quasi_steady_memory].map(short);
        format!("mode {}, ω τ = {figure} (ω T = {memory})", own.mode)
    });
    let others = broken.len().saturating_sub(NAMED);
    let more = if others > 0 { format!("; and {others} more") } else { String::new() };
    (!broken.is_empty()).then(|| {
        format!(
            "eq. (3) of the oscillator paper, the condition of steady-sliding laws in motion, is broken at `{contact}` for {}{more}: ω τ ≪ 1 is asked, or at \
             least ω T ≪ 1 with the time T by which the contact is behind. What these modes do is that of the law alone",
            named.collect::<Vec<_>>().join("; ")
        )
    })
}
