"""The solution of a scene: motions, ranges, the partition of the loads, continua."""

from __future__ import annotations

import json
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, Dict, Generic, Iterator, List, Mapping, Optional, Sequence, Tuple

from . import _core
from ._errors import wrong_value
from ._html import table, phase_line
from ._numbers import Affine, Interval, N, Number, Values, ratio, value
from ._result import Result

if TYPE_CHECKING:
    from ._scene import Scene


class Motion(Result, Generic[N]):
    """One motion, with every mode that gives it.

    Its numbers are attributes, ``motion.a``, and in ``values``: Fractions at one load, :class:`Affine` in a cell.
    ``values`` has accelerations, gaps, slips and the determined forces; ``force_ranges`` has the ranges of undetermined
    forces. In ``modes`` every condition holds strictly; ``boundary_modes`` are the other modes. ``dict(motion)`` has its
    numbers. Units are SI: accelerations m/s^2 and rad/s^2, forces N.
    """

    __slots__ = ("modes", "boundary_modes", "strict", "values", "force_ranges")

    def __init__(self, modes: Sequence[str], boundary_modes: Sequence[str], strict: bool, values: Mapping[str, N],
                 force_ranges: Mapping[str, Tuple[Optional[Fraction], Optional[Fraction]]]):
        self.modes = tuple(modes)
        self.boundary_modes = tuple(boundary_modes)
        self.strict = strict
        self.values = values
        self.force_ranges = force_ranges

    def _parts(self) -> Tuple[Any, ...]:
        values: Values[N] = Values.of(self.values)
        return self.modes, self.boundary_modes, self.strict, values, dict(self.force_ranges)

    def __iter__(self) -> Iterator[Tuple[str, N]]:
        return iter(self.values.items())

    @property
    def all_modes(self) -> Tuple[str, ...]:
        """``modes`` and ``boundary_modes``."""
        return self.modes + self.boundary_modes

    @property
    def status(self) -> str:
        """``strict``: every condition of one of its modes holds strictly; otherwise ``boundary``."""
        return "strict" if self.strict else "boundary"

    def __getattr__(self, name: str) -> N:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self.values[name]
        except KeyError:
            raise AttributeError(f"a motion has no {name}; it has {', '.join(self.values)}") from None

    def __dir__(self) -> List[str]:
        return [*super().__dir__(), *self.values]

    def __repr__(self) -> str:
        return f"<Motion {' = '.join(self.modes or self.boundary_modes)} {self.status}>"

    def _repr_html_(self) -> str:
        return table(["", ""], [[name, str(self.values[name])] for name in self.values if self.values[name] != 0])


class _Native(Values[Fraction]):
    """The numbers of a motion at its load, directly from the library."""

    __slots__ = ("_solution", "_index")

    def __init__(self, solution: "_core.Solution", index: int, names: Sequence[str]):
        super().__init__(dict.fromkeys(names))
        self._solution, self._index = solution, index

    def __getitem__(self, name: str) -> Fraction:
        made = self._made.get(name)
        if made is None:
            made = self._made[name] = ratio(self._solution.number(self._index, name))
        return made


class Continuum(Result):
    """A mode with infinitely many motions. ``ranges`` has the ranges of undetermined numbers, ``details`` the rest."""

    __slots__ = ("mode", "details")

    def __init__(self, details: Mapping[str, Any]):
        self.mode: str = details["mode"]
        self.details = details

    def _parts(self) -> Tuple[Any, ...]:
        return (self.details,)

    @property
    def ranges(self) -> Dict[str, Tuple[Any, ...]]:
        """The two ends of each number's range; None stands for an infinite end."""
        return {name: tuple(value(x) for x in ends) for name, ends in self.details["ranges"].items()}

    def __repr__(self) -> str:
        return f"<Continuum {self.mode}>"


class Range(Result):
    """The loads at which a mode is consistent."""

    __slots__ = ("mode", "loads", "details")

    def __init__(self, mode: str, loads: Interval, details: Mapping[str, Any]):
        self.mode, self.loads, self.details = mode, loads, details

    def _parts(self) -> Tuple[Any, ...]:
        return self.mode, self.loads, self.details

    def __repr__(self) -> str:
        return f"<Range {self.mode} {self.loads}>"


