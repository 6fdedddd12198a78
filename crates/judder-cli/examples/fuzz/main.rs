//! Feeds every door of judder with damaged files: case files, laws, meshes, matrices, heights, tables, stored studies, requests of the page.
//!
//! ```text
//! cargo run -p judder-cli --example fuzz -- [--door NAME] [--seconds S | --inputs N | --only N] [--seed K]
//! ```
//!
//! An input is a sample of the project, damaged at some places by numbers that follow from the seed and from its own number alone, so that any of them
//! can be made again: `--only N` makes the N-th alone, whose number stands in the name of a file that was kept. A door must read it or refuse it: no panic, no answer that takes more than two seconds without a word, no more than 1 GiB of memory
//! beyond the file. What does else is kept in `out/fuzz`, and the exit code is 1. An input that ends the process is the file that still lies in
//! `out/fuzz/<door>/tried`.
//!
//! - `damage.rs`: how a sample is damaged.
//! - `doors.rs`: the doors that read a file, and their samples; `studies.rs`, `page.rs`: those that are folders and requests.

#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used, reason = "a fuzzer fails by panicking")]

mod damage;
mod doors;
mod page;
mod studies;

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use damage::damaged;

/// The longest that a door may be silent.
const LONGEST: Duration = Duration::from_secs(2);
/// The longest that a door may take that tells how far it is.
const HANGS: Duration = Duration::from_secs(60);
/// What an input may take beyond its own size.
const MOST_MEMORY: u64 = 1 << 30;

/// A sample: the name of its file, and its content.
type Sample = (PathBuf, Vec<u8>);

/// What reads an input: the file that holds it, under the name of its sample, and its content. An error says what a reader must not do.
type Reading = Box<dyn FnMut(&Path, &[u8]) -> Result<(), String>>;

/// A door with its samples.
struct Door {
    name: &'static str,
    samples: Vec<Sample>,
    /// Whether it tells how far it is, so that it may take longer.
    tells: bool,
    reading: Reading,
}

/// What is asked for.
struct Asked {
    doors: Vec<String>,
    seconds: Option<f64>,
    inputs: u64,
    /// The number of the first.
    first: u64,
    seed: u64,
}

impl Asked {
    fn read(mut words: impl Iterator<Item = String>) -> Self {
        let mut asked = Self { doors: Vec::new(), seconds: None, inputs: u64::MAX, first: 0, seed: 0 };
        while let Some(word) = words.next() {
            let value = words.next().unwrap_or_else(|| panic!("{word} takes a value"));
            match word.as_str() {
                "--door" => asked.doors.push(value),
                "--seconds" => asked.seconds = Some(value.parse().expect("--seconds takes a number")),
                "--only" => {
                    asked.first = value.parse().expect("--only takes the number of an input");
                    asked.inputs = 1;
                }
                "--inputs" => asked.inputs = value.parse().expect("--inputs takes a count"),
                "--seed" => asked.seed = value.parse().expect("--seed takes a number"),
                _ => panic!("there are --door, --seconds, --inputs, --only, --seed; not {word}"),
            }
        }
        if asked.seconds.is_none() && asked.inputs == u64::MAX {
            asked.seconds = Some(5.0);
        }
        asked
    }
}

/// When the input began that is being read, in milliseconds since the start; zero between two.
static BEGAN: AtomicU64 = AtomicU64::new(0);

/// Panics so far, of any thread: a server answers them by an end of the connection.
static PANICS: AtomicU64 = AtomicU64::new(0);

fn count_panics() {
    let told = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        PANICS.fetch_add(1, Ordering::Relaxed);
        told(panic);
    }));
}

/// Ends the process where an input is read for ever.
fn watch(start: Instant) {
    thread::spawn(move || {
        loop {
            thread::sleep(Duration::from_secs(1));
            let (began, now) = (BEGAN.load(Ordering::Relaxed), start.elapsed().as_millis() as u64);
            if began > 0 && now.saturating_sub(began) > 2 * HANGS.as_millis() as u64 {
                eprintln!("an input hangs; it is the file in out/fuzz/<door>/tried");
                std::process::exit(1);
            }
        }
    });
}

