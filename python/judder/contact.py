"""Contact: what an indenter that slides on a viscoelastic substrate feels, computed and as a law.

Everything is dimensionless: speeds v τ/R, depths y/R, forces F/(E0* R²), areas A/R², pressures p/E0*.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

from judder import _arguments, _judder
from judder._judder import Law
from judder._keys import CONTACT_ACCURACY, CONTACT_MEMORY
from judder._shown import Shown

if TYPE_CHECKING:
    import numpy as np
    import xarray
    from numpy.typing import ArrayLike, NDArray

__all__ = ["ContactSolution", "Law", "LawResponse", "Level", "Shape", "Substrate", "solve"]


@dataclass(frozen=True, eq=False, repr=False)
class LawResponse(Shown):
    """What a law gives at points: values and exact first derivatives, arrays of the points' shape."""

    force: NDArray[np.float64]
    """F_k/(E0* R²)."""
    force_by_velocity: NDArray[np.float64]
    """Its derivative by v τ/R."""
    force_by_indentation: NDArray[np.float64]
    """Its derivative by y/R."""
    area: NDArray[np.float64]
    """A/R²."""
    area_by_velocity: NDArray[np.float64]
    """Its derivative by v τ/R."""
    area_by_indentation: NDArray[np.float64]
    """Its derivative by y/R."""
    friction: NDArray[np.float64]
    """μ_visc."""
    friction_by_velocity: NDArray[np.float64]
    """Its derivative by v τ/R."""
    friction_by_indentation: NDArray[np.float64]
    """Its derivative by y/R."""


@dataclass(frozen=True)
class Substrate:
    """A linear viscoelastic half-space, or under a cylinder a layer on a rigid base, 1/E(ω) = 1/E∞ + Σ C_k/(1 + i ω τ_k), over 1/E0.

    One retardation time and E∞/E0 = 10, the oscillator paper's, where nothing is given.
    """

    modulus_ratio: float = 10.0
    """E∞/E0, above 1."""
    terms: Sequence[tuple[float, float]] = field(default=())
    """Pairs τ_k/τ, C_k E0, with Σ C_k E0 = 1 − E0/E∞; one term with τ where none is given."""
    thickness: float | None = None
    """h/R of a layer whose base is rigid and holds it; a half-space where left out."""
    poisson_ratio: float = 0.5
    """Poisson's ratio ν of the layer, above −1, at most 1/2; on a half-space it stands in E0* alone."""

    @property
    def layer(self) -> tuple[float, float] | None:
        """Thickness and Poisson's ratio of the layer; ``None`` for a half-space."""
        return None if self.thickness is None else (self.thickness, self.poisson_ratio)

    def resolved(self) -> list[tuple[float, float]]:
        """The terms, that of one retardation time among them."""
        return [*self.terms] or [(1.0, 1.0 - 1.0 / self.modulus_ratio)]


Shape: TypeAlias = "Literal['paraboloid', 'sphere', 'cylinder'] | tuple[ArrayLike, float]"
"""An indenter by name, or heights above its lowest point, float64[rows, columns] in R, x along the columns, with their spacing."""


@dataclass(frozen=True)
class Level:
    """The result on one grid of a sequence."""

    cells: int
    """Cells a side."""
    force: float
    """F/(E0* R²)."""
    area: float
    """A/R²."""
    friction: float
    """μ."""
    indentation: float
    """y/R."""


