"""Assertions for tests of solvers and engines: what is wrong, by how much, and what would be right.

With pytest they are fixtures, too, if the package is installed, or with ``-p slipproof.testing``:
``assert_certified`` and ``assert_motion`` with the tolerance of ``--slipproof-tolerance``.

>>> from slipproof.testing import assert_certified, assert_motion
>>> assert_certified([[2, 1], [1, 2]], [-5, -6], [4/3, 7/3]).verdict
'certified'
>>> assert_motion("cases/ambiguous.toml", {"a": 0.1})
Traceback (most recent call last):
    ...
AssertionError: no motion of ambiguous is within 1e-09 of the answer
  the nearest is off by 0.241, a: found 0.1, expected 79461/25520
  stick/stick: a = 327/110
  stick/slip+: a = 981/320
  stick/lift: a = 79461/25520
"""

from __future__ import annotations

import os
from fractions import Fraction
from functools import partial
from typing import Any, Iterator, List, Mapping, Optional, Tuple, Union

from ._certify import certify
from ._scene import Scene, solve
from ._solution import Motion, Solution
from ._numbers import Bounds
from ._space import SpaceMotion, SpaceSolution
from ._verdicts import Verdict, Verdicts

__all__ = ["assert_certified", "assert_motion"]


def _violations(details: Mapping[str, Any]) -> Iterator[str]:
    for worst in details.get("worst", ())[:3]:
        place = f"contact {worst['contact']}" if "contact" in worst else f"row {worst['row']}"
        yield f"{place} violates {worst['violates']} by {worst['by']}"
    if details.get("violated"):
        yield f"it violates {details['violated']}, by {-Fraction(details['margin'])}"


def _solutions(verdict: Verdict, *looked: Any) -> Iterator[str]:
    """All that are known exactly, or one that one of the calls finds, to the last digit."""
    for found in verdict.details.get("found", ())[:3]:
        yield f"a solution: z = [{', '.join(found['z'])}]"
    if verdict.details.get("found"):
        return
    if verdict.details.get("other"):
        yield f"another solution: z = [{', '.join(str(x) for x in verdict.details['other'])}]"
        return
    for look in looked:
        refined = look().refined()
        if refined:
            yield f"a solution, to all digits: z = {refined['r']}"
            return


def assert_certified(W: Any, q: Any, z: Any, mu: Any = None, *, tolerance: float = 1e-6, only: bool = False,
                     **options: Any) -> Verdict:
    """Fails unless ``z`` is right for the contact problem w = ``W`` z + ``q`` with the friction ``mu``.

    These, ``tolerance`` and ``options`` are those of :func:`slipproof.certify`. ``only``: it has to be
    proved that there is no other solution. By laws of which only the residual is judged, such as the diamond in space, a
    backward error within the tolerance is right. The message says which contact breaks which law, by how much, and has a solution if one is found. Returns the verdict. Raises AssertionError, and what ``certify`` raises.
    """
    __tracebackhide__ = True
    verdict: Union[Verdict, Verdicts] = certify(W, q, z, mu, tolerance=tolerance, **options)
    if isinstance(verdict, Verdicts):
        raise TypeError("found several problems, expected one")
    best = verdict.verdict == "eps-solution" and bool(verdict.details.get("nothing_stronger"))
    if (verdict.only if only else verdict.certified or best or verdict.verdict == "ambiguous"):
        return verdict
    lines = [f"the answer is {verdict.verdict}, at a tolerance of {tolerance:g}"]
    if verdict.certified:
        raise AssertionError(lines[0] + "; other solutions are not excluded")
    if verdict.verdict == "invalid":
        raise AssertionError("\n  ".join([*lines, verdict.details["reason"]]))
    look = partial(certify, tolerance=tolerance, **{**options, "method": "enclosure", "refine": True, "mu": mu})
    near: Verdict = look(W, q, z)
    lines.extend(_violations(near.details))
    if verdict.details.get("reason"):
        lines.append(verdict.details["reason"])
    lines.extend(_solutions(verdict, lambda: near, lambda: look(W, q)))
    raise AssertionError("\n  ".join(lines))


def _kinds(solution: Solution, index: int) -> Tuple[List[str], List[str]]:
    """The names of a motion's accelerations, gaps and slips, and of its forces."""
    motion = solution.to_dict()["motions"][index]
    return list(motion["accelerations"]), list(motion["forces"])


