//! Meshes of Gmsh in its formats 4.1 and 2.2, text and binary, with physical names as sets.
//!
//! *Gmsh Reference Manual*, MSH file format, version 4.1 and version 2 (legacy).

mod element_type;
mod groups;
mod sections;
mod source;
mod version2;

use super::MeshFile;
use crate::bytes::Bytes;
use crate::cause::FileCause;
use crate::error::ExchangeError;
use crate::mesh_file::Warning;
use crate::quoted::quoted;
use sections::Sections;
use source::{MshForm, MshSource};

const FORMAT: &str = "mesh of Gmsh's format 4.1 or 2.2";
const REMEDY: &str = "save it anew with `gmsh FILE -save -format msh41 -o NEW.msh`";

/// The formats that are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum MshVersion {
    /// 2.2.
    Two,
    /// 4.1.
    Four,
}

/// Reads nodes, elements and physical groups.
pub(super) fn read_msh(bytes: &[u8]) -> Result<MeshFile, ExchangeError> {
    let mut source = MshSource::new(bytes);
    let version = read_format(&mut source)?;
    let mut sections = Sections::default();
    while let Some(line) = source.line()? {
        let name = line.strip_prefix('$').ok_or_else(|| {
            let problem = format!("`{}` stands where a section should begin", quoted(line));
            source.error(FileCause::Inconsistent { what: "the order of the file", problem })
        })?;
        match (name, version) {
            ("PhysicalNames", _) => sections.read_names(&mut source)?,
            ("Entities", MshVersion::Four) => sections.read_entities(&mut source)?,
            ("Nodes", MshVersion::Four) => sections.read_nodes(&mut source)?,
            ("Nodes", MshVersion::Two) => sections.read_nodes_of_2(&mut source)?,
            ("Elements", MshVersion::Four) => sections.read_elements(&mut source)?,
            ("Elements", MshVersion::Two) => sections.read_elements_of_2(&mut source)?,
            ("PartitionedEntities", _) => {
                let (what, found) = ("the mesh", String::from("partitioned"));
                return Err(source.error(FileCause::Unsupported { what, found, read: "a mesh in one part" }));
            }
            (other, _) => {
                let text = format!("the section ${} is passed over", quoted(other));
                sections.parts.warnings.push(Warning { line: None, text });
            }
        }
        if !source.skip_to(&format!("$End{name}")) {
            return Err(source.error(FileCause::NoEnd { section: quoted(name) }));
        }
    }
    Ok(sections.into_parts()?.build()?)
}

/// The version, the form and, in a binary file, the endianness.
fn read_format(source: &mut MshSource<'_>) -> Result<MshVersion, ExchangeError> {
    let foreign = |found: String| FileCause::Foreign { format: FORMAT, found, remedy: REMEDY };
    let first = source.line()?.unwrap_or("");
    if first != "$MeshFormat" {
        let found = format!("its first line is `{}`", quoted(first));
        return Err(source.error(foreign(found)));
    }
    let line = source.line()?.unwrap_or("");
    let words: Vec<&str> = line.split_whitespace().collect();
    let [version, form, width] = words.as_slice() else {
        return Err(source.error(foreign(format!("its format line is `{}`", quoted(line)))));
    };
    let read = match *version {
        "4.1" => MshVersion::Four,
        "2.2" => MshVersion::Two,
        other => return Err(source.error(foreign(format!("its version is {}", quoted(other))))),
    };
    match (*form, *width) {
        ("0", _) => {}
        ("1", "8") => {
            source.begin_numbers_after_line();
            let one = source.four_bytes()?;
            let big_endian = Bytes::new(&one, 0, false).u32("the number one")? != 1;
            if big_endian && Bytes::new(&one, 0, true).u32("the number one")? != 1 {
                return Err(source.error(foreign(String::from("its endianness cannot be told"))));
            }
            source.set_form(MshForm::Binary { big_endian });
        }
        _ => return Err(source.error(foreign(format!("its format line is `{}`", quoted(line))))),
    }
    if source.skip_to("$EndMeshFormat") {
        Ok(read)
    } else {
        Err(source.error(FileCause::NoEnd { section: String::from("MeshFormat") }))
    }
}
