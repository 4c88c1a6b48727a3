"""What all results have in common: equality, copies, pickles."""

from __future__ import annotations

from typing import Any, Dict, Tuple


class Result:
    """A value that is equal to another one of its class with the same parts, and made again from its parts. Results do
    not change, so that a copy is the result itself."""

    __slots__ = ()

    def _parts(self) -> Tuple[Any, ...]:
        """The arguments of the constructor."""
        raise NotImplementedError

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Result) and type(other) is type(self) and self._parts() == other._parts()

    def __hash__(self) -> int:
        return hash(repr(self._parts()))

    def __reduce__(self) -> Tuple[Any, ...]:
        return type(self), self._parts()

    def __copy__(self) -> "Result":
        return self

    def __deepcopy__(self, memo: Dict[int, Any]) -> "Result":
        return self
