"""Results in the files of other programs, read back by those: every bit, every unit, every failure."""

import csv
import json
import math
import os
import shutil
import subprocess
import sys

import numpy as np
import pytest
import xarray as xr
from pyarrow import parquet
from scipy.io import loadmat

import judder
from common import files
from exported import SMALL, WORDS, bits, study_of
from judder._interchange import comma, matlab, results, tables
from judder._interchange.whole import files as whole_files

WRITERS = {"to_parquet": "folder", "to_csv": "folder", "to_netcdf": "file.nc", "to_matlab": "file.mat"}


@pytest.fixture(scope="module")
def small(tmp_path_factory):
    return study_of(SMALL, tmp_path_factory.mktemp("small") / "study")


@pytest.fixture(scope="module")
def studies(small, tmp_path_factory):
    return [small, study_of(WORDS, tmp_path_factory.mktemp("words") / "study")]


def write(study, writer, folder, **options):
    return getattr(study, writer)(folder / WRITERS[writer], **options)


def parts(dataset):
    """Name, values and attributes of every variable, complex ones in two."""
    for name, variable in dataset.variables.items():
        if variable.dtype.kind == "c":
            yield from ((f"{name}_{part}", variable.dims, getattr(variable.values, part), variable.attrs) for part in ("real", "imag"))
        else:
            yield name, variable.dims, variable.values, variable.attrs


def sets(dataset):
    """The dimensions of its variables, and how the name of their table ends."""
    found = dict.fromkeys(variable.dims for variable in dataset.data_vars.values())
    return {dims: ".".join(dims) if place else "" for place, dims in enumerate(found)}


def expected_columns(dataset, dims):
    """What the table of these dimensions must hold: name, values row by row, attributes."""
    like = xr.DataArray(np.zeros([dataset.sizes[name] for name in dims]), dims=dims)
    for name, own, values, attrs in parts(dataset):
        is_coordinate = name in dims
        if is_coordinate or own == dims:
            spread = xr.DataArray(values, dims=own).broadcast_like(like).transpose(*dims)
            yield name, spread.values.ravel(), attrs
    for name in dims:
        if name not in dataset.coords:
            numbers = xr.DataArray(np.arange(dataset.sizes[name]), dims=name).broadcast_like(like).transpose(*dims)
            yield name, numbers.values.ravel(), {}


def test_parquet_has_every_bit_unit_and_class(studies, tmp_path):
    for place, study in enumerate(studies):
        written = study.to_parquet(tmp_path / str(place))
        assert sorted(written) == sorted((tmp_path / str(place)).iterdir())
        for name in study:
            dataset = study._dataset(name).compute()
            for dims, suffix in sets(dataset).items():
                table = parquet.read_table(tmp_path / str(place) / (f"{name}.{suffix}.parquet" if suffix else f"{name}.parquet"))
                wanted = list(expected_columns(dataset, dims))
                assert sorted(table.column_names) == sorted(column for column, _, _ in wanted)
                for column, values, attrs in wanted:
                    assert bits(table[column].to_numpy()) == bits(values), (name, column)
                    assert table[column].null_count == (np.isnan(values).sum() if values.dtype.kind == "f" else 0)
                    said = {key.decode(): value.decode() for key, value in (table.schema.field(column).metadata or {}).items()}
                    assert said.get("units") == attrs.get("units") and said.get("flag_meanings") == attrs.get("flag_meanings")
                    assert said.get("long_name", "").startswith(attrs.get("long_name", "")), (name, column)
                    codes = " ".join(map(str, attrs.get("flag_values", [])))
                    assert said.get("flag_values", "") == codes
                assert table.schema.metadata[b"judder_hash"].decode() == dataset.attrs["judder_hash"]
                assert json.loads(table.schema.metadata[b"results"]) == study.results[name]
                assert table.schema.metadata[b"source"].decode() == f"judder {study.summary['version']}"
                assert table.schema.metadata[b"case"].decode() == study.summary["study"]["source"]


