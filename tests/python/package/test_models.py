"""The classes of the models: every declared kind and key is there, and a method leaves what a run of the same case file leaves."""

import inspect
import json
import signal
import subprocess
import sys
import time
import tomllib

import pytest

import judder
from common import ROOT

SMALL = ROOT / "crates" / "judder-models" / "tests" / "small"
SWEEP = {"key": "operation.velocity", "from": 1e-6, "to": 1.0, "points": 5, "scale": "log"}


@pytest.fixture(scope="module")
def schema(command):
    """What the command says that case files may say."""
    return json.loads(command("schema").stdout)


def parameter(key):
    """A key as a parameter of Python."""
    return f"{key}_" if key == "from" else key


def class_of(model):
    return getattr(judder.models, "".join(part.capitalize() for part in model.split("-")))


def method_of(owner, kind):
    return getattr(owner, kind.replace("-", "_"))


def test_every_declared_kind_and_key_is_reached(schema):
    kinds = 0
    for case in schema["oneOf"]:
        sections = dict(case["properties"])
        owner, analyses = class_of(sections.pop("model")["const"]), sections["analysis"]["items"]["oneOf"]
        assert set(inspect.signature(owner).parameters) == {"case", "set", *map(parameter, sections)}, owner
        for analysis in analyses:
            keys, required = dict(analysis["properties"]), set(analysis["required"]) - {"kind"}
            kinds += keys.pop("name") is not None
            method = method_of(owner, keys.pop("kind")["const"])
            found = {name: own for name, own in inspect.signature(method).parameters.items() if name not in ("self", "threads", "progress")}
            assert set(found) == set(map(parameter, keys)), method
            needed = {name for name, own in found.items() if own.default is inspect.Parameter.empty}
            assert needed == set(map(parameter, required)), method
            words = " ".join(inspect.getdoc(method).split())
            for key, about in keys.items():
                doc = " ".join(about["description"].replace("`", "``").split())
                assert f"{parameter(key)}: {doc}" in words, (method, key)
    assert kinds > 25


