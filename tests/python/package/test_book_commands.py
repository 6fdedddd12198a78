"""The commands of the book, page by page, as they are typed: every one is accepted, and what is quick is run, with the Python that follows it."""

import json
import os
import re
import shlex
import subprocess
import sys

import pytest

from common import ROOT

# what `judder check` estimates at most of a page that is run here
QUICK_SECONDS = 20
BOOK = ROOT / "docs" / "src"
# its meshes come of Gmsh: tests/python/test_two_meshes.py
ELSEWHERE = {"docs/src/tutorials/two-meshes.md"}


def typed(page):
    """The commands of a page, split into words; those of schedulers, whose words are variables or places of a cluster, are not for a desk."""
    blocks = re.findall(r"^```sh\n(.*?)^```", page.read_text("utf-8"), flags=re.DOTALL | re.MULTILINE)
    lines = (line for block in blocks for line in block.splitlines())
    found = [shlex.split(line, comments=True) for line in lines if line.startswith("judder ") and not re.search(r"\$|/scratch", line)]
    return [words[1:] for words in found]


PAGES = {page.relative_to(ROOT).as_posix(): typed(page) for page in sorted(BOOK.rglob("*.md"))}
PAGES = {name: commands for name, commands in PAGES.items() if commands and name not in ELSEWHERE}


@pytest.fixture
def desk(tmp_path, monkeypatch):
    """A folder with the cases and the book, in which a page is typed; cases of the tutorials lie there under their bare names too."""
    for name in ("cases", "docs"):
        (tmp_path / name).symlink_to(ROOT / name)
    for path in (ROOT / "cases/tutorials").iterdir():
        (tmp_path / path.name).symlink_to(path)
    (tmp_path / "case.toml").symlink_to(ROOT / "cases/tutorials/first-map.toml")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def checked(words):
    """The command that checks the case of another command, with the same numbers; nothing where it takes no case."""
    cases = [word for word in words if word.endswith(".toml")]
    settings = [["--set", words[k + 1]] for k, word in enumerate(words) if word == "--set"]
    return ["check", *cases, *sum(settings, [])] if cases else None


@pytest.mark.parametrize("page", PAGES)
def test_every_command_of_a_page_is_accepted(page, desk, command):
    for words in filter(None, map(checked, PAGES[page])):
        done = command(*words)
        assert done.returncode == 0, f"judder {shlex.join(words)}\n{done.stderr}"


def seconds(command, words):
    document = json.loads(command(*checked(words), "--json").stdout)
    return sum(part.get("seconds", 0.0) for part in document.get("estimate", []))


def is_quick(command, page):
    """Whether all that the page types has an end, and a near one."""
    commands = PAGES[page]
    return all(words[0] in ("check", "point", "run") for words in commands) and sum(seconds(command, words) for words in commands) < QUICK_SECONDS


@pytest.mark.expensive
@pytest.mark.parametrize("page", PAGES)
def test_a_quick_page_runs_as_typed_with_its_python(page, desk, command):
    if not is_quick(command, page):
        pytest.skip("takes longer, or waits for a reader")
    for words in PAGES[page]:
        done = command(*words)
        assert done.returncode == 0, f"judder {shlex.join(words)}\n{done.stderr}"
    code = re.findall(r"^```python\n(.*?)^```", (ROOT / page).read_text("utf-8"), flags=re.DOTALL | re.MULTILINE)
    script = desk / "page.py"
    script.write_text("\n".join(block for block in code if "{{#include" not in block), "utf-8")
    done = subprocess.run([sys.executable, script], capture_output=True, text=True, env={**os.environ, "MPLBACKEND": "agg"})
    assert done.returncode == 0, done.stderr


def test_there_are_pages_with_commands():
    assert len(PAGES) > 15 and sum(map(len, PAGES.values())) > 25
