"""A sliding case through the command line: what it leaves opens with the real xarray, sounds with Python's own `wave`."""

import json
import subprocess
import wave

import numpy as np
import pytest
import scipy.io.wavfile
import xarray as xr

CASE = """
model = "sliding"

[[structure]]
name = "oblique"
beam = { length = "75 mm", thickness = "1.5 mm", elements = [15, 1], angle = "-30 deg", start = "guided" }
width = "10 mm"
material = { youngs_modulus = "71 GPa", poisson_ratio = 0.33, density = "2770 kg/m^3" }
damping = { rayleigh = { alpha = "0.2 1/s", beta = "4e-8 s" } }
reduction = { count = 6 }

[[structure]]
name = "horizontal"
beam = { length = "100 mm", thickness = "2 mm", elements = [20, 1], start = "clamped" }
width = "20 mm"
material = { youngs_modulus = "2.38 GPa", poisson_ratio = 0.40, density = "1200 kg/m^3" }
damping = { rayleigh = { alpha = "40 1/s", beta = "4e-8 s" } }
reduction = { count = 6 }

[contact]
slider = { structure = "oblique", set = "end-lower" }
track = { structure = "horizontal", set = "upper-corners" }

[motion]
start = "70 mm"
end = "95 mm"
velocity = "300 mm/s"
load = { set = "start" }
ramps = { velocity = "4 ms", load = "4 ms", friction = "4 ms", gap = "4 ms" }

[observe]
points = [{ name = "T", structure = "horizontal", set = "end-upper" }]

[[analysis]]
name = "modes"
kind = "modes"
structure = "horizontal"
count = 6

[[analysis]]
name = "locus"
kind = "locus"
configuration = "deformed"
count = 12
positions = { points = 40 }

[[analysis]]
name = "growth"
kind = "growth"
method = "ensubs"
position = "86 mm"
frequency = "3.52 kHz"

[[analysis]]
name = "march"
kind = "march"
method = "film"
signals = { quantities = ["acceleration", "velocity", "displacement"] }
sound = ["T.x", "T.y", "normal-force"]
"""


