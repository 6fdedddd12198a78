"""Objects in the place of files: what they leave is what the files leave, and what is wrong with one is told by its key."""

import copy
import json
import pickle
import subprocess
import sys

import meshio
import numpy as np
import pandas
import pytest
import scipy.sparse

import judder
from common import files
from judder import _keys, _objects, _written

MODES = {"kind": "modes", "count": 3}


def chain(count, spring=1e6):
    """The matrices of a chain of masses between two walls."""
    side = np.full(count - 1, -spring)
    return scipy.sparse.eye_array(count), scipy.sparse.diags_array([side, np.full(count, 2 * spring), side], offsets=[-1, 0, 1])


def frequencies(matrices, **more):
    return judder.models.Structure(matrices=matrices, **more).modes(count=3).numbers["frequencies_hz"]


@pytest.mark.parametrize("form", ["bsr", "coo", "csc", "csr", "dia", "dok", "lil"])
def test_sparse_matrices_of_every_form_are_those_of_a_file(form, tmp_path):
    mass, stiffness = chain(50)
    for name, matrix in (("mass", mass), ("stiffness", stiffness)):
        scipy.sparse.save_npz(tmp_path / f"{name}.npz", matrix.tocsr())
    of_files = {name: [{"file": str(tmp_path / f"{name}.npz")}] for name in ("mass", "stiffness")}
    assert frequencies({"mass": mass.asformat(form), "stiffness": stiffness.asformat(form)}) == frequencies(of_files)
    old = {"mass": scipy.sparse.coo_matrix(mass), "stiffness": getattr(scipy.sparse, f"{form}_matrix")(stiffness)}
    assert frequencies(old) == frequencies(of_files)


def test_dense_matrices_sums_and_names_of_matrices():
    mass, stiffness = chain(20)
    expected = frequencies({"mass": mass, "stiffness": stiffness})
    assert np.allclose(frequencies({"mass": mass.toarray(), "stiffness": stiffness.toarray().astype(np.float32)}), expected)
    named = {"springs": {"file": stiffness, "factor": "half"}, "others": {"file": stiffness.tocsc(), "factor": "1 - half"}}
    assert np.allclose(frequencies({"mass": [mass], "stiffness": named}, parameters={"half": 0.5}), expected)
    source = _objects.CaseSource({"model": "structure", "matrices": {"mass": mass, "stiffness": named}})
    assert 'file = "inputs/matrices.stiffness.springs.npz", factor = "half"' in source.given[1]


def test_freedoms_are_numbers_with_sparse_matrices_and_names_with_small_ones():
    mass, stiffness = chain(4)
    names = [["a", "x"], ["a", "y"], ["b", "x"], ["b", "y"]]
    columns = pandas.DataFrame({"node": [1, 1, 2, 2], "direction": ["x", "y", "x", "y"], "x": [0.0, 0.0, 0.1, 0.1]})
    for freedoms in (names, [(1, "x"), (1, "y"), (2, "x"), (2, "y")], columns):
        found = judder.models.Structure(matrices={"mass": mass, "stiffness": stiffness, "freedoms": freedoms}).modes(count=3)
        assert found.data.shape.sizes["shown_mode"] == 3
    assert found.data.place.values.max() == 0.1