def test_classes_are_made_when_they_are_used():
    script = (
        "import sys, judder; before = {*sys.modules}; assert {'models', 'distributed'} <= {*dir(judder)}; judder.models.Belt; judder.distributed.run; "
        "print(*({*sys.modules} - before) & {'judder.models', 'judder.distributed', 'asyncio'}, 'xarray' in before)"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert {*done.stdout.split()} >= {"judder.models", "judder.distributed", "False"}


def test_the_keys_of_a_point_are_those_of_a_case():
    with pytest.raises(judder.InputError) as caught:
        judder.oscillator.point(nothing=1.0)
    known = str(caught.value).partition("known are ")[2].split(", ")
    assert set(judder.oscillator.Keys.__annotations__) == set(known)
    for key in judder.oscillator.Keys.__annotations__:
        with pytest.raises(judder.CaseError, match=key):
            judder.oscillator.point(**{key: "1 furlong"})


def analyses():
    """An analysis of each kind of each model, from the small cases."""
    seen = set()
    for path in sorted(SMALL.glob("*.toml")):
        case = tomllib.loads(path.read_text("utf-8"))
        for analysis in case.get("analysis", []):
            kind = (case["model"], analysis["kind"])
            if kind not in seen:
                yield pytest.param(path, quick(analysis), id="-".join(kind))
            seen.add(kind)


def quick(analysis):
    """The same without a search for motions beside the branch of a threshold, which takes a minute."""
    return {**analysis, "global_margin": False} if analysis["kind"].startswith("critical-") else analysis


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    """What a run of each small case leaves."""
    studies = {}

    def of(path):
        if path not in studies:
            case = [quick(analysis) for analysis in tomllib.loads(path.read_text("utf-8"))["analysis"]]
            studies[path] = judder.run(path, output=tmp_path_factory.mktemp(path.stem), set={"analysis": case, "sweep": []})
        return studies[path]

    return of


def same_numbers(found, expected):
    """Whether the numbers of an analysis are the same under another name: but for a time and files that go by the name of the analysis."""
    others = ("seconds", "law_file", "sound", "sounds")
    return {key: own for key, own in found.items() if key not in others} == {key: own for key, own in expected.items() if key not in others}


@pytest.mark.filterwarnings("ignore::judder.JudderWarning")
@pytest.mark.parametrize(("path", "analysis"), [*analyses()])
def test_a_method_leaves_what_a_run_leaves(path, analysis, runs):
    import xarray

    keys = {parameter(key): own for key, own in analysis.items() if key not in ("name", "kind")}
    name, study = analysis.get("name", analysis["kind"]), runs(path)
    model = class_of(tomllib.loads(path.read_text("utf-8"))["model"])(path)
    found = method_of(model, analysis["kind"])(**keys)
    expected = study[name].load()
    for data in (found.data, expected):
        # an analysis of a method has a name of its own
        del data.attrs["judder_hash"], data.attrs["judder_case"]
    xarray.testing.assert_identical(found.data, expected)
    assert found.warnings == tuple(study.warnings[name])
    assert list(found.checks) == study.summary["study"]["checks"][name]
    assert same_numbers(found.numbers, study.results[name])


@pytest.mark.filterwarnings("ignore::judder.JudderWarning")
def test_keys_make_a_case_of_nothing_and_change_one_that_is_there(tmp_path):
    model = judder.models.Oscillator(operation={"velocity": "0.1 mm/s"}, title="one", set={"oscillator.damping_x": 0.02})
    assert model.check() == judder.check('model = "oscillator"\ntitle = "one"\noperation.velocity = "0.1 mm/s"\noscillator.damping_x = 0.02\n')
    changed = judder.models.Oscillator(model.text, operation={"normal_load": 2e-6})
    assert changed.check()["case"]["operation"] == {**model.check()["case"]["operation"], "normal_load": 2e-6}
    found = changed.spectrum(sweep=SWEEP)
    assert found.data.eigenvalues.dims == ("velocity", "mode") and found.data.velocity.size == 5
    study = judder.run(changed.text, output=tmp_path / "study", set={"analysis": [{"kind": "spectrum", "sweep": SWEEP}]})
    assert study["spectrum"].eigenvalues.identical(found.data.eigenvalues)


def test_keys_that_are_none_are_not_given_in_tables_too():
    model = judder.models.Oscillator(operation={"velocity": 0.02, "normal_load": None}, oscillator=None)
    assert model.text == judder.models.Oscillator(operation={"velocity": 0.02}).text
    started = model.motion(start={"x": 1.0, "y": None}, duration=5.0, transient=None)
    assert started.data.equals(model.motion(start={"x": 1.0}, duration=5.0).data)


@pytest.mark.filterwarnings("ignore::judder.JudderWarning")
def test_results_and_models_show_themselves_in_a_few_words():
    model = judder.models.Oscillator(operation={"velocity": 0.02})
    found = model.spectrum(sweep=SWEEP)
    assert repr(model) == "Oscillator(operation.velocity=0.02)"
    area = judder.oscillator.stability_map(("velocity", [1e-3, 1e-2]), ("shear_strength", [0.0, 0.1, 0.2]))
    response = judder.contact.Law("hertz").evaluate(0.1, [1e-3])
    assert "<th>operation.velocity</th><td>0.02</td>" in model._repr_html_()
    for own, words in ((found, "eigenvalues(velocity: 5, mode: 4)"), (area, "% of 6 points"), (response, "force=float64[1]")):
        assert words in repr(own) and len(repr(own)) < 1000 and len(own._repr_html_()) < 2000


def test_an_analysis_takes_up_others_of_the_case():
    model = judder.models.Sliding(SMALL / "sliding.toml", analysis=[{"name": "marched", "kind": "march", "method": "film", "predictor": "printed"}])
    levels = model.spectrogram(of="marched", length="1 ms")
    printed, own = (model.march(method="film", predictor=word) for word in ("printed", None))
    assert levels.data.sizes["frequency"] > 10
    assert any(name.endswith(".wav") for name in printed.files)
    assert not printed.data.equals(own.data)


def test_what_is_wrong_has_its_place(tmp_path):
    model = judder.models.Oscillator()
    with pytest.raises(judder.CaseError) as caught:
        model.spectrum(sweep={**SWEEP, "pionts": 3})
    assert caught.value.key == "analysis.spectrum.sweep.pionts" and caught.value.text == "pionts" and caught.value.line is None, "tables have no lines"
    with pytest.raises(judder.CaseError, match="velocity") as caught:
        judder.models.Oscillator(operation={"velocity": "30 N"}).spectrum(sweep=SWEEP)
    assert caught.value.file == "argument" and caught.value.text == '"30 N"'
    with pytest.raises(judder.CaseError, match="model `oscillator`"):
        judder.models.Belt(model.text).motion()
    with pytest.raises(TypeError, match="sweep"):
        model.spectrum()
    with pytest.raises(judder.ArgumentError, match="'operaton'; is `operation` meant") as caught:
        judder.models.Oscillator(operaton={})
    assert caught.value.argument == "operaton"
    with pytest.raises(judder.ArgumentError, match="'sweeep'; is `sweep` meant"):
        model.spectrum(sweeep=SWEEP)
    with pytest.raises(judder.ArgumentError, match="'ouput'; is `output` meant") as caught:
        judder.run(model.text, ouput="x")
    assert caught.value.argument == "ouput"
    with pytest.raises(judder.InputError, match="`case` is an int, and the path of a case file"):
        judder.run(3)
    # only the run sees it
    with pytest.raises(judder.CaseError) as caught:
        judder.models.Sliding(SMALL / "sliding.toml").march(method="ensubs", step="1 s")
    assert caught.value.file == "argument" and caught.value.key.startswith("analysis.march") and caught.value.cause


SCRIPT = """
import judder
side = dict(key="operation.velocity", points=4000, scale="log")
side["from"], side["to"] = 1e-6, 1.0
other = {**side, "key": "contact.shear_strength"}
try:
    judder.models.Oscillator().stability_map(
        x=side, y=other, method="every-point", boundaries=False, progress=lambda *told: print(*told, flush=True))
except KeyboardInterrupt as error:
    print("ended", type(error).__name__, flush=True)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_ctrl_c_ends_a_method():
    with subprocess.Popen([sys.executable, "-W", "ignore", "-c", SCRIPT], stdout=subprocess.PIPE, text=True) as run:
        for line in run.stdout:
            if int(line.split()[1]) > 2:
                break
        run.send_signal(signal.SIGINT)
        began = time.perf_counter()
        rest = run.stdout.read()
        assert run.wait(20) == 0 and time.perf_counter() - began < 5.0
    assert "ended KeyboardInterrupt" in rest or "ended Interrupted" in rest
