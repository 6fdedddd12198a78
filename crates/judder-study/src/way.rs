//! Ways from one place to another, as paths.

use std::io;
use std::path::{Component, Path, PathBuf};

/// The way from a study folder to a case file, so that both may be moved together.
pub(crate) fn way(folder: &Path, file: &Path) -> Option<String> {
    let (folder, file) = (whole(folder).ok()?, whole(file).ok()?);
    let shared = folder.components().zip(file.components()).take_while(|(own, other)| own == other).count();
    let up = folder.components().skip(shared).map(|_| Component::ParentDir);
    let way: PathBuf = up.chain(file.components().skip(shared)).collect();
    way.to_str().map(|text| text.replace('\\', "/"))
}

/// An absolute path without `.` and `..`; links are not followed.
fn whole(path: &Path) -> io::Result<PathBuf> {
    Ok(without_turns(&std::path::absolute(path)?))
}

/// A path without `.`, and `..` only at its start.
pub(crate) fn without_turns(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for component in path.components() {
        match component {
            Component::CurDir => (),
            Component::ParentDir if matches!(plain.components().next_back(), Some(Component::Normal(_))) => {
                plain.pop();
            }
            other => plain.push(other),
        }
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_way_leads_from_the_folder_to_the_file() {
        assert_eq!(way(Path::new("out/case"), Path::new("case.toml")).unwrap(), "../../case.toml");
        assert_eq!(way(Path::new("out/./x/../case"), Path::new("a/case.toml")).unwrap(), "../../a/case.toml");
        assert_eq!(without_turns(Path::new("out/case/../../a/case.toml")), Path::new("a/case.toml"));
        assert_eq!(without_turns(Path::new("../case.toml")), Path::new("../case.toml"));
    }
}