@pytest.fixture(scope="module")
def study(judder, tmp_path_factory):
    folder = tmp_path_factory.mktemp("sliding")
    (folder / "case.toml").write_text(CASE, "utf-8")
    run = subprocess.run([judder, "run", "case.toml", "-o", "study"], cwd=folder, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    return folder / "study", run.stderr


@pytest.fixture(scope="module")
def results(study):
    return json.loads((study[0] / "summary.json").read_text("utf-8"))["results"]


@pytest.fixture(scope="module")
def arrays(study):
    with xr.open_datatree(study[0] / "results.zarr", engine="zarr") as tree:
        yield {name: tree[name].to_dataset().load() for name in tree.children}


def test_a_reduction_costs_what_is_said(study, results, arrays):
    modes = arrays["modes"]
    np.testing.assert_array_equal(modes.reduced_frequency, results["modes"]["reduced_hz"])
    full, reduced = modes.frequency.values, modes.reduced_frequency.values
    # Rayleigh: a reduction only stiffens
    assert np.all(reduced >= full * (1 - 1e-9)) and np.all(reduced[:3] < full[:3] * 1.001)
    np.testing.assert_allclose(modes.reduction_error, (reduced - full) / reduced, rtol=1e-12, atol=1e-15)
    assert (modes.reduced_frequency.attrs["units"], modes.reduction_error.attrs["units"]) == ("Hz", "1")
    assert "reduced less full" in study[1]
    assert all(f"{frequency:.7f}" in study[1] for frequency in reduced if frequency < 1e5)


def test_the_zones_of_a_locus_are_where_it_grows(results, arrays):
    locus = arrays["locus"]
    assert locus.eigenvalue.dims == ("position", "branch")
    assert locus.eigenvalue.shape == (40, 12)
    units = {"position": "m", "eigenvalue": "1/s", "normal_force": "N", "slope": "1", "zone_from": "m", "zone_frequency": "Hz",
             "zone_growth_rate": "1/s"}
    assert {name: locus[name].attrs["units"] for name in units} == units
    np.testing.assert_allclose(locus.position, np.linspace(0.07, 0.095, 40), rtol=1e-12)
    zones = results["locus"]["unstable"]
    assert zones and locus.zone_from.values.tolist() == [zone["from_m"] for zone in zones]
    inside = np.zeros(40, bool)
    for zone in zones:
        inside |= (zone["from_m"] <= locus.position.values) & (locus.position.values <= zone["to_m"])
        assert zone["max_growth_rate"] > 0
    np.testing.assert_array_equal(inside, (locus.eigenvalue.real > 0).any("branch").values)


def test_growth_with_the_contact_held_is_the_eigenvalue(results, arrays):
    told, growth = results["growth"], arrays["growth"]
    assert told["measured"] == pytest.approx(told["predicted"], rel=1e-2)
    assert told["predicted"] > 10
    assert growth.predicted.item() == complex(told["predicted"], 2 * np.pi * told["frequency_hz"])
    assert growth.measured.item().real == told["measured"]
    assert growth.predicted.attrs["units"] == "1/s"


def test_a_march_has_its_signals_with_units(results, arrays):
    march = arrays["march"]
    units = {"T.x": "m/s^2", "T.y": "m/s^2", "T.x.velocity": "m/s", "T.y.velocity": "m/s", "T.x.displacement": "m",
             "T.y.displacement": "m", "normal_force": "N", "tangential_force": "N", "sliding_velocity": "m/s"}
    for name, unit in units.items():
        assert march[name].dims == ("time",)
        assert march[name].attrs["units"] == unit and march[name].attrs["long_name"]
    assert march.time.attrs["units"] == "s" and march.position.attrs["units"] == "m"
    assert "position" in march.coords
    assert np.all(np.diff(march.time) > 0)
    # the filter rings where the contact opens or closes; every step itself is non-negative
    assert results["march"]["normal_force"]["min"] >= 0
    assert march.normal_force.min() > -1e-3 * march.normal_force.max()
    # Coulomb's cone, μ = 0.3
    settled = march.where(march.time > march.attrs["settled_s"], drop=True)
    assert np.all(np.abs(settled.tangential_force) <= 0.3 * settled.normal_force + 1e-3)
    # differences over two samples lose a tenth at the end of the pass band
    slope = np.gradient(march["T.y.displacement"], march.time)
    largest = np.abs(march["T.y.velocity"]).max()
    assert np.abs(slope - march["T.y.velocity"])[1:-1].max() < 0.15 * largest


def test_sounds_open_with_pythons_own_reader(study, results):
    sounds = results["march"]["sound"]
    assert [sound["signal"] for sound in sounds] == ["T.x", "T.y", "normal-force"]
    for sound in sounds:
        path = study[0] / sound["file"]
        with wave.open(str(path)) as file:
            assert (file.getnchannels(), file.getsampwidth(), file.getframerate()) == (1, 3, 48000)
            raw = np.frombuffer(file.readframes(file.getnframes()), np.uint8).reshape(-1, 3)
        samples = (raw[:, 0].astype(int) + (raw[:, 1].astype(int) << 8) + (raw[:, 2].astype(np.int8).astype(int) << 16)) / 8388607
        # a decibel below full scale
        assert np.abs(samples).max() == pytest.approx(10 ** (-1 / 20), abs=1e-6)
        rate, other = scipy.io.wavfile.read(path)
        assert rate == 48000
        # SciPy puts 24 bits into the upper part of 32
        np.testing.assert_allclose(other / (8388607 * 256), samples, atol=1e-9)
        assert sound["gain"] > 0


def test_a_sound_is_its_signal_times_its_gain(study, results, arrays):
    sound = next(sound for sound in results["march"]["sound"] if sound["signal"] == "normal-force")
    _, samples = scipy.io.wavfile.read(study[0] / sound["file"])
    heard = samples / (8388607 * 256) / sound["gain"]
    march = arrays["march"]
    expected = np.interp(np.arange(len(heard)) / 48000 + march.time.values[0], march.time, march.normal_force)
    middle = slice(200, -200)
    assert np.abs(heard[middle] - expected[middle]).max() < 0.02 * march.normal_force.max()
