"""Kinds of tables: how the columns of each are read, and others added. None is imported here that was not there."""

from __future__ import annotations

import sys

from ._core import CoupletError
from ._exact import exact, listed

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ._types import Any, Mapping, Optional, Sequence

    #: Doubles as an array or exact texts, and which of the cells have a value; None if all have.
    Cells = tuple[Any, Optional[Any]]


#: The codes of no word and of no side.
NO_WORD, NO_SIDE = -1, -128


def kind_of(data: Any) -> Columns | None:
    """The kind of a table; None if it is none."""
    pandas, polars, pyarrow = map(sys.modules.get, ("pandas", "polars", "pyarrow"))
    for library, frame in ((pandas, Pandas), (polars, Polars)):
        if library is not None and isinstance(data, library.DataFrame):
            return frame(data, list(data.columns), len(data), library)
    if pyarrow is not None and isinstance(data, (pyarrow.Table, pyarrow.RecordBatch)):
        return Arrow(data, data.schema.names, data.num_rows, pyarrow)
    if hasattr(data, "__arrow_c_stream__") or hasattr(data, "__arrow_c_array__"):
        return kind_of(_of_arrow(data))
    if not hasattr(data, "keys") or not hasattr(data, "__getitem__") or hasattr(data, "columns"):
        return None
    return Columns(data, list(data), next((len(column) for column in data.values() if hasattr(column, "__len__")), 0), None)


def _of_arrow(data: Any) -> Any:
    """What speaks Arrow's C interface, as a table of pyarrow, or of polars if that is there and pyarrow is not."""
    try:
        import pyarrow  # type: ignore[import-not-found, import-untyped, unused-ignore]
    except ImportError:
        try:
            import polars  # type: ignore[import-not-found, unused-ignore]
        except ImportError:
            kind = type(data).__name__
            raise ModuleNotFoundError(f"a {kind} of Arrow is read by pyarrow or polars: pip install pyarrow", name="pyarrow") from None
        return polars.DataFrame(data)
    return pyarrow.table(data) if hasattr(data, "__arrow_c_stream__") else pyarrow.record_batch(data)


class Columns:
    """A dictionary of arrays, which has codes in place of words and of nothing. Other kinds of tables have the same methods."""

    def __init__(self, data: Any, names: list[Any], size: int, library: Any) -> None:
        self.data, self.names, self.size, self.library = data, names, size, library

    def cells(self, name: str) -> Cells:
        import numpy as np

        column = self.data[name]
        present = None
        if isinstance(column, np.ma.MaskedArray):
            present = ~np.ma.getmaskarray(column)
            column = column.filled(0) if column.dtype.kind in "fiu" else column.data
        array = np.asarray(column)
        if array.ndim != 1:
            raise CoupletError(f"the column '{name}' has {array.ndim} dimensions, not one")
        if not isinstance(column, (list, tuple)):
            return _cells(array, array, name, present)
        # NumPy makes texts of numbers beside texts, and doubles of whole numbers beside doubles.
        rounds = array.dtype.kind == "f" and any(isinstance(value, int) and abs(value) > 2**53 for value in column)
        return _cells(None if rounds else array, column, name)

    def column(self, values: Any, nothing: int | None = None, words: Sequence[str] | None = None, are_few: bool = True) -> Any:
        """A column of doubles, not a number where there is nothing; or of whole numbers with one that is nothing, as they are or as
        places of words, which are few or texts of any kind."""
        import numpy as np

        if words is None:
            return values
        # Codes as those of ``states``: nothing is 255.
        return values.view("uint8") if are_few else np.array([*words, None], dtype=object)[values]

    def with_columns(self, columns: Mapping[str, Any]) -> Any:
        return {**self.data, **columns}


class Pandas(Columns):
    """A frame of pandas."""

    def cells(self, name: str) -> Cells:
        column = self.data[name]
        if isinstance(column.dtype, self.library.CategoricalDtype):
            column = column.astype(column.cat.categories.dtype)
        kind = column.dtype
        if getattr(kind, "kind", "") in "fiu" and not hasattr(kind, "na_value"):
            return _cells(column.to_numpy(), column, name)
        missing = column.isna().to_numpy(dtype=bool)
        present = ~missing if missing.any() else None
        as_numpy = getattr(kind, "numpy_dtype", None)
        if as_numpy is not None and as_numpy.kind in "fiu":
            return _cells(column.to_numpy(dtype=as_numpy, na_value=0), column, name, present)
        return _cells(column.to_numpy(dtype=object), column, name, present, kind)

    def column(self, values: Any, nothing: int | None = None, words: Sequence[str] | None = None, are_few: bool = True) -> Any:
        if words is None:
            return values if nothing is None else self.library.arrays.IntegerArray(values, values == nothing)
        if are_few:
            return self.library.Categorical.from_codes(values, list(words))
        # One word more, as nothing is taken of nothing.
        texts = self.library.array([*words, ""], dtype="string" if self.library.__version__ < "3" else "str")
        return texts.take(values, allow_fill=True)

    def with_columns(self, columns: Mapping[str, Any]) -> Any:
        return self.data.assign(**columns)


