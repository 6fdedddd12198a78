//! The cases and scripts of the folder `cases`, inside the program: what `judder examples` lists and `judder demo` runs.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

use rust_embed::RustEmbed;
use std::path::{Path, PathBuf};
use std::{fs, io};

#[derive(RustEmbed)]
#[folder = "cases"]
struct Embedded;

/// What an example is, by the ending of its file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExampleKind {
    /// A case file.
    Case,
    /// A script of Python.
    Script,
}

impl ExampleKind {
    fn of(ending: &str) -> Option<Self> {
        match ending {
            "toml" => Some(Self::Case),
            "py" => Some(Self::Script),
            _ => None,
        }
    }

    /// Its name in lists: `case` or `script`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Case => "case",
            Self::Script => "script",
        }
    }
}

/// A case or a script, with the files that it names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Example {
    /// What it is called: its path in `cases` without the ending, such as `assembly/mode-coupling`.
    pub name: String,
    /// Case or script.
    pub kind: ExampleKind,
    /// What it is, in a line.
    pub title: String,
    /// The name of its file.
    pub file: String,
    /// Its text.
    pub text: String,
    /// The files that it names, which lie beside it: names and contents.
    pub files: Vec<(String, Vec<u8>)>,
}

/// Why there is no example, or why it was not written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExampleError {
    /// No example has this name.
    #[error("there is no example `{name}`; {}", neighbours(.near))]
    Unknown {
        /// The name.
        name: String,
        /// Names of examples that are like it.
        near: Vec<String>,
    },
    /// Another file of the same name lies there.
    #[error("{path} is there already, with another content; name another folder")]
    Exists {
        /// Its path.
        path: PathBuf,
    },
    /// A file or a folder cannot be written.
    #[error("{path} cannot be written: {source}")]
    Write {
        /// Its path.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
}

fn neighbours(near: &[String]) -> String {
    match near {
        [] => "`judder examples` lists them".to_owned(),
        near => format!("is {} meant? `judder examples` lists all", near.join(" or ")),
    }
}

/// All examples by their names. A case that names a folder of files which the program does not have is none.
#[must_use]
pub fn examples() -> Vec<Example> {
    let mut found: Vec<Example> = Embedded::iter().filter_map(|path| example_at(&path)).collect();
    found.sort_by(|first, second| first.name.cmp(&second.name));
    found
}

/// The example of this name; the last part of a name is enough where one example alone has it.
///
/// # Errors
/// [`ExampleError::Unknown`], with the names that are like it.
pub fn example(name: &str) -> Result<Example, ExampleError> {
    let all = examples();
    let (stem, ending) = name.rsplit_once('.').unwrap_or((name, ""));
    let asked = if ExampleKind::of(ending).is_some() { stem } else { name };
    let last = |own: &Example| own.name.rsplit('/').next().is_some_and(|last| last == asked);
    let by_last: Vec<&Example> = all.iter().filter(|own| last(own)).collect();
    match (all.iter().find(|own| own.name == asked), by_last.as_slice()) {
        (Some(own), _) => Ok(own.clone()),
        (None, [own]) => Ok((*own).clone()),
        (None, several) => {
            let words = asked.rsplit('/').next().unwrap_or(asked);
            let is_like = |own: &&Example| !words.is_empty() && own.name.contains(words);
            let near = match several {
                [] => all.iter().filter(is_like).map(|own| own.name.clone()).take(5).collect(),
                several => several.iter().map(|own| own.name.clone()).collect(),
            };
            Err(ExampleError::Unknown { name: name.to_owned(), near })
        }
    }
}

fn example_at(path: &str) -> Option<Example> {
    let (name, ending) = path.rsplit_once('.')?;
    let kind = ExampleKind::of(ending)?;
    let text = text_at(path)?;
    if text.lines().any(|line| line.starts_with("folder")) {
        return None;
    }
    let (folder, file) = path.rsplit_once('/').unwrap_or(("", path));
    let title = match kind {
        ExampleKind::Case => title_of_case(&text),
        ExampleKind::Script => text.lines().next().unwrap_or_default().trim_matches('"').to_owned(),
    };
    let files = beside(folder, &text);
    Some(Example { name: name.to_owned(), kind, title, file: file.to_owned(), text, files })
}

fn text_at(path: &str) -> Option<String> {
    String::from_utf8(Embedded::get(path)?.data.into_owned()).ok()
}

/// The files of a folder, which are no examples themselves, whose names stand in a text.
fn beside(folder: &str, text: &str) -> Vec<(String, Vec<u8>)> {
    let named = |path: &str| -> Option<(String, Vec<u8>)> {
        let file = path.strip_prefix(folder)?.strip_prefix('/')?;
        let is_example = file.rsplit_once('.').is_some_and(|(_, ending)| ExampleKind::of(ending).is_some());
        let is_named = !is_example && text.contains(&format!("\"{file}\""));
        is_named.then(|| Some((file.to_owned(), Embedded::get(path)?.data.into_owned())))?
    };
    let mut found: Vec<_> = Embedded::iter().filter_map(|path| named(&path)).collect();
    found.sort();
    found
}

/// The title that a case gives itself, else the first sentence of its first comment.
fn title_of_case(text: &str) -> String {
    let title = text.lines().find_map(|line| line.strip_prefix("title")?.trim_start().strip_prefix('='));
    if let Some(title) = title {
        return title.trim().trim_matches('"').to_owned();
    }
    let comment = text.lines().map_while(|line| line.strip_prefix('#')).map(str::trim);
    let mut words: Vec<&str> = Vec::new();
    for line in comment {
        words.push(line);
        if line.ends_with(['.', ':']) {
            break;
        }
    }
    words.join(" ").trim_end_matches(['.', ':']).to_owned()
}

impl Example {
    /// Writes it and the files that it names into a folder, which is made where there is none; returns its path. What lies there already with the same
    /// content stays.
    ///
    /// # Errors
    /// [`ExampleError::Exists`], before anything is written; [`ExampleError::Write`].
    pub fn write(&self, folder: &Path) -> Result<PathBuf, ExampleError> {
        let own = (self.file.as_str(), self.text.as_bytes());
        let files = self.files.iter().map(|(name, content)| (name.as_str(), content.as_slice()));
        let all: Vec<(PathBuf, &[u8])> =
            files.chain([own]).map(|(name, content)| (folder.join(name), content)).collect();
        let mut missing = Vec::new();
        for (path, content) in &all {
            match fs::read(path) {
                Ok(there) if there == *content => {}
                Ok(_) => return Err(ExampleError::Exists { path: path.clone() }),
                Err(error) if error.kind() == io::ErrorKind::NotFound => missing.push((path, content)),
                Err(source) => return Err(ExampleError::Write { path: path.clone(), source }),
            }
        }
        let failed = |path: &Path| {
            let path = path.to_owned();
            |source| ExampleError::Write { path, source }
        };
        judder_disk::create_folders(folder).map_err(failed(folder))?;
        for (path, content) in missing {
            let written: io::Result<()> = judder_disk::write_whole(path, |out| out.write_all(content));
            written.map_err(failed(path))?;
        }
        Ok(folder.join(&self.file))
    }
}
