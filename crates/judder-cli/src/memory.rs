//! How much memory a command takes at most.

use clap::Args;
use judder_keys::memory::Memory;
use judder_memory::MemoryBudget;

/// The option `--memory`.
#[derive(Debug, Clone, Copy, Args)]
#[command(next_help_heading = "Everywhere")]
pub(crate) struct MemoryLimit {
    /// Memory to take at most, as in "4 GiB" [default: three quarters of what is free]; what would need more is refused before it is computed
    #[arg(long, global = true, value_name = "AMOUNT", value_parser = parse, allow_hyphen_values = true)]
    memory: Option<Memory>,
}

fn parse(text: &str) -> Result<Memory, String> {
    Memory::parse(text).ok_or_else(|| format!("give {}", Memory::form()))
}

impl MemoryLimit {
    /// Makes it the budget of this process.
    pub(crate) fn tell(self) {
        if let Some(memory) = self.memory {
            MemoryBudget::tell(memory.bytes);
        }
    }
}
