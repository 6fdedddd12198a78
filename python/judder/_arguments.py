"""What Python itself says of wrong arguments is an error of judder besides: one place for all functions and classes.

Python refuses an argument that a function does not know, one that it lacks, and a value of a wrong type, each with an error of its own. Those
that come from judder's code, compiled or not, are told as :class:`judder.ArgumentError` or :class:`judder.NumberError`, which are the same errors of
Python too. What a function of the caller raises, a ``progress`` for example, stays as it is.
"""

from __future__ import annotations

import difflib
import functools
import inspect
import re
from collections.abc import Callable, Iterable, Iterator
from types import BuiltinFunctionType, FunctionType, MethodDescriptorType, TracebackType
from typing import Any

from judder import _judder
from judder._warned import is_own
from judder.errors import ArgumentError, InputError, JudderError, NumberError

_UNKNOWN = re.compile(r"unexpected keyword argument '(\w+)'")
_NAMED = re.compile(r"(?:while processing|argument:?) '(\w+)'")
_SAYS = "_says_wrong_arguments"
_FUNCTIONS = (BuiltinFunctionType, FunctionType, MethodDescriptorType)
_SPECIAL = ("__init__", "__call__", "_new")


def checked(module: dict[str, Any]) -> None:
    """Lets the public functions and classes of a module say what is wrong with their arguments; `module` are its globals, complete."""
    for name in module["__all__"]:
        item = module[name]
        if isinstance(item, type):
            for owner in _own(item):
                for member, value in [*vars(owner).items()]:
                    if not member.startswith("_") or member in _SPECIAL:
                        _replace(functools.partial(setattr, owner, member), value, owner.__module__)
        else:
            _replace(functools.partial(module.__setitem__, name), item, module["__name__"])


def _own(kind: type) -> Iterator[type]:
    """The classes of judder that a class is made of; errors are none, since they are what is said."""
    own = (base for base in kind.__mro__ if base.__module__.partition(".")[0] == "judder")
    return iter(()) if issubclass(kind, BaseException) else own


def _replace(put: Callable[[Any], None], value: Any, module: str) -> None:
    """Puts a function in its place that says what is wrong, where this is one that does not."""
    inner = value.__func__ if isinstance(value, staticmethod | classmethod) else value
    if isinstance(inner, _FUNCTIONS) and not hasattr(inner, _SAYS):
        told = _telling(inner)
        # by which it is pickled; static methods that are compiled have none
        told.__module__ = told.__module__ or module
        put(told if inner is value else type(value)(told))


def _telling(function: Callable[..., Any]) -> Callable[..., Any]:
    @functools.wraps(function)
    def call(*given: Any, **keys: Any) -> Any:
        try:
            return function(*given, **keys)
        except (TypeError, AttributeError, OverflowError) as error:
            if isinstance(error, JudderError) or not _is_ours(error.__traceback__):
                raise
            raise _told(error, _keys(function)) from error

    setattr(call, _SAYS, True)
    return call


def _is_ours(traceback: TracebackType | None) -> bool:
    """Whether judder has raised an error: its innermost frame is one of judder's."""
    while traceback is not None and traceback.tb_next is not None:
        traceback = traceback.tb_next
    return traceback is not None and is_own(traceback.tb_frame)


def _keys(function: Callable[..., Any]) -> Iterable[str]:
    """The names of the arguments of a function, where it tells them."""
    try:
        return inspect.signature(function).parameters
    except (TypeError, ValueError):
        return ()


def meant(unknown: str, known: Iterable[str]) -> str:
    """The end of a message about an unknown argument: which one is like it."""
    close = difflib.get_close_matches(unknown, known, 1)
    return f"; is `{close[0]}` meant?" if close else ""


def whole_bytes(name: str, given: Any) -> int:
    """An argument that is a number of bytes.

    Raises:
        ArgumentError: it is none.
        NumberError: it is below zero.
    """
    needed = f"a whole number of bytes is needed, such as {1 << 30} for 1 GiB"
    if isinstance(given, bool) or not hasattr(given, "__index__"):
        raise ArgumentError(f"{name}: is {given!r}, and {needed}", "Argument", {"argument": name})
    if (count := int(given.__index__())) not in range(1 << 64):
        raise NumberError(f"{name}: is {count}, and {needed}", "Argument", {"argument": name})
    return count


def _told(error: Exception, keys: Iterable[str]) -> InputError:
    kind = NumberError if isinstance(error, OverflowError) else ArgumentError
    words = str(error)
    if unknown := _UNKNOWN.search(words):
        # newer Pythons say themselves what is like it
        return kind(words.partition(". Did you mean")[0] + meant(unknown[1], keys), "Argument", {"argument": unknown[1]})
    found = _NAMED.search(" ".join([words, *getattr(error, "__notes__", ())]))
    name = found[1] if found else ""
    return kind(words if not name or f"'{name}'" in words else f"{name}: {words}", "Argument", {"argument": name})


# before any module takes a compiled function by its name
checked(vars(_judder))