class Polars(Columns):
    """A frame of polars."""

    def cells(self, name: str) -> Cells:
        column = self.data.get_column(name)
        present = column.is_not_null().to_numpy() if column.null_count() else None
        kind = column.dtype
        if kind.is_float() or kind.is_integer() and "128" not in str(kind):
            return _cells(column.fill_null(0).to_numpy(), column, name, present)
        if kind.is_numeric() or kind in (self.library.String, self.library.Categorical, self.library.Enum, self.library.Null):
            column = column.cast(self.library.String)
        elif kind != self.library.Object:
            raise _no_numbers(name, kind)
        return _cells(None, column, name, present)

    def column(self, values: Any, nothing: int | None = None, words: Sequence[str] | None = None, are_few: bool = True) -> Any:
        if nothing is None:
            return self.library.Series(values, nan_to_null=True)
        series = self.library.Series(values)
        series = series.set(series == nothing, None) if (values == nothing).any() else series
        if words is None:
            return series
        return self.library.Series(values=list(words), dtype=self.library.Enum(words) if are_few else self.library.String).gather(series)

    def with_columns(self, columns: Mapping[str, Any]) -> Any:
        return self.data.with_columns([column.alias(name) for name, column in columns.items()])


class Arrow(Columns):
    """A table or a batch of pyarrow."""

    def cells(self, name: str) -> Cells:
        from pyarrow import compute, types  # type: ignore[import-not-found, import-untyped, unused-ignore]

        column = self.data.column(name)
        if types.is_dictionary(column.type):
            column = column.cast(column.type.value_type)
        present = compute.is_valid(column).to_numpy(zero_copy_only=False) if column.null_count else None
        kind = column.type
        if types.is_floating(kind) or types.is_integer(kind):
            if present is not None:
                column = compute.fill_null(column, self.library.scalar(0, self.library.int8()).cast(kind))
            return _cells(column.to_numpy(zero_copy_only=False), column, name, present)
        if types.is_decimal(kind):
            column = column.cast(self.library.string())
        elif not (types.is_string(kind) or types.is_large_string(kind) or types.is_string_view(kind) or types.is_null(kind)):
            raise _no_numbers(name, kind)
        return _cells(None, column, name, present)

    def column(self, values: Any, nothing: int | None = None, words: Sequence[str] | None = None, are_few: bool = True) -> Any:
        if nothing is None:
            return self.library.array(values, self.library.float64(), from_pandas=True)
        mask = values == nothing
        codes = self.library.array(values, mask=mask if mask.any() else None)
        return codes if words is None else self.library.array(words, self.library.string()).take(codes)

    def with_columns(self, columns: Mapping[str, Any]) -> Any:
        schema = self.data.schema
        for name, column in columns.items():
            schema = schema.append(self.library.field(name, column.type))
        return type(self.data).from_arrays([*self.data.columns, *columns.values()], schema=schema)


def _no_numbers(name: str, kind: Any) -> CoupletError:
    return CoupletError(f"the column '{name}' is of {kind}, which is neither numbers nor texts")


def _cells(array: Any, values: Any, name: str, present: Any = None, kind: Any = None) -> Cells:
    """Cells of an array of numbers, or of values that are texts or exact numbers."""
    import numpy as np

    if array is not None:
        if array.dtype.kind == "f" and array.dtype.itemsize <= 8:
            return array.astype(np.float64, copy=False), present
        if array.dtype.kind in "iu":
            doubles = array.astype(np.float64)
            # Larger whole numbers may be rounded.
            if not array.size or -(2**53) <= int(array.min()) and int(array.max()) <= 2**53:
                return doubles, present
        elif array.dtype.kind not in "fOUT":
            raise _no_numbers(name, kind or array.dtype)
    given = listed(values)
    if present is None:
        present = np.fromiter((value is not None for value in given), bool, len(given))
        present = None if present.all() else present
    texts = []
    for row, value in enumerate(given):
        if present is not None and not present[row]:
            texts.append("")
            continue
        try:
            texts.append(value if type(value) is str else exact(value, f"cell of the column '{name}'"))
        except TypeError as error:
            raise CoupletError(f"{error} (row {row})") from None
    return texts, present
