"""Writes the matrices beside this file: python write.py (NumPy and SciPy; h5py and hdf5storage for version 7.3 of MATLAB's files).

All are the same unsymmetric 6 × 6 matrix a_ij = (i + 1) + 0.1 (j + 1) where |i - j| is 0, 1 or 4, but for symmetric.mtx (its
symmetric part) and skew.mtx (its skew-symmetric part).
"""

import pathlib

import h5py
import hdf5storage
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


def save_sparse_73(path, matrix, name="A", packed=False):
    """A sparse matrix as MATLAB writes it into a file of version 7.3, which no library does."""
    columns = matrix.tocsc()
    columns.sort_indices()
    with h5py.File(path, "w", userblock_size=512) as file:
        group = file.create_group(name)
        group.attrs["MATLAB_class"] = np.bytes_("double")
        group.attrs["MATLAB_sparse"] = np.uint64(columns.shape[0])
        how = {"compression": "gzip", "chunks": True} if packed else {}
        group.create_dataset("data", data=columns.data, **how)
        group.create_dataset("ir", data=columns.indices.astype(np.uint64), **how)
        group.create_dataset("jc", data=columns.indptr.astype(np.uint64), **how)
    header = b"MATLAB 7.3 MAT-file, Platform: GLNXA64, HDF5 schema 1.00 .".ljust(124) + b"\x00\x02IM"
    with open(path, "r+b") as file:
        file.write(header)


save_sparse_73(HERE / "sparse_73.mat", sparse)
save_sparse_73(HERE / "sparse_73_compressed.mat", sparse, packed=True)
(HERE / "full_73.mat").unlink(missing_ok=True)
hdf5storage.savemat(str(HERE / "full_73.mat"), {"A": dense, "note": "no matrix"}, format="7.3", store_python_metadata=False)
