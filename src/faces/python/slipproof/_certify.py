"""Verdicts about solvers' answers."""

from __future__ import annotations

import errno
import json
import os
from pathlib import Path
from typing import Any, Callable, NamedTuple, Optional, Sequence, Tuple, Union, overload

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import (Array, Doubles, is_sparse, numbers, one_of, real, refuse_infinite, rounded_nowhere, shaped,
                      sparse_rows, texts, whole)
from ._errors import wrong_type, wrong_value
from ._numbers import Number
from ._progress import Progress, reporter
from ._verdicts import BatchVerdicts, JudgedVerdicts, Verdict, Verdicts

#: Sizes up to which every solution of a problem is looked for in exact arithmetic, unless the caller wants otherwise.
EXACT_UP_TO = 64
_EFFORT = 1_500_000_000
#: law, restitution, tangential restitution, velocities before
_StepImpact = Optional[Tuple[str, Doubles, Optional[Doubles], Doubles]]
#: bounds, compliance, bias, slip speed, function, impact
_Solver = Tuple[Optional[Doubles], Optional[Doubles], Optional[Doubles], Optional[float], str, _StepImpact]
#: matrix, q, mu, dimension, z, w
_Given = Tuple[Tuple[Any, ...], Doubles, Optional[Doubles], int, Optional[Doubles], Optional[Doubles]]
_LAWS = tuple(_core.law_words())