class Cell(Result):
    """Loads with the same motions: a point or an open interval. The motions' numbers are affine in the load. Iterating
    gives the motions; ``continua`` names the modes with infinitely many."""

    __slots__ = ("loads", "motions", "continua")

    def __init__(self, loads: Interval, motions: Sequence[Motion[Affine]], continua: Sequence[str]):
        self.loads, self.motions, self.continua = loads, tuple(motions), tuple(continua)

    def _parts(self) -> Tuple[Any, ...]:
        return self.loads, self.motions, self.continua

    def __iter__(self) -> Iterator[Motion[Affine]]:
        return iter(self.motions)

    def __len__(self) -> int:
        return len(self.motions)

    def __repr__(self) -> str:
        modes = ", ".join(" = ".join(m.modes or m.boundary_modes) for m in self.motions)
        return f"<Cell {self.loads} {modes or 'no motion'}>"


class Rejected(Result):
    """A mode without a motion at the load, and the reason."""

    __slots__ = ("mode", "violated", "margin", "because", "_details")

    def __init__(self, details: Mapping[str, Any]):
        self._details = details
        self.mode: str = details["mode"]
        self.violated: Optional[str] = details["violated"]
        self.margin: Optional[Fraction] = value(details.get("margin"))
        self.because: Tuple[str, ...] = tuple(details.get("because", ()))

    def _parts(self) -> Tuple[Any, ...]:
        return (self._details,)

    def __repr__(self) -> str:
        return f"<Rejected {self.mode}: {self.violated or ' and '.join(self.because)}>"


