use crate::direction::Direction;
use crate::element::ElementKind;
use judder_memory::BeyondMemory;
use judder_numerics::words::{plain, plain_complex};
use thiserror::Error;

/// Why there is no structure.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum StructureError {
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
    /// A sum of a matrix that frequencies are sought between is not positive.
    #[error("{name} is {value}: it must be positive and finite", value = plain(*.value))]
    NotPositive {
        /// Which.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// An element is folded or flat.
    #[error(
        "element {element} ({kind}) is folded or flat: its Jacobian determinant is {determinant} at {place:?}; are its nodes in order?",
        determinant = plain(*.determinant),
    )]
    Folded {
        /// Its number from 0, in the order of the mesh.
        element: usize,
        /// Its shape.
        kind: ElementKind,
        /// Where, in its own coordinates.
        place: [f64; 3],
        /// The determinant there.
        determinant: f64,
    },
    /// A disc cannot be meshed.
    #[error("there is no disc: {what}")]
    NoDisc {
        /// Why.
        what: &'static str,
    },
    /// An element is so long and thin that its stiffness does not say how it bends.
    #[error(
        "element {element} ({kind}) is {ratio:.1e} times as long as it is thin: above {limit:.0e} rounding leaves nothing of its bending; are its lengths right?"
    )]
    Stretched {
        /// Its number from 0, in the order of the mesh.
        element: usize,
        /// Its shape.
        kind: ElementKind,
        /// Its longest over its shortest direction.
        ratio: f64,
        /// The largest that is taken.
        limit: f64,
    },
    /// A box cannot be chamfered so.
    #[error("there is no such chamfer: {what}")]
    NoChamfer {
        /// What it must do.
        what: &'static str,
    },
    /// A body that turns has elements of the plane.
    #[error("{kind}s cannot turn: gyroscopic and centrifugal terms are those of bricks and tetrahedra")]
    NoRotation {
        /// The shape.
        kind: ElementKind,
    },
    /// The centrifugal force of a body moves it as a whole.
    #[error(
        "the centrifugal force is not in balance: it moves the body away, by {} of the force; is its centre of mass on the axis, or is it held?",
        plain(*.share)
    )]
    Unbalanced {
        /// What no stress takes up, over the force.
        share: f64,
    },
    /// An element of the plane is given as a solid, or the other way round.
    #[error("{kind}s have {dimension} dimensions, their section has {section}")]
    WrongSection {
        /// The shape.
        kind: ElementKind,
        /// Of the shape.
        dimension: usize,
        /// Of the section.
        section: usize,
    },
    /// An element names a node that the mesh does not have.
    #[error("element {element} names node {node}, the mesh has {nodes} nodes (counted from 0)")]
    UnknownNode {
        /// Its number from 0, in the order of the mesh.
        element: usize,
        /// The node that it names.
        node: usize,
        /// How many there are.
        nodes: usize,
    },
    /// The list of an element's nodes is too short or too long.
    #[error("{found} node numbers do not make {kind}s of {nodes} nodes each")]
    BrokenConnectivity {
        /// The shape.
        kind: ElementKind,
        /// The nodes of one.
        nodes: usize,
        /// Node numbers in the list.
        found: usize,
    },
    /// A support names a displacement that the mesh does not have.
    #[error(
        "the mesh has no displacement {direction} of node {node}: it has {nodes} nodes (counted from 0) in {dimension} dimensions"
    )]
    UnknownFreedom {
        /// The node.
        node: usize,
        /// The direction.
        direction: Direction,
        /// Nodes of the mesh.
        nodes: usize,
        /// 2 or 3.
        dimension: usize,
    },
    /// A displacement is held and tied, or tied twice.
    #[error("the displacement {direction} of node {node} is held or tied by two supports that differ")]
    TwiceSupported {
        /// The node.
        node: usize,
        /// The direction.
        direction: Direction,
    },
    /// Elements name a material that is not given.
    #[error("no material `{name}`; there are {}", if known.is_empty() { "none".to_owned() } else { known.join(", ") })]
    UnknownMaterial {
        /// The name.
        name: String,
        /// The names that there are.
        known: Vec<String>,
    },
    /// The stiffness matrix has no Cholesky factor: something can move without force.
    #[error(
        "the structure can move without force: row {row} of its stiffness has no positive pivot; is it held?"
    )]
    NotHeld {
        /// The row in the order of elimination.
        row: usize,
    },
    /// A factorisation does not fit into memory.
    #[error("the factors of a matrix of {rows} rows do not fit into memory")]
    OutOfMemory {
        /// Of the matrix.
        rows: usize,
    },
    /// Factors and vectors would take more memory than there is for them.
    #[error("{beyond}; {}", beyond.remedy_or("mesh coarser, or ask for a narrower region"))]
    BeyondMemory {
        /// How much, and how much there is; errors that hold this one would be large with it.
        #[source]
        beyond: Box<BeyondMemory>,
    },
    /// Two matrices are not of one structure.
    #[error("a matrix of {} × {} and one of {} × {} do not belong to one structure: both must be square and of one size", first[0], first[1], second[0], second[1])]
    DifferentSizes {
        /// Rows and columns of the first.
        first: [usize; 2],
        /// Of the second.
        second: [usize; 2],
    },
    /// No Rayleigh damping without negative coefficients has these ratios.
    #[error(
        "no Rayleigh damping has the ratios {} at {} Hz and {} at {} Hz: the ratio at the second must lie between {} and {}",
        ratios[0], frequencies[0], ratios[1], frequencies[1],
        ratios[0] * frequencies[0] / frequencies[1], ratios[0] * frequencies[1] / frequencies[0]
    )]
    NoRayleighDamping {
        /// At the lower and the higher frequency.
        ratios: [f64; 2],
        /// In Hz.
        frequencies: [f64; 2],
    },
    /// A damping matrix that is no Rayleigh damping.
    #[error(
        "the damping matrix is not α M + β K: at best {departure} of its largest entry is left, and at most {tolerance} may be; \
         give such a matrix, or none",
        departure = plain(*.departure), tolerance = plain(*.tolerance),
    )]
    NotProportional {
        /// The largest entry that the nearest α M + β K leaves, as a share of the matrix's largest.
        departure: f64,
        /// What it may be.
        tolerance: f64,
    },
    /// Damping of single modes where one of all is needed.
    #[error("damping by ratios of modes is no α M + β K")]
    NotRayleigh,
    /// Damping of single modes of a body with too many freedoms for its matrix, which is full.
    #[error(
        "damping by ratios of modes is a full matrix, and the body has {freedoms} freedoms, more than {most}: give it α and β"
    )]
    TooLargeForRatios {
        /// Its freedoms.
        freedoms: usize,
        /// The most.
        most: usize,
    },
    /// More damping ratios than modes that swing.
    #[error("there are {ratios} damping ratios, but no more than {modes} modes that swing")]
    TooFewModes {
        /// How many ratios.
        ratios: usize,
        /// How many modes.
        modes: usize,
    },
    /// A damping matrix with a negative share of mass or stiffness.
    #[error(
        "the damping matrix is α M + β K with α = {alpha} 1/s and β = {beta} s: neither may be negative",
        alpha = plain(*.alpha), beta = plain(*.beta),
    )]
    NegativeDamping {
        /// 1/s.
        alpha: f64,
        /// s.
        beta: f64,
    },
    /// A matrix has no factors: a pivot is zero or not finite.
    #[error(
        "a matrix of {rows} rows is singular, or its numbers are not finite: is a shift an eigenvalue, or the structure not held?"
    )]
    Singular {
        /// Of the matrix.
        rows: usize,
    },
    /// A matrix has entries that the pattern of the factors does not have.
    #[error(
        "a matrix of {rows} rows does not have the pattern of factors for {expected} rows that it is to be factored with"
    )]
    WrongPattern {
        /// Of the matrix.
        rows: usize,
        /// Of the pattern.
        expected: usize,
    },
    /// Some motions have less than no kinetic energy.
    #[error(
        "the mass is indefinite, negative in {negative} of its {size} eigenvalues: undamped modes are those of a mass that is positive or zero in every motion; is a sign wrong?"
    )]
    IndefiniteMass {
        /// How many of its eigenvalues are negative.
        negative: usize,
        /// Of how many.
        size: usize,
    },
    /// Some motions grow without friction and damping, below the lowest mode that swings.
    #[error(
        "the stiffness is indefinite, negative in {negative} of its {size} eigenvalues: so many motions grow and do not swing, and modes from the lowest on would begin \
         with them; is a sign wrong? A band from a frequency above zero passes over them"
    )]
    IndefiniteStiffness {
        /// How many of its eigenvalues are negative.
        negative: usize,
        /// Of how many.
        size: usize,
    },
    /// Modes are missing that a count knows of.
    #[error("not all of {wanted} modes were found: the count of a factorisation knows of more")]
    MissingModes {
        /// How many were wanted.
        wanted: usize,
    },
    /// A freedom to be kept is named twice, or is not there.
    #[error("freedom {freedom} is to be kept twice, or is none of the {freedoms} freedoms (counted from 0)")]
    KeptTwice {
        /// Which.
        freedom: usize,
        /// How many there are.
        freedoms: usize,
    },
    /// A mode without stiffness would be cut off.
    #[error(
        "mode {mode} (counted from 0) of the modal form is rigid and would be cut off after {kept}: a rigid motion has no flexibility"
    )]
    CutRigid {
        /// Its number.
        mode: usize,
        /// How many would be kept.
        kept: usize,
    },
    /// The reduced mass is not positive definite, or an eigenvalue iteration did not end.
    #[error(
        "the reduced structure has no modal form: its mass is not positive definite, or its numbers are not finite"
    )]
    NoModalForm,
    /// Matrices of one problem differ in size, or one is not square.
    #[error("the {name} matrix is {} × {}: it must be {rows} × {rows}", found.0, found.1)]
    WrongShape {
        /// Which.
        name: String,
        /// Its rows and columns.
        found: (usize, usize),
        /// What both must be.
        rows: usize,
    },
    /// An entry of a matrix is not a number.
    #[error(
        "the {name} matrix has {value} in row {row}, column {column} (counted from 0): it must be finite"
    )]
    NotFinite {
        /// Which.
        name: String,
        /// From 0.
        row: usize,
        /// From 0.
        column: usize,
        /// The entry.
        value: f64,
    },
    /// A matrix that cannot be zero is.
    #[error("the {name} matrix has no entries but zeros: without it there are no modes")]
    EmptyMatrix {
        /// Which.
        name: String,
    },
    /// A range of the complex plane that is empty.
    #[error(
        "the region's range `{name}` goes from {from} to {to}: it must rise, between finite numbers",
        from = plain(*.from), to = plain(*.to),
    )]
    EmptyRegion {
        /// `re` or `im`.
        name: &'static str,
        /// Its start.
        from: f64,
        /// Its end.
        to: f64,
    },
    /// λ² M + λ C + K has no factors wherever it is tried.
    #[error(
        "λ²M + λC + K is singular at {value} and beside it: every number is an eigenvalue, or the matrices have an empty row or column",
        value = plain_complex(*.value),
    )]
    SingularEverywhere {
        /// The last place that was tried.
        value: faer::c64,
    },
    /// The eigenvalues of a small dense matrix were not found.
    #[error("the eigenvalue iteration of a projected problem of {rows} rows did not end")]
    NoDenseEigenvalues {
        /// Of the matrix.
        rows: usize,
    },
    /// A sum of matrices is given too many or too few factors.
    #[error("{found} factors for the {terms} matrices of the {name}: there must be one for each")]
    WrongFactors {
        /// Mass, damping or stiffness.
        name: &'static str,
        /// How many factors.
        found: usize,
        /// How many matrices.
        terms: usize,
    },
}

impl From<BeyondMemory> for StructureError {
    fn from(beyond: BeyondMemory) -> Self {
        Self::BeyondMemory { beyond: Box::new(beyond) }
    }
}
