//! Why there is no page.

use std::io;
use std::net::SocketAddr;

use judder_keys::error::CaseError;
use judder_study::StudyError;
use thiserror::Error;

/// Why the page cannot be served.
#[derive(Debug, Error)]
pub enum ExplorerError {
    /// The port is taken, or the system refuses it.
    #[error("cannot listen on {address}: {source}; leave out `--port`, or choose another")]
    Bind {
        /// Where.
        address: SocketAddr,
        /// Why.
        source: io::Error,
    },
    /// The system has no random numbers for the secret of the session.
    #[error("the system gives no random numbers for the secret of the session: {reason}")]
    NoRandomness {
        /// Why.
        reason: String,
    },
    /// The threads of the server could not be started.
    #[error("the server could not be started: {0}")]
    Start(io::Error),
    /// The case is wrong.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// The study folder cannot be read.
    #[error(transparent)]
    Study(#[from] StudyError),
}
