//! Analyses: a name that serves as a file name, and a kind with its settings.
//!
//! - `kind`: what there is to ask for. `read`: what a case asks for.

mod kind;
mod read;

pub use kind::{Kind, KindEntry, Kinds, Picture};
pub use read::read_analyses;

use dyn_clone::{DynClone, arc_make_mut};
use std::any::Any;
use std::sync::Arc;

/// One analysis of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Planned<K> {
    /// Unique in its case, safe as a file name; the kind where the case gives none.
    pub name: String,
    /// The name of its kind.
    pub kind_name: &'static str,
    /// What is computed.
    pub kind: K,
}

impl<A: AsAny + DynClone + ?Sized> Planned<Arc<A>> {
    /// Its settings, where they are of this type.
    pub fn settings<T: Any>(&self) -> Option<&T> {
        self.kind.as_ref().as_any().downcast_ref()
    }

    /// The same, to be changed; other clones of the case keep theirs.
    pub fn settings_mut<T: Any>(&mut self) -> Option<&mut T> {
        arc_make_mut(&mut self.kind).as_any_mut().downcast_mut()
    }
}

/// The names of analyses, in their order.
pub fn names<K>(analyses: &[Planned<K>]) -> Vec<&str> {
    analyses.iter().map(|planned| planned.name.as_str()).collect()
}

/// What can be asked of which type it is.
pub trait AsAny {
    /// The value, its type unsaid.
    fn as_any(&self) -> &dyn Any;

    /// The same, to be changed.
    fn as_any_mut(&mut self) -> &mut dyn Any;
}

impl<T: Any> AsAny for T {
    fn as_any(&self) -> &dyn Any {
        self
    }

    fn as_any_mut(&mut self) -> &mut dyn Any {
        self
    }
}

/// Whether a name is a plain file name on every system.
pub fn is_file_name(name: &str) -> bool {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'.' | b'_' | b'-');
    (1..=100).contains(&name.len()) && !name.starts_with('.') && name.bytes().all(plain)
}
