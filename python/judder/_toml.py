"""Values of Python as TOML writes them: for cases and changed keys that come from a program."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable, Mapping
from typing import Any

from judder._numpy import np
from judder.errors import InputError


MOST_DEEP = 64
"""How deep lists and tables may lie in each other."""


def value(name: str, given: Any, deep: int = 0) -> str:
    """``given`` as a TOML value on one line; NumPy scalars and arrays count as numbers and lists."""
    if deep > MOST_DEEP:
        raise InputError(f"{name}: lies deeper than {MOST_DEEP} lists and tables, or contains itself", "Input", {"argument": name})
    if hasattr(given, "tolist"):
        # finite numbers are the same in JSON
        if isinstance(given, np.ndarray) and given.dtype.kind in "fiub" and np.isfinite(given).all():
            return json.dumps(given.tolist())
        given = given.tolist()
    match given:
        case None:
            raise InputError(f"{name}: is None; leave the key out where its default is meant", "Input", {"argument": name})
        case bool():
            return "true" if given else "false"
        case str():
            return json.dumps(given, ensure_ascii=False)
        case int():
            return str(given)
        case float():
            return repr(given) if math.isfinite(given) else str(given)
        case Mapping():
            entries = (f"{_key(key)} = {value(f'{name}.{key}', own, deep + 1)}" for key, own in given.items())
            return "{ " + ", ".join(entries) + " }"
        case Iterable():
            return "[" + ", ".join(value(name, item, deep + 1) for item in given) + "]"
    message = f"{name}: a case holds texts, numbers, booleans, lists and tables, not {type(given).__name__}"
    raise InputError(message, "Input", {"argument": name})


def document(case: Mapping[str, Any]) -> str:
    """A case as a TOML document, one line a key."""
    return "".join(f"{_key(key)} = {value(str(key), own)}\n" for key, own in case.items())


def _key(key: Any) -> str:
    """A key, in quotes where it must be."""
    text = str(key)
    return text if re.fullmatch("[A-Za-z0-9_-]+", text) else json.dumps(text, ensure_ascii=False)


def overrides(changes: Mapping[str, Any] | None) -> list[str]:
    """Changed keys as the options ``--set KEY=VALUE`` have them."""
    changed = changes or {}
    if any(not str(key).strip() for key in changed):
        raise InputError('set: has an empty key; a dotted one is needed, as in {"operation.velocity": "30 mm/s"}', "Input", {"argument": "set"})
    return [f"{key}={value(key, given)}" for key, given in changed.items()]
