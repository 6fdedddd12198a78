"""The models, a class each, and in it a method for every kind of analysis; `help` tells every key.

The tests write it from the declarations by which case files are read: ``JUDDER_GOLDEN=write cargo nextest run -p judder-python``.
"""

from collections.abc import Mapping, Sequence
from typing import Any, Literal

from judder._model import Model, Result
from judder.progress import Progress
from judder.study import CaseLike

__all__ = [
    "Assembly",
    "Belt",
    "Contact",
    "Model",
    "Oscillator",
    "Result",
    "Sliding",
    "Structure",
    "TwoDegrees",
]

class Oscillator(Model):
    """The oscillator of the oscillator paper."""

    def __init__(
        self,
        case: CaseLike | None = None,
        *,
        set: Mapping[str, Any] | None = None,
        analysis: Sequence[Mapping[str, Any]] | None = None,
        contact: Mapping[str, Any] | None = None,
        indenter: Mapping[str, Any] | None = None,
        operation: Mapping[str, Any] | None = None,
        oscillator: Mapping[str, Any] | None = None,
        substrate: Mapping[str, Any] | None = None,
        sweep: Sequence[Mapping[str, Any]] | None = None,
        title: str | None = None,
    ) -> None: ...
    def equivalent_damping(
        self,
        *,
        sweep: Mapping[str, Any],
        family: Mapping[str, Any] | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The equivalent damping ratio along one key."""
    def spectrum(
        self,
        *,
        sweep: Mapping[str, Any],
        family: Mapping[str, Any] | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The eigenvalues along one key."""
    def critical_shear_strength(
        self,
        *,
        sweep: Mapping[str, Any],
        within: Mapping[str, Any] | None = None,
        family: Mapping[str, Any] | None = None,
        global_margin: bool | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The critical shear strengths along one key."""
    def critical_load(
        self,
        *,
        sweep: Mapping[str, Any],
        within: Mapping[str, Any] | None = None,
        family: Mapping[str, Any] | None = None,
        global_margin: bool | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The critical loads along one key."""
    def stability_map(
        self,
        *,
        x: Mapping[str, Any],
        y: Mapping[str, Any],
        method: Literal["adaptive", "every-point"] | None = None,
        boundaries: bool | None = None,
        global_margin: bool | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Stable and unstable points over two keys."""
    def motion(
        self,
        *,
        start: Mapping[str, Any] | None = None,
        duration: float | str | None = None,
        transient: float | str | None = None,
        points: int | None = None,
        tolerance: float | None = None,
        steps: int | None = None,
        sound: bool | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The history of one motion: stick, slip, lift-off, its averages, its energy."""
    def limit_cycle(
        self,
        *,
        start: Mapping[str, Any] | None = None,
        duration: float | str | None = None,
        tolerance: float | None = None,
        steps: int | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The cycle that a motion settles to, with its Floquet multipliers."""
    def bifurcation(
        self,
        *,
        sweep: Mapping[str, Any],
        direction: Literal["both", "forward", "backward"] | None = None,
        start: Mapping[str, Any] | None = None,
        duration: float | str | None = None,
        transient: float | str | None = None,
        tolerance: float | None = None,
        steps: int | None = None,
        branches: bool | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """What the motion settles to along one key, each motion from the end of the one before."""
    def basin(
        self,
        *,
        within: Mapping[str, Any],
        samples: int | None = None,
        seed: int | None = None,
        duration: float | str | None = None,
        tolerance: float | None = None,
        steps: int | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The share of starts, drawn evenly, from which steady sliding is reached."""
    def engines(
        self,
        *,
        start: Mapping[str, Any] | None = None,
        time_step: Mapping[str, Any] | None = None,
        width: Mapping[str, Any] | None = None,
        duration: float | str | None = None,
        tolerance: float | None = None,
        steps: int | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The cycle that a motion settles to, by events, by time-stepping and with a smoothed sign."""

class Contact(Model):
    """A rigid indenter that slides on a viscoelastic substrate."""

    def __init__(
        self,
        case: CaseLike | None = None,
        *,
        set: Mapping[str, Any] | None = None,
        analysis: Sequence[Mapping[str, Any]] | None = None,
        indenter: Mapping[str, Any] | None = None,
        memory_limit: str | None = None,
        substrate: Mapping[str, Any] | None = None,
        sweep: Sequence[Mapping[str, Any]] | None = None,
        title: str | None = None,
    ) -> None: ...
    def contact(
        self,
        *,
        velocity: float | str,
        indentation: float | str | None = None,
        load: float | str | None = None,
        accuracy: float | None = None,
        cells: int | None = None,
        domain: float | str | None = None,
        memory_limit: str | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """One contact: force, area, friction, fields."""
    def contact_law(
        self,
        *,
        velocity: Mapping[str, Any] | None = None,
        indentation: Mapping[str, Any] | None = None,
        accuracy: float | None = None,
        method: Literal["collapse", "sweep"] | None = None,
        memory_limit: str | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Force, area and friction over speed and indentation, as a law for an oscillator."""
    def fit(
        self,
        *,
        velocity: Mapping[str, Any] | None = None,
        indentation: Mapping[str, Any] | None = None,
        accuracy: float | None = None,
        method: Literal["collapse", "sweep"] | None = None,
        velocity_scale: float | None = None,
        memory_limit: str | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The three functions of the oscillator paper, fitted to a computed law."""
    def modulus(
        self,
        *,
        frequency: Mapping[str, Any] | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Storage and loss modulus and loss tangent over frequency."""
    def transient(
        self,
        *,
        motion: Literal["start", "reciprocation", "rest"],
        velocity: float | str | None = None,
        amplitude: float | str | None = None,
        frequency: float | str | None = None,
        indentation: float | str | None = None,
        load: float | str | None = None,
        oscillation: Mapping[str, Any] | None = None,
        duration: float | str,
        cells: int | None = None,
        memory_limit: str | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """A contact that is followed in time: histories of force, friction and area, work of a cycle."""

class Belt(Model):
    """One mass on a moving belt, friction against the speed of sliding."""

    def __init__(
        self,
        case: CaseLike | None = None,
        *,
        set: Mapping[str, Any] | None = None,
        analysis: Sequence[Mapping[str, Any]] | None = None,
        friction: Mapping[str, Any] | None = None,
        operation: Mapping[str, Any] | None = None,
        oscillator: Mapping[str, Any] | None = None,
        sweep: Sequence[Mapping[str, Any]] | None = None,
        title: str | None = None,
    ) -> None: ...
    def motion(
        self,
        *,
        start: Mapping[str, Any] | None = None,
        duration: float | str | None = None,
        transient: float | str | None = None,
        points: int | None = None,
        tolerance: float | None = None,
        steps: int | None = None,
        sound: bool | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The history of one motion: stick, slip, lift-off, its averages, its energy."""
    def limit_cycle(
        self,
        *,
        start: Mapping[str, Any] | None = None,
        duration: float | str | None = None,
        tolerance: float | None = None,
        steps: int | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The cycle that a motion settles to, with its Floquet multipliers."""
    def bifurcation(
        self,
        *,
        sweep: Mapping[str, Any],
        direction: Literal["both", "forward", "backward"] | None = None,
        start: Mapping[str, Any] | None = None,
        duration: float | str | None = None,
        transient: float | str | None = None,
        tolerance: float | None = None,
        steps: int | None = None,
        branches: bool | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """What the motion settles to along one key, each motion from the end of the one before."""
    def basin(
        self,
        *,
        within: Mapping[str, Any],
        samples: int | None = None,
        seed: int | None = None,
        duration: float | str | None = None,
        tolerance: float | None = None,
        steps: int | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The share of starts, drawn evenly, from which steady sliding is reached."""

class TwoDegrees(Model):
    """Two degrees of freedom with given matrices."""

    def __init__(
        self,
        case: CaseLike | None = None,
        *,
        set: Mapping[str, Any] | None = None,
        analysis: Sequence[Mapping[str, Any]] | None = None,
        matrices: Mapping[str, Any] | None = None,
        parameters: Mapping[str, float] | None = None,
        sweep: Sequence[Mapping[str, Any]] | None = None,
        title: str | None = None,
    ) -> None: ...
    def spectrum(
        self,
        *,
        sweep: Mapping[str, Any],
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The eigenvalues along one parameter."""
    def stability_map(
        self,
        *,
        x: Mapping[str, Any],
        y: Mapping[str, Any],
        method: Literal["adaptive", "every-point"] | None = None,
        boundaries: bool | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Stable and unstable points over two parameters."""
    def critical(
        self,
        *,
        sweep: Mapping[str, Any],
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The values of a parameter at which stability changes."""

class Structure(Model):
    """One linear structure alone."""

    def __init__(
        self,
        case: CaseLike | None = None,
        *,
        set: Mapping[str, Any] | None = None,
        analysis: Sequence[Mapping[str, Any]] | None = None,
        damping: Mapping[str, Any] | None = None,
        matrices: Mapping[str, Any] | None = None,
        parameters: Mapping[str, float] | None = None,
        reduction: Mapping[str, Any] | None = None,
        structure: Mapping[str, Any] | None = None,
        sweep: Sequence[Mapping[str, Any]] | None = None,
        title: str | None = None,
    ) -> None: ...
    def modes(
        self,
        *,
        count: int | None = None,
        band: Sequence[str] | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Undamped modes: frequencies, shapes, residuals, and a count that shows whether one is missing."""
    def reduction(
        self,
        *,
        count: int | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Frequencies of the reduced structure against those of the full one, and the limit that the reduction tells of itself."""
    def eigen(
        self,
        *,
        region: Mapping[str, Any],
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """All complex modes in a region of the plane of growth rate and frequency, each with its error."""
    def eigen_sweep(
        self,
        *,
        sweep: Mapping[str, Any],
        family: Mapping[str, Any] | None = None,
        region: Mapping[str, Any],
        method: Literal["full", "projected"] | None = None,
        tolerance: float | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Complex modes along a parameter, followed through where they meet."""
    def receptance(
        self,
        *,
        excited: Mapping[str, Any],
        observed: Mapping[str, Any],
        band: Sequence[str],
        points: int | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The displacement of one point by a unit force at another, over frequency."""

class Sliding(Model):
    """One structure slides along another."""

    def __init__(
        self,
        case: CaseLike | None = None,
        *,
        set: Mapping[str, Any] | None = None,
        analysis: Sequence[Mapping[str, Any]] | None = None,
        contact: Mapping[str, Any] | None = None,
        motion: Mapping[str, Any] | None = None,
        observe: Mapping[str, Any] | None = None,
        parameters: Mapping[str, float] | None = None,
        structure: Sequence[Mapping[str, Any]] | None = None,
        sweep: Sequence[Mapping[str, Any]] | None = None,
        title: str | None = None,
    ) -> None: ...
    def modes(
        self,
        *,
        structure: str,
        count: int | None = None,
        band: Sequence[str] | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Undamped modes of one of the two structures, as it is held, without contact."""
    def locus(
        self,
        *,
        configuration: Literal["undeformed", "deformed"] | None = None,
        damping: bool | None = None,
        count: int | None = None,
        positions: Mapping[str, Any] | None = None,
        at: str | None = None,
        sweep: Mapping[str, Any] | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Complex eigenvalues against the position of the contact, or against any key, with located unstable zones."""
    def march(
        self,
        *,
        method: Literal["subs", "ensubs", "film", "residual-flexibility"],
        step: str | None = None,
        from_: str | None = None,
        to: str | None = None,
        signals: Mapping[str, Any] | None = None,
        signal: str | None = None,
        cut_off: str | None = None,
        slope: Literal["none", "static"] | None = None,
        predictor: Literal["printed", "with-force"] | None = None,
        sound: bool | Sequence[str] | None = None,
        checkpoint_steps: int | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The motion along the path by explicit time integration: signals, bursts, contact forces."""
    def growth(
        self,
        *,
        method: Literal["subs", "ensubs", "film", "residual-flexibility"],
        position: str,
        frequency: str,
        step: str | None = None,
        cut_off: str | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The growth of one mode in a march with the contact held, against the eigenvalue there."""
    def spectrogram(
        self,
        *,
        of: str,
        window: Literal["hann", "hamming", "blackman", "rectangular"] | None = None,
        length: str | None = None,
        overlap: float | None = None,
        reference: str | None = None,
        range: Sequence[float] | None = None,
        waterfall: int | None = None,
        signal: str | None = None,
        locus: str | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """A signal of a march over time, position and frequency, with the unstable zones of a locus."""

class Assembly(Model):
    """Bodies that touch at many points."""

    def __init__(
        self,
        case: CaseLike | None = None,
        *,
        set: Mapping[str, Any] | None = None,
        analysis: Sequence[Mapping[str, Any]] | None = None,
        contact: Sequence[Mapping[str, Any]] | None = None,
        load: Sequence[Mapping[str, Any]] | None = None,
        observe: Mapping[str, Any] | None = None,
        parameters: Mapping[str, float] | None = None,
        spring: Sequence[Mapping[str, Any]] | None = None,
        structure: Sequence[Mapping[str, Any]] | None = None,
        substrate: Mapping[str, Any] | None = None,
        sweep: Sequence[Mapping[str, Any]] | None = None,
        tie: Sequence[Mapping[str, Any]] | None = None,
        title: str | None = None,
    ) -> None: ...
    def steady_sliding(
        self,
        *,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Steady sliding: forces, gaps, pressure, which contact points are closed."""
    def eigen(
        self,
        *,
        count: int | None = None,
        band: Sequence[str] | None = None,
        region: Mapping[str, Any] | None = None,
        damping: bool | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Complex modes about steady sliding, each with its error, and what makes it grow."""
    def eigen_sweep(
        self,
        *,
        sweep: Mapping[str, Any],
        band: Sequence[str] | None = None,
        region: Mapping[str, Any] | None = None,
        damping: bool | None = None,
        method: Literal["full", "projected"] | None = None,
        tolerance: float | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Complex modes about steady sliding along any key, and where they begin to grow."""
    def stability_map(
        self,
        *,
        x: Mapping[str, Any],
        y: Mapping[str, Any],
        band: Sequence[str] | None = None,
        region: Mapping[str, Any] | None = None,
        damping: bool | None = None,
        boundaries: bool | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Where steady sliding is stable over two keys, and what feeds the fastest growing mode."""
    def growth(
        self,
        *,
        frequency: str,
        method: Literal["moreau", "film", "ensubs", "smoothed"] | None = None,
        step: str,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The growth of one mode in a march that is started in it, against its eigenvalue."""
    def march(
        self,
        *,
        method: Literal["moreau", "film", "ensubs", "smoothed"] | None = None,
        step: str,
        duration: str,
        transient: str | None = None,
        start: Mapping[str, Any] | None = None,
        restitution: float | None = None,
        implicitness: float | None = None,
        cut_off: str | None = None,
        modes: int | None = None,
        course: Mapping[str, Any] | None = None,
        temperature: Mapping[str, Any] | None = None,
        friction_over_temperature: Mapping[str, Any] | None = None,
        base: Sequence[Mapping[str, Any]] | None = None,
        forces: Sequence[Mapping[str, Any]] | None = None,
        sample_rate: str | None = None,
        checkpoint_steps: int | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The motion through stick, slip and lift-off at every contact point, with its balance of energy."""
    def spectrogram(
        self,
        *,
        of: str,
        window: Literal["hann", "hamming", "blackman", "rectangular"] | None = None,
        length: str | None = None,
        overlap: float | None = None,
        reference: str | None = None,
        range: Sequence[float] | None = None,
        waterfall: int | None = None,
        signal: str | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """A signal of a march over time and frequency."""
    def limit_cycle(
        self,
        *,
        frequency: str | None = None,
        modes: int | None = None,
        start: Mapping[str, Any] | None = None,
        method: Literal["harmonic-balance", "shooting"] | None = None,
        steps: int | None = None,
        harmonics: int | None = None,
        left_out: float | None = None,
        samples: int | None = None,
        largest_amplitude: float | None = None,
        stability: bool | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The periodic motion through stick, slip and lift-off that a mode grows to, without a march."""
    def squeal(
        self,
        *,
        band: Sequence[str],
        harmonics: int | None = None,
        left_out: float | None = None,
        samples: int | None = None,
        largest_amplitude: float | None = None,
        stability: bool | None = None,
        margin: bool | Mapping[str, Any] | None = None,
        margin_harmonics: int | None = None,
        knocks: Mapping[str, Any] | None = None,
        cures: bool | Sequence[str] | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The limit cycle of every mode of a band that grows, ranked by loudness and by growth rate."""
    def bifurcation(
        self,
        *,
        sweep: Mapping[str, Any],
        frequency: str | None = None,
        modes: int | None = None,
        start: Mapping[str, Any] | None = None,
        harmonics: int | None = None,
        samples: int | None = None,
        cycles: int | None = None,
        stability: bool | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Limit cycles of a mode along any key, stable or not, through folds to where they shrink to steady sliding."""
    def frequency_response(
        self,
        *,
        frequency: Sequence[str],
        forces: Sequence[Mapping[str, Any]] | None = None,
        base: Sequence[Mapping[str, Any]] | None = None,
        harmonics: int | None = None,
        samples: int | None = None,
        points: int | None = None,
        longest_step: str | None = None,
        stability: bool | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Periodic motions through stick, slip and lift-off under forces that swing, over their frequency and through its folds."""
