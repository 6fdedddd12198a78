"""Pictures: the colours of the program's own, areas and boundaries where the numbers have them."""

import dataclasses
import re

import matplotlib
import numpy as np
import pytest

matplotlib.use("agg")

import matplotlib.pyplot as pyplot

import judder
from common import ROOT

PALETTE = ROOT / "crates" / "judder-report" / "src" / "palette.rs"



def test_the_colours_are_those_of_the_program():
    text = PALETTE.read_text("utf-8")
    roles = dict(re.findall(r"Self::(\w+) => Colour\((0x.*?)\)", text))
    series = re.search(r"QUALITATIVE.*?= \[(.*?)\];", text, flags=re.DOTALL).group(1)

    def hexadecimal(channels):
        return "#" + "".join(re.findall(r"0x(\w\w)", channels))

    assert [hexadecimal(one) for one in re.findall(r"Colour\((.*?)\)", series)] == list(judder.plot.SERIES)
    for name in ("stable", "flutter", "negative-damping", "both", "normal-force-coupling", "destabilised-by-damping", "unresolved", "decoupled-boundary"):
        role = "".join(word.capitalize() for word in name.split("-"))
        assert hexadecimal(roles[role]) == judder.plot.COLOURS[name], name


@pytest.fixture
def axes():
    figure, made = pyplot.subplots()
    yield made
    pyplot.close(figure)


def names(axes):
    return [text.get_text() for text in axes.get_legend().get_texts()]


def test_a_map_is_drawn_with_the_classes_that_occur(axes):
    found = judder.oscillator.stability_map(("velocity", np.logspace(-6, 0, 20), "m/s"), ("shear_strength", np.linspace(0, 0.2, 10)))
    assert judder.plot.stability(found, ax=axes) is axes
    assert (axes.get_xscale(), axes.get_yscale()) == ("log", "linear")
    assert "m/s" in axes.get_xlabel() and axes.get_xlim() == (1e-6, 1.0)
    assert names(axes)[0] == "stable" and "unresolved" not in names(axes) and not axes.lines
    drawn = axes.collections[0]
    assert (drawn.get_array().reshape(found.classes.shape) == found.classes).all()
    seen = {matplotlib.colors.to_hex(drawn.to_rgba(code)) for code in np.unique(found.classes)}
    assert seen == {judder.plot.COLOURS[judder.oscillator.CLASSES[code]] for code in np.unique(found.classes)}


def test_what_the_law_does_not_decide_is_crossed_out(axes):
    found = judder.oscillator.stability_map(("velocity", np.logspace(-6, 0, 20)), ("shear_strength", np.linspace(0, 0.2, 10)))
    judder.plot.stability(found, ax=axes)
    assert "marginal within the law" not in names(axes)
    axes.clear()
    is_open = np.zeros(found.classes.shape, np.uint8)
    is_open[2:5, 3:9] = 1
    judder.plot.stability(dataclasses.replace(found, within_law=is_open), ax=axes)
    assert "marginal within the law" in names(axes)
    assert any("x" in hatch for hatch in axes.collections[1].hatches)


def test_the_map_of_a_case_has_its_boundaries(axes, map_case, tmp_path):
    study = judder.run(map_case, output=tmp_path, only=["map"])
    judder.plot.stability(study["map"], ax=axes, legend=False)
    assert axes.get_legend() is None and len(axes.lines) == 3


def test_the_map_of_a_general_system_is_drawn_in_the_same_colours(axes, tmp_path):
    study = judder.run(ROOT / "cases" / "benchmarks" / "damped-hopf.toml", output=tmp_path, only=["map"])
    data = study["map"]
    assert "destabilised-by-damping" in data.stability.attrs["flag_meanings"]
    judder.plot.stability(data, ax=axes)
    assert "mu" in axes.get_xlabel() and axes.get_yscale() == "log"
    classes = data.stability.attrs["flag_meanings"].split()
    assert names(axes)[: len(np.unique(data.stability))] == [classes[code].replace("-", " ") for code in np.unique(data.stability)]


def test_what_is_no_map_is_named():
    found = judder.oscillator.stability_map(("velocity", [1e-6, 1e-4]), ("shear_strength", [0.01, 0.1])).to_dataset().drop_vars("stability")
    for wrong, has in ((found, "a dataset of"), (3, "3")):
        with pytest.raises(judder.InputError, match=f"found: a stability map is needed, not {has}"):
            judder.plot.stability(wrong)
