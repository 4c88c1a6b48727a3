"""Which contact modes are consistent, for many bicycles at once."""

from __future__ import annotations

from typing import Any, Dict, List, NamedTuple, Tuple

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import Doubles, doubles, one_of, whole
from ._errors import wrong_value

#: All contact modes, rear wheel/front wheel; bit i of a mask belongs to the mode with index i.
MODES: Tuple[str, ...] = _core.mode_names

_NUMBERS = ("M", "R", "h", "b2", "b3", "I1", "I2", "I3", "r1", "r2", "L", "f", "g", "F")


class ConsistentModes(NamedTuple):
    """The modes of each scene as bits, and which tier decided."""

    consistent: "npt.NDArray[np.uint16]"
    """the non-strict conditions hold for some motion of the mode"""
    strict: "npt.NDArray[np.uint16]"
    """of these, those in which some motion holds all conditions strictly"""
    tier: "npt.NDArray[np.uint8]"
    """0 binary64 with error bounds, 1 exact arithmetic"""
    tiers: Dict[str, int]
    """how many scenes each tier decided"""

    def __eq__(self, other: object) -> bool:
        return (isinstance(other, ConsistentModes) and self.tiers == other.tiers
                and np.array_equal(self.consistent, other.consistent) and np.array_equal(self.strict, other.strict)
                and np.array_equal(self.tier, other.tier))

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __hash__(self) -> int:
        return hash(self.consistent.tobytes())

    def names(self, scene: int) -> List[str]:
        """The consistent modes of one scene; ``scene`` counts from 0. Raises IndexError."""
        mask = int(self.consistent[scene])
        return [name for i, name in enumerate(MODES) if mask >> i & 1]


def _column(name: str, value: Any) -> Doubles:
    return doubles(name, value, (0, 1)).reshape(-1)


def consistent_modes(*, M: Any, R: Any, h: Any, b2: Any, b3: Any, I1: Any, I2: Any, I3: Any, r1: Any, r2: Any, L: Any,
                     f: Any, g: Any, F: Any, J: Any = None, kind: str = "internal", threads: int = 0) -> ConsistentModes:
    """The consistent modes of every scene, exactly, at nearly the speed of binary64.

    Each argument is one number for all scenes, or an array with one for each, in SI units, with the names of a scene
    file: the masses ``M`` (kg); the lengths ``R``, ``h``, ``b2``, ``b3``, ``r1``, ``r2``, ``L`` (m); the moments of inertia
    ``I1``, ``I2``, ``I3``, ``J`` (kg m^2); the friction ``f``; gravity ``g`` (m/s^2); the force ``F`` (N), of the ``kind``
    "internal" or "external". Contiguous arrays of float64 are not copied. Without ``J`` only modes with both wheels on the road are
    modelled. ``threads``: 0 for all cores. Raises TypeError, ValueError (also for a NaN).

    >>> import numpy as np, slipproof
    >>> found = slipproof.consistent_modes(M=94, R=0.3, h=0.56, b2=0.34, b3=0.68, I1=0.01, I2=0.12, I3=0.2, r1=0.09,
    ...     r2=0.036, L=0.17, J=15.7, f=0.8, g=9.81, F=np.array([300.0, 3000.0]))
    >>> found.names(0), found.names(1)
    (['stick/stick'], ['stick/lift'])
    """
    given = dict(M=M, R=R, h=h, b2=b2, b3=b3, I1=I1, I2=I2, I3=I3, r1=r1, r2=r2, L=L, f=f, g=g, F=F)
    columns = {name: _column(name, given[name]) for name in _NUMBERS}
    if J is not None:
        columns["J"] = _column("J", J)
    size = common_size(columns)
    external = one_of("kind", kind, ("internal", "external")) == "external"
    found = _core.consistent_modes(columns, external, size, whole("threads", threads, 0, 4096))
    return ConsistentModes(*found)


def common_size(columns: Dict[str, Doubles]) -> int:
    """The common length of all columns that have more than one number; 1 if there are none."""
    longest = next((name for name, column in columns.items() if column.size != 1), None)
    if longest is None:
        return 1
    size = columns[longest].size
    for name, column in columns.items():
        if column.size not in (1, size):
            raise wrong_value(name, f"{column.size} numbers", f"{size} as in {longest}, or 1")
    return size
