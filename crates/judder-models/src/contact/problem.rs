//! What can be wrong with a substrate, an indenter or a contact analysis, beyond types, units and ranges.

use thiserror::Error;

use judder_keys::memory::Memory;
use judder_keys::problem::Problem;
use judder_numerics::words::plain;

/// What is wrong, with what a caller needs in order to act.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ContactProblem {
    /// Times of a series that do not ascend.
    #[error("the times of `{key}` must ascend, but {time} s follows {before} s", time = plain(*.time), before = plain(*.before))]
    UnsortedTimes {
        /// The key of the list.
        key: &'static str,
        /// The earlier time, s.
        before: f64,
        /// The later entry, s.
        time: f64,
    },
    /// A grid that has no grid of half its cells beside it.
    #[error("`cells` must be a multiple of two from {from} to {to}, but is {found}")]
    Cells {
        /// The smallest.
        from: usize,
        /// The largest.
        to: usize,
        /// What was given.
        found: usize,
    },
    /// An analysis that does not know the shape.
    #[error("the analysis kind `{kind}` is for {shapes}, not for the shape `{shape}`")]
    Shape {
        /// The kind.
        kind: &'static str,
        /// The shapes that it knows.
        shapes: &'static str,
        /// The shape of the case.
        shape: &'static str,
    },
    /// The collapse on one variable of another shape than a paraboloid.
    #[error("the method `collapse` is exact for a paraboloid only, not for the shape `{shape}`")]
    Collapse {
        /// The shape of the case.
        shape: &'static str,
    },
    /// A key that a contact without end does not know: a line, a surface that repeats itself.
    #[error("`{key}` has no meaning for {what}")]
    Endless {
        /// The key.
        key: &'static str,
        /// The shape in words, with the reason.
        what: &'static str,
    },
    /// What only a cylinder has, of another shape.
    #[error("`{key}` is of a line contact, not of the shape `{shape}`")]
    LineKey {
        /// The key.
        key: &'static str,
        /// The shape of the case.
        shape: &'static str,
    },
    /// A force where that of a cylinder is one per length.
    #[error("the load of a cylinder is a force per length, N/m, and no force of {} N", plain(*force))]
    WholeLoad {
        /// The force, N.
        force: f64,
        /// The length of the cylinder, m, where it is given.
        length: Option<f64>,
    },
    /// A quantity of another kind where the load of a cylinder is a force per length.
    #[error("the load of a cylinder is a force per length, and `{text}` is none")]
    NotPerLength {
        /// The quantity as written.
        text: String,
    },
    /// A depth of a cylinder on a half-space, which has none.
    #[error(
        "{what} of a cylinder needs `substrate.thickness`: on a half-space its depth depends on how far away it is measured"
    )]
    NoThickness {
        /// What was asked for, in words.
        what: &'static str,
    },
    /// A depth that is that of the layer.
    #[error("the indentation is {indentation} R, and the layer is {thickness} R thick", indentation = plain(*.indentation), thickness = plain(*.thickness))]
    ThroughLayer {
        /// δ/R.
        indentation: f64,
        /// h/R.
        thickness: f64,
    },
    /// A contact that is far wider than its layer is thick.
    #[error("at an indentation of {} R the contact is far wider than the layer is thick, {} R", plain(*indentation), plain(*thickness))]
    WiderThanLayer {
        /// δ/R.
        indentation: f64,
        /// h/R.
        thickness: f64,
    },
    /// Wave lengths of a rough surface that do not descend.
    #[error(
        "the wave lengths of `indenter.shape.rough` must descend: {longer} {from} m, {shorter} {to} m",
        from = plain(*.from), to = plain(*.to),
    )]
    WaveLengths {
        /// The name of the one that must be longer.
        longer: &'static str,
        /// Its value, m.
        from: f64,
        /// The name of the one that must be shorter.
        shorter: &'static str,
        /// Its value, m.
        to: f64,
    },
    /// Samples of a spectrum that are zero throughout.
    #[error("the samples of `substrate.continuous` are zero throughout")]
    NoSpectrum,
    /// A grid that takes more memory than allowed.
    #[error("{columns} × {rows} cells take {needed} of memory, and the limit is {limit}")]
    Memory {
        /// Cells along x.
        columns: usize,
        /// Cells along y.
        rows: usize,
        /// What they take.
        needed: Memory,
        /// What is allowed.
        limit: Memory,
    },
    /// An indenter that ends before the depth asked for.
    #[error("the indentation is {indentation} R, and this indenter ends at {limit} R")]
    TooDeep {
        /// δ/R.
        indentation: f64,
        /// δ/R at which the indenter ends.
        limit: f64,
    },
    /// A load that presses the indenter in to where it has ended.
    #[error("this load presses the indenter in by {} R at least, and it ends at {limit} R", plain(*indentation))]
    LoadTooLarge {
        /// δ/R on the glassy substrate.
        indentation: f64,
        /// δ/R at which the indenter ends.
        limit: f64,
    },
    /// A contact that would go on beyond the heights of a file.
    #[error("the contact reaches the edge of the heights at x = {} R, y = {} R", plain(*x), plain(*y))]
    BeyondHeights {
        /// x/R of a cell in contact beside the edge.
        x: f64,
        /// y/R of the cell.
        y: f64,
    },
    /// A periodic substrate that has not forgotten a period when the next one comes.
    #[error(
        "at this speed the substrate still remembers {memory} of its deformation after one period, and {allowed} is \
         allowed at most",
        memory = plain(*.memory), allowed = plain(*.allowed),
    )]
    LongWake {
        /// The part of the deformation that is left.
        memory: f64,
        /// The part that may be.
        allowed: f64,
    },
    /// A motion that would be followed in too many steps.
    #[error("this takes {needed:.0} steps at least, and {allowed} are allowed")]
    TooManySteps {
        /// The steps that motion and frequencies need.
        needed: f64,
        /// The steps allowed.
        allowed: usize,
    },
    /// A computed square that the contact does not fit into.
    #[error("the contact touches the edge of the computed square, whose side is {} R", plain(*side))]
    DomainTooSmall {
        /// Its side over R.
        side: f64,
        /// The side over R that would hold the contact.
        needed: f64,
    },
    /// A swept key whose value another choice of the case decides.
    #[error("`{key}` cannot be swept: {by} decides it")]
    FixedKey {
        /// The key.
        key: String,
        /// What decides it.
        by: String,
    },
}