def plate(count=4):
    """A plate of squares, its left and right edge sets of points, its halves sets of cells."""
    side = np.arange(count + 1)
    points = np.array([(0.1 * x, 0.1 * y) for y in side for x in side])
    squares = [(y * (count + 1) + x + np.array([0, 1, count + 2, count + 1])) for y in range(count) for x in range(count)]
    sets = {"left": side * (count + 1), "right": side * (count + 1) + count}
    halves = [[cell for cell in range(count**2) if (cell % count < count // 2) == is_left] for is_left in (True, False)]
    return points, np.array(squares), sets, {"soft": [halves[0]], "hard": [halves[1]]}


STEEL = {"youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m^3"}
RUBBER = {**STEEL, "youngs_modulus": "5 MPa"}
HELD = {"supports": [{"set": "left", "fixed": ["x", "y"]}], "material": STEEL}


def test_a_mesh_of_millimetres_without_a_unit_is_remarked_on():
    points, squares, sets, _ = plate()
    mesh = {"points": 300.0 * points, "cells": {"quad": squares}, "point_sets": sets}
    warnings = judder.check({"model": "structure", "structure": {"mesh": mesh, **HELD}})["warnings"]
    assert len(warnings) == 1 and "`structure.mesh`" in warnings[0] and "120 m long" in warnings[0] and 'unit = "mm"' in warnings[0], warnings
    for unit in ("mm", "m"):
        assert judder.check({"model": "structure", "structure": {"mesh": mesh, "unit": unit, **HELD}})["warnings"] == []


def test_meshes_of_meshio_and_of_arrays_are_those_of_a_file(tmp_path):
    points, squares, sets, halves = plate()
    mesh = meshio.Mesh(points, [("quad", squares)], point_sets=sets, cell_sets=halves)
    arrays = {"points": points, "cells": {"quad": squares}, "point_sets": sets, "cell_sets": halves}
    meshio.Mesh(np.pad(points, ((0, 0), (0, 1))), [("quad", squares)], point_sets=sets).write(tmp_path / "plate.inp")
    deck = (tmp_path / "plate.inp").read_text("utf-8").replace("CAX4P", "CPS4I")
    (tmp_path / "plate.inp").write_text(deck, "utf-8")
    found = [judder.models.Structure(structure={"mesh": own, **HELD}).modes(count=3).data.frequency for own in (mesh, arrays, str(tmp_path / "plate.inp"))]
    assert found[0].equals(found[1]) and found[0].equals(found[2])
    two = {**HELD, "materials": {"soft": RUBBER, "hard": STEEL}}
    softer = judder.models.Structure(structure={"mesh": mesh, **two}).modes(count=3).data.frequency
    assert float(softer[0]) < 0.1 * float(found[0][0])


def test_groups_of_gmsh_are_sets():
    points, squares, sets, _ = plate()
    edge = np.column_stack([sets["left"][:-1], sets["left"][1:]])
    tags = {"gmsh:physical": [np.full(len(edge), 7), np.full(len(squares), 7)]}
    mesh = meshio.Mesh(points, [("line", edge), ("quad", squares)], cell_data=tags, field_data={"left": [7, 1], "whole": [7, 2]})
    assert judder.models.Structure(structure={"mesh": mesh, **HELD}).modes(count=1).numbers["degrees_of_freedom"] == 2 * (25 - 5)


@pytest.mark.filterwarnings("ignore::judder.JudderWarning")
@pytest.mark.parametrize(("kind", "nodes"), [("hexahedron", 8), ("hexahedron20", 20), ("tetra10", 10), ("quad8", 8), ("triangle6", 6)])
def test_every_kind_of_cell_has_its_nodes_in_order(kind, nodes):
    corners = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)], dtype=float)
    bottom = [(0, 1), (1, 2), (2, 3), (3, 0)]
    edges = {
        "hexahedron": [],
        "hexahedron20": [*bottom, (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)],
        "tetra10": [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)],
        "quad8": bottom,
        "triangle6": [(0, 1), (1, 2), (2, 0)],
    }[kind]
    first = {"tetra10": corners[[0, 1, 3, 4]], "quad8": corners[:4], "triangle6": corners[:3]}.get(kind, corners)
    points = np.vstack([first, *((first[a] + first[b])[None] / 2 for a, b in edges)])
    mesh = meshio.Mesh(points, [(kind, np.arange(nodes)[None])], point_sets={"left": [0]})
    told = judder.models.Structure(structure={"mesh": mesh, "material": STEEL, "supports": []}).modes(count=8)
    # a body that nothing holds has its rigid motions: six in space, three in the plane
    assert told.numbers["rigid_modes"] == (6 if points[:, 2].any() else 3)


def moduli():
    frequency = np.logspace(-2, 4, 40)
    modulus = 1e6 + 9e6 * 2j * np.pi * frequency * 0.01 / (1 + 2j * np.pi * frequency * 0.01)
    return frequency, modulus


def test_measured_moduli_are_columns(tmp_path):
    frequency, modulus = moduli()
    columns = {"frequency [Hz]": frequency, "E' [Pa]": modulus.real, "E'' [Pa]": modulus.imag}
    pandas.DataFrame(columns).to_csv(tmp_path / "dma.csv", index=False)

    def groups(dma):
        return judder.check({"model": "oscillator", "contact": {"law": "hertz"}, "substrate": {"dma": dma}})["groups"]

    expected = groups({"file": str(tmp_path / "dma.csv"), "terms": 1})
    for given in (columns, {"frequency [Hz]": frequency, "E [Pa]": modulus}):
        assert groups({**given, "terms": 1}) == expected
        assert groups({"file": given, "terms": 1}) == expected
    assert groups(pandas.DataFrame(columns)) == groups({"file": str(tmp_path / "dma.csv")})


