"""Two structures in sliding contact: their eigenvalues against the position of the contact, and their march through time.

Everything is in SI units. A structure is given by its modes, M = I and K diagonal, as ``scipy.linalg.eigh(K, M)`` gives them, or
comes from a sliding case.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

from judder import _arguments, _judder
from judder._judder import Pair
from judder._keys import LOCUS_CONFIGURATION, LOCUS_COUNT, LOCUS_DAMPING, Configuration, MarchMethod, Predictor
from judder._objects import CaseSource
from judder._sampled import sampled
from judder._shown import Shown
from judder.progress import Progress
from judder.study import CaseLike

if TYPE_CHECKING:
    import numpy as np
    import xarray
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "Configuration",
    "Locus",
    "March",
    "Method",
    "Observed",
    "Pair",
    "Predictor",
    "Slider",
    "Track",
    "Zone",
    "friction_table",
    "load_pair",
    "locus",
    "march",
]

Method: TypeAlias = MarchMethod | Literal["subs-static-slope"]
"""How a march finds the contact and its force, see the beams paper; ``"film"`` knows stick and lift-off."""


@dataclass(frozen=True, eq=False, repr=False)
class Slider(Shown):
    """The structure that carries the contact point, in its own modes."""

    eigenvalues: ArrayLike
    """ω² of its modes by rising size, 1/s², float64[modes]; exactly zero of rigid motions."""
    contact: ArrayLike
    """Where the contact point lies undeformed, m, float64[2]."""
    contact_rows: ArrayLike
    """Its displacements along x and y by mode, 1/√kg, float64[2, modes]."""
    load: ArrayLike
    """Φᵀ f of a unit load where the slider is pressed, 1/√kg, float64[modes]."""
    inertia: ArrayLike
    """Φᵀ M 1 along the direction of sliding, √kg, float64[modes]."""
    alpha: float = 0.0
    """α of Rayleigh's damping, 1/s."""
    beta: float = 0.0
    """β of Rayleigh's damping, s."""


@dataclass(frozen=True, eq=False, repr=False)
class Track(Shown):
    """The structure along which the slider moves, in its own modes."""

    eigenvalues: ArrayLike
    """ω² of its modes by rising size, 1/s², float64[modes]."""
    nodes: ArrayLike
    """Where the nodes of its contact edge lie undeformed, in order, m, float64[nodes, 2]."""
    node_rows: ArrayLike
    """Their displacements along x and y by mode, 1/√kg, float64[nodes, 2, modes]."""
    alpha: float = 0.0
    """α of Rayleigh's damping, 1/s."""
    beta: float = 0.0
    """β of Rayleigh's damping, s."""


@dataclass(frozen=True, eq=False, repr=False)
class Observed(Shown):
    """A displacement that is watched."""

    side: Literal["slider", "track"]
    """Of which structure."""
    row: ArrayLike
    """The displacement by mode, 1/√kg, float64[modes]."""
    rigid: float = 0.0
    """What a unit displacement of the slider's frame along the track adds to it; 0 on the track."""