def test_pandas_reads_the_failures_of_a_sweep_and_its_numbers(small, tmp_path):
    import pandas

    small.to_parquet(tmp_path, only=["grid", "samples"])
    for name in ("grid", "samples"):
        expected = small.failed_points(name)
        found = pandas.read_parquet(tmp_path / f"{name}.failures.parquet")
        assert len(found) == len(expected) > 0
        assert [*found["reason"]] == [*expected["reason"]] and any(reason.startswith("doubtful") for reason in found["reason"])
        whole = pandas.read_parquet(tmp_path / f"{name}.parquet")
        for key in small._dataset(name).attrs["keys"]:
            assert bits(found[key].to_numpy()) == bits(expected[key].to_numpy()) == bits(whole[key].to_numpy()[found["point"]])
        lost = found["point"][~found["reason"].str.startswith("doubtful")]
        assert whole["cycle.rms"][lost].isna().all() and whole["cycle.rms"].isna().sum() == len(lost)
    numbers = pandas.read_parquet(tmp_path / "samples.results.parquet").set_index("key")
    assert numbers["value"]["points"] == 64 and numbers["value"]["failed"] == small.results["samples"]["failed"]


def test_csv_reads_back_to_the_last_bit(studies, tmp_path):
    for place, study in enumerate(studies):
        study.to_csv(tmp_path / str(place))
        for name in study:
            dataset = study._dataset(name).compute()
            with (tmp_path / str(place) / f"{name}.columns.csv").open(newline="", encoding="utf-8") as file:
                said = {(row["table"], row["column"]): row for row in csv.DictReader(file)}
            for dims, suffix in sets(dataset).items():
                own = f"{name}.{suffix}" if suffix else name
                with (tmp_path / str(place) / f"{own}.csv").open(newline="", encoding="utf-8") as file:
                    heads, *rows = csv.reader(file)
                for column, values, attrs in expected_columns(dataset, dims):
                    units = attrs.get("units", "1")
                    at = heads.index(column if units == "1" else f"{column} [{units}]")
                    cells = [row[at] for row in rows]
                    if values.dtype.kind == "f":
                        assert [cell == "" for cell in cells] == np.isnan(values).tolist()
                        cells = np.array([float(cell or "nan") for cell in cells])
                        assert bits(cells[~np.isnan(values)]) == bits(values[~np.isnan(values)])
                    else:
                        assert cells == [str(value) for value in values.tolist()]
                    row = said[own, column]
                    assert row["units"] == attrs.get("units", "") and row["flag_meanings"] == attrs.get("flag_meanings", "")
    with (tmp_path / "0" / "grid.failures.csv").open(newline="", encoding="utf-8") as file:
        assert [row["reason"] for row in csv.DictReader(file)] == [*studies[0].failed_points("grid")["reason"]]


def test_xarray_reads_the_netcdf_file(studies, tmp_path):
    for place, study in enumerate(studies):
        path = study.to_netcdf(tmp_path / f"{place}.nc")
        whole = xr.open_dataset(path).attrs
        assert whole["case"] == study.summary["study"]["source"] and whole["case_hash"] == study.summary["case_hash"]
        for name in study:
            dataset = study._dataset(name).compute()
            with xr.open_dataset(path, group=name) as read:
                wanted = list(parts(dataset))
                assert sorted(read.variables) == sorted(variable for variable, _, _, _ in wanted)
                assert {*read.coords} == {*dataset.coords} and read.sizes == dataset.sizes
                for variable, dims, values, attrs in wanted:
                    assert read[variable].dims == dims and bits(read[variable].values) == bits(values), (name, variable)
                    own = read[variable].attrs
                    assert own.get("units") == attrs.get("units") and own.get("flag_meanings") == attrs.get("flag_meanings")
                    assert own.get("long_name", "").startswith(attrs.get("long_name", ""))
                    assert np.atleast_1d(own.get("flag_values", [])).tolist() == attrs.get("flag_values", [])
                assert read.attrs["judder_hash"] == dataset.attrs["judder_hash"] and json.loads(read.attrs["results"]) == study.results[name]
    for name in ("grid", "samples"):
        failures = xr.open_dataset(tmp_path / "0.nc", group=f"{name}/failures")
        expected = studies[0].failed_points(name)
        assert failures["reason"].values.tolist() == [*expected["reason"]]
        rms = studies[0]._dataset(name)["cycle.rms"].values.ravel()[failures["point"].values]
        assert np.isnan(rms).tolist() == [not reason.startswith("doubtful") for reason in expected["reason"]]
        for key in studies[0]._dataset(name).attrs["keys"]:
            assert bits(failures[key].values) == bits(expected[key].to_numpy())
            assert failures[key].attrs["units"] == studies[0]._dataset(name)[key].attrs["units"]