/// The most memory that this process has had, in bytes, where the system says so.
fn most_memory() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = line.and_then(|line| line.split_whitespace().next()?.parse::<u64>().ok());
    kilobytes.unwrap_or(0) * 1024
}

impl Door {
    /// Reads inputs as long as is asked; the numbers of those that were read wrongly, with why.
    fn run(&mut self, asked: &Asked, start: Instant) -> Vec<String> {
        let folder = Path::new("out/fuzz").join(self.name.replace(' ', "-"));
        fs::create_dir_all(folder.join("tried")).unwrap();
        let (began, before) = (Instant::now(), most_memory());
        let (mut faults, mut slowest, mut number) = (Vec::new(), Duration::ZERO, asked.first);
        let goes_on = |number: u64, began: Instant| {
            number - asked.first < asked.inputs
                && asked.seconds.is_none_or(|seconds| began.elapsed().as_secs_f64() < seconds)
        };
        while goes_on(number, began) {
            let (name, content) = damaged(&self.samples, asked.seed, number);
            let place = folder.join("tried").join(name.file_name().unwrap());
            fs::write(&place, &content).unwrap();
            let (outcome, took) = self.timed(&place, &content, start);
            slowest = slowest.max(took);
            let taken = most_memory().saturating_sub(before);
            let is_too_much = taken > content.len() as u64 + MOST_MEMORY;
            let why = match outcome {
                Err(why) => Some(why),
                Ok(()) if is_too_much => Some(format!("{} MiB of memory", taken >> 20)),
                Ok(()) if took > if self.tells { HANGS } else { LONGEST } => Some(format!("{took:?}")),
                Ok(()) => None,
            };
            if let Some(why) = why {
                let kept =
                    folder.join(format!("{}-{number}-{}", asked.seed, name.file_name().unwrap().display()));
                fs::copy(&place, &kept).unwrap();
                faults.push(format!("{}: {why}", kept.display()));
            }
            fs::remove_file(&place).unwrap();
            number += 1;
            if is_too_much || faults.len() > 20 {
                break;
            }
        }
        let taken = most_memory().saturating_sub(before) >> 20;
        println!(
            "{}: {} inputs, {} faults; the slowest took {slowest:.0?}, all {taken} MiB more",
            self.name,
            number - asked.first,
            faults.len()
        );
        faults
    }

    /// Reads an input; one that is slow a second time, as the machine may have been busy.
    fn timed(&mut self, place: &Path, content: &[u8], start: Instant) -> (Result<(), String>, Duration) {
        let mut least = Duration::MAX;
        for _ in 0..2 {
            BEGAN.store(start.elapsed().as_millis() as u64 + 1, Ordering::Relaxed);
            let began = Instant::now();
            let before = PANICS.load(Ordering::Relaxed);
            let outcome = catch_unwind(AssertUnwindSafe(|| (self.reading)(place, content)));
            least = least.min(began.elapsed());
            BEGAN.store(0, Ordering::Relaxed);
            match outcome {
                Ok(Err(why)) => return (Err(why), least),
                _ if PANICS.load(Ordering::Relaxed) > before => return (Err("a panic".to_owned()), least),
                _ if least <= LONGEST || self.tells => break,
                _ => {}
            }
        }
        (Ok(()), least)
    }
}

fn main() -> ExitCode {
    let asked = Asked::read(std::env::args().skip(1));
    let start = Instant::now();
    watch(start);
    count_panics();
    let mut faults = Vec::new();
    let wanted = |door: &Door| asked.doors.is_empty() || asked.doors.iter().any(|name| name == door.name);
    let doors = doors::doors().into_iter().chain([studies::door(), page::door()]);
    for mut door in doors.filter(wanted) {
        assert!(!door.samples.is_empty(), "{} has no sample", door.name);
        faults.extend(door.run(&asked, start));
    }
    faults.iter().for_each(|fault| println!("{fault}"));
    if faults.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
