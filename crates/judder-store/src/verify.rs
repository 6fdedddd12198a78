//! A whole study against its manifest.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use judder_disk::kind_in_words;
use rayon::prelude::*;
use serde_json::{Value, json};

use crate::manifest::{self, FileDamage, FileRecord, Manifest};
use crate::{
    LARGEST_DOCUMENT, StoreError, lock, metadata, plain, results, scratch, staging, summary, sweep, zarr,
};

/// How the names of what a run leaves in a study begin while it is at work.
const AT_WORK: [&str; 4] = [staging::PREFIX, staging::STREAM_PREFIX, scratch::PREFIX, sweep::PREFIX];

/// Bytes of files that are read between two questions whether to go on: a fraction of a second,
const STRETCH_BYTES: u64 = 1 << 28;
/// where one counts as so many more, which could be read while it is opened.
const OPENING_BYTES: u64 = 1 << 16;

/// What a study is beside its manifest.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Verification {
    /// Whether a run has ended and listed all; not while one is at work, or was interrupted.
    pub is_complete: bool,
    /// How many files are as they were written.
    pub sound: usize,
    /// Their size.
    pub bytes: u64,
    /// What is not so, by path.
    pub findings: Vec<Finding>,
}

/// A file of a study with which something is wrong.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Finding {
    /// It is not as it was written.
    Damaged {
        /// Its path in the study, with `/` between folders.
        path: String,
        /// The analysis or sweep that it is of.
        of: Option<String>,
        /// What is wrong.
        damage: FileDamage,
    },
    /// It is not in the manifest, or is of a result that the finished study no longer has: an earlier case has left it, finished or not.
    Extra {
        /// Its path.
        path: String,
        /// The analysis or sweep of an earlier case that it is of; none where judder does not know it.
        of: Option<String>,
    },
    /// It is of a result that no run has finished.
    Unfinished {
        /// Its path.
        path: String,
    },
}

impl Finding {
    /// The path of the file in the study, with `/` between folders.
    #[must_use]
    pub fn path(&self) -> &str {
        match self {
            Self::Damaged { path, .. } | Self::Extra { path, .. } | Self::Unfinished { path } => path,
        }
    }

    /// The analysis or sweep that it is of, as far as known.
    #[must_use]
    pub fn of(&self) -> Option<&str> {
        match self {
            Self::Damaged { of, .. } | Self::Extra { of, .. } => of.as_deref(),
            Self::Unfinished { .. } => None,
        }
    }

    /// What is wrong, in words.
    #[must_use]
    pub fn words(&self) -> String {
        match self {
            Self::Damaged { of: Some(of), damage, .. } => format!("of {of}: {damage}"),
            Self::Damaged { of: None, damage, .. } => damage.to_string(),
            Self::Extra { of: None, .. } => "it is not in the manifest".to_owned(),
            Self::Extra { of: Some(of), .. } => {
                format!(
                    "it is of {of} of an earlier case, which the study has no more; `judder run --fresh` removes it"
                )
            }
            Self::Unfinished { .. } => "it is of a result that no run has finished".to_owned(),
        }
    }

    /// Of which kind it is, for programs.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Damaged { damage, .. } if damage.is_damage() => "damaged",
            Self::Damaged { .. } => "unreadable",
            Self::Extra { .. } => "extra",
            Self::Unfinished { .. } => "unfinished",
        }
    }
}

impl Verification {
    /// Whether the study is finished and all of it as it was written. What is there besides does no harm.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        self.is_complete && self.findings.iter().all(|finding| matches!(finding, Finding::Extra { .. }))
    }

    /// All of it as JSON: `sound`, `complete`, `files` and `bytes` that are as they were written, `findings` with `path`, `kind`, `of` and `reason`.
    #[must_use]
    pub fn told(&self) -> Value {
        let findings = self.findings.iter().map(|finding| {
            json!({ "path": finding.path(), "kind": finding.kind(), "of": finding.of(), "reason": finding.words() })
        });
        json!({
            "sound": self.is_sound(),
            "complete": self.is_complete,
            "files": self.sound,
            "bytes": self.bytes,
            "findings": findings.collect::<Vec<Value>>(),
        })
    }
}

