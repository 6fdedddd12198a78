//! The calls of the system.

use crate::fault::{self, Call, pass};
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::Path;

/// Makes a folder, which must not be there.
///
/// # Errors
/// A failure of the file system, as of all here.
pub fn create_folder(path: &Path) -> io::Result<()> {
    pass(Call::CreateFolder, path)?;
    fs::create_dir(path)
}

/// Makes a folder with those above it, where they are not there.
///
/// # Errors
/// A failure of the file system.
pub fn create_folders(path: &Path) -> io::Result<()> {
    if !path.is_dir() {
        pass(Call::CreateFolder, path)?;
    }
    fs::create_dir_all(path)
}

/// Opens a file to write it anew.
///
/// # Errors
/// A failure of the file system.
pub fn create_file(path: &Path) -> io::Result<File> {
    pass(Call::CreateFile, path)?;
    OpenOptions::new().create(true).truncate(true).write(true).open(path)
}

/// Makes a file, which must not be there.
///
/// # Errors
/// A failure of the file system.
pub fn create_new_file(path: &Path) -> io::Result<File> {
    pass(Call::CreateFile, path)?;
    File::create_new(path)
}

/// Opens a file to read and write, and makes it where it is not there; its content stays.
///
/// # Errors
/// A failure of the file system.
pub fn open_lasting(path: &Path) -> io::Result<File> {
    pass(Call::CreateFile, path)?;
    OpenOptions::new().create(true).truncate(false).read(true).write(true).open(path)
}

/// Writes bytes where the file stands.
///
/// # Errors
/// A failure of the file system.
pub fn write(mut file: &File, bytes: &[u8]) -> io::Result<()> {
    match fault::due(Call::Write, None) {
        None => file.write_all(bytes),
        Some(fault) => {
            let half = bytes.get(..bytes.len() / 2).unwrap_or_default();
            file.write_all(half).and_then(|()| Err(fault.strike()))
        }
    }
}

/// Cuts a file off, or makes it longer.
///
/// # Errors
/// A failure of the file system.
pub fn set_length(file: &File, length: u64) -> io::Result<()> {
    fault::due(Call::SetLength, None).map_or(Ok(()), |fault| Err(fault.strike()))?;
    file.set_len(length)
}

/// Forces a file to the disk.
///
/// # Errors
/// A failure of the file system.
pub fn sync(file: &File) -> io::Result<()> {
    fault::due(Call::Sync, None).map_or(Ok(()), |fault| Err(fault.strike()))?;
    file.sync_all()
}

/// Forces the entries of a folder to the disk, where the system has a notion of it.
///
/// # Errors
/// A failure of the file system.
pub fn sync_folder(path: &Path) -> io::Result<()> {
    pass(Call::Sync, path)?;
    if cfg!(unix) { File::open(path)?.sync_all() } else { Ok(()) }
}

/// Renames a file or a folder; a file takes the place of another.
///
/// # Errors
/// A failure of the file system.
pub fn rename(from: &Path, to: &Path) -> io::Result<()> {
    pass(Call::Rename, to)?;
    fs::rename(from, to)
}

/// Exchanges two files or folders in one step.
///
/// # Errors
/// A failure of the file system; [`ErrorKind::Unsupported`] where it has no such step.
pub fn exchange(one: &Path, other: &Path) -> io::Result<()> {
    pass(Call::Exchange, other)?;
    exchange_at_once(one, other)
}

#[cfg(any(target_os = "linux", target_vendor = "apple"))]
fn exchange_at_once(one: &Path, other: &Path) -> io::Result<()> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    Ok(renameat_with(CWD, one, CWD, other, RenameFlags::EXCHANGE)?)
}

#[cfg(not(any(target_os = "linux", target_vendor = "apple")))]
fn exchange_at_once(_one: &Path, _other: &Path) -> io::Result<()> {
    Err(ErrorKind::Unsupported.into())
}

/// Removes a file.
///
/// # Errors
/// A failure of the file system.
pub fn remove_file(path: &Path) -> io::Result<()> {
    pass(Call::Remove, path)?;
    fs::remove_file(path)
}

/// Removes a file, or a folder with all that it holds, entry by entry; nothing there is as good.
///
/// # Errors
/// A failure of the file system.
pub fn remove(path: &Path) -> io::Result<()> {
    let removed = match fs::symlink_metadata(path) {
        Ok(metadata) if metadata.is_dir() => remove_folder(path),
        Ok(_) => remove_file(path),
        Err(source) => Err(source),
    };
    match removed {
        Err(source) if source.kind() != ErrorKind::NotFound => Err(source),
        _ => Ok(()),
    }
}

fn remove_folder(path: &Path) -> io::Result<()> {
    for entry in fs::read_dir(path)? {
        remove(&entry?.path())?;
    }
    pass(Call::Remove, path)?;
    fs::remove_dir(path)
}
