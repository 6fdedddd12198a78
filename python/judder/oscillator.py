"""The two-degree-of-freedom oscillator in sliding contact: is steady sliding stable, and why not.

Everything is dimensionless as in the oscillator paper: speeds v τ/R, loads F/(E0* R²), stresses τ0/E0*, times ω_nx t.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, Unpack

from judder import _arguments, _judder
from judder._columns import described, wrong
from judder._judder import OscillatorPoint, point
from judder._keys import FrictionLoad, Keys, LawName
from judder._shown import Shown, told
from judder.contact import Law
from judder.progress import Progress

if TYPE_CHECKING:
    import numpy as np
    import xarray
    from numpy.typing import ArrayLike, NDArray

__all__ = ["Axis", "FrictionLoad", "Keys", "LawName", "Numeric", "OscillatorPoint", "StabilityMap", "Values", "point", "points", "stability_map"]

Numeric: TypeAlias = float | str
"""A dimensionless group, or a text with a unit."""

Values: TypeAlias = "ArrayLike | tuple[ArrayLike, str] | xarray.DataArray"
"""Values of a key: groups, or with their unit, ``(np.linspace(1, 50), "mm/s")``; a DataArray has it in its attribute ``units``."""

CLASSES = (
    "stable",
    "flutter",
    "negative-damping",
    "both",
    "normal-force-coupling",
    "marginal",
    "unresolved",
    "destabilised-by-damping",
)
"""What the codes of ``StabilityMap.classes`` mean, in their order."""
LAW_STANDINGS = ("decided", "marginal_within_the_law", "unknown")
"""What the codes of ``StabilityMap.within_law`` mean, in their order."""
_OTHER_CLASSES = ("stable", "marginal", "unresolved")
"""Those that are no mechanism."""


@dataclass(frozen=True, eq=False, repr=False)
class Axis(Shown):
    """One side of a map."""

    key: str
    """The key, such as ``"operation.velocity"``."""
    name: str
    """Its last name, such as ``"velocity"``."""
    values: NDArray[np.float64]
    """Its values, in ``units``."""
    long_name: str
    """What it is, in words."""
    units: str
    """Its unit, ``"1"`` for a group."""

    def _short(self) -> str:
        """Its name, how many values it has, and between which."""
        unit = "" if self.units == "1" else f" {self.units}"
        return f"{self.name}, {told([*self.values.tolist()])}{unit}"


@dataclass(frozen=True, eq=False, repr=False)
class StabilityMap(Shown):
    """Verdict, mechanism and growth rate over two keys; arrays are [y, x]."""

    x: Axis
    """The columns."""
    y: Axis
    """The rows."""
    classes: NDArray[np.uint8]
    """Codes of verdict and mechanism, uint8[y, x]: the places of their names in :data:`CLASSES`."""
    growth_rate: NDArray[np.float64] | None
    """Growth rate in units of ω_nx, float64[y, x]; NaN where there is no steady sliding, ``None`` where it was not asked for."""
    within_law: NDArray[np.uint8] | None
    """What the errors of the contact law leave of the verdicts, uint8[y, x]: the places of :data:`LAW_STANDINGS`. Found on a coarse grid and from
    there on along its edges. ``None`` for a formula, which has no errors."""
    decisions: int
    """Points that were decided; the others follow from their neighbours (``method="adaptive"``)."""
    seconds: float
    """What verdicts and growth rates took, without the way there and back."""
    warnings: tuple[str, ...]
    """What makes the law doubtful, a sentence each."""
    case: str = field(repr=False)
    """The case of all other keys and of the law, JSON."""

    @property
    def unstable(self) -> NDArray[np.bool_]:
        """Where steady sliding is unstable, bool[y, x]."""
        found: NDArray[np.bool_] = self.verdict == "unstable"
        return found

    @property
    def unstable_fraction(self) -> float:
        """Share of the points that is unstable."""
        return float(self.unstable.mean())

    @property
    def unresolved(self) -> int:
        """How many points have no answer."""
        return int((self.classes == CLASSES.index("unresolved")).sum())

    @property
    def verdict(self) -> NDArray[np.str_]:
        """``"stable"``, ``"marginal"``, ``"unstable"`` or ``"unresolved"``, str[y, x]."""
        import numpy as np

        names = [name if name in _OTHER_CLASSES else "unstable" for name in CLASSES]
        found: NDArray[np.str_] = np.array(names)[self.classes]
        return found

    @property
    def mechanism(self) -> NDArray[np.str_]:
        """What carries an instability, ``"none"`` where there is none, str[y, x]."""
        import numpy as np

        names = ["none" if name in _OTHER_CLASSES else name for name in CLASSES]
        found: NDArray[np.str_] = np.array(names)[self.classes]
        return found

    def _told(self) -> Iterator[tuple[str, str]]:
        yield "x", self.x._short()
        yield "y", self.y._short()
        count = self.classes.size
        yield "unstable", f"{100 * self.unstable_fraction:.3g} % of {count} points"
        shares = {name: 100 * (self.classes == code).sum() / count for code, name in enumerate(CLASSES)}
        yield "mechanisms", ", ".join(f"{name} {share:.3g} %" for name, share in shares.items() if name not in _OTHER_CLASSES and share) or "none"
        yield "unresolved", str(self.unresolved)
        if self.growth_rate is not None:
            yield "growth_rate", f"{told(self.growth_rate)} ω_nx"
        if self.warnings:
            yield "warnings", told(self.warnings)

    def to_dataset(self) -> xarray.Dataset:
        """The map as the dataset that an analysis ``stability-map`` leaves: ``stability``, ``growth_rate``, ``within_law`` and their coordinates."""
        import numpy as np
        import xarray

        sides = (self.y.name, self.x.name)
        codes = {"flag_values": np.arange(len(CLASSES), dtype=np.uint8), "flag_meanings": " ".join(CLASSES)}
        stability = {"long_name": "stability of steady sliding, by mechanism", **codes}
        variables: dict[str, tuple[tuple[str, str], NDArray[np.uint8] | NDArray[np.float64], dict[str, object]]] = {
            "stability": (sides, self.classes, dict(stability))
        }
        if self.growth_rate is not None:
            about: dict[str, object] = {"long_name": "growth rate max Re(λ)/ω_nx", "units": "1"}
            variables["growth_rate"] = (sides, self.growth_rate, about)
        if self.within_law is not None:
            codes = {"flag_values": np.arange(len(LAW_STANDINGS), dtype=np.uint8), "flag_meanings": " ".join(LAW_STANDINGS)}
            about = {"long_name": "what the errors of the contact law leave of the verdict", **codes}
            variables["within_law"] = (sides, self.within_law, about)
        coordinates = {
            axis.name: (axis.name, axis.values, {"long_name": axis.long_name, "units": axis.units, "key": axis.key})
            for axis in (self.x, self.y)
        }
        about_all = {"judder_case": self.case, "judder_warnings": "\n".join(self.warnings)}
        return xarray.Dataset(variables, coordinates, about_all)


Side: TypeAlias = "tuple[str, ArrayLike] | tuple[str, ArrayLike, str]"
"""A key, its values, and their unit where they are no groups."""


def _side(argument: str, given: Any) -> tuple[str, Any, str | None]:
    """A key, its values and their unit, as the compiled part takes them."""
    needed = 'a key, its values and, where they have one, their unit are needed, such as ("velocity", np.linspace(1, 50), "mm/s")'
    if not isinstance(given, tuple | list):
        raise wrong(argument, f"is {described(given)}, and {needed}")
    if len(given) not in (2, 3):
        raise wrong(argument, f"has {len(given)} items, and {needed}")
    key, values, unit = (*given, None)[:3]
    for own, name in ((key, "key"), (unit or "", "unit")):
        if not isinstance(own, str) or (name == "key" and not own):
            raise wrong(argument, f"has {own!r} as its {name}, and {needed}")
    return key, values, unit


def stability_map(
    x: Side,
    y: Side,
    *,
    method: Literal["every-point", "adaptive"] = "every-point",
    growth_rate: bool = True,
    law: LawName | Law | None = None,
    friction_load: FrictionLoad | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
    **keys: Unpack[Keys],
) -> StabilityMap:
    """Verdict, mechanism and growth rate over two keys.

    Args:
        x: what the columns vary: the key (``"velocity"`` or ``"operation.velocity"``), its values, float64[n], and their unit where they
            are no dimensionless groups: ``("velocity", np.linspace(1, 50, 100), "mm/s")``.
        y: what the rows vary, float64[m].
        method: ``"every-point"``; ``"adaptive"`` decides a coarse grid and then along its boundaries only, and has no growth rates.
        growth_rate: whether to compute growth rates too, some twenty times the work of the verdicts.
        law: a law's name or a :class:`judder.contact.Law`; the oscillator paper's where none is given.
        friction_load: which load carries the viscoelastic friction, ``"normal-load"`` where none is given.
        threads: threads to compute with; one a core where none is given. The result does not depend on it.
        progress: ``progress(name, done, total)``.
        keys: all other :class:`Keys`, as of :func:`point`.

    Raises:
        CaseError, InputError: a value out of range, a wrong unit, an array that is empty or not of one dimension.

    >>> import numpy as np
    >>> found = judder.oscillator.stability_map(
    ...     ("velocity", np.logspace(-6, 0, 50)), ("shear_strength", np.linspace(0, 0.2, 40)), growth_rate=False)
    >>> found.classes.shape, found.unresolved
    ((40, 50), 0)
    """
    told = _judder.oscillator_map(
        _side("x", x),
        _side("y", y),
        method=method,
        growth_rate=growth_rate and method == "every-point",
        law=law,
        friction_load=friction_load,
        threads=threads,
        progress=progress,
        keys=dict(keys),
    )
    return StabilityMap(
        x=Axis(*told["x"]),
        y=Axis(*told["y"]),
        classes=told["classes"],
        growth_rate=told["growth_rate"],
        within_law=told["within_law"],
        decisions=told["decisions"],
        seconds=told["seconds"],
        warnings=tuple(told["warnings"]),
        case=told["case"],
    )


def points(
    *,
    quantities: str | Sequence[str] | None = None,
    law: LawName | Law | None = None,
    friction_load: FrictionLoad | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
    **keys: Values,
) -> xarray.Dataset:
    """Operating points over arrays of any keys, which are broadcast against each other: many times :func:`point`, in compiled code, on all cores.

    Args:
        quantities: what to find, one or several, by the names that a ``[[sweep]]`` of an oscillator has; all that need no search where none are named. Thresholds, such as
            ``"critical_shear_strength"``, are sought where they are named.
        law: a law's name or a :class:`judder.contact.Law`; the oscillator paper's where none is given.
        friction_load: which load carries the viscoelastic friction, ``"normal-load"`` where none is given.
        threads: threads to compute with; one a core where none is given. The result does not depend on it.
        progress: ``progress(name, done, total)``.
        keys: :class:`Keys`, each a number, a text with a unit, an array of groups, an array with its unit, ``velocity=(np.linspace(1, 50), "mm/s")``, or a
            DataArray, whose attribute ``units`` counts. One that is ``None`` is as left out.

    Returns:
        A dataset: a variable for each quantity and the eigenvalues; NaN where there is no steady sliding. A dimension along which one key alone varies
        is called by that key, any other ``point``; DataArrays keep their dimensions. The attribute ``judder_case`` has all other keys and the law, JSON,
        ``judder_warnings`` what has to be known, which is a :class:`judder.JudderWarning` too.

    Raises:
        CaseError, InputError: a value out of range, a wrong unit, arrays that cannot be broadcast.

    >>> import numpy as np
    >>> found = judder.oscillator.points(velocity=np.logspace(-5, -3, 5), shear_strength=[[0.01], [0.05]])
    >>> dict(found.growth_rate.sizes), found.velocity.attrs["units"]
    ({'shear_strength': 2, 'velocity': 5}, '1')
    """
    from judder import _points

    given = [quantities] if isinstance(quantities, str) else quantities
    names = None if given is None else list(given) if isinstance(given, Iterable) else [given]
    if not all(isinstance(name, str) for name in names or ()):
        raise wrong("quantities", f"is {described(quantities)}, and a name or a list of names is needed, such as [\"growth_rate\"]")
    varied = _points.Varied(keys)
    told = _judder.oscillator_points(
        varied.sides(),
        quantities=names,
        law=law,
        friction_load=friction_load,
        threads=threads,
        progress=progress,
        keys=varied.fixed,
    )
    return _points.dataset(varied, told)


_arguments.checked(globals())
