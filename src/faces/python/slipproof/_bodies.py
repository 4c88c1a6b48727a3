"""What a mechanism of bodies is made of: each class is a table of its file, each field a key.

Vectors are pairs of numbers or expressions, in space triples; what is None is left out. The language is described in
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
    """A body, in kg and kg m^2, or, with ``acceleration`` in place of ``mass`` and ``inertia``, one that moves as prescribed.
    In space ``inertia`` has three or six entries, ``spin`` and ``turning`` are vectors, and ``turn`` is a quaternion, or
    ``{"axis": [...], "angle": "theta"}``."""

    name: str
    mass: Optional[Expression] = None
    inertia: Optional[Union[Expression, Vector]] = None  #: about the centre of mass
    at: Optional[Vector] = None  #: the centre of mass
    angle: Optional[Union[str, Vector]] = None  #: an entry of ``angles``, or a cosine and a sine
    velocity: Optional[Vector] = None
    spin: Optional[Union[Expression, Vector]] = None
    acceleration: Optional[Vector] = None
    turning: Optional[Union[Expression, Vector]] = None
    shape: Optional[Union[Mapping[str, Any], List[Mapping[str, Any]]]] = None
    names: Optional[Mapping[str, str]] = None
    turn: Optional[Union[Vector, Mapping[str, Any]]] = None
    by: Optional[str] = None  #: the joint that places it
    displacement: Optional[Expression] = None  #: along that joint


@dataclass(frozen=True)
class Contact(_Part):
    """A point or, with a ``radius``, a disc of the body ``of`` on a line or disc of the body ``on``; lengths in m. In space
    a sphere in place of a disc, a plane in place of a line; ``tangent`` is the direction from which slips are counted."""

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
    tangent: Optional[Vector] = None


@dataclass(frozen=True)
class Joint(_Part):
    """``kind``: pin, slider, weld, rod, rope, spring, gear; in space ball, hinge, universal and cylindrical in place of pin.
    Lengths are in m, the ``force`` of a spring in N."""

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
    to_axis: Optional[Vector] = None
    friction: Optional[Union[Expression, Mapping[str, Expression]]] = None
    radius: Optional[Expression] = None
    ring: Optional[Expression] = None


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
    """A couple ``is_``, in N m, on a body, counterclockwise; in space a vector."""

    on: str
    is_: Union[Expression, Vector]
    back_on: Optional[str] = None
    axes: Optional[str] = None
