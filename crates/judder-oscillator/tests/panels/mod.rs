//! The stability maps of Figs. 9 and 10, which tests and benchmarks share.

use judder_contact::{FittedLaw, Law};
use judder_oscillator::critical::{ParameterRange, RangeScale};
use judder_oscillator::map::{CoefficientPlane, SweptCoefficient};
use judder_oscillator::{Contact, FrictionLoad, Groups};

/// One panel with one reading of the friction load.
pub(crate) struct Panel {
    /// `"fig-9a"` and so on.
    pub(crate) figure: &'static str,
    pub(crate) contact: Contact,
    pub(crate) plane: CoefficientPlane,
}

impl Panel {
    /// `"normal-load"` or `"contact-force"`, as case files name it.
    pub(crate) fn load_name(&self) -> &'static str {
        match self.contact.friction_load {
            FrictionLoad::NormalLoad => "normal-load",
            FrictionLoad::ContactForce => "contact-force",
        }
    }
}

/// The paper's law as printed, with either reading of the friction load.
pub(crate) fn paper(friction_load: FrictionLoad) -> Contact {
    Contact { law: Law::Fitted(FittedLaw::oscillator_paper()), friction_load }
}

/// Values evenly spaced in the logarithm, both ends among them.
pub(crate) fn logarithmic(from: f64, to: f64, points: usize) -> Vec<f64> {
    let range = ParameterRange { from, to, scale: RangeScale::Logarithmic };
    (0..points).map(|k| range.value(k as f64 / (points - 1) as f64)).collect()
}

/// Figs. 9a, 9b (τ̃0 over v̂ at F̃_n = 1e-6, 1e-3) and 10a, 10b (F̃_n over v̂ at τ̃0 = 1e-2, 1e-1), `points` a side, for
/// both friction loads. The paper prints no end of the load axis; 1e-8 to 1e-1 holds all loads that it speaks of.
pub(crate) fn panels(points: usize) -> Vec<Panel> {
    let shear = || (SweptCoefficient::ShearStrength, logarithmic(1e-4, 1.0, points));
    let load = || (SweptCoefficient::NormalLoad, logarithmic(1e-8, 1e-1, points));
    let at_load = |normal_load| Groups { normal_load, ..Groups::default() };
    let at_shear = |shear_strength| Groups { shear_strength, ..Groups::default() };
    let mut all = Vec::new();
    for friction_load in [FrictionLoad::NormalLoad, FrictionLoad::ContactForce] {
        for (figure, groups, y) in [
            ("fig-9a", at_load(1e-6), shear()),
            ("fig-9b", at_load(1e-3), shear()),
            ("fig-10a", at_shear(1e-2), load()),
            ("fig-10b", at_shear(1e-1), load()),
        ] {
            let x = (SweptCoefficient::Velocity, logarithmic(1e-8, 1e2, points));
            let plane = CoefficientPlane { base: groups.resolve(), x, y };
            all.push(Panel { figure, contact: paper(friction_load), plane });
        }
    }
    all
}
