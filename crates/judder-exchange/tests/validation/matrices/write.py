"""Writes the matrices beside this file: python write.py (NumPy and SciPy).

All are the same unsymmetric 6 × 6 matrix a_ij = (i + 1) + 0.1 (j + 1) where |i - j| is 0, 1 or 4, but for symmetric.mtx (its
symmetric part) and skew.mtx (its skew-symmetric part).
"""

import pathlib

import numpy as np
import scipy.io
import scipy.sparse

HERE = pathlib.Path(__file__).parent
i, j = np.indices((6, 6))
dense = np.where(np.isin(abs(i - j), [0, 1, 4]), (i + 1) + 0.1 * (j + 1), 0.0)
sparse = scipy.sparse.csr_matrix(dense)

for name, matrix in {"sparse": sparse.tocsc(), "full": dense}.items():
    scipy.io.savemat(HERE / f"{name}.mat", {"A": matrix, "note": "no matrix"})
    scipy.io.savemat(HERE / f"{name}_compressed.mat", {"A": matrix}, do_compression=True)
for name in ["csr", "csc", "coo", "dia"]:
    scipy.sparse.save_npz(HERE / f"{name}.npz", sparse.asformat(name))
scipy.sparse.save_npz(HERE / "bsr.npz", scipy.sparse.bsr_matrix(dense, blocksize=(2, 3)), compressed=False)
scipy.sparse.save_npz(HERE / "coo_array.npz", scipy.sparse.coo_array(dense))
scipy.io.mmwrite(HERE / "general.mtx", sparse, symmetry="general", precision=17)
scipy.io.mmwrite(HERE / "array.mtx", dense, symmetry="general", precision=17)
scipy.io.mmwrite(HERE / "symmetric.mtx", (sparse + sparse.T) / 2, symmetry="symmetric", precision=17)
scipy.io.mmwrite(HERE / "skew.mtx", (sparse - sparse.T) / 2, symmetry="skew-symmetric", precision=17)
coordinates = [f"{a + 1:8d} {b + 1:8d} {dense[a, b]:25.17E}" for a, b in zip(*dense.nonzero())]
(HERE / "abaqus.mtx").write_text("\n".join(coordinates) + "\n")
