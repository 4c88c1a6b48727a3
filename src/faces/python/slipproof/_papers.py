"""Claims of papers, proofs and certificates."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

from . import _core
from ._arrays import whole
from ._certify import _path
from ._document import Report
from ._errors import wrong_type
from ._html import table
from ._numbers import Values
from ._progress import Progress, reporter

_Path = Union[str, "os.PathLike[str]"]


class ClaimVerdict:
    """One claim in one reading: ``id``, ``reading``, ``verdict``, ``expected``; ``details`` has everything else."""

    __slots__ = ("id", "reading", "verdict", "expected", "details")

    def __init__(self, details: Mapping[str, Any]):
        self.id: str = details["id"]
        self.reading: str = details["reading"]
        self.verdict: str = details["verdict"]
        self.expected: Optional[str] = details.get("expected")
        self.details = details

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

    def __getitem__(self, index: Any) -> Any:
        return self._claims[index]

    def __len__(self) -> int:
        return len(self._claims)

    def find(self, id: str, reading: str = "printed") -> ClaimVerdict:
        """The claim with this id; raises KeyError."""
        for claim in self:
            if claim.id == id and claim.reading == reading:
                return claim
        raise KeyError(f"found no claim {id} ({reading})")

    def __repr__(self) -> str:
        return f"<slipproof.Verification {self._text.rstrip().splitlines()[-1]}>"

    def _repr_html_(self) -> str:
        return table(["claim", "reading", "verdict"], [[c.id, c.reading, c.verdict] for c in self], self.summary)


def verify(claims: _Path, *, samples: int = 10_000, lines: Optional[int] = None, seed: int = 1, only: str = "",
           threads: int = 0, progress: Progress = None) -> Verification:
    """Judges the claims of a paper, a file ``slipproof/claims/1``: at samples, along lines, and by certificates.

    ``only``: judge only claims whose id begins with this. The result does not depend on the number of threads. Raises
    InputError.
    """
    if not isinstance(only, str):
        raise wrong_type("only", only, "str")
    return Verification(*_core.verify(_path("claims", claims), whole("samples", samples, 1, 1_000_000_000),
                                      None if lines is None else whole("lines", lines, 0, 1_000_000),
                                      whole("seed", seed, 0, 2**64 - 1), only, whole("threads", threads, 0, 4096),
                                      reporter(progress)))


class Proof:
    """The result of a search for a proof: ``verdict`` is ``proved``, ``refuted`` or ``undecided``."""

    __slots__ = ("theorem", "verdict", "certificate", "counterexample", "details")

    def __init__(self, details: Mapping[str, Any]):
        self.theorem: str = details["theorem"]
        self.verdict: str = details["verdict"]
        self.certificate: Optional[str] = details["certificate"] or None
        self.counterexample = Values(details["counterexample"])
        self.details = details

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

    ``statement`` is a file, or, if it has more than one line, the text itself. Writes no files. Raises InputError.

    >>> import slipproof
    >>> slipproof.prove('''slipproof-statement 1
    ... theorem means
    ... real x y
    ... assume positive: x > 0 and y > 0
    ... show (x + y)/2 >= 2/(1/x + 1/y)
    ... ''')
    <slipproof.Proof means: proved>
    """
    if isinstance(statement, str) and "\n" in statement:
        file, text = b"statement", statement.encode("utf-8", "surrogateescape")
    else:
        file = _path("statement", statement)
        text = Path(os.fsdecode(file)).read_bytes()
    return Proof(_core.prove(file, text, whole("effort", effort, 1, 10**12), reporter(progress)))


class CheckedCertificate(NamedTuple):
    """A certificate, and what the checker says about it."""

    certificate: str
    verdict: str
    theorem: str
    message: str


class Check(Sequence[CheckedCertificate]):
    """What the checker says about certificates."""

    def __init__(self, results: List[Tuple[str, str, str, str]], text: str, summary: str):
        self._results = tuple(CheckedCertificate(*r) for r in results)
        self._text, self._summary = text, summary

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
    """Checks certificates: files, statements, or folders of them. Errors in one are reported, not raised."""
    if not paths:
        raise wrong_type("paths", None, "at least one certificate, statement or folder")
    return Check(*_core.check([_path("paths", p) for p in paths]))
