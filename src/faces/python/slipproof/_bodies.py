"""What a mechanism of bodies is made of: each class is a table of its file, each field a key.

Vectors are pairs of numbers or expressions; what is None is left out. The language is described in
cases/mechanisms/bodies/README.md.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

from ._numbers import Number

Expression = Union[str, Number]
Vector = Sequence[Expression]


class _Part:
    def to_dict(self) -> Dict[str, Any]:
        """The table of a mechanism's file."""
        found = ((field.name.rstrip("_"), getattr(self, field.name)) for field in fields(self))
        return {name: value for name, value in found if value is not None}


@dataclass(frozen=True)
class Body(_Part):
    """A body, in kg and kg m^2, or, with ``acceleration`` in place of ``mass`` and ``inertia``, one that moves as prescribed."""

    name: str
    mass: Optional[Expression] = None
    inertia: Optional[Expression] = None  #: about the centre of mass
    at: Optional[Vector] = None  #: the centre of mass
    angle: Optional[Union[str, Vector]] = None  #: an entry of ``angles``, or a cosine and a sine
    velocity: Optional[Vector] = None
    spin: Optional[Expression] = None
    acceleration: Optional[Vector] = None
    turning: Optional[Expression] = None
    shape: Optional[Union[Mapping[str, Any], List[Mapping[str, Any]]]] = None
    names: Optional[Mapping[str, str]] = None


@dataclass(frozen=True)
class Contact(_Part):
    """A point or, with a ``radius``, a disc of the body ``of`` on a line or disc of the body ``on``; lengths in m."""

    name: str
    of: str
    point: Vector
    normal: Optional[Vector] = None
    friction: Optional[Union[Expression, Mapping[str, Expression]]] = None
    on: Optional[str] = None  #: the ground, if left out
    radius: Optional[Expression] = None
    through: Optional[Vector] = None
    on_point: Optional[Vector] = None
    on_radius: Optional[Expression] = None
    rolling_resistance: Optional[Expression] = None
    bilateral: Optional[bool] = None
    lift_needs: Optional[List[str]] = None
    state: Optional[str] = None
    slip_direction: Optional[Vector] = None
    names: Optional[Mapping[str, str]] = None


@dataclass(frozen=True)
class Joint(_Part):
    """``kind``: pin, slider, weld, rod, rope, spring, gear. Lengths are in m, the ``force`` of a spring in N."""

    name: str
    kind: str
    between: Tuple[str, str]
    at: Optional[Vector] = None
    to: Optional[Vector] = None
    axis: Optional[Vector] = None
    length: Optional[Expression] = None
    force: Optional[Expression] = None
    ratio: Optional[Expression] = None
    carrier: Optional[str] = None
    one_sided: Optional[bool] = None
    state: Optional[str] = None
    names: Optional[Mapping[str, str]] = None


@dataclass(frozen=True)
class Friction(_Part):
    """A brake, a clutch: a couple up to ``limit``, in N m, between two bodies."""

    name: str
    between: Tuple[str, str]
    limit: Union[Expression, Mapping[str, Expression]]
    force: Optional[str] = None
    state: Optional[str] = None


@dataclass(frozen=True)
class Force(_Part):
    """A force ``is_``, in N, on a body, at its centre of mass if ``at`` is left out."""

    on: str
    is_: Vector
    at: Optional[Vector] = None
    axes: Optional[str] = None
    back_on: Optional[str] = None


@dataclass(frozen=True)
class Torque(_Part):
    """A couple ``is_``, in N m, on a body, counterclockwise."""

    on: str
    is_: Expression
    back_on: Optional[str] = None
