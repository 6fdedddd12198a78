"""From the measured moduli of a rubber to the map on which a foot of it sings."""

import numpy as np

from judder.models import Contact, Oscillator

# what a machine has measured, E(ω) in Pa at frequencies in Hz; a fractional standard solid takes its place here
frequency = np.logspace(0, 11, 45)
part = (2j * np.pi * frequency * 1e-8) ** 0.6
modulus = 1e6 + 99e6 * part / (1 + part)

substrate = {"dma": {"frequency [Hz]": frequency, "E [Pa]": modulus, "terms": "auto"}, "poisson_ratio": 0.5}
indenter = {"radius": "10 mm"}
rubber = Contact(substrate=substrate, indenter=indenter).modulus().numbers
print(f"{rubber['terms']} terms leave {100 * rubber['storage_deviation']:.1f} % of the storage modulus")

foot = Oscillator(
    substrate=substrate,
    indenter=indenter,
    contact={"law": {"computed": True, "accuracy": 5e-2}, "friction_load": "contact-force", "shear_strength": "20 kPa"},
    operation={"velocity": "0.1 m/s", "normal_load": "1 mN"},
)
found = foot.stability_map(
    x={"key": "operation.velocity", "from": "1 mm/s", "to": "100 m/s", "points": 100, "scale": "log"},
    y={"key": "contact.shear_strength", "from": "1 kPa", "to": "1 MPa", "points": 80, "scale": "log"},
)
verdicts = found.data.stability.attrs["flag_meanings"].split()
# what is marginal, or has no answer, does not sing
sings = ~found.data.stability.isin([verdicts.index(verdict) for verdict in ("stable", "marginal", "unresolved")])
softest = found.data.shear_strength.where(sings.any("velocity")).min()
print(f"{100 * found.numbers['unstable_fraction']:.0f} % of the map sings; below a shear strength of {float(softest) / 1e3:.1f} kPa none of it")