def test_scipy_reads_the_matlab_file(studies, tmp_path):
    for place, study in enumerate(studies):
        read = loadmat(study.to_matlab(tmp_path / f"{place}.mat"), simplify_cells=True)
        assert read["judder"]["case_hash"] == study.summary["case_hash"]
        for name in study:
            dataset, own = study._dataset(name).compute(), read[name]
            names = {original: identifier for identifier, original in own["names"].items()}
            assert names.keys() == {*dataset.variables}
            for variable in dataset.variables:
                values, identifier = dataset[variable].values, names[variable]
                found = np.asarray(own[identifier])
                if values.dtype.kind != "T":
                    # whole numbers that fit are stored smaller
                    found = found.astype(values.dtype)
                assert bits(found.ravel()) == bits(values.ravel()), (name, variable)
                assert own["dimensions"][identifier] == " ".join(dataset[variable].dims)
                assert own["long_name"][identifier] == dataset[variable].attrs["long_name"]
                assert own["units"].get(identifier) == dataset[variable].attrs.get("units")
                if "flag_values" in dataset[variable].attrs:
                    assert own["flag_values"][identifier].tolist() == dataset[variable].attrs["flag_values"]
                    assert own["flag_meanings"][identifier] == dataset[variable].attrs["flag_meanings"]
    grid = loadmat(tmp_path / "0.mat", simplify_cells=True)["grid"]
    assert "cycle_rms" in grid and grid["names"]["operation_velocity"] == "operation.velocity"
    # an element as MATLAB counts: from 1, the first dimension fastest
    lost = grid["cycle_rms"].ravel(order="F")[grid["failures"]["index"] - 1]
    assert np.isnan(lost).tolist() == [not reason.startswith("doubtful") for reason in grid["failures"]["reason"]]
    assert grid["results"]["failed"] == studies[0].results["grid"]["failed"]


@pytest.mark.parametrize("writer", WRITERS)
def test_the_same_study_has_the_same_bytes(small, writer, tmp_path):
    one, two = write(small, writer, tmp_path / "one"), write(small, writer, tmp_path / "two")
    pairs = zip(one, two, strict=True) if isinstance(one, list) else [(one, two)]
    assert all(mine.name == other.name and mine.read_bytes() == other.read_bytes() for mine, other in pairs)


def test_blocks_are_all_points_row_by_row_and_never_many():
    random = np.random.default_rng(5)
    for _ in range(200):
        shape = tuple(random.integers(1, 9, size=random.integers(0, 4)))
        chunk = tuple(int(random.integers(1, length + 1)) for length in shape)
        rows = int(random.integers(1, 60))
        numbers = np.arange(math.prod(shape)).reshape(shape)
        found = [numbers[block].ravel() for block in results.blocks(shape, chunk, rows)]
        assert np.concatenate(found).tolist() == numbers.ravel().tolist()
        assert max(map(len, found)) <= max(rows, math.prod(chunk))
    # chunks of some whole rows, as sweeps have them, are read once
    starts = [block[0].start for block in results.blocks((10_000, 10_000), (7, 10_000), 1 << 18)]
    assert len(starts) == 10_000 // 21 + 1 and all(start % 7 == 0 for start in starts)


