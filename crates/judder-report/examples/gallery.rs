//! Draws one figure of every kind and a page around them into a folder: `cargo run --example gallery -- DIR`.
//!
//! The curves are invented; they only have the shapes that friction-induced vibration brings.

#[path = "gallery/figures.rs"]
mod figures;
#[path = "gallery/report.rs"]
mod report;

use std::error::Error;
use std::fs;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).unwrap_or_else(|| "gallery".to_owned());
    let folder = Path::new(&folder);
    fs::create_dir_all(folder.join("figures"))?;
    for figure in figures::all() {
        let stem = folder.join("figures").join(&figure.name);
        fs::write(stem.with_extension("svg"), judder_report::svg(&figure)?)?;
        fs::write(stem.with_extension("png"), judder_report::png(&figure, 3.0)?)?;
    }
    fs::write(folder.join("report.html"), judder_report::html(&report::page(figures::all()))?)?;
    Ok(())
}
