//! The frequencies at which sliding excites its substrate, against those at which the moduli of the substrate were measured.
//!
//! A contact of half length a that slides at v excites ω = v/a, f = v/(2π a), as in [eq. (3)](judder_oscillator::quasi_steady); waves of length λ, f = v/λ.

use crate::material::Material;
use crate::oscillator::inputs::OscillatorInputs;
use crate::oscillator::steady_states::SteadyState;
use judder_oscillator::{Contact, quasi_steady};
use judder_study::text::short;
use std::f64::consts::TAU;

/// What lies outside by less is not told: v/a is a scale, good to a factor of two.
const BLURRED: f64 = 2.0;

/// The band of measured moduli at the temperature of a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MeasuredBand {
    /// Lowest and highest ω, rad/s.
    band: [f64; 2],
    /// τ of the groups, s.
    time: f64,
}

impl MeasuredBand {
    /// That of a material; `None` of one that was not measured, or has no time.
    pub(crate) fn of(material: &Material) -> Option<Self> {
        let (data, _) = material.fit.as_ref()?;
        let (from, to) = data.band();
        // times are a_T as long, so frequencies are lower by as much
        let band = [from, to].map(|frequency| frequency / material.time_factor);
        Some(Self { band, time: material.mean_time()? })
    }

    /// That some of what is excited, ω τ, was not measured, in words with the decades; `None` where all was.
    pub(crate) fn warning(&self, excited: impl IntoIterator<Item = f64>) -> Option<String> {
        let is_told = |frequency: &f64| frequency.is_finite() && *frequency > 0.0;
        let (least, most) = excited
            .into_iter()
            .map(|group| group / self.time)
            .filter(is_told)
            .fold((f64::INFINITY, 0.0_f64), |(least, most), frequency| {
                (least.min(frequency), most.max(frequency))
            });
        let [from, to] = self.band;
        let below = (least < from / BLURRED).then(|| libm::log10(from / least));
        let above = (most > to * BLURRED).then(|| libm::log10(most / to));
        let outside: Vec<String> = [(below, "below"), (above, "above")]
            .into_iter()
            .filter_map(|(decades, side)| decades.map(|decades| format!("{decades:.1} decades {side}")))
            .collect();
        if outside.is_empty() {
            return None;
        }
        let hertz = |frequency: f64| short(frequency / TAU);
        let excited = if most / least < 1.01 {
            format!("at {} Hz", hertz(most))
        } else {
            format!("from {} to {} Hz", hertz(least), hertz(most))
        };
        Some(format!(
            "sliding excites the substrate {excited}, {} the measured moduli, which go from {} to {} Hz at the temperature of the case: there \
             the fitted series stands for no measurement",
            outside.join(" and "),
            hertz(from),
            hertz(to)
        ))
    }
}

/// ω τ at a state of steady sliding in a contact.
pub(crate) fn excited(contact: &Contact, state: &SteadyState) -> f64 {
    let half_length = contact.law.half_length(state.equilibrium.response.area.value);
    quasi_steady::excited(state.coefficients.velocity, half_length)
}

/// The same at an operating point; `None` where there is no steady sliding.
pub(crate) fn excited_at(contact: &Contact, inputs: &OscillatorInputs) -> Option<f64> {
    SteadyState::new(contact, inputs).ok().map(|state| excited(contact, &state))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_not_measured_is_told_with_its_decades() {
        // measured from 0.1 to 1000 Hz, τ = 0.01 s
        let band = MeasuredBand { band: [TAU * 0.1, TAU * 1e3], time: 1e-2 };
        let at = |hertz: f64| TAU * hertz * 1e-2;
        assert_eq!(band.warning([at(0.06), at(1.9e3)]), None);
        assert_eq!(band.warning([f64::NAN, 0.0]), None);
        let told = band.warning([at(1e-3), at(1.0), at(1e5)]).unwrap();
        for part in ["from 0.001 to 1e5 Hz", "2.0 decades below and 2.0 decades above", "from 0.1 to 1000 Hz"]
        {
            assert!(told.contains(part), "{part}: {told}");
        }
        let told = band.warning([at(5e3)]).unwrap();
        assert!(told.contains("at 5000 Hz, 0.7 decades above") && !told.contains("below"), "{told}");
    }
}
