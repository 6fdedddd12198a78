//! The figures of the gallery.

use judder_report::figure::{Class, ClassMap, ValueMap};
use judder_report::palette::ColourMap;
use judder_report::{Axis, Figure, Layer, Legend, Panel, Role};

/// One figure of every kind.
pub(crate) fn all() -> Vec<Figure> {
    vec![stability_map(), equivalent_damping(), eigenvalues(), thresholds(), growth_rates(), motion()]
}

/// `count` values from `from` to `to`, evenly in the logarithm.
fn logarithmic(from: f64, to: f64, count: usize) -> Vec<f64> {
    let (first, last) = (from.log10(), to.log10());
    (0..count).map(|i| 10_f64.powf(first + (last - first) * i as f64 / (count - 1) as f64)).collect()
}

fn linear(from: f64, to: f64, count: usize) -> Vec<f64> {
    (0..count).map(|i| from + (to - from) * i as f64 / (count - 1) as f64).collect()
}

fn bump(velocity: f64, centre: f64, width: f64) -> f64 {
    (-((velocity.log10() - centre) / width).powi(2)).exp()
}

fn conservative(velocity: f64) -> f64 {
    3e-2 * (1.0 + 8.0 * bump(velocity, -1.0, 1.5)) * (1.0 + velocity).powf(0.2)
}

fn decoupled(velocity: f64) -> f64 {
    let depth = bump(velocity, -2.5, 1.6);
    if depth < 0.02 { f64::NAN } else { 4e-3 / depth }
}

fn map_panel(load: f64) -> Panel {
    let velocity = logarithmic(1e-8, 1e2, 240);
    let strength = logarithmic(1e-4, 1.0, 200);
    let shift = load.powf(0.12);
    let code = |v: f64, s: f64| {
        let flutter = s > conservative(v) * shift;
        let falling = s > decoupled(v) / shift;
        let lifted = s > 0.6 * conservative(v) * shift && v > 1e-1 && v < 10.0;
        match (flutter, falling) {
            _ if v > 40.0 && s > 0.5 => 5,
            (true, true) => 3,
            (true, false) => 1,
            (false, true) => 2,
            (false, false) if lifted => 4,
            (false, false) => 0,
        }
    };
    let codes = strength.iter().flat_map(|s| velocity.iter().map(move |v| code(*v, *s))).collect();
    let classes = vec![
        Class::new("stable", Role::Stable),
        Class::new("flutter", Role::Flutter),
        Class::new("negative damping", Role::NegativeDamping),
        Class::new("both", Role::Both),
        Class::new("normal-force coupling", Role::NormalForceCoupling),
        Class::new("destabilised by damping", Role::DestabilisedByDamping),
        Class::new("unresolved", Role::Unresolved),
    ];
    let curve = |f: &dyn Fn(f64) -> f64| velocity.iter().map(|v| f(*v)).collect::<Vec<f64>>();
    let full = curve(&|v| (conservative(v) * shift).min((decoupled(v) / shift).min(1e9)));
    let layers = vec![
        Layer::Classes(ClassMap { x: velocity.clone(), y: strength, codes, classes }),
        Layer::line("full system", velocity.clone(), full, Role::FullBoundary),
        Layer::line(
            "conservative ($C = 0$)",
            velocity.clone(),
            curve(&|v| conservative(v) * shift),
            Role::ConservativeBoundary,
        ),
        Layer::line(
            "decoupled ($η = 0$)",
            velocity.clone(),
            curve(&|v| decoupled(v) / shift),
            Role::DecoupledBoundary,
        ),
    ];
    Panel::new(
        Axis::log("Substrate velocity $v̂_{d}$"),
        Axis::log("Shear strength $τ̃_{0}$").with_range(1e-4, 1.0),
        layers,
    )
    .with_title(format!("$F̃_{{n}}$ = {load} × 10^{{−6}}"))
}

fn stability_map() -> Figure {
    let panels = [7.5, 75.0, 750.0, 7500.0].map(map_panel).into();
    Figure::new("stability-map", "Stability maps of the full system", panels).with_caption(
        "Linear stability of the full system against the substrate velocity $v̂_{d}$ and the shear strength $τ̃_{0}$ \
         for four loads. Colours name the mechanism. Dashed: boundary of the conservative system; red: boundary \
         without coupling.",
    )
}

fn equivalent_damping() -> Figure {
    let velocity = logarithmic(1e-8, 1e2, 400);
    let strengths = [0.0, 0.01, 0.05, 0.1];
    let panel = |load: i32| {
        let curves = strengths.iter().enumerate().map(|(index, strength)| {
            let damping = velocity.iter().map(|v| {
                let rise = 40.0 * bump(*v, -3.0, 1.4) * 10_f64.powi(-load - 3);
                0.01 + rise * (1.0 - 30.0 * strength) - 3.0 * strength * bump(*v, -0.8, 0.8)
            });
            let label = format!("$τ̃_{{0}}$ = {strength}");
            Layer::line(label, velocity.clone(), damping.collect(), Role::Graded { index, count: 4 })
        });
        let layers = std::iter::once(Layer::horizontal_rule(0.0, "")).chain(curves).collect();
        Panel::new(
            Axis::log("Substrate velocity $v̂_{d}$"),
            Axis::symmetric_log("Equivalent damping $ξ_{eq}$", 1e-2),
            layers,
        )
        .with_title(format!("$F̃_{{n}}$ = 7.5 × 10^{{−{load}}}"))
        .with_legend(Legend::Below)
    };
    Figure::new("equivalent-damping", "Equivalent damping against velocity", [5, 4, 3, 2].map(panel).into())
        .with_caption("Equivalent damping $ξ_{eq}$ (eq. 23) for four loads. Below zero the friction force feeds the motion.")
}

