"""What is wrong with objects, functions and tables of Python is said of them, not of files that judder writes in between."""

import json
import re
import warnings

import numpy as np
import pytest
import scipy.sparse

import judder
from judder import _said_of_objects

FREQUENCY = np.logspace(-2, 4, 40)
MODULUS = 1e6 + 9e6 * 2j * np.pi * FREQUENCY * 0.01 / (1 + 2j * np.pi * FREQUENCY * 0.01)
OF_FILES = ("inputs/", ".csv", ".npz", ".json", ".inp", ".npy", "header", "(from 1)", "judder-", "case.toml")


def said(call, *words):
    """The error of a call and all that goes with it, which speaks of no file."""
    with pytest.raises(judder.JudderError) as caught:
        call()
    error = caught.value
    whole = "\n".join([str(error), str(error.fields), *getattr(error, "__notes__", [])])
    assert not [word for word in OF_FILES if word in whole] and not re.search(r"\bline \d", whole), whole
    assert all(word in whole for word in words), whole
    return error


def of_dma(columns, **law):
    return lambda: judder.check({"model": "oscillator", "contact": law, "substrate": {"dma": columns}})


@pytest.mark.parametrize("law", [{"law": "hertz"}, {}], ids=["a law of any substrate", "the law of one time"])
@pytest.mark.parametrize(
    ("columns", "words"),
    [
        ({"frequency": FREQUENCY, "E [Pa]": MODULUS}, ["the column `frequency` is without a unit", "`Hz`, `rad/s`"]),
        ({"frequency [Hz]": FREQUENCY, "E [psi]": MODULUS}, ["the column `E [psi]` is without a unit"]),
        ({"frequency [Hz]": FREQUENCY, "G' [Pa]": MODULUS.real, "G'' [Pa]": MODULUS.imag}, ["it has the columns `frequency [Hz]`, `G' [Pa]`"]),
        ({"f [Hz]": FREQUENCY, "omega [rad/s]": FREQUENCY, "E [Pa]": MODULUS}, ["two columns for the frequency"]),
        ({"frequency [Hz]": FREQUENCY[::-1], "E [Pa]": MODULUS}, ["the frequency in row 1 (from 0)", "sort the rows"]),
        ({"frequency [Hz]": FREQUENCY, "E [Pa]": MODULUS.conj()}, ["the loss modulus in row 0 (from 0)", "e^(−iωt)", "conjugate"]),
        ({"frequency [Hz]": FREQUENCY, "E [Pa]": np.where(FREQUENCY > 1, np.nan, MODULUS)}, ["`substrate.dma.E [Pa]` has nan at"]),
        ({"frequency [Hz]": FREQUENCY, "E [Pa]": abs(MODULUS)}, ["`substrate.dma.E [Pa]`", "complex moduli E' + iE''"]),
        ({"frequency [Hz]": FREQUENCY, "G [Pa]": MODULUS}, ["`substrate.dma.G [Pa]`", "are called `E`"]),
        ({}, ["`substrate.dma` is an empty table", "columns of measured moduli"]),
    ],
)
def test_what_is_wrong_with_measured_moduli_is_said_of_columns_and_rows(columns, words, law):
    error = said(of_dma(columns, **law), "`substrate.dma", *words)
    assert isinstance(error, judder.InputError) and isinstance(error, ValueError) and error.argument.startswith("substrate.dma")
    assert "decimal point" not in str(error) and ("E [Pa]" not in columns or "dma.E' [Pa]" not in str(error))


@pytest.mark.parametrize("unit", ["N/mm^2", "N/mm²", "N/mm2", "MPa"])
def test_moduli_are_read_in_newtons_per_square_millimetre(unit):
    assert judder.check({"model": "oscillator", "contact": {"law": "hertz"}, "substrate": {"dma": {"frequency [Hz]": FREQUENCY, f"E [{unit}]": MODULUS / 1e6}}})


def test_a_law_of_one_time_is_refused_where_nothing_is_wrong_with_the_moduli():
    said(of_dma({"frequency [Hz]": FREQUENCY, "E [Pa]": MODULUS, "terms": 3}), "one retardation time only")


def of_matrices(**matrices):
    return lambda: judder.models.Structure(matrices=matrices).modes(count=1)


def test_what_is_wrong_with_matrices_is_said_of_keys_and_entries():
    three, four = scipy.sparse.eye_array(3), scipy.sparse.eye_array(4)
    said(of_matrices(mass=three, stiffness=four), "`matrices.mass` has 3 rows", "`matrices.stiffness` has 4")
    gap = scipy.sparse.diags_array([1.0, 0.0, 1.0])
    said(of_matrices(mass=gap, stiffness=three), "row 1 (from 0)")
    lower = {"file": scipy.sparse.csr_array(np.array([[1.0, 0, 0], [2, 1, 0], [0, 0, 1]])), "triangle": "upper"}
    said(of_matrices(mass=three, stiffness=lower), "`matrices.stiffness`", "[1, 0]")
    said(of_matrices(mass=three, stiffness=three, freedoms=[(1, "x")]), "table of freedoms has 1 rows")


