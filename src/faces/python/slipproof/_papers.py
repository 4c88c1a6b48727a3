"""Claims of papers, proofs and certificates."""

from __future__ import annotations

import json
import os
import re
from fractions import Fraction
from pathlib import Path
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

from . import _core
from ._arrays import whole
from ._certify import _file
from ._errors import InputError, wrong_type
from ._html import table
from ._numbers import Values
from ._progress import Progress, reporter
from ._result import Report, Result
from ._scene import as_claims

_Path = Union[str, "os.PathLike[str]"]
_COMPARISON = re.compile("[<>=]")


class ClaimVerdict(Result):
    """One claim in one reading: ``id``, ``reading``, ``origin`` (printed or ours), ``verdict``, ``expected``; ``details``
    has everything else."""

    __slots__ = ("id", "reading", "origin", "verdict", "expected", "details")

    def __init__(self, details: Mapping[str, Any]):
        self.id: str = details["id"]
        self.reading: str = details["reading"]
        self.origin: str = details["origin"]
        self.verdict: str = details["verdict"]
        self.expected: Optional[str] = details.get("expected")
        self.details = details

    def _parts(self) -> Tuple[Any, ...]:
        return (self.details,)

    @property
    def counterexample(self) -> Optional[Mapping[str, Any]]:
        """The counterexample, as in the program's JSON; None if there is none."""
        return self.details.get("counterexample")

    def __repr__(self) -> str:
        return f"<slipproof.ClaimVerdict {self.id} {self.reading}: {self.verdict}>"


class Verification(Report, Sequence[ClaimVerdict]):
    """The verdicts on all claims of a paper. ``summary``: VERIFIED, REFUTED, UNDECIDED or REJECTED."""

    def __init__(self, document: str, text: str, summary: str):
        super().__init__(document, text)
        self.summary = summary
        self._claims = tuple(ClaimVerdict(c) for c in json.loads(document)["claims"])

    def _parts(self) -> Tuple[Any, ...]:
        return self._json, self._text, self.summary

    def __getitem__(self, index: Any) -> Any:
        return self._claims[index]

    def __len__(self) -> int:
        return len(self._claims)

    def find(self, id: str, reading: str = "printed") -> ClaimVerdict:
        """The claim with this ``id`` in this ``reading``, printed or repaired. Raises KeyError."""
        for claim in self:
            if claim.id == id and claim.reading == reading:
                return claim
        raise KeyError(f"found no claim {id} ({reading})")

    def __repr__(self) -> str:
        return f"<slipproof.Verification {self._text.rstrip().splitlines()[-1]}>"

    def _repr_html_(self) -> str:
        return table(["claim", "reading", "verdict"], [[c.id, c.origin if c.reading == "printed" else c.reading, c.verdict] for c in self], self.summary)


_CLAIMS = "claims.toml"  # from whose folder a text counts its paths: the present one


def _claims(claims: Any) -> Tuple[bytes, Optional[bytes]]:
    """The path of claims, and their text where they come from no file."""
    if isinstance(claims, str) and "\n" in claims:
        return _CLAIMS.encode(), claims.encode("utf-8", "surrogateescape")
    return _file("claims", claims), None


def verify(claims: Union[_Path, Mapping[str, Any]], *, samples: int = 10_000, lines: Optional[int] = None, seed: int = 1, only: str = "",
           threads: int = 0, progress: Progress = None) -> Verification:
    """Judges the claims of a paper: at samples, along lines, and by certificates.

    ``claims`` is a file ``slipproof/claims/1``, its text, or a dict with its tables (``schema`` may be left out); a text
    and a dict have no certificates, and count paths from the present folder. ``samples``: points for each setting;
    ``lines``: lines of samples for each claim, by default one for 200 samples; ``seed`` of the samples. ``only``: judge
    only claims whose id begins with this. ``threads``: 0 for all cores; the result does not depend on it. ``progress``: a
    function of (done, all), or True. Raises InputError, and FileNotFoundError if there is no such file.
    """
    if isinstance(claims, Mapping):
        toml = as_claims({"schema": "slipproof/claims/1", **claims})
        try:
            return verify(toml.text, samples=samples, lines=lines, seed=seed, only=only, threads=threads, progress=progress)
        except InputError as error:
            raise InputError([(toml.place(d.line) or _CLAIMS, 0, 0, d.message) if d.file == _CLAIMS else d
                              for d in error.diagnostics]) from None
    if not isinstance(only, str):
        raise wrong_type("only", only, "str")
    return Verification(*_core.verify(*_claims(claims), whole("samples", samples, 1, 1_000_000_000),
                                      None if lines is None else whole("lines", lines, 0, 1_000_000),
                                      whole("seed", seed, 0, 2**64 - 1), only, whole("threads", threads, 0, 4096),
                                      reporter(progress)))


