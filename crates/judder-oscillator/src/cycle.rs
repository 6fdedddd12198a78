//! Limit cycles: periodic motions of an oscillator in sliding contact, stable or not.
//!
//! - [`mod@return_map`]: once around, from the section x' = 0 back to it, with the exact derivative through all events.
//! - `newton`: Newton's method on the return map; [`shooting`]: what it finds, with Floquet multipliers.
//! - [`confirmed`]: what a motion settles to, told where a finer tolerance tells the same and another algorithm closes it.
//! - `wandering`: whether a motion without a period is irregular, or only has not settled.
//! - `least_period`: the shortest cycle that a longer one walks.
//! - [`birth`]: the small cycles beside a Hopf point.
//! - [`continuation`]: branches of cycles along any parameter, through folds and changes of the pattern.
//! - [`margin`]: from a subcritical threshold back to the fold of its branch.
//! - [`exploration`]: motions beside stable steady sliding on no known branch: how far a knock reaches.

pub mod birth;
pub mod confirmed;
pub mod continuation;
mod error;
pub mod exploration;
mod least_period;
pub mod margin;
mod newton;
pub mod return_map;
pub mod shooting;
mod wandering;

pub use birth::small_cycle;
pub use confirmed::{Confirmed, settle_confirmed};
pub use continuation::{BranchEnd, BranchPoint, Continuation, CycleBranch, Fold, continue_branch};
pub use error::CycleError;
pub use exploration::{Exploration, Look, SearchEnd, explore};
pub use margin::{GlobalMargin, global_margin};
pub use return_map::{Return, return_map, returned_state};
pub use shooting::{Cycle, Shooting, shoot};
