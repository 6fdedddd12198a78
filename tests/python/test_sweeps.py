"""Sweeps of whole studies from outside: the same bytes however they are computed, and whatever happens meanwhile."""

import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import time

import numpy as np
import pytest
import xarray as xr

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
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


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


def test_every_design(run, case, tmp_path):
    case(SAMPLES)
    said = run("run", "case.toml", "-o", "study")
    results = json.loads((tmp_path / "study" / "summary.json").read_text("utf-8"))["results"]
    points = {name: results[name]["points"] for name in ("list", "hypercube", "sequence", "sensitivity", "amplitude")}
    assert points == {"list": 3, "hypercube": 20, "sequence": 32, "sensitivity": 64 * 5, "amplitude": 2}
    assert all(results[name]["failed"] == 0 for name in points)

    tree = xr.open_datatree(tmp_path / "study" / "results.zarr", engine="zarr")
    listed = tree["list"]["values"].sel(quantity="contact.shear_strength")
    assert listed.values.tolist() == [0.1, 0.2, 0.3]
    assert tree["list"].attrs["method"] == "list"

    # a twentieth of the range holds one point each
    drawn = tree["hypercube"]["values"].sel(quantity="operation.velocity").values
    parts = np.floor((np.log10(drawn) + 5) / 4 * 20).astype(int)
    assert sorted(parts) == list(range(20))

    # A and B of a row differ in every key, AB_k from A in the k-th
    rows = tree["sensitivity"]["values"].values.reshape(64, 5, 5)[:, :, :3]
    for k in range(3):
        changed = rows[:, 1 + k] != rows[:, 0]
        assert changed[:, k].all() and changed.sum() == 64
    indices = results["sensitivity"]["sensitivity"]["growth_rate"]
    assert indices["rows"] == 64 and indices["confidence"] == 0.9
    for order in ("first", "total"):
        for index in indices[order].values():
            assert index["from"] <= index["value"] <= index["to"]
    assert "first order" in said.stderr and "oscillator.damping_x" in said.stderr

    # Saltelli et al. 2010, Table 2 (b) and (f), from the stored values
    growth = tree["sensitivity"]["values"].sel(quantity="growth_rate").values.reshape(64, 5)
    a, b = growth[:, 0], growth[:, -1]
    mean, variance = np.mean([a, b]), np.var([a, b])
    for k, key in enumerate(indices["first"]):
        changed = growth[:, 1 + k]
        first, total = np.mean((b - mean) * (changed - a)) / variance, np.mean((a - changed) ** 2) / 2 / variance
        assert indices["first"][key]["value"] == pytest.approx(first, abs=0.02)
        assert indices["total"][key]["value"] == pytest.approx(total, rel=0.02)

    for figure in ("list", "hypercube", "sequence", "sensitivity", "sensitivity-sensitivity", "amplitude"):
        assert (tmp_path / "study" / "figures" / f"{figure}.png").stat().st_size > 5000, figure
    page = (tmp_path / "study" / "report.html").read_text("utf-8")
    assert "Sensitivity of growth_rate" in page and "Quantities over all points" in page


def test_a_point_of_a_sweep_is_that_of_the_case(run, case, tmp_path):
    case(GRID.replace("points = 40", "points = 3").replace("points = 30", "points = 2"))
    run("run", "case.toml", "-o", "study")
    swept = xr.open_zarr(tmp_path / "study" / "results.zarr", group="map")["values"]
    assert swept.dims == ("operation.velocity", "contact.shear_strength", "quantity")
    for velocity in swept["operation.velocity"].values:
        for strength in swept["contact.shear_strength"].values:
            keys = [f"operation.velocity={float(velocity)!r}", f"contact.shear_strength={float(strength)!r}"]
            said = run("point", "case.toml", "--json", *(word for key in keys for word in ("--set", key)))
            growth = swept.sel({"operation.velocity": velocity, "contact.shear_strength": strength, "quantity": "growth_rate"})
            assert float(growth) == json.loads(said.stdout)["growth_rate"]
    # an analysis of the same point
    case(SAMPLES)
    run("run", "case.toml", "-o", "other", "--only", "amplitude")
    run("run", "case.toml", "-o", "one", "--only", "cycle", "--set", "operation.velocity=3e-4")
    swept = xr.open_zarr(tmp_path / "other" / "results.zarr", group="amplitude")["values"]
    alone = json.loads((tmp_path / "one" / "summary.json").read_text("utf-8"))["results"]["cycle"]["rms"]
    assert float(swept.sel(quantity="cycle.rms")[1]) == alone


