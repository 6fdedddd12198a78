"""Results in the files of other programs."""

from judder._interchange.comma import to_csv
from judder._interchange.matlab import to_matlab
from judder._interchange.netcdf import to_netcdf
from judder._interchange.parquet import to_parquet

__all__ = ["to_csv", "to_matlab", "to_netcdf", "to_parquet"]
