"""The classes of :mod:`judder.models`, made of the declarations by which case files are read."""

from __future__ import annotations

import inspect
import json
from collections.abc import Callable, Iterator, Mapping
from inspect import Parameter, Signature
from typing import Any

from judder import _judder
from judder._arguments import meant
from judder._model import Model, Result
from judder.errors import ArgumentError

_SELF = Parameter("self", Parameter.POSITIONAL_OR_KEYWORD)
_CASE = Parameter("case", Parameter.POSITIONAL_OR_KEYWORD, default=None, annotation="CaseLike | None")


def _keyword(name: str, annotation: str, default: Any = None) -> Parameter:
    return Parameter(name, Parameter.KEYWORD_ONLY, default=default, annotation=annotation)


_SET = _keyword("set", "Mapping[str, Any] | None")
_RUN = (_keyword("threads", "int | None"), _keyword("progress", "Progress | None"))


def classes() -> dict[str, type[Model]]:
    """A class a model by its name, and in it a method for every kind of analysis."""
    return {told["name"]: _class(told) for told in json.loads(_judder.declared_models())}


def _class(told: Mapping[str, Any]) -> type[Model]:
    name = told["name"]
    signature = Signature([_SELF, _CASE, _SET, *_parameters(told)], return_annotation="None")

    def begin(*given: Any, **keys: Any) -> None:
        arguments = _bound(name, signature, given, keys)
        Model.__init__(arguments["self"], arguments["case"], arguments["set"], _keys(told, arguments))

    own: dict[str, Any] = {method["name"]: _method(method, name) for method in told["methods"]}
    own["__init__"] = _signed(begin, "__init__", name, signature)
    return type(name, (Model,), {**own, "__doc__": inspect.cleandoc(told["doc"]), "__module__": "judder.models", "_name": told["of"]})


def _method(told: Mapping[str, Any], owner: str) -> Callable[..., Result]:
    signature = Signature([_SELF, *_parameters(told), *_RUN], return_annotation="Result")

    def compute(*given: Any, **keys: Any) -> Result:
        arguments = _bound(f"{owner}.{told['name']}", signature, given, keys)
        model: Model = arguments["self"]
        return model._computed(told["of"], _keys(told, arguments), arguments["threads"], arguments["progress"])

    compute.__doc__ = inspect.cleandoc(told["doc"])
    return _signed(compute, told["name"], owner, signature)


def _parameters(told: Mapping[str, Any]) -> Iterator[Parameter]:
    for name, _, annotation, is_required in told["parameters"]:
        yield _keyword(name, annotation, Parameter.empty if is_required else None)


def _keys(told: Mapping[str, Any], arguments: Mapping[str, Any]) -> dict[str, Any]:
    """What was given, by the names of a case file."""
    return {key: arguments[name] for name, key, *_ in told["parameters"]}


def _bound(name: str, signature: Signature, given: tuple[Any, ...], keys: Mapping[str, Any]) -> dict[str, Any]:
    """The arguments of a call by their names, those that are left out filled in."""
    try:
        bound = signature.bind(*given, **keys)
    except TypeError as error:
        unknown = next((key for key in keys if key not in signature.parameters), "")
        why = f"got an unexpected keyword argument '{unknown}'{meant(unknown, signature.parameters)}" if unknown else str(error)
        raise ArgumentError(f"{name}() {why}", "Argument", {"argument": unknown}) from None
    bound.apply_defaults()
    return bound.arguments


def _signed(function: Callable[..., Any], name: str, owner: str, signature: Signature) -> Callable[..., Any]:
    """The function as a member of a class of :mod:`judder.models`."""
    function.__name__, function.__qualname__, function.__module__ = name, f"{owner}.{name}", "judder.models"
    vars(function)["__signature__"] = signature
    return function
