"""Errors are exceptions with the fields of the errors below; no bad input ends otherwise."""

import itertools
import pickle

import numpy as np
import pytest

import judder


def raised(call, kind):
    with pytest.raises(kind) as caught:
        call()
    assert type(caught.value) is kind and isinstance(caught.value, judder.JudderError)
    again = pickle.loads(pickle.dumps(caught.value))
    assert str(again) == str(caught.value) and again.fields == caught.value.fields and again.cause == caught.value.cause
    return caught.value


def test_a_case_error_knows_its_place():
    text = 'model = "oscillator"\n\n[operation]\nvelocity = "30 N"\n'
    error = raised(lambda: judder.check(text), judder.CaseError)
    assert (error.file, error.line, error.column, error.key) == ("case.toml", 4, 12, "operation.velocity")
    assert error.cause == "WrongDimension" and error.text == '"30 N"' and "30 mm/s" in error.help
    assert isinstance(error, ValueError) and "line 4" in error.__notes__[0]
    error = raised(lambda: judder.check("no/such/case.toml"), judder.CaseError)
    assert error.line is None and error.cause == "Missing"
    error = raised(lambda: judder.check({"model": "oscillator"}, set={"operation.velocity": -1}), judder.CaseError)
    assert error.file == "--set" and error.key == "operation.velocity"


def test_an_oscillator_error_has_its_numbers():
    call = lambda: judder.oscillator.point(coupling_angle="-45 deg", shear_strength=50.0, velocity=1e-5)  # noqa: E731
    error = raised(call, judder.OscillatorError)
    assert error.cause in ("NoEquilibrium", "SeveralEquilibria")
    assert error.fields and all(getattr(error, name) == value for name, value in error.fields.items())
    with pytest.raises(AttributeError, match="has no attribute 'colour'"):
        error.colour  # noqa: B018


def test_errors_of_contacts_and_laws():
    error = raised(lambda: judder.contact.solve(0.1, indentation=2.0, shape="sphere"), judder.ContactError)
    assert (error.cause, error.indentation, error.limit) == ("TooDeep", 2.0, 1.0)
    error = raised(lambda: judder.contact.solve(0.1, indentation=1e-2, accuracy=2.0), judder.ContactError)
    assert error.accuracy == 2.0
    error = raised(lambda: judder.contact.Law.from_json('{"format": "x", "version": 1}'), judder.LawError)
    assert error.cause == "WrongFormat" and isinstance(error, judder.ContactError)
    raised(lambda: judder.contact.Law("steel"), judder.InputError)


def test_errors_of_folders_and_studies(tmp_path):
    (tmp_path / "mine.txt").write_text("keep me")
    error = raised(lambda: judder.run({"model": "oscillator"}, output=tmp_path), judder.StoreError)
    assert error.cause == "ForeignFolder" and error.holds == "mine.txt"
    error = raised(lambda: judder.load_study(tmp_path), judder.StudyError)
    assert error.cause == "NoStudy"
    error = raised(lambda: judder.run({"model": "oscillator"}, output=tmp_path / "new", only=["map"]), judder.StudyError)
    assert (error.cause, error.name, error.known) == ("UnknownAnalysis", "map", [])
    with pytest.raises(OSError) as caught:
        judder.contact.Law.load(tmp_path / "none.json")
    assert isinstance(caught.value, FileNotFoundError) and str(tmp_path) in str(caught.value)


BAD = [None, float("nan"), float("inf"), -1.0, 0, 1e308, "", "\0", "3", "3 m", [], [1.0], {}, object(), b"x", 10**400, 1j, True, np.array([1.0]), np.float32(2)]


@pytest.mark.parametrize("name", ["velocity", "normal_load", "shear_strength", "radius", "law", "friction_load", "glassy_modulus"])
def test_no_value_of_a_key_panics(name):
    for value in BAD:
        try:
            judder.oscillator.point(**{name: value})
        except (judder.JudderError, TypeError, OverflowError):
            pass


def test_no_argument_of_a_contact_panics():
    for velocity, depth in itertools.product([float("nan"), -1.0, 0.0, 1e-300, 1e300], [float("nan"), -1.0, 0.0, 1e-300, 1e6]):
        try:
            judder.contact.solve(velocity, indentation=depth, accuracy=0.5, cells=8)
        except judder.JudderError:
            pass
    for shape in ("cube", (np.zeros((2, 2)), 1.0), (np.full((8, 8), np.nan), 1.0), (np.zeros(3), 1.0), (np.zeros((8, 8)), -1.0)):
        with pytest.raises(judder.JudderError):
            judder.contact.solve(0.1, indentation=1e-2, shape=shape)
    for cells in (0, 1, 7):
        with pytest.raises(judder.JudderError):
            judder.contact.solve(0.1, indentation=1e-2, cells=cells)
    with pytest.raises(judder.InputError):
        judder.contact.solve(0.1)
    with pytest.raises(judder.LawError):
        judder.contact.solve(0.1, indentation=1e-2, substrate=judder.contact.Substrate(0.5))
