"""Answers with proved bounds: all motions of a scene in space, and whether a scene rests."""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from typing import Any, Dict, List, Mapping, Optional, Tuple

from ._numbers import SpaceNumber, Values, enclosed, fraction, value
from ._result import Report, Result
from ._solution import Motion, Solution


def _numbers(texts: Mapping[str, Any]) -> Dict[str, Optional[SpaceNumber]]:
    return {name: ends and enclosed(ends) for name, ends in texts.items()}


class SpaceMotion(Motion[SpaceNumber]):
    """One motion in space. A number is a Fraction where it is known exactly, otherwise :class:`Bounds`, a pair of
    Fractions that enclose it.

    ``slips``: by contact, the directions in which it slips, in degrees from T1 towards T2. ``accelerations``, in m/s^2 and
    rad/s^2, and ``forces``, in N, by their names; a force is None if the motion leaves it open. ``open_directions``:
    along how many directions forces are open; then those in ``forces`` are some of them; None if it is not known
    whether they are. ``exists``: it is proved that
    there is a motion in these bounds. ``unique``: and only one. ``others_within``: gaps and slips of others that count
    as this one differ from its own by no more; None if it is unique, or one of a family that moves in different ways.
    """

    __slots__ = ("slips", "accelerations", "forces", "exists", "unique", "others_within", "open_directions", "_details")

    def __init__(self, details: Mapping[str, Any]):
        self._details = details
        self.slips = _numbers(details["slips"])
        self.accelerations = _numbers(details["accelerations"])
        self.forces = _numbers(details["forces"])
        self.exists: bool = details["exists"]
        self.unique: bool = details["unique"]
        self.others_within: Optional[Fraction] = value(details["others_within"])
        self.open_directions: Optional[int] = details["open_directions"]
        everything = {**self.accelerations, **self.forces}
        known = Values.of({name: number for name, number in everything.items() if number is not None})
        open_forces = {name: (None, None) for name, number in self.forces.items() if number is None}
        super().__init__(details["modes"], (), details["status"] == "strict", known, open_forces)

    def _parts(self) -> Tuple[Any, ...]:
        return (self._details,)


class SpaceSolution(Solution):
    """All motions of a scene in space, as :meth:`Scene.solve` returns them for a mechanism with ``dimension=3``.

    >>> import slipproof
    >>> solution = slipproof.solve("cases/space/stool-tipping.toml")
    >>> solution.complete, solution.only, [motion.modes for motion in solution]
    (True, True, [('lift/stick/stick',)])
    >>> solution.motions[0].alphay
    Fraction(-538, 275)
    """

    @cached_property
    def motions(self) -> Tuple[SpaceMotion, ...]:  # type: ignore[override]
        """Every motion that was found; if ``complete``, it is proved that there is no other."""
        return tuple(SpaceMotion(motion) for motion in self._document["motions"])

    @property
    def complete(self) -> bool:
        """Whether it is proved that there is no other motion."""
        return self._document["complete"]  # type: ignore[no-any-return]

    @property
    def undecided(self) -> List[str]:
        """Patterns in which there may be other motions; empty if ``complete``."""
        return list(self._document["undecided"])

    @property
    def only(self) -> bool:
        """Whether it is proved that there is one motion, and no other. Its forces may be open."""
        motion = self.motions[0] if self.complete and len(self.motions) == 1 else None
        return motion is not None and motion.exists and (motion.unique or motion.others_within == 0)


class RestMap(Result):
    """The values of two loads at which a scene can rest. It can at each of the corners ``inside`` and between them, and
    nowhere beyond the corners ``around``; both go counterclockwise, and are the same if ``exact``. ``gap`` is the largest
    distance between them, in widths and heights of ``around``. ``none``: it rests nowhere. ``svg`` is the picture."""

    __slots__ = ("x", "y", "inside", "around", "none", "exact", "decided", "gap", "svg", "_details")

    def __init__(self, details: Mapping[str, Any], svg: str):
        self._details = details
        self.svg = svg
        self.x: str = details["x"]
        self.y: str = details["y"]
        self.inside = [(fraction(corner["x"]), fraction(corner["y"])) for corner in details["inside"]]
        self.around = [(fraction(x), fraction(y)) for x, y in details["around"]]
        self.none: bool = details["none"]
        self.exact: bool = details["exact"]
        self.decided: bool = details["decided"]
        self.gap: float = details["gap"]

    def _parts(self) -> Tuple[Any, ...]:
        return self._details, self.svg

    def _repr_svg_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"<slipproof.RestMap of {self.x} and {self.y}, {len(self.inside)} corners>"


class Rest(Report):
    """Whether a scene can rest, whether it must, and up to where, as :meth:`Scene.rest` finds it.

    >>> import slipproof
    >>> rest = slipproof.Scene.load("cases/rest/ladder.toml").rest()
    >>> rest.can_rest, rest.load[1]
    (True, Fraction(981, 11))
    """

    def __init__(self, document: str, text: str, picture: str):
        super().__init__(document, text)
        self._picture = picture

    def _parts(self) -> Tuple[Any, ...]:
        return self._json, self._text, self._picture

    @cached_property
    def _document(self) -> Dict[str, Any]:
        return self.to_dict()

    @property
    def can_rest(self) -> Optional[bool]:
        """Whether forces can hold it; None if that is undecided."""
        return self._document["can_rest"]  # type: ignore[no-any-return]

    @property
    def touching(self) -> bool:
        """Whether it can rest only just: it is proved that no forces are inside of all cones of friction."""
        return self._document["touching"]  # type: ignore[no-any-return]

    @property
    def must_rest(self) -> Optional[bool]:
        """Whether it has no motion beside rest; None if that is open. ``because`` says why."""
        return self._document["must_rest"]  # type: ignore[no-any-return]

    @property
    def because(self) -> str:
        """Why it must rest, need not rest, or why that is open."""
        return self._document["must_rest_because"]  # type: ignore[no-any-return]

    @property
    def forces(self) -> Optional[Dict[str, Fraction]]:
        """Forces that hold it, by name, in N."""
        forces = self._document["forces"]
        return forces and {name: value(force) for name, force in forces.items()}

    @property
    def fall(self) -> Optional[Dict[str, Fraction]]:
        """The virtual motion that proves that it cannot rest, by the names of accelerations."""
        why_not = self._document["why_not"]
        return why_not and {name: value(rate) for name, rate in why_not["motion"].items()}

    @property
    def load(self) -> Tuple[Optional[SpaceNumber], Optional[SpaceNumber]]:
        """The least and the greatest load at which it can rest; None where there is no end, or no load."""
        return self._ends("load")

    @property
    def parameter(self) -> Tuple[Optional[SpaceNumber], Optional[SpaceNumber]]:
        """The values of the parameter that was asked for, likewise."""
        return self._ends("parameter")

    @property
    def tilt(self) -> Optional[SpaceNumber]:
        """The tangent of the greatest angle; None at 90 degrees or beyond, or if it was not asked for."""
        tilt = self._document["tilt"]
        return tilt and tilt["tangent"] and enclosed(tilt["tangent"])

    @property
    def map(self) -> Optional[RestMap]:
        """The map of two loads; None if it was not asked for, or the effort was not enough for one."""
        found = self._document["map"]
        return found and RestMap(found, self._picture)

    def _ends(self, what: str) -> Tuple[Optional[SpaceNumber], Optional[SpaceNumber]]:
        found = self._document[what] or {"from": None, "to": None}
        return found["from"] and enclosed(found["from"]), found["to"] and enclosed(found["to"])
