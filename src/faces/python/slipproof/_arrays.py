"""Checks arrays of numbers before they are used. Their numbers are binary64, taken exactly."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Optional, Tuple

import numpy as np
import numpy.typing as npt

from . import _core
from ._errors import wrong_type, wrong_value
from ._numbers import ratio, text_of

Doubles = npt.NDArray[np.float64]
Array = npt.NDArray[Any]  # of float64, or of Fractions
_TOO_LARGE = 2**1023
_LARGEST = 2**53  # all integers up to it are binary64 numbers


def refuse_rounding(name: str, array: "npt.NDArray[Any]") -> None:
    """Raises unless each of its numbers is a float64."""
    kind = array.dtype.kind
    if kind not in "fiu" or array.dtype.itemsize > 8:
        raise TypeError(f"{name}: found an array of {array.dtype}, expected numbers that are float64 without rounding")
    if kind in "iu" and array.dtype.itemsize == 8 and array.size and (array.max() > _LARGEST or array.min() < -_LARGEST):
        raise wrong_value(name, "integers beyond 2**53", "numbers that are float64 without rounding")


def doubles(name: str, value: Any, dimensions: Tuple[int, ...]) -> Doubles:
    """An array with one of these numbers of dimensions, contiguous by rows; not copied if it is one already."""
    if isinstance(value, np.ma.MaskedArray):
        raise wrong_type(name, value, "an array without a mask")
    try:
        array = np.asarray(value)
    except ValueError:
        raise wrong_value(name, "rows of different lengths", "numbers in rows of one length") from None
    if array.ndim not in dimensions:
        expected = " or ".join(f"{d} dimension{'s' * (d != 1)}" for d in dimensions)
        raise wrong_value(name, f"shape {array.shape}", expected)
    refuse_rounding(name, array)
    # ascontiguousarray turns a scalar into a vector
    return np.ascontiguousarray(array, dtype=np.float64).reshape(array.shape)


def _is_exact(array: Array) -> bool:
    """Whether there are numbers in it that may not be float64."""
    if array.dtype.kind in "iu":
        return array.size > 0 and (int(array.max()) > _LARGEST or int(array.min()) < -_LARGEST)
    return array.dtype.kind in "OU"


def numbers(name: str, value: Any, dimensions: Tuple[int, ...]) -> Array:
    """doubles(), or, if there are Fractions, Decimals, texts or large integers, an array of Fractions."""
    if isinstance(value, np.ma.MaskedArray):
        return doubles(name, value, dimensions)
    try:
        array = np.asarray(value)
    except ValueError:
        return doubles(name, value, dimensions)
    if not _is_exact(array):
        return doubles(name, value, dimensions)
    array = np.asarray(value, dtype=object)  # texts leave floats beside them as they are
    if array.ndim not in dimensions:
        return doubles(name, np.zeros(array.shape), dimensions)
    found = np.empty(array.shape, dtype=object)
    for place in np.ndindex(array.shape):
        where = f"{name}{list(place)}" if place else name
        try:
            found[place] = ratio(_core.exact(text_of(array[place], where)))
        except ValueError as error:
            message = str(error)
            raise ValueError(message if message.startswith(where) else f"{where}: {message}") from None
    return found


def rounded_nowhere(name: str, array: Array) -> Doubles:
    """The same numbers as float64. Raises ValueError if one is none."""
    if array.dtype != object:
        return array
    for place in np.ndindex(array.shape):
        x = array[place]
        if abs(x) > _TOO_LARGE or Fraction(float(x)) != x:
            raise wrong_value(f"{name}{list(place)}", x, "a float64 without rounding, where not every solution is looked for "
                              "in exact arithmetic")
    return array.astype(np.float64)


def texts(array: Array) -> Any:
    """What the library takes: the array of float64 itself, or a list of texts."""
    return array if array.dtype != object else [text_of(x, "") for x in array.reshape(-1)]


def shaped(name: str, value: Any, shape: Tuple[int, ...], why: str) -> Array:
    """numbers() in one shape."""
    array = numbers(name, value, (len(shape),))
    if array.shape != shape:
        raise wrong_value(name, f"shape {array.shape}", f"{shape} {why}")
    return array


def whole(name: str, value: Any, low: int, high: Optional[int] = None) -> int:
    """A whole number in a range."""
    if isinstance(value, (bool, np.bool_)) or not hasattr(value, "__index__"):
        raise wrong_type(name, value, "a whole number")
    number = int(value.__index__())
    if number < low or (high is not None and number > high):
        raise wrong_value(name, number, f"a whole number from {low}" + (f" to {high}" if high is not None else ""))
    return number


def real(name: str, value: Any, low: float, high: float) -> float:
    """A float in a range."""
    if isinstance(value, (bool, np.bool_, str)) or not hasattr(value, "__float__"):
        raise wrong_type(name, value, "a number")
    number = float(value)
    if not low <= number <= high:
        raise wrong_value(name, number, f"a number from {low:g} to {high:g}")
    return number


def one_of(name: str, value: Any, choices: Tuple[str, ...]) -> str:
    """One of some texts."""
    if not isinstance(value, str):
        raise wrong_type(name, value, " or ".join(repr(c) for c in choices))
    if value not in choices:
        raise wrong_value(name, repr(value), " or ".join(repr(c) for c in choices))
    return value


def is_sparse(W: Any) -> bool:
    return hasattr(W, "tocsr")


def sparse_rows(W: Any, size: int) -> Tuple[Any, ...]:
    """(indptr, indices, data) of a SciPy matrix, or of an object with the same members; sums duplicate entries."""
    csr = W.tocsr()
    if tuple(csr.shape) != (size, size):
        raise wrong_value("W", f"shape {tuple(csr.shape)}", f"{(size, size)} as q has {size} components")
    if hasattr(csr, "sum_duplicates"):
        csr = csr.copy() if csr is W else csr
        csr.sum_duplicates()
    data = doubles("W.data", csr.data, (1,))
    starts, columns = (np.ascontiguousarray(x, dtype=np.int64) for x in (csr.indptr, csr.indices))
    monotone = starts.shape == (size + 1,) and starts[0] == 0 and starts[-1] == data.size and (np.diff(starts) >= 0).all()
    if not monotone or columns.shape != data.shape or (columns.size and not 0 <= columns.min() <= columns.max() < size):
        raise wrong_value("W", "indptr and indices that do not fit each other", "rows as SciPy's csr_matrix has them")
    return starts, columns, data


def refuse_infinite(name: str, array: Optional[Array]) -> None:
    if array is None or array.dtype == object or np.isfinite(array).all():
        return
    place = tuple(int(i) for i in np.argwhere(~np.isfinite(array))[0])
    raise wrong_value(f"{name}{list(place)}", array[place], "a finite number")