def friction_table(
    function: Callable[[NDArray[np.float64]], Any], *, velocity: tuple[float, float], tolerance: float = 1e-4
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """A friction law of one's own as the table of sliding speeds and coefficients that pairs and cases take: ``Pair(..., friction=table)``, or
    ``{"velocity [m/s]": table[0], "coefficient": table[1]}`` as ``friction_coefficient`` of a case.

    Args:
        function: coefficients at an array of speeds, m/s.
        velocity: the lowest and the highest speed, m/s; beyond them the coefficient stays as it is there.
        tolerance: how far straight lines between the points may be off, of the largest coefficient.

    Raises:
        InputError: a function whose values are not finite, or that jumps.

    >>> import numpy as np
    >>> def stribeck(velocity):
    ...     return 0.2 + 0.2 * np.exp(-velocity / 0.05) + 0.1 * velocity
    >>> velocity, coefficient = judder.sliding.friction_table(stribeck, velocity=(0.0, 1.0))
    >>> round(float(coefficient[0]), 3), velocity.size < 200
    (0.4, True)
    """
    return sampled("function", function, velocity, tolerance)


def load_pair(case: CaseLike, *, set: Mapping[str, Any] | None = None) -> Pair:
    """The pair of a sliding case: its structures built, reduced and coupled.

    It watches the displacements along x and y of each point that the case names, and knows the motion that the case prescribes.

    Args:
        case: a path, the text of a case, or its tables as a mapping.
        set: changed keys, such as ``{"contact.friction_coefficient": 0.3}``.

    Raises:
        CaseError: the case is wrong.
        StructureError, SlidingError: its structures cannot be built or coupled.
    """
    source = CaseSource(case, set)
    with source.told():
        return Pair.from_source(source.given, source.overrides, inputs=source)


@dataclass(frozen=True, eq=False, repr=False)
class March(Shown):
    """The signals of a march, arrays of n steps."""

    step: float
    """The time step, s."""
    ran_off: bool
    """Whether the contact ran off an end of the track before the end of its path."""
    time: NDArray[np.float64]
    """Since the start, s."""
    position: NDArray[np.float64]
    """Distance of the contact point from the track's first node without deformation, m."""
    normal_force: NDArray[np.float64]
    """N, on the slider along the normal, N."""
    tangential_force: NDArray[np.float64]
    """T, on the slider along the tangent, N: negative where it is dragged back."""
    sliding_velocity: NDArray[np.float64]
    """How fast the contact point moves along the track's own material, m/s."""
    gap: NDArray[np.float64]
    """Between the contact point and the track, m."""
    friction: NDArray[np.float64]
    """μ."""
    state: NDArray[np.uint8]
    """The contact states by their numbers in all results: 0 stick, 1 slip, 2 slip against the path, 3 lift-off."""
    accelerations: NDArray[np.float64]
    """Accelerations of the observed displacements, m/s², float64[n, observed]."""
    arguments: Mapping[str, Any]
    """What was asked for: the arguments of :func:`march` that were given."""
    warnings: tuple[str, ...]
    """What has to be known of the pair."""

    def to_dataset(self) -> xarray.Dataset:
        """The signals over time, with units and long names; what was asked for and what has to be known as attributes."""
        import numpy as np
        import xarray

        from judder import _conventions

        signals = {
            "position": ("position of the contact", "m"),
            "normal_force": ("normal force", "N"),
            "tangential_force": ("tangential force", "N"),
            "sliding_velocity": ("sliding velocity", "m/s"),
            "gap": ("gap", "m"),
            "friction": ("friction coefficient", "1"),
        }
        variables: dict[str, Any] = {
            name: ("time", getattr(self, name), {"long_name": words, "units": units}) for name, (words, units) in signals.items()
        }
        names = [name.replace(" ", "_") for name in _judder.CONTACT_STATES]
        codes = {"flag_values": np.arange(len(names), dtype=np.uint8), "flag_meanings": " ".join(names)}
        variables["state"] = ("time", self.state, {"long_name": "state of the contact", **codes})
        both = {"long_name": "acceleration", "units": "m/s²"}
        variables["accelerations"] = (("time", "observed"), self.accelerations, both)
        coordinates = {"time": ("time", self.time, {"long_name": "time", "units": "s"})}
        about = {"step_second": self.step, "ran_off": self.ran_off, **self.arguments, "judder_warnings": "\n".join(self.warnings)}
        return xarray.Dataset(variables, coordinates, _conventions.attributes(about))


def march(
    pair: Pair,
    *,
    start: float | None = None,
    end: float | None = None,
    velocity: float | None = None,
    load: float | None = None,
    method: Method = "ensubs",
    predictor: Predictor | None = None,
    cut_off: float | None = None,
    step: float | None = None,
    velocity_ramp: float | None = None,
    load_ramp: float | None = None,
    friction_ramp: float | None = None,
    gap_ramp: float | None = None,
    initial_gap: float | None = None,
    noise: float | None = None,
    seed: int | None = None,
    every: int = 1,
    progress: Progress | None = None,
) -> March:
    """Marches a pair through time from rest, its contact point along the track.

    What is not given of the motion has the value of the case that the pair comes from; without a case, velocity and load are needed, the
    path is the whole track, and all else is zero.

    Args:
        start, end: distances of the contact point from the track's first node, m.
        velocity: speed of the slider's frame after its ramp, m/s; negative towards the first node.
        load: in N after its ramp.
        method: how the contact is found and its force computed.
        predictor: of ``"ensubs"`` and ``"film"``: which displacements of the next step the geometry of the contact is taken from, those
            ``"with-force"`` of the last step where none is given, or ``"printed"``, those without it, as in the beams paper.
        cut_off: modes from this frequency on only yield, Hz; for ``"residual-flexibility"``.
        step: time step, s; a share of the largest stable one where none is given.
        velocity_ramp, load_ramp, friction_ramp, gap_ramp: durations of half-cosine ramps, s.
        initial_gap: gap between the contact point and the track at the start, m.
        noise: root mean square of a random force on the contact point, N; ``seed`` decides it.
        every: keep every so many steps; unfiltered.
        progress: ``progress(name, done, total)``.

    Raises:
        SlidingError: a step over its limit (``error.limit``), a path off the track, a slider that locks or flies away.
        InputError: a number that is missing.
        KeyboardInterrupt: Ctrl-C.
    """
    motion = {
        "start": start,
        "end": end,
        "velocity": velocity,
        "load": load,
        "initial_gap": initial_gap,
        "velocity_ramp": velocity_ramp,
        "load_ramp": load_ramp,
        "friction_ramp": friction_ramp,
        "gap_ramp": gap_ramp,
        "noise": noise,
        "seed": seed,
    }
    told = _judder.sliding_march(
        pair, motion, method=method, predictor=predictor, cut_off=cut_off, step=step, every=every, progress=progress
    )
    asked = {**motion, "method": method, "predictor": predictor, "cut_off": cut_off, "every": every}
    return March(arguments={name: own for name, own in asked.items() if own is not None}, warnings=tuple(pair.warnings), **told)


@dataclass(frozen=True)
class Zone:
    """A stretch of the track on which one eigenvalue is unstable."""

    start: float
    """Where it starts, m."""
    end: float
    """Where it ends, m."""
    ends: tuple[str, str]
    """What start and end are: ``"root"``, ``"range"``, ``"jump"``, ``"meeting"``, ``"lost"``."""
    peak: float
    """Where the growth rate is largest, m."""
    growth_rate: float
    """The growth rate there, 1/s."""
    frequency_hz: float
    """The frequency there, Hz."""


@dataclass(frozen=True, eq=False, repr=False)
class Locus(Shown):
    """Eigenvalues against the position of the contact."""

    positions: NDArray[np.float64]
    """Distances of the contact point from the track's first node, m, float64[n]."""
    eigenvalues: NDArray[np.complex128]
    """s in 1/s by position and branch, complex128[n, branches]; NaN where a branch is not among the ``count`` lowest. Where one leaves them and another enters, there are more branches than ``count``: none goes on as another."""
    normal_force: NDArray[np.float64]
    """Normal force of the state of rest, N, float64[n]."""
    zones: tuple[Zone, ...]
    """Where the pair is unstable, by where they start."""
    arguments: Mapping[str, Any]
    """What was asked for: the arguments of :func:`locus` that were given."""
    warnings: tuple[str, ...]
    """What has to be known of the pair."""

    def to_dataset(self) -> xarray.Dataset:
        """Growth rate and frequency of every branch over the position, with units and long names; what was asked for and what has to be known as
        attributes."""
        import numpy as np
        import xarray

        from judder import _conventions

        sides = ("position", "branch")
        frequency = np.abs(self.eigenvalues.imag) / (2.0 * np.pi)
        variables = {
            "growth_rate": (sides, self.eigenvalues.real, {"long_name": "growth rate", "units": "1/s"}),
            "frequency": (sides, frequency, {"long_name": "frequency", "units": "Hz"}),
            "normal_force": ("position", self.normal_force, {"long_name": "normal force", "units": "N"}),
        }
        coordinates = {"position": ("position", self.positions, {"long_name": "position of the contact", "units": "m"})}
        about = {**self.arguments, "judder_warnings": "\n".join(self.warnings)}
        return xarray.Dataset(variables, coordinates, _conventions.attributes(about))


def locus(
    pair: Pair,
    positions: ArrayLike,
    *,
    count: int = LOCUS_COUNT,
    velocity: float | None = None,
    load: float | None = None,
    configuration: Configuration = LOCUS_CONFIGURATION,
    damped: bool = LOCUS_DAMPING,
    threads: int | None = None,
) -> Locus:
    """Eigenvalues of the coupled pair against the position of the contact, and every zone in which it is unstable.

    Args:
        positions: distances of the contact point from the track's first node, ascending, m, float64[n].
        count: how many eigenvalues at each position, the lowest by the larger of imaginary and absolute real part.
        velocity: sliding speed, m/s; that of the case where none is given.
        load: in N; that of the case where none is given.
        configuration: ``"undeformed"``, or ``"deformed"`` by the load.
        damped: whether modes are damped and friction falls with speed.
        threads: threads to compute with; one a core where none is given. The result does not depend on it.

    Raises:
        SlidingError: a position off the track, a slider that locks, eigenvalues that were not found.
        InputError: a number that is missing.
        KeyboardInterrupt: Ctrl-C.
    """
    told = _judder.sliding_locus(
        pair,
        positions,
        count=count,
        velocity=velocity,
        load=load,
        configuration=configuration,
        damped=damped,
        threads=threads,
    )
    zones = tuple(Zone(*zone) for zone in told.pop("zones"))
    asked = {"count": count, "velocity": velocity, "load": load, "configuration": configuration, "damped": damped}
    arguments = {name: own for name, own in asked.items() if own is not None}
    return Locus(zones=zones, arguments=arguments, warnings=tuple(pair.warnings), **told)


_arguments.checked(globals())
