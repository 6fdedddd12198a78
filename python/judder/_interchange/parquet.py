"""Tables in Apache Parquet."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from judder._interchange.results import chosen, provenance, words
from judder._interchange.tables import Column, Table, tables
from judder._interchange.whole import Files, files
from judder._packages import needed

if TYPE_CHECKING:
    from judder.progress import Progress
    from judder.study import Study


def to_parquet(study: Study, folder: Path, only: Iterable[str], progress: Progress | None) -> list[Path]:
    """A file a table; units, long names and codes of classes are in the metadata of the fields."""
    arrow, parquet = (needed(module, "parquet", "to_parquet") for module in ("pyarrow", "pyarrow.parquet"))
    source = provenance(study)
    with files(folder) as written:
        for result in chosen(study, only, progress):
            for table in tables(result):
                _write(arrow, parquet, table, source, written)
    return written.paths


def _write(arrow: Any, parquet: Any, table: Table, source: dict[str, str], written: Files) -> None:
    said = {**source, **{key: words(value) for key, value in table.attributes.items()}}
    schema = arrow.schema([_field(arrow, column) for column in table.columns], metadata=said)
    with parquet.ParquetWriter(written.new(f"{table.name}.parquet"), schema) as writer:
        for block in table.blocks():
            columns = [_array(arrow, values, field.type) for values, field in zip(block, schema, strict=True)]
            writer.write_batch(arrow.record_batch(columns, schema=schema), row_group_size=max(1, len(block[0])))


def _array(arrow: Any, values: NDArray[Any], kind: Any) -> Any:
    """Values with nothing in place of NaN: databases count NaN among the numbers, as the largest."""
    return arrow.array(values, kind, mask=np.isnan(values) if values.dtype.kind == "f" else None)


def _field(arrow: Any, column: Column) -> Any:
    kind = arrow.string() if column.dtype == np.dtype(object) else arrow.from_numpy_dtype(column.dtype)
    return arrow.field(column.name, kind, metadata={key: words(value) for key, value in column.attributes.items()} or None)
