"""Writes the height maps beside it with the libraries of other hands: NumPy, SciPy (NetCDF classic), netCDF4 (NetCDF-4).

    python write.py

The surface is z = 0.25 (2 x² + y²) + 0.125 x + 3 on 5 columns x and 4 rows y, in um.
"""

from pathlib import Path

import netCDF4
import numpy as np
from scipy.io import netcdf_file

HERE = Path(__file__).resolve().parent
X, Y = 0.5 * np.arange(5.0), 0.5 * np.arange(4.0) - 1.0
Z = 0.25 * (2 * X[None, :] ** 2 + Y[:, None] ** 2) + 0.125 * X[None, :] + 3.0


def classic(name, variables, x=X, y=Y, unit=b"um", order=("y", "x")):
    with netcdf_file(HERE / name, "w") as file:
        sizes = {"x": len(X), "y": len(Y)}
        for dimension in order:
            file.createDimension(dimension, sizes[dimension])
        for dimension, values in (("x", x), ("y", y)):
            if values is not None:
                coordinate = file.createVariable(dimension, "f8", (dimension,))
                coordinate[:] = values
                coordinate.units = b"um"
        for variable in variables:
            heights = file.createVariable(variable, "f8", order)
            heights[:] = Z if order == ("y", "x") else Z.T
            heights.units = unit


np.save(HERE / "c_order.npy", Z)
np.save(HERE / "fortran_order_f4.npy", np.asfortranarray(Z.astype(">f4")))
np.save(HERE / "integers.npy", Z.astype(int))
classic("classic.nc", ["z"])
classic("transposed.nc", ["z"], order=("x", "y"))
classic("no_coordinates.nc", ["z"], x=None, y=None)
classic("two_variables.nc", ["z", "error"])
classic("stretched.nc", ["z"], x=X**1.5)
classic("oblong.nc", ["z"], x=2 * X)
classic("two_units.nc", ["z"], unit=b"nm")
with netCDF4.Dataset(HERE / "four_packed.nc", "w") as file:
    for dimension, values in (("y", Y[::-1]), ("x", X)):
        file.createDimension(dimension, len(values))
        file.createVariable(dimension, "f8", (dimension,))[:] = values
    heights = file.createVariable("z", "i2", ("y", "x"), zlib=True, fill_value=-1)
    heights.scale_factor, heights.add_offset = 1.0 / 1024.0, 2.0
    heights[:] = Z[::-1]
with netCDF4.Dataset(HERE / "four_masked.nc", "w") as file:
    for dimension, size in (("y", 4), ("x", 5)):
        file.createDimension(dimension, size)
    heights = file.createVariable("z", "f4", ("y", "x"), fill_value=1e30)
    heights[:] = np.ma.masked_where((X[None, :] == 1.5) & (Y[:, None] == 0.0), Z)
# every type of numbers that the format has, the largest and the smallest first, in both byte orders
with netCDF4.Dataset(HERE / "four_types.nc", "w") as file:
    for dimension, size in (("y", 2), ("x", 3)):
        file.createDimension(dimension, size)
    for kind in ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8"):
        for order in ("little", "big"):
            largest = 2.0**100 if kind[0] == "f" else 2 ** (8 * int(kind[1]) - (kind[0] == "i")) - 1
            smallest = {"f": -largest, "i": -largest - 1, "u": 0}[kind[0]]
            ordered = ("<" if order == "little" else ">") + kind
            heights = file.createVariable(f"{kind}-{order}", ordered, ("y", "x"), endian=order, fill_value=False)
            heights[:] = np.array([[largest, smallest, 2], [1, 0, 7]], dtype=kind)
# bytes that are unsigned by an attribute, whose largest one is no height
with netCDF4.Dataset(HERE / "four_unsigned.nc", "w") as file:
    for dimension, size in (("y", 2), ("x", 2)):
        file.createDimension(dimension, size)
    heights = file.createVariable("z", "i1", ("y", "x"), fill_value=False)
    heights.set_auto_maskandscale(False)
    heights.setncattr("_Unsigned", "true")
    heights.setncattr("missing_value", np.int8(-1))
    heights.scale_factor = 0.5
    heights[:] = np.array([[-1, -2], [2, 127]], dtype="i1")