fn eigenvalues() -> Figure {
    let strength = linear(0.0, 0.1, 301);
    let critical = 0.035;
    let split = |s: f64| (s - critical).abs().sqrt();
    let real = |sign: f64| -> Vec<f64> {
        strength.iter().map(|s| if *s > critical { sign * 0.8 * split(*s) } else { 0.0 } - 1e-3).collect()
    };
    let imaginary = |sign: f64| -> Vec<f64> {
        strength.iter().map(|s| 1.3 + if *s < critical { sign * 1.1 * split(*s) } else { 0.0 }).collect()
    };
    let measured: (Vec<f64>, Vec<f64>) = (vec![0.05, 0.065, 0.08], vec![0.096, 0.137, 0.169]);
    let axis = || Axis::linear("Shear strength $τ̃_{0}$");
    let label = "critical, $τ̃_{0,crit}$";
    let panels = vec![
        Panel::new(
            axis(),
            Axis::linear("Growth rate Re $λ$"),
            vec![
                Layer::vertical_rule(critical, label),
                Layer::line("mode 1", strength.clone(), real(1.0), Role::Mode(0)),
                Layer::line("mode 2", strength.clone(), real(-1.0), Role::Mode(1)),
                Layer::points("from a transient", measured.0, measured.1, Role::Mode(0)),
            ],
        ),
        Panel::new(
            axis(),
            Axis::linear("Frequency Im $λ$"),
            vec![
                Layer::vertical_rule(critical, label),
                Layer::line("mode 1", strength.clone(), imaginary(1.0), Role::Mode(0)),
                Layer::line("mode 2", strength.clone(), imaginary(-1.0), Role::Mode(1)),
            ],
        ),
    ];
    Figure::new("eigenvalues", "Eigenvalues against the shear strength", panels)
        .with_caption("Two modes meet at $τ̃_{0,crit}$ ≈ 3.5 × 10^{−2}; beyond it one of them grows.")
}

fn thresholds() -> Figure {
    let velocity = logarithmic(1e-8, 1e2, 300);
    let loads = [-8_i32, -7, -6, -5, -4];
    let curve = |load: i32, gap: f64| -> Vec<f64> {
        velocity
            .iter()
            .map(|v| {
                conservative(*v) * 10_f64.powf(0.33 * f64::from(load + 6)) * (1.0 - gap * bump(*v, -2.0, 1.0))
            })
            .collect()
    };
    let family = loads.iter().enumerate().flat_map(|(index, load)| {
        let role = Role::Graded { index, count: loads.len() };
        let label = format!("$F̃_{{n}}$ = 10^{{−{}}}", load.abs());
        [
            Layer::line(label, velocity.clone(), curve(*load, 0.6), role),
            Layer::line("", velocity.clone(), curve(*load, 0.0), role.dashed()),
        ]
    });
    let keys =
        [Layer::key("full", Role::Reference.solid()), Layer::key("conservative", Role::Reference.dashed())];
    let panel = Panel::new(
        Axis::log("Substrate velocity $v̂_{d}$"),
        Axis::log("Critical shear strength $τ̃_{0,crit}$"),
        family.chain(keys).collect(),
    );
    Figure::new("thresholds", "Critical shear strength against velocity", vec![panel])
        .with_caption("Above these curves the equilibrium is unstable.")
}

fn growth_rates() -> Figure {
    let x = logarithmic(1e-6, 1.0, 121);
    let y = linear(0.0, 0.1, 101);
    let z = y
        .iter()
        .flat_map(|s| {
            x.iter().map(move |v| {
                if *v > 0.3 && *s > 0.08 {
                    f64::NAN
                } else {
                    2e-3 * (s - 0.05) / 0.05 + 3e-3 * bump(*v, -2.5, 0.9) * s / 0.1
                }
            })
        })
        .collect();
    let map =
        ValueMap { x, y, z, bar: Axis::linear("Growth rate max Re $λ$"), colours: ColourMap::Diverging };
    let panel = Panel::new(
        Axis::log("Substrate velocity $v̂_{d}$"),
        Axis::linear("Shear strength $τ̃_{0}$"),
        vec![Layer::Values(map), Layer::note(1e-5, 0.02, "stable")],
    );
    Figure::new("growth-rates", "Growth rate over velocity and shear strength", vec![panel])
        .with_caption("White is marginal; hatched cells did not resolve.")
}

fn motion() -> Figure {
    let time = linear(0.0, 400.0, 4001);
    let amplitude = |t: f64| 1e-3 / (1.0 + (-(t - 150.0) / 20.0).exp());
    let position = time.iter().map(|t| 5e-4 + amplitude(*t) * (1.02 * t).sin()).collect();
    let panel = Panel::new(
        Axis::linear("Time $θ = ω_{nx} t$"),
        Axis::linear("Displacement $x̃$"),
        vec![Layer::line("", time, position, Role::Series(0))],
    );
    Figure::new("motion", "A transient into a limit cycle", vec![panel])
        .with_caption("Displacement after a small push.")
}