@dataclass(frozen=True, eq=False, repr=False)
class ContactSolution(Shown):
    """The contact of steady sliding with its estimated relative errors, and the fields on the finest grid.

    Of a cylinder force and area are per length: F/(E0* R), a width over R.
    """

    force: float
    """F/(E0* R²)."""
    force_error: float
    """Its estimated relative error."""
    area: float
    """A/R²."""
    area_error: float
    """Its estimated relative error."""
    friction: float
    """μ_visc."""
    friction_error: float
    """Its estimated relative error, no smaller than the difference from that in the bulk."""
    indentation: float
    """y/R."""
    indentation_error: float
    """Its estimated relative error."""
    peak_pressure: float
    """The largest pressure over E0*."""
    peak_pressure_error: float
    """Its change from the grid before, relative; no accuracy is asked of it."""
    friction_from_dissipation: float
    """The friction coefficient once more, from the energy dissipated in the bulk."""
    converged: bool
    """Whether every grid's problem was solved and the accuracy is met."""
    levels: tuple[Level, ...]
    """The grids, coarse to fine."""
    x: NDArray[np.float64]
    """x/R of the cells, the direction of sliding, float64[columns]."""
    y: NDArray[np.float64]
    """y/R of the cells, float64[rows]."""
    pressure: NDArray[np.float64]
    """p/E0* on every cell, float64[rows, columns]."""
    gap: NDArray[np.float64]
    """Gap over R at every cell, float64[rows, columns]."""
    arguments: Mapping[str, Any]
    """What it was solved for: the arguments of :func:`solve`."""

    def to_dataset(self) -> xarray.Dataset:
        """The fields with their coordinates, the numbers as attributes."""
        import xarray

        from judder import _conventions

        sides = ("y", "x")
        fields_ = {
            "pressure": (sides, self.pressure, {"long_name": "pressure p/E0*", "units": "1"}),
            "gap": (sides, self.gap, {"long_name": "gap g/R", "units": "1"}),
        }
        coordinates = {
            "x": ("x", self.x, {"long_name": "x/R, the direction of sliding", "units": "1"}),
            "y": ("y", self.y, {"long_name": "y/R", "units": "1"}),
        }
        own = ((one.name, getattr(self, one.name)) for one in fields(self))
        numbers = {name: float(number) for name, number in own if isinstance(number, float | bool)}
        return xarray.Dataset(fields_, coordinates, {**_conventions.attributes(self.arguments), **numbers})


def solve(
    velocity: float,
    *,
    indentation: float | None = None,
    load: float | None = None,
    substrate: Substrate | None = None,
    shape: Shape = "paraboloid",
    accuracy: float = CONTACT_ACCURACY,
    cells: int | None = None,
    memory: int = CONTACT_MEMORY,
) -> ContactSolution:
    """The contact of a rigid indenter that slides steadily on a viscoelastic half-space or layer, by the boundary-element method.

    Args:
        velocity: v τ/R, positive.
        indentation: imposed depth y/R; either this or a load. A cylinder has a depth on a layer, and none on a half-space.
        load: imposed force F/(E0* R²), of a cylinder F/(E0* R).
        substrate: the oscillator paper's where none is given; with a ``thickness`` a layer, under a cylinder.
        shape: the indenter.
        accuracy: relative error allowed to the force, between 0 and 1; area and friction may be five times as far off.
        cells: cells a side of the finest grid; as many as the accuracy asks where none are given.
        memory: bytes that a grid's kernel may take.

    Returns:
        The solution. Where the finest grid misses the accuracy, ``converged`` is false and the errors say by how much.

    Raises:
        InputError: a number that is not positive and finite, an unknown shape, a layer under another shape than a cylinder or thinner than it is pressed in.
        ContactError: too deep, too much memory, a contact that is larger than the indenter.

    Ctrl-C acts when the contact is solved: seconds at the accuracy of 1e-3.

    >>> contact = judder.contact.solve(0.1, indentation=1e-2, accuracy=1e-2)
    >>> contact.converged, contact.pressure.shape == (contact.y.size, contact.x.size)
    (True, True)
    """
    own = substrate or Substrate()
    told = _judder.contact_solution(
        velocity,
        indentation=indentation,
        load=load,
        modulus_ratio=own.modulus_ratio,
        terms=own.resolved(),
        layer=own.layer,
        shape=shape,
        accuracy=accuracy,
        cells=cells,
        memory=_arguments.whole_bytes("memory", memory),
    )
    levels = tuple(Level(*level) for level in told.pop("levels"))
    asked = {"velocity": velocity, "indentation": indentation, "load": load, "accuracy": accuracy}
    shaped = shape if isinstance(shape, str) else "heights"
    named: dict[str, Any] = {"shape": shaped, "modulus_ratio": own.modulus_ratio, "terms": own.resolved()}
    if own.layer:
        named |= {"thickness": own.thickness, "poisson_ratio": own.poisson_ratio}
    arguments = {f"asked_{name}": value for name, value in {**asked, **named}.items() if value is not None}
    return ContactSolution(levels=levels, arguments=arguments, **told)


_arguments.checked(globals())