def test_the_same_bytes_by_whom_they_come(run, case, judder, tmp_path):
    case(GRID)
    run("run", "case.toml", "-o", "whole", "--threads", 1)
    run("run", "case.toml", "-o", "threads", "--threads", 2)
    assert_same(tmp_path / "whole", tmp_path / "threads")

    for part in ("3/3", "1/3", "2/3"):
        said = run("run", "case.toml", "-o", "parts", "--shard", part)
        assert f"part {part} is done" in said.stderr
        if part == "1/3":
            said = run("merge", "case.toml", "-o", "parts", code=1)
            assert "chunks are missing" in said.stderr
    run("merge", "case.toml", "-o", "parts")
    assert_same(tmp_path / "whole", tmp_path / "parts")

    command = [judder, "run", "case.toml", "-o", "race", "--threads", "1"]
    racing = [subprocess.Popen(command, cwd=tmp_path, stderr=subprocess.PIPE, text=True) for _ in range(3)]
    said = [process.communicate(timeout=120)[1] for process in racing]
    assert [process.returncode for process in racing] == [0, 0, 0], said
    assert any("report: " in own for own in said)
    assert_same(tmp_path / "whole", tmp_path / "race")


def test_kills_at_any_instant(run, case, judder, tmp_path):
    case(GRID.replace("points = 40", "points = 80").replace("points = 30", "points = 60").replace("chunk = 30", "chunk = 20"))
    began = time.monotonic()
    run("run", "case.toml", "-o", "calm", "--threads", 1)
    whole = time.monotonic() - began
    instants = random.Random(20)
    kills, attempts, found = 0, 0, set()
    while True:
        process = subprocess.Popen(
            [judder, "run", "case.toml", "-o", "stormy", "--threads", "1"], cwd=tmp_path, stderr=subprocess.DEVNULL
        )
        attempts += 1
        try:
            # short at first, so that many die while there is work, then long enough to come through to the report
            process.wait(timeout=whole * instants.uniform(0.0, max(0.12, (attempts - 24) * 0.05)))
            assert process.returncode == 0
            if kills >= 20:
                break
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
            process.wait()
            kills += 1
            found.add(len(chunks(tmp_path / "stormy")))
    assert len(found) > 8, "kills that fell while there was work"
    assert_same(tmp_path / "calm", tmp_path / "stormy")


