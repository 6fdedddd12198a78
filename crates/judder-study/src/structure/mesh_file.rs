//! Mesh files of other programs.

use super::{Structure, Unbuilt};
use judder_case::FileReference;
use judder_case::structure::body::Body;
use judder_case::structure::damping::Damping;

pub(super) fn structure(
    _body: &Body,
    _file: &FileReference,
    _damping: &Damping,
) -> Result<Structure, Unbuilt> {
    Err(Unbuilt::because("structure.mesh", &"mesh files come with a later version"))
}
