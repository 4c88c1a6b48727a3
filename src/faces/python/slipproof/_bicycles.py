"""Verdicts on many answers about bicycles, from columns in memory."""

from __future__ import annotations

import json
from typing import Any, Dict, Iterator, List, Mapping, NamedTuple, Optional, Tuple

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import real, refuse_rounding, whole
from ._errors import wrong_type, wrong_value
from ._filter import MODES
from ._html import table
from ._progress import Progress, reporter
from ._result import Result
from ._scene import as_scene
from ._verdicts import Verdict

#: The names of verdicts by their codes in an array.
VERDICTS: Tuple[str, ...] = _core.record_verdicts
_FIELDS = frozenset(_core.record_fields)
_NO_MODE = 65535
_KINDS = ("internal", "external")


class BicycleVerdicts(Result):
    """Verdicts on all records, as arrays; ``verdicts[i]`` has all that is known about record i."""

    __slots__ = ("codes", "modes", "errors", "tiers", "summary", "_given", "_found", "_made")

    def __init__(self, given: Tuple[Any, ...], found: Tuple[Any, ...], made: "Optional[_core.RecordsInMemory]" = None):
        self._given, self._found, self._made = given, found, made
        self.codes: "npt.NDArray[np.uint8]" = found[0]
        """of each record the index of its verdict in VERDICTS"""
        self.modes: "npt.NDArray[np.uint16]" = found[1].astype(np.uint16)
        """the modes of the motion that the answer is, as bits"""
        self.errors: "npt.NDArray[np.float64]" = found[2]
        """an upper bound on the largest relative error of a component"""
        self.tiers: "npt.NDArray[np.uint8]" = found[3]
        """0 binary64 with error bounds, 1 exact arithmetic"""
        self.summary: Dict[str, Any] = json.loads(found[4])
        """counts, as ``slipproof certify --summary`` writes them"""

    def _parts(self) -> Tuple[Any, ...]:
        return self._given, self._found

    def __eq__(self, other: object) -> bool:
        return (isinstance(other, BicycleVerdicts) and self.summary == other.summary
                and all(np.array_equal(a, b, equal_nan=True) for a, b in zip(self._found[:4], other._found[:4])))

    def __hash__(self) -> int:
        return hash(self._found[4])

    @property
    def _records(self) -> "_core.RecordsInMemory":
        if self._made is None:
            self._made = _core.RecordsInMemory(*self._given)
        return self._made

    @property
    def verdicts(self) -> "npt.NDArray[np.str_]":
        """The verdict on each record, as a text."""
        return np.array(VERDICTS)[self.codes]

    def counts(self) -> Dict[str, int]:
        """How many records have each verdict."""
        return {name: int(n) for name, n in zip(VERDICTS, np.bincount(self.codes, minlength=len(VERDICTS))) if n}

    @property
    def certified(self) -> bool:
        """Whether there are records and all of them are certified."""
        return bool(self.codes.size and not self.codes.any())

    def __getitem__(self, record: int) -> Verdict:
        return Verdict(self._records.line(range(len(self))[record]))

    def __iter__(self) -> Iterator[Verdict]:
        return (self[i] for i in range(len(self)))

    def __len__(self) -> int:
        return int(self.codes.size)

    def __repr__(self) -> str:
        return f"<slipproof.BicycleVerdicts {', '.join(f'{n} {name}' for name, n in self.counts().items()) or 'none'}>"

    def _repr_html_(self) -> str:
        return table(["verdict", "records"], [[name, str(n)] for name, n in self.counts().items()])


class _Columns(NamedTuple):
    names: List[str]
    get: Any


def _columns(records: Any) -> _Columns:
    """The columns of a structured array, a mapping, or a frame."""
    if isinstance(records, np.ndarray):
        if records.dtype.names is None:
            raise TypeError(f"records: found an array of {records.dtype}, expected one with fields by name")
        if records.ndim != 1:
            raise wrong_value("records", f"shape {records.shape}", "1 dimension")
        return _Columns(list(records.dtype.names), lambda name: records[name])
    if isinstance(records, Mapping):
        return _Columns(list(records), lambda name: records[name])
    if hasattr(records, "columns") and hasattr(records, "__getitem__"):
        return _Columns(list(records.columns), lambda name: records[name])
    raise wrong_type("records", records, "a structured array, a dict of columns, or a frame")


def _numbers(name: str, value: Any) -> "npt.NDArray[np.float64]":
    """A column of float64; does not copy it if it is one, whatever its stride."""
    array = np.asarray(value)
    if array.dtype == np.float64 and array.dtype.isnative:
        return array
    refuse_rounding(name, array)
    return array.astype(np.float64)


