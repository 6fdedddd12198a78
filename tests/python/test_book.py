"""The book: every chapter is reachable, every link and include leads somewhere, every case file is accepted."""

import pathlib
import re
import subprocess
import unicodedata

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BOOK = ROOT / "docs" / "src"
CHAPTERS = sorted(BOOK.rglob("*.md"))
CASES = sorted((ROOT / "cases").rglob("*.toml"))


def relative(path):
    return str(path.relative_to(ROOT))


def without_code(text):
    return re.sub(r"`[^`\n]*`", "", re.sub(r"^```.*?^```", "", text, flags=re.DOTALL | re.MULTILINE))


def anchors(chapter):
    """The anchors that mdBook gives to the headings of a chapter."""
    headings = re.findall(r"^#+ (.*)$", without_code(chapter.read_text("utf-8")), flags=re.MULTILINE)
    plain = (unicodedata.normalize("NFC", heading).lower().strip() for heading in headings)
    return {re.sub(r"[^\w\- ]", "", heading).replace(" ", "-") for heading in plain}


@pytest.mark.parametrize("chapter", CHAPTERS, ids=relative)
def test_links_lead_somewhere(chapter):
    for target in re.findall(r"\]\(([^)\s]+)\)", without_code(chapter.read_text("utf-8"))):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        linked = (chapter.parent / path).resolve() if path else chapter
        assert linked.is_file(), f"{relative(chapter)} links to {target}"
        assert not anchor or anchor in anchors(linked), f"{relative(chapter)} links to {target}"


@pytest.mark.parametrize("chapter", CHAPTERS, ids=relative)
def test_includes_exist(chapter):
    for target in re.findall(r"\{\{#include ([^}]+)\}\}", chapter.read_text("utf-8")):
        assert (chapter.parent / target.strip()).is_file(), f"{relative(chapter)} includes {target}"


def test_every_chapter_is_in_the_summary():
    summary = (BOOK / "SUMMARY.md").read_text("utf-8")
    linked = {(BOOK / target).resolve() for target in re.findall(r"\]\(([^)]+\.md)\)", summary)}
    assert linked == set(CHAPTERS) - {BOOK / "SUMMARY.md"}


@pytest.mark.parametrize("case", CASES, ids=relative)
def test_cases_are_accepted(judder, case):
    command = [judder, "check", case]
    folder = re.search(r'^folder = "(.+)"', case.read_text("utf-8"), re.MULTILINE)
    if folder:
        data = ROOT.parent / "shared" / "data" / folder[1]
        if not data.is_dir():
            pytest.skip(f"SKIPPED: {data}, which the case needs and the project does not hold, is not there")
        command += ["--set", f"matrices.folder={data}"]
    check = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert check.returncode == 0, check.stderr
