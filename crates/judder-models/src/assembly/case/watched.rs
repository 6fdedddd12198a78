//! `[observe]`: points whose motion a march keeps.

use super::contact::SurfaceOf;
use super::named_list::{NamedItem, NamedList, item_section};
use super::structure::AssemblyStructure;
use crate::sliding::case::plain_name::PlainName;
use judder_keys::Settings;
use judder_keys::declared::all;
use judder_keys::error::Fault;
use judder_keys::section::{Section, list};

/// Points whose motion is kept.
#[derive(Debug, Clone, Settings)]
pub(crate) struct WatchedPoints {
    /// Points whose motion a march keeps, as accelerations and velocities along x, y and z, and leaves as sound; of which a frequency-response has the displacements.
    #[key(example = "[{ name = \"edge\", structure = \"…\", set = \"x-min\" }]")]
    pub(crate) points: NamedList<WatchedPoint>,
}

/// A point whose motion is kept: a node, or the mean of several.
#[derive(Debug, Clone, Settings)]
pub struct WatchedPoint {
    /// By which signals call this point.
    #[key(rule = "point", example = "\"…\", by which signals call this point")]
    pub name: PlainName,
    /// Where it is.
    #[key(flatten)]
    pub nodes: SurfaceOf,
}

impl NamedItem for WatchedPoint {
    const WHAT: &'static str = "point";

    fn name(&self) -> &PlainName {
        &self.name
    }
}

impl WatchedPoints {
    /// Finds the structures of the points; `section` is that of `observe`.
    pub(super) fn admit(
        &mut self,
        section: &Section<'_>,
        structures: &[AssemblyStructure],
    ) -> Result<(), Fault> {
        let Some(node) = section.get("points") else { return Ok(()) };
        let items = self.points.0.iter_mut().zip(list("observe.points", node)?);
        let admitted =
            items.map(|(own, node)| own.nodes.admit(&item_section::<WatchedPoint>(node)?, structures));
        all(admitted).map(drop)
    }
}
