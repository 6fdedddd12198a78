"""What the tests of sweeps share: cases, the fixtures `run` and `case`, studies compared."""

import json
import pathlib
import subprocess

import pytest

MODEL = """
model = "oscillator"

[contact]
shear_strength = 0.005

[operation]
normal_load = 1e-5
"""

# thresholds take a fraction of a millisecond a point: long enough to be killed in, short enough to be repeated
GRID = MODEL + """
[[sweep]]
name = "map"
over = [
  { key = "operation.velocity", from = 1e-5, to = 1e-1, points = 40, scale = "log" },
  { key = "contact.shear_strength", from = 0.01, to = 1.0, points = 30, scale = "log" },
]
quantities = ["growth_rate", "mechanism", "threshold_shear_strength"]
chunk = 30
"""

SAMPLES = MODEL + """
[[analysis]]
name = "cycle"
kind = "limit-cycle"

[[sweep]]
name = "list"
method = "list"
over = [
  { key = "operation.velocity", values = ["1 mm/s", "2 mm/s", "0.5 mm/s"] },
  { key = "contact.shear_strength", values = [0.1, 0.2, 0.3] },
]
quantities = ["growth_rate"]

[[sweep]]
name = "hypercube"
method = "latin-hypercube"
points = 20
seed = 3
over = [{ key = "operation.velocity", from = 1e-5, to = 1e-1, scale = "log" }, { key = "oscillator.damping_x", from = 0.0, to = 0.1 }]
quantities = ["growth_rate", "verdict"]
chunk = 7

[[sweep]]
name = "sequence"
method = "sobol"
points = 32
over = [{ key = "operation.velocity", from = 1e-5, to = 1e-1, scale = "log" }, { key = "oscillator.damping_x", from = 0.0, to = 0.1 }]
quantities = ["growth_rate"]

[[sweep]]
name = "sensitivity"
method = "sobol"
points = 64
over = [
  { key = "operation.velocity", from = 1e-3, to = 1e-2, scale = "log" },
  { key = "contact.shear_strength", from = 0.01, to = 0.1, scale = "log" },
  { key = "oscillator.damping_x", from = 0.005, to = 0.02 },
]
quantities = ["growth_rate", "mechanism"]
sensitivity = { confidence = 0.9, resamples = 200 }
chunk = 100

[[sweep]]
name = "amplitude"
over = [{ key = "operation.velocity", values = [2e-4, 3e-4] }]
quantities = ["cycle.rms", "cycle.floquet_multipliers.count"]
"""


@pytest.fixture
def run(judder, tmp_path):
    """Runs `judder` on the case in the folder of the test and gives back what it said."""

    def run(*arguments, code=0, **options):
        said = subprocess.run(
            [judder, *map(str, arguments)], cwd=tmp_path, capture_output=True, text=True, timeout=300, **options
        )
        assert said.returncode == code, said.stderr
        return said

    return run


@pytest.fixture
def case(tmp_path):
    """Writes the case that the test runs."""
    return lambda text, name="case.toml": (tmp_path / name).write_text(text, "utf-8")


def tree(folder):
    """All files of a study with their content, but for those that tell times."""
    told = {"summary.json", "report.html"}
    files = (path for path in pathlib.Path(folder).rglob("*") if path.is_file() and path.name not in told)
    found = {str(path.relative_to(folder)): path.read_bytes() for path in files}
    if "manifest.json" in found:
        listed = json.loads(found["manifest.json"])
        found["manifest.json"] = listed["complete"], {name: record for name, record in listed["files"].items() if name not in told}
    return found


def without_times(value):
    """A summary without what no two runs share."""
    if isinstance(value, dict):
        return {key: without_times(own) for key, own in value.items() if key not in {"seconds", "wall_time_s"}}
    return [without_times(own) for own in value] if isinstance(value, list) else value


def assert_same(one, other):
    """The same files with the same bytes, nothing else left, and the same summary."""
    one_tree, other_tree = tree(one), tree(other)
    assert sorted(one_tree) == sorted(other_tree)
    different = [name for name in one_tree if one_tree[name] != other_tree[name]]
    assert not different
    assert [name for name in other_tree if name.startswith(".")] == [".judder.lock"]
    summaries = [json.loads((pathlib.Path(folder) / "summary.json").read_text("utf-8")) for folder in (one, other)]
    assert without_times(summaries[0]) == without_times(summaries[1])


def chunks(folder, sweep="map"):
    return sorted((pathlib.Path(folder) / "results.zarr" / sweep / "values").glob("c.*"))
