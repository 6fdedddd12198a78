"""A mass on a belt whose friction was measured: at which speeds it slides, at which it sticks and slips, and where both can be."""

import numpy as np

from judder.models import Belt

# speeds and coefficients as a measurement has them; in the units of the belt a mass of 1 swings on a spring of 1
speed = np.array([0.0, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0])
coefficient = np.array([0.800, 0.726, 0.664, 0.569, 0.502, 0.424, 0.390, 0.378, 0.393, 0.421, 0.480])

belt = Belt(
    oscillator={"damping": 0.02},
    friction={"velocity": speed, "coefficient": coefficient},
    operation={"velocity": 0.6, "normal_force": 1.0},
)
cycle = belt.limit_cycle(start={"x": 1.0, "velocity_x": 0.6}).numbers
print(f"at 0.6 it sticks {100 * cycle['stick_fraction']:.0f} % of the period of {cycle['period']:.2f}")

speeds = {"key": "operation.velocity", "from": 0.8, "to": 1.6, "points": 9}
found = belt.bifurcation(sweep=speeds, start={"x": 1.0, "velocity_x": 0.0}, tolerance=1e-8).numbers
vibrates = {"forward": set(), "backward": set()}
for value, direction, becomes in zip(found["value"], found["direction"], found["becomes"], strict=True):
    if becomes != "steady sliding":
        vibrates[direction].add(round(value, 2))
both = sorted(vibrates["forward"] - vibrates["backward"])
print(f"it vibrates up to {max(vibrates['forward'])} where the belt speeds up; from {both[0]} on it also slides, where it slows down")
