"""Verdicts on answers: values that are made from the library's lines of output."""

from __future__ import annotations

import json
from typing import Any, Dict, Iterator, List, Optional, Sequence, Tuple, Union, overload

import numpy as np
import numpy.typing as npt

from . import _core
from ._html import table
from ._result import Result

_CERTIFIED = (
    "certified",
    "solution within rho",
    "unique",
    "velocities within rho",
    "velocities of a solution within rho",
)

#: The words of verdicts on answers to contact problems at real size.
CONTACT_VERDICTS: Tuple[str, ...] = _core.contact_verdicts


class _Kept:
    """What the library says about answers, as texts: in the place of its own object in a copy or a pickle."""

    def __init__(self, answers: Sequence[Tuple[str, str, str, str, str]]):
        self._answers = tuple(answers)

    @classmethod
    def of(cls, judged: "_Judged", places: Sequence[int]) -> "_Kept":
        return cls([(judged.line(i), judged.words(i), judged.refined(i), judged.certificate(i), judged.report(_COMMAND))
                    for i in places])

    def __len__(self) -> int:
        return len(self._answers)

    def line(self, answer: int) -> str:
        return self._answers[answer][0]

    def words(self, answer: int) -> str:
        return self._answers[answer][1]

    def refined(self, answer: int) -> str:
        return self._answers[answer][2]

    def certificate(self, answer: int) -> str:
        return self._answers[answer][3]

    def report(self, command: str) -> str:
        return self._answers[0][4]


_Judged = Union["_core.Judged", _Kept]
_COMMAND = "slipproof.certify(...).report()"


class Verdict(Result):
    """What is proved about one answer: ``verdict`` is a word, ``details`` has everything that the program reports.

    The members of ``details`` are also attributes: ``verdict.rho``, ``verdict.modes``, ...
    """

    __slots__ = ("verdict", "details", "_judged", "_index")

    def __init__(self, line: str, judged: "Optional[_Judged]" = None, index: int = 0):
        self.details: Dict[str, Any] = json.loads(line)
        self.verdict: str = self.details["verdict"]
        self._judged, self._index = judged, index

    def _parts(self) -> Tuple[Any, ...]:
        return json.dumps(self.details), self._judged and _Kept.of(self._judged, [self._index]), 0

    @property
    def certified(self) -> bool:
        """Whether the verdict is one of the best that an answer can get."""
        return self.verdict in _CERTIFIED

    @property
    def only(self) -> bool:
        """Whether the answer is certified, and it is proved that there is no other solution."""
        return self.certified and "others" not in self.details

    @property
    def solutions(self) -> Any:
        """All solutions, where they were asked for and it is proved that there are no others: a dict for each, then one for
        each continuum of them, with forces ``z`` (``nearest_z``) and velocities ``w``, exact or in ranges; where some stay
        open ``left_out`` says so, and there is no list. Of a problem in exact numbers how many there are."""
        found = self.details.get("all", {})
        if "found" in found:
            return found["found"] + found.get("continua", [])
        if "solutions" not in self.details:
            raise AttributeError(f"this verdict has no solutions; it has {', '.join(self.details)}")
        return self.details["solutions"]

    def to_dict(self) -> Dict[str, Any]:
        """The output line of ``slipproof certify``, as a dict."""
        return dict(self.details)

    def words(self) -> str:
        """The verdict in words if the problem was judged at real size; otherwise as JSON."""
        return self._judged.words(self._index) if self._judged else json.dumps(self.details, ensure_ascii=False)

    def refined(self) -> Optional[Dict[str, Any]]:
        """The improved answer, with a radius for each number; None if no solution is enclosed."""
        text = self._judged.refined(self._index) if self._judged else ""
        return json.loads(text) if text else None

    def certificate(self) -> Optional[str]:
        """The certificate that ``slipproof-check-contact`` checks; None if nothing is proved that has one."""
        return (self._judged.certificate(self._index) if self._judged else "") or None

    def report(self) -> Optional[str]:
        """An HTML page with the contacts in their cones; None for a problem that was judged in exact numbers."""
        return self._judged.report(_COMMAND) if self._judged else None

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self.details[name]
        except KeyError:
            raise AttributeError(f"this verdict has no {name}; it has {', '.join(self.details)}") from None

    def __bool__(self) -> bool:
        return self.certified

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Verdict) and self.details == other.details

    def __hash__(self) -> int:
        return hash(self.verdict)

    def __repr__(self) -> str:
        return f"<slipproof.Verdict {self.verdict}>"

    def _repr_html_(self) -> str:
        return table(["", ""], [[key, str(value)] for key, value in self.details.items()])


