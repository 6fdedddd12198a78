"""Packages that not everybody needs, imported when they are used."""

from __future__ import annotations

import importlib
from typing import Any

from judder.errors import PackageError


def needed(module: str, extra: str, purpose: str) -> Any:
    """A module by its name, untyped; `purpose` begins the sentence where it is missing."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        package = module.partition(".")[0]
        why = f"{purpose} needs the package {package} ({error}): pip install 'judder[{extra}]'"
        raise PackageError(why, "MissingPackage", {"package": package, "extra": extra}) from error
