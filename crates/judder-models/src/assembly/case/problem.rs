//! What can be wrong with an assembly case, beyond types, units and ranges.

use judder_keys::problem::Problem;
use judder_numerics::words::plain;
use std::fmt;
use thiserror::Error;

/// A set of nodes and the box around it.
#[derive(Debug, Clone, PartialEq)]
pub struct PlacedSet {
    /// The set in words.
    pub words: String,
    /// The corners of its box, in m.
    pub bounds: [[f64; 3]; 2],
}

impl fmt::Display for PlacedSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [from, to] = self.bounds.map(|corner| corner.map(plain).join(", "));
        write!(f, "between ({from}) and ({to}) m")
    }
}

/// What is wrong, with what a caller needs in order to act.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum AssemblyProblem {
    /// Two items of one name.
    #[error("two {what}s are called `{name}`")]
    NameTwice {
        /// What they are.
        what: &'static str,
        /// The name.
        name: String,
    },
    /// A structure that slides on itself.
    #[error("`{name}` cannot slide on itself")]
    SameStructure {
        /// The structure.
        name: String,
    },
    /// A vector of zeros where a direction is wanted.
    #[error("`{key}` has no direction: all its numbers are zero")]
    NoDirection {
        /// The key.
        key: String,
    },
    /// A load whose direction lacks, or is one too many.
    #[error("a load of `{kind}` {what}")]
    LoadDirection {
        /// Which load.
        kind: &'static str,
        /// What is wrong.
        what: &'static str,
    },
    /// An imposed displacement of nodes that no support holds.
    #[error(
        "`{set}` of `{structure}` is not held along {direction}: only what a support fixes can be displaced"
    )]
    NotFixed {
        /// The structure.
        structure: String,
        /// The set.
        set: String,
        /// The direction.
        direction: String,
    },
    /// Nodes of two interfaces, or of both sides of one.
    #[error(
        "the contacts `{first}` and `{second}` share node {node} of `{structure}`: contact interfaces must not share nodes"
    )]
    SharedNode {
        /// A contact.
        first: String,
        /// Another.
        second: String,
        /// The structure.
        structure: String,
        /// The node.
        node: usize,
    },
    /// Sets that do not face each other.
    #[error(
        "no node of `{}` lies opposite `{}` within {} m: their nearest nodes are {} m apart, `{}` lies {slider}, `{}` {track}",
        .slider.words, .track.words, plain(*.reach), plain(*.nearest), .slider.words, .track.words
    )]
    Apart {
        /// The set of the slider.
        slider: PlacedSet,
        /// The set of the track.
        track: PlacedSet,
        /// How far was searched, in m.
        reach: f64,
        /// The least distance between nodes of both, in m.
        nearest: f64,
    },
    /// A track without faces and without a normal.
    #[error("`{node}` has no faces that something could slide on")]
    NoFaces {
        /// The node.
        node: String,
    },
    /// A normal of a track that is a surface.
    #[error("a plane moves with one node, but `{set}` has {found}")]
    CarriedBySet {
        /// The set.
        set: String,
        /// How many nodes it has.
        found: usize,
    },
    /// A spring of neither stiffness nor damping.
    #[error("a spring of neither stiffness nor damping does nothing")]
    IdleSpring,
    /// A spring to the ground without a direction.
    #[error("a spring to the ground has no second place that would give its direction")]
    GroundWithoutDirection,
    /// A spring whose ends lie at one place.
    #[error("both ends of the spring lie at one place: there is no line along which it would act")]
    NoLength,
    /// A spring neither end of which can move.
    #[error("neither end of the spring can move along it: supports hold both")]
    HeldSpring,
    /// A structure that is tied to itself.
    #[error("`{name}` cannot be tied to itself")]
    TiedToItself {
        /// The structure.
        name: String,
    },
    /// Tied nodes that a load displaces.
    #[error("a load displaces nodes of `{set}`, which are tied")]
    DisplacedTie {
        /// The set.
        set: String,
    },
    /// A tie that holds what others hold already.
    #[error("the tie `{name}` holds a displacement that ties or supports hold already")]
    RedundantTie {
        /// The tie.
        name: String,
    },
    /// Steady sliding of bodies that touch nowhere.
    #[error("nothing touches: the case has no `[[contact]]`, so nothing slides")]
    NothingTouches,
    /// Steady sliding on a track that does not move.
    #[error(
        "the track of `{contact}` is at rest: friction there may be anything that it can hold, so that nothing slides steadily"
    )]
    AtRest {
        /// The contact.
        contact: String,
    },
    /// A sphere without a substrate.
    #[error("`{key}` is a sphere on the substrate of the case, but the case has no `[substrate]`")]
    NoSubstrate {
        /// The key of the sphere.
        key: String,
    },
    /// A substrate without a sphere.
    #[error("no contact has a sphere that would slide on the `[substrate]`")]
    NoSphere,
    /// A sphere whose contact has several nodes.
    #[error(
        "`{set}` has {nodes} nodes, but the sphere of `{contact}` touches at one: its law is that of the whole contact"
    )]
    SeveralPoints {
        /// The contact.
        contact: String,
        /// The set of the slider.
        set: String,
        /// How many nodes it has.
        nodes: usize,
    },
    /// A sphere that neither a load of its own nor one of the case presses.
    #[error("nothing presses the sphere of `{contact}`: the case has no loads, and it no `normal_load`")]
    NothingPresses {
        /// The contact.
        contact: String,
    },
    /// A load of a sphere that is not the one with which the loads of the case press it.
    #[error(
        "the sphere of `{contact}` has a `normal_load` of {given:.6e} N, but the loads of the case press it with {pressing:.6e} N"
    )]
    OtherLoad {
        /// The contact.
        contact: String,
        /// As it was given, N.
        given: f64,
        /// What the loads of the case press with, N.
        pressing: f64,
    },
    /// Interface modes at a rigid contact.
    #[error(
        "`{structure}` touches at the rigid contact `{contact}`, which holds each of its points: a few interface modes cannot follow them all"
    )]
    RigidInterfaceModes {
        /// The structure.
        structure: String,
        /// The contact.
        contact: String,
    },
    /// Interface modes of a body without a contact.
    #[error("`{structure}` touches nowhere: it has no interface whose freedoms could be reduced")]
    NoInterface {
        /// The structure.
        structure: String,
    },
    /// What a part of the case is refused for.
    #[error("{reason}")]
    Refused {
        /// Why.
        reason: String,
    },
}

