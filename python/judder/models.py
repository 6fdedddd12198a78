"""The models, a class each, and in it a method for every kind of analysis: all that a case file can say, as keyword arguments.

The tests write it from the declarations by which case files are read: ``JUDDER_GOLDEN=write cargo nextest run -p judder-cli -E 'test(/golden/)'``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Literal

from judder._model import Model, Result
from judder.progress import Progress
from judder.study import CaseLike

__all__ = [
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
    """The oscillator of the oscillator paper.

    Args:
        case: what the case begins with: a path, the text of a case, its tables as a mapping; nothing where left out.
        set: changed keys by their dotted paths, as of :func:`judder.check`.
        analysis: a list of tables
        contact: the forces of the contact
            - ``friction_load``: the force that μ_visc multiplies; ``"normal-load"`` where left out
            - ``law``: contact law; ``"oscillator-paper"`` where left out
              - ``accuracy``: ε: its relative accuracy; ``0.01`` where left out
              - ``computed``: the law ``bem``
              - ``file``: a law that was computed earlier; a path relative to the case file
            - ``shear_strength``: τ0: interfacial shear strength; such as ``"1 MPa"``; ``0.01`` where left out
        indenter: what slides
            - ``radius``: R: radius of the indenter; such as ``"10 mm"``; ``"10 mm"`` where left out
        operation: speed and load
            - ``normal_load``: F_n: normal load; such as ``"0.2 N"``; ``1e-6`` where left out
            - ``velocity``: v_d: driving speed; such as ``"30 mm/s"``; ``0.0001`` where left out
        oscillator: what carries the indenter
            - ``coupling``: η: coupling frequency ratio, ω_nxy/ω_nx; η² is k_xy/k_x; ``1.0`` where left out
            - ``coupling_angle``: α: inclination of the oblique spring; such as ``"45 deg"``; ``"45 deg"`` where left out
            - ``damping_x``: ξ_x: damping ratio along the sliding direction; ``0.01`` where left out
            - ``damping_y``: ξ_y: damping ratio normal to the surface; ``0.01`` where left out
            - ``frequency_ratio``: Ω: normal over tangential natural frequency, ω_ny/ω_nx; ``1.0`` where left out
            - ``natural_frequency``: ω_nx: tangential natural frequency; 1 Hz is 2π rad/s; such as ``"40 rad/s"`` or ``"7 kHz"``; ``"40
              rad/s"`` where left out
            - ``stiffness_x``: k_x: tangential stiffness; such as ``"50 N/m"``; ``"50 N/m"`` where left out
        substrate: what the indenter slides on
            - ``continuous``: a continuous spectrum, taken apart into retardation times
              - ``accuracy``: ε: relative error of E(ω) that the terms may make at any frequency, in place of their number; ``0.001`` where
                left out
              - ``log_normal``: τ𝒞 is a Gaussian in log₁₀ τ, scaled to both moduli
                - ``median``: τ_m: median of the retardation times; such as ``"10 ms"``; must be given
                - ``width``: w: standard deviation in decades of time; must be given
              - ``power_law``: 𝒞 ∝ τ^(m − 1) between two times, scaled to both moduli
                - ``exponent``: m: exponent of the compliance, which grows as t^m; at 0 the spectrum is even in ln τ; must be given
                - ``from``: τ_1: shortest retardation time; such as ``"10 ms"``; must be given
                - ``to``: τ_2: longest retardation time; such as ``"10 ms"``; must be given
              - ``samples``: samples, ascending; between them τ𝒞 is linear in ln τ. The glassy modulus follows
                - ``density``: 𝒞: spectrum at this time; such as ``"1e-5 1/Pa/s"``; must be given
                - ``time``: τ: retardation time of a sample; such as ``"10 ms"``; must be given
              - ``terms``: how many retardation times stand for it
            - ``dma``: a series fitted to measured moduli
              - ``file``: CSV of frequency, storage and loss modulus; a path relative to the case file; must be given
              - ``terms``: number of terms of the fitted series; ``"auto"`` where left out
            - ``glassy_modulus``: E∞: modulus of the substrate under fast loading, above the rubbery modulus; such as ``"1 MPa"``; ``"10
              MPa"`` where left out
            - ``poisson_ratio``: ν: the Poisson ratio of the substrate; ``0.5`` where left out
            - ``prony``: terms of the creep compliance: 1/E∞ = 1/E0 − Σ compliance
              - ``compliance``: C_k: creep compliance of a term; such as ``"1e-7 1/Pa"``; must be given
              - ``time``: τ_k: retardation (creep) time of a term; such as ``"10 ms"``; must be given
            - ``relaxation``: terms of the relaxation modulus: E∞ = E0 + Σ modulus
              - ``modulus``: E_j: modulus of a term; such as ``"1 MPa"``; must be given
              - ``time``: ρ_j: relaxation time of a term; such as ``"10 ms"``; must be given
            - ``relaxation_time``: τ_r: relaxation time of the substrate, τ E0/E∞; in place of retardation_time; such as ``"10 ms"``
            - ``retardation_time``: τ: creep time of the substrate, the paper's τ; such as ``"10 ms"``; ``"10 ms"`` where left out
            - ``rubbery_modulus``: E0: modulus of the substrate under slow loading; such as ``"1 MPa"``; ``"1 MPa"`` where left out
            - ``shift``: the rule by which temperature moves all times
              - ``arrhenius``: the shift of Arrhenius: ln a_T = E_a/R_gas (1/T − 1/T_ref)
                - ``activation_energy``: E_a: activation energy of the Arrhenius shift; such as ``"80 kJ/mol"``; must be given
                - ``reference_temperature``: T_ref: temperature at which the times are as given; such as ``"25 degC"`` or ``"298 K"``; must
                  be given
              - ``wlf``: the shift of Williams, Landel and Ferry: log₁₀ a_T = −C1 (T − T_ref)/(C2 + T − T_ref)
                - ``c1``: C1: first constant of the WLF shift; must be given
                - ``c2``: C2: second constant of the WLF shift, a difference of temperatures in K; such as ``"51.6 K"``; must be given
                - ``reference_temperature``: T_ref: temperature at which the times are as given; such as ``"25 degC"`` or ``"298 K"``; must
                  be given
            - ``temperature``: T: temperature of the substrate; needs ``shift``; such as ``"25 degC"`` or ``"298 K"``
        sweep: the whole case at many points
            - ``chunk``: points of a unit of work; chosen by the program where left out
            - ``method``: how points are chosen; ``"grid"`` where left out
            - ``name``: under which results are kept; no analysis and no other sweep has it; must be given
            - ``over``: the swept keys, see below; must be given
              - ``from``: first value
              - ``key``: dotted path of any number of the case; an item of a list goes by its name; must be given
              - ``points``: how many values, both ends included
              - ``scale``: spacing of the values; ``"linear"`` where left out
              - ``to``: last value
              - ``values``: in place of a range
            - ``points``: of ``latin-hypercube`` and ``sobol``: how many points; with sensitivity how many rows of k + 2 points for k keys.
              A power of two fills the ranges most evenly with ``sobol``
            - ``quantities``: what is kept of every point, see below: a quantity of the operating point, or ANALYSIS.PATH into the results
              of an analysis; must be given
            - ``seed``: of these two: which of all such points; the same seed gives the same points; ``1`` where left out
            - ``sensitivity``: of ``latin-hypercube`` and ``sobol``: first-order and total Sobol' indices of every quantity, with bootstrap
              intervals
              - ``confidence``: confidence of the intervals; ``0.95`` where left out
              - ``resamples``: bootstrap resamples from which they are taken; ``1000`` where left out
        title: the title; ``""`` where left out
    """

    _name = "oscillator"

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
    ) -> None:
        keys: dict[str, Any] = {
            "analysis": analysis,
            "contact": contact,
            "indenter": indenter,
            "operation": operation,
            "oscillator": oscillator,
            "substrate": substrate,
            "sweep": sweep,
            "title": title,
        }
        super().__init__(case, set, keys)

    def equivalent_damping(
        self,
        *,
        sweep: Mapping[str, Any],
        family: Mapping[str, Any] | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The equivalent damping ratio along one key.

        Args:
            sweep: one key over a range; a table ``{ key, from, to, points, scale }``; must be given
                - ``key``: dotted path of the key; the dotted path of a number of the case; must be given
                - ``from``: first value; a number, or a quantity with the key's unit; must be given
                - ``to``: last value; a number, or a quantity with the key's unit; must be given
                - ``points``: number of points, both ends included; an integer from 2 to 134217728; must be given
                - ``scale``: spacing of the points; ``"linear"`` (equal steps), ``"log"`` (equal ratios); ``"linear"`` where left out
            family: one curve for each value of another key; a table ``{ key, values }``
                - ``key``: dotted path of the key; the dotted path of a number of the case; must be given
                - ``values``: its values; a list, each a number, or a quantity with the key's unit; must be given
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "sweep": sweep,
            "family": family,
        }
        return self._computed("equivalent-damping", keys, threads, progress)

    def spectrum(
        self,
        *,
        sweep: Mapping[str, Any],
        family: Mapping[str, Any] | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The eigenvalues along one key.

        Args:
            sweep: one key over a range; a table ``{ key, from, to, points, scale }``; must be given
                - ``key``: dotted path of the key; the dotted path of a number of the case; must be given
                - ``from``: first value; a number, or a quantity with the key's unit; must be given
                - ``to``: last value; a number, or a quantity with the key's unit; must be given
                - ``points``: number of points, both ends included; an integer from 2 to 134217728; must be given
                - ``scale``: spacing of the points; ``"linear"`` (equal steps), ``"log"`` (equal ratios); ``"linear"`` where left out
            family: one curve for each value of another key; a table ``{ key, values }``
                - ``key``: dotted path of the key; the dotted path of a number of the case; must be given
                - ``values``: its values; a list, each a number, or a quantity with the key's unit; must be given
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "sweep": sweep,
            "family": family,
        }
        return self._computed("spectrum", keys, threads, progress)

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
        """The critical shear strengths along one key.

        Args:
            sweep: one key over a range; a table ``{ key, from, to, points, scale }``; must be given
                - ``key``: dotted path of the key; the dotted path of a number of the case; must be given
                - ``from``: first value; a number, or a quantity with the key's unit; must be given
                - ``to``: last value; a number, or a quantity with the key's unit; must be given
                - ``points``: number of points, both ends included; an integer from 2 to 134217728; must be given
                - ``scale``: spacing of the points; ``"linear"`` (equal steps), ``"log"`` (equal ratios); ``"linear"`` where left out
            within: where roots are sought; a table ``{ from, to }``; ``{ from = 1e-6, to = 1000.0 }`` where left out
                - ``from``: lower end; a plain number (τ0/E0*) or a stress such as 1 MPa, > 0; must be given
                - ``to``: upper end; a plain number (τ0/E0*) or a stress such as 1 MPa, > 0; must be given
            family: one curve for each value of another key; a table ``{ key, values }``
                - ``key``: dotted path of the key; the dotted path of a number of the case; must be given
                - ``values``: its values; a list, each a number, or a quantity with the key's unit; must be given
            global_margin: follow the cycles beside every subcritical threshold back to [their fold](theory/motion.md#the-global-margin),
                and seek motions beyond: some seconds a threshold; ``true`` or ``false``; ``true`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "sweep": sweep,
            "within": within,
            "family": family,
            "global_margin": global_margin,
        }
        return self._computed("critical-shear-strength", keys, threads, progress)

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
        """The critical loads along one key.

        Args:
            sweep: one key over a range; a table ``{ key, from, to, points, scale }``; must be given
                - ``key``: dotted path of the key; the dotted path of a number of the case; must be given
                - ``from``: first value; a number, or a quantity with the key's unit; must be given
                - ``to``: last value; a number, or a quantity with the key's unit; must be given
                - ``points``: number of points, both ends included; an integer from 2 to 134217728; must be given
                - ``scale``: spacing of the points; ``"linear"`` (equal steps), ``"log"`` (equal ratios); ``"linear"`` where left out
            within: where roots are sought; a table ``{ from, to }``; ``{ from = 1e-10, to = 1.0 }`` where left out
                - ``from``: lower end; a plain number (F_n/(E0* R²)) or a force such as 0.2 N, > 0; must be given
                - ``to``: upper end; a plain number (F_n/(E0* R²)) or a force such as 0.2 N, > 0; must be given
            family: one curve for each value of another key; a table ``{ key, values }``
                - ``key``: dotted path of the key; the dotted path of a number of the case; must be given
                - ``values``: its values; a list, each a number, or a quantity with the key's unit; must be given
            global_margin: follow the cycles beside every subcritical threshold back to [their fold](theory/motion.md#the-global-margin),
                and seek motions beyond: some seconds a threshold; ``true`` or ``false``; ``true`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "sweep": sweep,
            "within": within,
            "family": family,
            "global_margin": global_margin,
        }
        return self._computed("critical-load", keys, threads, progress)

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
        """Stable and unstable points over two keys.

        Args:
            x: the key along the abscissa, over a range; a table ``{ key, from, to, points, scale }``; must be given
                - ``key``: dotted path of the key; the dotted path of a number of the case; must be given
                - ``from``: first value; a number, or a quantity with the key's unit; must be given
                - ``to``: last value; a number, or a quantity with the key's unit; must be given
                - ``points``: number of points, both ends included; an integer from 2 to 134217728; must be given
                - ``scale``: spacing of the points; ``"linear"`` (equal steps), ``"log"`` (equal ratios); ``"linear"`` where left out
            y: the key along the ordinate, over a range; a table ``{ key, from, to, points, scale }``; must be given
                - ``key``: dotted path of the key; the dotted path of a number of the case; must be given
                - ``from``: first value; a number, or a quantity with the key's unit; must be given
                - ``to``: last value; a number, or a quantity with the key's unit; must be given
                - ``points``: number of points, both ends included; an integer from 2 to 134217728; must be given
                - ``scale``: spacing of the points; ``"linear"`` (equal steps), ``"log"`` (equal ratios); ``"linear"`` where left out
            method: how the points are decided; ``"adaptive"`` (cells are refined only where a boundary crosses), ``"every-point"`` (every
                point is decided); ``"adaptive"`` where left out
            boundaries: trace the boundary curves as well; ``true`` or ``false``; ``true`` where left out
            global_margin: tell the points at which a knock may start a motion apart from those at which none is known to: up to a minute;
                ``true`` or ``false``; ``false`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "x": x,
            "y": y,
            "method": method,
            "boundaries": boundaries,
            "global_margin": global_margin,
        }
        return self._computed("stability-map", keys, threads, progress)

    def motion(
        self,
        *,
        start: Mapping[str, Any] | None = None,
        duration: float | str | None = None,
        transient: float | str | None = None,
        points: int | None = None,
        tolerance: float | None = None,
        steps: int | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The history of one motion: stick, slip, lift-off, its averages, its energy.

        Args:
            start: where the motion starts; a table ``{ disturbance, x, y, velocity_x, velocity_y }``; ``{ disturbance = 0.2 }`` where left
                out
                - ``disturbance``: steady sliding with x moved by this share of its magnitude, or of the scale of a motion where steady
                  sliding has no x; a number, any
                - ``x``: displacement, in units of x0 = F_n/k_x for the oscillator; a number, any
                - ``y``: normal displacement, in units of x0; in the air where it is not above zero; a number, any
                - ``velocity_x``: velocity along x, in these units and those of ω_nx; a number, any
                - ``velocity_y``: velocity along y; a number, any
            duration: t: time that the motion is followed; a plain number (ω_nx t) or a time such as 10 ms, > 0; ``2000.0`` where left out
            transient: t: first part of the duration, which averages leave out; half of it by default; a plain number (ω_nx t) or a time
                such as 10 ms, ≥ 0; ``1000.0`` where left out
            points: points of the uniform grid of time that is kept; an integer from 16 to 4194304; ``4096`` where left out
            tolerance: ε: local error of a step, relative to the magnitudes of steady sliding; a number, > 0.00000000000001, ≤ 0.01;
                ``1e-8`` where left out
            steps: the most steps of one motion; an integer from 1 to 1000000000000; ``10000000`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "start": start,
            "duration": duration,
            "transient": transient,
            "points": points,
            "tolerance": tolerance,
            "steps": steps,
        }
        return self._computed("motion", keys, threads, progress)

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
        """The cycle that a motion settles to, with its Floquet multipliers.

        Args:
            start: where the motion starts; a table ``{ disturbance, x, y, velocity_x, velocity_y }``; ``{ disturbance = 0.2 }`` where left
                out
                - ``disturbance``: steady sliding with x moved by this share of its magnitude, or of the scale of a motion where steady
                  sliding has no x; a number, any
                - ``x``: displacement, in units of x0 = F_n/k_x for the oscillator; a number, any
                - ``y``: normal displacement, in units of x0; in the air where it is not above zero; a number, any
                - ``velocity_x``: velocity along x, in these units and those of ω_nx; a number, any
                - ``velocity_y``: velocity along y; a number, any
            duration: t: time within which the motion settles; a plain number (ω_nx t) or a time such as 10 ms, > 0; ``20000.0`` where left
                out
            tolerance: ε: local error of a step, relative to the magnitudes of steady sliding; a number, > 0.00000000000001, ≤ 0.01;
                ``1e-10`` where left out
            steps: the most steps of one motion; an integer from 1 to 1000000000000; ``10000000`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "start": start,
            "duration": duration,
            "tolerance": tolerance,
            "steps": steps,
        }
        return self._computed("limit-cycle", keys, threads, progress)

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
        """What the motion settles to along one key, each motion from the end of the one before.

        Args:
            sweep: one key over a range; a table ``{ key, from, to, points, scale }``; must be given
                - ``key``: dotted path of the key; the dotted path of a number of the case; must be given
                - ``from``: first value; a number, or a quantity with the key's unit; must be given
                - ``to``: last value; a number, or a quantity with the key's unit; must be given
                - ``points``: number of points, both ends included; an integer from 2 to 134217728; must be given
                - ``scale``: spacing of the points; ``"linear"`` (equal steps), ``"log"`` (equal ratios); ``"linear"`` where left out
            direction: which way the key is followed; ``"both"`` (both ways), ``"forward"`` (from the first value to the last),
                ``"backward"`` (from the last value to the first); ``"both"`` where left out
            start: where the motion at the first value starts; a table ``{ disturbance, x, y, velocity_x, velocity_y }``; ``{ disturbance =
                0.2 }`` where left out
                - ``disturbance``: steady sliding with x moved by this share of its magnitude, or of the scale of a motion where steady
                  sliding has no x; a number, any
                - ``x``: displacement, in units of x0 = F_n/k_x for the oscillator; a number, any
                - ``y``: normal displacement, in units of x0; in the air where it is not above zero; a number, any
                - ``velocity_x``: velocity along x, in these units and those of ω_nx; a number, any
                - ``velocity_y``: velocity along y; a number, any
            duration: t: time within which each motion settles; a plain number (ω_nx t) or a time such as 10 ms, > 0; ``5000.0`` where left
                out
            transient: t: first part of the duration, which the averages of an irregular motion leave out; half of it by default; a plain
                number (ω_nx t) or a time such as 10 ms, ≥ 0; ``2500.0`` where left out
            tolerance: ε: local error of a step, relative to the magnitudes of steady sliding; a number, > 0.00000000000001, ≤ 0.01;
                ``1e-6`` where left out
            steps: the most steps of one motion; an integer from 1 to 1000000000000; ``10000000`` where left out
            branches: follow the [branches of cycles](theory/motion.md#branches-through-a-diagram), stable and unstable, through the
                diagram: a cascade of cycles that stick and lift off takes minutes; ``true`` or ``false``; ``false`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "sweep": sweep,
            "direction": direction,
            "start": start,
            "duration": duration,
            "transient": transient,
            "tolerance": tolerance,
            "steps": steps,
            "branches": branches,
        }
        return self._computed("bifurcation", keys, threads, progress)

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
        """The share of starts, drawn evenly, from which steady sliding is reached.

        Args:
            within: the ranges from which starts are drawn, evenly and independently; a table ``{ x, y, velocity_x, velocity_y }``; must be
                given
                - ``x``: of the displacement; a list of 2, each a number, any
                - ``y``: of the normal displacement; a list of 2, each a number, any
                - ``velocity_x``: of the velocity along x; a list of 2, each a number, any
                - ``velocity_y``: of the velocity along y; a list of 2, each a number, any
            samples: number of starts; an integer from 1 to 10000000; ``1000`` where left out
            seed: which starts are drawn; the n-th depends on the seed and on n alone; an integer from 0 to 9007199254740991; ``1`` where
                left out
            duration: t: time within which each motion settles; a plain number (ω_nx t) or a time such as 10 ms, > 0; ``20000.0`` where left
                out
            tolerance: ε: local error of a step, relative to the magnitudes of steady sliding; a number, > 0.00000000000001, ≤ 0.01;
                ``1e-6`` where left out
            steps: the most steps of one motion; an integer from 1 to 1000000000000; ``10000000`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "within": within,
            "samples": samples,
            "seed": seed,
            "duration": duration,
            "tolerance": tolerance,
            "steps": steps,
        }
        return self._computed("basin", keys, threads, progress)

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
        """The cycle that a motion settles to, by events, by time-stepping and with a smoothed sign.

        Args:
            start: where the motion that settles to the cycle starts; a table ``{ disturbance, x, y, velocity_x, velocity_y }``; ``{
                disturbance = 0.2 }`` where left out
                - ``disturbance``: steady sliding with x moved by this share of its magnitude, or of the scale of a motion where steady
                  sliding has no x; a number, any
                - ``x``: displacement, in units of x0 = F_n/k_x for the oscillator; a number, any
                - ``y``: normal displacement, in units of x0; in the air where it is not above zero; a number, any
                - ``velocity_x``: velocity along x, in these units and those of ω_nx; a number, any
                - ``velocity_y``: velocity along y; a number, any
            time_step: h: steps of the time-stepping, with equal ratios between them; a table ``{ from, to, points }``; ``{ from = 0.0003,
                to = 0.1, points = 11 }`` where left out
                - ``from``: the lower end; a plain number (ω_nx t) or a time such as 10 ms, > 0; must be given
                - ``to``: the upper end; a plain number (ω_nx t) or a time such as 10 ms, > 0; must be given
                - ``points``: how many points, both ends included; an integer from 2 to 200; ``11`` where left out
            width: ε/v_d: widths of the smoothed sign tanh(v_rel/ε), over v_d; a table ``{ from, to, points }``; ``{ from = 0.0001, to =
                1.0, points = 13 }`` where left out
                - ``from``: the lower end; a plain number (ε/v_d), > 0; must be given
                - ``to``: the upper end; a plain number (ε/v_d), > 0; must be given
                - ``points``: how many points, both ends included; an integer from 2 to 200; ``13`` where left out
            duration: t: time within which the motion settles; a plain number (ω_nx t) or a time such as 10 ms, > 0; ``20000.0`` where left
                out
            tolerance: ε: local error of a step, relative to the magnitudes of steady sliding; a number, > 0.00000000000001, ≤ 0.01;
                ``1e-10`` where left out
            steps: the most steps of one motion; an integer from 1 to 1000000000000; ``10000000`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "start": start,
            "time_step": time_step,
            "width": width,
            "duration": duration,
            "tolerance": tolerance,
            "steps": steps,
        }
        return self._computed("engines", keys, threads, progress)


class Contact(Model):
    """A rigid indenter that slides on a viscoelastic substrate.

    Args:
        case: what the case begins with: a path, the text of a case, its tables as a mapping; nothing where left out.
        set: changed keys by their dotted paths, as of :func:`judder.check`.
        analysis: a list of tables
        indenter: the rigid body that slides
            - ``radius``: R: radius of the indenter; such as ``"10 mm"``; ``"10 mm"`` where left out
            - ``shape``: the shape of the indenter; ``"paraboloid"`` where left out
              - ``heights``: the file: npy, a text matrix or NetCDF; a path relative to the case file; must be given
              - ``periodic``: whether the surface repeats itself at its edges; ``false`` where left out
              - ``spacing``: h: distance of neighbouring heights; may be left out where the file has coordinates; such as ``"10 mm"``
              - ``turned_over``: whether large heights point towards the substrate, as in a measured topography, so that its peaks touch
                first; ``false`` where left out
              - ``unit``: the length that a height of 1 in the file stands for; such as ``"10 mm"``; ``"1 m"`` where left out
              - ``variable``: the variable of a file that holds several
        memory_limit: what the largest grid of one contact may take; an analysis may say it for itself; such as ``"4 GiB"`` or ``"512
            MiB"``; ``"4 GiB"`` where left out
        substrate: the material that the indenter slides on
            - ``continuous``: a continuous spectrum, taken apart into retardation times
              - ``accuracy``: ε: relative error of E(ω) that the terms may make at any frequency, in place of their number; ``0.001`` where
                left out
              - ``log_normal``: τ𝒞 is a Gaussian in log₁₀ τ, scaled to both moduli
                - ``median``: τ_m: median of the retardation times; such as ``"10 ms"``; must be given
                - ``width``: w: standard deviation in decades of time; must be given
              - ``power_law``: 𝒞 ∝ τ^(m − 1) between two times, scaled to both moduli
                - ``exponent``: m: exponent of the compliance, which grows as t^m; at 0 the spectrum is even in ln τ; must be given
                - ``from``: τ_1: shortest retardation time; such as ``"10 ms"``; must be given
                - ``to``: τ_2: longest retardation time; such as ``"10 ms"``; must be given
              - ``samples``: samples, ascending; between them τ𝒞 is linear in ln τ. The glassy modulus follows
                - ``density``: 𝒞: spectrum at this time; such as ``"1e-5 1/Pa/s"``; must be given
                - ``time``: τ: retardation time of a sample; such as ``"10 ms"``; must be given
              - ``terms``: how many retardation times stand for it
            - ``dma``: a series fitted to measured moduli
              - ``file``: CSV of frequency, storage and loss modulus; a path relative to the case file; must be given
              - ``terms``: number of terms of the fitted series; ``"auto"`` where left out
            - ``glassy_modulus``: E∞: modulus of the substrate under fast loading, above the rubbery modulus; such as ``"1 MPa"``; ``"10
              MPa"`` where left out
            - ``poisson_ratio``: ν: the Poisson ratio of the substrate; ``0.5`` where left out
            - ``prony``: terms of the creep compliance: 1/E∞ = 1/E0 − Σ compliance
              - ``compliance``: C_k: creep compliance of a term; such as ``"1e-7 1/Pa"``; must be given
              - ``time``: τ_k: retardation (creep) time of a term; such as ``"10 ms"``; must be given
            - ``relaxation``: terms of the relaxation modulus: E∞ = E0 + Σ modulus
              - ``modulus``: E_j: modulus of a term; such as ``"1 MPa"``; must be given
              - ``time``: ρ_j: relaxation time of a term; such as ``"10 ms"``; must be given
            - ``relaxation_time``: τ_r: relaxation time of the substrate, τ E0/E∞; in place of retardation_time; such as ``"10 ms"``
            - ``retardation_time``: τ: creep time of the substrate, the paper's τ; such as ``"10 ms"``; ``"10 ms"`` where left out
            - ``rubbery_modulus``: E0: modulus of the substrate under slow loading; such as ``"1 MPa"``; ``"1 MPa"`` where left out
            - ``shift``: the rule by which temperature moves all times
              - ``arrhenius``: the shift of Arrhenius: ln a_T = E_a/R_gas (1/T − 1/T_ref)
                - ``activation_energy``: E_a: activation energy of the Arrhenius shift; such as ``"80 kJ/mol"``; must be given
                - ``reference_temperature``: T_ref: temperature at which the times are as given; such as ``"25 degC"`` or ``"298 K"``; must
                  be given
              - ``wlf``: the shift of Williams, Landel and Ferry: log₁₀ a_T = −C1 (T − T_ref)/(C2 + T − T_ref)
                - ``c1``: C1: first constant of the WLF shift; must be given
                - ``c2``: C2: second constant of the WLF shift, a difference of temperatures in K; such as ``"51.6 K"``; must be given
                - ``reference_temperature``: T_ref: temperature at which the times are as given; such as ``"25 degC"`` or ``"298 K"``; must
                  be given
            - ``temperature``: T: temperature of the substrate; needs ``shift``; such as ``"25 degC"`` or ``"298 K"``
        sweep: the whole case at many points
            - ``chunk``: points of a unit of work; chosen by the program where left out
            - ``method``: how points are chosen; ``"grid"`` where left out
            - ``name``: under which results are kept; no analysis and no other sweep has it; must be given
            - ``over``: the swept keys, see below; must be given
              - ``from``: first value
              - ``key``: dotted path of any number of the case; an item of a list goes by its name; must be given
              - ``points``: how many values, both ends included
              - ``scale``: spacing of the values; ``"linear"`` where left out
              - ``to``: last value
              - ``values``: in place of a range
            - ``points``: of ``latin-hypercube`` and ``sobol``: how many points; with sensitivity how many rows of k + 2 points for k keys.
              A power of two fills the ranges most evenly with ``sobol``
            - ``quantities``: what is kept of every point, see below: a quantity of the operating point, or ANALYSIS.PATH into the results
              of an analysis; must be given
            - ``seed``: of these two: which of all such points; the same seed gives the same points; ``1`` where left out
            - ``sensitivity``: of ``latin-hypercube`` and ``sobol``: first-order and total Sobol' indices of every quantity, with bootstrap
              intervals
              - ``confidence``: confidence of the intervals; ``0.95`` where left out
              - ``resamples``: bootstrap resamples from which they are taken; ``1000`` where left out
        title: the title; ``""`` where left out
    """

    _name = "contact"

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
    ) -> None:
        keys: dict[str, Any] = {
            "analysis": analysis,
            "indenter": indenter,
            "memory_limit": memory_limit,
            "substrate": substrate,
            "sweep": sweep,
            "title": title,
        }
        super().__init__(case, set, keys)

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
        """One contact: force, area, friction, fields.

        Args:
            velocity: v: sliding speed; 0 at rest; a plain number (v τ/R) or a speed such as 30 mm/s, ≥ 0; must be given
            indentation: δ: indentation; a plain number (δ/R) or a length such as 10 mm, > 0
            load: F: normal load, in place of the indentation; of a cylinder per length, F/(E0* R) or in N/m; a plain number (F/(E0* R²)) or
                a force such as 0.2 N, > 0
            accuracy: ε: relative accuracy of the force; area and friction may be five times as far off; a number, > 0, ≤ 0.2; ``0.001``
                where left out
            cells: cells along a side, an even number; chosen and refined from the accuracy where left out; an even number from 64 to 4096
            domain: L: side of the computed square; chosen from the accuracy where left out; a plain number (L/R) or a length such as 10 mm,
                > 0
            memory_limit: what the largest grid may take; as much as the case says where left out; an amount such as 4 GiB, in TiB, GiB,
                MiB, KiB, TB, GB, MB, kB
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "velocity": velocity,
            "indentation": indentation,
            "load": load,
            "accuracy": accuracy,
            "cells": cells,
            "domain": domain,
            "memory_limit": memory_limit,
        }
        return self._computed("contact", keys, threads, progress)

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
        """Force, area and friction over speed and indentation, as a law for an oscillator.

        Args:
            velocity: v: speeds; a table ``{ from, to, points }``; ``{ from = 1e-6, to = 10000.0, points = 51 }`` where left out
                - ``from``: the lower end; a plain number (v τ/R) or a speed such as 30 mm/s, > 0; must be given
                - ``to``: the upper end; a plain number (v τ/R) or a speed such as 30 mm/s, > 0; must be given
                - ``points``: how many points, both ends included; an integer from 2 to 2000; ``51`` where left out
            indentation: δ: indentations; a table ``{ from, to, points }``; ``{ from = 0.0001, to = 0.1, points = 16 }`` where left out
                - ``from``: the lower end; a plain number (δ/R) or a length such as 10 mm, > 0; must be given
                - ``to``: the upper end; a plain number (δ/R) or a length such as 10 mm, > 0; must be given
                - ``points``: how many points, both ends included; an integer from 2 to 2000; ``16`` where left out
            accuracy: ε: relative accuracy of the law; a number, > 0, ≤ 0.2; ``0.01`` where left out
            method: how the plane is covered; of another shape than a paraboloid ``sweep`` where left out; ``"collapse"`` (one curve over z
                = v τ/√(R δ) serves the whole plane: exact for a paraboloid), ``"sweep"`` (a table over speed and indentation, refined where
                it must be); ``"collapse"`` where left out
            memory_limit: what the largest grid of each of its contacts may take; as much as the case says where left out; an amount such as
                4 GiB, in TiB, GiB, MiB, KiB, TB, GB, MB, kB
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "velocity": velocity,
            "indentation": indentation,
            "accuracy": accuracy,
            "method": method,
            "memory_limit": memory_limit,
        }
        return self._computed("contact-law", keys, threads, progress)

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
        """The three functions of the oscillator paper, fitted to a computed law.

        Args:
            velocity: v: speeds; a table ``{ from, to, points }``; ``{ from = 1e-6, to = 10000.0, points = 51 }`` where left out
                - ``from``: the lower end; a plain number (v τ/R) or a speed such as 30 mm/s, > 0; must be given
                - ``to``: the upper end; a plain number (v τ/R) or a speed such as 30 mm/s, > 0; must be given
                - ``points``: how many points, both ends included; an integer from 2 to 2000; ``51`` where left out
            indentation: δ: indentations; a table ``{ from, to, points }``; ``{ from = 0.0001, to = 0.1, points = 16 }`` where left out
                - ``from``: the lower end; a plain number (δ/R) or a length such as 10 mm, > 0; must be given
                - ``to``: the upper end; a plain number (δ/R) or a length such as 10 mm, > 0; must be given
                - ``points``: how many points, both ends included; an integer from 2 to 2000; ``16`` where left out
            accuracy: ε: relative accuracy of the law; a number, > 0, ≤ 0.2; ``0.01`` where left out
            method: how the plane is covered; of another shape than a paraboloid ``sweep`` where left out; ``"collapse"`` (one curve over z
                = v τ/√(R δ) serves the whole plane: exact for a paraboloid), ``"sweep"`` (a table over speed and indentation, refined where
                it must be); ``"collapse"`` where left out
            velocity_scale: s: factor of v τ/R at which the fits are read; a number, > 0; ``0.01`` where left out
            memory_limit: what the largest grid of each of its contacts may take; as much as the case says where left out; an amount such as
                4 GiB, in TiB, GiB, MiB, KiB, TB, GB, MB, kB
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "velocity": velocity,
            "indentation": indentation,
            "accuracy": accuracy,
            "method": method,
            "velocity_scale": velocity_scale,
            "memory_limit": memory_limit,
        }
        return self._computed("fit", keys, threads, progress)

    def modulus(
        self,
        *,
        frequency: Mapping[str, Any] | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Storage and loss modulus and loss tangent over frequency.

        Args:
            frequency: ω: angular frequencies; chosen from the spectrum where left out; a table ``{ from, to, points }``
                - ``from``: the lower end; a plain number (ω τ) or an angular frequency such as 40 rad/s or 7 kHz, > 0; must be given
                - ``to``: the upper end; a plain number (ω τ) or an angular frequency such as 40 rad/s or 7 kHz, > 0; must be given
                - ``points``: how many points, both ends included; an integer from 2 to 2000; ``200`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "frequency": frequency,
        }
        return self._computed("modulus", keys, threads, progress)

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
        """A contact that is followed in time: histories of force, friction and area, work of a cycle.

        Args:
            motion: how the indenter moves along the surface; ``"start"`` (at time 0 suddenly at a speed), ``"reciprocation"`` (to and fro),
                ``"rest"`` (not at all); must be given
            velocity: v: sliding speed of a start; a plain number (v τ/R) or a speed such as 30 mm/s, ≥ 0
            amplitude: a: amplitude of the position of a reciprocation; a plain number (a/R) or a length such as 10 mm, > 0
            frequency: ω: angular frequency of a reciprocation; a plain number (ω τ) or an angular frequency such as 40 rad/s or 7 kHz, > 0
            indentation: δ: indentation, on average; a plain number (δ/R) or a length such as 10 mm, > 0
            load: F: normal load, in place of the indentation; a plain number (F/(E0* R²)) or a force such as 0.2 N, > 0
            oscillation: how the indentation oscillates about its mean, at rest or after a start; a table ``{ amplitude, frequency }``
                - ``amplitude``: a: amplitude; a plain number (a/R) or a length such as 10 mm, > 0; must be given
                - ``frequency``: ω: angular frequency; a plain number (ω τ) or an angular frequency such as 40 rad/s or 7 kHz, > 0; must be
                  given
            duration: t: how long the contact is followed; a plain number (t/τ) or a time such as 10 ms, > 0; must be given
            cells: cells a side of the window that moves with the indenter; an integer from 8 to 4096; ``64`` where left out
            memory_limit: what window and remembered strip may take; as much as the case says where left out; an amount such as 4 GiB, in
                TiB, GiB, MiB, KiB, TB, GB, MB, kB
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "motion": motion,
            "velocity": velocity,
            "amplitude": amplitude,
            "frequency": frequency,
            "indentation": indentation,
            "load": load,
            "oscillation": oscillation,
            "duration": duration,
            "cells": cells,
            "memory_limit": memory_limit,
        }
        return self._computed("transient", keys, threads, progress)


class Belt(Model):
    """One mass on a moving belt, friction that falls with speed.

    Args:
        case: what the case begins with: a path, the text of a case, its tables as a mapping; nothing where left out.
        set: changed keys by their dotted paths, as of :func:`judder.check`.
        analysis: a list of tables
        friction: friction between mass and belt
            - ``at_rest``: μ_0: friction coefficient at rest, the limit of stick; ``1.0`` where left out
            - ``at_speed``: μ_∞: friction coefficient at high speed; ``0.5`` where left out
            - ``decay_speed``: v_0: speed over which friction falls: μ_∞ + (μ_0 − μ_∞) e^(−|v|/v_0); ``0.5`` where left out
        operation: speed and force
            - ``normal_force``: N: normal force on the mass; ``1.0`` where left out
            - ``velocity``: v: speed of the belt; ``1.0`` where left out
        oscillator: the mass on its spring
            - ``damping``: ξ: damping ratio; ``0.05`` where left out
        sweep: the whole case at many points
            - ``chunk``: points of a unit of work; chosen by the program where left out
            - ``method``: how points are chosen; ``"grid"`` where left out
            - ``name``: under which results are kept; no analysis and no other sweep has it; must be given
            - ``over``: the swept keys, see below; must be given
              - ``from``: first value
              - ``key``: dotted path of any number of the case; an item of a list goes by its name; must be given
              - ``points``: how many values, both ends included
              - ``scale``: spacing of the values; ``"linear"`` where left out
              - ``to``: last value
              - ``values``: in place of a range
            - ``points``: of ``latin-hypercube`` and ``sobol``: how many points; with sensitivity how many rows of k + 2 points for k keys.
              A power of two fills the ranges most evenly with ``sobol``
            - ``quantities``: what is kept of every point, see below: a quantity of the operating point, or ANALYSIS.PATH into the results
              of an analysis; must be given
            - ``seed``: of these two: which of all such points; the same seed gives the same points; ``1`` where left out
            - ``sensitivity``: of ``latin-hypercube`` and ``sobol``: first-order and total Sobol' indices of every quantity, with bootstrap
              intervals
              - ``confidence``: confidence of the intervals; ``0.95`` where left out
              - ``resamples``: bootstrap resamples from which they are taken; ``1000`` where left out
        title: the title; ``""`` where left out
    """

    _name = "belt"

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
    ) -> None:
        keys: dict[str, Any] = {
            "analysis": analysis,
            "friction": friction,
            "operation": operation,
            "oscillator": oscillator,
            "sweep": sweep,
            "title": title,
        }
        super().__init__(case, set, keys)

    def motion(
        self,
        *,
        start: Mapping[str, Any] | None = None,
        duration: float | None = None,
        transient: float | None = None,
        points: int | None = None,
        tolerance: float | None = None,
        steps: int | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The history of one motion: stick, slip, lift-off, its averages, its energy.

        Args:
            start: where the motion starts; a table ``{ disturbance, x, velocity_x }``; ``{ disturbance = 0.2 }`` where left out
                - ``disturbance``: steady sliding with x moved by this share of its magnitude, or of the scale of a motion where steady
                  sliding has no x; a number, any
                - ``x``: displacement, in units of x0 = F_n/k_x for the oscillator; a number, any
                - ``velocity_x``: velocity along x, in these units and those of ω_nx; a number, any
            duration: t: time that the motion is followed; a plain number (t), > 0; ``2000.0`` where left out
            transient: t: first part of the duration, which averages leave out; half of it by default; a plain number (t), ≥ 0; ``1000.0``
                where left out
            points: points of the uniform grid of time that is kept; an integer from 16 to 4194304; ``4096`` where left out
            tolerance: ε: local error of a step, relative to the magnitudes of steady sliding; a number, > 0.00000000000001, ≤ 0.01;
                ``1e-8`` where left out
            steps: the most steps of one motion; an integer from 1 to 1000000000000; ``10000000`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "start": start,
            "duration": duration,
            "transient": transient,
            "points": points,
            "tolerance": tolerance,
            "steps": steps,
        }
        return self._computed("motion", keys, threads, progress)

    def limit_cycle(
        self,
        *,
        start: Mapping[str, Any] | None = None,
        duration: float | None = None,
        tolerance: float | None = None,
        steps: int | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The cycle that a motion settles to, with its Floquet multipliers.

        Args:
            start: where the motion starts; a table ``{ disturbance, x, velocity_x }``; ``{ disturbance = 0.2 }`` where left out
                - ``disturbance``: steady sliding with x moved by this share of its magnitude, or of the scale of a motion where steady
                  sliding has no x; a number, any
                - ``x``: displacement, in units of x0 = F_n/k_x for the oscillator; a number, any
                - ``velocity_x``: velocity along x, in these units and those of ω_nx; a number, any
            duration: t: time within which the motion settles; a plain number (t), > 0; ``20000.0`` where left out
            tolerance: ε: local error of a step, relative to the magnitudes of steady sliding; a number, > 0.00000000000001, ≤ 0.01;
                ``1e-10`` where left out
            steps: the most steps of one motion; an integer from 1 to 1000000000000; ``10000000`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "start": start,
            "duration": duration,
            "tolerance": tolerance,
            "steps": steps,
        }
        return self._computed("limit-cycle", keys, threads, progress)

    def bifurcation(
        self,
        *,
        sweep: Mapping[str, Any],
        direction: Literal["both", "forward", "backward"] | None = None,
        start: Mapping[str, Any] | None = None,
        duration: float | None = None,
        transient: float | None = None,
        tolerance: float | None = None,
        steps: int | None = None,
        branches: bool | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """What the motion settles to along one key, each motion from the end of the one before.

        Args:
            sweep: one key over a range; a table ``{ key, from, to, points, scale }``; must be given
                - ``key``: dotted path of the key; the dotted path of a number of the case; must be given
                - ``from``: first value; a number, any; must be given
                - ``to``: last value; a number, any; must be given
                - ``points``: number of points, both ends included; an integer from 2 to 134217728; must be given
                - ``scale``: spacing of the points; ``"linear"`` (equal steps), ``"log"`` (equal ratios); ``"linear"`` where left out
            direction: which way the key is followed; ``"both"`` (both ways), ``"forward"`` (from the first value to the last),
                ``"backward"`` (from the last value to the first); ``"both"`` where left out
            start: where the motion at the first value starts; a table ``{ disturbance, x, velocity_x }``; ``{ disturbance = 0.2 }`` where
                left out
                - ``disturbance``: steady sliding with x moved by this share of its magnitude, or of the scale of a motion where steady
                  sliding has no x; a number, any
                - ``x``: displacement, in units of x0 = F_n/k_x for the oscillator; a number, any
                - ``velocity_x``: velocity along x, in these units and those of ω_nx; a number, any
            duration: t: time within which each motion settles; a plain number (t), > 0; ``5000.0`` where left out
            transient: t: first part of the duration, which the averages of an irregular motion leave out; half of it by default; a plain
                number (t), ≥ 0; ``2500.0`` where left out
            tolerance: ε: local error of a step, relative to the magnitudes of steady sliding; a number, > 0.00000000000001, ≤ 0.01;
                ``1e-6`` where left out
            steps: the most steps of one motion; an integer from 1 to 1000000000000; ``10000000`` where left out
            branches: follow the [branches of cycles](theory/motion.md#branches-through-a-diagram), stable and unstable, through the
                diagram: a cascade of cycles that stick and lift off takes minutes; ``true`` or ``false``; ``false`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "sweep": sweep,
            "direction": direction,
            "start": start,
            "duration": duration,
            "transient": transient,
            "tolerance": tolerance,
            "steps": steps,
            "branches": branches,
        }
        return self._computed("bifurcation", keys, threads, progress)

    def basin(
        self,
        *,
        within: Mapping[str, Any],
        samples: int | None = None,
        seed: int | None = None,
        duration: float | None = None,
        tolerance: float | None = None,
        steps: int | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The share of starts, drawn evenly, from which steady sliding is reached.

        Args:
            within: the ranges from which starts are drawn, evenly and independently; a table ``{ x, velocity_x }``; must be given
                - ``x``: of the displacement; a list of 2, each a number, any
                - ``velocity_x``: of the velocity along x; a list of 2, each a number, any
            samples: number of starts; an integer from 1 to 10000000; ``1000`` where left out
            seed: which starts are drawn; the n-th depends on the seed and on n alone; an integer from 0 to 9007199254740991; ``1`` where
                left out
            duration: t: time within which each motion settles; a plain number (t), > 0; ``20000.0`` where left out
            tolerance: ε: local error of a step, relative to the magnitudes of steady sliding; a number, > 0.00000000000001, ≤ 0.01;
                ``1e-6`` where left out
            steps: the most steps of one motion; an integer from 1 to 1000000000000; ``10000000`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "within": within,
            "samples": samples,
            "seed": seed,
            "duration": duration,
            "tolerance": tolerance,
            "steps": steps,
        }
        return self._computed("basin", keys, threads, progress)


