"""What a release says of itself: links of its index page, its citation, its licences."""

import importlib.machinery
import importlib.util
import pathlib
import re
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
ADDRESS = "https://forge.example/people/judder"


def tool(name):
    """A script of tools/dist as a module."""
    loader = importlib.machinery.SourceFileLoader(name, str(ROOT / "tools/dist" / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


def targets(text):
    return re.findall(r"\]\(([^)\s]+)\)", re.sub(r"^```.*?^```", "", text, flags=re.DOTALL | re.MULTILINE))


def test_every_link_of_the_index_page_is_absolute_and_leads_to_a_file():
    text = (ROOT / "README.md").read_text("utf-8")
    written = tool("stage").absolute(text, ADDRESS, "0123abcd")
    links = targets(written)
    assert len(links) == len(targets(text)) > 20
    for link in links:
        assert re.match(r"https?://|#", link), link
        kind, _, path = link.removeprefix(f"{ADDRESS}/").partition("/0123abcd/")
        if path:
            assert (kind, path.endswith(".png")) in (("raw", True), ("blob", False)), link
            assert (ROOT / path.partition("#")[0]).is_file(), link


def test_without_an_address_no_link_of_the_index_page_leads_nowhere():
    text = (ROOT / "README.md").read_text("utf-8")
    written = tool("stage").unlinked(text)
    kept = targets(written)
    assert kept and set(kept) < set(targets(text)), "absolute links stay"
    assert [link for link in kept if not re.match(r"https?://|#", link)] == []
    for words in re.findall(r"\[([^\]\[]+)\]\(", text):
        assert words in written, words


def test_the_citation_has_the_version_of_the_crates():
    version = tomllib.loads((ROOT / "Cargo.toml").read_text("utf-8"))["workspace"]["package"]["version"]
    assert f"\nversion: {version}\n" in (ROOT / "CITATION.cff").read_text("utf-8")


def test_licences_follow_what_is_linked_alone():
    """Of a program: what it is linked from, not what its tests need or what builds it."""

    def link(name, *kinds):
        return {"pkg": name, "dep_kinds": [{"kind": kind} for kind in kinds]}

    nodes = {
        "judder-cli": [link("a", None), link("tests", "dev"), link("builds", "build")],
        "a": [link("b", "build", None)],
        "judder-python": [],
        "b": [],
        "tests": [],
        "builds": [],
    }
    metadata = {
        "packages": [{"id": name, "name": name, "version": "1.0.0"} for name in nodes],
        "resolve": {"nodes": [{"id": name, "deps": deps} for name, deps in nodes.items()]},
    }
    assert [package["name"] for package in tool("licences").linked(metadata)] == ["a", "b", "judder-cli", "judder-python"]
