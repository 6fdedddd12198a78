//! What a panic says.

use std::any::Any;

/// The reason of a panic in words, as a fault of the program.
#[must_use]
pub fn fault_told(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().copied();
    let text = text.or_else(|| panic.downcast_ref::<String>().map(String::as_str));
    format!("a fault of the program: {}", text.unwrap_or("it gave no reason"))
}
