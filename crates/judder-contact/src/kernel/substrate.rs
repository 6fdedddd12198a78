//! The substrate as an indenter sees it that slides at one speed.

use super::layer::BondedLayer;
use judder_numerics::complex::ElementaryComplex;
use judder_numerics::order::sort_by_number;
use num_complex::Complex64;
use std::f64::consts::PI;

/// Wakes shorter than this, in cells, are no wakes: the kernel would differ by less than rounding.
const SHORTEST: f64 = 1e-20;
/// Wakes longer than this, in cells, have no displacement within any grid.
const LONGEST: f64 = 1e30;
/// Bits of a length that are dropped.
const DROPPED_BITS: u64 = 8;

/// One retardation time at one sliding speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WakeTerm {
    /// C_k E0, compliance of the term over that of the relaxed substrate.
    pub compliance: f64,
    /// ℓ_k = v τ_k, the distance slid in one retardation time, in the problem's length unit.
    pub length: f64,
}

/// A positive number to the nearest multiple of 2⁸ units in its last place.
fn rounded(value: f64) -> f64 {
    let half = 1 << (DROPPED_BITS - 1);
    f64::from_bits(value.to_bits().wrapping_add(half) >> DROPPED_BITS << DROPPED_BITS)
}

/// The compliance of a sliding contact: 1/E∞ at once, the rest along wakes behind the pressure. In units of 1/E0.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SlidingSubstrate {
    /// E0/E∞.
    pub instantaneous: f64,
    /// The terms of the creep spectrum.
    pub terms: Vec<WakeTerm>,
    /// The layer on a rigid base that it is, of line contacts alone; otherwise a half-space.
    pub layer: Option<BondedLayer>,
}

impl SlidingSubstrate {
    /// An elastic half-space of modulus E0.
    #[must_use]
    pub fn elastic() -> Self {
        Self { instantaneous: 1.0, terms: Vec::new(), layer: None }
    }

    /// One retardation time: `contrast` is E∞/E0, `length` is v τ.
    #[must_use]
    pub fn single(contrast: f64, length: f64) -> Self {
        let instantaneous = 1.0 / contrast;
        let terms = vec![WakeTerm { compliance: 1.0 - instantaneous, length }];
        Self { instantaneous, terms, layer: None }
    }

    /// The same material as a layer.
    #[must_use]
    pub fn as_layer(self, layer: BondedLayer) -> Self {
        Self { layer: Some(layer), ..self }
    }

    /// Whether a wake is about as long as a cell, from a third to one and a half: shorter ones are a lag, longer ones are resolved.
    #[must_use]
    pub fn has_wake_of(&self, cell: f64) -> bool {
        self.terms.iter().any(|term| (1.0 / 3.0..=1.5).contains(&(term.length / cell)))
    }

    /// E0/E∞ + Σ C_k E0, the compliance when all has crept: 1 for a substrate measured by its own E0.
    #[must_use]
    pub fn relaxed(&self) -> f64 {
        self.instantaneous + self.terms.iter().map(|term| term.compliance).sum::<f64>()
    }

    /// J(q) = E0/E∞ + Σ C_k E0/(1 − i q ℓ_k): a pressure e^{iqx} that slides to +x moves the surface by 2 J(q)/|q| e^{iqx}, times
    /// [`f(qh)`](BondedLayer::transfer) of a layer.
    ///
    /// This is eq. (30) of the oscillator paper at ω = −q v; its imaginary part dissipates.
    #[must_use]
    pub fn compliance(&self, wave_number: f64) -> Complex64 {
        self.terms.iter().fold(Complex64::new(self.instantaneous, 0.0), |sum, term| {
            sum + term.compliance / Complex64::new(1.0, -wave_number * term.length)
        })
    }

    /// f(q h) of a layer, 1 of a half-space: what it yields to a wave over what a half-space does.
    #[must_use]
    pub fn transfer(&self, wave_number: f64) -> f64 {
        self.layer.as_ref().map_or(1.0, |layer| layer.transfer(wave_number))
    }

    /// The same substrate with its lengths in cells of side `cell`, ascending and distinct.
    ///
    /// Equal lengths are merged; a wake shorter than any cell resolves belongs to the instantaneous answer, and one that
    /// is not over before the indenter is out of sight adds nothing. Lengths are rounded to 44 bits (6e-14), so that
    /// computations that arrive at the same ratio ℓ/h by different roundings share one kernel.
    #[must_use]
    pub fn in_cells(&self, cell: f64) -> Self {
        let mut scaled = Self {
            instantaneous: self.instantaneous,
            terms: Vec::with_capacity(self.terms.len()),
            layer: self.layer.as_ref().map(|layer| layer.in_units(cell)),
        };
        let mut terms = self.terms.clone();
        sort_by_number(&mut terms, |own| own.length);
        for term in terms {
            let length = rounded(term.length / cell);
            match scaled.terms.last_mut() {
                _ if length < SHORTEST => scaled.instantaneous += term.compliance,
                _ if length > LONGEST => {}
                Some(last) if last.length == length => last.compliance += term.compliance,
                _ => scaled.terms.push(WakeTerm { compliance: term.compliance, length }),
            }
        }
        scaled
    }

    /// Where displacements are compared with heights, upstream of the cells' centres, in cells: φ/π with φ the loss
    /// angle at the shortest wave of the grid, q = π/h.
    ///
    /// A sum over cells of side h knows the waves +π/h and −π/h as one, so it keeps only the real part of what the
    /// operator does to them. At the centres that is Re J, next to nothing where the substrate is mostly viscous: the
    /// pressure would alternate from cell to cell. Turned by the loss angle it is |J|. The shift vanishes with h in
    /// smooth contacts, and for v τ ≪ h it is the lag of the elastic answer, so friction is exact there.
    #[must_use]
    pub fn collocation_shift(&self, cell: f64) -> f64 {
        self.compliance(PI / cell).argument() / PI
    }
}
