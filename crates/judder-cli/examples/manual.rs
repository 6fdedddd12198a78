//! Writes the manual pages of the command, one a subcommand, into a folder.

use std::env;
use std::fs;
use std::io;
use std::path::PathBuf;

fn main() -> io::Result<()> {
    let folder = env::args_os().nth(1).map(PathBuf::from);
    let Some(folder) = folder else {
        return Err(io::Error::new(io::ErrorKind::InvalidInput, "usage: manual FOLDER"));
    };
    fs::create_dir_all(&folder)?;
    clap_mangen::generate_to(judder_cli::command_line(), folder)
}