def _contacts(mu: Any, shape: Tuple[int, ...], dimension: Optional[int], of: str = "q") -> Tuple[int, Optional[Array]]:
    """The dimension of the contacts, and a coefficient for each; a single number is for all contacts."""
    if mu is None:
        if dimension in (2, 3):
            raise wrong_value("mu", "None", f"the coefficients of friction of contacts in dimension {dimension}")
        return 1, None
    if dimension == 1:
        raise wrong_value("mu", "coefficients of friction", "none in dimension 1, a complementarity problem")
    array = numbers("mu", mu, (0, 1) if len(shape) == 1 else (0, 1, 2))
    size = shape[-1]
    contacts = None if array.ndim == 0 else array.shape[-1]
    each = dimension or _core.dimension_by_sizes(size, contacts)
    if size % each or contacts not in (None, size // each):
        raise wrong_value("mu", "one number" if contacts is None else f"{contacts} coefficients",
                          f"{each} components of {of} for each contact, which has {size}")
    if array.ndim == 0:
        return each, np.full(size // each, array[()], dtype=array.dtype)
    return each, array


class Impact(NamedTuple):
    """Contacts approach in the step, and a law of impact restores velocities.

    ``law``: ``newton`` restores ``restitution`` times the velocity of a contact that approaches, ``moreau`` that of each
    contact; both also ``tangential_restitution`` times the velocities of sliding. Each is a number, or one for each contact.
    ``before`` are the velocities before the step: of contacts, like q, for :func:`certify`; of bodies, like f, for
    :func:`certify_bodies`. ``details["energy"]`` of a verdict then says whether the impulses gain energy.
    """

    law: str
    restitution: Any
    before: Any
    tangential_restitution: Any = None


def _impact(impact: Optional[Impact], contacts: int, shape: Tuple[int, ...], of: str) -> _StepImpact:
    if impact is None:
        return None
    if not isinstance(impact, Impact):
        raise wrong_type("impact", impact, "a slipproof.Impact")
    one_of("impact.law", impact.law, ("newton", "moreau"))
    if impact.restitution is None:
        raise wrong_value("impact.restitution", "None", "a number from 0 to 1, or one for each contact")
    restitution = _each("impact.restitution", impact.restitution, contacts)
    assert restitution is not None
    before = shaped("impact.before", impact.before, shape, f"as {of} has shape {shape}")
    return (impact.law, restitution, _each("impact.tangential_restitution", impact.tangential_restitution, contacts),
            rounded_nowhere("impact.before", before))


@overload
def certify(W: Any, q: Sequence[Number], z: Any = None, mu: Any = None, *, w: Any = None,  # type: ignore[misc]
            dimension: Optional[int] = None,
            tolerance: Optional[float] = None, law: str = "cone", bounds: Any = None, compliance: Any = None,
            bias: Any = None, slip_speed: Optional[float] = None, function: str = "linear",
            impact: Optional[Impact] = None, refine: bool = False,
            all: bool = False, within: Optional[float] = None, method: str = "auto", effort: Optional[int] = None,
            threads: int = 0, progress: Progress = None) -> Verdict: ...


@overload
def certify(W: Any, q: Sequence[Sequence[Number]], z: Any = None, mu: Any = None, *, w: Any = None,
            dimension: Optional[int] = None,
            tolerance: Optional[float] = None, law: str = "cone", bounds: Any = None, compliance: Any = None,
            bias: Any = None, slip_speed: Optional[float] = None, function: str = "linear",
            impact: Optional[Impact] = None, refine: bool = False,
            all: bool = False, within: Optional[float] = None, method: str = "auto", effort: Optional[int] = None,
            threads: int = 0, progress: Progress = None) -> Verdicts: ...


@overload
def certify(W: Any, q: "npt.NDArray[Any]", z: Any = None, mu: Any = None, *, w: Any = None,
            dimension: Optional[int] = None,
            tolerance: Optional[float] = None, law: str = "cone", bounds: Any = None, compliance: Any = None,
            bias: Any = None, slip_speed: Optional[float] = None, function: str = "linear",
            impact: Optional[Impact] = None, refine: bool = False,
            all: bool = False, within: Optional[float] = None, method: str = "auto", effort: Optional[int] = None,
            threads: int = 0, progress: Progress = None) -> Any: ...


def certify(W: Any, q: Any, z: Any = None, mu: Any = None, *, w: Any = None, dimension: Optional[int] = None,
            tolerance: Optional[float] = None, law: str = "cone", bounds: Any = None, compliance: Any = None,
            bias: Any = None, slip_speed: Optional[float] = None, function: str = "linear",
            impact: Optional[Impact] = None, refine: bool = False,
            all: bool = False, within: Optional[float] = None, method: str = "auto", effort: Optional[int] = None,
            threads: int = 0, progress: Progress = None) -> Union[Verdict, Verdicts]:
    """Is z an answer to the contact problem w = W z + q, and the only one?

    Without ``mu`` this is a linear complementarity problem: z >= 0, w >= 0, z . w = 0. With ``mu`` the contacts have
    friction: ``mu`` is one number, or one for each contact; z has the forces of each contact, (N, T) in the plane or
    (N, T1, T2) in space. ``dimension`` is 2 or 3; it is required if the sizes do not determine it (one ``mu``, and a
    multiple of 6 components). ``W`` is an array of shape (n, n), or a sparse matrix of SciPy; ``q``, ``z`` and the
    optional ``w``, the solver's velocities, have n components. Arrays of shapes (k, n, n) and (k, n) are k problems and
    give k :class:`Verdicts`; ``W`` of shape (n, n), or a sparse one, is the same for all of them. In space, and wherever
    else ``exact`` does not judge them, they are :class:`BatchVerdicts`, whose verdicts, radii and backward errors are
    arrays. Numbers may be float, int, Fraction, Decimal or texts (``"1/3"``), and are taken exactly; any consistent units
    do. A NaN or an infinity in z makes the answer ``invalid``.

    ``method``: ``exact`` finds every solution of an LCP or a planar problem with up to 64 components, in exact
    arithmetic (``certified``, ``ambiguous``, ``inaccurate``, ``wrong``); ``enclosure`` proves what it can at any size
    (``unique``, ``solution within rho``, ``inaccurate``, ``eps-solution``, ``wrong``, ...). ``auto`` uses ``exact`` if
    it can. ``tolerance`` (default 1e-6) limits the distance from a solution: forces are divided by the largest force,
    velocities by the largest velocity. If ``enclosure`` finds no solution, it limits the backward error. ``refine``:
    search for a solution, also without z. ``all``: find all solutions by Coulomb's law, in space as well, with a proof
    that there are no others; :attr:`Verdict.solutions` has them, also without z. ``within``: the radius in which a solution is near: with one there an answer
    whose backward error is above the tolerance is ``not converged``, without one it is wrong. ``effort`` limits the work
    on one answer, in operations on words. ``threads``: 0 for all cores. ``progress``: a function of (done, all), or True.

    ``law`` is what the solver solves: ``cone`` (or ``coulomb``), the pyramids ``box`` and ``diamond``, ``fixed`` with
    ``bounds`` of the tangential components, ``associated``, ``regularised`` with ``slip_speed`` and ``function``
    (``linear`` or ``soft``). ``compliance`` and ``bias``, numbers or arrays like q, are what it adds to w: R z and b.
    Where anything differs from Coulomb's law, ``details["coulomb"]`` judges the same forces by that. ``impact``: an
    :class:`Impact`, for a step in which contacts approach.

    Raises TypeError and ValueError for arrays that do not fit, or that hold numbers which are no float64 where not every
    solution is looked for in exact arithmetic; InputError for numbers that no problem can have.

    >>> import slipproof
    >>> slipproof.certify([[2, 1], [1, 2]], [-5, -6], [4/3, 7/3]).verdict
    'certified'
    >>> slipproof.certify([[1, 2], [2, 1]], [-1, -1], [1, 0]).solutions
    3
    """
    q_array = numbers("q", q, (1, 2))
    if q_array.shape[-1] == 0:
        raise wrong_value("q", "no components", "at least one")
    chosen = None if dimension is None else whole("dimension", dimension, 1, 3)
    dims, mu_array = _contacts(mu, q_array.shape, chosen)
    size = q_array.shape[-1]
    one_of("law", law, _LAWS)
    one_of("function", function, ("linear", "soft"))
    one_of("method", method, ("auto", "exact", "enclosure"))
    own_law = law not in ("cone", "coulomb") or any(x is not None for x in (compliance, bias, impact))
    special = refine or all or within is not None or own_law or z is None
    can_be_exact = dims < 3 and size <= EXACT_UP_TO and not is_sparse(W) and not special
    if method == "exact" and not can_be_exact:
        raise wrong_value("method", "'exact'", "an array W, an answer z, no refine, all, within, law or impact, dimension 1 or 2, "
                          f"and at most {EXACT_UP_TO} components")
    if z is None and not refine and not all:
        raise wrong_value("z", "None", "an answer, refine=True or all=True")
    if method == "enclosure" or not can_be_exact:
        options = _core.ContactOptions(real("tolerance", 1e-6 if tolerance is None else tolerance, 0, 1),
                                       None if within is None else real("within", within, 0, 1e300), bool(refine), bool(all), law,
                                       None if effort is None else whole("effort", effort, 1, 2**63))
        tangential = 0 if mu_array is None else size - size // dims
        solver: _Solver = (
            _each("bounds", bounds, tangential), _each("compliance", compliance, size), _each("bias", bias, size),
            None if slip_speed is None else real("slip_speed", slip_speed, 0, 1e300), function,
            _impact(impact, size // dims, q_array.shape, "q"))
        given = _arrays(W, rounded_nowhere("q", q_array), z, w,
                        None if mu_array is None else rounded_nowhere("mu", mu_array), dims)
        if q_array.ndim == 1:
            judged = _core.certify_problem(*given, *solver, options)
            return Verdict(judged.line(0), judged, 0)
        return BatchVerdicts(*_core.certify_problems(*given, *solver, options, whole("threads", threads, 0, 4096),
                                                     reporter(progress)))
    return _certify_exact(W, q_array, z, w, mu_array, real("tolerance", 1e-6 if tolerance is None else tolerance, 0, 1),
                          whole("effort", _EFFORT if effort is None else effort, 1, 2**63),
                          whole("threads", threads, 0, 4096), reporter(progress))


def _each(name: str, value: Any, size: int) -> Optional[Doubles]:
    """An array of this size, or one number for all of it."""
    if value is None:
        return None
    array = rounded_nowhere(name, numbers(name, value, (0, 1)))
    if array.ndim == 0:
        return np.full(size, float(array))
    return shaped(name, array, (size,), f"as that many components have {'one' if name == 'bounds' else 'it'}")


def certify_bodies(M: Any, H: Any, f: Any, r: Any = None, mu: Any = None, *, w: Any = None, u: Any = None, v: Any = None,
                   dimension: int = 3, impact: Optional[Impact] = None, tolerance: Optional[float] = None,
                   refine: bool = False, all: bool = False,
                   within: Optional[float] = None, effort: Optional[int] = None, threads: int = 0,
                   progress: Progress = None) -> BatchVerdicts:
    """Are the rows of r answers to the contact problems of bodies M v = H r + f, u = H^T v + w?

    A row of ``f`` (k, n) is a problem. ``M`` (k, n, n) and ``H`` (k, n, m) may be the same for all of them, (n, n) and (n, m),
    and so may ``mu``: a number, one for each contact, or (k, contacts). ``w`` (k, m) is 0 if it is left out; ``r`` (k, m) has
    the forces of each contact, (N, T1, T2) in space; ``u`` (k, m) and ``v`` (k, n), the solver's velocities of contacts
    and bodies, may be left out. These numbers are judged as they are: W = H^T M^-1 H is not rounded on the way.
    ``dimension`` is 2 or 3. ``impact``, ``tolerance``, ``refine``, ``all``, ``within``, ``effort``, ``threads`` and ``progress`` are those
    of :func:`certify`. Raises TypeError and ValueError for arrays that do not fit, InputError for numbers that no problem
    can have.
    """
    push = numbers("f", f, (2,))
    count, n = push.shape
    why = f"as f has shape {push.shape}"
    mass, directions = numbers("M", M, (2, 3)), numbers("H", H, (2, 3))
    m = directions.shape[-1]
    for name, array, shape in (("M", mass, (n, n)), ("H", directions, (n, m))):
        if array.shape not in (shape, (count, *shape)):
            raise wrong_value(name, f"shape {array.shape}", f"{shape} or {(count, *shape)} {why}")
    dims = whole("dimension", dimension, 2, 3)
    if m % dims:
        raise wrong_value("H", f"{m} columns", f"{dims} for each contact")
    dims, friction = _contacts(0 if mu is None else mu, (count, m), dims, "H")
    assert friction is not None  # in dimension 2 and 3
    if friction.ndim == 2 and len(friction) != count:
        raise wrong_value("mu", f"shape {friction.shape}", f"({count}, {m // dims}) {why}")
    if r is None and not refine and not all:
        raise wrong_value("r", "None", "an answer, refine=True or all=True")
    sizes = (("w", w, m), ("r", r, m), ("u", u, m), ("v", v, n))
    free, *answers = (None if x is None else rounded_nowhere(name, shaped(name, x, (count, size), why)) for name, x, size in sizes)
    options = _core.ContactOptions(real("tolerance", 1e-6 if tolerance is None else tolerance, 0, 1),
                                   None if within is None else real("within", within, 0, 1e300), bool(refine), bool(all), None,
                                   None if effort is None else whole("effort", effort, 1, 2**63))
    given = (rounded_nowhere(name, x) for name, x in (("M", mass), ("H", directions), ("f", push)))
    return BatchVerdicts(*_core.certify_bodies(*given, np.zeros((count, m)) if free is None else free,
                                               rounded_nowhere("mu", friction), dims, answers,
                                               _impact(impact, m // dims, (count, n), "f"), options,
                                               whole("threads", threads, 0, 4096), reporter(progress)))


def _arrays(W: Any, q: Doubles, z: Any, w: Any, mu: Optional[Doubles], dimension: int) -> _Given:
    """The numbers of one problem, or of as many as q has rows."""
    n = q.shape[-1]
    why = f"as q has {n} components" if q.ndim == 1 else f"as q has shape {q.shape}"
    if mu is not None and mu.ndim == 2 and mu.shape[:-1] != q.shape[:-1]:
        raise wrong_value("mu", f"shape {mu.shape}", f"({q.shape[0]}, {mu.shape[-1]}) {why}")
    if is_sparse(W):
        matrix = sparse_rows(W, n)
    else:
        dense = shaped("W", W, (n, n), why) if q.ndim == 1 else _matrices(W, q.shape, why)
        matrix = (rounded_nowhere("W", dense),)
    z_array = None if z is None else rounded_nowhere("z", shaped("z", z, q.shape, why))
    w_array = None if w is None else rounded_nowhere("w", shaped("w", w, q.shape, why))
    return matrix, q, mu, dimension, z_array, w_array


def _matrices(W: Any, shape: Tuple[int, ...], why: str) -> Array:
    """A matrix for each problem, or one for all of them."""
    array = numbers("W", W, (2, 3))
    if array.shape not in ((*shape, shape[-1]), (shape[-1], shape[-1])):
        raise wrong_value("W", f"shape {array.shape}", f"{(*shape, shape[-1])} {why}")
    return array


def _certify_exact(W: Any, q: Array, z: Any, w: Any, mu: Optional[Array], tolerance: float, effort: int,
                   threads: int, progress: Optional[Callable[[int, int], object]]) -> Union[Verdict, Verdicts]:
    shape, n = q.shape, q.shape[-1]
    why = f"as q has shape {shape}"
    W_array = _matrices(W, shape, why) if len(shape) == 2 else numbers("W", W, (2,))
    if W_array.shape not in ((*shape, n), (n, n)):
        raise wrong_value("W", f"shape {W_array.shape}", f"{(*shape, n)} {why}")
    z_array = shaped("z", z, shape, why)
    w_array = None if w is None else shaped("w", w, shape, why)
    if mu is not None and mu.shape[:-1] not in ((), shape[:-1]):
        raise wrong_value("mu", f"shape {mu.shape}", f"({shape[0]}, {mu.shape[-1]}) {why}")
    for name, array in (("W", W_array), ("q", q), ("mu", mu)):
        refuse_infinite(name, array)
    if mu is not None and (mu < 0).any():
        raise wrong_value("mu", float(mu.min()), "coefficients >= 0")
    lines = _core.certify_exact((shape[0] if len(shape) == 2 else 1, n, 0 if mu is None else mu.shape[-1]),
                                texts(W_array), texts(q), texts(z_array), None if w_array is None else texts(w_array),
                                None if mu is None else texts(mu), tolerance, effort, threads, progress)
    return Verdicts(lines) if len(shape) == 2 else Verdict(lines[0])


def certify_file(path: Union[str, "os.PathLike[str]"], *, scene: Union[None, str, "os.PathLike[str]"] = None,
                 mechanism: Optional[str] = None, answer: Union[None, str, "os.PathLike[str]"] = None,
                 tolerance: Optional[float] = None, law: Optional[str] = None, refine: bool = False,
                 all: bool = False, within: Optional[float] = None, effort: Optional[int] = None, ignore_unknown: bool = False,
                 threads: int = 0, progress: Progress = None) -> Verdicts:
    """The verdicts of ``slipproof certify`` on a file: one for each record, or for each answer to a contact problem.

    Records are CSV or JSON Lines; ``scene`` has the values that are the same for all of them, or ``mechanism`` is their
    mechanism. Problems are FCLIB's HDF5, text of Siconos, MatrixMarket or JSON; ``answer`` is a file with the solver's
    answer, ``law`` is in place of the one that the problem names. ``tolerance``, ``refine``, ``all``, ``within``,
    ``effort``, ``threads`` and ``progress`` are those of :func:`certify`; ``ignore_unknown`` skips unknown columns. ``path`` and the
    others are files. Raises FileNotFoundError if one is not there, InputError for mistakes in them.
    """
    name = _file("path", path)
    if law is not None:
        one_of("law", law, _LAWS)
    work = None if effort is None else whole("effort", effort, 1, 2**63)
    if answer is not None or refine or all or within is not None or law is not None or _core.is_problem_file(name):
        options = _core.ContactOptions(real("tolerance", 1e-6 if tolerance is None else tolerance, 0, 1),
                                       None if within is None else real("within", within, 0, 1e300), bool(refine), bool(all), law,
                                       work)
        judged = _core.certify_problem_file(name, None if answer is None else _file("answer", answer), options)
        return JudgedVerdicts(judged)
    lines, summary = _core.certify_records(
        name, None if scene is None else _file("scene", scene),
        None if mechanism is None else _mechanism("mechanism", mechanism),
        None if tolerance is None else real("tolerance", tolerance, 0, 1), work, bool(ignore_unknown),
        whole("threads", threads, 0, 4096), reporter(progress))
    return Verdicts(lines.decode("utf-8", "replace").splitlines(), json.loads(summary))


def _path(name: str, value: Any) -> bytes:
    if not isinstance(value, (str, os.PathLike)):
        raise wrong_type(name, value, "a path")
    return os.fsencode(value)


def _file(name: str, value: Any) -> bytes:
    """The path of a file or folder that is there. Raises OSError."""
    path = _path(name, value)
    if path != b"-":
        os.stat(value)
    return path


def _mechanism(name: str, value: Any) -> bytes:
    """The path of a mechanism's file, or the name of a shipped one."""
    path = _path(name, value)
    shipped = _core.shipped_mechanisms()
    if os.fsdecode(path) not in shipped and not Path(os.fsdecode(path)).exists():
        raise FileNotFoundError(errno.ENOENT, f"No such file, and no shipped mechanism of this name ({', '.join(shipped)})",
                                os.fsdecode(path))
    return path
