//! What the system says is free: Linux writes it into files, of other systems nothing is known here.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// What was read is as good for so long: a dozen files take half a millisecond, a quarter of a small run in memory, and nobody fills a machine sooner.
const GOOD_FOR: Duration = Duration::from_millis(50);

/// What the system said, and when.
static READ: Mutex<Option<(Instant, SystemMemory)>> = Mutex::new(None);

/// What the system says of memory.
#[derive(Debug, Clone, Copy)]
pub(super) struct SystemMemory {
    /// The least of what the machine, the control groups and the address space of the process have left; none where nothing says.
    pub(super) free: Option<u64>,
    /// What this process holds; none where nothing says.
    pub(super) resident: Option<u64>,
}

/// What it says now.
pub(super) fn system_memory() -> SystemMemory {
    let read = || SystemMemory { free: free_bytes(), resident: resident_bytes() };
    // who finds it held reads as well: a process that is forked meanwhile would wait for ever
    let Ok(mut kept) = READ.try_lock() else { return read() };
    match *kept {
        Some((at, memory)) if at.elapsed() < GOOD_FOR => memory,
        _ => kept.insert((Instant::now(), read())).1,
    }
}

/// The least of what the machine, the control groups and the address space of the process have left; none where nothing says.
fn free_bytes() -> Option<u64> {
    let machine = fs::read_to_string("/proc/meminfo").ok().and_then(|text| available(&text));
    let groups = fs::read_to_string("/proc/self/cgroup").ok().and_then(|text| left_in_groups(&text));
    [machine, groups, left_in_address_space()].into_iter().flatten().min()
}

/// What this process holds; none where nothing says.
fn resident_bytes() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    kibibytes(status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?)
}

/// `MemAvailable` of `/proc/meminfo`.
fn available(text: &str) -> Option<u64> {
    kibibytes(text.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?)
}

/// `  2048 kB`.
fn kibibytes(text: &str) -> Option<u64> {
    text.split_whitespace().next()?.parse::<u64>().ok()?.checked_mul(1024)
}

/// What the groups of the process and those above leave; both versions of control groups.
fn left_in_groups(text: &str) -> Option<u64> {
    let groups = text.lines().filter_map(|line| {
        let mut fields = line.splitn(3, ':').skip(1);
        let (controllers, path) = (fields.next()?, fields.next()?);
        let root = Path::new("/sys/fs/cgroup");
        let in_root = |root: PathBuf| (root.join(path.trim_start_matches('/')), root);
        match controllers {
            "" => Some((in_root(root.to_owned()), ["memory.max", "memory.current", "inactive_file"])),
            of if of.split(',').any(|controller| controller == "memory") => Some((
                in_root(root.join("memory")),
                ["memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"],
            )),
            _ => None,
        }
    });
    let left = groups.flat_map(|((folder, root), names)| {
        // a process in a container may see its own group as the root, whatever its path says
        let above: Vec<PathBuf> =
            folder.ancestors().take_while(|folder| folder.starts_with(&root)).map(Path::to_owned).collect();
        above.into_iter().filter_map(move |folder| left_in_group(&folder, names))
    });
    left.min()
}

/// What a group leaves: its limit less what is used, but for what can be dropped.
fn left_in_group(folder: &Path, [limit, usage, droppable]: [&str; 3]) -> Option<u64> {
    let number = |name: &str| fs::read_to_string(folder.join(name)).ok()?.trim().parse::<u64>().ok();
    let (limit, used) = (number(limit)?, number(usage)?);
    let statistics = fs::read_to_string(folder.join("memory.stat")).unwrap_or_default();
    let dropped =
        statistics.lines().find_map(|line| line.strip_prefix(droppable)?.trim().parse::<u64>().ok());
    Some(limit.saturating_sub(used.saturating_sub(dropped.unwrap_or(0))))
}

/// What `ulimit -v` leaves.
fn left_in_address_space() -> Option<u64> {
    let limits = fs::read_to_string("/proc/self/limits").ok()?;
    let limit = limits.lines().find_map(|line| line.strip_prefix("Max address space"))?;
    let limit: u64 = limit.split_whitespace().next()?.parse().ok()?;
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let used = kibibytes(status.lines().find_map(|line| line.strip_prefix("VmSize:"))?)?;
    Some(limit.saturating_sub(used))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_machine_has_left_is_read() {
        let text = "MemTotal:       24614000 kB\nMemFree:  1 kB\nMemAvailable:   23000000 kB\n";
        assert_eq!(available(text), Some(23_000_000 * 1024));
        assert_eq!(available("MemTotal: 1 kB\n"), None);
    }

    #[test]
    fn a_group_leaves_its_limit_without_what_is_used() {
        let folder = std::env::temp_dir().join(format!("judder-memory-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let names = ["memory.max", "memory.current", "inactive_file"];
        let left = |limit: &str| {
            fs::write(folder.join("memory.max"), limit).unwrap();
            fs::write(folder.join("memory.current"), "700\n").unwrap();
            fs::write(folder.join("memory.stat"), "anon 500\ninactive_file 200\n").unwrap();
            left_in_group(&folder, names)
        };
        assert_eq!(left("1000\n"), Some(500));
        assert_eq!(left("100\n"), Some(0));
        assert_eq!(left("max\n"), None);
        fs::remove_dir_all(&folder).unwrap();
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn linux_says_what_is_free_and_what_is_held() {
        assert!(free_bytes().is_some());
        let held = vec![1_u8; 64 << 20];
        let resident = resident_bytes().unwrap();
        assert!(resident > held.iter().map(|byte| u64::from(*byte)).sum(), "{resident}");
    }
}
