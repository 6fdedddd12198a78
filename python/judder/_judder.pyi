from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from typing import Any, Final, Literal, Unpack, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from judder._keys import FrictionLoad, Keys, LawName
from judder.contact import LawResponse
from judder.errors import JudderError
from judder.sliding import Observed, Slider, Track

__all__ = [
    "BUILD",
    "CONTACT_STATES",
    "VERSION",
    "HeldStudy",
    "HeldSweep",
    "Law",
    "OscillatorPoint",
    "Pair",
    "ServedPage",
    "Sweep",
    "checked_case",
    "command",
    "computed_analysis",
    "contact_solution",
    "copied_study",
    "declared_models",
    "embedded_examples",
    "held_analysis",
    "held_case",
    "oscillator_map",
    "oscillator_points",
    "point",
    "rebuilt_point",
    "rebuilt_report",
    "repeated_points",
    "reproduced_paper",
    "run_case",
    "schema_text",
    "sliding_locus",
    "sliding_march",
    "template_text",
    "text_of_case",
    "written_example",
]

BUILD: Final[str]
VERSION: Final[str]
CONTACT_STATES: Final[list[str]]

_Path = str | PathLike[str]
_Package = tuple[str, str, list[str], list[tuple[str, str]]]
_Progress = Callable[[str, int, int], object]

@final
class OscillatorPoint:
    @property
    def eigenvalues(self) -> NDArray[np.complex128]: ...
    @property
    def growth_rate(self) -> float: ...
    @property
    def growth_rate_error(self) -> float | None: ...
    @property
    def marginal_within_law(self) -> bool | None: ...
    @property
    def verdict(self) -> Literal["stable", "marginal", "unstable", "unresolved"]: ...
    @property
    def mechanism(self) -> Literal["none", "flutter", "negative-damping", "both", "normal-force-coupling", "destabilised-by-damping"]: ...
    @property
    def damping(self) -> NDArray[np.float64]: ...
    @property
    def stiffness(self) -> NDArray[np.float64]: ...
    @property
    def equivalent_damping(self) -> float: ...
    @property
    def equivalent_damping_error(self) -> float | None: ...
    @property
    def x(self) -> float: ...
    @property
    def y(self) -> float: ...
    @property
    def indentation(self) -> float: ...
    @property
    def force(self) -> float: ...
    @property
    def area(self) -> float: ...
    @property
    def viscoelastic_friction(self) -> float: ...
    @property
    def critical_shear_strength(self) -> NDArray[np.float64]: ...
    @property
    def critical_load(self) -> NDArray[np.float64]: ...
    @property
    def warnings(self) -> list[str]: ...
    def to_json(self) -> str: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

def point(
    *, law: LawName | Law | None = None, friction_load: FrictionLoad | None = None, **keys: Unpack[Keys]
) -> OscillatorPoint: ...
def rebuilt_point(
    values: Sequence[tuple[float, bool]], is_relaxation: bool, law: str | Law, friction_load: str
) -> OscillatorPoint: ...
def repeated_points(times: int) -> float: ...
def oscillator_map(
    x: tuple[str, ArrayLike, str | None],
    y: tuple[str, ArrayLike, str | None],
    *,
    method: str,
    growth_rate: bool,
    law: LawName | Law | None,
    friction_load: FrictionLoad | None,
    threads: int | None,
    progress: _Progress | None,
    keys: dict[str, Any],
) -> dict[str, Any]: ...
def oscillator_points(
    varied: Sequence[tuple[str, ArrayLike, str | None]],
    *,
    quantities: Sequence[str] | None,
    law: LawName | Law | None,
    friction_load: FrictionLoad | None,
    threads: int | None,
    progress: _Progress | None,
    keys: dict[str, Any],
) -> dict[str, Any]: ...
@final
class Law:
    def __new__(cls, name: LawName) -> Law: ...
    @staticmethod
    def from_table(
        velocity: ArrayLike,
        indentation: ArrayLike,
        force: ArrayLike,
        area: ArrayLike,
        friction: ArrayLike,
        *,
        source: str = "a table",
    ) -> Law: ...
    @staticmethod
    def from_function(
        function: Callable[[NDArray[np.float64], NDArray[np.float64]], tuple[ArrayLike, ArrayLike, ArrayLike]],
        *,
        velocity: tuple[float, float],
        indentation: tuple[float, float],
        tolerance: float = 1e-4,
        source: str = "a function",
    ) -> Law: ...
    @staticmethod
    def from_json(text: str) -> Law: ...
    @staticmethod
    def load(path: _Path) -> Law: ...
    def save(self, path: _Path) -> None: ...
    def to_json(self) -> str | None: ...
    def evaluate(self, velocity: ArrayLike, indentation: ArrayLike, *, threads: int | None = None) -> LawResponse: ...
    def concern(self, velocity: float, indentation: float) -> str | None: ...
    @property
    def name(self) -> str: ...
    @property
    def errors(self) -> dict[str, float] | None: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...

def contact_solution(
    velocity: float,
    *,
    indentation: float | None,
    load: float | None,
    modulus_ratio: float,
    terms: Sequence[tuple[float, float]],
    layer: tuple[float, float] | None,
    shape: str | tuple[ArrayLike, float],
    accuracy: float,
    cells: int | None,
    memory: int,
) -> dict[str, Any]: ...
@final
class Pair:
    def __new__(
        cls,
        slider: Slider,
        track: Track,
        *,
        friction: float | tuple[ArrayLike, ArrayLike],
        interpolation: str = "linear",
        side: str = "left",
        observed: Sequence[Observed] = ...,
    ) -> Pair: ...
    @staticmethod
    def from_source(case: tuple[str, str] | str, overrides: Sequence[str], *, inputs: object = None) -> Pair: ...
    @property
    def package(self) -> _Package | None: ...
    def __copy__(self) -> Pair: ...
    def __deepcopy__(self, _memo: object, /) -> Pair: ...
    @property
    def modes(self) -> int: ...
    @property
    def eigenvalues(self) -> NDArray[np.float64]: ...
    @property
    def node_positions(self) -> NDArray[np.float64]: ...
    @property
    def observed(self) -> int: ...
    @property
    def warnings(self) -> list[str]: ...

