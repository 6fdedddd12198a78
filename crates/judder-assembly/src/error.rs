use judder_contact::friction::FrictionError;
use judder_numerics::words::plain;
use judder_structure::StructureError;
use judder_structure::element::ElementKind;
use thiserror::Error;

/// Why an assembly does not slide steadily, or its stability is not known.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum AssemblyError {
    /// A number is out of its range.
    #[error("{name} is {value}: it must be {requirement}", value = plain(*.value))]
    InvalidNumber {
        /// Which.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What it must be.
        requirement: &'static str,
    },
    /// Numbers that make no friction coefficient.
    #[error(transparent)]
    Friction(#[from] FrictionError),
    /// A list has another length than what it belongs to.
    #[error("{name}: there are {found}, but must be {expected}")]
    Length {
        /// Which.
        name: &'static str,
        /// How many there are.
        found: usize,
        /// How many there must be.
        expected: usize,
    },
    /// A contact point names a freedom that the assembly does not have.
    #[error("interface `{interface}` names freedom {freedom}, the assembly has {freedoms} (counted from 0)")]
    UnknownFreedom {
        /// The interface.
        interface: String,
        /// The freedom that it names.
        freedom: usize,
        /// How many there are.
        freedoms: usize,
    },
    /// An interface without contact points.
    #[error("interface `{interface}` has no contact point: no place of the slider lies opposite the track")]
    NoPoints {
        /// The interface.
        interface: String,
    },
    /// The track does not move along the contact.
    #[error(
        "interface `{interface}` does not slide at {}: the track's velocity of {} m/s has no part along the contact, whose normal is {}; \
         give `sliding` a velocity or, at rest, a direction along the contact, or a speed about an axis that the contact is not on",
        triple(.place), triple(.velocity), triple(.normal)
    )]
    NoSlip {
        /// The interface.
        interface: String,
        /// Where, in m.
        place: [f64; 3],
        /// V, in m/s.
        velocity: [f64; 3],
        /// n.
        normal: [f64; 3],
    },
    /// Friction on a track that does not move.
    #[error(
        "the track of `{interface}` is at rest: friction there may be anything that it can hold, so that nothing slides steadily"
    )]
    AtRest {
        /// The interface.
        interface: String,
    },
    /// A surface of elements with nodes between their corners.
    #[error(
        "a surface of {kind}s cannot be in contact node by node: a uniform pressure loads nodes between corners and corners unevenly, \
         of twenty-node bricks even the wrong way; mesh the body with four-node quadrilaterals or eight-node bricks"
    )]
    QuadraticFace {
        /// The elements.
        kind: ElementKind,
    },
    /// A plane whose normal has no direction.
    #[error("the normal of a plane is {}: it must have a direction", triple(.normal))]
    NoNormal {
        /// As it was given.
        normal: [f64; 3],
    },
    /// A plane whose normal does not point at the slider.
    #[error(
        "the plane's normal {} points the wrong way: out of the track, towards the slider, it looks against the slider's surface, whose own normal is {} in the mean; \
         a plane along that surface has the normal {}",
        triple(.normal), triple(.outward), triple(&back(.outward))
    )]
    WrongNormal {
        /// n, of length one.
        normal: [f64; 3],
        /// That of the slider's surface, out of the slider, of length one.
        outward: [f64; 3],
    },
    /// A contact point whose structures are both held along its normal.
    #[error(
        "interface `{interface}`: at {} neither the slider nor the track can move along the normal, so a rigid contact there has no force of its own; \
         leave the point out of the set, or its support off",
        triple(.place)
    )]
    HeldPoint {
        /// The interface.
        interface: String,
        /// Where, in m.
        place: [f64; 3],
    },
    /// A contact point without an area, to which a pressure would give a force.
    #[error(
        "interface `{interface}`: the contact at {} has no area: no face lies between the nodes of the set there, so a pressure has no force; \
         name a surface, or let the contact be rigid, or give it a stiffness of points in N/m, normal = {{ point_stiffness = \"1e6 N/m\" }}",
        triple(.place)
    )]
    NoArea {
        /// The interface.
        interface: String,
        /// Where, in m.
        place: [f64; 3],
    },
    /// More contact points than fit into memory.
    #[error(
        "{points} contact points are more than the {most} whose compliance is held in memory; name smaller sets, or coarser meshes"
    )]
    TooManyPoints {
        /// How many there are.
        points: usize,
        /// How many may be.
        most: usize,
    },
    /// Two closed points hold one displacement.
    #[error(
        "interface `{interface}`: the contact at {} holds a displacement that other closed contacts hold already; interfaces must not share nodes",
        triple(.place)
    )]
    RedundantPoint {
        /// The interface.
        interface: String,
        /// Where, in m.
        place: [f64; 3],
    },
    /// A tie holds a displacement that other ties hold already.
    #[error(
        "form {form} of the ties (counted from 0) holds a displacement that those before it hold already"
    )]
    RedundantTie {
        /// Which form.
        form: usize,
    },
    /// Neither supports nor contacts hold a motion of the bodies.
    #[error(
        "{motions} rigid motion{} {} held neither by supports nor by contacts; the first moves freedom {freedom} most",
        if *.motions == 1 { "" } else { "s" }, if *.motions == 1 { "is" } else { "are" }
    )]
    RigidMotion {
        /// How many motions.
        motions: usize,
        /// The freedom that moves most in the first.
        freedom: usize,
        /// Its shape on all freedoms.
        shape: Vec<f64>,
    },
    /// The stiffness pushes on what it should resist, and no part of a body turns, whose gyroscopic forces might hold it.
    #[error(
        "the stiffness of the bodies is not positive: it pushes on {motions} motion{} that it should resist; is a sign wrong?",
        if *.motions == 1 { "" } else { "s" }
    )]
    PushedOn {
        /// How many motions.
        motions: usize,
    },
    /// All contacts are open.
    #[error(
        "no contact point is closed in steady sliding, with friction or without: at the nearest, of `{interface}` at {} m with a gap of {} m \
         between the undeformed bodies and the normal {}, the loads {}",
        triple(.place), plain(*.gap), triple(.normal), pushed(*.opened, *.is_held)
    )]
    NothingCloses {
        /// The interface of the point that comes nearest.
        interface: String,
        /// Where it lies, in m.
        place: [f64; 3],
        /// g₀ in m.
        gap: f64,
        /// n, out of the track.
        normal: [f64; 3],
        /// By how much the loads open it, in m; where contacts alone hold the bodies, against springs in their place.
        opened: f64,
        /// Whether something else than contacts holds the bodies.
        is_held: bool,
    },
    /// The search for steady sliding has not ended.
    #[error(
        "steady sliding was not found, not even without friction: after {iterations} iterations {changing} of {points} contact points still open and close, the \
         equations are off by {} m, at that of `{interface}` at {} m",
        plain(*.residual), triple(.place)
    )]
    NoConvergence {
        /// How many iterations were done.
        iterations: usize,
        /// Points that change in the last.
        changing: usize,
        /// Of how many.
        points: usize,
        /// How far the equations of the closures are off, in m.
        residual: f64,
        /// The interface of a point that changes; where none does, of that whose equations are off most.
        interface: String,
        /// Where it lies, in m.
        place: [f64; 3],
    },
    /// Friction leaves no steady sliding.
    #[error(
        "there is no steady sliding with this much friction: as it grows from nothing, steady sliding ends at {} times the friction coefficients{}, \
         where the contact point of `{interface}` at {} m (point {point}, counted from 0) {}",
        plain(*.factor), of_coefficient(*.coefficient), triple(.place), ends(*.digs_in)
    )]
    NoSteadySliding {
        /// By what the friction coefficients are multiplied where steady sliding ends.
        factor: f64,
        /// The friction coefficient of the point there; `None` of one whose friction is not proportional to its normal force.
        coefficient: Option<f64>,
        /// The interface of the point where it ends.
        interface: String,
        /// The point, in the order of its interface.
        point: usize,
        /// Where it lies, in m.
        place: [f64; 3],
        /// Whether the closed points move there without a change of force, this one most; otherwise it opens or closes, and no state goes on from there.
        digs_in: bool,
    },
    /// The equations of steady sliding are singular.
    #[error(
        "steady sliding is not determined: with {closed} of {} contact points closed the bodies move without a change of their forces{}",
        .closed + .open, of_open(*.open)
    )]
    Undetermined {
        /// How many points are closed.
        closed: usize,
        /// How many the loads have lifted off.
        open: usize,
    },
    /// The dense eigenvalues of the contact's compliance were not found.
    #[error("the eigenvalues of the compliance of {points} contact points were not found")]
    NoEigenvalues {
        /// How many.
        points: usize,
    },
    /// What a structure does not do.
    #[error(transparent)]
    Structure(#[from] StructureError),
}