def test_texts_are_no_matrix():
    texts = np.array([["1", "0"], ["0", "1"]])
    error = said(of_matrices(mass=texts, stiffness=np.eye(2)), "matrices.mass", "texts")
    assert isinstance(error, judder.InputError)
    said(lambda: judder.check({"model": "structure", "matrices": {"mass": np.eye(2), "stiffness": [texts]}}), "matrices.stiffness", "texts")


def test_what_is_wrong_with_friction_is_said_of_columns():
    def belt(friction):
        return lambda: judder.check({"model": "belt", "friction": friction, "operation": {"velocity": 0.2}})

    speeds = np.array([0.0, 1.0])
    said(belt({"file": {"speed": speeds, "coefficient": speeds, "other": speeds}}), "`friction`", "it has 3 columns")
    said(belt({"file": {0: speeds, 1: speeds}}), "its first column is called `0`")
    said(belt({"file": {"speed [V]": speeds, "coefficient": speeds}}), "`friction`", "`V` is no unit of")
    said(belt((speeds[::-1], speeds)), "ascend")
    said(belt({"file": {"speed": speeds, "coefficient": 1j * speeds}}), "`friction.coefficient`", "complex numbers")


def test_warnings_speak_of_keys_too(recwarn):
    friction = {"file": np.array([[0.0, 4e6], [-4e6, 0.0]]), "factor": "mu"}
    case = {"parameters": {"mu": 0.5}, "matrices": {"mass": np.eye(2), "stiffness": {"bodies": np.diag([3e6, 1e6]), "friction": friction}}}
    region = {"re": [-1e3, 1e3], "im": [0.0, 1e4]}
    found = judder.models.Structure(**case).eigen(region=region)
    study = judder.run({"model": "structure", **case, "analysis": [{"kind": "eigen", "name": "modes", "region": region}]})
    told = [str(own.message) for own in recwarn if own.category is judder.JudderWarning]
    for of_one in (told[:1], told[1:], found.warnings, study.warnings["modes"]):
        assert any("without `matrices.stiffness.friction`" in own for own in of_one), of_one
    assert not [own for own in [*told, *found.warnings, *study.warnings["modes"]] for word in OF_FILES if word in own]


def test_names_of_files_of_ones_own_stay(tmp_path):
    scipy.sparse.save_npz(tmp_path / "mass.npz", scipy.sparse.eye_array(3).tocsr())
    with pytest.raises(judder.JudderError, match="mass.npz has 3 rows") as caught:
        of_matrices(mass=[{"file": str(tmp_path / "mass.npz")}], stiffness=np.eye(4))()
    assert "`matrices.stiffness` has 4" in str(caught.value)
    objects = {"inputs/a.csv": _said_of_objects.HeldObject("a"), "inputs/a.csv-2.csv": _said_of_objects.HeldObject("b")}
    assert _said_of_objects.said("inputs/a.csv-2.csv: line 4: no; my.csv is", objects, "/of/ours") == "`b`: row 2 (from 0): no; my.csv is"


def test_a_wrong_table_of_python_has_no_line_in_a_file():
    error = said(lambda: judder.check({"model": "oscillator", "operation": {"velocity": "30 N"}}), "operation.velocity", "30 mm/s")
    assert (error.file, error.line, error.column, error.key) == ("tables", None, None, "operation.velocity")
    said(lambda: judder.check({"model": "oscillator", "operatoin": {}}), "operatoin")
    said(lambda: judder.run({}), "is an empty mapping", "model")


@pytest.mark.parametrize("case", [{"operation": {"velocity": None}}, {"title": None}, {"substrate": {"prony": [{"time": "1 s", "compliance": None}]}}])
def test_none_is_refused_in_tables(case):
    said(lambda: judder.check({"model": "oscillator", **case}), "is None; leave the key out")
    said(lambda: judder.check({"model": "oscillator"}, set=case), "is None; leave the key out")


@pytest.mark.parametrize("memory", ["1 kB", 1.5, None, True, [1]])
def test_memory_is_a_number_of_bytes(memory):
    calls = (
        lambda: judder.run({"model": "oscillator"}, memory=memory),
        lambda: judder.contact.solve(0.1, indentation=1e-2, memory=memory),
    )
    for call in calls:
        error = said(call, f"memory: is {memory!r}, and a whole number of bytes is needed, such as 1073741824 for 1 GiB")
        assert isinstance(error, judder.ArgumentError)
    with pytest.raises(judder.NumberError, match="memory: is -1"):
        judder.run({"model": "oscillator"}, memory=-1)
    assert judder.run({"model": "oscillator"}, memory=np.int64(1 << 20)).complete