impl Problem for ContactProblem {
    fn kind(&self) -> &'static str {
        "Contact"
    }

    fn label(&self) -> &'static str {
        match self {
            Self::UnsortedTimes { .. } => "not ascending",
            Self::Cells { .. } => "out of range",
            Self::Shape { .. } | Self::Collapse { .. } | Self::Endless { .. } | Self::LineKey { .. } => {
                "another shape"
            }
            Self::WholeLoad { .. } | Self::NotPerLength { .. } => "not per length",
            Self::NoThickness { .. } => "of a half-space",
            Self::ThroughLayer { .. } => "too deep",
            Self::WiderThanLayer { .. } => "too wide",
            Self::WaveLengths { .. } => "these lengths",
            Self::FixedKey { .. } => "fixed",
            Self::NoSpectrum => "no spectrum",
            Self::Memory { .. } => "too much",
            Self::TooDeep { .. } => "too deep",
            Self::LoadTooLarge { .. } => "too large",
            Self::BeyondHeights { .. } => "beyond the heights",
            Self::LongWake { .. } => "too fast",
            Self::TooManySteps { .. } => "too long",
            Self::DomainTooSmall { .. } => "too small",
        }
    }

    fn help(&self) -> Option<String> {
        Some(self.advice())
    }
}

impl ContactProblem {
    /// What would be right.
    fn advice(&self) -> String {
        match self {
            Self::UnsortedTimes { .. } => "list the terms from the shortest time to the longest".to_owned(),
            Self::Cells { from, .. } => format!(
                "give an even number, {from} at least: the grid of half as many cells says how exact the answer is"
            ),
            Self::Shape { shapes, .. } => {
                format!("the analysis kind `contact` takes any shape; this one, {shapes}")
            }
            Self::Collapse { .. } => "leave `method` out, or use method = \"sweep\"".to_owned(),
            Self::Endless { .. } => "give `load`, and leave this key out".to_owned(),
            Self::LineKey { .. } => "leave it out, or set indenter.shape = \"cylinder\"".to_owned(),
            Self::WholeLoad { force, length: Some(length) } => {
                format!("over the length of this cylinder, {} m, it is load = \"{} N/m\"", plain(*length), plain(force.abs() / length))
            }
            Self::WholeLoad { force, length: None } => {
                format!("divide it by the length of the cylinder: over 100 mm it is load = \"{} N/m\"", plain(force.abs() / 0.1))
            }
            Self::NotPerLength { .. } => "write a quantity such as \"50 N/m\", or a plain number, F/(E0* R)".to_owned(),
            Self::NoThickness { .. } => {
                "give the thickness of the layer, which a rigid base holds; one `contact` may have a `load` instead".to_owned()
            }
            Self::ThroughLayer { .. } => {
                "give far less: a layer is linear while the indentation is a small part of its thickness".to_owned()
            }
            Self::WiderThanLayer { .. } => "press less, or take a thicker layer".to_owned(),
            Self::WaveLengths { .. } => "period ≥ roll_off > cut_off ≥ two cells".to_owned(),
            Self::NoSpectrum => "give a positive density at one time at least".to_owned(),
            Self::Memory { needed, .. } => {
                format!("take fewer cells, or set memory_limit = \"{}\"", needed.rounded_up())
            }
            Self::TooDeep { .. } | Self::LoadTooLarge { .. } => {
                "give far less: a half-space stands for the substrate only while contact and depth are small"
                    .to_owned()
            }
            Self::BeyondHeights { .. } => "press less, or give heights of a larger piece".to_owned(),
            Self::LongWake { .. } => "slide slower, or take a longer period".to_owned(),
            Self::TooManySteps { .. } => {
                "shorten `duration`, slide or oscillate slower, or take fewer `cells`".to_owned()
            }
            Self::DomainTooSmall { needed, .. } => {
                format!(
                    "give `domain` = {:.3e} at least, or leave it out: the square is then fitted to the contact",
                    1.01 * needed
                )
            }
            Self::FixedKey { .. } => {
                "sweep another key, or run the case once a value with `--set`".to_owned()
            }
        }
    }
}