/// Refuses a list of another length than what it belongs to.
pub(crate) fn check_length(name: &'static str, found: usize, expected: usize) -> Result<(), AssemblyError> {
    if found == expected { Ok(()) } else { Err(AssemblyError::Length { name, found, expected }) }
}

fn triple(vector: &[f64; 3]) -> String {
    // zero without its sign
    let [x, y, z] = vector.map(|part| plain(part + 0.0));
    format!("({x}, {y}, {z})")
}

fn back(vector: &[f64; 3]) -> [f64; 3] {
    vector.map(|part| -part)
}

/// What of points that are open is told.
fn of_open(open: usize) -> &'static str {
    if open == 0 { "" } else { "; the loads lift the others off" }
}

fn of_coefficient(coefficient: Option<f64>) -> String {
    coefficient.map_or_else(String::new, |own| format!(", a coefficient of {}", plain(own)))
}

/// What loads do at an open point that they open by so much, in m.
fn pushed(opened: f64, is_held: bool) -> String {
    match (opened < 0.0, is_held) {
        (true, true) => format!("push the slider towards the track, but by {} m alone", plain(-opened)),
        (true, false) => "push the slider towards the track there, but pull the bodies apart where that point alone is closed, and nothing else holds them".to_owned(),
        (false, _) if opened == 0.0 => "do not push".to_owned(),
        (false, _) => "push the slider along that normal, off the track".to_owned(),
    }
}

/// How steady sliding ends at a point.
fn ends(digs_in: bool) -> &'static str {
    if digs_in {
        "digs in, pressed on by its friction as much as it is held: sprag-slip"
    } else {
        "opens or closes, and no state goes on from there"
    }
}