class TwoDegrees(Model):
    """Two degrees of freedom with given matrices.

    Args:
        case: what the case begins with: a path, the text of a case, its tables as a mapping; nothing where left out.
        set: changed keys by their dotted paths, as of :func:`judder.check`.
        analysis: a list of tables
        matrices: M, C and K
            - ``damping``: C; zero by default
            - ``mass``: M, 2×2 numbers or expressions; the identity by default
            - ``stiffness``: K; must be given
        parameters: numbers that expressions use and sweeps vary
        sweep: the whole case at many points
            - ``chunk``: points of a unit of work; chosen by the program where left out
            - ``method``: how points are chosen; ``"grid"`` where left out
            - ``name``: under which results are kept; no analysis and no other sweep has it; must be given
            - ``over``: the swept keys, see below; must be given
              - ``from``: first value
              - ``key``: dotted path of any number of the case; an item of a list goes by its name; must be given
              - ``points``: how many values, both ends included
              - ``scale``: spacing of the values; ``"linear"`` where left out
              - ``to``: last value
              - ``values``: in place of a range
            - ``points``: of ``latin-hypercube`` and ``sobol``: how many points; with sensitivity how many rows of k + 2 points for k keys.
              A power of two fills the ranges most evenly with ``sobol``
            - ``quantities``: what is kept of every point, see below: a quantity of the operating point, or ANALYSIS.PATH into the results
              of an analysis; must be given
            - ``seed``: of these two: which of all such points; the same seed gives the same points; ``1`` where left out
            - ``sensitivity``: of ``latin-hypercube`` and ``sobol``: first-order and total Sobol' indices of every quantity, with bootstrap
              intervals
              - ``confidence``: confidence of the intervals; ``0.95`` where left out
              - ``resamples``: bootstrap resamples from which they are taken; ``1000`` where left out
        title: the title; ``""`` where left out
    """

    _name = "two-degrees"

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
    ) -> None:
        keys: dict[str, Any] = {
            "analysis": analysis,
            "matrices": matrices,
            "parameters": parameters,
            "sweep": sweep,
            "title": title,
        }
        super().__init__(case, set, keys)

    def spectrum(
        self,
        *,
        sweep: Mapping[str, Any],
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The eigenvalues along one parameter.

        Args:
            sweep: one key over a range; a table ``{ key, from, to, points, scale }``; must be given
                - ``key``: dotted path of the key; ``parameters.NAME``; must be given
                - ``from``: first value; a number, any; must be given
                - ``to``: last value; a number, any; must be given
                - ``points``: number of points, both ends included; an integer from 2 to 134217728; must be given
                - ``scale``: spacing of the points; ``"linear"`` (equal steps), ``"log"`` (equal ratios); ``"linear"`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "sweep": sweep,
        }
        return self._computed("spectrum", keys, threads, progress)

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
        """Stable and unstable points over two parameters.

        Args:
            x: the key along the abscissa, over a range; a table ``{ key, from, to, points, scale }``; must be given
                - ``key``: dotted path of the key; ``parameters.NAME``; must be given
                - ``from``: first value; a number, any; must be given
                - ``to``: last value; a number, any; must be given
                - ``points``: number of points, both ends included; an integer from 2 to 134217728; must be given
                - ``scale``: spacing of the points; ``"linear"`` (equal steps), ``"log"`` (equal ratios); ``"linear"`` where left out
            y: the key along the ordinate, over a range; a table ``{ key, from, to, points, scale }``; must be given
                - ``key``: dotted path of the key; ``parameters.NAME``; must be given
                - ``from``: first value; a number, any; must be given
                - ``to``: last value; a number, any; must be given
                - ``points``: number of points, both ends included; an integer from 2 to 134217728; must be given
                - ``scale``: spacing of the points; ``"linear"`` (equal steps), ``"log"`` (equal ratios); ``"linear"`` where left out
            method: how the points are decided; ``"adaptive"`` (cells are refined only where a boundary crosses), ``"every-point"`` (every
                point is decided); ``"adaptive"`` where left out
            boundaries: trace the boundary curves as well; ``true`` or ``false``; ``true`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "x": x,
            "y": y,
            "method": method,
            "boundaries": boundaries,
        }
        return self._computed("stability-map", keys, threads, progress)

    def critical(
        self,
        *,
        sweep: Mapping[str, Any],
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """The values of a parameter at which stability changes.

        Args:
            sweep: one key over a range; a table ``{ key, from, to, points, scale }``; must be given
                - ``key``: dotted path of the key; ``parameters.NAME``; must be given
                - ``from``: first value; a number, any; must be given
                - ``to``: last value; a number, any; must be given
                - ``points``: number of points, both ends included; an integer from 2 to 134217728; ``400`` where left out
                - ``scale``: spacing of the points; ``"linear"`` (equal steps), ``"log"`` (equal ratios); ``"linear"`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "sweep": sweep,
        }
        return self._computed("critical", keys, threads, progress)


class Structure(Model):
    """One linear structure alone.

    Args:
        case: what the case begins with: a path, the text of a case, its tables as a mapping; nothing where left out.
        set: changed keys by their dotted paths, as of :func:`judder.check`.
        analysis: a list of tables
        damping: the damping of a body; none where left out
            - ``rayleigh``: C = α M + β K
              - ``alpha``: α: damping in proportion to the mass, C = α M + β K; such as ``"5 1/s"``; ``"0 1/s"`` where left out
              - ``beta``: β: damping in proportion to the stiffness; such as ``"10 ms"``; ``"0 s"`` where left out
              - ``ratios``: two damping ratios, in place of alpha and beta, which follow from them
                - ``frequency``: ω_k: frequency at which a damping ratio is given, in place of α and β; such as ``"40 rad/s"`` or ``"7
                  kHz"``; must be given
                - ``ratio``: ζ_k: the damping ratio there, ζ = α/(2ω) + βω/2; must be given
            - ``structural``: C = η K/ω_r, which meets structural damping K (1 + iη) at one frequency
              - ``loss_factor``: η: loss factor of structural damping, met by C = η K/ω_r at one frequency; must be given
              - ``reference_frequency``: ω_r: frequency at which structural damping is met; such as ``"40 rad/s"`` or ``"7 kHz"``; must be
                given
        matrices: M, C and K that another program assembled
            - ``damping``: C; zero by default
              - ``factor``: a number or an expression of the parameters; ``"1"`` where left out
              - ``file``: a matrix file, .mtx, .mat or .npz, relative to the folder; must be given
              - ``triangle``: what of a symmetric matrix the file holds; what the matrices say where left out
            - ``folder``: the folder of the files, relative to the case file
            - ``freedoms``: a table with node, direction and place of every degree of freedom
            - ``mass``: M; must be given
              - ``factor``: a number or an expression of the parameters; ``"1"`` where left out
              - ``file``: a matrix file, .mtx, .mat or .npz, relative to the folder; must be given
              - ``triangle``: what of a symmetric matrix the file holds; what the matrices say where left out
            - ``stiffness``: K; must be given
              - ``factor``: a number or an expression of the parameters; ``"1"`` where left out
              - ``file``: a matrix file, .mtx, .mat or .npz, relative to the folder; must be given
              - ``triangle``: what of a symmetric matrix the file holds; what the matrices say where left out
            - ``triangle``: what of a symmetric matrix a file holds whose term does not say; ``"both"`` where left out
        parameters: numbers that factors of matrices use and sweeps vary
        reduction: what a reduction keeps
            - ``count``: so many fixed-interface modes are kept, from the lowest on, where no cut-off is given; ``20`` where left out
            - ``cut_off``: ω_c: fixed-interface modes up to this frequency are kept; such as ``"40 rad/s"`` or ``"7 kHz"``
            - ``kept``: freedoms that are kept; must be given
              - ``directions``: directions in which they are kept; all that are free where left out; ``["x","y","z"]`` where left out
              - ``nodes``: of matrices, in place of set: nodes of the table of freedoms, by their numbers in it
              - ``set``: a set of nodes of a body
        structure: a body of elements
            - ``beam``: a straight beam of eight-node quadrilaterals
              - ``angle``: ϑ: from the x-axis to the axis of the beam, counter-clockwise; such as ``"45 deg"``; ``"0 rad"`` where left out
              - ``elements``: elements of a beam along and across; must be given
              - ``end``: how the end of a beam is held; ``"free"`` where left out
              - ``length``: l: length of a beam; such as ``"10 mm"``; must be given
              - ``origin``: x, y: where the middle of a beam's start lies; ``["0 m","0 m"]`` where left out
              - ``start``: how the start of a beam is held; ``"free"`` where left out
              - ``thickness``: b: thickness of a beam in its plane; such as ``"10 mm"``; must be given
            - ``block``: a rectangle or box of equal cells
              - ``cells``: cells along each side of a block; must be given
              - ``element``: the shape of a block's elements; ``quad8`` in the plane and ``hexahedron20`` in space where left out
              - ``size``: l_x, l_y, l_z: lengths of a block, two in the plane, three in space; must be given
            - ``material``: the material of all elements that have no other; a beam and a block must have one
              - ``density``: ρ: density; such as ``"7850 kg/m^3"``; must be given
              - ``poisson_ratio``: ν: Poisson's ratio; must be given
              - ``youngs_modulus``: E: Young's modulus; such as ``"1 MPa"``; must be given
            - ``materials``: materials by the names of a mesh file; ``{ }`` where left out
            - ``mesh``: a mesh file, .msh or .inp, relative to the case file
            - ``section``: how the third direction of a body of the plane is meant; a mesh file may say it; ``"plane-stress"`` where left
              out
            - ``supports``: what holds sets of nodes; ``[]`` where left out
              - ``fixed``: directions in which the nodes are held; ``[]`` where left out
              - ``set``: the name of the set of nodes; must be given
              - ``tied``: directions in which the nodes move as one; ``[]`` where left out
            - ``width``: a: width of a body of the plane across its plane; that of a mesh file, else 1 m where left out; such as ``"10 mm"``
        sweep: the whole case at many points
            - ``chunk``: points of a unit of work; chosen by the program where left out
            - ``method``: how points are chosen; ``"grid"`` where left out
            - ``name``: under which results are kept; no analysis and no other sweep has it; must be given
            - ``over``: the swept keys, see below; must be given
              - ``from``: first value
              - ``key``: dotted path of any number of the case; an item of a list goes by its name; must be given
              - ``points``: how many values, both ends included
              - ``scale``: spacing of the values; ``"linear"`` where left out
              - ``to``: last value
              - ``values``: in place of a range
            - ``points``: of ``latin-hypercube`` and ``sobol``: how many points; with sensitivity how many rows of k + 2 points for k keys.
              A power of two fills the ranges most evenly with ``sobol``
            - ``quantities``: what is kept of every point, see below: a quantity of the operating point, or ANALYSIS.PATH into the results
              of an analysis; must be given
            - ``seed``: of these two: which of all such points; the same seed gives the same points; ``1`` where left out
            - ``sensitivity``: of ``latin-hypercube`` and ``sobol``: first-order and total Sobol' indices of every quantity, with bootstrap
              intervals
              - ``confidence``: confidence of the intervals; ``0.95`` where left out
              - ``resamples``: bootstrap resamples from which they are taken; ``1000`` where left out
        title: the title; ``""`` where left out
    """

    _name = "structure"

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
    ) -> None:
        keys: dict[str, Any] = {
            "analysis": analysis,
            "damping": damping,
            "matrices": matrices,
            "parameters": parameters,
            "reduction": reduction,
            "structure": structure,
            "sweep": sweep,
            "title": title,
        }
        super().__init__(case, set, keys)

    def modes(
        self,
        *,
        count: int | None = None,
        band: Sequence[str] | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Undamped modes: frequencies, shapes, residuals, and a count that shows whether one is missing.

        Args:
            count: so many modes, from the lowest on, where no band is given; an integer from 1 to 2000; ``20`` where left out
            band: ω: all modes between two frequencies, in place of count; a list of 2, each an angular frequency such as 40 rad/s or 7 kHz,
                ≥ 0
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "count": count,
            "band": band,
        }
        return self._computed("modes", keys, threads, progress)

    def reduction(
        self,
        *,
        count: int | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Frequencies of the reduced structure against those of the full one, and the limit that the reduction tells of itself.

        Args:
            count: how many frequencies are compared; an integer from 1 to 2000; ``12`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "count": count,
        }
        return self._computed("reduction", keys, threads, progress)

    def eigen(
        self,
        *,
        region: Mapping[str, Any],
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """All complex modes in a region of the plane of growth rate and frequency, each with its error.

        Args:
            region: the rectangle of λ = re + i im in which eigenvalues are sought; a table ``{ re, im }``; must be given
                - ``re``: growth rates from and to, 1/s; a list of 2, each a number, any; must be given
                - ``im``: angular frequencies from and to, rad/s; a list of 2, each a number, any; must be given
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "region": region,
        }
        return self._computed("eigen", keys, threads, progress)

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
        """Complex modes along a parameter, followed through where they meet.

        Args:
            sweep: a parameter over a range, or with a list of values; a table ``{ key, from, to, points, scale }`` or ``{ key, values }``;
                must be given
            family: one curve for each value of another key; a table ``{ key, values }``
                - ``key``: dotted path of the key; ``parameters.NAME``; must be given
                - ``values``: its values; a list, each a number, any; must be given
            region: the rectangle of λ = re + i im in which eigenvalues are sought; a table ``{ re, im }``; must be given
                - ``re``: growth rates from and to, 1/s; a list of 2, each a number, any; must be given
                - ``im``: angular frequencies from and to, rad/s; a list of 2, each a number, any; must be given
            method: how each point is solved; ``"full"`` (on the full matrices), ``"projected"`` (on a basis of the modes of a few points);
                ``"full"`` where left out
            tolerance: ε: relative error that the method ``projected`` may leave; a number, > 0, ≤ 0.1; ``1e-6`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "sweep": sweep,
            "family": family,
            "region": region,
            "method": method,
            "tolerance": tolerance,
        }
        return self._computed("eigen-sweep", keys, threads, progress)

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
        """The displacement of one point by a unit force at another, over frequency.

        Args:
            excited: where the force acts; a table ``{ set, nodes, direction }``; must be given
                - ``set``: a set of nodes of a body; a text
                - ``nodes``: of matrices, in place of set: nodes of the table of freedoms, by their numbers in it; a list, each an integer,
                  ≥ 0
                - ``direction``: the direction; ``"x"`` (along x), ``"y"`` (along y), ``"z"`` (along z); must be given
            observed: where the displacement is told; a table ``{ set, nodes, direction }``; must be given
                - ``set``: a set of nodes of a body; a text
                - ``nodes``: of matrices, in place of set: nodes of the table of freedoms, by their numbers in it; a list, each an integer,
                  ≥ 0
                - ``direction``: the direction; ``"x"`` (along x), ``"y"`` (along y), ``"z"`` (along z); must be given
            band: ω: frequencies, from and to; a list of 2, each an angular frequency such as 40 rad/s or 7 kHz, ≥ 0; must be given
            points: how many frequencies, evenly spaced, both ends included; an integer from 2 to 100000; ``1000`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "excited": excited,
            "observed": observed,
            "band": band,
            "points": points,
        }
        return self._computed("receptance", keys, threads, progress)


class Sliding(Model):
    """One structure slides along another.

    Args:
        case: what the case begins with: a path, the text of a case, its tables as a mapping; nothing where left out.
        set: changed keys by their dotted paths, as of :func:`judder.check`.
        analysis: a list of tables
        contact: who slides on what, and friction
            - ``friction_coefficient``: μ: friction coefficient, or a table against the sliding speed; ``0.3`` where left out
              - ``coefficient``: μ(v): friction coefficients there, linear between the speeds and constant beyond them; must be given
              - ``velocity``: v: sliding speeds, ascending, two at least; must be given
            - ``initial_gap``: g_0: gap between the undeformed structures at the start, closed over the ramp of the gap; below zero a
              penetration; such as ``"10 mm"``; ``"0 m"`` where left out
            - ``interpolation``: how the edge runs between its nodes; ``"linear"`` where left out
            - ``slider``: the slider, and its contact point C, one node; must be given
              - ``nodes``: of matrices, in place of set: nodes of the table of freedoms, by their numbers in it
              - ``set``: a set of nodes of a body
              - ``structure``: the name of a structure; must be given
            - ``track``: the other structure, and the nodes of its edge in their order: positions count from the first; must be given
              - ``nodes``: of matrices, in place of set: nodes of the table of freedoms, by their numbers in it
              - ``set``: a set of nodes of a body
              - ``structure``: the name of a structure; must be given
        motion: path, velocity and load of the slider
            - ``end``: s_1: where it ends; such as ``"10 mm"``; ``"98.5 mm"`` where left out
            - ``initial_damping``: damping of both structures at the start, which then gives way to their own; left out, they have their own
              from the start on
              - ``alpha``: α_0: damping of both structures in proportion to their mass at the start; such as ``"5 1/s"``; ``"40 1/s"`` where
                left out
              - ``beta``: β_0: damping of both structures in proportion to their stiffness at the start; such as ``"10 ms"``; ``"4e-8 s"``
                where left out
              - ``hold``: T: time for which it holds; such as ``"10 ms"``; ``"0.2 s"`` where left out
              - ``release``: T: time over which it then gives way to the structures' own; such as ``"10 ms"``; ``"50 ms"`` where left out
            - ``load``: what presses the slider on the track; must be given
              - ``direction``: its direction; ``"y"`` where left out
              - ``force``: F_y: force on the slider; such as ``"0.2 N"``; ``"-0.2 N"`` where left out
              - ``nodes``: of matrices, in place of set: nodes of the table of freedoms, by their numbers in it
              - ``set``: a set of nodes of a body
            - ``noise``: a random force on C
              - ``force``: f_rms: root mean square of a random force on C across the track; 0 is none; such as ``"0.2 N"``; ``"0 N"`` where
                left out
              - ``seed``: which one: the same seed gives the same force; ``1`` where left out
            - ``ramps``: times of half a cosine from zero; 0 is at once
              - ``friction``: T: time over which friction rises from zero; such as ``"10 ms"``; ``"0.1 s"`` where left out
              - ``gap``: T: time over which the initial gap closes; such as ``"10 ms"``; ``"0.1 s"`` where left out
              - ``load``: T: time over which the load rises from zero; such as ``"10 ms"``; ``"0.1 s"`` where left out
              - ``velocity``: T: time over which the velocity rises from zero; such as ``"10 ms"``; ``"0.1 s"`` where left out
            - ``start``: s_0: rigid distance of C from the first node of the track when the motion starts; such as ``"10 mm"``; ``"10 mm"``
              where left out
            - ``velocity``: v_x: velocity of the slider along the track; below zero towards the first node; such as ``"30 mm/s"``; ``"30
              mm/s"`` where left out
        observe: points whose motion is kept; none where left out
            - ``points``: points whose motion along x and y a march keeps; must be given
              - ``at``: x, y: in place of set or nodes: where it lies in the undeformed structure; the nearest node is taken
              - ``name``: by which signals call this point; must be given
              - ``nodes``: of matrices, in place of set: nodes of the table of freedoms, by their numbers in it
              - ``set``: a set of nodes of a body
              - ``structure``: the name of a structure; must be given
        parameters: numbers that factors of matrices use and sweeps vary
        structure: the two structures
            - ``beam``: a straight beam of eight-node quadrilaterals
              - ``angle``: ϑ: from the x-axis to the axis of the beam, counter-clockwise; such as ``"45 deg"``; ``"0 rad"`` where left out
              - ``elements``: elements of a beam along and across; must be given
              - ``end``: how the end of a beam is held; ``"free"`` where left out
              - ``length``: l: length of a beam; such as ``"10 mm"``; must be given
              - ``origin``: x, y: where the middle of a beam's start lies; ``["0 m","0 m"]`` where left out
              - ``start``: how the start of a beam is held; ``"free"`` where left out
              - ``thickness``: b: thickness of a beam in its plane; such as ``"10 mm"``; must be given
            - ``block``: a rectangle or box of equal cells
              - ``cells``: cells along each side of a block; must be given
              - ``element``: the shape of a block's elements; ``quad8`` in the plane and ``hexahedron20`` in space where left out
              - ``size``: l_x, l_y, l_z: lengths of a block, two in the plane, three in space; must be given
            - ``damping``: its own damping; matrices have theirs
              - ``rayleigh``: C = α M + β K
                - ``alpha``: α: damping in proportion to the mass, C = α M + β K; such as ``"5 1/s"``; ``"0 1/s"`` where left out
                - ``beta``: β: damping in proportion to the stiffness; such as ``"10 ms"``; ``"0 s"`` where left out
                - ``ratios``: two damping ratios, in place of alpha and beta, which follow from them
                  - ``frequency``: ω_k: frequency at which a damping ratio is given, in place of α and β; such as ``"40 rad/s"`` or ``"7
                    kHz"``; must be given
                  - ``ratio``: ζ_k: the damping ratio there, ζ = α/(2ω) + βω/2; must be given
              - ``structural``: C = η K/ω_r, which meets structural damping K (1 + iη) at one frequency
                - ``loss_factor``: η: loss factor of structural damping, met by C = η K/ω_r at one frequency; must be given
                - ``reference_frequency``: ω_r: frequency at which structural damping is met; such as ``"40 rad/s"`` or ``"7 kHz"``; must be
                  given
            - ``material``: the material of all elements that have no other; a beam and a block must have one
              - ``density``: ρ: density; such as ``"7850 kg/m^3"``; must be given
              - ``poisson_ratio``: ν: Poisson's ratio; must be given
              - ``youngs_modulus``: E: Young's modulus; such as ``"1 MPa"``; must be given
            - ``materials``: materials by the names of a mesh file; ``{ }`` where left out
            - ``matrices``: M, C and K that another program assembled
              - ``damping``: C; zero by default
                - ``factor``: a number or an expression of the parameters; ``"1"`` where left out
                - ``file``: a matrix file, .mtx, .mat or .npz, relative to the folder; must be given
                - ``triangle``: what of a symmetric matrix the file holds; what the matrices say where left out
              - ``folder``: the folder of the files, relative to the case file
              - ``freedoms``: a table with node, direction and place of every degree of freedom
              - ``mass``: M; must be given
                - ``factor``: a number or an expression of the parameters; ``"1"`` where left out
                - ``file``: a matrix file, .mtx, .mat or .npz, relative to the folder; must be given
                - ``triangle``: what of a symmetric matrix the file holds; what the matrices say where left out
              - ``stiffness``: K; must be given
                - ``factor``: a number or an expression of the parameters; ``"1"`` where left out
                - ``file``: a matrix file, .mtx, .mat or .npz, relative to the folder; must be given
                - ``triangle``: what of a symmetric matrix the file holds; what the matrices say where left out
              - ``triangle``: what of a symmetric matrix a file holds whose term does not say; ``"both"`` where left out
            - ``mesh``: a mesh file, .msh or .inp, relative to the case file
            - ``name``: by which keys call this structure; must be given
            - ``reduction``: the modes that its reduction keeps, and what freedoms it keeps beside those that contact, load and observed
              points need
              - ``count``: so many fixed-interface modes are kept, from the lowest on, where no cut-off is given; ``20`` where left out
              - ``cut_off``: ω_c: fixed-interface modes up to this frequency are kept; such as ``"40 rad/s"`` or ``"7 kHz"``
              - ``kept``: freedoms that are kept
                - ``directions``: directions in which they are kept; all that are free where left out; ``["x","y","z"]`` where left out
                - ``nodes``: of matrices, in place of set: nodes of the table of freedoms, by their numbers in it
                - ``set``: a set of nodes of a body
            - ``section``: how the third direction of a body of the plane is meant; a mesh file may say it; ``"plane-stress"`` where left
              out
            - ``supports``: what holds sets of nodes; ``[]`` where left out
              - ``fixed``: directions in which the nodes are held; ``[]`` where left out
              - ``set``: the name of the set of nodes; must be given
              - ``tied``: directions in which the nodes move as one; ``[]`` where left out
            - ``width``: a: width of a body of the plane across its plane; that of a mesh file, else 1 m where left out; such as ``"10 mm"``
        sweep: the whole case at many points
            - ``chunk``: points of a unit of work; chosen by the program where left out
            - ``method``: how points are chosen; ``"grid"`` where left out
            - ``name``: under which results are kept; no analysis and no other sweep has it; must be given
            - ``over``: the swept keys, see below; must be given
              - ``from``: first value
              - ``key``: dotted path of any number of the case; an item of a list goes by its name; must be given
              - ``points``: how many values, both ends included
              - ``scale``: spacing of the values; ``"linear"`` where left out
              - ``to``: last value
              - ``values``: in place of a range
            - ``points``: of ``latin-hypercube`` and ``sobol``: how many points; with sensitivity how many rows of k + 2 points for k keys.
              A power of two fills the ranges most evenly with ``sobol``
            - ``quantities``: what is kept of every point, see below: a quantity of the operating point, or ANALYSIS.PATH into the results
              of an analysis; must be given
            - ``seed``: of these two: which of all such points; the same seed gives the same points; ``1`` where left out
            - ``sensitivity``: of ``latin-hypercube`` and ``sobol``: first-order and total Sobol' indices of every quantity, with bootstrap
              intervals
              - ``confidence``: confidence of the intervals; ``0.95`` where left out
              - ``resamples``: bootstrap resamples from which they are taken; ``1000`` where left out
        title: the title; ``""`` where left out
    """

    _name = "sliding"

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
    ) -> None:
        keys: dict[str, Any] = {
            "analysis": analysis,
            "contact": contact,
            "motion": motion,
            "observe": observe,
            "parameters": parameters,
            "structure": structure,
            "sweep": sweep,
            "title": title,
        }
        super().__init__(case, set, keys)

    def modes(
        self,
        *,
        structure: str,
        count: int | None = None,
        band: Sequence[str] | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """Undamped modes of one of the two structures, as it is held, without contact.

        Args:
            structure: the name of a structure; a text; must be given
            count: so many modes, from the lowest on, where no band is given; an integer from 1 to 2000; ``20`` where left out
            band: ω: all modes between two frequencies, in place of count; a list of 2, each an angular frequency such as 40 rad/s or 7 kHz,
                ≥ 0
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "structure": structure,
            "count": count,
            "band": band,
        }
        return self._computed("modes", keys, threads, progress)

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
        """Complex eigenvalues against the position of the contact, or against any key, with located unstable zones.

        Args:
            configuration: the configuration about which small motions are meant; ``"undeformed"`` (as drawn), ``"deformed"`` (under load
                and friction of steady sliding); ``"undeformed"`` where left out
            damping: whether the structures are damped; ``true`` or ``false``; ``true`` where left out
            count: how many eigenvalues at each value, from the lowest on, by the larger of imaginary and absolute real part; an integer
                from 1 to 2000; ``20`` where left out
            positions: positions of the contact, evenly spaced; the path of the motion where left out; a table ``{ from, to, points }``
                - ``from``: s: the first position; that of the motion where left out; a length such as 10 mm, ≥ 0
                - ``to``: s: the last position; that of the motion where left out; a length such as 10 mm, ≥ 0
                - ``points``: how many, both ends included; an integer from 2 to 1000000; ``1000`` where left out
            at: s: where the contact is while a key is swept; a length such as 10 mm, ≥ 0
            sweep: any number of ``structure``, ``contact``, ``motion`` or ``parameters`` over a range; each value is a case of its own; a
                table ``{ key, from, to, points, scale, values }``
                - ``key``: dotted path of any number of the case; an item of a list goes by its name; a text; must be given
                - ``from``: first value; a number, or a quantity with the key's unit
                - ``to``: last value; a number, or a quantity with the key's unit
                - ``points``: how many values, both ends included; an integer from 2 to 100000
                - ``scale``: spacing of the values; ``"linear"`` (equal steps), ``"log"`` (equal ratios); ``"linear"`` where left out
                - ``values``: in place of a range; a list, each a number, or a quantity with the key's unit
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "configuration": configuration,
            "damping": damping,
            "count": count,
            "positions": positions,
            "at": at,
            "sweep": sweep,
        }
        return self._computed("locus", keys, threads, progress)

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
        """The motion along the path by explicit time integration: signals, bursts, contact forces.

        Args:
            method: how the coupled structures are integrated; ``"subs"`` (couplings of the rigid, a-priori motion), ``"ensubs"`` (couplings
                of the deformed structures), ``"film"`` (forward increment Lagrange multipliers), ``"residual-flexibility"`` (exact between
                contacts); must be given
            step: h: time step; where left out, 3e-7 s or 0.9 of the limit of stability, of ``residual-flexibility`` 3e-6 s or 0.75 of it,
                whichever is smaller; a time such as 10 ms, > 0
            from_: s: where it begins, and the ramps run; ``motion.start`` where left out; a length such as 10 mm, ≥ 0
            to: s: where it ends; ``motion.end`` where left out; a length such as 10 mm, ≥ 0
            signals: how signals are low-passed and decimated, 1/step ≥ sample_rate > 2 pass_band, and what is kept of the observed points;
                a table ``{ pass_band, sample_rate, quantities }``
                - ``pass_band``: ω: up to which sampled signals are kept as they are; an angular frequency such as 40 rad/s or 7 kHz, > 0;
                  ``"50 kHz"`` where left out
                - ``sample_rate``: 2π f_s: samples per time at least: the steps between samples are a whole number; every step where steps
                  are longer; an angular frequency such as 40 rad/s or 7 kHz, > 0; ``"400 kHz"`` where left out
                - ``quantities``: what is kept of the motion of every observed point, along x and y; a list, each ``"acceleration"``,
                  ``"velocity"``, ``"displacement"``; ``["acceleration"]`` where left out
            signal: the signal whose peak and bursts are told: ``POINT.x`` or ``POINT.y``, an acceleration, ``POINT.y.velocity``,
                ``POINT.y.displacement``, ``normal-force``, ``tangential-force`` or ``sliding-velocity``; the first point's acceleration
                along y where left out; a text
            cut_off: ω_c: of ``residual-flexibility``: modes above are replaced by their flexibility; an angular frequency such as 40 rad/s
                or 7 kHz, > 0; ``"60 kHz"`` where left out
            slope: of ``subs``: whether the static slope of the deformed track is put in; ``"none"`` (it does not), ``"static"`` (its static
                slope is put in); ``"none"`` where left out
            predictor: of ``ensubs`` and ``film``: the displacements of the next step that the geometry of the contact is taken from;
                ``"printed"`` (those without the contact's force, as equation (16) of the beams paper has them), ``"with-force"`` (those
                under the force of the last step); ``"with-force"`` where left out
            sound: leave the accelerations that are kept, and ``signal``, as WAV, or these signals, each with its gain in the summary;
                ``true`` or ``false``; or a list, each a text; ``true`` where left out
            checkpoint_steps: steps between two states that an interrupted march can go on from; an integer from 1000 to 1000000000;
                ``500000`` where left out
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "method": method,
            "step": step,
            "from": from_,
            "to": to,
            "signals": signals,
            "signal": signal,
            "cut_off": cut_off,
            "slope": slope,
            "predictor": predictor,
            "sound": sound,
            "checkpoint_steps": checkpoint_steps,
        }
        return self._computed("march", keys, threads, progress)

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
        """The growth of one mode in a march with the contact held, against the eigenvalue there.

        Args:
            method: how the coupled structures are integrated; ``subs`` means the undeformed configuration, the others the deformed one;
                ``"subs"`` (couplings of the rigid, a-priori motion), ``"ensubs"`` (couplings of the deformed structures), ``"film"``
                (forward increment Lagrange multipliers), ``"residual-flexibility"`` (exact between contacts); must be given
            position: s: where the contact is held; a length such as 10 mm, ≥ 0; must be given
            frequency: ω: frequency near which the mode lies that is meant; an angular frequency such as 40 rad/s or 7 kHz, > 0; must be
                given
            step: h: time step; where left out, 3e-7 s or 0.9 of the limit of stability, of ``residual-flexibility`` 3e-6 s or 0.75 of it,
                whichever is smaller; a time such as 10 ms, > 0
            cut_off: ω_c: of ``residual-flexibility``: modes above are replaced by their flexibility; 60 kHz where left out; an angular
                frequency such as 40 rad/s or 7 kHz, > 0
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "method": method,
            "position": position,
            "frequency": frequency,
            "step": step,
            "cut_off": cut_off,
        }
        return self._computed("growth", keys, threads, progress)

    def spectrogram(
        self,
        *,
        of: str,
        signal: str | None = None,
        window: Literal["hann", "hamming", "blackman", "rectangular"] | None = None,
        length: str | None = None,
        overlap: float | None = None,
        reference: str | None = None,
        range: Sequence[float] | None = None,
        waterfall: int | None = None,
        locus: str | None = None,
        threads: int | None = None,
        progress: Progress | None = None,
    ) -> Result:
        """A signal of a march over time, position and frequency, with the unstable zones of a locus.

        Args:
            of: the name of a march that stands above; a text; must be given
            signal: which of its signals, called as that of a march is; the first point's acceleration along y where left out; a text
            window: how a piece of the signal fades in and out; ``"hann"``, ``"hamming"``, ``"blackman"``, ``"rectangular"``; ``"hann"``
                where left out
            length: T: length of its window; a time such as 10 ms, > 0; ``"5 ms"`` where left out
            overlap: o: share of a window that the next one has too; a number, ≥ 0, < 1; ``0.75`` where left out
            reference: the amplitude of 0 dB, in a unit of the signal; 1 of its SI unit where left out; a quantity of the signal, such as 1
                m/s^2
            range: the levels between which colours run, dB; they follow from the signal where left out; a list of 2, each a number, any
            waterfall: spectra that the waterfall draws one behind the other, 30 where left out; 0 draws none; an integer from 0 to 200
            locus: the name of a locus over positions that stands above, whose unstable zones are laid over; a text
            threads, progress: as of :func:`judder.run`.
        """
        keys: dict[str, Any] = {
            "of": of,
            "signal": signal,
            "window": window,
            "length": length,
            "overlap": overlap,
            "reference": reference,
            "range": range,
            "waterfall": waterfall,
            "locus": locus,
        }
        return self._computed("spectrogram", keys, threads, progress)