def _error(motion: Motion[Any], kinds: Tuple[List[str], List[str]], answer: Mapping[str, Any]) -> Tuple[float, str]:
    """The largest error of a component, over the largest number of its kind, and what it is. Of a number with bounds it is
    the error from the farther one; forces that are open have none."""
    worst, told = 0.0, ""
    for names in kinds:
        if isinstance(motion, SpaceMotion) and motion.open_directions != 0 and names is kinds[1]:
            continue
        known = {name: motion.values[name] for name in names if name in motion.values}
        ends = {name: x if isinstance(x, Bounds) else (x, x) for name, x in known.items()}
        size = max([min(map(abs, x)) for x in ends.values()] + [abs(Fraction(answer[n])) for n in names if n in answer],
                   default=Fraction(0))
        for name in names:
            if name not in answer:
                continue
            x = Fraction(answer[name])
            if name in known:
                off, right = max(abs(x - end) for end in ends[name]), str(known[name])
            else:
                lower, upper = motion.force_ranges.get(name, (None, None))
                off = max(Fraction(0), *(lower - x,) if lower is not None else (), *(x - upper,) if upper is not None else ())
                right = f"from {lower} to {upper}"
            error = float(off / size) if size else 0.0
            if error > worst:
                worst, told = error, f"{name}: found {answer[name]}, expected {right}"
    return worst, told


def assert_motion(scene: Union[str, "os.PathLike[str]", Mapping[str, Any], Scene, Solution], answer: Mapping[str, Any],
                  *, tolerance: float = 1e-9, only: bool = False) -> Motion[Fraction]:
    """Fails unless an answer is a motion of a scene at its load: accelerations, gaps, slips and forces by their names.

    ``scene`` is a file, a dict or a Solution; ``answer`` a dict, in SI units. Each error is divided by the largest number
    of its kind, and may be ``tolerance``; in space it has to be, wherever in its bounds the motion is, and forces that are
    open are not compared. ``only``: a motion that is one of several is not enough. Returns the motion. Raises
    AssertionError with all motions, ValueError for names that no motion has, and what ``solve`` raises.
    """
    __tracebackhide__ = True
    solution = scene if isinstance(scene, Solution) else solve(scene)
    if not answer:
        raise ValueError("answer: found nothing, expected numbers by their names")
    known = {name for i in range(len(solution.motions)) for kind in _kinds(solution, i) for name in kind}
    for name, x in answer.items():
        if solution.motions and name not in known:
            raise ValueError(f"answer: found {name}, expected one of {', '.join(sorted(known))}")
        if x != x or x in (float("inf"), float("-inf")):
            raise AssertionError(f"the answer has {name} = {x}")
    best: Optional[Tuple[float, str, Motion[Fraction]]] = None
    for i, motion in enumerate(solution.motions):
        if isinstance(motion, SpaceMotion) and not motion.exists:
            continue
        error, told = _error(motion, _kinds(solution, i), answer)
        if best is None or error < best[0]:
            best = (error, told, motion)
    if best and best[0] <= tolerance and (not only or solution.only):
        return best[2]
    lines = [f"no motion of {solution.name} is within {tolerance:g} of the answer"]
    if best and best[0] <= tolerance:
        lines = [f"{solution.name} has {len(solution.motions)} motions, and the answer is one of them"]
        if len(solution.motions) == 1:
            lines = [f"the answer is a motion of {solution.name}, and others are not excluded"]
    elif best:
        lines.append(f"the nearest is off by {best[0]:.3g}, {best[1]}")
    for motion in solution.motions:
        numbers = ", ".join(f"{name} = {motion.values[name]}" for name in answer if name in motion.values)
        lines.append(f"{' = '.join(motion.modes or motion.boundary_modes)}: {numbers}")
    lines.extend(f"{c.mode}: infinitely many motions" for c in solution.continua)
    if isinstance(solution, SpaceSolution) and not solution.complete:
        lines.append("it may have others")
    elif not solution.motions and not solution.continua:
        lines.append("it has none")
    raise AssertionError("\n  ".join(lines))


def pytest_addoption(parser: Any) -> None:
    parser.getgroup("slipproof").addoption("--slipproof-tolerance", type=float, default=1e-6,
                                           help="largest error of an answer, over the largest number of its kind")


try:
    import pytest
except ImportError:  # the assertions need none of it
    pass
else:

    @pytest.fixture(name="assert_certified")
    def _certified_fixture(request: "pytest.FixtureRequest") -> Any:
        """:func:`assert_certified` with the tolerance of ``--slipproof-tolerance``."""
        return partial(assert_certified, tolerance=request.config.getoption("--slipproof-tolerance"))

    @pytest.fixture(name="assert_motion")
    def _motion_fixture(request: "pytest.FixtureRequest") -> Any:
        """:func:`assert_motion` with the tolerance of ``--slipproof-tolerance``."""
        return partial(assert_motion, tolerance=request.config.getoption("--slipproof-tolerance"))
