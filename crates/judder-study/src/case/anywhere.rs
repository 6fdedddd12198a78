//! Cases that run wherever they lie: the files that they name stand in them by their whole paths.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf, absolute};

use toml_edit::{DocumentMut, Item, TableLike, Value};

use crate::case::file::CaseFile;
use crate::case::keys::file_keys;
use crate::case::options::with_options;
use judder_keys::edited::put;
use judder_keys::error::CaseError;
use judder_keys::file_reference::FileReference;

/// The key of the folder in which the files beside and below it are sought.
const FOLDER: &str = "folder";

/// The case of `file` with its options written into it, and its files by their whole paths; one without files keeps its text.
///
/// # Errors
/// Those of [`CaseFile::parse`], where a file has gone meanwhile.
pub fn anywhere(file: &CaseFile) -> Result<CaseFile, CaseError> {
    let mut document = with_options(&file.origin, &file.text, &file.overrides)?;
    settle(&mut document, file);
    CaseFile::parse(file.registry(), &file.origin, &document.to_string(), &[])
}

/// Puts whole paths into the text of a case; its files are those of `file`.
pub(crate) fn settle(document: &mut DocumentMut, file: &CaseFile) {
    let files = file.case.files();
    if files.is_empty() {
        return;
    }
    let home = Path::new(&file.origin).parent().unwrap_or(Path::new(""));
    // a folder of an option is sought where the program runs
    let folders = [home, Path::new("")].map(|folder| absolute(folder.join(".")).unwrap_or_default());
    Home { folders, files, keys: file_keys(file.registry()) }.settle(document.as_table_mut());
}

/// Where the files of a case are sought, and which they are.
struct Home<'a> {
    folders: [PathBuf; 2],
    files: Vec<&'a FileReference>,
    /// The keys of files.
    keys: BTreeSet<&'static str>,
}

impl Home<'_> {
    fn settle(&self, table: &mut dyn TableLike) {
        let is_of_files = |path: &Path| self.files.iter().any(|file| file.lies_in(path));
        if let Some(item) = table.get_mut(FOLDER) {
            return self.replace(item, is_of_files);
        }
        for (key, item) in table.iter_mut() {
            if self.keys.contains(key.get()) && item.is_str() {
                self.replace(item, is_of_files);
            } else {
                self.settle_below(item);
            }
        }
    }

    fn settle_below(&self, item: &mut Item) {
        if let Some(tables) = item.as_array_of_tables_mut() {
            tables.iter_mut().for_each(|table| self.settle(table));
        } else if let Some(list) = item.as_array_mut() {
            list.iter_mut().filter_map(Value::as_inline_table_mut).for_each(|table| self.settle(table));
        } else if let Some(table) = item.as_table_like_mut() {
            self.settle(table);
        }
    }

    /// Puts the whole path in the place of the one that is given, where it is one of those.
    fn replace(&self, item: &mut Item, is_meant: impl Fn(&Path) -> bool) {
        let Some(text) = item.as_str() else { return };
        let found = self.folders.iter().map(|folder| folder.join(text)).find(|path| is_meant(path));
        if let Some(whole) = found.as_deref().and_then(Path::to_str) {
            put(item, whole.into());
        }
    }
}