def sliding_march(
    pair: Pair,
    motion: Mapping[str, float | int | None],
    *,
    method: str,
    predictor: str | None,
    cut_off: float | None,
    step: float | None,
    every: int,
    progress: _Progress | None,
) -> dict[str, Any]: ...
def sliding_locus(
    pair: Pair,
    positions: ArrayLike,
    *,
    count: int,
    velocity: float | None,
    load: float | None,
    configuration: str,
    damped: bool,
    threads: int | None,
) -> dict[str, Any]: ...
def declared_models() -> str: ...
def text_of_case(case: tuple[tuple[str, str] | str, str, Sequence[str]]) -> str: ...
def held_analysis(
    case: tuple[tuple[str, str] | str, str, Sequence[str]],
    kind: str,
    keys: str,
    *,
    threads: int | None,
    progress: _Progress | None,
) -> tuple[str, _Held | None]: ...
def computed_analysis(
    case: tuple[tuple[str, str] | str, str, Sequence[str]],
    kind: str,
    keys: str,
    *,
    folder: str,
    threads: int | None,
    progress: _Progress | None,
) -> tuple[str, list[str]]: ...
def checked_case(case: tuple[str, str] | str, overrides: Sequence[str]) -> str: ...
def run_case(
    case: tuple[str, str] | str,
    *,
    output: str | None,
    only: Sequence[str],
    overrides: Sequence[str],
    fresh: bool,
    law: Law | None,
    threads: int | None,
    progress: _Progress | None,
    report: bool,
) -> dict[str, Any]: ...
def held_case(
    case: tuple[str, str] | str,
    *,
    only: Sequence[str],
    overrides: Sequence[str],
    law: Law | None,
    memory: int,
    threads: int | None,
    progress: _Progress | None,
) -> _Held | None: ...
def copied_study(folder: str) -> None: ...
@final
class HeldStudy:
    @property
    def summary(self) -> str: ...
    def arrays(self, name: str) -> tuple[str, list[Any]]: ...
    def files(self) -> list[tuple[str, bytes]]: ...
    def figures(self) -> list[tuple[str, str]]: ...
    def save(self, folder: str, report: bool) -> None: ...

_Held = tuple[HeldStudy, list[str], list[tuple[str, JudderError]]]

@final
class Sweep:
    @staticmethod
    def all(
        case: tuple[str, str] | str, overrides: Sequence[str], *, threads: int | None = None, law: tuple[Law, str] | None = None
    ) -> list[Sweep]: ...
    @property
    def name(self) -> str: ...
    @property
    def hash(self) -> str: ...
    @property
    def method(self) -> str: ...
    @property
    def points(self) -> int: ...
    @property
    def chunks(self) -> int: ...
    @property
    def shape(self) -> list[int]: ...
    @property
    def chunk_shape(self) -> list[int]: ...
    @property
    def keys(self) -> list[str]: ...
    @property
    def quantities(self) -> list[str]: ...
    @property
    def package(self) -> _Package: ...
    def estimate(self, folder: _Path | None = None) -> str: ...
    def missing(self, folder: _Path) -> NDArray[np.int64]: ...
    def prepare(self, *, stop: Callable[[], bool] | None = None) -> None: ...
    def compute(self, chunks: Sequence[int], *, stop: Callable[[], bool] | None = None) -> list[bytes]: ...
    def values(self, chunk: int) -> NDArray[np.float64]: ...
    def compute_into(
        self, folder: _Path, chunks: Sequence[int], *, stop: Callable[[], bool] | None = None
    ) -> tuple[list[int], list[int]]: ...
    def point(self, chunk: int, index: int) -> tuple[NDArray[np.float64], str | None]: ...
    def point_without_values(self, chunk: int, index: int) -> NDArray[np.float64]: ...
    def hold(self, folder: _Path) -> HeldSweep: ...
    def encoded(self, chunk: int, values: Sequence[float], failures: Sequence[tuple[int, str]]) -> bytes: ...
    def count(self, chunk: int) -> int: ...
    def run(self, folder: _Path, *, shard: str | None, threads: int | None, progress: _Progress | None) -> list[str]: ...
    def merge(self, folder: _Path) -> tuple[list[str], bool]: ...

@final
class HeldSweep:
    def write(self, chunks: Sequence[tuple[int, bytes]]) -> None: ...
    def release(self) -> None: ...

def template_text(name: str) -> str: ...
def schema_text() -> str: ...
def rebuilt_report(folder: str) -> str: ...
def reproduced_paper(paper: str, *, quick: bool, output: str | None, threads: int | None, progress: _Progress | None) -> str: ...
def embedded_examples(name: str | None = None) -> list[tuple[str, str, str, str, str, list[tuple[str, bytes]]]]: ...
def written_example(name: str, folder: str) -> str: ...
@final
class ServedPage:
    def __new__(cls, case: tuple[str, str] | str | None, overrides: Sequence[str], *, study: str | None, port: int | None) -> ServedPage: ...
    @property
    def address(self) -> str: ...
    @property
    def is_open(self) -> bool: ...
    def close(self) -> None: ...

def command(words: Sequence[str]) -> int: ...
