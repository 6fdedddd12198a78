"""Objects of Python where a case names a file: matrices, meshes, tables, heights and laws in memory.

A case is walked before it becomes TOML. What stands at a key of a file and is no path is written into a folder of its own, whose files go by the dotted
keys; the case names them relative to itself, so that its hash is that of what they hold, whatever the folder is called. A study folder keeps them.
"""

from __future__ import annotations

import os
import re
import shutil
import tempfile
import weakref
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TypeAlias

from judder import _columns, _judder, _toml, _written
from judder._columns import described, wrong
from judder._judder import Law
from judder._keys import FILES, ROWS
from judder._numpy import np
from judder._said_of_objects import HeldObject, said, said_fields
from judder._sampled import FASTEST, SPEED_TOLERANCE, sampled, speeds_of_sliding
from judder.errors import OF_ARGUMENTS, OF_CHANGES, OF_TABLES, CaseError, InputError, JudderError, StudyError

INPUTS = "inputs"
"""The folder of the files, beside the case and in a study."""
CASE = "case.toml"
"""What tables and texts are called as a file."""
_WITH_UNIT = re.compile(r"(?P<key>[^\[\]]*[^\[\]\s])\s*\[(?P<unit>[^\[\]]+)\]")
_NAMES_ITS_MODEL = re.compile(r"\s*model\s*=")
_MATRICES = ("mass", "damping", "stiffness")

KeyPath: TypeAlias = tuple[str, ...]
"""The steps of a dotted key; ``*`` is any item of a list, or any name."""


class CaseSource:
    """A case as the compiled part takes it, with the files of its objects, which are there as long as this is."""

    given: tuple[str, str] | str
    """A name and a text, or a path."""
    overrides: list[str]
    """The changed keys."""
    arguments: Collection[str] = ()
    """The dotted keys that are changed because they were given as arguments of a function."""

    def __init__(self, case: str | os.PathLike[str] | Mapping[str, Any], set: Mapping[str, Any] | None = None) -> None:
        self._files = _InputFiles()
        if set is not None and not isinstance(set, Mapping):
            raise wrong("set", f"is {described(set)}, and a mapping is needed, such as {{\"operation.velocity\": \"30 mm/s\"}}")
        self._is_written_here = isinstance(case, Mapping)
        if isinstance(case, Mapping):
            if not case:
                raise wrong("case", "is an empty mapping, and its tables are needed, such as {\"model\": \"oscillator\"}")
            model = str(case.get("model"))
            tables, changes = (_Walk(self._files, model).of_table(own) for own in (case, set or {}))
            if self._files.folder is not None:
                tables, changes = (_settled(own, model, self._files.objects) for own in (tables, changes))
            self.given = os.path.join(self._files.folder or "", CASE), _toml.document(tables)
        else:
            if not isinstance(case, str | os.PathLike):
                raise wrong("case", f"is {described(case)}, and the path of a case file, its text or its tables as a mapping is needed")
            self.given = (CASE, case) if isinstance(case, str) and _is_text(case) else os.fspath(case)
            changes = self.whole(set or {})
            if self._files.folder is not None:
                changes = self._settled_beside(set or {}) or changes
        self.overrides = _toml.overrides(changes)

    def whole(self, tables: Mapping[str, Any], model: str | None = None, at: KeyPath = (), *, without_none: bool = False) -> dict[str, Any]:
        """More tables, without objects, that name files by their whole paths; keys that are ``None`` may count as not given."""
        return _Walk(self._files, model, whole=True, without_none=without_none).of_table(tables, at)

    def _settled_beside(self, set: Mapping[str, Any]) -> dict[str, Any] | None:
        """Takes the text of a case beside the objects that change it, so that these have the same names wherever they lie; gives back the changes, or
        nothing where the case cannot be read, which is told better where it is checked."""
        import tomllib

        text, base = self.given[1], ""
        try:
            if isinstance(self.given, str):
                text, base = Path(self.given).read_text(encoding="utf-8"), os.path.dirname(self.given)
            tables = tomllib.loads(text)
        except (OSError, UnicodeError, tomllib.TOMLDecodeError):
            return None
        self._files, self._is_written_here = _InputFiles(), True
        model = str(tables.get("model"))
        changes = _settled(_Walk(self._files, model).of_table(set), model, self._files.objects)
        self.given = os.path.join(self._files.folder or "", CASE), _toml.document(_settled(tables, model, (), base))
        return changes

    def hold(self) -> None:
        """Keeps the files until this process ends."""
        if self._files not in _held:
            _held.append(self._files)

    def keep(self, folder: str | os.PathLike[str]) -> None:
        """Copies the files into a study folder, which then has all that its case needs."""
        if self._files.folder is not None:
            shutil.copytree(os.path.join(self._files.folder, INPUTS), os.path.join(folder, INPUTS), dirs_exist_ok=True)
            _judder.listed_files(os.fspath(folder), INPUTS)

    def plain(self, text: str) -> str:
        """A text without the folder of the files: the names of these are those of keys."""
        return text if self._files.folder is None else text.replace(self._files.folder + os.sep, "")

    def said(self, text: str) -> str:
        """A message that speaks of objects, not of the files that hold them."""
        return text if self._files.folder is None else self.plain(said(text, self._files.objects, self._files.folder))

    def said_error(self, error: JudderError) -> JudderError:
        """An error that speaks of objects and tables, not of what judder writes of them."""
        file = self._file_said(error) if isinstance(error, CaseError) else None
        if self._files.folder is None and file is None:
            return error
        fields = said_fields(error.fields, self.said)
        path, reason = error.fields.get("path"), error.fields.get("reason")
        if isinstance(reason, str) and fields.get("path") != path:
            # which speaks of the file that the path names
            fields["reason"] = self.said(f"{path}: {reason}").partition(": ")[2]
        message = self.said(str(error))
        if isinstance(error, StudyError) and path is not None and fields["path"] != path:
            # an object is an argument, whoever has read it
            return InputError(message, "Input", {"argument": fields["path"], "key": fields["path"], "reason": fields.get("reason")})
        if file is not None:
            fields["file"] = file
            if (key := fields["text"]) != error.text and f"`{key}" not in message:
                message = f"`{key}`: {message}"
        return type(error)(message, error.cause, fields)

    def _file_said(self, error: CaseError) -> str | None:
        """What an error calls the text in which it has its place, where that is written here; nothing where it is a file of the caller's."""
        if self._is_written_here and os.path.basename(error.file) == CASE:
            return OF_TABLES
        key = error.key or ""
        given = any(key == own or key.startswith(f"{own}.") for own in self.arguments)
        return OF_ARGUMENTS if given and error.file == OF_CHANGES else None

    @contextmanager
    def told(self) -> Iterator[None]:
        """Errors speak of objects by their keys."""
        try:
            yield
        except JudderError as error:
            own = self.said_error(error)
            if own is error:
                raise
            raise own from None