impl Problem for AssemblyProblem {
    fn kind(&self) -> &'static str {
        "Assembly"
    }

    fn label(&self) -> &'static str {
        match self {
            Self::NameTwice { .. } => "given twice",
            Self::SameStructure { .. } => "the same structure",
            Self::NoDirection { .. } => "no direction",
            Self::LoadDirection { .. } => "this load",
            Self::NotFixed { .. } => "not held",
            Self::SharedNode { .. } => "shares a node",
            Self::Apart { .. } => "nothing opposite",
            Self::NoFaces { .. } => "no faces",
            Self::CarriedBySet { .. } => "of a surface",
            Self::IdleSpring | Self::GroundWithoutDirection | Self::NoLength | Self::HeldSpring => {
                "this spring"
            }
            Self::TiedToItself { .. } => "the same structure",
            Self::DisplacedTie { .. } | Self::RedundantTie { .. } => "this tie",
            Self::NothingTouches => "of this case",
            Self::AtRest { .. } => "of steady sliding",
            Self::NoSubstrate { .. } => "a sphere without a substrate",
            Self::NoSphere => "a substrate without a sphere",
            Self::SeveralPoints { .. } => "more than one node",
            Self::NothingPresses { .. } => "nothing presses",
            Self::OtherLoad { .. } => "another load",
            Self::RigidInterfaceModes { .. } => "of a rigid contact",
            Self::NoInterface { .. } => "no interface",
            Self::Refused { .. } => "here",
        }
    }

    fn help(&self) -> Option<String> {
        let help = match self {
            Self::NameTwice { what, .. } => return Some(format!("give each {what} a `name` of its own")),
            Self::SameStructure { .. } => {
                "let one structure slide on another, or on track = { plane = { normal = [0, 1] } }"
            }
            Self::NoDirection { .. } => "give a vector such as [0, 1] in the plane, [0, 0, 1] in space",
            Self::LoadDirection { .. } => {
                "forces and displacements have a direction = \"x\", \"y\" or \"z\"; a pressure acts against the surface"
            }
            Self::NotFixed { .. } => {
                "fix the direction in a support of the same set: supports = [{ set = \"…\", fixed = [\"y\"] }]"
            }
            Self::SharedNode { .. } => "take the node out of one of the sets",
            Self::Apart { reach, nearest, .. } if nearest <= reach => {
                "name surfaces that look at each other: the faces of these look another way, or lie beside each other"
            }
            Self::Apart { .. } => {
                "name the surfaces that face each other, or bring a block or beam there by its `origin`; a mesh in millimetres takes unit = \"mm\""
            }
            Self::NoFaces { .. } => {
                "give the normal of a plane that moves with it: track = { structure = \"…\", set = \"…\", normal = [0, 1] }"
            }
            Self::CarriedBySet { .. } => {
                "leave `normal` out, the faces of a surface have their own; or name a set of one node"
            }
            Self::IdleSpring => "give stiffness = \"1e6 N/m\" or damping = \"10 N s/m\"",
            Self::GroundWithoutDirection | Self::NoLength => "give direction = [0, 1], or another vector",
            Self::HeldSpring => "let it act in another direction, or leave it out",
            Self::TiedToItself { .. } => "let one structure be tied to another",
            Self::DisplacedTie { .. } => "displace other nodes, or join the bodies by a spring",
            Self::RedundantTie { .. } => "leave nodes that are held twice out of one of the sets",
            Self::NothingTouches => {
                "give a table [[contact]], or ask for `eigen`, the complex modes of the bodies as they are"
            }
            Self::AtRest { .. } => {
                "give its `sliding` a velocity; or ask for `march` or `frequency-response`, motions that need no sliding"
            }
            Self::NoSubstrate { .. } => {
                "give the case its substrate: [substrate] with rubbery_modulus, glassy_modulus, retardation_time, as in an oscillator case"
            }
            Self::NoSphere => "give a contact asperity = { … }, or leave the substrate out",
            Self::SeveralPoints { .. } => {
                "name a set of one node, as `end-lower` of a beam is; a surface takes `normal` and `friction_coefficient`"
            }
            Self::NothingPresses { .. } => {
                "press with a [[load]], or give asperity a normal_load, the F_n of an oscillator case"
            }
            Self::OtherLoad { .. } => {
                "leave normal_load out: it follows from the loads; or leave the loads out, then it presses by itself"
            }
            Self::RigidInterfaceModes { .. } => {
                "give the contact a stiffness: normal = { stiffness = \"1e12 N/m^3\" }; or leave interface_modes out, then each freedom is kept"
            }
            Self::NoInterface { .. } => "leave interface_modes out",
            Self::Refused { .. } => return None,
        };
        Some(help.to_owned())
    }
}
