//! How many cores a command uses.

use clap::Args;

use crate::failure::{Failure, Message};

/// More than any machine has; a larger number is a slip.
const MOST_THREADS: usize = 4096;

/// The option `--threads`.
#[derive(Debug, Clone, Copy, Args)]
pub(crate) struct Threads {
    /// Threads to compute with, one a core by default; results do not depend on it
    #[arg(long, value_name = "N", value_parser = parse, allow_hyphen_values = true)]
    threads: Option<usize>,
}

fn parse(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(threads @ 1..=MOST_THREADS) => Ok(threads),
        _ => Err(format!("give a whole number from 1 to {MOST_THREADS}")),
    }
}

impl Threads {
    /// Does `work` in a pool of that many threads.
    ///
    /// # Errors
    /// The system does not give the threads.
    pub(crate) fn install<T: Send>(self, work: impl FnOnce() -> T + Send) -> Result<T, Failure> {
        let Some(threads) = self.threads else { return Ok(work()) };
        match rayon::ThreadPoolBuilder::new().num_threads(threads).build() {
            Ok(pool) => Ok(pool.install(work)),
            Err(source) => Err(Failure::missing(
                Message::error(format!("cannot start {threads} threads: {source}"))
                    .with_help("ask for fewer, or leave --threads out"),
            )),
        }
    }
}