def test_series_are_columns_and_keys_have_units():
    rows = [{"time": "0.001 s", "compliance": "1e-7 1/Pa"}, {"time": "0.1 s", "compliance": "2e-7 1/Pa"}]
    columns = {"time [ms]": np.array([1.0, 100.0]), "compliance [1/MPa]": [0.1, 0.2]}
    written, given = (judder.check({"model": "oscillator", "contact": {"law": "hertz"}, "substrate": {"prony": own}}) for own in (rows, columns))
    assert written["groups"] == pytest.approx(given["groups"])
    speed = judder.check({"model": "oscillator", "operation": {"velocity [mm/s]": np.float32(30)}})
    assert speed["groups"] == judder.check({"model": "oscillator", "operation": {"velocity": "30 mm/s"}})["groups"]
    assert judder.check({"model": "oscillator"}, set={"operation.velocity [mm/s]": 30})["groups"] == speed["groups"]


def test_heights_are_an_array(tmp_path):
    side = np.linspace(-1.0, 1.0, 32)
    heights = 1e-3 * (side[:, None] ** 2 + side**2)
    np.save(tmp_path / "heights.npy", heights)

    def touched(given):
        shape = {"heights": given, "spacing": "0.1 mm"}
        contact = judder.models.Contact(indenter={"shape": shape, "radius": "10 mm"}, substrate={"retardation_time": "10 ms"})
        return contact.contact(velocity="1 mm/s", indentation="0.1 mm", accuracy=0.2).numbers

    assert touched(heights) == touched(str(tmp_path / "heights.npy")) == touched(heights[::-1, ::-1].copy()[::-1, ::-1])


def test_laws_are_objects_too(tmp_path):
    law = judder.contact.Law.from_function(lambda v, y: (y**1.5 + 0 * v, np.pi * y + 0 * v, 0.1 * v / (1 + v**2)), velocity=(1e-5, 1e2), indentation=(1e-7, 1e-1))
    law.save(tmp_path / "law.json")
    in_memory, in_file = ({"model": "oscillator", "contact": {"law": own}} for own in (law, {"file": str(tmp_path / "law.json")}))
    assert judder.check(in_memory)["groups"] == judder.check(in_file)["groups"]
    assert judder.check({"model": "oscillator"}, set={"contact.law": judder.contact.Law("hertz")})["case"]["contact"]["law"] == "hertz"


def test_objects_go_over_a_case_file(tmp_path):
    mass, stiffness = chain(10)
    case = {"model": "structure", "matrices": {"mass": mass, "stiffness": stiffness}, "analysis": [MODES]}
    study = judder.run(case, output=tmp_path / "study")
    (tmp_path / "study" / "case.toml").write_text(study.summary["study"]["source"], "utf-8")
    path = tmp_path / "study" / "case.toml"
    twice = judder.models.Structure(path, matrices={"stiffness": 4 * stiffness}).modes(count=3).numbers["frequencies_hz"]
    assert np.allclose(twice, 2 * np.array(study.results["modes"]["frequencies_hz"]))
    run = judder.run(path, set={"matrices.stiffness": 4 * stiffness}, output=tmp_path / "twice")
    assert run.results["modes"]["frequencies_hz"] == twice


def test_friction_laws_are_sampled_as_finely_as_they_ask():
    def stribeck(velocity):
        return 0.2 + 0.2 * np.exp(-velocity / 0.05) + 0.1 * velocity

    velocity, coefficient = judder.sliding.friction_table(stribeck, velocity=(0.0, 2.0), tolerance=1e-3)
    between = np.linspace(0.0, 2.0, 5001)
    assert np.abs(np.interp(between, velocity, coefficient) - stribeck(between)).max() < 1e-3 * stribeck(0.0)
    assert 20 < velocity.size < 200
    with pytest.raises(judder.InputError, match="not finite"):
        judder.sliding.friction_table(lambda velocity: velocity * np.nan, velocity=(0.0, 1.0))
    with pytest.raises(judder.InputError, match="jump"):
        judder.sliding.friction_table(lambda velocity: np.where(velocity < 0.3, 0.5, 0.2), velocity=(0.0, 1.0))
    with pytest.raises(judder.InputError, match="does not take"):
        judder.check({"model": "belt", "operation": {"velocity": stribeck}})


