//! The signals of a march: what is recorded, and what it is called in the study.

use crate::sliding::case::observe::{ObservedPoint, PointQuantity, Signal};
use crate::sliding::system::ReducedPair;
use judder_numerics::contact_state::ContactState;
use judder_sliding::recorder::Channel;
use judder_store::Variable;

/// The channel of a signal.
pub(super) fn channel(signal: Signal) -> Channel {
    match signal {
        Signal::Point { point, axis, quantity } => {
            let observed = ReducedPair::observed(point, axis);
            match quantity {
                PointQuantity::Acceleration => Channel::Acceleration(observed),
                PointQuantity::Velocity => Channel::Velocity(observed),
                PointQuantity::Displacement => Channel::Displacement(observed),
            }
        }
        Signal::NormalForce => Channel::NormalForce,
        Signal::TangentialForce => Channel::TangentialForce,
        Signal::SlidingVelocity => Channel::SlidingVelocity,
    }
}

/// The name of a signal among the arrays.
pub(crate) fn variable_name(signal: Signal, points: &[ObservedPoint]) -> String {
    match signal {
        Signal::Point { .. } => signal.name(points),
        _ => signal.name(points).replace('-', "_"),
    }
}

/// What a signal is, in words and as an axis is labelled.
fn words(signal: Signal, points: &[ObservedPoint]) -> (String, String) {
    let unit = unit(signal);
    match signal {
        Signal::Point { point, axis, quantity } => {
            let name = points.get(point).map_or("", |point| point.name.as_str());
            let (what, symbol) = match quantity {
                PointQuantity::Acceleration => ("acceleration", "ü"),
                PointQuantity::Velocity => ("velocity", "u̇"),
                PointQuantity::Displacement => ("displacement", "u"),
            };
            let (first, rest) = what.split_at(1);
            let axis = axis.name();
            let label = format!("{}{rest} of {name}, ${symbol}_{{{axis}}}$ ({unit})", first.to_uppercase());
            (format!("{what} of {name} along {axis}"), label)
        }
        Signal::NormalForce => ("normal force N".to_owned(), format!("Normal force $N$ ({unit})")),
        Signal::TangentialForce => {
            let words = "tangential force on the slider T".to_owned();
            (words, format!("Tangential force $T$ ({unit})"))
        }
        Signal::SlidingVelocity => {
            let words = "velocity of the contact point along the track".to_owned();
            (words, format!("Sliding velocity $v$ ({unit})"))
        }
    }
}

/// Its unit symbol.
pub(super) fn unit(signal: Signal) -> &'static str {
    match signal {
        Signal::Point { quantity: PointQuantity::Acceleration, .. } => "m/s^2",
        Signal::Point { quantity: PointQuantity::Velocity, .. } | Signal::SlidingVelocity => "m/s",
        Signal::Point { quantity: PointQuantity::Displacement, .. } => "m",
        Signal::NormalForce | Signal::TangentialForce => "N",
    }
}

/// The arrays that grow: time, position of C, then the signals in their order, then the states at times of their own.
pub(super) fn growing(signals: &[Signal], points: &[ObservedPoint]) -> Vec<Variable> {
    let grows = |name: &str| Variable::new(name, &["time"], &[0], Vec::<f64>::new());
    let mut variables = vec![
        grows("time").units("s").long_name("time since the start").attribute("label", "Time $t$ (s)"),
        grows("position")
            .units("m")
            .long_name("distance of the contact point from the first node of the track, without deformation")
            .attribute("label", "Position $s$ (m)")
            .as_coordinate(),
    ];
    variables.extend(signals.iter().map(|signal| {
        let (long_name, label) = words(*signal, points);
        let label = label.replace("^2", "^{2}");
        grows(&variable_name(*signal, points))
            .units(unit(*signal))
            .long_name(&long_name)
            .attribute("label", label)
    }));
    let (over, codes) = (["state_time"], &ContactState::CODES);
    variables.push(
        Variable::coordinate("state_time", Vec::<f64>::new()).units("s").long_name("time of the states"),
    );
    let states = Variable::classes("state", &over, &[0], Vec::new(), codes);
    variables.push(states.long_name("what the contact does"));
    variables
}
