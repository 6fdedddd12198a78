"""Pictures with matplotlib in judder's own colours, in which a meaning has one colour everywhere.

Needs ``pip install 'judder[plot]'``. Everything else draws itself: datasets through xarray, studies in a notebook.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from judder import _arguments
from judder._packages import needed
from judder._palette import AREAS, LINES, SERIES
from judder.errors import InputError
from judder.oscillator import LAW_STANDINGS, StabilityMap

if TYPE_CHECKING:
    import numpy as np
    import xarray
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

__all__ = ["COLOURS", "SERIES", "stability"]

COLOURS: Final = {
    **AREAS,
    **LINES,
    "one-way-coupling": AREAS["normal-force-coupling"],
    "marginal": LINES["reference"],
    "marginal-within-the-law": AREAS["within-law"],
}
"""The colours of areas and boundaries of a stability map; areas are apart in grey too."""

_BOUNDARIES = {
    "full": ("boundary, full system", "-"),
    "conservative": ("boundary without damping", "--"),
    "decoupled": ("boundary for η = 0", "-"),
}


def stability(found: StabilityMap | xarray.Dataset, *, ax: Axes | None = None, legend: bool = True) -> Axes:
    """Draws a stability map: its mechanisms as areas and, where they were followed, its boundaries as lines.

    Args:
        found: a map of :func:`judder.oscillator.stability_map`, or the dataset of an analysis ``stability-map``.
        ax: where to draw; the current axes where none are given.
        legend: whether to name areas and lines, those that occur.

    Returns:
        The axes, with labels and, where values have equal ratios, logarithmic scales.

    Raises:
        InputError: it is no stability map.
        PackageError: matplotlib is not installed.

    >>> import matplotlib; matplotlib.use("agg")
    >>> found = judder.oscillator.stability_map(("velocity", [1e-6, 1e-4, 1e-2]), ("shear_strength", [0.01, 0.1]))
    >>> judder.plot.stability(found).get_xscale()
    'log'
    """
    needed("matplotlib", "plot", "judder.plot")
    import matplotlib.pyplot as pyplot
    import numpy as np
    import xarray
    from matplotlib.colors import ListedColormap

    if not isinstance(found, StabilityMap) and not (isinstance(found, xarray.Dataset) and "stability" in found):
        has = f"a dataset of {', '.join(f'`{name}`' for name in found)}" if isinstance(found, xarray.Dataset) else repr(found)
        raise InputError(f"found: a stability map is needed, not {has}", "Input", {"argument": "found"})
    axes = pyplot.gca() if ax is None else ax
    data = found.to_dataset() if isinstance(found, StabilityMap) else found
    classes = data["stability"]
    y, x = (data[name] for name in classes.dims)
    names = str(classes.attrs["flag_meanings"]).split()
    colours = ListedColormap([COLOURS[name] for name in names])
    axes.pcolormesh(x.values, y.values, classes.values, cmap=colours, vmin=-0.5, vmax=len(names) - 0.5, shading="nearest", rasterized=True)
    is_open = np.zeros(classes.shape, bool)
    if "within_law" in data and min(classes.shape) > 1:
        is_open = data["within_law"].values == LAW_STANDINGS.index("marginal_within_the_law")
        _hatched(axes, x.values, y.values, is_open)
    _boundaries(data, str(x.name), str(y.name), axes)
    axes.grid(visible=False)
    axes.set(xlabel=_label(x), ylabel=_label(y), xscale=_scale(x), yscale=_scale(y))
    axes.set(xlim=(x.values.min(), x.values.max()), ylim=(y.values.min(), y.values.max()))
    if legend:
        _legend(axes, [names[code] for code in np.unique(classes.values[~is_open])], with_open=bool(is_open.any()))
    return axes


def _hatched(axes: Axes, x: NDArray[np.float64], y: NDArray[np.float64], is_open: NDArray[np.bool_]) -> None:
    """Crosses out the points whose verdict the errors of the law decide."""
    import numpy as np

    if is_open.any():
        colours = [COLOURS["marginal-within-the-law"]]
        areas = axes.contourf(x, y, is_open.astype(np.float64), levels=[0.5, 1.5], colors=colours, hatches=["xxx"])
        areas.set_edgecolor(COLOURS["reference"])


def _boundaries(data: xarray.Dataset, x: str, y: str, axes: Axes) -> None:
    """The boundaries that the dataset has, each with a light rim that keeps it apart from the areas."""
    from matplotlib.patheffects import Normal, Stroke

    for name, (label, dash) in _BOUNDARIES.items():
        if f"{name}_boundary_{x}" in data:
            along = [data[f"{name}_boundary_{side}"].values for side in (x, y)]
            (line,) = axes.plot(*along, dash, color=COLOURS[f"{name}-boundary"], linewidth=1.3, label=label)
            line.set_path_effects([Stroke(linewidth=2.8, foreground="white"), Normal()])


def _label(side: xarray.DataArray) -> str:
    """Name and unit of a side of a map."""
    units = side.attrs.get("units", "1")
    return str(side.attrs.get("label", f"{side.attrs.get('long_name', side.name)} ({'–' if units == '1' else units})"))


def _scale(side: xarray.DataArray) -> str:
    """Logarithmic where the values have equal ratios."""
    import numpy as np

    values = side.values
    even = len(values) > 2 and bool(np.all(values > 0)) and np.allclose(np.diff(np.log(values), 2), 0, atol=1e-6)
    return "log" if even else "linear"


def _legend(axes: Axes, names: list[str], *, with_open: bool) -> None:
    """Areas, then lines, below the axes."""
    from matplotlib.patches import Patch

    words = {name: name.replace("-", " ") for name in names} | {"normal-force-coupling": "normal-force coupling"}
    rim = COLOURS["reference"]
    areas = [Patch(facecolor=COLOURS[name], edgecolor=rim, linewidth=0.5, label=words[name]) for name in names]
    if with_open:
        colour = COLOURS["marginal-within-the-law"]
        areas.append(Patch(facecolor=colour, edgecolor=rim, linewidth=0.5, hatch="xxx", label="marginal within the law"))
    lines, _ = axes.get_legend_handles_labels()
    axes.legend(handles=[*areas, *lines], loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=3, frameon=False, fontsize="small")


_arguments.checked(globals())