def test_a_friction_law_that_is_negative_is_one_error_with_its_speed():
    with pytest.raises(judder.InputError, match=r"is -0\.\d+ at a speed of [\d.e-]+; a friction coefficient is zero or more at every speed") as told:
        judder.models.Belt(oscillator={"damping": 0.05}, friction=lambda velocity: 0.3 - velocity, operation={"velocity": 0.1}).check()
    assert str(told.value).count("friction coefficient") == 1


def test_friction_laws_stand_wherever_a_friction_coefficient_does():
    def law(velocity):
        return 0.5 + 0.5 * np.exp(-velocity / 0.5)

    def period(friction):
        start = {"x": 1.0, "velocity_x": 1.5}
        belt = {"oscillator": {"damping": 0.05}, "friction": friction, "operation": {"velocity": 1.5}}
        case = {"model": "belt", **belt, "analysis": [{"kind": "limit-cycle", "name": "cycle", "start": start}]}
        return judder.run(case, output=None).results["cycle"]["period"]

    exact = period({"at_rest": 1.0, "at_speed": 0.5, "decay_speed": 0.5})
    speeds = np.linspace(0.0, 5.0, 1001)
    assert abs(period(law) / exact - 1) < 1e-4
    assert abs(period((speeds, law(speeds))) / exact - 1) < 1e-4
    assert abs(period({"velocity": speeds, "coefficient": law(speeds)}) / exact - 1) < 1e-4
    assert abs(period({"file": {"speed": speeds, "coefficient": law(speeds)}}) / exact - 1) < 1e-4

    mass = {"name": "m", "matrices": {"mass": [[1, 0], [0, 1]], "stiffness": [[1, 0], [0, 0]], "freedoms": [["m", "x"], ["m", "y"]]}}
    contact = {"name": "belt", "slider": {"structure": "m", "set": "m"}, "track": {"plane": {"normal": [0, 1]}}, "sliding": {"velocity": "1 m/s", "direction": [1, 0]}}
    load = {"structure": "m", "set": "m", "direction": "y", "force": "-1 N"}
    table = {"velocity [m/s]": speeds, "coefficient": law(speeds)}
    growths = []
    for friction in [law, (speeds, law(speeds)), table]:
        case = {"model": "assembly", "structure": [mass], "contact": [{**contact, "friction_coefficient": friction}], "load": [load]}
        study = judder.run({**case, "analysis": [{"kind": "eigen", "name": "eigen", "region": {"frequency": ["0 Hz", "1 Hz"], "damping_ratio": [-0.9, 0.9]}}]}, output=None)
        growths.append(sum(study.results["eigen"]["growing"][0]["growth"].values()))
    # a mass on a belt grows with −N μ′(v)/2 of a law that falls; a table is straight above the speed of the belt
    chord = (law(1.0) - law(1.005)) / 0.005
    assert np.allclose(growths[1:], 0.5 * chord, rtol=1e-9)
    assert np.allclose(growths[0], 0.5 * np.exp(-2.0), rtol=1e-3)


def test_a_study_keeps_its_inputs_and_goes_on(tmp_path, monkeypatch, command):
    monkeypatch.chdir(tmp_path)
    mass, stiffness = chain(30)
    case = {"model": "structure", "title": "A chain", "matrices": {"mass": mass, "stiffness": stiffness}, "analysis": [MODES]}
    first = judder.run(case, output=True)
    began = files(first.folder)["summary.json"]
    again = judder.run({**case, "matrices": {"mass": mass.tocsc(), "stiffness": stiffness.tolil()}}, output=True)
    assert again.folder == first.folder and again.hashes == first.hashes
    assert json.loads(files(first.folder)["summary.json"])["analyses"] == json.loads(began)["analyses"]
    assert {"inputs/matrices.mass.npz", "inputs/matrices.stiffness.npz"} < {*files(first.folder)}
    assert not any(b"/judder-" in content for content in files(first.folder).values())
    # what the study says of its case is a case that runs beside its inputs
    (first.folder / "case.toml").write_text(first.summary["study"]["source"], "utf-8")
    command("run", first.folder / "case.toml", "--output", tmp_path / "again")
    assert judder.load_study(tmp_path / "again").hashes == first.hashes
    other = judder.run(case, set={"matrices.stiffness": 2 * stiffness}, output=True)
    assert other.folder != first.folder


