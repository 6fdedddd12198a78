"""What the files hold that judder reads in place of objects of Python: matrices, heights, meshes, tables, laws."""

from __future__ import annotations

import io
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from judder import _columns, _mesh
from judder._columns import described, numbers, wrong
from judder._judder import Law
from judder._numpy import np

if TYPE_CHECKING:
    from numpy.typing import NDArray

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
    table = _columns.moduli if at[-2] == "dma" else _columns.text
    return ".csv", table(key.removesuffix(".file"), value).encode()


def is_matrix(value: Any) -> bool:
    """Whether an object is a sparse matrix, or an array of numbers of two dimensions."""
    return is_sparse(value) or isinstance(value, np.ndarray) and value.dtype.kind not in "US"


def has_texts(value: Any) -> bool:
    """Whether a value is an array of texts, or has one among its terms."""
    if isinstance(value, Mapping | list | tuple):
        terms = value.values() if isinstance(value, Mapping) else value
        return any(isinstance(term, np.ndarray | Mapping) and has_texts(term) for term in terms)
    return isinstance(value, np.ndarray) and value.dtype.kind in "US"


def is_sparse(value: Any) -> bool:
    """Whether an object is a sparse matrix of SciPy, or is like one."""
    return hasattr(value, "tocoo") and hasattr(value, "shape")


def is_sum(value: Any) -> bool:
    """Whether a value is a sum of matrices: terms in a list or by names, or one with a factor."""
    if isinstance(value, Mapping):
        return "file" in value or any(is_matrix(term) or isinstance(term, Mapping) for term in value.values())
    return isinstance(value, list | tuple) and any(is_matrix(term) or isinstance(term, Mapping) for term in value)


def rows(key: str, value: Any) -> Any:
    """A matrix, or a sum of matrices with factors, as the rows that the text of a case has; what is neither as it is."""
    if is_matrix(value):
        return _dense(key, value).tolist()
    if not is_sum(value):
        return value
    if isinstance(value, Mapping):
        named = {key: value} if "file" in value else {f"{key}.{name}": term for name, term in value.items()}
    else:
        named = {f"{key}.{index}": term for index, term in enumerate(value)}
    terms = [_term(name, term) for name, term in named.items()]
    shapes = {matrix.shape for matrix, _ in terms}
    if len(shapes) > 1:
        raise wrong(key, f"is a sum of matrices of the shapes {', '.join(map(str, sorted(shapes)))}, and all need the same")
    plain: NDArray[np.float64] = sum((matrix for matrix, factor in terms if factor is None), start=np.zeros(shapes.pop()))
    varied = [(matrix, factor) for matrix, factor in terms if factor is not None]
    rows, columns = map(range, plain.shape)
    return [[_entry(plain[row, column], [(own[row, column], factor) for own, factor in varied]) for column in columns] for row in rows]


def _entry(plain: float, varied: list[tuple[float, str]]) -> float | str:
    """An entry of a sum: a number, or an expression of the parameters."""
    own = [f"({float(number)!r})*({factor})" for number, factor in varied if number != 0.0]
    return " + ".join([repr(float(plain)), *own]) if own else float(plain)


def _term(key: str, term: Any) -> tuple[NDArray[np.float64], str | None]:
    """The matrix of a term, both of its triangles, and its factor."""
    own = term if isinstance(term, Mapping) else {"file": term}
    matrix = own.get("file")
    if not is_matrix(matrix):
        raise wrong(key, f"is {described(matrix)}, and beside freedoms with names every term needs a matrix in memory")
    if strangers := {*own} - {"file", "factor", "triangle"}:
        raise wrong(key, f"has the key `{min(strangers)}`, and knows `file`, `factor`, `triangle`")
    dense, triangle, factor = _dense(key, matrix), own.get("triangle"), own.get("factor")
    if is_sparse(matrix) and triangle is None:
        row, column, entries = _entries(matrix)
        _check_triangle(key, row, column, entries)
    if triangle in ("lower", "upper"):
        half = np.tril(dense) if triangle == "lower" else np.triu(dense)
        dense = half + half.T - np.diag(np.diag(half))
    return dense, None if factor is None else str(factor)


def _dense(key: str, value: Any) -> NDArray[np.float64]:
    if max(value.shape) > _MOST_NAMED:
        raise wrong(key, f"has {value.shape[0]} rows, too many for freedoms with names; number the nodes, as in freedoms = [(1, \"x\"), …]")
    return numbers(key, value.toarray() if is_sparse(value) else value, dimensions=2)


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
