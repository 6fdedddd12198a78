"""Colours by meaning, written by the tests of `judder-report` from its palette: change them there."""

from __future__ import annotations

from typing import Final

AREAS: Final = {
    "stable": "#f3f3ef",
    "flutter": "#5b90c4",
    "negative-damping": "#eeab55",
    "both": "#6a4682",
    "normal-force-coupling": "#efdc8f",
    "destabilised-by-damping": "#6fb09a",
    "unresolved": "#8c8c8c",
    "knock": "#fbdcd4",
    "knock-unknown": "#f7ece9",
    "within-law": "#dfdfe6",
    "turning-normal": "#e3b7cf",
    "convected-slip": "#b5dcf2",
    "across-slip": "#d9c7a3",
    "unknown-growth": "#c9c9c9",
    "unstable-zone": "#f7dccb",
    "stick": "#b9d9b2",
    "slip-ahead": "#d89fc1",
    "lift-off": "#dde9f7",
}
LINES: Final = {
    "full-boundary": "#000000",
    "conservative-boundary": "#000000",
    "decoupled-boundary": "#c8102e",
    "reference": "#6b6b6b",
}
SERIES: Final = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000")
"""The colours of curves that have no order."""
