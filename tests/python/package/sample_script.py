"""What a user writes, for the type checkers."""

from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np
from distributed import Client

import judder
from judder.sliding import Pair, Slider, Track, locus, march


def bell(velocity: np.ndarray, indentation: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    return 4 / 3 * indentation**1.5, np.pi * indentation, 0.3 * velocity / (1 + velocity**2)


def points() -> float:
    point = judder.oscillator.point(velocity="30 mm/s", normal_load=1e-6, law="hertz")
    eigenvalue: complex = point.eigenvalues[0]
    print(point.verdict.upper(), eigenvalue.real, point.damping[0, 0])
    return point.growth_rate


def arrays() -> float:
    found = judder.oscillator.points(velocity=(np.linspace(1.0, 50.0), "mm/s"), shear_strength=[[0.01], [0.05]], quantities=["growth_rate"], threads=2)
    print(found.growth_rate.max(), judder.contact.Law("hertz").evaluate([0.1], 1e-3, threads=1).force[0])
    return float(found.velocity[0])


def programs() -> None:
    print(judder.examples()["mode-coupling"].write("here"), judder.demo("mode-coupling").complete, judder.demo(output=Path("out")).scoreboard[0].verdict)
    print(judder.new("belt"), judder.schema()["$defs"], judder.report("out").name, judder.reproduce("beams-paper", quick=True).report)
    with judder.explore({"model": "oscillator"}, browser=False) as page:
        print(page.address)


def maps() -> None:
    law = judder.contact.Law.from_function(bell, velocity=(1e-6, 1e2), indentation=(1e-6, 1e-1))
    found = judder.oscillator.stability_map(
        ("operation.velocity", np.logspace(-6, 0, 100)),
        ("radius", [5.0, 10.0], "mm"),
        law=law,
        damping_x=0.02,
        retardation_time="10 ms",
        progress=judder.tqdm_progress(),
    )
    judder.plot.stability(found).set_title(judder.plot.COLOURS["flutter"])
    growth = found.growth_rate
    print(found.unstable.mean(), growth.max() if growth is not None else None, found.to_dataset().sizes)


def cases() -> None:
    judder.plot.stability(judder.load_study("out")["map"], legend=False)
    study = judder.run(Path("case.toml"), set={"operation.velocity": 1e-3}, only=["map"], threads=2).save(Path("out"))
    print(study.results["map"], study["map"].growth_rate.mean(), [name for name in study], study.report.name, [*study.files], judder.run("case.toml", output=True).folder)
    try:
        judder.check({"model": "oscillator"})
    except judder.CaseError as error:
        print(error.line, error.key, error.help, error.fields)
    except judder.JudderError as error:
        print(error.cause)


def models() -> None:
    pair = judder.models.Sliding(Path("case.toml"), contact={"friction_coefficient": 0.4}, set={"structure.0.reduction.count": 6})
    found = pair.march(method="film", predictor="printed", from_="10 mm", sound=["T.y"], progress=judder.tqdm_progress())
    print(found.data.normal_force.max(), found.numbers["steps"], [check["figure"] for check in found.checks], found.files.keys(), found.warnings)
    print(judder.models.Oscillator().spectrum(sweep={"key": "operation.velocity", "from": 1e-6, "to": 1, "points": 5}).data.sizes, pair.text, pair.check())


def exports() -> None:
    study = judder.load_study("s3://bucket/study", storage_options={"anon": True})
    print(study.report.name, study.report.read_text()[:10], [path.stem for path in study.figures.values()], open(study.tables["map"]).readline())
    tables = study.to_parquet(Path("tables"), only=["map"], progress=judder.tqdm_progress())
    print(tables[0].name, study.to_csv("tables")[0].name, study.to_netcdf("study.nc").suffix, study.to_matlab("study.mat", only="map").suffix)
    try:
        judder.run("case.toml", output="s3://bucket/study")
    except judder.StoreError as error:
        print(error.cause)
    except judder.PackageError as error:
        print(error.package, error.extra)


def sweeps(client: Client) -> None:
    sweep = judder.sweep.plan(Path("case.toml"), "robustness", set={"sweep.robustness.points": 64})
    for chunk in sweep.missing("out"):
        sweep.write("out", chunk, sweep.compute(chunk))
    print(sweep.merge("out")["robustness"].growth_rate.mean(), sweep.values(0).shape, sweep.estimate()["seconds"])
    study = judder.distributed.run("case.toml", client, output="out", progress=lambda name, done, total: None)
    print(study.failed_points("robustness")["reason"])
    judder.distributed.run_with("case.toml", lambda: ProcessPoolExecutor(2), output="out", workers=2)


def contacts() -> float:
    contact = judder.contact.solve(0.1, indentation=1e-2, substrate=judder.contact.Substrate(10.0, [(1.0, 0.9)]), shape="sphere")
    print(contact.pressure.max(), contact.converged)
    return contact.force


def pairs() -> None:
    slider = Slider([0.0], [0.0, 0.0], [[0.0], [1.0]], [-1.0], [0.0])
    track = Track([1e6], [[0.0, 0.0], [0.1, 0.0]], np.zeros((2, 2, 1)), alpha=1.0)
    pair = Pair(slider, track, friction=0.3)
    ended = march(pair, velocity=0.1, load=1.0, method="film", predictor="printed")
    print(ended.normal_force.mean(), locus(pair, [0.01, 0.02], count=1, velocity=0.1, load=1.0).zones)
