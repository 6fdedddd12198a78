//! The words of a problem.

use std::any::Any;
use std::fmt;

/// What is wrong with a part of a case, in the words of that part.
pub trait Problem: Any + fmt::Debug + fmt::Display + Send + Sync {
    /// The kind of problem, by which programs tell one from another.
    fn kind(&self) -> &'static str;

    /// What stands beside the caret: a few words.
    fn label(&self) -> &'static str;

    /// What would be right.
    fn help(&self) -> Option<String>;

    /// The dotted path of the key that is to blame, where there is one.
    fn key(&self) -> Option<&str> {
        None
    }
}