/// Compares all files of a study with its manifest, by their content, on all cores; writes nothing. `read` is told of every file with its size before it
/// is read, and says whether to go on.
///
/// Links are not followed but for those to folders below `results.zarr`; what the metadata of all arrays together say, which follows from those of
/// each, is derived again and compared.
///
/// # Errors
/// [`StoreError::NoStudy`], [`StoreError::NoManifest`], [`StoreError::ManifestDamaged`]; failures of the file system but for those that concern one
/// file.
pub fn verify(
    study: impl AsRef<Path>,
    mut read: impl FnMut(&str, u64) -> bool,
) -> Result<Verification, StoreError> {
    let study = study.as_ref();
    let manifest = match Manifest::of_study(study) {
        // a run has only just begun it
        Err(StoreError::NoStudy { .. }) if study.join(lock::FILE).is_file() => Manifest::default(),
        manifest => manifest?,
    };
    let mut found = Verification { is_complete: manifest.complete, ..Verification::default() };
    compare(&mut found, study, &manifest, &mut read);
    for (path, record) in manifest.files.iter().filter(|(_, record)| manifest.is_earlier(record)) {
        if study.join(path).symlink_metadata().is_ok() {
            found.findings.push(Finding::Extra { path: path.clone(), of: record.of.clone() });
        }
    }
    if let Some(other) = plain::other_than_file(&study.join(lock::FILE)) {
        found.findings.push(damaged(lock::FILE, FileDamage::Other(other)));
    }
    let root = format!("{}/{}", results::FOLDER, metadata::FILE);
    match root_is_derived(study) {
        Ok(true) => found.sound += usize::from(study.join(&root).exists()),
        Ok(false) if !manifest.complete => found.findings.push(Finding::Unfinished { path: root.clone() }),
        Ok(false) => found.findings.push(damaged(&root, FileDamage::Content)),
        Err(damage) => found.findings.push(damaged(&root, damage)),
    }
    let (there, closed) = there(study)?;
    found.findings.extend(closed);
    for path in there {
        let is_known = manifest.files.contains_key(&path) || path == root || path == manifest::FILE;
        if is_known || path == lock::FILE {
            continue;
        }
        // a link is none of judder's
        let is_link = plain::is_link(&study.join(&path));
        let finding =
            if is_link { Finding::Extra { path, of: None } } else { unlisted(study, path, &manifest) };
        found.findings.push(finding);
    }
    found.findings.sort_by(|one, other| one.path().cmp(other.path()));
    Ok(found)
}

/// Compares the files that are listed, as long as `read` says so.
fn compare(
    found: &mut Verification,
    study: &Path,
    manifest: &Manifest,
    read: &mut impl FnMut(&str, u64) -> bool,
) {
    for stretch in stretches(manifest) {
        let of = |(path, record): &(&String, &FileRecord)| manifest::check(&study.join(path), record, true);
        let wanted: Vec<_> =
            stretch.iter().take_while(|(path, record)| read(path, record.bytes)).copied().collect();
        let looked: Vec<Result<(), FileDamage>> = wanted.par_iter().map(of).collect();
        for ((path, record), outcome) in wanted.iter().zip(looked) {
            match outcome {
                Ok(()) => {
                    found.sound += 1;
                    found.bytes += record.bytes;
                }
                Err(damage) => {
                    let (path, of) = ((*path).clone(), record.of.clone());
                    found.findings.push(Finding::Damaged { path, of, damage });
                }
            }
        }
        if wanted.len() < stretch.len() {
            break;
        }
    }
}