def test_damaged_chunks_are_found_and_computed_anew(run, case, tmp_path):
    case(GRID)
    run("run", "case.toml", "-o", "sound")
    run("run", "case.toml", "-o", "study")
    truncated, turned, empty, lost, swapped, other = chunks(tmp_path / "study")[3:9]
    truncated.write_bytes(truncated.read_bytes()[:-100])
    content = bytearray(turned.read_bytes())
    content[len(content) // 3] ^= 1
    turned.write_bytes(content)
    empty.write_bytes(b"")
    lost.unlink()
    shutil.copy(other, swapped)
    said = run("run", "case.toml", "-o", "study")
    assert "4 damaged chunks were computed anew" in said.stderr
    assert_same(tmp_path / "sound", tmp_path / "study")


def test_what_belongs_to_another_case_is_refused(run, case, tmp_path):
    case(GRID)
    run("run", "case.toml", "-o", "study")
    run("run", "case.toml", "-o", "other", "--set", "operation.normal_load=2e-5")
    before = tree(tmp_path / "study")

    # another case on the same folder
    said = run("run", "case.toml", "-o", "study", "--set", "operation.normal_load=2e-5", code=2)
    assert "results.zarr/map" in said.stderr and "--fresh" in said.stderr
    assert {name: before[name] for name in before if "values/c." in name}.items() <= tree(tmp_path / "study").items()

    # a chunk of another case among ours
    ours, theirs = chunks(tmp_path / "study")[5], chunks(tmp_path / "other")[5]
    ours.unlink()
    shutil.copy(theirs, ours)
    said = run("run", "case.toml", "-o", "study", code=2)
    assert ours.name in said.stderr and "another case" in said.stderr
    assert ours.read_bytes() == theirs.read_bytes(), "what is not ours is not overwritten"
    ours.unlink()
    run("run", "case.toml", "-o", "study")
    assert tree(tmp_path / "study") == before

    run("run", "case.toml", "-o", "study", "--fresh", "--set", "operation.normal_load=2e-5")
    assert_same(tmp_path / "other", tmp_path / "study")


CLOCK = r"""
#define _GNU_SOURCE
#include <dlfcn.h>
#include <sys/time.h>
#include <time.h>

/* Every call another day: forwards, backwards. The monotonic clock stays what it is. */
static long jump(void) {
    static unsigned calls;
    return (calls++ % 7 - 3) * 40000000L;
}

int clock_gettime(clockid_t clock, struct timespec *now) {
    static int (*real)(clockid_t, struct timespec *);
    if (!real) real = (int (*)(clockid_t, struct timespec *))dlsym(RTLD_NEXT, "clock_gettime");
    int code = real(clock, now);
    if (clock == CLOCK_REALTIME) now->tv_sec += jump();
    return code;
}

time_t time(time_t *place) {
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    if (place) *place = now.tv_sec;
    return now.tv_sec;
}

int gettimeofday(struct timeval *now, void *zone) {
    struct timespec exact;
    clock_gettime(CLOCK_REALTIME, &exact);
    now->tv_sec = exact.tv_sec;
    now->tv_usec = exact.tv_nsec / 1000;
    return 0;
}
"""


def test_a_clock_that_jumps(run, case, tmp_path):
    case(GRID)
    run("run", "case.toml", "-o", "calm")
    shim = {}
    (tmp_path / "clock.c").write_text(CLOCK, "utf-8")
    if shutil.which("gcc"):
        subprocess.run(["gcc", "-shared", "-fPIC", "-o", "clock.so", "clock.c", "-ldl"], cwd=tmp_path, check=True)
        shim = {"env": {**os.environ, "LD_PRELOAD": str(tmp_path / "clock.so")}}
    for part, date in (("1/3", 0), ("2/3", 4_100_000_000), ("3/3", 1_000_000)):
        run("run", "case.toml", "-o", "jumpy", "--shard", part, **shim)
        for path in (tmp_path / "jumpy").rglob("*"):
            os.utime(path, (date, date))
    chunks(tmp_path / "jumpy")[0].unlink()
    run("run", "case.toml", "-o", "jumpy", **shim)
    for path in (tmp_path / "jumpy").rglob("*"):
        os.utime(path, (4_100_000_000, 4_100_000_000))
    said = run("run", "case.toml", "-o", "jumpy", **shim)
    assert "done before: map" in said.stderr
    assert_same(tmp_path / "calm", tmp_path / "jumpy")


def test_a_point_that_fails_says_why_and_stops_nothing(run, case, tmp_path):
    # between 0.6 and 0.8 an entry of the stiffness is the root of a negative number
    case("""
model = "two-degrees"

[parameters]
mu = 0.5

[matrices]
stiffness = [[2, "1 - 4*mu/3"], [1, "2 + sqrt((mu - 0.7)^2 - 0.01)"]]

[[sweep]]
name = "hole"
method = "latin-hypercube"
points = 40
over = [{ key = "parameters.mu", from = 0, to = 1 }]
quantities = ["growth_rate", "verdict"]
chunk = 8
""")
    said = run("run", "case.toml", "-o", "study", code=1)
    results = json.loads((tmp_path / "study" / "summary.json").read_text("utf-8"))["results"]["hole"]
    swept = xr.open_zarr(tmp_path / "study" / "results.zarr", group="hole")["values"].load()
    assert swept["quantity"].values.tolist() == ["parameters.mu", "growth_rate", "verdict"]
    parameter, growth, verdict = swept.values.T
    wrong = abs(parameter - 0.7) < 0.1
    assert wrong.sum() == pytest.approx(8, abs=1)
    assert np.isnan(growth[wrong]).all() and np.isnan(verdict[wrong]).all()
    assert np.isfinite(growth[~wrong]).all() and set(verdict[~wrong]) <= {0.0, 1.0, 2.0}
    assert results["failed"] == wrong.sum() == len(results["failures"])
    assert all(abs(failure["at"]["parameters.mu"] - 0.7) < 0.1 for failure in results["failures"])
    assert all("stiffness[1][1] is NaN" in failure["reason"] for failure in results["failures"])
    assert f"{wrong.sum()} of 40 points failed" in said.stderr
    page = (tmp_path / "study" / "report.html").read_text("utf-8")
    assert "Points without an answer" in page
    # what failed is an answer too: it is not computed again, and stays a missing result
    said = run("run", "case.toml", "-o", "study", code=1)
    assert "done before: hole" in said.stderr


def test_ctrl_c_keeps_the_chunks_that_are_done(run, case, judder, tmp_path):
    case(GRID)
    run("run", "case.toml", "-o", "calm")
    process = subprocess.Popen(
        [judder, "run", "case.toml", "-o", "study", "--threads", "1"], cwd=tmp_path, stderr=subprocess.PIPE, text=True
    )
    while len(chunks(tmp_path / "study")) < 3:
        assert process.poll() is None
        time.sleep(0.002)
    process.send_signal(signal.SIGINT)
    said = process.communicate(timeout=60)[1]
    assert process.returncode == 1 and "what was done is kept" in said
    kept = {path: path.read_bytes() for path in chunks(tmp_path / "study")}
    assert 3 <= len(kept) < len(chunks(tmp_path / "calm"))
    inodes = {path: path.stat().st_ino for path in kept}
    run("run", "case.toml", "-o", "study")
    assert inodes == {path: path.stat().st_ino for path in kept}, "nothing is computed twice"
    assert_same(tmp_path / "calm", tmp_path / "study")


MOUNTED = """
mount -t tmpfs -o size=$SIZE none disk && touch mounted && {{ {script} ; }}
"""


def in_a_file_system(judder, folder, size, script):
    """Runs a script beside a file system of that size, which lives as long as the script."""
    (folder / "disk").mkdir()
    said = subprocess.run(
        ["unshare", "--user", "--map-root-user", "--mount", "sh", "-c", MOUNTED.format(script=script)],
        cwd=folder, capture_output=True, text=True, env={**os.environ, "JUDDER": str(judder), "SIZE": size},
    )
    if not (folder / "mounted").exists():
        pytest.skip(f"SKIPPED: needs `unshare` and leave to mount: {said.stderr}")
    return said


@pytest.mark.skipif(not shutil.which("unshare"), reason="SKIPPED: needs `unshare`")
def test_a_full_disk_is_named_and_leaves_nothing_half_written(run, case, judder, tmp_path):
    case(GRID)
    run("run", "case.toml", "-o", "calm", "--shard", "1/1")
    said = in_a_file_system(judder, tmp_path, "176k", """
        "$JUDDER" run case.toml -o disk/study --threads 1; code=$?
        find disk -name '*.partial' > partial; ls disk/study/results.zarr/map/values > done
        mount -o remount,size=10m disk; "$JUDDER" run case.toml -o disk/study --shard 1/1 2> resumed || exit 9
        cp -r disk/study study; exit $code""")
    assert said.returncode == 1, said.stderr
    assert "no room for" in said.stderr and "what is done is kept" in said.stderr
    assert (tmp_path / "partial").read_text() == ""
    done = [name for name in (tmp_path / "done").read_text().split() if name.startswith("c.")]
    assert 0 < len(done) < len(chunks(tmp_path / "calm"))
    assert [path.read_bytes() for path in chunks(tmp_path / "calm")] == [path.read_bytes() for path in chunks(tmp_path / "study")]


@pytest.mark.skipif(not shutil.which("unshare"), reason="SKIPPED: needs `unshare`")
def test_a_read_only_folder_is_named(case, judder, tmp_path):
    case(GRID)
    said = in_a_file_system(judder, tmp_path, "10m", """
        "$JUDDER" run case.toml -o disk/study --shard 1/2 2> first || exit 9
        mount -o remount,ro disk; "$JUDDER" run case.toml -o disk/study""")
    assert said.returncode == 1, said.stderr
    assert "disk/study" in said.stderr and "not writable" in said.stderr.lower(), said.stderr
