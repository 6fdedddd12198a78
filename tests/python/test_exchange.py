"""Matrices and meshes of other libraries come through; what judder writes, they read: SciPy, meshio, pyuff."""

import pathlib
import re
import subprocess
import xml.etree.ElementTree

import hdf5storage
import mat73
import meshio
import numpy as np
import pytest
import pyuff
import scipy.io
import scipy.sparse

from conftest import ROOT

VALIDATION = ROOT / "crates" / "judder-exchange" / "tests" / "validation"
MESHES = VALIDATION / "meshes"


@pytest.fixture(scope="module")
def exchanged(exchange, tmp_path_factory):
    """Gives a file to the example and says what it wrote."""
    folder = tmp_path_factory.mktemp("exchanged")

    def run(source, name):
        done = subprocess.run([exchange, source, folder / name], capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        return folder / name

    return run


def random_matrix(seed, rows=40, columns=40):
    return scipy.sparse.random(rows, columns, 0.1, "csr", rng=np.random.default_rng(seed))


def saved(matrix, folder, kind):
    """The matrix in a file that its own library writes."""
    path = folder / f"matrix.{kind.split()[0]}"
    match kind:
        case "mat v5":
            scipy.io.savemat(path, {"A": matrix.tocsc()})
        case "mat compressed":
            scipy.io.savemat(path, {"A": matrix.tocsc()}, do_compression=True)
        case "mat full":
            scipy.io.savemat(path, {"A": matrix.toarray()})
        case "mat 7.3":
            hdf5storage.savemat(str(path), {"A": matrix.toarray()}, format="7.3", store_python_metadata=False)
        case "mtx":
            scipy.io.mmwrite(path, matrix, precision=17)
        case "mtx array":
            scipy.io.mmwrite(path, matrix.toarray(), precision=17)
        case _:
            form = kind.split()[1]
            scipy.sparse.save_npz(path, matrix.asformat(form), compressed=not kind.endswith("stored"))
    return path


KINDS = ["mat v5", "mat compressed", "mat full", "mat 7.3", "mtx", "mtx array", "npz csr", "npz csc", "npz coo", "npz bsr", "npz dia",
         "npz csr stored"]


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("shape", ["square", "oblong", "symmetric", "skew"])
def test_matrices_come_through_to_the_last_bit(exchanged, tmp_path, kind, shape):
    matrix = random_matrix(1, columns=30 if shape == "oblong" else 40)
    if shape == "symmetric":
        matrix = matrix + matrix.T
    if shape == "skew":
        matrix = matrix - matrix.T
    read = scipy.io.mmread(exchanged(saved(matrix, tmp_path, kind), "matrix.mtx"))
    assert read.shape == matrix.shape
    assert abs(read - matrix).max() == 0.0


@pytest.mark.parametrize("name", ["sparse_73", "sparse_73_compressed", "full_73"])
def test_matrices_of_matlab_7_3_are_those_that_mat73_reads(exchanged, name):
    theirs = mat73.loadmat(VALIDATION / "matrices" / f"{name}.mat")["A"]
    ours = scipy.io.mmread(exchanged(VALIDATION / "matrices" / f"{name}.mat", f"{name}.mtx"))
    assert abs(ours - theirs).max() == 0.0


def cells(mesh, numbers):
    """Each cell as its type and its nodes, by their numbers."""
    return sorted((block.type, *numbers[row]) for block in mesh.cells for row in block.data)


@pytest.mark.parametrize("name", ["quad4", "quad8", "quad8_binary", "quad8_22", "quad8_22_binary", "triangle6",
                                  "hexahedron8", "hexahedron20",
                                  "hexahedron20_binary", "hexahedron20_22_binary", "tetrahedron10", "tetrahedron10_22"])
def test_meshes_of_gmsh_have_the_elements_that_meshio_reads(exchanged, name):
    theirs = meshio.read(MESHES / f"{name}.msh")
    ours = meshio.read(exchanged(MESHES / f"{name}.msh", f"{name}.vtu"))
    kind = ours.cells[0].type
    assert len(ours.cells) == 1
    # Gmsh numbers nodes from 1 without gaps here
    labels = ours.point_data["label"].astype(int)
    np.testing.assert_allclose(ours.points, theirs.points[labels - 1], atol=1e-15)
    expected = np.concatenate([block.data for block in theirs.cells if block.type == kind]) + 1
    found = labels[ours.cells[0].data]
    if name.startswith(("quad", "tri")):
        # these lie on their face, and are turned: same corners from the same first one, the other way round
        assert sorted(map(sorted, found)) == sorted(map(sorted, expected))
    else:
        np.testing.assert_array_equal(found, expected)


@pytest.mark.parametrize("kind", ["quad", "quad8", "triangle6", "hexahedron", "hexahedron20", "tetra10"])
@pytest.mark.parametrize("name", ["mesh.inp", "mesh.msh", "mesh_binary.msh", "mesh_22.msh", "mesh_22_binary.msh"])
def test_meshes_of_meshio_come_through(exchanged, tmp_path, kind, name):
    points = {
        "quad": [(0, 0), (1, 0), (1, 1), (0, 1)],
        "quad8": [(0, 0), (1, 0), (1, 1), (0, 1), (0.5, 0.1), (1, 0.5), (0.5, 1), (0, 0.5)],
        "triangle6": [(0, 0), (1, 0), (0, 1), (0.5, 0.1), (0.5, 0.5), (0, 0.5)],
        "hexahedron": [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
        "tetra10": [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (0.5, 0, 0), (0.5, 0.5, 0), (0, 0.5, 0), (0, 0, 0.5),
                    (0.5, 0, 0.5), (0, 0.5, 0.5)],
    }
    edges = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
    brick = np.array(points["hexahedron"], float)
    points["hexahedron20"] = np.concatenate([brick, [(brick[a] + brick[b]) / 2 for a, b in edges]])
    places = np.array(points[kind], float)
    places = np.hstack([places, np.zeros((len(places), 3 - places.shape[1]))])
    # a second element beside the first, and a node of neither
    both = np.concatenate([places, places + [2.0, 0.0, 0.0], [[9.0, 9.0, 0.0]]])
    mesh = meshio.Mesh(both, [(kind, np.arange(2 * len(places)).reshape(2, -1))])
    if name.endswith(".msh"):
        dimension = 2 if kind.startswith(("quad", "tri")) else 3
        tags = np.full((len(both), 2), [dimension, 1])
        mesh.point_data["gmsh:dim_tags"] = tags
        mesh.cell_data = {"gmsh:geometrical": [np.array([1, 1])], "gmsh:physical": [np.array([5, 5])]}
        meshio.gmsh.write(tmp_path / name, mesh, fmt_version="2.2" if "22" in name else "4.1", binary="binary" in name)
    else:
        meshio.write(tmp_path / name, mesh)
        # of the many types of a shape meshio writes one of shells, fluids or axes
        types = {"quad": "CPS4I", "quad8": "CPE8", "triangle6": "CPS6", "hexahedron": "C3D8I", "hexahedron20": "C3D20",
                 "tetra10": "C3D10"}
        text = re.sub("TYPE=.*", f"TYPE={types[kind]}", (tmp_path / name).read_text())
        (tmp_path / name).write_text(text)
    ours = meshio.read(exchanged(tmp_path / name, "mesh.vtu"))
    np.testing.assert_allclose(ours.points, both[:-1], atol=1e-15)
    labels = ours.point_data["label"].astype(int) - 1
    assert cells(ours, labels) == cells(mesh, np.arange(len(both)))


def test_paraview_gets_complex_shapes_and_their_motion(exchanged):
    mesh = meshio.read(exchanged(MESHES / "hexahedron20.msh", "shape.vtu"))
    x, y, z = mesh.points.T
    shape = np.stack([x + 1j * y, y - 1j * x, z + 0j], axis=1)
    np.testing.assert_array_equal(mesh.point_data["shape real"], shape.real)
    np.testing.assert_array_equal(mesh.point_data["shape imaginary"], shape.imag)
    np.testing.assert_allclose(mesh.point_data["shape amplitude"], abs(shape), rtol=1e-15)
    np.testing.assert_allclose(mesh.point_data["shape phase"], np.angle(shape), rtol=1e-14)
    series = exchanged(MESHES / "hexahedron20.msh", "turning.pvd")
    frames = xml.etree.ElementTree.parse(series).getroot().findall("./Collection/DataSet")
    assert len(frames) == 8
    for frame in frames:
        turn = np.exp(2j * np.pi * float(frame.get("timestep")) / 0.02)
        found = meshio.read(pathlib.Path(series).parent / frame.get("file")).point_data["turning"]
        np.testing.assert_allclose(found, (shape * turn).real, atol=1e-14)


def test_test_engineers_get_nodes_drawings_shapes_and_responses(exchanged):
    path = exchanged(MESHES / "hexahedron20.msh", "shape.unv")
    mesh = meshio.read(exchanged(MESHES / "hexahedron20.msh", "shape.vtu"))
    file = pyuff.UFF(str(path))
    assert list(file.get_set_types()) == [164, 2411, 82, 55, 55, 58, 58]
    units, nodes, lines, real, complex_, history, response = (file.read_sets(k) for k in range(7))
    assert units["length"] == units["force"] == 1.0
    np.testing.assert_array_equal(np.stack([nodes["x"], nodes["y"], nodes["z"]], axis=1), mesh.points)
    # the outer edges of two bricks in a row: 20, each with a middle
    pairs = np.append([0], lines["nodes"]).reshape(-1, 3)
    assert (pairs[:, 0] == 0).all() and len(pairs) == 40
    lengths = np.linalg.norm(mesh.points[pairs[:, 1].astype(int) - 1] - mesh.points[pairs[:, 2].astype(int) - 1], axis=1)
    assert lengths.sum() == pytest.approx(8 * 1.5 + 6 * 2 + 6 * 1)
    x, y, z = mesh.points.T
    shape = np.stack([x + 1j * y, y - 1j * x, z + 0j])
    assert real["analysis_type"] == 2 and real["freq"] == 47.5 and real["modal_damp_vis"] == 0.01
    np.testing.assert_allclose([real[f"r{k}"] for k in (1, 2, 3)], shape.real, rtol=1e-5)
    assert complex_["analysis_type"] == 3 and complex_["eig"] == 2 + 300j
    assert complex_["modal_b"] == pytest.approx(-complex_["eig"] * complex_["modal_a"], rel=1e-5)
    np.testing.assert_allclose([complex_[f"r{k}"] for k in (1, 2, 3)], shape, rtol=1e-5)
    assert (history["func_type"], history["rsp_node"], history["rsp_dir"]) == (1, 3, 3)
    np.testing.assert_allclose(history["x"], 0.5 + 0.1 * np.arange(10), rtol=1e-12)
    np.testing.assert_allclose(history["data"], np.sin(0.1 * np.arange(10)), rtol=1e-12)
    assert (response["func_type"], response["ref_node"], response["ref_dir"]) == (4, 1, 1)
    np.testing.assert_array_equal(response["x"], [1, 10, 100])
    np.testing.assert_array_equal(response["data"], [1 - 0.5j, -2e-7 + 3e12j, 0])