class Verdicts(Result, Sequence[Verdict]):
    """Verdicts on many answers, each made when it is accessed. If a file was read, ``summary`` has counts."""

    def __init__(self, lines: List[str], summary: Optional[Dict[str, Any]] = None):
        self._lines = lines
        self.summary = summary

    def _parts(self) -> Tuple[Any, ...]:
        return self._lines, self.summary

    @property
    def verdicts(self) -> "npt.NDArray[np.str_]":
        """The verdict on each answer, as a text."""
        return np.array([v.verdict for v in self], dtype=str)

    @overload
    def __getitem__(self, index: int) -> Verdict: ...

    @overload
    def __getitem__(self, index: slice) -> "Verdicts": ...

    def __getitem__(self, index: Union[int, slice]) -> Union[Verdict, "Verdicts"]:
        if isinstance(index, slice):
            return Verdicts(self._lines[index])
        return Verdict(self._lines[index])

    def __len__(self) -> int:
        return len(self._lines)

    def __iter__(self) -> Iterator[Verdict]:
        return map(Verdict, self._lines)

    def counts(self) -> Dict[str, int]:
        """How many answers have each verdict."""
        found: Dict[str, int] = {}
        for verdict in self:
            found[verdict.verdict] = found.get(verdict.verdict, 0) + 1
        return found

    @property
    def certified(self) -> bool:
        """Whether there are answers and all of them are certified."""
        return len(self) > 0 and all(v.certified for v in self)

    def __repr__(self) -> str:
        counts = ", ".join(f"{count} {verdict}" for verdict, count in self.counts().items())
        return f"<slipproof.Verdicts {counts or 'none'}>"

    def _repr_html_(self) -> str:
        return table(["verdict", "answers"], [[verdict, str(count)] for verdict, count in self.counts().items()])


class BatchVerdicts(Verdicts):
    """Verdicts on many problems of one size that were judged at real size, as arrays: ``codes`` has the index of each
    verdict in CONTACT_VERDICTS, ``rho`` within which a solution is (NaN where none is known), ``backward_error`` (NaN of an
    invalid answer)."""

    def __init__(self, codes: "npt.NDArray[np.uint8]", rho: "npt.NDArray[np.float64]",
                 backward_error: "npt.NDArray[np.float64]", lines: List[str]):
        super().__init__(lines)
        self.codes, self.rho, self.backward_error = codes, rho, backward_error

    def _parts(self) -> Tuple[Any, ...]:
        return self.codes, self.rho, self.backward_error, self._lines

    def __eq__(self, other: object) -> bool:
        return isinstance(other, BatchVerdicts) and self._lines == other._lines

    def __hash__(self) -> int:
        return hash(tuple(self._lines))

    @property
    def verdicts(self) -> "npt.NDArray[np.str_]":
        """The verdict on each answer, as a text."""
        return np.array(CONTACT_VERDICTS)[self.codes]

    def counts(self) -> Dict[str, int]:
        """How many answers have each verdict."""
        counts = np.bincount(self.codes, minlength=len(CONTACT_VERDICTS))
        return {name: int(n) for name, n in zip(CONTACT_VERDICTS, counts) if n}

    @property
    def certified(self) -> bool:
        """Whether there are answers and all of them are certified."""
        return len(self) > 0 and set(self.counts()) <= set(_CERTIFIED)


class JudgedVerdicts(Verdicts):
    """Verdicts on one problem at real size; they have more details than their lines of output."""

    def __init__(self, judged: "_Judged"):
        super().__init__([judged.line(i) for i in range(len(judged))])
        self._judged = judged

    def _parts(self) -> Tuple[Any, ...]:
        return (_Kept.of(self._judged, range(len(self))),)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, JudgedVerdicts) and self._lines == other._lines

    def __hash__(self) -> int:
        return hash(tuple(self._lines))

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return super().__getitem__(index)
        place = range(len(self))[index]
        return Verdict(self._lines[place], self._judged, place)

    def __iter__(self) -> Iterator[Verdict]:
        return (self[i] for i in range(len(self)))
