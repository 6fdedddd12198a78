"""A mass on a belt whose friction was measured: at which speeds it slides, at which it sticks and slips, and where both can be."""

import numpy as np

from judder.models import Belt

# speeds and coefficients as a measurement has them; in the units of the belt a mass of 1 swings on a spring of 1
speed = np.array([0.0, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0])
coefficient = np.array([0.800, 0.726, 0.664, 0.569, 0.502, 0.424, 0.390, 0.378, 0.393, 0.421, 0.480])

belt = Belt(
    oscillator={"damping": 0.05},
    friction={"velocity": speed, "coefficient": coefficient},
    operation={"velocity": 0.6, "normal_force": 1.0},
)
cycle = belt.limit_cycle(start={"x": 1.0, "velocity_x": 0.6}).numbers
print(f"at 0.6 it sticks {100 * cycle['stick_fraction']:.0f} % of the period of {cycle['period']:.2f}")

speeds = {"key": "operation.velocity", "from": 0.51, "to": 1.21, "points": 36}
found = belt.bifurcation(sweep=speeds, start={"x": 1.0, "velocity_x": 0.0}, tolerance=1e-8).numbers
fastest = {}
for value, direction, becomes in zip(found["value"], found["direction"], found["becomes"], strict=True):
    if becomes == "cycle":
        fastest[direction] = max(value, fastest.get(direction, 0.0))
print(f"where the belt speeds up, by 0.02 each, it vibrates to {fastest['forward']:.2f}; where it slows down, from {fastest['backward']:.2f} on")