/// The files of what a manifest lists, but for those of an earlier case, in its order, in stretches that are read on all cores before anybody is asked whether to go on.
fn stretches(manifest: &Manifest) -> Vec<Vec<(&String, &FileRecord)>> {
    let mut stretches: Vec<Vec<(&String, &FileRecord)>> = Vec::new();
    let mut bytes = u64::MAX;
    for (path, record) in manifest.files.iter().filter(|(_, record)| !manifest.is_earlier(record)) {
        if bytes >= STRETCH_BYTES {
            stretches.push(Vec::new());
            bytes = 0;
        }
        bytes = bytes.saturating_add(record.bytes).saturating_add(OPENING_BYTES);
        if let Some(stretch) = stretches.last_mut() {
            stretch.push((path, record));
        }
    }
    stretches
}

fn damaged(path: &str, damage: FileDamage) -> Finding {
    Finding::Damaged { path: path.to_owned(), of: None, damage }
}

/// What a file is that the manifest does not list.
fn unlisted(study: &Path, path: String, manifest: &Manifest) -> Finding {
    let is_work = AT_WORK.iter().any(|prefix| path.starts_with(prefix));
    let group = path.strip_prefix(results::FOLDER).and_then(|below| below.strip_prefix('/'));
    let group = group.and_then(|below| below.split('/').next());
    // what lies among the arrays and is none is somebody's
    let is_group = |name: &str| zarr::stored_hash(&study.join(results::FOLDER).join(name)).is_some();
    let is_open = group
        .is_some_and(|name| !manifest.results.contains_key(name) && (!manifest.complete || is_group(name)));
    let is_summary = path == summary::FILE && !manifest.complete;
    if is_work || is_open || is_summary {
        Finding::Unfinished { path }
    } else {
        Finding::Extra { path, of: None }
    }
}

/// Whether the metadata of all arrays together are those that follow from the metadata of each.
fn root_is_derived(study: &Path) -> Result<bool, FileDamage> {
    let results = study.join(results::FOLDER);
    let path = results.join(metadata::FILE);
    let kind = fs::symlink_metadata(&path).map(|metadata| metadata.file_type());
    match kind {
        Err(_) if !results.exists() => return Ok(true),
        Err(_) => return Err(FileDamage::Missing),
        Ok(kind) if !kind.is_file() => return Err(FileDamage::Other(kind_in_words(kind))),
        Ok(_) => {}
    }
    let unreadable = |source: std::io::Error| FileDamage::Unreadable(source.to_string());
    let stands = plain::read_small_file(&path, LARGEST_DOCUMENT).map_err(unreadable)?;
    match results::derived(&results) {
        Ok(derived) => Ok(stands == derived),
        Err(StoreError::Unreadable { path, reason }) => {
            let from = path.strip_prefix(study).unwrap_or(&path).display();
            Err(FileDamage::Unreadable(format!("it follows from {from}, and that cannot be read: {reason}")))
        }
        Err(_) => Err(FileDamage::Content),
    }
}

/// The paths of all files of a study, links and other things among them; its folders that cannot be looked into.
fn there(study: &Path) -> Result<(BTreeSet<String>, Vec<Finding>), StoreError> {
    let name = |path: &Path| {
        let below = path.strip_prefix(study).unwrap_or(path);
        manifest::relative(study, path).unwrap_or_else(|| below.to_string_lossy().into_owned())
    };
    let (mut found, mut closed, mut folders) = (BTreeSet::new(), Vec::new(), vec![study.to_owned()]);
    while let Some(folder) = folders.pop() {
        match manifest::entries(&folder) {
            Ok((files, below)) => {
                found.extend(files.iter().map(|path| name(path)));
                folders.extend(below);
            }
            Err(source) if folder == study => return Err(StoreError::read(study, source)),
            Err(source) => {
                closed.push(damaged(&name(&folder), FileDamage::Unreadable(source.to_string())));
            }
        }
    }
    Ok((found, closed))
}
