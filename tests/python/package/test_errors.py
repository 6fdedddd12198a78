"""Errors are exceptions with the fields of the errors below; no bad input ends otherwise."""

import inspect
import itertools
import pickle
import re

import numpy as np
import pytest

import judder
from common import ROOT
from judder import _said_in_python
from names import callables


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
    assert (error.file, error.line, error.key, error.__notes__) == ("set", None, "operation.velocity", ["at operation.velocity: -1"])
    error = raised(lambda: judder.oscillator.point(velocity=-1.0), judder.CaseError)
    assert (error.file, error.line, error.__notes__) == ("argument", None, ["at operation.velocity: -1"])


@pytest.mark.parametrize(
    ("analysis", "key", "text"),
    [
        ({"from": 1e-5, "to": 1e-3, "points": 0}, "analysis.line.sweep.points", "0"),
        ({"from": -1, "to": 1e-3, "points": 3}, "analysis.line.sweep.from", "-1"),
        ({"from": 1e-5, "to": 1e-5, "points": 3}, "analysis.line.sweep", None),
        ({"from": 1e-5, "to": 1e-3, "pionts": 3}, "analysis.line.sweep.pionts", "pionts"),
        ({"from": 1e-5, "to": 1e-3, "points": 3, "key": "operation.velocty"}, "analysis.line.sweep.key", "operation.velocty"),
    ],
)
def test_a_place_in_tables_is_the_whole_path_of_its_key(analysis, key, text):
    case = {"model": "oscillator", "analysis": [{"kind": "spectrum", "name": "line", "sweep": {"key": "operation.velocity", **analysis}}]}
    error = raised(lambda: judder.check(case), judder.CaseError)
    assert (error.file, error.line, error.key) == ("tables", None, key) and error.__notes__[0].startswith(f"at {key}")
    assert text is None or error.text == text


def test_changed_keys_and_arguments_are_called_as_they_were_given():
    error = raised(lambda: judder.check({"model": "oscillator"}, set={"operation": {"velocty": 1}}), judder.CaseError)
    assert (error.file, error.key) == ("set", "operation.velocty")
    error = raised(lambda: judder.models.Oscillator(operation={"velocty": 1}).check(), judder.CaseError)
    assert (error.file, error.key, error.__notes__[0]) == ("argument", "operation.velocty", "at operation.velocty: velocty")
    error = raised(lambda: judder.models.Oscillator(operation={"velocity": 1}, set={"operation.velocity": -1}).check(), judder.CaseError)
    assert error.file == "set"
    error = raised(lambda: judder.check({"model": "oscillator"}, set={"operation..velocity": 1}), judder.CaseError)
    assert "has no dotted key" in str(error) and "--set" not in "\n".join([str(error), *error.__notes__])
    error = raised(lambda: judder.check({"model": "oscillator"}, set={"": 1}), judder.InputError)
    assert str(error).startswith("set: has an empty key")
    for given, kind in (([("a", 1)], "a list"), ("operation.velocity=1", "a str")):
        error = raised(lambda given=given: judder.check({"model": "oscillator"}, set=given), judder.InputError)
        assert f"`set` is {kind}, and a mapping is needed" in str(error)
    error = raised(lambda: judder.run("none.toml"), judder.CaseError)
    assert error.help == "`judder.new()` gives the text of a case to start from"


@pytest.mark.parametrize("begun", [None, 'model = "belt"', 'model = "belt"\n[[analysis]]\nkind = "limit-cycle"\n'])
def test_analyses_of_functions_are_arguments_whatever_the_case_has(begun, tmp_path):
    for case in [begun] if begun is None else [begun, tmp_path / "own.toml"]:
        if case is not None and case is not begun:
            case.write_text(begun, "utf-8")
        error = raised(lambda case=case: judder.models.Belt(case).limit_cycle(start={"x": "a"}), judder.CaseError)
        assert (error.file, error.line, error.text) == ("argument", None, '"a"') and error.key.endswith(".start.x")


def test_analyses_of_the_case_are_no_arguments(tmp_path):
    path = tmp_path / "own.toml"
    path.write_text('model = "belt"\n[[analysis]]\nkind = "limit-cycle"\nstart = { x = "a" }\n', "utf-8")
    error = raised(lambda: judder.models.Belt(path).limit_cycle(), judder.CaseError)
    assert (error.file, error.line) == (str(path), 4)
    error = raised(lambda: judder.models.Belt({"model": "belt", "analysis": [{"kind": "motion", "duration": "a"}]}).motion(duration=10.0), judder.CaseError)
    assert (error.file, error.key) == ("tables", "analysis.motion.duration")


def test_an_empty_table_is_that_of_a_file():
    assert judder.check({"model": "belt", "friction": {}}) == judder.check('model = "belt"\n[friction]\n')


