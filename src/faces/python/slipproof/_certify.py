"""Verdicts about solvers' answers."""

from __future__ import annotations

import json
import os
from typing import Any, Callable, Dict, Iterator, List, Optional, Sequence, Tuple, Union, overload

import numpy as np

from . import _core
from ._arrays import Doubles, doubles, one_of, real, shaped, whole
from ._errors import wrong_type, wrong_value
from ._html import table
from ._progress import Progress, reporter

#: Sizes up to which every solution of a problem is looked for in exact arithmetic, unless the caller wants otherwise.
EXACT_UP_TO = 64
_EFFORT = 1_500_000_000
_CERTIFIED = (
    "certified",
    "solution within rho",
    "unique",
    "velocities within rho",
    "velocities of a solution within rho",
)
_LAWS = tuple(_core.law_words())


class Verdict:
    """What is proved about one answer: ``verdict`` is a word, ``details`` has everything that the program reports.

    The members of ``details`` are also attributes: ``verdict.rho``, ``verdict.modes``, ...
    """

    __slots__ = ("verdict", "details", "_judged", "_index")

    def __init__(self, line: str, judged: "Optional[_core.Judged]" = None, index: int = 0):
        self.details: Dict[str, Any] = json.loads(line)
        self.verdict: str = self.details["verdict"]
        self._judged, self._index = judged, index

    @property
    def certified(self) -> bool:
        """Whether the verdict is one of the best that an answer can get."""
        return self.verdict in _CERTIFIED

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
        return self._judged.report("slipproof.certify(...).report()") if self._judged else None

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


class Verdicts(Sequence[Verdict]):
    """Verdicts on many answers, each made when it is accessed. If a file was read, ``summary`` has counts."""

    def __init__(self, lines: List[str], summary: Optional[Dict[str, Any]] = None):
        self._lines = lines
        self.summary = summary

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


def _is_sparse(W: Any) -> bool:
    return hasattr(W, "tocsr")


def _sparse(W: Any, size: int) -> Tuple[Any, ...]:
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