def _codes(name: str, value: Any, names: Tuple[str, ...], none: Optional[int]) -> "npt.NDArray[np.uint16]":
    """Converts texts to their indices; `none` for records without a text."""
    array = np.asarray(value)
    if array.dtype == np.uint8:  # codes; 255 stands for none
        return np.where(array == 255, np.uint16(_NO_MODE), array.astype(np.uint16)) if none is not None else \
            array.astype(np.uint16)
    if array.dtype.kind == "f" and none is not None and np.isnan(array).all():  # an empty column of a frame
        return np.full(array.shape, none, dtype=np.uint16)
    if array.dtype.kind not in "USO":
        raise TypeError(f"{name}: found an array of {array.dtype}, expected texts such as {names[0]!r}")
    known: Dict[Any, int] = {text: i for i, text in enumerate(names)}
    if none is not None:
        known.update({"": none, None: none})
    codes = np.empty(array.shape, dtype=np.uint16)
    texts, places = np.unique(array.astype(str) if array.dtype.kind == "U" else _as_texts(array), return_inverse=True)
    for i, text in enumerate(texts):
        if text not in known:
            raise wrong_value(name, repr(str(text)), f"one of {', '.join(names)}")
        codes.reshape(-1)[places == i] = known[text]
    return codes


def _as_texts(array: "npt.NDArray[Any]") -> "npt.NDArray[np.str_]":
    def text(x: Any) -> str:
        missing = x is None or (isinstance(x, float) and x != x)  # NaN stands for a missing value in frames
        return "" if missing else x.decode("utf-8", "replace") if isinstance(x, bytes) else str(x)

    return np.array([text(x) for x in array.reshape(-1)], dtype=str)


def certify_bicycles(records: Any, *, scene: Any = None, ignore_unknown: bool = False, tolerance: float = 1e-9,
                     effort: Optional[int] = None, threads: int = 0, progress: Progress = None) -> BicycleVerdicts:
    """Is each answer about a bicycle the one motion that there is?

    ``records``: a structured array, a dict of columns, or a frame of pandas. Its names are those of ``slipproof
    certify``: the scene's numbers, in SI units, and for the answer ``a``, ``S2``, ``S3``, ``N2``, ``N3``, optionally ``mode`` and
    others. A value that is the same for all records may be one number, or come from ``scene``. Columns of float64 are
    not copied, whatever their strides. A NaN makes an answer ``invalid``. ``tolerance``: the largest relative error of a
    component that is certified. ``ignore_unknown`` skips columns with other names. ``effort`` limits the work on one
    answer, in operations on words. ``threads``: 0 for all cores. ``progress``: a function of (done, all), or True. Raises
    TypeError and ValueError for columns that cannot be used, FileNotFoundError, InputError.

    >>> import slipproof
    >>> found = slipproof.certify_bicycles(dict(F=[3.27, 3.2], mode=["stick/stick", "stick/slip+"],
    ...     a=[2.9727272727272727, 3], S2=[3.1213636363636363, 3.05], S3=[-0.14863636363636363, -0.05],
    ...     N2=[9.642784090909091, 9.75], N3=[0.16721590909090908, 0.06]), scene="cases/ambiguous.toml")
    >>> list(found.verdicts), found[1].violated
    (['ambiguous', 'wrong'], 'N3 >= 0')
    """
    columns = _columns(records)
    given: Dict[str, Any] = {}
    for name in columns.names:
        if not isinstance(name, str):
            raise wrong_type("the name of a column", name, "str")
        if name == "mode":
            given[name] = _codes(name, columns.get(name), MODES, _NO_MODE)
        elif name == "kind":
            given[name] = _codes(name, columns.get(name), _KINDS, None).astype(np.float64)
        elif name in _FIELDS:
            given[name] = _numbers(name, columns.get(name))
        elif not ignore_unknown:
            raise wrong_value("records", f"the column {name!r}", f"one of {', '.join(sorted(_FIELDS))}, mode, kind")
    size = _size(given)
    scene_text = None if scene is None else as_scene(scene, {})._source()[0]
    made_of = (given, size, scene_text, real("tolerance", tolerance, 0, 1),
               None if effort is None else whole("effort", effort, 1, 2**63))
    judged = _core.RecordsInMemory(*made_of)
    return BicycleVerdicts(made_of, judged.certify(whole("threads", threads, 0, 4096), reporter(progress)), judged)


def _size(columns: Mapping[str, "npt.NDArray[Any]"]) -> int:
    """How many records there are."""
    size, of = 1, ""
    for name, column in columns.items():
        if column.ndim > 1:
            raise wrong_value(name, f"shape {column.shape}", "1 dimension")
        if column.size == 1 or (of and column.size == size):
            continue
        if of:
            raise wrong_value(name, f"{column.size} values", f"{size} as in {of}, or 1")
        size, of = column.size, name
    return size
