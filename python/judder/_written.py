"""What the files hold that judder reads in place of objects of Python: matrices, heights, meshes, tables, laws."""

from __future__ import annotations

import io
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from judder import _columns, _mesh
from judder._columns import described, numbers, wrong
from judder._judder import Law

_MOST_NAMED = 500
"""Freedoms with names that the text of a case holds: its matrices have this many entries, squared."""


def content(key: str, at: tuple[str, ...], value: Any, beside: Mapping[str, Any]) -> tuple[str, bytes]:
    """The ending of a file and its bytes; the table in which the key stands is `beside` it."""
    match at[-1]:
        case "mesh":
            return ".inp", _mesh.deck(key, value, beside.get("materials")).encode()
        case "heights":
            return ".npy", _saved(numbers(key, getattr(value, "values", value), dimensions=2))
        case "study":
            raise wrong(key, f"is {described(value)}, and a judder.Study or the path of its folder is needed")
        case "freedoms":
            return ".csv", _columns.freedoms(key, value).encode()
    if len(at) > 2 and at[-3] in ("mass", "damping", "stiffness") or at[-2] in ("mass", "damping", "stiffness"):
        return ".npz", _matrix(key.removesuffix(".file"), value, beside)
    if at[-2] == "law":
        return ".json", _law(key.removesuffix(".file"), value)
    return ".csv", _columns.text(key.removesuffix(".file"), value).encode()


def is_matrix(value: Any) -> bool:
    """Whether an object is a sparse matrix, or an array of numbers of two dimensions."""
    return is_sparse(value) or isinstance(value, np.ndarray) and value.dtype.kind != "U"


def is_sparse(value: Any) -> bool:
    """Whether an object is a sparse matrix of SciPy, or is like one."""
    return hasattr(value, "tocoo") and hasattr(value, "shape")


def rows(key: str, value: Any) -> Any:
    """A matrix as the rows that the text of a case has; what is no matrix as it is."""
    if not is_matrix(value):
        return value
    if max(value.shape) > _MOST_NAMED:
        raise wrong(key, f"has {value.shape[0]} rows, too many for freedoms with names; number the nodes, as in freedoms = [(1, \"x\"), …]")
    return numbers(key, value.toarray() if is_sparse(value) else value, dimensions=2).tolist()


def _matrix(key: str, value: Any, term: Mapping[str, Any]) -> bytes:
    """An archive as ``scipy.sparse.save_npz`` writes it, with the entries by rows."""
    if not is_matrix(value):
        raise wrong(key, f"is {described(value)}, and a sparse matrix of SciPy, an array of NumPy or the path of a file is needed")
    shape = value.shape
    if len(shape) != 2 or shape[0] != shape[1] or shape[0] == 0:
        raise wrong(key, f"has the shape {shape}, and a square matrix is needed")
    if is_sparse(value):
        row, column, entries = _entries(value)
        entries = numbers(key, entries, dimensions=1) if entries.size else np.zeros(0)
        if term.get("triangle") is None:
            _check_triangle(key, row, column, entries)
    else:
        dense = numbers(key, value, dimensions=2)
        row, column = np.nonzero((dense != 0.0) | np.eye(len(dense), dtype=bool))
        entries = dense[row, column]
    order = np.lexsort((column, row))
    arrays = {"row": row[order].astype(np.int64), "col": column[order].astype(np.int64), "data": entries[order]}
    archive = io.BytesIO()
    np.savez(archive, format=np.array(b"coo"), shape=np.array(shape, dtype=np.int64), **arrays)  # type: ignore[arg-type]
    return archive.getvalue()


def _entries(value: Any) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
    """Rows, columns and numbers of a sparse matrix."""
    found = value.tocoo()
    return np.asarray(found.row), np.asarray(found.col), np.asarray(found.data)


def _check_triangle(key: str, row: NDArray[Any], column: NDArray[Any], entries: NDArray[Any]) -> None:
    """Refuses a matrix of which one triangle is empty, as programs hand over symmetric ones."""
    below, above = (bool(np.any(entries[side] != 0.0)) for side in (row > column, row < column))
    if below != above:
        which = "lower" if below else "upper"
        why = f"has entries on one side of its diagonal only; say whether that is meant: {{\"file\": matrix, \"triangle\": \"{which}\"}}"
        raise wrong(key, f"{why} where it is the {which} triangle of a symmetric matrix, \"as-stored\" where it is all")


def _law(key: str, value: Any) -> bytes:
    if not isinstance(value, Law):
        raise wrong(key, f"is {described(value)}, and a judder.contact.Law, its name or the path of its file is needed")
    text = value.to_json()
    if text is None:
        raise wrong(key, f"is a law with the name {value.name!r}, which no file holds; give it in place of the table with a file")
    return text.encode()


def _saved(array: NDArray[np.float64]) -> bytes:
    held = io.BytesIO()
    np.save(held, array)
    return held.getvalue()
