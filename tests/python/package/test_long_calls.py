"""Long calls leave the interpreter to others, tell how far they are, end at Ctrl-C and keep what is done."""

import multiprocessing
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import judder

# seconds on any machine, so that there is something to interrupt
LARGE = ("velocity", np.logspace(-6, 0, 3000)), ("shear_strength", np.linspace(0, 0.2, 4000))


def test_another_thread_goes_on_while_a_map_is_made():
    ticks, stop = [], threading.Event()

    def tick():
        while not stop.wait(0.005):
            ticks.append(time.perf_counter())

    other = threading.Thread(target=tick)
    other.start()
    began = time.perf_counter()
    judder.oscillator.stability_map(("velocity", np.logspace(-6, 0, 500)), ("shear_strength", np.linspace(0, 0.2, 500)))
    ended = time.perf_counter()
    stop.set()
    other.join()
    during = [began, *(tick for tick in ticks if began < tick < ended), ended]
    # whoever holds the interpreter's lock to the end leaves one gap as long as the call
    assert ended - began > 0.1 and max(np.diff(during)) < 0.5 * (ended - began)


def test_an_exception_of_the_callback_ends_the_call():
    def refuse(name, done, total):
        raise LookupError(name)

    began = time.perf_counter()
    with pytest.raises(LookupError, match="verdicts|growth rates"):
        judder.oscillator.stability_map(*LARGE, progress=refuse)
    assert time.perf_counter() - began < 5.0


SCRIPT = """
import sys, time, numpy as np, judder
case = sys.argv[1]
try:
    judder.run(case, output=sys.argv[2], progress=lambda name, done, total: print(name, done, total, flush=True))
except KeyboardInterrupt as error:
    print("ended", type(error).__name__, error, flush=True)
"""

CASE = """
model = "oscillator"
[[analysis]]
name = "quick"
kind = "spectrum"
sweep = { key = "operation.velocity", from = 1e-6, to = 1e-2, points = 5, scale = "log" }
[[analysis]]
name = "long"
kind = "stability-map"
method = "every-point"
boundaries = false
x = { key = "operation.velocity", from = 1e-6, to = 1, points = 3000, scale = "log" }
y = { key = "contact.shear_strength", from = 0, to = 0.2, points = 4000 }
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_ctrl_c_ends_a_run_and_keeps_what_is_done(tmp_path):
    case = tmp_path / "case.toml"
    case.write_text(CASE)
    words = [sys.executable, "-W", "ignore", "-c", SCRIPT, str(case), str(tmp_path / "study")]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as run:
        for line in run.stdout:
            if line.startswith("long ") and int(line.split()[1]) > 2:
                break
        run.send_signal(signal.SIGINT)
        began = time.perf_counter()
        rest = run.stdout.read()
        assert run.wait(20) == 0 and time.perf_counter() - began < 2.0
    assert "ended Interrupted" in rest and "kept" in rest
    study = judder.load_study(tmp_path / "study")
    assert list(study) == ["quick"]
    again = judder.run(case, output=tmp_path / "study", only=["quick"])
    assert again.summary["analyses"]["quick"] == study.summary["analyses"]["quick"]


def _growth(seed):
    found = judder.oscillator.stability_map(("velocity", np.logspace(-6, 0, 64)), ("shear_strength", [0.01, 0.1]), damping_x=seed)
    return found.growth_rate.tolist()


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="no fork here")
def test_workers_that_are_forked_compute_too():
    expected = [_growth(seed) for seed in (0.01, 0.02)]
    with multiprocessing.get_context("fork").Pool(2) as pool:
        assert pool.map_async(_growth, [0.01, 0.02]).get(60) == expected


def test_bars_of_tqdm(capsys):
    pytest.importorskip("tqdm")
    judder.oscillator.stability_map(*((name, values[:200]) for name, values in LARGE), progress=judder.tqdm_progress(file=sys.stdout))
    assert "growth rates: 100%" in capsys.readouterr().out