def _is_text(case: str) -> bool:
    """Whether this is the text of a case, which may have one line alone, and no path."""
    return "\n" in case or _NAMES_ITS_MODEL.match(case) is not None


class _InputFiles:
    """A folder that is made when the first file is written, and goes with this."""

    def __init__(self) -> None:
        self.folder: str | None = None
        """Where it is; none before there is a file."""
        self.objects: dict[str, HeldObject] = {}
        """What the files in it hold, by their paths in it."""

    def write(self, key: str, ending: str, content: bytes, columns: Mapping[str, str]) -> str:
        """Writes a file that goes by a key; gives back its path in the folder. Of its columns some are parts of one of the object."""
        if self.folder is None:
            self.folder = tempfile.mkdtemp(prefix="judder-")
            weakref.finalize(self, shutil.rmtree, self.folder, ignore_errors=True)
            Path(self.folder, INPUTS).mkdir()
        plain = re.sub(r"[^\w.-]+", "-", key).strip(".-") or "input"
        name, count = f"{INPUTS}/{plain}{ending}", 1
        while name in self.objects:
            count += 1
            name = f"{INPUTS}/{plain}-{count}{ending}"
        self.objects[name] = HeldObject(key, columns)
        Path(self.folder, name).write_bytes(content)
        return name


_held: list[_InputFiles] = []


