"""The sources: a type has a name of its own, so that a word means one thing wherever it is read."""

import collections
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = sorted(ROOT.glob("crates/*/src/**/*.rs"))
VISIBILITY = r"(?:pub(?:\([^)]*\))?\s+)?"
NAMED = re.compile(rf"\s*{VISIBILITY}(struct|enum|trait|type|union)\s+([A-Z]\w*)")
BODY = re.compile(rf"\s*{VISIBILITY}(?:unsafe\s+)?(?:impl|trait)\b(?!.*\}}$)")


def types(path):
    """Line and name of every type in a file, but for those of test modules and associated ones. As rustfmt has it, a block ends where its first line begins."""
    tests, body, is_next = None, None, False
    for number, line in enumerate(path.read_text("utf-8").splitlines(), start=1):
        margin = line[: len(line) - len(line.lstrip())]
        if tests is not None:
            tests = None if line == tests + "}" else tests
            continue
        if is_next and not line.lstrip().startswith("#["):
            is_next, tests = False, margin if line.endswith("{") else None
            continue
        is_next = is_next or line.strip() == "#[cfg(test)]"
        if body is not None and line == body + "}":
            body = None
        found = NAMED.match(line)
        if found and not (found[1] == "type" and body is not None):
            yield number, found[2]
        if body is None and BODY.match(line):
            body = margin


def test_a_type_has_a_name_of_its_own():
    places = collections.defaultdict(dict)
    for path in SOURCES:
        for number, name in types(path):
            places[name].setdefault(path, f"{path.relative_to(ROOT)}:{number}")
    assert len(places) > 1000
    assert [f"{name}: {', '.join(found.values())}" for name, found in places.items() if len(found) > 1] == []


def test_every_crate_forbids_functions_whose_bits_are_the_machines():
    """Derive macros compute nothing that is stored."""
    line = "#![cfg_attr(not(test), warn(clippy::disallowed_methods))]"
    roots = [path for path in SOURCES if path.name in ("lib.rs", "main.rs") and path.parent.name == "src" and "-derive" not in str(path)]
    assert len(roots) >= 20, len(roots)
    without = [str(path.relative_to(ROOT)) for path in roots if line not in path.read_text("utf-8").splitlines()]
    assert without == []


READS_ARRAYS = re.compile(r"use judder_study::pictures::\{?[^;]*\b(?:reals|complexes|wholes|codes|words)\b|\bread_rows\(")
INDEXES_NOTHING = "#![deny(clippy::indexing_slicing"


def test_what_reads_stored_arrays_indexes_nothing():
    """Stored arrays may be of any length: clippy refuses what would panic."""
    models = [path for path in SOURCES if path.relative_to(ROOT).parts[1] == "judder-models"]
    readers = [path for path in models if READS_ARRAYS.search(path.read_text("utf-8"))]
    whole = [ROOT / "crates" / name for name in ("judder-store/src/lib.rs", "judder-study/src/pictures.rs", "judder-report/src/runs.rs")]
    assert len(readers) > 20
    assert [str(path.relative_to(ROOT)) for path in readers + whole if INDEXES_NOTHING not in path.read_text("utf-8")] == []


CHANGES_A_DISK = re.compile(
    r"\bfs::(?:write|copy|rename|hard_link|set_permissions|(?:create|remove)_\w+)\b|\bFile::(?:create|create_new|options)\b"
    r"|\.(?:create|create_new)\(true\)|\.(?:sync_all|sync_data|set_len)\(|\btempfile::"
)
WRITERS = ("judder-store", "judder-study", "judder-exchange", "judder-examples")


def test_what_is_written_goes_through_one_crate():
    """A call that is made elsewhere is none that the tests of faults can make fail."""
    written = [path for path in SOURCES if path.relative_to(ROOT).parts[1] in WRITERS]
    without_tests = {path: path.read_text("utf-8").split("#[cfg(test)]")[0].split("#[cfg(all(test")[0] for path in written}
    code = {path: re.sub(r"//.*", "", text) for path, text in without_tests.items()}
    assert len(code) > 100
    assert {str(path.relative_to(ROOT)): found for path, text in code.items() if (found := CHANGES_A_DISK.findall(text))} == {}
    assert CHANGES_A_DISK.search((ROOT / "crates/judder-disk/src/calls.rs").read_text("utf-8"))
