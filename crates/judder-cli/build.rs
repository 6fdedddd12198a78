//! Names the sources that the program is built from: `JUDDER_VERSION` is the number of the version, a `+` and what is known of the commit.

use std::collections::hash_map::DefaultHasher;
use std::env;
use std::fs;
use std::hash::{Hash, Hasher};
use std::path::{Path, PathBuf};
use std::process::Command;

/// The number of digits of a commit that are told.
const DIGITS: usize = 12;

fn main() {
    let number = env::var("CARGO_PKG_VERSION").unwrap_or_default();
    let version = match given().or_else(packaged).or_else(checked_out).or_else(unpacked) {
        Some(sources) => format!("{number}+{sources}"),
        None => number,
    };
    println!("cargo::rustc-env=JUDDER_VERSION={version}");
    for (name, of) in [("JUDDER_PROFILE", profile()), ("JUDDER_TARGET", env::var("TARGET").ok())] {
        println!("cargo::rustc-env={name}={}", of.unwrap_or_default());
    }
}

/// The commit that whoever builds names, in the environment or, in a source distribution, in a file.
fn given() -> Option<String> {
    println!("cargo::rerun-if-env-changed=JUDDER_COMMIT");
    let named = env::var("JUDDER_COMMIT").ok().or_else(|| {
        let noted = fs::read_to_string("commit.txt").ok()?;
        // named only where it is: Cargo takes a file that is missing for one that changed
        println!("cargo::rerun-if-changed=commit.txt");
        Some(noted)
    });
    named.map(|commit| shortened(&commit)).filter(|commit| !commit.is_empty())
}

/// The commit that `cargo package` has noted in a crate.
fn packaged() -> Option<String> {
    let noted = std::fs::read_to_string(".cargo_vcs_info.json").ok()?;
    let (_, after) = noted.split_once("\"sha1\"")?;
    after.split('"').nth(1).map(shortened)
}

/// The commit of the checkout that these sources are, with a digest of what differs from it.
fn checked_out() -> Option<String> {
    let root = git(&["rev-parse", "--show-toplevel"])?;
    let ours = Path::new(root.trim()).join("crates/judder-cli").canonicalize().ok()?;
    if Path::new(".").canonicalize().ok()? != ours {
        return None;
    }
    // grows with every commit and checkout, and is left alone by all else
    println!("cargo::rerun-if-changed={}", git(&["rev-parse", "--git-path", "logs/HEAD"])?.trim());
    for compiled in ["../../crates", "../../Cargo.lock", "../../Cargo.toml"] {
        for file in git(&["ls-files", compiled])?.lines().filter(|file| is_compiled(file)) {
            println!("cargo::rerun-if-changed={file}");
        }
    }
    let commit = shortened(&git(&["rev-parse", "HEAD"])?);
    let changes = git(&["diff", "HEAD", "--", "../../crates", "../../Cargo.lock", "../../Cargo.toml"])?;
    let others = git(&["ls-files", "--others", "--exclude-standard", "../../crates"])?;
    let added: Vec<PathBuf> = others.lines().filter(|file| is_compiled(file)).map(PathBuf::from).collect();
    if changes.is_empty() && added.is_empty() {
        return Some(commit);
    }
    let mut digest = DefaultHasher::new();
    changes.hash(&mut digest);
    Some(format!("{commit}.changed-{}", digest_of(digest, &added)))
}

/// A digest of the sources themselves, where nothing tells of which commit they are.
fn unpacked() -> Option<String> {
    let mut files = vec![PathBuf::from("../../Cargo.lock"), PathBuf::from("../../Cargo.toml")];
    let mut folders = vec![PathBuf::from("../../crates")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).ok()?.flatten() {
            let path = entry.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.to_str().is_some_and(is_compiled) {
                files.push(path);
            }
        }
    }
    files.sort();
    Some(format!("sources-{}", digest_of(DefaultHasher::new(), &files)))
}

/// Eight digits of a digest that goes on over the names and contents of files.
fn digest_of(mut digest: DefaultHasher, files: &[PathBuf]) -> String {
    for file in files {
        println!("cargo::rerun-if-changed={}", file.display());
        file.hash(&mut digest);
        fs::read(file).unwrap_or_default().hash(&mut digest);
    }
    format!("{:08x}", digest.finish() >> 32)
}

/// Whether a file decides what is computed.
fn is_compiled(file: &str) -> bool {
    ["/src/", "/build.rs", "Cargo.toml", "Cargo.lock"].iter().any(|part| file.contains(part))
        && !file.contains("/web/")
}

fn git(arguments: &[&str]) -> Option<String> {
    let output =
        Command::new("git").args(arguments).output().ok().filter(|output| output.status.success())?;
    String::from_utf8(output.stdout).ok()
}

fn shortened(commit: &str) -> String {
    commit.trim().chars().take_while(char::is_ascii_alphanumeric).take(DIGITS).collect()
}

/// The profile of Cargo, which names the folder that it builds into.
fn profile() -> Option<String> {
    let folder = env::var("OUT_DIR").ok()?;
    Path::new(&folder).ancestors().nth(3)?.file_name()?.to_str().map(|name| name.replace("debug", "dev"))
}