def test_the_text_of_a_case_may_have_one_line():
    assert judder.check('model = "belt"') == judder.check({"model": "belt"})


STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')
OF_COMMAND = re.compile(r"`judder [a-z]|(?<![\w-])--[a-z]|(?<!\S)-o\b")


def test_messages_have_no_words_of_the_command_line():
    """Of every text in the sources that speaks of the command, but those of the command itself and of another program."""
    sources = [path for path in sorted(ROOT.glob("crates/*/src/**/*.rs")) if path.relative_to(ROOT).parts[1] != "judder-cli"]
    lines = [line for path in sources for line in path.read_text("utf-8").split("#[cfg(test)]")[0].splitlines() if not line.strip().startswith("//")]
    texts = [text.replace('\\"', '"') for line in lines for text in STRING.findall(line)]
    told = [text for text in texts if OF_COMMAND.search(text) and text != "--set" and "`gmsh" not in text]
    assert len(told) > 30
    assert [text for text in told if OF_COMMAND.search(_said_in_python.in_python(text))] == []


def test_words_of_python_are_those_of_functions_that_there_are():
    error = judder.StudyError("`judder run --fresh` computes it anew", "Cause", {"reason": "name another folder with -o", "path": "a -o"})
    assert str(error) == "`judder.run(…, fresh=True)` computes it anew" and error.fields == {"reason": "name another folder with `output`", "path": "a -o"}
    for command in ("run", "verify", "report", "examples", "new", "explore"):
        assert hasattr(judder, command), command
    assert _said_in_python.in_python("give judder more with --memory \"3 GiB\" where") == "give judder more with `judder.limit_memory(\"3 GiB\")` where"


def test_arrays_that_do_not_go_together_are_told_with_both_shapes():
    error = raised(lambda: judder.contact.Law("hertz").evaluate([1.0, 2.0], [1.0, 2.0, 3.0]), judder.InputError)
    assert error.argument == "indentation" and "[3]" in str(error) and "[2] of `velocity`" in str(error)
    assert judder.contact.Law("hertz").evaluate([[1.0], [2.0]], [1.0, 2.0, 3.0]).force.shape == (2, 3)
    own = lambda: judder.contact.Law.from_function(lambda v, y: (y, y[:2], 0.3), velocity=(0.1, 1.0), indentation=(0.1, 1.0))  # noqa: E731
    error = raised(own, judder.InputError)
    assert "its area has the shape (2,)" in str(error) and "broadcast" not in str(error)


@pytest.mark.parametrize(("given", "words"), [(3, "an int"), ([], "a list"), (None, "None"), (object(), "an object")])
def test_what_is_no_case_is_told_with_its_article(given, words):
    assert f"`case` is {words}, and the path" in str(raised(lambda: judder.run(given), judder.InputError))


NEAR = [
    (lambda: judder.oscillator.point(velocty=1.0), "velocty: .*is `velocity` meant"),
    (lambda: judder.oscillator.point(**{"operation.velocty": 1.0}), "is `operation.velocity` meant"),
    (lambda: judder.oscillator.points(velocty=[1.0]), "velocty: .*is `velocity` meant"),
    (lambda: judder.oscillator.points(velocity=[1.0], quantities=["growth_rte"]), "is `growth_rate` meant"),
    (lambda: judder.oscillator.stability_map(("velocty", [1.0]), ("shear_strength", [0.1])), "is `velocity` meant"),
    (lambda: judder.oscillator.stability_map(("velocity", [1.0]), ("shear_strength", [0.1]), radis=1.0), "is `radius` meant"),
    (lambda: judder.oscillator.stability_map(("velocity", [1.0]), ("shear_strength", [0.1]), method="adaptiv"), "is `adaptive` meant"),
    (lambda: judder.oscillator.point(law="hertzz"), "is `hertz` meant"),
    (lambda: judder.oscillator.point(friction_load="normal-lod"), "is `normal-load` meant"),
    (lambda: judder.contact.solve(0.1, indentation=1e-2, shape="cylindr"), "is `cylinder` meant"),
    (lambda: judder.reproduce("oscillator-papr"), "is `oscillator-paper` meant"),
]


@pytest.mark.parametrize(("call", "words"), NEAR)
def test_what_an_unknown_word_is_like_is_told(call, words):
    assert re.search(words, str(raised(call, judder.InputError)))


def test_a_key_of_an_oscillator_that_is_none_is_left_out():
    assert list(judder.oscillator.point(velocity=None).eigenvalues) == list(judder.oscillator.point().eigenvalues)
    with pytest.raises(judder.InputError, match="is `velocity` meant"):
        judder.oscillator.point(velocty=None)


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
        except judder.JudderError:
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