class _Walk:
    """A way through the tables of a case on which objects become names of files."""

    def __init__(self, files: _InputFiles, model: str | None, *, whole: bool = False, without_none: bool = False) -> None:
        self._files = files
        self._model, self._declared = model, Declared(model)
        self._whole, self._without_none = whole, without_none
        self._above: list[int] = []

    def of_table(self, table: Mapping[str, Any], at: KeyPath = ()) -> dict[str, Any]:
        """A table, its keys spelled out: those with a unit, dotted ones as paths."""
        found: dict[str, Any] = {}
        for given, value in table.items():
            if value is None and self._without_none:
                continue
            key = str(given)
            if split := _WITH_UNIT.fullmatch(key):
                key, value = split["key"], _columns.quantities(".".join((*at, key)), value, split["unit"])
            if key in found:
                raise wrong(".".join((*at, key)), f"is given twice: `{key}` and `{given}`")
            found[key] = self._value(value, (*at, *key.split(".")), table)
        return found

    def _value(self, value: Any, at: KeyPath, beside: Mapping[str, Any]) -> Any:
        """What the case says for a value; the table in which it stands is `beside` it."""
        declared = self._declared
        if isinstance(value, str | int | float) or value is None:
            return value
        if id(value) in self._above or len(self._above) > _toml.MOST_DEEP:
            raise wrong(".".join(at), "contains itself, or lies too deep")
        self._above.append(id(value))
        try:
            if declared.is_friction(at) and (table := self._friction(value, at)) is not None:
                return table
            if callable(value):
                raise wrong(".".join(at), "is a function, which this key does not take")
            if declared.is_file(at):
                return self._file(value, at, beside)
            if declared.is_file((*at, "file")) and not isinstance(value, list | tuple):
                return self._table_with_file(value, at)
            if declared.is_file((*at, "*", "file")):
                return self._terms(value, at, beside)
            if declared.has_rows(at) and (columns := _columns.of(".".join(at), value)) is not None:
                return self._items(_columns.rows(".".join(at), columns), at)
            if _written.is_sparse(value):
                raise wrong(".".join(at), "is a sparse matrix, which this key does not take")
            if isinstance(value, Mapping):
                return self.of_table(self._named(value, at), at)
            return self._items(value, at)
        finally:
            self._above.pop()

    def _friction(self, value: Any, at: KeyPath) -> dict[str, Any] | None:
        """The table of a friction law: of a function of an array of speeds, or of speeds and coefficients; `None` of anything else."""
        key = ".".join(at)
        if callable(value):
            speeds, coefficients = sampled(key, value, (0.0, FASTEST), SPEED_TOLERANCE, first=speeds_of_sliding())
        elif isinstance(value, list | tuple) and len(value) == 2 and all(_columns.is_column(column) for column in value):
            speeds, coefficients = value
        else:
            return None
        unit = "velocity" if self._model == "belt" else "velocity [m/s]"
        table = self.of_table({unit: speeds, "coefficient": coefficients}, at)
        # its slope, which decides whether sliding is steady, is nearer to that of the function than those of straight lines
        return {**table, "interpolation": "monotone"} if callable(value) else table

    def _items(self, value: Any, at: KeyPath) -> Any:
        """A list, whose items may be tables; anything else as it is."""
        if isinstance(value, os.PathLike):
            return os.fspath(value)
        if not isinstance(value, list | tuple) or not value or isinstance(value[0], str | int | float):
            return value
        return [self._value(item, (*at, str(index)), {}) for index, item in enumerate(value)]

    def _file(self, value: Any, at: KeyPath, beside: Mapping[str, Any]) -> Any:
        """The name of a file with what an object holds."""
        if isinstance(value, os.PathLike):
            return os.fspath(value)
        if at[-1] == "freedoms" and _columns.are_names(value):
            return value
        key = ".".join(at)
        ending, content = _written.content(key, at, value, beside)
        columns = _columns.halves(_columns.of(key, value) or {}) if ending == ".csv" else {}
        name = self._files.write(key.removesuffix(".file"), ending, content, columns)
        return os.path.join(self._files.folder or "", name) if self._whole else name

    def _table_with_file(self, value: Any, at: KeyPath) -> Any:
        """A table with a key `file`; columns of numbers that it has in place of one, or an object in place of the table, go into a file."""
        key = (*at, "file")
        if isinstance(value, Law) and value.to_json() is None:
            return value.name
        if not isinstance(value, Mapping) or hasattr(value, "data_vars"):
            return {"file": self._file(value, key, {})}
        if not value and at[-1] == "dma":
            raise wrong(".".join(at), "is an empty table, and columns of measured moduli, or a path as `file`, are needed")
        if "file" in value:
            return self.of_table(value, at)
        own = self._declared.beside_file(key)
        columns = {str(name): column for name, column in value.items() if _WITH_UNIT.sub(r"\g<key>", str(name)) not in own}
        if not columns or not all(_columns.is_column(column) for column in columns.values()):
            return self.of_table(value, at)
        rest = {name: own for name, own in value.items() if str(name) not in columns}
        return {"file": self._file(columns, key, {}), **self.of_table(rest, at)}

    def _terms(self, value: Any, at: KeyPath, beside: Mapping[str, Any]) -> Any:
        """The terms of a sum of matrices: one matrix, several, those with factors, with names that their files go by."""
        if _written.has_texts(value) and at[-1] in beside and not _columns.are_names(beside.get("freedoms")):
            why = "is an array of texts, and numbers are needed; expressions of parameters stand beside `freedoms` with names, a factor in"
            raise wrong(".".join(at), f'{why} {{"file": matrix, "factor": "mu"}}')
        if _written.is_matrix(value) or isinstance(value, Mapping) and "file" in value:
            value = [value]
        if isinstance(value, Mapping):
            return [self._term(term, (*at, str(name))) for name, term in value.items()]
        if isinstance(value, list | tuple) and any(isinstance(term, Mapping) or _written.is_matrix(term) for term in value):
            return [self._term(term, (*at, str(index)) if len(value) > 1 else at) for index, term in enumerate(value)]
        return self._items(value, at)

    def _term(self, value: Any, name: KeyPath) -> Any:
        """A term of a sum, whose file goes by a name; what was dense may have anything on either side of its diagonal."""
        term = {"file": value} if _written.is_matrix(value) or not isinstance(value, Mapping) else dict(value)
        matrix = term.get("file")
        if not isinstance(matrix, str | None):
            if isinstance(matrix, np.ndarray):
                term.setdefault("triangle", "as-stored")
            term["file"] = self._file(matrix, (*name, "file"), term)
        return self.of_table(term, name)

    def _named(self, table: Mapping[str, Any], at: KeyPath) -> Mapping[str, Any]:
        """Matrices whose freedoms have names stand in the case itself; all others as they are."""
        if not self._declared.is_file((*at, "mass", "*", "file")) or not _columns.are_names(table.get("freedoms")):
            return table
        matrices = {name: table[name] for name in _MATRICES if name in table}
        if not any(_written.is_matrix(matrix) or _written.is_sum(matrix) for matrix in matrices.values()):
            return table
        return {**table, **{name: _written.rows(".".join((*at, name)), matrix) for name, matrix in matrices.items()}}