# a file of MATLAB is made whole
@pytest.mark.parametrize("writer", ["to_parquet", "to_csv", "to_netcdf"])
def test_what_is_written_does_not_depend_on_blocks(small, writer, tmp_path, monkeypatch):
    whole = write(small, writer, tmp_path / "whole", only=["grid", "samples"])
    read, seen = results.Variable.read, []
    monkeypatch.setattr(results, "ROWS", 8)
    monkeypatch.setattr(results, "_FAILURES", 2)
    monkeypatch.setattr(results.Variable, "read", lambda self, block=(): [seen.append(math.prod(s.stop - s.start for s in block)), read(self, block)][1])
    parted = write(small, writer, tmp_path / "parted", only=["grid", "samples"])
    assert max(seen) <= 16
    if writer == "to_parquet":
        assert parquet.ParquetFile(tmp_path / "parted" / "folder" / "grid.parquet").num_row_groups > 3
        assert all(parquet.read_table(mine).to_pandas().equals(parquet.read_table(other).to_pandas()) for mine, other in zip(whole, parted, strict=True))
    elif writer == "to_csv":
        assert all(mine.read_bytes() == other.read_bytes() for mine, other in zip(whole, parted, strict=True))
    else:
        for group in ("grid", "samples", "grid/failures", "samples/failures"):
            assert xr.open_dataset(whole, group=group).identical(xr.open_dataset(parted, group=group))


@pytest.mark.parametrize("writer", WRITERS)
def test_progress_is_told_and_may_end_it(small, writer, tmp_path):
    seen = []
    write(small, writer, tmp_path / "told", progress=lambda *told: seen.append(told))
    assert [*dict.fromkeys(name for name, _, _ in seen)] == [*small]
    assert all(done <= total for _, done, total in seen) and {name for name, done, total in seen if done == total} == {*small}

    def stop(name, done, total):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write(small, writer, tmp_path / "ended" / "deep", progress=stop)
    assert not (tmp_path / "ended").exists()


FULL = """
import resource, signal, sys
import judder
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
study, writer, *targets = judder.load_study(sys.argv[1]), *sys.argv[2:]
resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))
for target in targets:
    try:
        getattr(study, writer)(target)
    except judder.StoreError as error:
        print(error.cause, error)
"""


@pytest.mark.parametrize("writer", WRITERS)
def test_a_full_disk_leaves_what_was_there(small, writer, tmp_path):
    write(small, writer, tmp_path, only="grid")
    before = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
    targets = [tmp_path / WRITERS[writer], tmp_path / "new" / WRITERS[writer]]
    done = subprocess.run([sys.executable, "-c", FULL, small.folder, writer, *targets], capture_output=True, text=True)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    for target, line in zip(targets, done.stdout.splitlines(), strict=True):
        assert line.startswith(f"Write {target}") and "cannot be written (" in line and "File too large" in line
    assert {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()} == before
    assert not (tmp_path / "new").exists()


