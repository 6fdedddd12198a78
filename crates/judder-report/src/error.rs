//! What can be wrong with a figure or a page.

/// Why a figure or a page cannot be drawn. Panels and layers are counted from 0.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ReportError {
    /// The name cannot be a file stem.
    #[error(
        "figure name {name:?} cannot be a file stem: use letters, digits, '-', '_' and '.', not starting with '.'"
    )]
    FigureName {
        /// The name that was given.
        name: String,
    },
    /// Two figures of a page would be the same file.
    #[error("two figures of the page are named {name:?}: give each its own name")]
    SameName {
        /// The name that was given twice.
        name: String,
    },
    /// A figure has no columns to lay panels in.
    #[error("figure {figure:?} has {columns} columns: at least 1 is needed")]
    Columns {
        /// The figure.
        figure: String,
        /// What was given.
        columns: usize,
    },
    /// Something is wrong inside a panel.
    #[error("figure {figure:?}, panel {panel}: {source}")]
    Panel {
        /// The figure.
        figure: String,
        /// The panel.
        panel: usize,
        /// What is wrong.
        source: PanelError,
    },
    /// The picture would have no or too many pixels.
    #[error(
        "a picture of {width} x {height} pixels cannot be made: choose the scale so that both lie in 1..=16384"
    )]
    PictureSize {
        /// Pixels across.
        width: f64,
        /// Pixels down.
        height: f64,
    },
    /// The drawing could not be turned into pixels.
    #[error("figure {figure:?} could not be turned into pixels: {reason}")]
    Raster {
        /// The figure.
        figure: String,
        /// What the renderer said.
        reason: String,
    },
    /// The figure could not be written for the interactive chart.
    #[error("figure {figure:?} could not be written as JSON: {reason}")]
    Json {
        /// The figure.
        figure: String,
        /// What the writer said.
        reason: String,
    },
    /// The page could not be written.
    #[error("the page {title:?} could not be written: {reason}")]
    Page {
        /// Title of the page.
        title: String,
        /// What the template said.
        reason: String,
    },
}

/// What is wrong inside a panel.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PanelError {
    /// The range of an axis cannot be drawn.
    #[error(
        "the range {from} .. {to} of the {axis} axis cannot be drawn: it must be finite and ascending, and positive on a log axis"
    )]
    Range {
        /// `"x"`, `"y"` or `"colour"`.
        axis: &'static str,
        /// First value.
        from: f64,
        /// Last value.
        to: f64,
    },
    /// The linear part of a symmetric log axis is not a positive number.
    #[error("the linear part {linear} of the {axis} axis must be positive and finite")]
    LinearPart {
        /// `"x"`, `"y"` or `"colour"`.
        axis: &'static str,
        /// What was given.
        linear: f64,
    },
    /// Abscissae and values of a second axis do not pair up.
    #[error("the second axis has {x} abscissae but {values} values: give as many of both")]
    SecondLengths {
        /// Number of abscissae.
        x: usize,
        /// Number of values.
        values: usize,
    },
    /// A second axis that turns back, or has something that is no number.
    #[error(
        "the second axis is out of order: its abscissae must ascend, its values rise or fall throughout, all finite"
    )]
    SecondOrder,
    /// Abscissae and ordinates do not pair up.
    #[error("layer {layer}: {x} abscissae but {y} ordinates: give as many of both")]
    Lengths {
        /// The layer.
        layer: usize,
        /// Number of abscissae.
        x: usize,
        /// Number of ordinates.
        y: usize,
    },
    /// A marker of a size that cannot be drawn.
    #[error("layer {layer}: the size of marker {index} is {value}: give a finite number, zero or more")]
    Size {
        /// The layer.
        layer: usize,
        /// The marker, from 0.
        index: usize,
        /// Its size.
        value: f64,
    },
    /// A line swings over an axis that is not even.
    #[error("layer {layer} swings, but an axis is logarithmic: swinging lines need linear axes")]
    SwingScale {
        /// The layer.
        layer: usize,
    },
    /// A map has another number of cells than its coordinates say.
    #[error("layer {layer}: {cells} cells for {columns} columns and {rows} rows: {} are needed", .columns * .rows)]
    Cells {
        /// The layer.
        layer: usize,
        /// Number of cells.
        cells: usize,
        /// Number of abscissae.
        columns: usize,
        /// Number of ordinates.
        rows: usize,
    },
    /// The coordinates of a map are not strictly ascending, or have no place on their axis.
    #[error(
        "layer {layer}: coordinate {index} along {axis} is {value}: coordinates must be finite and strictly ascending, and positive on a log axis"
    )]
    Coordinate {
        /// The layer.
        layer: usize,
        /// `"x"` or `"y"`.
        axis: &'static str,
        /// Which coordinate.
        index: usize,
        /// Its value.
        value: f64,
    },
    /// A cell names a class that the map does not have.
    #[error("layer {layer}: cell {cell} has the code {code}, but there are {classes} classes")]
    Code {
        /// The layer.
        layer: usize,
        /// The cell, row-major.
        cell: usize,
        /// Its code.
        code: u8,
        /// Number of classes.
        classes: usize,
    },
}
