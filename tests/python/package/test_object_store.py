"""Studies in object stores: the same as on the disk, fetched when they are used, never written."""

import os
import shutil
import sys

import fsspec
import numpy as np
import pytest
from fsspec.implementations.memory import MemoryFileSystem

import judder
from common import files
from exported import SMALL, bits, study_of


@pytest.fixture(scope="module")
def local(tmp_path_factory):
    return study_of(SMALL, tmp_path_factory.mktemp("local") / "study")


@pytest.fixture
def memory(local):
    """The study in the memory file system of fsspec, under bucket/study."""
    store = fsspec.filesystem("memory")
    # there is one for the whole process, and the examples of the book use it, too
    if store.exists("/bucket"):
        store.rm("/bucket", recursive=True)
    store.put(str(local.folder), "/bucket/study", recursive=True)
    yield store
    store.rm("/bucket", recursive=True)


@pytest.fixture
def fetched(memory, monkeypatch):
    """The files that are read from it, with the ranges asked for."""
    found, read = [], MemoryFileSystem.cat_file

    def cat_file(self, path, start=None, end=None, **options):
        found.append((path.removeprefix("/bucket/study/"), start, end))
        return read(self, path, start, end, **options)

    monkeypatch.setattr(MemoryFileSystem, "cat_file", cat_file)
    return found


def assert_same(remote, local):
    """Every name, bit, table and figure."""
    assert [*remote] == [*local] and remote.summary == local.summary and remote.complete == local.complete
    for name in local:
        mine, other = remote[name].compute(), local[name].compute()
        assert mine.identical(other), name
        assert all(bits(mine[variable].values) == bits(other[variable].values) for variable in other.variables)
    for name in local.sweeps:
        assert remote.failed_points(name).equals(local.failed_points(name)) and len(local.failed_points(name))
    assert remote.figures.keys() == local.figures.keys() and remote.tables.keys() == local.tables.keys()
    for name, path in {**local.figures, **local.tables}.items():
        found = {**remote.figures, **remote.tables}[name]
        assert found.read_bytes() == path.read_bytes() and found.name == path.name
    assert remote.report.read_text() == local.report.read_text(encoding="utf-8")
    assert remote._repr_html_() == local._repr_html_()


def test_a_study_in_a_store_is_that_of_the_disk(memory, local):
    study = judder.load_study("memory://bucket/study")
    assert_same(study, local)
    assert str(study.folder) == "memory://bucket/study" and "memory://bucket/study" in repr(study)
    assert str(study.figures["map"]) == "memory://bucket/study/figures/map.svg" and study.report.exists() and study.report.is_file()
    assert_same(judder.load_study(study.folder), local)


def test_opening_fetches_no_values(fetched, local):
    study = judder.load_study("memory://bucket/study")
    assert [path for path, _, _ in fetched] == ["summary.json", "manifest.json"]
    data = study["grid"]
    values = [one for one in fetched if one[0].startswith("results.zarr/grid/values/c")]
    assert values == [] and data.growth_rate.dims == ("velocity", "shear_strength")
    # what is fetched beside metadata are coordinates: names, units, swept values
    chunks = {path for path, _, _ in fetched if "/c/" in path}
    assert all(path.split("/")[2].startswith("quantity") or path.split("/")[2].rpartition(".")[2] in data.coords for path in chunks)
    study["map"]
    assert not any("/growth_rate/c" in path for path, _, _ in fetched)


def test_a_point_fetches_a_part_of_its_chunk(fetched, local):
    values = local["samples"].growth_rate.values
    point = int(np.flatnonzero(~np.isnan(values))[-1])
    study = judder.load_study("memory://bucket/study")
    assert float(study["samples"].growth_rate[point]) == values[point]
    fetched.clear()
    plain = judder._swept.dataset(study.folder, "samples", dask=False).growth_rate
    assert float(plain[point]) == values[point]
    chunks = [one for one in fetched if one[0].startswith("results.zarr/samples/values/c.")]
    assert {path.rpartition("/")[2] for path, _, _ in chunks} == {f"c.{point // 16}.0"} and all(start is not None for _, start, _ in chunks)


