"""What functions on arrays take that are keys of a case.

The tests write it from the declarations by which case files are read: ``JUDDER_GOLDEN=write cargo nextest run -p judder-python``.
"""

from __future__ import annotations

from typing import Final, Literal, TypeAlias, TypedDict

LawName: TypeAlias = Literal["oscillator-paper", "oscillator-paper-corrected", "hertz", "bem"]
"""Contact law."""
FrictionLoad: TypeAlias = Literal["normal-load", "contact-force"]
"""The force that μ_visc multiplies."""
Configuration: TypeAlias = Literal["undeformed", "deformed"]
"""The configuration about which small motions are meant."""
MarchMethod: TypeAlias = Literal["subs", "ensubs", "film", "residual-flexibility"]
"""How the coupled structures are integrated."""
Predictor: TypeAlias = Literal["printed", "with-force"]
"""Of ``ensubs`` and ``film``: the displacements of the next step that the geometry of the contact is taken from."""
CONTACT_ACCURACY: Final = 0.001
CONTACT_MEMORY: Final = 4294967296
LOCUS_CONFIGURATION: Final = "undeformed"
LOCUS_COUNT: Final = 20
LOCUS_DAMPING: Final = True
FILES: Final[dict[str, dict[str, tuple[str, ...]]]] = {
    "oscillator": {
        "contact.law.file": ("accuracy", "computed"),
        "substrate.dma.file": ("terms",),
    },
    "contact": {
        "indenter.shape.heights": (),
        "substrate.dma.file": ("terms",),
    },
    "belt": {
        "friction.file": ("at_rest", "at_speed", "coefficient", "decay_speed", "exponent", "interpolation", "velocity", "viscous"),
    },
    "two-degrees": {},
    "structure": {
        "matrices.damping.*.file": ("factor", "triangle"),
        "matrices.freedoms": (),
        "matrices.mass.*.file": ("factor", "triangle"),
        "matrices.stiffness.*.file": ("factor", "triangle"),
        "structure.mesh": (),
    },
    "sliding": {
        "contact.friction_coefficient.file": ("at_rest", "at_speed", "coefficient", "decay_speed", "exponent", "interpolation", "velocity", "viscous"),
        "structure.*.matrices.damping.*.file": ("factor", "triangle"),
        "structure.*.matrices.freedoms": (),
        "structure.*.matrices.mass.*.file": ("factor", "triangle"),
        "structure.*.matrices.stiffness.*.file": ("factor", "triangle"),
        "structure.*.mesh": (),
    },
    "assembly": {
        "analysis.*.base.*.acceleration.file": ("amplitude", "band", "frequency", "from", "phase", "rms", "scale", "seed", "sweep", "to"),
        "analysis.*.course.friction.file": ("factors", "rise", "times"),
        "analysis.*.course.load.file": ("factors", "rise", "times"),
        "analysis.*.course.speed.file": ("factors", "rise", "times"),
        "analysis.*.forces.*.force.file": ("amplitude", "band", "frequency", "from", "phase", "rms", "scale", "seed", "sweep", "to"),
        "analysis.*.friction_over_temperature.file": ("factors", "temperatures"),
        "analysis.*.start.study": (),
        "analysis.*.temperature.file": ("temperatures", "times"),
        "contact.*.asperity.law.file": ("accuracy", "computed"),
        "contact.*.friction_coefficient.file": ("at_rest", "at_speed", "coefficient", "decay_speed", "exponent", "interpolation", "velocity", "viscous"),
        "contact.*.normal.file": ("cubic", "interpolation", "point_cubic", "point_stiffness", "point_table", "stiffness", "table"),
        "structure.*.matrices.damping.*.file": ("factor", "triangle"),
        "structure.*.matrices.freedoms": (),
        "structure.*.matrices.mass.*.file": ("factor", "triangle"),
        "structure.*.matrices.stiffness.*.file": ("factor", "triangle"),
        "structure.*.mesh": (),
        "substrate.dma.file": ("terms",),
    },
}
"""The keys of each model that name a file, by their dotted paths, ``*`` for an item or a name; and what may stand beside a key ``file``."""
ROWS: Final[dict[str, tuple[str, ...]]] = {
    "oscillator": ("substrate.continuous.samples", "substrate.prony", "substrate.relaxation"),
    "contact": ("substrate.continuous.samples", "substrate.prony", "substrate.relaxation"),
    "belt": (),
    "two-degrees": (),
    "structure": ("damping.rayleigh.ratios",),
    "sliding": ("structure.*.damping.rayleigh.ratios",),
    "assembly": ("structure.*.damping.rayleigh.ratios", "substrate.continuous.samples", "substrate.prony", "substrate.relaxation"),
}
"""Lists of tables of nothing but numbers, by their dotted paths."""


class Keys(TypedDict, total=False):
    """The numeric keys of an oscillator case, by their last names."""

    normal_load: float | str
    """F_n: normal load; such as ``"0.2 N"``; ``1e-6`` where left out."""
    velocity: float | str
    """v_d: driving speed; such as ``"30 mm/s"``; ``0.0001`` where left out."""
    shear_strength: float | str
    """τ0: interfacial shear strength; such as ``"1 MPa"``; ``0.01`` where left out."""
    coupling: float
    """η: coupling frequency ratio, ω_nxy/ω_nx; η² is k_xy/k_x; ``1.0`` where left out."""
    coupling_angle: str
    """α: inclination of the oblique spring; such as ``"45 deg"``; ``"45 deg"`` where left out."""
    damping_x: float
    """ξ_x: damping ratio along the sliding direction; ``0.01`` where left out."""
    damping_y: float
    """ξ_y: damping ratio normal to the surface; ``0.01`` where left out."""
    frequency_ratio: float
    """Ω: normal over tangential natural frequency, ω_ny/ω_nx; ``1.0`` where left out."""
    natural_frequency: str
    """ω_nx: tangential natural frequency; 1 Hz is 2π rad/s; such as ``"40 rad/s"`` or ``"7 kHz"``; ``"40 rad/s"`` where left out."""
    stiffness_x: str
    """k_x: tangential stiffness; such as ``"50 N/m"``; ``"50 N/m"`` where left out."""
    radius: str
    """R: radius of the indenter; such as ``"10 mm"``; ``"10 mm"`` where left out."""
    glassy_modulus: str
    """E∞: modulus of the substrate under fast loading, above the rubbery modulus; such as ``"1 MPa"``; ``"10 MPa"`` where left out."""
    poisson_ratio: float
    """ν: the Poisson ratio of the substrate; ``0.5`` where left out."""
    relaxation_time: str
    """τ_r: relaxation time of the substrate, τ E0/E∞; in place of retardation_time; such as ``"10 ms"``."""
    retardation_time: str
    """τ: creep time of the substrate, the paper's τ; such as ``"10 ms"``; ``"10 ms"`` where left out."""
    rubbery_modulus: str
    """E0: modulus of the substrate under slow loading; such as ``"1 MPa"``; ``"1 MPa"`` where left out."""
