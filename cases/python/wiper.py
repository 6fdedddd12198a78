"""A wiper whose friction falls with speed: from which speed on it wipes, and how it stutters below."""

import numpy as np

from judder.models import Assembly

lip = {
    "name": "lip",
    "matrices": {
        "mass": 0.02 * np.eye(2),  # kg
        "damping": 0.6 * np.eye(2),  # N s/m
        "stiffness": np.diag([800.0, 5000.0]),  # N/m
        "freedoms": [("tip", "x"), ("tip", "y")],
    },
}
glass = {
    "name": "glass",
    "slider": {"structure": "lip", "set": "tip"},
    "track": {"plane": {"normal": [0, 1]}},
    "sliding": {"velocity": "0.3 m/s", "direction": [1, 0]},
    "normal": {"point_stiffness": "20 kN/m"},
    "friction_coefficient": {"at_rest": 1.2, "at_speed": 0.2, "decay_speed": "0.15 m/s"},
}
wiper = Assembly(
    structure=[lip],
    contact=[glass],
    load=[{"structure": "lip", "set": "tip", "direction": "y", "force": "-10 N"}],
    observe={"points": [{"name": "tip", "structure": "lip", "set": "tip"}]},
)
speeds = {"key": "contact.glass.sliding.velocity", "from": "0.1 m/s", "to": "1 m/s", "points": 10}
for onset in wiper.eigen_sweep(band=["1 Hz", "60 Hz"], sweep=speeds).numbers["onsets"]:
    print(f"wipes from {onset['value']:.3f} m/s on; below it swings at {onset['frequency_hz']:.0f} Hz")
stutter = wiper.march(method="moreau", step="50 us", duration="2 s", transient="1 s", start={"velocity": [0.01, 0]}).numbers
stuck = stutter["contacts"]["glass"]["stick_share"][0]
print(f"at 0.3 m/s it stutters {stutter['frequency_hz']:.0f} times a second and sticks {100 * stuck:.0f} % of the time")