@pytest.mark.parametrize(("writer", "module", "extra"), [("to_parquet", "pyarrow", "parquet"), ("to_netcdf", "h5netcdf", "netcdf"), ("to_matlab", "scipy.io", "matlab")])
def test_a_missing_package_is_named_with_its_extra(small, writer, module, extra, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(judder.PackageError, match=rf"{writer} needs the package {module.partition('.')[0]} .*: pip install 'judder\[{extra}\]'") as caught:
        write(small, writer, tmp_path)
    assert isinstance(caught.value, ImportError) and caught.value.extra == extra and list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("writer", WRITERS)
def test_places_that_cannot_be_written_are_named(small, writer, tmp_path):
    (tmp_path / "file").write_text("mine")
    with pytest.raises(judder.StoreError, match=r"file.*: cannot be written \((Not a directory|File exists)\); nothing of it is left") as caught:
        write(small, writer, tmp_path / "file" if writer in ("to_netcdf", "to_matlab") else tmp_path / "file" / "deep")
    assert caught.value.cause == "Write" and (tmp_path / "file").read_text() == "mine"
    with pytest.raises(judder.StoreError, match="memory://x: studies in an object store are read and never written"):
        getattr(small, writer)("memory://x")
    for name in ("x" * 300, "nul\0"):
        with pytest.raises(judder.StoreError, match="File name too long|no path has a NUL") as caught:
            getattr(small, writer)(tmp_path / name)
        assert caught.value.cause == "Write"
    if WRITERS[writer] != "folder":
        with pytest.raises(judder.StoreError, match="a folder has this name; name a file"):
            getattr(small, writer)(tmp_path)


@pytest.mark.parametrize("writer", WRITERS)
def test_nothing_is_exported_into_a_study_folder(small, writer, tmp_path):
    study = judder.load_study(shutil.copytree(small.folder, tmp_path / "study"))
    (tmp_path / "link").symlink_to(study.folder)
    before = files(study.folder)
    inside = ["summary.json", "report.html", "figures/map.svg", "new", "results.zarr/grid", "results.zarr/grid/values/c.0.0.0", "../link/summary.json"]
    for source in (study, small):
        for name in [*inside, *([""] if WRITERS[writer] == "folder" else [])]:
            with pytest.raises(judder.StoreError, match="is a study folder, and nothing is exported into one") as caught:
                getattr(source, writer)(study.folder / name)
            assert caught.value.cause == "StudyFolder"
    assert files(study.folder) == before
    # beside it, and a second time
    for _ in range(2):
        getattr(study, writer)(tmp_path / "study-exported", only="grid")


@pytest.mark.parametrize("writer", WRITERS)
def test_results_that_are_not_there_are_named(small, writer, tmp_path):
    with pytest.raises(judder.InputError, match="only: there is no result `nothing`; the study has `map`, `spectrum`, `cycle`, `grid`, `samples`"):
        write(small, writer, tmp_path / "none", only=["grid", "nothing"])
    assert not (tmp_path / "none").exists()


def test_two_results_of_one_name_are_refused(tmp_path):
    sweep = {"key": "operation.velocity", "from": 1e-6, "to": 1, "points": 3, "scale": "log"}
    case = {"model": "oscillator", "analysis": [{"name": name, "kind": "spectrum", "sweep": sweep} for name in ("a", "a.results", "end", "a-results")]}
    study = study_of(case, tmp_path / "study")
    with pytest.raises(judder.StoreError, match=r"a\.results\.parquet: two results would have this file; name one of them with `only`"):
        study.to_parquet(tmp_path / "tables")
    assert not (tmp_path / "tables").exists() and study.to_parquet(tmp_path / "tables", only="a")
    read = loadmat(study.to_matlab(tmp_path / "names.mat"), simplify_cells=True)
    # each has its own name, and `end` is a word of MATLAB's
    assert {"a", "a_results", "a_results_2", "xend"} <= read.keys()


def test_names_for_matlab_are_its_names():
    names = ["operation.velocity", "operation_velocity", "9a", "units", "end", "_x", "x" * 80, "x" * 90, "ξ"]
    found = matlab.identifiers(names, taken=["units"])
    assert len({*found.values()}) == len(names) and found["units"] == "units_2"
    assert all(name.isidentifier() and name.isascii() and name[0] != "_" and len(name) <= 63 for name in found.values())


def test_a_result_too_large_for_matlab_is_refused_with_another_way(small, tmp_path, monkeypatch):
    monkeypatch.setattr(matlab, "LARGEST", 1000)
    with pytest.raises(judder.StoreError, match="`map` has .* bytes, .* leave it out with `only`, or take `to_netcdf`") as caught:
        small.to_matlab(tmp_path / "x.mat")
    assert caught.value.cause == "TooLarge" and list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("writer", WRITERS)
def test_a_chunk_that_is_gone_is_no_column_of_nan(small, writer, tmp_path):
    study = judder.load_study(shutil.copytree(small.folder, tmp_path / "study"))
    chunks = sorted((study.folder / "results.zarr" / "grid" / "values").glob("c.*"))
    content = chunks[3].read_bytes()
    chunks[3].unlink()
    with pytest.raises(judder.StoreError, match=r"c\.1\.1\.0: this chunk is not there") as caught:
        write(study, writer, tmp_path / "out", only="grid")
    assert caught.value.cause == "MissingChunk" and not (tmp_path / "out").exists()
    flipped = bytes([content[0] ^ 1, *content[1:]])
    for damaged in (content[:-20], content[20:], flipped, b""):
        chunks[3].write_bytes(damaged)
        with pytest.raises(judder.StoreError, match=r"c\.1\.1\.0: this chunk is damaged: .*; `judder.run` computes it again") as caught:
            write(study, writer, tmp_path / "out", only="grid")
        assert caught.value.cause == "DamagedChunk" and not (tmp_path / "out").exists()


def test_a_chunk_that_is_gone_is_named_before_a_sweep_is_opened(small, tmp_path):
    study = judder.load_study(shutil.copytree(small.folder, tmp_path / "study"))
    chunks = sorted((study.folder / "results.zarr" / "grid" / "values").glob("c.*"))
    gone = chunks[-1].read_bytes()
    chunks[-1].unlink()
    # neither one in its place nor anything else that lies there hides that
    (chunks[-1].parent / "c.other").touch()
    for look in (lambda: study["grid"], lambda: study.failed_points("grid")):
        with pytest.raises(judder.StoreError, match=rf"{chunks[-1].name}: this chunk is not there; `judder.run` computes it") as caught:
            look()
        assert caught.value.cause == "MissingChunk" and caught.value.path == chunks[-1]
    assert study["samples"].sizes and len(study.failed_points("samples")) >= 0
    chunks[-1].write_bytes(gone)
    assert study["grid"].identical(small["grid"])
    # values that are read by zarr are checked, too
    chunks[0].write_bytes(bytes([chunks[0].read_bytes()[0] ^ 1, *chunks[0].read_bytes()[1:]]))
    with pytest.raises(ValueError, match="checksum do not match"):
        study["grid"].load()


def test_what_a_killed_export_left_is_removed_by_the_next(small, tmp_path):
    write(small, "to_csv", tmp_path)
    whole = {path.name for path in tmp_path.iterdir()}
    killed = (
        "import os, signal, sys; from pathlib import Path; from judder._interchange.whole import files\n"
        "with files(Path(sys.argv[1])) as written:\n"
        "    written.new('map.csv').write_text('half')\n"
        "    os.kill(os.getpid(), signal.SIGKILL)\n"
    )
    assert subprocess.run([sys.executable, "-c", killed, tmp_path], check=False).returncode == -9
    left = {path.name for path in tmp_path.iterdir()} - whole
    assert len(left) == 2 and all(name.startswith(".partial-") for name in left)
    (tmp_path / ".partial-notes").write_text("of somebody else")
    with whole_files(tmp_path) as living:
        place = living.new("living.csv")
        place.write_text("whole")
        write(small, "to_csv", tmp_path)
        assert place.exists(), "what another is writing stays"
    assert {path.name for path in tmp_path.iterdir()} == whole | {"living.csv", ".partial-notes"}


def test_the_permissions_are_those_of_any_file(small, tmp_path):
    (tmp_path / "mine").touch()
    for path in (*small.to_csv(tmp_path / "csv", only="grid"), small.to_netcdf(tmp_path / "x.nc", only="grid"), small.to_matlab(tmp_path / "x.mat", only="grid")):
        assert os.stat(path).st_mode == os.stat(tmp_path / "mine").st_mode


def test_texts_are_no_formulas_of_spreadsheets(tmp_path):
    cells = np.array(["=1+1", "-3", "@SUM(A1)", "word"], dtype=object)
    table = tables.Table("own", [tables.Column("+head", cells.dtype, {})], {}, lambda: iter([[cells]]))
    with whole_files(tmp_path / "tables") as written:
        comma._write(table, written)
    assert written.paths[0].read_text().splitlines() == ["'+head", "'=1+1", "-3", "'@SUM(A1)", "word"]