def test_functions_that_want_a_file_get_a_copy(memory, local):
    import pandas

    study = judder.load_study("memory://bucket/study")
    assert pandas.read_csv(study.tables["grid"]).equals(pandas.read_csv(local.tables["grid"]))
    path = os.fspath(study.tables["grid"])
    assert os.path.basename(path) == "grid.csv" and os.path.isfile(path)
    with study.tables["grid"].open() as file:
        assert file.readline() == local.tables["grid"].read_text().splitlines(keepends=True)[0]
    with pytest.raises(judder.StoreError, match="memory://bucket/study: a folder of an object store has no path on this machine"):
        os.fspath(study.folder)
    with pytest.raises(FileNotFoundError, match=r"memory://bucket/study/none\.csv: not there"):
        (study.folder / "none.csv").read_bytes()


def test_the_law_of_a_study_is_read_from_the_store(memory, tmp_path):
    law = judder.contact.Law.from_function(lambda v, y: (4 / 3 * y**1.5, np.pi * y, 0 * v), velocity=(1e-6, 1e2), indentation=(1e-6, 1e-1))
    speeds = {"key": "operation.velocity", "from": 1e-4, "to": 1e-2, "points": 3}
    own = study_of({"model": "oscillator", "analysis": [{"name": "s", "kind": "spectrum", "sweep": speeds}]}, tmp_path / "own", law=law)
    memory.put(str(own.folder), "/bucket/own", recursive=True)
    assert judder.contact.Law.load(judder.load_study("memory://bucket/own").folder / "law.json") == law


def test_exports_from_a_store_are_those_from_the_disk(memory, local, tmp_path):
    study = judder.load_study("memory://bucket/study")
    for own, name in ((local, "local"), (study, "remote")):
        own.to_csv(tmp_path / name)
        own.to_parquet(tmp_path / name)
        own.to_netcdf(tmp_path / name / "x.nc")
        own.to_matlab(tmp_path / name / "x.mat")
    assert files(tmp_path / "local") == files(tmp_path / "remote")


def writers():
    """Everything that would write into a study."""
    sweep = judder.sweep.plan(SMALL, "grid")
    yield "run", lambda place: judder.run(SMALL, output=place)
    yield "distributed", lambda place: judder.distributed.run_with(SMALL, lambda: None, output=place)
    for name, arguments in (("write", (0, b"")), ("run", ()), ("merge", ()), ("missing", ()), ("estimate", ())):
        yield f"sweep.{name}", lambda place, name=name, arguments=arguments: getattr(sweep, name)(place, *arguments)


