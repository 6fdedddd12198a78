"""A wiper: how it touches the glass, along a line, what friction that leaves, from which speed on it wipes, and how it stutters below."""

import numpy as np

from judder.models import Assembly, Contact

length, pressed, dry, wet = 0.6, 15.0, 200e3, 150e3  # m, N/m, and the shear strength of the interface at rest and fast, Pa
rubber = {"rubbery_modulus": "3 MPa", "glassy_modulus": "300 MPa", "retardation_time": "1 us", "thickness": "1 mm"}
edge = Contact(substrate=rubber, indenter={"radius": "0.2 mm", "shape": "cylinder", "length": f"{length} m"})
# on smooth glass the contact stays on the rubber: at rest, whatever the speed of the wiper
less, more = (edge.contact(velocity=0, load=f"{load} N/m").numbers for load in (0.95 * pressed, 1.05 * pressed))
width = (less["width_metre"] + more["width_metre"]) / 2
stiffness = 0.1 * pressed * length / (more["indentation_metre"] - less["indentation_metre"])
print(f"the edge is {1e6 * width:.0f} um wide on the glass; friction is {dry * width / pressed:.2f} at rest, {wet * width / pressed:.2f} fast")
lip = {
    "name": "lip",
    "matrices": {
        "mass": 6e-3 * np.eye(2),  # kg
        "damping": 0.6 * np.eye(2),  # N s/m
        "stiffness": np.diag([1500.0, 6000.0]),  # N/m
        "freedoms": [("tip", "x"), ("tip", "y")],
    },
}
glass = {
    "name": "glass",
    "slider": {"structure": "lip", "set": "tip"},
    "track": {"plane": {"normal": [0, 1]}},
    "sliding": {"velocity": "0.3 m/s", "direction": [1, 0]},
    "normal": {"point_stiffness": f"{stiffness} N/m"},
    "friction_coefficient": {"at_rest": dry * width / pressed, "at_speed": wet * width / pressed, "decay_speed": "0.5 m/s"},
}
load = {"structure": "lip", "set": "tip", "direction": "y", "force": f"{-pressed * length} N"}
wiper = Assembly(structure=[lip], contact=[glass], load=[load], observe={"points": [{"name": "tip", "structure": "lip", "set": "tip"}]})
speeds = {"key": "contact.glass.sliding.velocity", "from": "0.1 m/s", "to": "1.5 m/s", "points": 15}
for onset in wiper.eigen_sweep(band=["1 Hz", "500 Hz"], sweep=speeds).numbers["onsets"]:
    print(f"wipes from {onset['value']:.2f} m/s on; below it swings at {onset['frequency_hz']:.0f} Hz")
stutter = wiper.march(method="moreau", step="20 us", duration="1 s", transient="0.5 s").numbers
stuck = stutter["contacts"]["glass"]["stick_share"][0]
print(f"at 0.3 m/s it stutters {stutter['frequency_hz']:.0f} times a second and sticks {100 * stuck:.0f} % of the time")
