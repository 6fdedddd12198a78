"""What an install line leaves in a new environment, and nothing else: links to the packages of this one, for another interpreter."""

import importlib.metadata
import os
import re
import subprocess
import sys

from packaging.requirements import Requirement

_EXTRAS = re.compile(r"pip install '(?:\.|judder)\[([\w,]+)\]'")


def extras(text):
    """The extras of judder that the install lines of a page name."""
    return {extra for line in _EXTRAS.findall(text) for extra in line.split(",")}


def environment(folder, wanted):
    """Links in a folder to judder with these extras and to all that these need; gives back the folder."""
    seen, left = set(), [("judder", frozenset(wanted))]
    folder.mkdir()
    while left:
        name, own = left.pop()
        if (name, own) in seen:
            continue
        seen.add((name, own))
        found = importlib.metadata.distribution(name)
        for requirement in map(Requirement, found.requires or []):
            if requirement.marker is None or any(requirement.marker.evaluate({"extra": extra}) for extra in ("", *own)):
                left.append((requirement.name, frozenset(requirement.extras)))
        for top in {path.parts[0] for path in found.files} - {"..", "__pycache__"}:
            if not (folder / top).exists():
                (folder / top).symlink_to(found.locate_file(top))
    return folder


def python(packages, script, cwd):
    """Runs a script with these packages and those of Python itself."""
    settings = {"PYTHONPATH": str(packages), "MPLBACKEND": "agg", "MPLCONFIGDIR": str(packages.parent / "matplotlib")}
    # -S: nothing of the environment that runs this
    return subprocess.run([sys.executable, "-S", str(script)], capture_output=True, text=True, cwd=cwd, env={**os.environ, **settings})