class Proof(Result):
    """The result of a search for a proof: ``verdict`` is ``proved``, ``refuted`` or ``undecided``."""

    __slots__ = ("theorem", "verdict", "certificate", "counterexample", "statement", "details")

    def __init__(self, details: Mapping[str, Any]):
        self.theorem: str = details["theorem"]
        self.verdict: str = details["verdict"]
        self.certificate: Optional[str] = details["certificate"] or None
        self.counterexample: Values[Fraction] = Values(details["counterexample"])
        self.statement: str = details["statement"]
        self.details = details

    def _parts(self) -> Tuple[Any, ...]:
        return (self.details,)

    @property
    def proved(self) -> bool:
        """Whether there is a certificate."""
        return self.verdict == "proved"

    def __bool__(self) -> bool:
        return self.proved

    def __repr__(self) -> str:
        return f"<slipproof.Proof {self.theorem}: {self.verdict}>"


def prove(statement: _Path, *, effort: int = 100_000_000, progress: Progress = None) -> Proof:
    """Searches for a proof of a statement for all parameters, and for numbers at which it is false.

    ``statement`` is a formula for all real values of its variables; or the text of a statement, if it has more than one
    line; or a statement's file. The language is described in proofs/FORMAT.md. ``effort`` limits the steps of polynomial
    arithmetic. ``progress``: a function of (done, all), or True. Writes no files. Raises InputError, and
    FileNotFoundError if there is no such file.

    >>> import slipproof
    >>> slipproof.prove("x^2 + y^2 >= 2*x*y")
    <slipproof.Proof formula: proved>
    >>> slipproof.prove("x^2 > 2*x").counterexample
    {x: 1}
    >>> slipproof.prove('''slipproof-statement 1
    ... theorem means
    ... real x y
    ... assume positive: x > 0 and y > 0
    ... show (x + y)/2 >= 2/(1/x + 1/y)
    ... ''')
    <slipproof.Proof means: proved>
    """
    file: Optional[bytes] = b"statement"
    if isinstance(statement, str) and ("\n" in statement or _COMPARISON.search(statement)):
        text = statement.encode("utf-8", "surrogateescape")
        if "\n" not in statement:
            file = None
    else:
        file = _file("statement", statement)
        text = Path(os.fsdecode(file)).read_bytes()
    return Proof(_core.prove(file, text, whole("effort", effort, 1, 10**12), reporter(progress)))


class CheckedCertificate(NamedTuple):
    """A certificate, and what the checker says about it."""

    certificate: str
    verdict: str
    theorem: str
    message: str


class Check(Result, Sequence[CheckedCertificate]):
    """What the checker says about certificates."""

    def __init__(self, results: Sequence[Tuple[str, str, str, str]], text: str, summary: str):
        self._results = tuple(CheckedCertificate(*r) for r in results)
        self._text, self._summary = text, summary

    def _parts(self) -> Tuple[Any, ...]:
        return self._results, self._text, self._summary

    def __getitem__(self, index: Any) -> Any:
        return self._results[index]

    def __len__(self) -> int:
        return len(self._results)

    @property
    def accepted(self) -> bool:
        """Whether there are certificates and all of them are accepted."""
        return len(self) > 0 and all(r.verdict == "accepted" for r in self)

    def text(self) -> str:
        """What ``slipproof check`` prints."""
        return self._text + self._summary

    def __repr__(self) -> str:
        return f"<slipproof.Check {self._summary.strip()}>"


def check(*paths: _Path) -> Check:
    """Checks certificates: ``paths`` are their files, statements, theorem files, or folders of them. Errors in one are
    reported, not raised. Raises FileNotFoundError if one is not there."""
    if not paths:
        raise wrong_type("paths", None, "at least one certificate, statement or folder")
    return Check(*_core.check([_file("paths", p) for p in paths]))