@pytest.mark.parametrize(("name", "write"), [*writers()], ids=[name for name, _ in writers()])
def test_what_would_write_says_that_it_does_not(name, write, memory, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    before = {path: memory.cat_file(path) for path in memory.find("/bucket")}
    for place in ("memory://bucket/study", judder.load_study("memory://bucket/study").folder, "s3://bucket/study"):
        with pytest.raises(judder.StoreError, match="studies in an object store are read and never written; name a folder of this machine") as caught:
            write(place)
        assert caught.value.cause == "ReadOnly" and caught.value.path == str(place)
    assert {path: memory.cat_file(path) for path in memory.find("/bucket")} == before and list(tmp_path.iterdir()) == []


def test_paths_in_a_store_are_read_only(memory):
    path = judder.load_study("memory://bucket/study").folder / "summary.json"
    for write in (path.write_text, path.write_bytes, path.unlink, path.rename, path.touch, path.mkdir):
        with pytest.raises(judder.StoreError, match="read and never written"):
            write("x")
    with pytest.raises(judder.StoreError, match="read and never written"):
        path.open("w")


def test_places_of_this_machine(local, tmp_path, monkeypatch):
    shutil.copytree(local.folder, tmp_path / "my study")
    monkeypatch.setenv("HOME", str(tmp_path))
    for place in (tmp_path / "my study", str(tmp_path / "my study"), "~/my study", (tmp_path / "my study").as_uri(), f"file://{tmp_path}/my study"):
        study = judder.load_study(place)
        assert study.folder == tmp_path / "my study" and study.summary == local.summary
    assert study_of(SMALL, "~/my study", only=["spectrum"]).folder == tmp_path / "my study"
    with pytest.raises(judder.InputError, match="files of another machine have no such address; file:///server/… is one here"):
        judder.load_study("file://server/study")
    with pytest.raises(judder.InputError, match="storage_options: .* is a folder of this machine, which takes none"):
        judder.load_study(local.folder, storage_options={"anon": True})


def test_archives_and_paths_of_other_packages(memory, local, tmp_path):
    upath = pytest.importorskip("upath")
    archive = shutil.make_archive(str(tmp_path / "study"), "zip", local.folder.parent, "study")
    memory.put(archive, "/bucket/study.zip")
    assert_same(judder.load_study("zip://study::memory://bucket/study.zip"), local)
    assert_same(judder.load_study(f"zip://study::file://{archive}"), local)
    assert_same(judder.load_study(upath.UPath("memory://bucket/study")), local)
    assert str(judder.load_study("zip://study::memory://bucket/study.zip").report) == "zip://study/report.html::memory://bucket/study.zip"


def test_what_is_not_there_is_told(memory):
    with pytest.raises(judder.StudyError, match="memory://bucket/none: no study here") as caught:
        judder.load_study("memory://bucket/none")
    assert caught.value.cause == "NoStudy"
    with pytest.raises(judder.StudyError, match="no study here"):
        judder.load_study("zip::memory://bucket/none.zip")
    with pytest.raises(judder.InputError, match=r"magic://bucket: cannot be opened \(Protocol not known: magic\)"):
        judder.load_study("magic://bucket")
    memory.rm("/bucket/study/results.zarr/grid/values/c.1.1.0")
    with pytest.raises(judder.StoreError, match=r"memory://bucket/study/results.zarr/grid/values/c\.1\.1\.0: this chunk is not there"):
        judder.load_study("memory://bucket/study").failed_points("grid")


def test_packages_that_are_missing_are_named(memory, monkeypatch):
    with pytest.raises(judder.PackageError, match="gs://bucket/study: .*gcsfs"):
        judder.load_study("gs://bucket/study")
    monkeypatch.setitem(sys.modules, "fsspec.core", None)
    with pytest.raises(judder.PackageError, match=r"an address needs the package fsspec .*: pip install 'judder\[remote\]'"):
        judder.load_study("memory://bucket/study")


def test_a_store_that_refuses_is_told(memory, monkeypatch):
    study = judder.load_study("memory://bucket/study")

    def refuse(*_, **__):
        raise PermissionError("Forbidden")

    def unlisted(*_, **__):
        raise FileNotFoundError("no index page")

    monkeypatch.setattr(MemoryFileSystem, "ls", unlisted)
    with pytest.raises(judder.StoreError, match="this store lists no files; name one, such as `study.folder / 'figures/map.svg'`"):
        study.figures  # noqa: B018
    monkeypatch.setattr(MemoryFileSystem, "ls", refuse)
    with pytest.raises(judder.StoreError, match=r"cannot be read \(PermissionError: Forbidden\)"):
        study.tables  # noqa: B018
    monkeypatch.setattr(MemoryFileSystem, "cat_file", refuse)
    with pytest.raises(judder.StudyError, match=r"the summary cannot be read \(.*PermissionError: Forbidden\)"):
        judder.load_study("memory://bucket/study")


def test_a_study_without_figures_has_none(memory):
    memory.rm("/bucket/study/figures", recursive=True)
    assert judder.load_study("memory://bucket/study").figures == {}


@pytest.fixture(scope="module")
def endpoint():
    """An S3 endpoint of this machine."""
    from moto.moto_server.threaded_moto_server import ThreadedMotoServer

    server = ThreadedMotoServer(ip_address="127.0.0.1", port=0, verbose=False)
    server.start()
    host, port = server.get_host_and_port()
    yield f"http://{host}:{port}"
    server.stop()


def test_a_study_in_s3(endpoint, local, tmp_path):
    import s3fs

    options = {"key": "key", "secret": "secret", "client_kwargs": {"endpoint_url": endpoint}}
    store = s3fs.S3FileSystem(**options)
    store.mkdir("judder")
    store.put(str(local.folder), "judder/study", recursive=True)
    study = judder.load_study("s3://judder/study", storage_options=options)
    assert_same(study, local)
    assert str(study.report) == "s3://judder/study/report.html"
    study.to_csv(tmp_path / "csv", only="grid")
    assert (tmp_path / "csv" / "grid.csv").is_file()
    with pytest.raises(judder.StudyError, match="s3://judder/none: no study here"):
        judder.load_study("s3://judder/none", storage_options=options)
    before = store.find("judder")
    with pytest.raises(judder.StoreError, match="read and never written"):
        judder.run(SMALL, output="s3://judder/study")
    assert store.find("judder") == before
