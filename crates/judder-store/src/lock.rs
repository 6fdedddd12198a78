//! Locks of the operating system, which end with the process however it ends.

use std::fs::{File, TryLockError};
use std::io::{self, ErrorKind};
use std::path::Path;
use std::sync::Arc;

use crate::lock_sign::sign;
use crate::{StoreError, staging};

/// The name of the file in a study that is locked.
pub(crate) const FILE: &str = ".judder.lock";

/// Whom a lock lets in beside its holder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LockMode {
    /// Nobody.
    Alone,
    /// Everybody who asks for the same.
    Shared,
}

/// A locked file; unlocked when dropped.
#[derive(Debug)]
pub(crate) struct Lock {
    file: Arc<File>,
    mode: LockMode,
    is_real: bool,
}

impl Lock {
    /// Whether it keeps anybody out: some cluster file systems have no locks, and to refuse them would help nobody.
    pub(crate) fn is_real(&self) -> bool {
        self.is_real
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // Who holds it alone takes the name off that `sign` has written: what a study holds does not depend on who wrote it.
        if self.is_real && self.mode == LockMode::Alone {
            let _ = judder_disk::set_length(&self.file, 0);
        }
        // To close the file is not enough while a child process that is being started still has it. What fails here ends with the process.
        let _ = self.file.unlock();
    }
}

/// Locks a file, which is made where there is none; `None` while another holds it.
pub(crate) fn try_lock(path: &Path, mode: LockMode) -> Result<Option<Lock>, StoreError> {
    /// A file system that numbers a file anew at each look is believed after so many.
    const LOOKS: usize = 3;
    let lock = |file: &File| match mode {
        LockMode::Alone => file.try_lock(),
        LockMode::Shared => file.try_lock_shared(),
    };
    let mut file = open(path)?;
    let mut locked = lock(&file);
    for _ in 1..LOOKS {
        if locked.is_err() || is_at(path, &file) {
            break;
        }
        // who cleared the place meanwhile has locked another file
        file = open(path)?;
        locked = lock(&file);
    }
    match locked {
        Ok(()) => {
            let file = Arc::new(file);
            sign(&file, &file);
            Ok(Some(Lock { file, mode, is_real: true }))
        }
        Err(TryLockError::WouldBlock) => Ok(None),
        Err(TryLockError::Error(source)) => unlocked(path, file, mode, source).map(Some),
    }
}

/// Whether a file is still the one that has this path.
#[cfg(unix)]
fn is_at(path: &Path, file: &File) -> bool {
    use std::os::unix::fs::MetadataExt;
    let place = |metadata: std::fs::Metadata| (metadata.dev(), metadata.ino());
    match (file.metadata(), path.symlink_metadata()) {
        (Ok(own), Ok(there)) => place(own) == place(there),
        _ => true,
    }
}

#[cfg(not(unix))]
fn is_at(_path: &Path, _file: &File) -> bool {
    true
}

/// Readable and writable, since a network file system may ask for the one or the other by the kind of lock.
fn open(path: &Path) -> Result<File, StoreError> {
    let open = || {
        // what a link leads to is somebody's
        staging::clear_place(path)?;
        judder_disk::open_lasting(path)
    };
    open().map_err(|source| StoreError::write(path, 0, source))
}

fn unlocked(path: &Path, file: File, mode: LockMode, source: io::Error) -> Result<Lock, StoreError> {
    if has_no_locks(&source) {
        return Ok(Lock { file: Arc::new(file), mode, is_real: false });
    }
    Err(StoreError::FileSystem { action: "lock", path: path.to_owned(), source })
}

/// Whether the file system has no locks: it says that it cannot, or that nobody there keeps them.
fn has_no_locks(failure: &io::Error) -> bool {
    #[cfg(any(target_os = "linux", target_vendor = "apple"))]
    if failure.raw_os_error() == Some(rustix::io::Errno::NOLCK.raw_os_error()) {
        return true;
    }
    failure.kind() == ErrorKind::Unsupported
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lock_sign::LockSign;

    #[test]
    fn a_lock_is_held_alone_or_shared() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("lock");
        let lock = |mode| try_lock(&path, mode).unwrap();
        let alone = lock(LockMode::Alone);
        assert!(alone.as_ref().is_some_and(Lock::is_real));
        assert!(lock(LockMode::Alone).is_none() && lock(LockMode::Shared).is_none());
        drop(alone);
        let shared = (lock(LockMode::Shared), lock(LockMode::Shared));
        assert!(shared.0.is_some() && shared.1.is_some() && lock(LockMode::Alone).is_none());
        drop(shared);
        assert!(lock(LockMode::Alone).is_some());
    }

    #[test]
    fn who_holds_it_is_written_there_as_long_as_it_is_held() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("lock");
        let lock = try_lock(&path, LockMode::Alone).unwrap();
        let sign = LockSign::of(path.clone());
        assert!(sign.holder.unwrap().starts_with(&format!("process {}", std::process::id())));
        assert!(sign.touched.is_some());
        drop(lock);
        assert_eq!(LockSign::of(path.clone()).holder, None);
        assert!(std::fs::read(path).unwrap().is_empty());
    }

    #[cfg(unix)]
    #[test]
    fn a_link_in_its_place_gives_way_and_what_it_leads_to_stays() {
        let folder = tempfile::tempdir().unwrap();
        let [path, other] = ["lock", "other"].map(|name| folder.path().join(name));
        std::fs::write(&other, "mine").unwrap();
        std::os::unix::fs::symlink(&other, &path).unwrap();
        assert!(try_lock(&path, LockMode::Alone).unwrap().is_some());
        assert_eq!(std::fs::read_to_string(&other).unwrap(), "mine");
        assert!(path.symlink_metadata().unwrap().is_file());
        std::fs::remove_file(&path).unwrap();
        std::fs::create_dir(&path).unwrap();
        assert!(try_lock(&path, LockMode::Alone).unwrap().is_some());
        assert!(path.is_file(), "as does a folder with nothing in it");
    }

    #[test]
    fn a_copy_of_the_file_does_not_keep_the_lock() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("lock");
        let lock = try_lock(&path, LockMode::Alone).unwrap().unwrap();
        let _copy = lock.file.try_clone().unwrap();
        assert!(try_lock(&path, LockMode::Alone).unwrap().is_none());
        drop(lock);
        assert!(try_lock(&path, LockMode::Alone).unwrap().is_some());
    }

    #[test]
    fn a_file_system_without_locks_is_no_failure() {
        assert!(has_no_locks(&ErrorKind::Unsupported.into()));
        assert!(!has_no_locks(&ErrorKind::PermissionDenied.into()));
        #[cfg(target_os = "linux")]
        assert!(has_no_locks(&io::Error::from_raw_os_error(37)), "ENOLCK");
    }
}
