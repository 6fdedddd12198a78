//! The report page as data: sections of blocks, written as one self-contained HTML file by [`html`].
//!
//! Texts take the small markup of labels (`_{…}`, `^{…}`, `$…$`); everything else in them is escaped.

mod template;

pub use template::html;

use crate::figure::Figure;

/// A page.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Page {
    /// What the page is about.
    pub title: String,
    /// The paragraph under the title: what was done and what came out.
    pub lead: String,
    /// Small print under the lead, each a name and a value: version, case hash, wall time.
    pub facts: Vec<(String, String)>,
    /// The sections, which also make the table of contents.
    pub sections: Vec<PageSection>,
}

/// A section of a page.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PageSection {
    /// Its heading.
    pub title: String,
    /// What it holds, from top to bottom.
    pub blocks: Vec<PageBlock>,
}

impl Page {
    /// The figures that could not be drawn, from top to bottom.
    #[must_use]
    pub fn undrawn(&self) -> Vec<UndrawnFigure> {
        let blocks = self.sections.iter().flat_map(|section| &section.blocks);
        let undrawn = blocks.filter_map(|block| match block {
            PageBlock::Undrawn(undrawn) => Some(undrawn.clone()),
            _ => None,
        });
        undrawn.collect()
    }
}

/// A figure that could not be drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UndrawnFigure {
    /// Its name.
    pub name: String,
    /// Why.
    pub reason: String,
}

impl PageSection {
    /// A section of these blocks.
    pub fn new(title: impl Into<String>, blocks: Vec<PageBlock>) -> Self {
        Self { title: title.into(), blocks }
    }
}

/// A piece of a section.
#[derive(Debug, Clone, PartialEq)]
pub enum PageBlock {
    /// A heading below that of the section.
    Heading(String),
    /// A paragraph.
    Text(String),
    /// An interactive figure with its caption, numbered through the page, and links to `figures/<name>.svg` and `.png`.
    Figure(Box<Figure>),
    /// In the place of a figure that could not be drawn.
    Undrawn(UndrawnFigure),
    /// A table.
    Table(PageTable),
    /// What a paper says against what we find.
    Scoreboard(Scoreboard),
    /// Numbers that were doubted by other numbers.
    Checks(Vec<Check>),
    /// What the reader has to know before trusting the results; an empty list says that there is nothing.
    Warnings(Vec<String>),
    /// Text as it is in a file, without markup.
    Code(Code),
    /// Blocks that are shown on demand.
    Details(Details),
}

impl PageBlock {
    /// A paragraph.
    pub fn text(text: impl Into<String>) -> Self {
        Self::Text(text.into())
    }

    /// An interactive figure.
    pub fn figure(figure: Figure) -> Self {
        Self::Figure(Box::new(figure))
    }
}

/// A table; cells that are numbers are set flush right.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PageTable {
    /// What the table shows.
    pub caption: String,
    /// Column heads.
    pub head: Vec<String>,
    /// Rows of cells; a row may be shorter than the head.
    pub rows: Vec<Vec<String>>,
}

/// Claims of a paper beside our numbers.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Scoreboard {
    /// Heads of our columns, e.g. the two readings of the friction law.
    pub ours: Vec<String>,
    /// How many of these, from the first, the verdicts are about; the others are shown on demand.
    pub judged: usize,
    /// The claims.
    pub rows: Vec<Claim>,
}

/// A claim of a paper and what we find.
#[derive(Debug, Clone, PartialEq)]
pub struct Claim {
    /// Where it stands in the paper.
    pub place: String,
    /// What the paper says: a number or a short quotation.
    pub says: String,
    /// What we find, a cell for each of our columns.
    pub ours: Vec<String>,
    /// The outcome.
    pub verdict: ClaimVerdict,
    /// Why, in one line.
    pub why: String,
}

/// What becomes of a claim.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ClaimVerdict {
    /// Our number is the paper's.
    Agrees,
    /// The paper misprints it, and the right value is known.
    Misprint,
    /// Neither.
    Open,
}

impl ClaimVerdict {
    /// The word on the badge.
    pub fn word(self) -> &'static str {
        match self {
            Self::Agrees => "agrees",
            Self::Misprint => "misprint",
            Self::Open => "open",
        }
    }
}

/// A result compared with an independent one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Check {
    /// What is checked.
    pub name: String,
    /// What was compared with what, and how often.
    pub compared: String,
    /// The figure that came out.
    pub figure: String,
    /// What it may be at most (or at least), in words or signs.
    pub limit: String,
    /// Whether it is within the limit.
    pub passed: bool,
}

/// The text of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Code {
    /// What the text is, e.g. its file name.
    pub caption: String,
    /// The text.
    pub text: String,
}

/// Blocks behind a line that opens them.
#[derive(Debug, Clone, PartialEq)]
pub struct Details {
    /// The line.
    pub summary: String,
    /// What it opens.
    pub blocks: Vec<PageBlock>,
}
