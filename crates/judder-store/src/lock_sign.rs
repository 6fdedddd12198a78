//! Who holds a lock, and whether that process lives: what it writes into the locked file, and when it has touched it last.

use std::fmt;
use std::fs::{self, File};
use std::io::Seek;
use std::path::{Path, PathBuf};
use std::process;
use std::sync::{Arc, Mutex, PoisonError, Weak};
use std::thread;
use std::time::{Duration, SystemTime};

use crate::{lock, plain};

/// How often a process touches the files that it has locked.
const BEAT: Duration = Duration::from_secs(5);

/// The files that this process has locked, and the process whose thread touches them: a forked one has none.
static HELD: Mutex<(u32, Vec<Weak<File>>)> = Mutex::new((0, Vec::new()));

/// More than anybody writes into a lock: a process and the name of its machine.
const HOLDER_BYTES: u64 = 1 << 12;

/// What is known of a lock that another holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LockSign {
    /// The file that is locked.
    pub file: PathBuf,
    /// The process that has locked it last, and its machine, where it says so.
    pub holder: Option<String>,
    /// When who holds it has touched it last; every five seconds as long as it runs.
    pub touched: Option<SystemTime>,
}

impl LockSign {
    pub(crate) fn of(file: PathBuf) -> Self {
        let holder =
            plain::read_small_file(&file, HOLDER_BYTES).ok().and_then(|text| String::from_utf8(text).ok());
        let holder = holder.map(|text| text.trim().to_owned());
        let touched = fs::metadata(&file).and_then(|metadata| metadata.modified()).ok();
        Self { file, holder: holder.filter(|holder| !holder.is_empty()), touched }
    }
}

impl fmt::Display for LockSign {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let holder = self.holder.as_deref().unwrap_or("another process");
        write!(formatter, "{}, held by {holder}", self.file.display())
    }
}

/// What is known of the lock of a study.
#[must_use]
pub fn lock_sign(study: &Path) -> LockSign {
    LockSign::of(study.join(lock::FILE))
}

/// Names this process in a file that it has locked, and touches it from now on.
pub(crate) fn sign(file: &File, kept: &Arc<File>) {
    // who cannot write it has no name, and is waited for no longer than others
    let write = |mut file: &File| {
        judder_disk::set_length(file, 0)?;
        file.rewind()?;
        judder_disk::write(file, format!("{}\n", own_name()).as_bytes())
    };
    let _ = write(file);
    let mut held = HELD.lock().unwrap_or_else(PoisonError::into_inner);
    held.1.retain(|other| other.strong_count() > 0);
    held.1.push(Arc::downgrade(kept));
    if held.0 != process::id() && thread::Builder::new().name("locks".to_owned()).spawn(beat).is_ok() {
        held.0 = process::id();
    }
}

fn beat() {
    loop {
        thread::sleep(BEAT);
        let held = HELD.lock().unwrap_or_else(PoisonError::into_inner).1.clone();
        for file in held.iter().filter_map(Weak::upgrade) {
            let _ = file.set_modified(SystemTime::now());
        }
    }
}

/// `process 4711 on node-3`; the machine where the system tells its name in a file.
fn own_name() -> String {
    let machine = fs::read_to_string("/proc/sys/kernel/hostname").unwrap_or_default();
    match machine.trim() {
        "" => format!("process {}", process::id()),
        machine => format!("process {} on {machine}", process::id()),
    }
}
