"""What sweeps on a cluster cost beside the points: a simulation with 100 000 chunks of one point, and what follows from it for 10^9 points.

    python benches/scaling.py [--chunks 100000] [--folder FOLDER]

Needs the package judder with dask and distributed. The chunks are written under FOLDER, a temporary one where none is given: name one on the
file system that is asked about. A cluster of two processes is started on this machine; client and scheduler share this process, so that
their time is one number. Takes some ten minutes; the book's chapter "Sweeps on a cluster" has its output.
"""

import argparse
import logging
import os
import platform
import resource
import statistics
import sys
import tempfile
import time
from pathlib import Path

import judder
from judder._cluster.executors import DaskExecutor
from judder._cluster.package import Package
from judder._cluster.work import Job

TINY = """
model = "oscillator"
[operation]
normal_load = 1e-4
[contact]
shear_strength = 0.05
[[analysis]]
name = "cycle"
kind = "limit-cycle"
[[sweep]]
name = "tiny"
over = [{{ key = "operation.velocity", from = 1e-6, to = 1, points = {chunks}, scale = "log" }}]
quantities = ["growth_rate"]
chunk = 1
[[sweep]]
name = "map"
over = [
  {{ key = "operation.velocity", from = 1e-6, to = 1, points = 1000, scale = "log" }},
  {{ key = "contact.shear_strength", from = 1e-3, to = 0.2, points = 1000 }},
]
quantities = ["growth_rate"]
[[sweep]]
name = "cycles"
method = "sobol"
points = 1024
over = [{{ key = "contact.shear_strength", from = 0.04, to = 0.08 }}]
quantities = ["cycle.rms"]
"""
TASKS = 4000
POINTS = 1e9
CORES = 1000
SHOWN = "{:44s} {:>12s}"


def told(what: str, value: float, unit: str) -> None:
    print(SHOWN.format(what, f"{value:.3g} {unit}"))


def cpu() -> float:
    """Seconds of this process on all cores."""
    used = resource.getrusage(resource.RUSAGE_SELF)
    return used.ru_utime + used.ru_stime