class Solution(Result):
    """The exact solution of a scene. Everything is made when it is accessed. Iterating gives the motions at the load.

    A pickle has the scene, which is solved again where a number is asked for; a mechanism's file must be there.
    """

    def __init__(self, scene: "Scene"):
        #: the scene that was solved
        self.scene = scene

    def _parts(self) -> Tuple[Any, ...]:
        return (self.scene,)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Solution) and (self.scene == other.scene or self.to_json() == other.to_json())

    def __hash__(self) -> int:
        return hash(self.to_json())

    def __iter__(self) -> Iterator[Motion[Fraction]]:
        return iter(self.motions)

    def __len__(self) -> int:
        return len(self.motions)

    @cached_property
    def _solution(self) -> "_core.Solution":
        return self.scene._scene.solve()  # type: ignore[no-any-return]

    def at(self, load: Number) -> "Solution":
        """The solution of the same scene at another ``load``, in the load's unit (F in N). Raises ValueError if the
        mechanism has no load, or the number is none.

        >>> import slipproof
        >>> slipproof.solve("cases/city-bicycle.toml", F=None).at(300).motions[0].modes
        ('stick/stick',)
        """
        if self.load_symbol is None:
            raise wrong_value("load", load, "none: the mechanism has no load")
        return self.scene._with_load(self.load_symbol, load).solve()

    @cached_property
    def _document(self) -> Dict[str, Any]:
        return json.loads(self.to_json())  # type: ignore[no-any-return]

    def to_json(self) -> str:
        """The output of ``slipproof solve --json``, byte for byte."""
        return self._solution.json()

    def to_dict(self) -> Dict[str, Any]:
        """The document as a new dict, in which exact numbers are texts."""
        return json.loads(self.to_json())  # type: ignore[no-any-return]

    def text(self, digits: int = 6) -> str:
        """The text that ``slipproof solve`` prints; decimals have this many ``digits``."""
        return self._solution.text(digits)

    @property
    def name(self) -> str:
        """The name of the scene."""
        return self._document["scene"]  # type: ignore[no-any-return]

    @property
    def notes(self) -> List[str]:
        """Defaults and derived values that the scene does not give."""
        return list(self._document["notes"])

    @property
    def load(self) -> Optional[Fraction]:
        """The load, F for a bicycle; None if the scene gives none: then it was solved for every load."""
        load = self._document["load"]
        return value(load["value"]) if load else None

    @property
    def load_symbol(self) -> Optional[str]:
        """The symbol of the mechanism's load, ``F`` for a bicycle; None if it has none."""
        load = self._document["load"]
        return load["symbol"] if load else None

    @cached_property
    def motions(self) -> Tuple[Motion[Fraction], ...]:
        """Every motion at the load. Raises ValueError if the scene gives no load: then use ``cells``."""
        found = self._solution.motions()
        if found is None:
            raise ValueError(f"found no {self.load_symbol} in the scene, expected one for motions; without it ask for "
                             "cells and ranges")
        return tuple(Motion(modes, boundary_modes, bool(modes), _Native(self._solution, i, names),
                            {name: (lower and ratio(lower), upper and ratio(upper))
                             for name, (lower, upper) in ranges.items()})
                     for i, (modes, boundary_modes, names, ranges) in enumerate(found))

    @cached_property
    def rejected(self) -> Tuple[Rejected, ...]:
        """The modes without a motion at the load."""
        return tuple(Rejected(r) for r in self._document.get("rejected", ()))

    @cached_property
    def continua(self) -> Tuple[Continuum, ...]:
        """Modes with infinitely many motions at the load; without a load, ``cells`` have them."""
        return tuple(Continuum(c) for c in self._document.get("continua", ()))

    @property
    def hysteresis(self) -> Tuple[str, ...]:
        """Modes that exist only because static coefficients are larger than kinetic ones."""
        return tuple(self._document.get("hysteresis", ()))

    @cached_property
    def ranges(self) -> Tuple[Range, ...]:
        """The loads of each mode that is consistent at some load; empty for a mechanism without a load."""
        return tuple(Range(r["mode"], Interval.read(r["load"], r["closed"]), r) for r in self._document.get("ranges", ()))

    @cached_property
    def cells(self) -> Tuple[Cell, ...]:
        """All loads, divided into points and open intervals with the same motions. Raises ValueError if the scene gives
        its load, or has none: then use ``motions``."""
        if self.load_symbol is None:
            raise ValueError("found a mechanism without a load, expected one with a load for cells; it has motions")
        if self.load is not None:
            raise ValueError(f"found {self.load_symbol} = {self.load} in the scene, expected none for cells; leave it out, "
                             f"or replace({self.load_symbol}=None), or ask for motions")
        return tuple(_cell(*cell) for cell in self._solution.cells())

    @property
    def only(self) -> bool:
        """Whether it has one motion at the load, and no other."""
        return len(self.motions) == 1 and not self.continua

    def phase_line(self) -> str:
        """The loads of each mode as SVG."""
        return phase_line([(r.mode, r.loads) for r in self.ranges], self.load, self.load_symbol or "")

    def __repr__(self) -> str:
        return f"<slipproof.Solution of {self.name!r}: {self.text().rstrip().splitlines()[-1]}>"

    def _repr_html_(self) -> str:
        if "motions" in self._document:
            rows = [[" = ".join(m.modes or m.boundary_modes), m.status,
                     ", ".join(f"{name} = {m.values[name]}" for name in m.values if m.values[name] != 0)]
                    for m in self.motions]
            head = ["modes", "", "what is not 0"]
        else:
            rows = [[r.mode, str(r.loads)] for r in self.ranges]
            head = ["mode", self.load_symbol or ""]
        return table(head, rows, self.name) + (self.phase_line() if self.ranges else "")


class _Pairs(Values[Affine]):
    """Affine numbers of a cell."""

    __slots__ = ()

    def _make(self, pairs: Any) -> Affine:
        return Affine(ratio(pairs[0]), ratio(pairs[1]))


def _cell(lower: Any, upper: Any, lower_closed: bool, upper_closed: bool, motions: Any, continua: Any) -> Cell:
    loads = Interval(lower and ratio(lower), upper and ratio(upper), lower_closed, upper_closed)
    made = []
    for modes, boundary_modes, accelerations, forces in motions:
        undetermined = {name: (None, None) for name, x in forces.items() if x is None}
        known = {**accelerations, **{name: x for name, x in forces.items() if x is not None}}
        made.append(Motion(modes, boundary_modes, bool(modes), _Pairs(known), undetermined))
    return Cell(loads, made, continua)