def test_files_beside_objects_are_where_they_were(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    mass, stiffness = chain(10)
    (tmp_path / "some").mkdir()
    scipy.sparse.save_npz("some/mass.npz", mass.tocsr())
    expected = frequencies({"mass": mass, "stiffness": stiffness})
    for matrices in ({"folder": "some", "mass": [{"file": "mass.npz"}]}, {"mass": [{"file": tmp_path / "some" / "mass.npz"}]}):
        case = {"model": "structure", "matrices": {**matrices, "stiffness": stiffness}, "analysis": [MODES]}
        assert judder.run(case, output="out").results["modes"]["frequencies_hz"] == expected


@pytest.mark.filterwarnings("ignore::judder.JudderWarning")
def test_sweeps_have_their_objects_wherever_they_run(tmp_path):
    frequency, modulus = moduli()
    sweep = {"over": [{"key": "operation.velocity", "values": [1e-3, 1e-2, 1e-1]}], "quantities": ["growth_rate"], "chunk": 1, "name": "speeds"}
    dma = {"frequency [Hz]": frequency, "E [Pa]": modulus}
    case = {"model": "oscillator", "contact": {"law": "hertz"}, "substrate": {"dma": dma}, "sweep": [sweep]}
    plan = judder.sweep.plan(case)
    assert copy.copy(plan) is plan and copy.deepcopy([plan])[0] is plan
    for chunk in plan.missing(tmp_path / "by-hand"):
        plan.write(tmp_path / "by-hand", chunk, plan.compute(chunk))
    by_hand = plan.merge(tmp_path / "by-hand")
    assert by_hand["speeds"].load().equals(judder.run(case, output=tmp_path / "run")["speeds"].load())
    assert (by_hand.folder / "inputs" / "substrate.dma.csv").exists()
    # elsewhere: all that it needs travels with it
    script = "import pathlib, pickle, sys; sweep = pickle.loads(pathlib.Path('sweep').read_bytes()); sweep.run('elsewhere'); sweep.merge('elsewhere')"
    (tmp_path / "sweep").write_bytes(pickle.dumps(plan))
    del plan
    subprocess.run([sys.executable, "-W", "ignore", "-c", script], cwd=tmp_path, check=True)
    assert judder.load_study(tmp_path / "elsewhere").hashes == by_hand.hashes
    assert files(tmp_path / "elsewhere" / "inputs") == files(by_hand.folder / "inputs")


ENDLESS = []
ENDLESS.append(ENDLESS)
SQUARE = np.eye(3)


@pytest.mark.parametrize(
    ("case", "key", "words"),
    [
        ({"matrices": {"mass": scipy.sparse.eye_array(3) * 1j}}, "matrices.mass", "complex numbers"),
        ({"matrices": {"mass": scipy.sparse.eye_array(3, 4)}}, "matrices.mass", "a square matrix"),
        ({"matrices": {"stiffness": [SQUARE, np.full((3, 3), np.nan)]}}, "matrices.stiffness.1", "nan at (0, 0)"),
        ({"matrices": {"mass": np.zeros((0, 0))}}, "matrices.mass", "a square matrix"),
        ({"matrices": {"mass": np.array([[object()]])}}, "matrices.mass", "objects of Python"),
        ({"matrices": {"mass": [{"file": [1.0]}]}}, "matrices.mass", "a sparse matrix of SciPy"),
        ({"matrices": {"mass": scipy.sparse.csr_array(np.triu(np.ones((3, 3))))}}, "matrices.mass", "as-stored"),
        ({"matrices": {"mass": SQUARE, "freedoms": [(1, "x"), (2, "u")]}}, "matrices.freedoms.direction", "'u'"),
        ({"matrices": {"mass": scipy.sparse.eye_array(600), "freedoms": [["a", "x"]]}}, "matrices.mass", "number the nodes"),
        ({"structure": {"mesh": [3.5]}}, "structure.mesh", "a mesh of meshio"),
        ({"structure": {"mesh": {"points": SQUARE, "cells": {"triangle": [[0, 1, 2]]}}}}, "structure.mesh", "which judder does not have"),
        ({"structure": {"mesh": {"points": SQUARE, "cells": {"quad": [[0, 1, 2, 3]]}}}}, "structure.mesh.cells.quad", "3 points"),
        ({"structure": {"mesh": {"points": SQUARE, "cells": {"quad": [[0, 1, 2]]}}}}, "structure.mesh.cells.quad", "4 are needed"),
        ({"structure": {"mesh": {"points": SQUARE, "cells": {}}}}, "structure.mesh.cells", "is empty"),
        ({"structure": {"mesh": {"points": np.zeros((0, 2)), "cells": {}}}}, "structure.mesh.points", "not empty"),
        ({"title": ENDLESS}, "title", "itself"),
        ({"parameters": {"a": scipy.sparse.eye_array(3)}}, "parameters.a", "not"),
    ],
)
def test_a_wrong_object_is_told_by_its_key(case, key, words):
    with pytest.raises(judder.InputError) as caught:
        judder.check({"model": "structure", **case})
    assert caught.value.argument.startswith(key) and words in str(caught.value)


def test_wrong_columns_are_told_by_their_names():
    for dma, words in (
        ({"frequency [Hz]": [1.0, 2.0], "E [Pa]": [1.0]}, "the same length"),
        ({"frequency [Hz]": [], "E [Pa]": []}, "(0,)"),
        ({"frequency [Hz]": [1.0, np.inf], "E [Pa]": [1j, 2j]}, "inf at (1)"),
        (np.ones(3), "columns of numbers"),
    ):
        with pytest.raises(judder.InputError, match="substrate.dma") as caught:
            judder.check({"model": "oscillator", "substrate": {"dma": dma}})
        assert words in str(caught.value)
    with pytest.raises(judder.InputError, match="given twice"):
        judder.check({"model": "oscillator", "operation": {"velocity": 1e-3, "velocity [mm/s]": 3.0}})


def test_errors_name_the_key_and_no_folder_of_ours():
    dma = {"frequency [Hz]": [2.0, 1.0], "E [Pa]": [1e6 + 1e5j, 2e6 + 1e5j]}
    case = {"model": "oscillator", "contact": {"law": "hertz"}, "substrate": {"dma": dma}}
    with pytest.raises(judder.JudderError) as caught:
        judder.check(case)
    assert "`substrate.dma`" in str(caught.value)
    with pytest.raises(judder.CaseError) as told:
        judder.check({**case, "operation": {"velocity": "30 N"}})
    for error in (caught.value, told.value):
        assert "/judder-" not in f"{error} {error.fields} {getattr(error, '__notes__', '')}"
    assert told.value.file == "tables" and told.value.line is None


def test_a_study_is_the_path_of_its_folder(map_case, tmp_path):
    study = judder.run(map_case, output=tmp_path / "study", only=["spectrum"])
    given = {"model": "assembly", "analysis": [{"kind": "limit-cycle", "start": {"study": study, "analysis": "cycle"}}]}
    assert f'study = "{tmp_path / "study"}"' in _objects.CaseSource(given).given[1]
    with pytest.raises(judder.InputError, match="judder.Study or the path"):
        judder.check({"model": "assembly", "analysis": [{"kind": "limit-cycle", "start": {"study": SQUARE}}]})


def test_every_key_of_a_file_takes_an_object():
    endings = {"mesh": ".inp", "heights": ".npy", "freedoms": ".csv", "matrices": ".npz", "law": ".json"}
    points, squares, _, _ = plate(1)
    objects = {
        ".inp": {"points": points, "cells": {"quad": squares}},
        ".npy": SQUARE,
        ".npz": SQUARE,
        ".json": judder.contact.Law.from_function(lambda v, y: (y + 0 * v, y + 0 * v, y + 0 * v), velocity=(1e-2, 1.0), indentation=(1e-2, 1e-1)),
    }
    for model, paths in _keys.FILES.items():
        assert model in _keys.ROWS
        # a study is in its folder already
        for path in paths.keys() - {"analysis.*.start.study"}:
            at = tuple(path.split("."))
            ending = endings.get(at[-1]) or next((own for part, own in endings.items() if part in at), ".csv")
            value = objects.get(ending, {"node": [1], "direction": ["x"]} if at[-1] == "freedoms" else {"time [s]": [0.0, 1.0], "factor": [1.0, 2.0]})
            assert _written.content(path, at, value, {})[0] == ending, path


def test_freedoms_have_names_beside_sums_of_sparse_matrices():
    mass, stiffness = (own.tocsr() for own in chain(4))
    names = [["a", "x"], ["a", "y"], ["b", "x"], ["b", "y"]]
    half = scipy.sparse.tril(stiffness).tocsr()
    expected = frequencies({"mass": mass, "stiffness": stiffness, "freedoms": names})
    sums = [
        {"whole": {"file": stiffness, "factor": "part"}, "rest": {"file": stiffness.toarray(), "factor": "1 - part"}},
        [{"file": half, "triangle": "lower", "factor": 0.25}, {"file": stiffness, "factor": "0.5*(part + 1)"}],
        {"file": half, "triangle": "lower"},
        [0.5 * stiffness, 0.5 * stiffness.tocoo()],
    ]
    for own in sums:
        assert np.allclose(frequencies({"mass": [mass], "stiffness": own, "freedoms": names}, parameters={"part": 0.5}), expected)
    wrong = [
        ([stiffness, stiffness[:3, :3]], "sum of matrices of the shapes"),
        ([half, stiffness], "on one side of its diagonal"),
        ({"a": stiffness, "b": {"file": "K.mtx"}}, "every term needs a matrix in memory"),
        ({"a": {"file": stiffness, "scale": 2}}, "has the key `scale`"),
    ]
    for own, words in wrong:
        with pytest.raises(judder.InputError, match=words):
            frequencies({"mass": mass, "stiffness": own, "freedoms": names})


def test_objects_set_over_a_case_file_have_the_same_names_everywhere(tmp_path):
    (tmp_path / "case.toml").write_text(
        'model = "structure"\n[structure]\nmesh = "plate.inp"\nmaterial = { youngs_modulus = "210 GPa", poisson_ratio = 0.3, density = "7850 kg/m^3" }\n'
        'supports = [{ set = "left", fixed = ["x", "y"] }]\n[[analysis]]\nname = "modes"\nkind = "modes"\ncount = 3\n'
    )
    points, squares, sets, _ = plate()
    changes = {"structure.mesh": {"points": points, "cells": {"quad": squares}, "point_sets": sets}}
    found = [judder.run(tmp_path / "case.toml", set=changes, output=tmp_path / name) for name in ("first", "second")]
    assert found[0].hashes == found[1].hashes and "judder-" not in json.dumps(found[0].summary["case"])
    assert (tmp_path / "first" / "inputs" / "structure.mesh.inp").is_file()
    with pytest.raises(judder.CaseError, match="no/such.toml"):
        judder.run("no/such.toml", set=changes)


@pytest.mark.expensive
def test_shapes_and_meshes_go_through_pyvista_and_meshio(tmp_path):
    import pyvista

    points, squares, sets, _ = plate()
    found = judder.models.Structure(structure={"mesh": {"points": points, "cells": {"quad": squares}, "point_sets": sets}, **HELD}).modes(count=3)
    (tmp_path / "modes.vtu").write_bytes(found.files["fields/modes.vtu"])
    grid, mesh = pyvista.read(tmp_path / "modes.vtu"), meshio.read(tmp_path / "modes.vtu")
    assert np.array_equal(grid.points, found.data.place.values) and np.array_equal(mesh.points, found.data.place.values)
    assert np.array_equal(mesh.cells_dict["quad"], squares) and grid.n_cells == len(squares)
    for index, name in enumerate(grid.array_names):
        shape = found.data.shape.values[index]
        assert np.allclose(grid[name], shape, rtol=1e-12, atol=1e-12) and np.array_equal(mesh.point_data[name], grid[name])
        assert f"{float(found.data.frequency[index]):.6f} Hz" in name
    # and back: the mesh that pyvista holds is the mesh that was given
    again = {"points": np.asarray(grid.points)[:, :2], "cells": {"quad": grid.cells.reshape(-1, 5)[:, 1:]}, "point_sets": sets}
    expected = found.data.frequency
    assert judder.models.Structure(structure={"mesh": again, **HELD}).modes(count=3).data.frequency.equals(expected)
    assert judder.models.Structure(structure={"mesh": meshio.Mesh(mesh.points[:, :2], mesh.cells, point_sets=sets), **HELD}).modes(count=3).data.frequency.equals(expected)