class Declared:
    """The keys of files of a model, or of any where it is not known."""

    def __init__(self, model: str | None) -> None:
        own = [model] if model in FILES else [*FILES]
        self._files = {path: beside for name in own for path, beside in FILES[name].items()}
        self._rows = [path for name in own for path in ROWS[name]]

    def is_file(self, at: KeyPath) -> bool:
        """Whether a key names a file."""
        return any(_is(at, path) for path in self._files)

    def beside_file(self, at: KeyPath) -> Sequence[str]:
        """The keys that stand beside that of a file."""
        return [key for path, beside in self._files.items() if _is(at, path) for key in beside]

    def is_friction(self, at: KeyPath) -> bool:
        """Whether a key is a friction coefficient, which may be a table."""
        return {"velocity", "coefficient"} <= set(self.beside_file((*at, "file")))

    def has_rows(self, at: KeyPath) -> bool:
        """Whether a key is a list of tables of numbers."""
        return any(_is(at, path) for path in self._rows)


def _is(at: KeyPath, path: str) -> bool:
    """Whether a key is one of a declared path, in which `*` is an item of a list or a name."""
    steps = path.split(".")
    return len(steps) == len(at) and all(step in (own, "*") for step, own in zip(steps, at, strict=True))


def _settled(tables: Mapping[str, Any], model: str, own_names: Collection[str], folder: str = "") -> dict[str, Any]:
    """The same tables with whole paths of the files that were given by their names, since the case now lies beside files of its own."""
    declared = Declared(model)

    def settled(value: Any, at: KeyPath, base: str) -> Any:
        if isinstance(value, str) and declared.is_file(at):
            return value if value in own_names else os.path.abspath(os.path.join(base, value))
        if isinstance(value, Mapping):
            own = value.get("folder")
            inside = isinstance(own, str) and declared.is_file((*at, "mass", "*", "file"))
            below = os.path.join(base, own) if inside and isinstance(own, str) else base
            return {key: settled(item, (*at, *str(key).split(".")), below) for key, item in value.items() if not (inside and key == "folder")}
        if isinstance(value, list) and value and isinstance(value[0], Mapping):
            return [settled(item, (*at, str(index)), base) for index, item in enumerate(value)]
        return value

    found: dict[str, Any] = settled(tables, (), folder)
    return found
