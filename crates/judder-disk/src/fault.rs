//! A disk that fails at the n-th call.

use std::env;
use std::fmt;
use std::io::{self, ErrorKind};
use std::path::Path;
use std::process;
use std::sync::LazyLock;
use std::sync::atomic::{AtomicU64, Ordering};

/// The variable of the environment that asks for a fault: `full@17`, `broken@17`, `end@17`. Nothing reads it in a program without debug assertions.
pub const FAULT_VARIABLE: &str = "JUDDER_DISK_FAULT";

/// What a call does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Call {
    CreateFolder,
    CreateFile,
    Write,
    SetLength,
    Sync,
    Rename,
    Exchange,
    Remove,
}

impl Call {
    /// Whether a full disk refuses it.
    fn takes_room(self) -> bool {
        matches!(self, Self::CreateFolder | Self::CreateFile | Self::Write)
    }
}

/// How a disk fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum DiskFault {
    /// It is full, from a call on.
    Full,
    /// One call fails.
    Broken,
    /// The process ends before a call.
    End,
}

impl DiskFault {
    /// Ends the process, or says how the call fails.
    pub(crate) fn strike(self) -> io::Error {
        match self {
            Self::Full => ErrorKind::StorageFull.into(),
            Self::Broken => io::Error::other("input/output error"),
            Self::End => process::abort(),
        }
    }
}

/// The fault that was asked for.
#[derive(Debug)]
struct AskedFault {
    fault: DiskFault,
    at: u64,
    passed: AtomicU64,
}

static ASKED: LazyLock<Option<AskedFault>> =
    LazyLock::new(|| AskedFault::read(&env::var(FAULT_VARIABLE).ok()?));

impl AskedFault {
    fn read(text: &str) -> Option<Self> {
        let (fault, at) = text.split_once('@')?;
        let fault = match fault {
            "full" => DiskFault::Full,
            "broken" => DiskFault::Broken,
            "end" => DiskFault::End,
            _ => return None,
        };
        Some(Self { fault, at: at.parse().ok()?, passed: AtomicU64::new(0) })
    }

    /// Counts a call; the fault where it strikes it.
    fn count(&self, call: Call, told: impl fmt::Display) -> Option<DiskFault> {
        let number = self.passed.fetch_add(1, Ordering::Relaxed) + 1;
        if number == self.at {
            eprintln!("the disk fails at call {number}: {call:?} {told}");
        }
        let is_struck = match self.fault {
            DiskFault::Full => number >= self.at && call.takes_room(),
            DiskFault::Broken | DiskFault::End => number == self.at,
        };
        is_struck.then_some(self.fault)
    }
}

/// The fault that strikes this call.
pub(crate) fn due(call: Call, path: Option<&Path>) -> Option<DiskFault> {
    if !cfg!(debug_assertions) {
        return None;
    }
    ASKED.as_ref()?.count(call, path.unwrap_or(Path::new("(an open file)")).display())
}

/// Fails where a fault strikes this call.
pub(crate) fn pass(call: Call, path: &Path) -> io::Result<()> {
    due(call, Some(path)).map_or(Ok(()), |fault| Err(fault.strike()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_full_disk_stays_full_and_a_broken_call_is_one() {
        let struck = |text: &str, calls: &[Call]| {
            let asked = AskedFault::read(text).unwrap();
            calls.iter().map(|call| asked.count(*call, "it").is_some()).collect::<Vec<_>>()
        };
        let calls = [Call::Write, Call::Sync, Call::Rename, Call::Write, Call::Remove, Call::CreateFile];
        assert_eq!(struck("full@2", &calls), [false, false, false, true, false, true]);
        assert_eq!(struck("broken@3", &calls), [false, false, true, false, false, false]);
        assert_eq!(struck("end@7", &calls), [false; 6]);
        assert!(AskedFault::read("full").is_none() && AskedFault::read("slow@3").is_none());
    }
}