@pytest.fixture(scope="module")
def instances():
    """An object of each class whose methods take arguments."""
    sweep = {"name": "grid", "over": [{"key": "operation.velocity", "from": 1e-5, "to": 1e-3, "points": 3}], "quantities": ["growth_rate"]}
    case = {"model": "oscillator", "sweep": [sweep]}
    own = [
        judder.contact.Law("hertz"),
        judder.oscillator.point(),
        judder.oscillator.stability_map(("velocity", [1e-4]), ("shear_strength", [0.1])),
        judder.run({"model": "oscillator"}),
        judder.sweep.plan(case),
        judder.models.Oscillator(),
    ]
    return {type(one): one for one in own}


def parameters(call):
    """The names of what a call takes, but its object."""
    named = inspect.signature(call).parameters.values()
    return [own for own in named if own.kind in (own.POSITIONAL_OR_KEYWORD, own.KEYWORD_ONLY) and own.name != "self"]


def takes_any(call):
    """Whether a call takes arguments of any name."""
    return any(own.kind == own.VAR_KEYWORD for own in inspect.signature(call).parameters.values())


@pytest.mark.parametrize(("name", "call", "kind"), [pytest.param(*one, id=one[0]) for one in callables()])
def test_wrong_arguments_are_errors_of_judder_and_of_python(name, call, kind, instances, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    is_static = kind is not None and isinstance(inspect.getattr_static(kind, name.rpartition(".")[2]), staticmethod | classmethod)
    whose = [] if kind is None or is_static else [instances.get(kind, object())]
    if not takes_any(call):
        with pytest.raises(judder.ArgumentError) as caught:
            call(*whose, no_such_argument=1)
        assert isinstance(caught.value, TypeError) and str(caught.value)
    taken = parameters(call)
    wrong = {own.name: object() for own in taken} | ({"velocity": object()} if takes_any(call) and name.startswith("judder.oscillator") else {})
    try:
        call(*whose, **wrong)
    except judder.JudderError:
        return
    # what keeps its arguments until they are used, or takes none
    assert inspect.isclass(call) or not wrong, name


SOLVE = {"velocity": 0.1, "indentation": 1e-2, "accuracy": 0.5, "cells": 8}


@pytest.mark.parametrize(
    ("call", "argument", "kind", "also"),
    [
        (lambda: judder.contact.solve(**SOLVE | {"velocity": "fast"}), "velocity", judder.ArgumentError, TypeError),
        (lambda: judder.contact.solve(**SOLVE | {"cells": -1}), "cells", judder.NumberError, OverflowError),
        (lambda: judder.contact.solve(**SOLVE | {"cells": 10**30}), "cells", judder.NumberError, OverflowError),
        (lambda: judder.contact.Law(3), "name", judder.ArgumentError, TypeError),
        (lambda: judder.contact.Law.from_json(text=b"x"), "text", judder.ArgumentError, TypeError),
        (lambda: judder.contact.Law("hertz").evaluate(1.0, 1e-2, threads="two"), "threads", judder.ArgumentError, TypeError),
        (lambda: judder.contact.Law("hertz").concern(1.0, None), "indentation", judder.ArgumentError, TypeError),
        (lambda: judder.oscillator.point(friction_load=3), "friction_load", judder.ArgumentError, TypeError),
        (lambda: judder.oscillator.stability_map(("velocity", [1.0]), ("shear_strength", [0.1]), threads=-1), "threads", judder.NumberError, OverflowError),
        (lambda: judder.sliding.Pair(friction=0.3), "slider", judder.ArgumentError, TypeError),
    ],
)
def test_a_wrong_argument_is_named(call, argument, kind, also):
    error = raised(call, kind)
    assert isinstance(error, also) and isinstance(error, judder.InputError)
    assert argument in str(error) and error.argument in (argument, "")


def test_an_error_of_the_callers_function_stays_as_it_is(map_case):
    def progress(name, done, total):
        raise TypeError("mine")

    with pytest.raises(TypeError, match="^mine$") as caught:
        judder.run(map_case, progress=progress)
    assert type(caught.value) is TypeError
    with pytest.raises(AttributeError, match="colour") as caught:
        judder.contact.Law.from_function(lambda v, y: v.colour, velocity=(0.1, 1.0), indentation=(0.1, 1.0))
    assert type(caught.value) is AttributeError


def test_warnings_are_told_of_the_line_that_calls(recwarn):
    steep = judder.contact.Law.from_function(lambda v, y: (y**1.5 * (1 + (v > 1.0)), y, 0 * v), velocity=(1e-3, 1e3), indentation=(1e-3, 1.0))
    assert steep.errors and {told.filename for told in recwarn if told.category is judder.JudderWarning} == {__file__}
