//! The local page of judder: what `judder explore` serves to the browser of this machine, and to nobody else.
//!
//! A view of the page is a case file: the base case, the options set on it, one analysis. It is composed, read and run by the code
//! that `judder run` uses, so that what was found by hand is found again by the exported file.
//!
//! In the order in which the data flows:
//!
//! - `server`: the listener on the loopback interface, its limits on connections, its end.
//! - `guest`: who is at a connection, and who makes room for another.
//! - `admission`: who is let in: Host, Origin, the token, the cookie. `secret`: the token.
//! - `page`: the built page, embedded, with the headers that bind it to this server.
//! - `routes`: which request is answered by what. `site`: what every answer may need. `body`: requests as JSON, within limits.
//! - `subject`: what is explored: the base case, its laws, the study folder.
//! - `view`: a request as a case file; what a request may set. `limits`: how much it may ask for.
//! - `scheduler`: how many requests work at once, and which a newer one cancels. `reporter`: a request at work, its frames, its end.
//! - `limiter`: short computations, a few at a time, and whether their readers are still there.
//! - `frame`: arrays with their names and units as bytes of a stream.
//! - `answers`: one module a kind of answer.
//! - `refusal`: errors as documents. [`ExplorerError`]: why there is no page.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod admission;
mod answers;
mod body;
mod error;
mod frame;
mod guest;
mod limiter;
mod limits;
mod page;
mod refusal;
mod reporter;
mod routes;
mod scheduler;
mod secret;
mod server;
mod site;
mod subject;
mod view;

pub use error::ExplorerError;
pub use server::Explorer;
pub use subject::ViewedCase;
