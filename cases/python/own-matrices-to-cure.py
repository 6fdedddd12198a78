"""From the matrices of a pad on a disc to the mode that squeals, and to the abutment that keeps it quiet."""

import numpy as np

from judder.models import Structure

# a pad along and across the slip, and the disc under it, in kg and N/m; matrices of scipy.sparse take the same way
mass = np.diag([0.3, 0.3, 1.2])
bodies = np.diag([0.0, 2.0e7, 3.9e8])
abutment = np.diag([1.2e8, 0.0, 0.0])
compressed = np.array([0.0, 1.0, -1.0])  # how the lining between pad and disc is compressed
dragged = np.array([1.0, 0.0, 0.0])  # what its friction drags
lining = 1e8 * np.outer(compressed, compressed)
tilt = 1e7 * (np.outer(dragged, compressed) + np.outer(compressed, dragged))
friction = -1e8 * np.outer(dragged, compressed)

parameters = {"mu": 0.9, "held": 1.0, "lining_damping": 20.0}
matrices = {
    "mass": mass,
    "damping": {"bodies": 50.0 * mass, "lining": {"file": np.outer(compressed, compressed), "factor": "lining_damping"}},
    "stiffness": {
        "bodies": bodies + lining + tilt,
        "abutment": {"file": abutment, "factor": "held"},
        "friction": {"file": friction, "factor": "mu"},
    },
}
brake = Structure(parameters=parameters, matrices=matrices)
region = {"re": [-3e3, 3e3], "im": [5e3, 5e4]}
worst = brake.eigen(region=region).numbers["diagnosis"][0]
print(f"the mode at {worst['frequency_hz']:.0f} Hz grows with {worst['growth_rate']:.0f} 1/s")
for own in worst["parameters"]:
    print(f"  {own['name']}: {own['sensitivity'][0] * 0.1 * parameters[own['name']]:+.1f} 1/s for a tenth more")
along = {"key": "parameters.held", "from": 0.4, "to": 1.0, "points": 13}
onsets = brake.eigen_sweep(region=region, sweep=along).numbers["onsets"]
gains, loses = (next(own["value"] for own in onsets if own["gains"] is gains) for gains in (True, False))
cured = Structure(parameters={**parameters, "held": (gains + loses) / 2}, matrices=matrices)
unstable = cured.eigen(region=region).numbers["unstable"]
print(f"it is quiet with {gains:.2f} to {loses:.2f} times the stiffness of the abutment; modes that grow half-way: {unstable}")
