"""Studies for the tests of what leaves judder: every kind of variable, sweeps with failed points."""

import judder

SMALL = """
title = "Small things"
model = "oscillator"

[[analysis]]
name = "map"
kind = "stability-map"
method = "every-point"
x = { key = "operation.velocity", from = 1e-6, to = 1, points = 24, scale = "log" }
y = { key = "contact.shear_strength", from = 0, to = 0.2, points = 20 }

[[analysis]]
name = "spectrum"
kind = "spectrum"
sweep = { key = "operation.velocity", from = 1e-6, to = 1, points = 12, scale = "log" }

[[analysis]]
name = "cycle"
kind = "limit-cycle"

[[sweep]]
name = "grid"
over = [
  { key = "operation.velocity", from = 1e-6, to = 1, points = 7, scale = "log" },
  { key = "contact.shear_strength", from = 0, to = 0.2, points = 5 },
]
quantities = ["growth_rate", "verdict", "cycle.rms"]
chunk = 4

[[sweep]]
name = "samples"
method = "sobol"
points = 64
over = [
  { key = "operation.velocity", from = "1 mm/s", to = "1 m/s", scale = "log" },
  { key = "contact.shear_strength", from = 0.01, to = 0.2 },
]
quantities = ["growth_rate", "verdict", "cycle.rms"]
chunk = 16
"""

# its branches say in words which pattern of the contact they have
WORDS = """
model = "belt"
[oscillator]
damping = 0.05
[friction]
at_rest = 1.0
at_speed = 0.5
decay_speed = 0.5
[operation]
velocity = 1.5
normal_force = 1.0
[[analysis]]
name = "diagram"
kind = "bifurcation"
sweep = { key = "operation.velocity", from = 0.5, to = 2.0, points = 5 }
start = { x = 1.0, velocity_x = 0.0 }
branches = true
"""


def study_of(case, folder, **options):
    """The study of a case, whose warnings are no matter here."""
    import warnings

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", judder.JudderWarning)
        return judder.run(case, output=folder, **options)


def bits(values):
    """Numbers or words in a form that is equal only where every bit is."""
    return [str(value) for value in values.ravel()] if values.dtype.kind in "OTU" else values.tobytes()