def megabytes() -> float:
    """Memory of this process at its largest."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def tasks(client, sweep) -> float:
    """Seconds of client and scheduler for a task that does nothing."""
    executor = DaskExecutor(client, Package.of(sweep), "nothing")
    job = Job(sweep.name, sweep.hash, (), None, None, 1)
    flying = done = 0
    used, began = cpu(), time.perf_counter()
    while done < TASKS:
        while flying < min(4, TASKS - done):
            executor.submit(job)
            flying += 1
        ended = len(executor.wait())
        flying, done = flying - ended, done + ended
    seconds = (cpu() - used) / TASKS
    told("client and scheduler, a task", 1e3 * seconds, "ms")
    told("  tasks a second, two workers", TASKS / (time.perf_counter() - began), "/s")
    return seconds


def alone(client) -> None:
    """The same of Dask itself, which has all tasks at once."""
    used = cpu()
    client.gather(client.map(abs, range(TASKS), pure=False))
    told("  of Dask alone, all tasks at once", 1e3 * (cpu() - used) / TASKS, "ms")


def store(sweep, folder: Path) -> tuple[float, float]:
    """Seconds of a chunk in the store, and of one in a list."""
    chunks = list(range(sweep.chunks))
    contents: list[tuple[int, bytes]] = []
    began = time.perf_counter()
    for begin in range(0, len(chunks), 1000):
        part = chunks[begin : begin + 1000]
        contents.extend(zip(part, sweep.compute(part), strict=True))
    told("a chunk of one point computed and encoded", 1e6 * (time.perf_counter() - began) / len(chunks), "us")
    one = judder._judder.Sweep.all(("case.toml", TINY.format(chunks=len(chunks))), [], threads=1)[0]
    part = len(contents) // 4
    began = time.perf_counter()
    one.hold(folder).write(contents[:part])
    told("a chunk on the disk, one thread", 1e3 * (time.perf_counter() - began) / part, "ms")
    began = time.perf_counter()
    sweep.hold(folder).write(contents[part:])
    seconds = (time.perf_counter() - began) / (len(contents) - part)
    told(f"a chunk on the disk, {os.cpu_count()} threads", 1e3 * seconds, "ms")
    told("  chunks a second", 1 / seconds, "/s")
    began = time.perf_counter()
    count = sum(1 for entry in os.scandir(folder / "results.zarr" / "tiny" / "values") if entry.name.startswith("c."))
    listed = time.perf_counter() - began
    assert count == len(chunks)
    told(f"{count} chunks listed", listed, "s")
    began = time.perf_counter()
    assert len(sweep.missing(folder)) == 0
    told(f"{count} chunks read and compared", time.perf_counter() - began, "s")
    return seconds, listed / count


def whole(client, case: str, folder: Path) -> None:
    """The same through a cluster."""
    before, used, began = megabytes(), cpu(), time.perf_counter()
    sizes: list[int] = []
    last = [0]

    def progress(name: str, done: int, total: int) -> None:
        if name == "tiny":
            sizes.append(done - last[0])
            last[0] = done

    judder.distributed.run(case, client, output=folder, name="tiny", progress=progress)
    chunks = last[0]
    told(f"{chunks} chunks through the cluster", time.perf_counter() - began, "s")
    told("  chunks a task, median", statistics.median([size for size in sizes if size]), "")
    told("  client and scheduler, a chunk", 1e6 * (cpu() - used) / chunks, "us")
    told("  memory of client and scheduler grew by", megabytes() - before, "MB")


def points(case: str, folder: Path) -> dict[str, float]:
    """Seconds of a point of each kind, and of reading one at the end."""
    found = {}
    for name in ("map", "cycles"):
        found[name] = judder.sweep.plan(case, name).estimate(folder)["seconds_per_point"]
    sweep = judder.sweep.plan(case, "map")
    sweep.run(folder)
    began = time.perf_counter()
    sweep.merge(folder)
    found["merge"] = (time.perf_counter() - began) / sweep.points
    told("an operating point", 1e6 * found["map"], "us")
    told("a limit cycle", 1e3 * found["cycles"], "ms")
    told("completing a study, a point", 1e6 * found["merge"], "us")
    return found


def model(point: float, chunk: int, costs: dict[str, float]) -> list[str]:
    """A row of the table: 10^9 points of this kind."""
    chunks = POINTS / chunk
    work = POINTS * point / CORES
    per_task = max(1.0, 0.01 * CORES, point * chunk)
    count = POINTS * point / per_task
    return [
        f"{chunk}",
        f"{chunks:.3g}",
        f"{work / 3600:.3g} h",
        f"{count / work:.3g}/s",
        f"{100 * min(1.0, count * costs['task'] / work):.2g} %",
        f"{chunks / work:.3g}/s",
        f"{chunks * costs['listing']:.3g} s",
        f"{POINTS * costs['merge'] / 60:.3g} min",
    ]


def table(costs: dict[str, float]) -> None:
    print(f"\n{POINTS:.0e} points on {CORES} cores, by these figures")
    head = ["point", "chunk", "chunks", "time", "tasks", "scheduler", "chunk files", "one list", "completing"]
    rows = [
        ["operating point", *model(costs["map"], 1 << 17, costs)],
        ["limit cycle", *model(costs["cycles"], 64, costs)],
        ["limit cycle", *model(costs["cycles"], 4096, costs)],
        ["a minute each", *model(60.0, 1, costs)],
    ]
    for row in [head, *rows]:
        print("| " + " | ".join(row) + " |")
    told("\nshortest task that keeps 1000 cores busy", CORES * costs["task"], "s")


def main() -> int:
    import distributed

    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--chunks", type=int, default=100_000)
    options.add_argument("--folder", type=Path, default=None)
    asked = options.parse_args()
    case = TINY.format(chunks=asked.chunks)
    print(f"{platform.machine()}, {os.cpu_count()} cores, Python {platform.python_version()}, distributed {distributed.__version__}")
    with tempfile.TemporaryDirectory(dir=asked.folder) as scratch:
        folder = Path(scratch)
        compiled = judder.sweep.plan(case, "tiny")._compiled
        costs = points(case, folder / "points")
        costs["store"], costs["listing"] = store(compiled, folder / "store")
        local = distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=logging.CRITICAL
        )
        with local, distributed.Client(local) as client:
            costs["task"] = tasks(client, compiled)
            alone(client)
            whole(client, case, folder / "cluster")
        table(costs)
        print("\nremoving the chunks, which may take as long again", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
