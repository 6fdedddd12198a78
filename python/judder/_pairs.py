"""Pairs that come from another process."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from judder import _judder
from judder._cluster.package import Package


def given(slider: Any, track: Any, friction: Any, interpolation: str, side: str, observed: Sequence[Any]) -> _judder.Pair:
    """The pair of modal data."""
    return _judder.Pair(slider, track, friction=friction, interpolation=interpolation, side=side, observed=observed)


def packed(told: tuple[str, str, list[str], list[tuple[str, Any]]]) -> tuple[Package]:
    """The case of a pair with the files that it names, as :func:`of_package` takes it."""
    return (Package.of(told),)


def of_package(package: Package) -> _judder.Pair:
    """The pair of a case, built anew."""
    return _judder.Pair.from_source((package.unpacked(), package.text), list(package.overrides))