def _contacts(mu: Any, shape: Tuple[int, ...], dimension: Optional[int]) -> Tuple[int, Optional[Doubles]]:
    """The dimension of the contacts, and a coefficient for each; a single number is for all contacts."""
    if mu is None:
        if dimension in (2, 3):
            raise wrong_value("mu", "None", f"the coefficients of friction of contacts in dimension {dimension}")
        return 1, None
    if dimension == 1:
        raise wrong_value("mu", "coefficients of friction", "none in dimension 1, a complementarity problem")
    array = doubles("mu", mu, (0, 1) if len(shape) == 1 else (0, 1, 2))
    size = shape[-1]
    contacts = None if array.ndim == 0 else array.shape[-1]
    each = dimension or _core.dimension_by_sizes(size, contacts)
    if size % each or contacts not in (None, size // each):
        raise wrong_value("mu", "one number" if contacts is None else f"{contacts} coefficients",
                          f"{each} components of q for each contact, which has {size}")
    if array.ndim == 0:
        return each, np.full((*shape[:-1], size // each), float(array))
    if array.ndim == 1 and len(shape) == 2:
        return each, np.ascontiguousarray(np.broadcast_to(array, (shape[0], array.size)))
    return each, array


def certify(W: Any, q: Any, z: Any = None, mu: Any = None, *, w: Any = None, dimension: Optional[int] = None,
            tolerance: Optional[float] = None, law: str = "cone", bounds: Any = None, compliance: Any = None,
            bias: Any = None, slip_speed: Optional[float] = None, function: str = "linear", refine: bool = False,
            within: Optional[float] = None, method: str = "auto", effort: Optional[int] = None, threads: int = 0,
            progress: Progress = None) -> Union[Verdict, Verdicts]:
    """Is z an answer to the contact problem w = W z + q, and the only one?

    Without ``mu`` this is a linear complementarity problem: z >= 0, w >= 0, z . w = 0. With ``mu`` the contacts have
    friction: ``mu`` is one number, or one for each contact; z has the forces of each contact, (N, T) in the plane or
    (N, T1, T2) in space. ``dimension`` is 2 or 3; it is required if the sizes do not determine it (one ``mu``, and a
    multiple of 6 components). ``W`` is an array of shape (n, n), or a sparse matrix of SciPy; ``q``, ``z`` and the
    optional ``w`` have n components. Arrays of shapes (k, n, n) and (k, n) are k problems and give k verdicts. A NaN or
    an infinity in z makes the answer ``invalid``.

    ``method``: ``exact`` finds every solution of an LCP or a planar problem with up to 64 components, in exact
    arithmetic (``certified``, ``ambiguous``, ``inaccurate``, ``wrong``); ``enclosure`` proves what it can at any size
    (``unique``, ``solution within rho``, ``inaccurate``, ``eps-solution``, ``wrong``, ...). ``auto`` uses ``exact`` if
    it can. ``tolerance`` (default 1e-6) limits the distance from a solution: forces are divided by the largest force,
    velocities by the largest velocity. If ``enclosure`` finds no solution, it limits the backward error. ``refine``:
    search for a solution, also without z. ``within``: the radius in which a solution is near: with one there an answer
    whose backward error is above the tolerance is ``not converged``, without one it is wrong. ``effort`` limits the work
    on one answer, in operations on words.

    ``law`` is what the solver solves: ``cone`` (or ``coulomb``), the pyramids ``box`` and ``diamond``, ``fixed`` with
    ``bounds`` of the tangential components, ``associated``, ``regularised`` with ``slip_speed`` and ``function``
    (``linear`` or ``soft``). ``compliance`` and ``bias``, numbers or arrays like q, are what it adds to w: R z and b.
    Where anything differs from Coulomb's law, ``details["coulomb"]`` judges the same forces by that.

    Raises TypeError and ValueError for arrays that do not fit, InputError for numbers that no problem can have.

    >>> import slipproof
    >>> slipproof.certify([[2, 1], [1, 2]], [-5, -6], [4/3, 7/3]).verdict
    'certified'
    >>> slipproof.certify([[1, 2], [2, 1]], [-1, -1], [1, 0]).solutions
    3
    """
    q_array = doubles("q", q, (1, 2))
    if q_array.shape[-1] == 0:
        raise wrong_value("q", "no components", "at least one")
    chosen = None if dimension is None else whole("dimension", dimension, 1, 3)
    dims, mu_array = _contacts(mu, q_array.shape, chosen)
    size = q_array.shape[-1]
    one_of("law", law, _LAWS)
    one_of("function", function, ("linear", "soft"))
    one_of("method", method, ("auto", "exact", "enclosure"))
    own_law = law not in ("cone", "coulomb") or compliance is not None or bias is not None
    special = refine or within is not None or own_law or z is None
    can_be_exact = dims < 3 and size <= EXACT_UP_TO and not _is_sparse(W) and not special
    if method == "exact" and not can_be_exact:
        raise wrong_value("method", "'exact'", "an array W, an answer z, no refine, within or law, dimension 1 or 2, "
                          f"and at most {EXACT_UP_TO} components")
    if z is None and not refine:
        raise wrong_value("z", "None", "an answer, or refine=True")
    if method == "enclosure" or not can_be_exact:
        if q_array.ndim != 1:
            raise wrong_value("q", f"shape {q_array.shape}", "one problem, (n,), for what is not decided exactly")
        options = _core.ContactOptions(real("tolerance", 1e-6 if tolerance is None else tolerance, 0, 1),
                                       None if within is None else real("within", within, 0, 1e300), bool(refine), law,
                                       None if effort is None else whole("effort", effort, 1, 2**63))
        tangential = 0 if mu_array is None else size - size // dims
        solver = (_each("bounds", bounds, tangential), _each("compliance", compliance, size), _each("bias", bias, size),
                  None if slip_speed is None else real("slip_speed", slip_speed, 0, 1e300), function)
        return _certify_any(W, q_array, z, w, mu_array, dims, solver, options)
    return _certify_exact(W, q_array, z, w, mu_array, real("tolerance", 1e-6 if tolerance is None else tolerance, 0, 1),
                          whole("effort", _EFFORT if effort is None else effort, 1, 2**63),
                          whole("threads", threads, 0, 4096), reporter(progress))


def _each(name: str, value: Any, size: int) -> Optional[Doubles]:
    """An array of this size, or one number for all of it."""
    if value is None:
        return None
    array = doubles(name, value, (0, 1))
    if array.ndim == 0:
        return np.full(size, float(array))
    return shaped(name, array, (size,), f"as that many components have {'one' if name == 'bounds' else 'it'}")


def _certify_any(W: Any, q: Doubles, z: Any, w: Any, mu: Optional[Doubles], dimension: int, solver: Tuple[Any, ...],
                 options: "_core.ContactOptions") -> Verdict:
    n = q.shape[0]
    why = f"as q has {n} components"
    matrix = _sparse(W, n) if _is_sparse(W) else (shaped("W", W, (n, n), why),)
    z_array = None if z is None else shaped("z", z, (n,), why)
    w_array = None if w is None else shaped("w", w, (n,), why)
    judged = _core.certify_problem(matrix, q, mu, dimension, z_array, w_array, *solver, options)
    return Verdict(judged.line(0), judged, 0)


def _finite(name: str, array: Optional[Doubles]) -> None:
    if array is None or np.isfinite(array).all():
        return
    place = tuple(int(i) for i in np.argwhere(~np.isfinite(array))[0])
    raise wrong_value(f"{name}{list(place)}", array[place], "a finite number")


def _certify_exact(W: Any, q: Doubles, z: Any, w: Any, mu: Optional[Doubles], tolerance: float, effort: int,
                   threads: int, progress: Optional[Callable[[int, int], object]]) -> Union[Verdict, Verdicts]:
    shape, n = q.shape, q.shape[-1]
    why = f"as q has shape {shape}"
    W_array = shaped("W", W, (*shape, n), why)
    z_array = shaped("z", z, shape, why)
    w_array = None if w is None else shaped("w", w, shape, why)
    if mu is not None and mu.shape[:-1] != shape[:-1]:
        raise wrong_value("mu", f"shape {mu.shape}", f"({shape[0]}, {mu.shape[-1]}) {why}")
    for name, array in (("W", W_array), ("q", q), ("mu", mu)):
        _finite(name, array)
    if mu is not None and (mu < 0).any():
        raise wrong_value("mu", float(mu.min()), "coefficients >= 0")
    if len(shape) == 1:
        return Verdict(_core.certify_exact(
            W_array[np.newaxis], q[np.newaxis], z_array[np.newaxis], None if w_array is None else w_array[np.newaxis],
            None if mu is None else mu[np.newaxis], tolerance, effort, threads, progress)[0])
    return Verdicts(_core.certify_exact(W_array, q, z_array, w_array, mu, tolerance, effort, threads, progress))


def certify_file(path: Union[str, "os.PathLike[str]"], *, scene: Union[None, str, "os.PathLike[str]"] = None,
                 mechanism: Optional[str] = None, answer: Union[None, str, "os.PathLike[str]"] = None,
                 tolerance: Optional[float] = None, law: Optional[str] = None, refine: bool = False,
                 within: Optional[float] = None, effort: Optional[int] = None, ignore_unknown: bool = False,
                 threads: int = 0, progress: Progress = None) -> Verdicts:
    """The verdicts of ``slipproof certify`` on a file: one for each record, or for each answer to a contact problem.

    Records are CSV or JSON Lines; ``scene`` has the values that are the same for all of them, or ``mechanism`` is their
    mechanism. Problems are FCLIB's HDF5, text of Siconos, MatrixMarket or JSON; ``answer`` is a file with the solver's
    answer, ``law`` is in place of the one that the problem names. Raises InputError.
    """
    name = _path("path", path)
    if law is not None:
        one_of("law", law, _LAWS)
    work = None if effort is None else whole("effort", effort, 1, 2**63)
    if answer is not None or refine or within is not None or law is not None or _core.is_problem_file(name):
        options = _core.ContactOptions(real("tolerance", 1e-6 if tolerance is None else tolerance, 0, 1),
                                       None if within is None else real("within", within, 0, 1e300), bool(refine), law,
                                       work)
        judged = _core.certify_problem_file(name, None if answer is None else _path("answer", answer), options)
        return _JudgedVerdicts(judged)
    lines, summary = _core.certify_records(
        name, None if scene is None else _path("scene", scene),
        None if mechanism is None else _path("mechanism", mechanism),
        None if tolerance is None else real("tolerance", tolerance, 0, 1), work, bool(ignore_unknown),
        whole("threads", threads, 0, 4096), reporter(progress))
    return Verdicts(lines.decode("utf-8", "replace").splitlines(), json.loads(summary))


class _JudgedVerdicts(Verdicts):
    """Verdicts on one problem at real size; they have more details than their lines of output."""

    def __init__(self, judged: "_core.Judged"):
        super().__init__([judged.line(i) for i in range(len(judged))])
        self._judged = judged

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return super().__getitem__(index)
        place = range(len(self))[index]
        return Verdict(self._lines[place], self._judged, place)

    def __iter__(self) -> Iterator[Verdict]:
        return (self[i] for i in range(len(self)))


def _path(name: str, value: Any) -> bytes:
    if not isinstance(value, (str, os.PathLike)):
        raise wrong_type(name, value, "a path")
    return os.fsencode(value)
