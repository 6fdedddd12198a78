use super::{Plane, StabilityMap};
use crate::Contact;
pub fn adaptive(contact: &Contact, plane: &impl Plane) -> StabilityMap {
    super::every_point(contact, plane)
}
