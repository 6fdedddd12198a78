//! Times the store of sweeps in a folder that is named on the command line and must not exist: chunks that are written and forced to the disk,
//! then, of many small ones, the list of those that are done, their records, all of their checksums. A second argument says how many, 100,000
//! if left out.

use std::fs;
use std::path::Path;
use std::time::Instant;

use judder_store::{
    ClaimAnswer, SharedStudy, StoreError, SweepDimension, SweepLayout, SweepQuantity, SweepStore,
};

const WRITTEN: usize = 500;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let path = arguments.next().ok_or("name the folder to write into")?;
    let many = arguments.next().map_or(Ok(100_000), |count| count.parse::<usize>())?;
    let study = SharedStudy::join(&path)?;
    for points in [256, 4096, 65_536] {
        let written = WRITTEN * 256 / points.clamp(256, 12_800);
        let layout = layout(&format!("points_{points}"), points, written)?;
        let values = values(&layout, 0)?;
        println!(
            "chunks of {points} points × 5 quantities, {} bytes:",
            layout.encode(0, &values, &[])?.len()
        );
        let store = timed("begin the sweep", 1, || study.sweep(&layout))?;
        let encode = |chunk| layout.encode(chunk, &values, &[]).map(drop);
        timed("encode a chunk", written, || (0..written).try_for_each(encode))?;
        timed("claim, encode and write a chunk", written, || write(&store, &values))?;
    }
    println!("{many} chunks of 1 point × 5 quantities:");
    let layout = layout("many", 1, many)?;
    let store = study.sweep(&layout)?;
    let values = values(&layout, 0)?;
    for chunk in 0..many {
        // not forced to the disk: only the number of files matters here
        let place = Path::new(&path).join(format!("results.zarr/many/values/c.{chunk}.0"));
        fs::write(place, layout.encode(chunk, &values, &[])?)?;
    }
    let done = timed("list all chunks", 1, || store.done_chunks())?;
    let failures = timed("read a record", many, || store.failures())?;
    let unsound = timed("verify a chunk", many, || store.verify())?;
    let done = done.iter().filter(|done| **done).count();
    println!("  {done} are done, {} of their points failed, {} are not sound", failures.len(), unsound.len());
    Ok(())
}

fn layout(name: &str, points: usize, chunks: usize) -> Result<SweepLayout, StoreError> {
    let sample = SweepDimension { name: "sample".to_owned(), length: points * chunks, chunk: points };
    let quantities = (0..5).map(|i| SweepQuantity::new(&format!("quantity_{i}"), "1", "")).collect();
    SweepLayout::new(name, "hash", vec![sample], quantities)
}

fn values(layout: &SweepLayout, chunk: usize) -> Result<Vec<f64>, StoreError> {
    let count = layout.points(chunk)?.count() * 5;
    Ok((0..count).map(|i| (i as f64).sin()).collect())
}

fn write(store: &SweepStore, values: &[f64]) -> Result<(), StoreError> {
    for chunk in 0..store.layout().chunk_count() {
        if let ClaimAnswer::Claimed(claim) = store.claim(chunk)? {
            store.write(claim, values, &[])?;
        }
    }
    Ok(())
}

/// Prints the time of one of `count` equal steps.
fn timed<T>(what: &str, count: usize, steps: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = steps();
    println!("  {what}: {:.1} µs", start.elapsed().as_secs_f64() * 1e6 / count as f64);
    result
}
