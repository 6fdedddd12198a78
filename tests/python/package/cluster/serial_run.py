"""What a serial run leaves, to compare with."""

import subprocess
import sys


def files(folder):
    """Every file below a folder with its bytes, by its relative path."""
    paths = (path for path in sorted(folder.rglob("*")) if path.is_file())
    return {str(path.relative_to(folder)): path.read_bytes() for path in paths}


def serial(case, folder, sweep):
    """What the command leaves of a sweep on one thread."""
    words = [sys.executable, "-m", "judder", "run", str(case), "-o", str(folder), "--only", sweep, "--threads", "1", "-q"]
    subprocess.run(words, check=True)
    return files(folder / "results.zarr" / sweep)