def test_what_a_function_raises_is_its_own_with_a_note_of_the_key():
    def broken(*_):
        raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="^mine") as caught:
        judder.check({"model": "belt", "friction": broken, "operation": {"velocity": 0.2}})
    assert caught.value.__notes__ == ["raised by the function that was given as `friction`"]
    with pytest.raises(ZeroDivisionError, match="^mine") as caught:
        judder.contact.Law.from_function(broken, velocity=(0.1, 1.0), indentation=(0.1, 1.0))
    assert caught.value.__notes__ == ["raised by the function that was given to `judder.contact.Law.from_function`"]


@pytest.mark.parametrize(
    ("function", "words"),
    [
        (lambda v, y: (1.0, 1.0, 0.3), "must rise with the indentation"),
        (lambda v, y: (y, y, np.nan * v), "friction of the function"),
        (lambda v, y: (y, np.inf * y, 0.3), "area of the function"),
        (lambda v, y: (y, y[:2], 0.3), "area"),
        (lambda v, y: (y, y, v * 1j), "real numbers"),
        (lambda v, y: (y, y), "three arrays"),
    ],
)
def test_a_function_that_makes_no_law_is_refused(function, words):
    with pytest.raises(judder.InputError, match=words):
        judder.contact.Law.from_function(function, velocity=(0.1, 1.0), indentation=(0.1, 1.0))


def test_a_friction_that_no_speed_changes_is_a_law():
    law = judder.contact.Law.from_function(lambda v, y: (y**1.5, y, 0.3), velocity=(0.1, 1.0), indentation=(0.1, 1.0))
    found = law.evaluate(0.5, 0.5)
    assert abs(found.friction - 0.3) < 1e-12 and abs(found.friction_by_velocity) < 1e-12
    with pytest.raises(judder.InputError, match="must rise with the indentation"):
        judder.contact.Law.from_table([0.1, 1.0], [0.1, 1.0], np.ones((2, 2)), np.ones((2, 2)), np.zeros((2, 2)))
    with pytest.raises(judder.InputError, match="real numbers"):
        judder.sliding.friction_table(lambda v: v * 1j, velocity=(0.0, 1.0))
    with pytest.raises(judder.InputError, match="shape"):
        judder.sliding.friction_table(lambda v: v[:2], velocity=(0.0, 1.0))


LARGEST = 256 << 20


def test_documents_have_a_bound(tmp_path):
    def too_large(path):
        with path.open("wb") as file:
            # as long as it says, and without a block on the disk
            file.truncate(LARGEST + 1)
        return path

    words = f"{LARGEST + 1} bytes, where such a file has at most {LARGEST}"
    for call in (
        lambda: judder.contact.Law.load(too_large(tmp_path / "law.json")),
        lambda: of_dma({"file": str(too_large(tmp_path / "dma.csv"))}, law="hertz")(),
        lambda: judder.check({"model": "oscillator", "contact": {"law": {"file": str(too_large(tmp_path / "law.json"))}}}),
    ):
        with pytest.raises(judder.JudderError, match=words):
            call()
    with pytest.raises(judder.FileError):
        judder.contact.Law.load(tmp_path)
    judder.run({"model": "oscillator"}, output=tmp_path / "study")
    for name in ("manifest.json", "summary.json"):
        too_large(tmp_path / "study" / name)
        with pytest.raises(judder.JudderError, match=words):
            judder.load_study(tmp_path / "study")


def test_results_show_verdicts_shares_and_ranges():
    sweep = {"key": "operation.velocity", "from": 1e-5, "to": 1e-1, "points": 5, "scale": "log"}
    case = {"model": "oscillator", "analysis": [{"kind": "spectrum", "name": "line", "sweep": sweep}]}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", judder.JudderWarning)
        study = judder.run(case)
        found = judder.models.Oscillator().spectrum(sweep=sweep)
        area = judder.oscillator.stability_map(("velocity", [10.0, 20.0], "mm/s"), ("shear_strength", [0.0, 0.1, 0.2]))
    rates = study.results["line"]["growth_rate"]
    verdict = f"growth_rate > 0 at {sum(rate > 0 for rate in rates)} of 5"
    span = f"{min(rates):.6g} … {max(rates):.6g}"
    assert repr(study) == f"Study(in memory: line ({verdict}))"
    page = study._repr_html_().partition("<details")[0]
    assert verdict.replace(">", "&gt;") in page and f"{span} (5 values)" in page and len(page) < 2000
    assert f"growth_rate: {span} (5 values)" in repr(found) and "5 of float" not in repr(found) and "value: 1e-05 … 0.1 (5 values)" in repr(found)
    share = area.unstable_fraction
    assert f"unstable={100 * share:.3g} % of 6 points" in repr(area) and "x=velocity, [0.01, 0.02] m/s" in repr(area)
    assert json.dumps(area.unresolved) in repr(area) and len(repr(area)) < 500
