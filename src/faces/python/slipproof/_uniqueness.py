"""The value of a parameter from which on a scene has several motions."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Optional, Tuple, Union

from . import _core
from ._result import Report
from ._errors import wrong_type
from ._numbers import fraction, value
from ._scene import as_scene


class Critical(Report):
    """The values of a parameter for which each load has one motion; ``to_dict()`` has all its ranges."""

    def __init__(self, document: str, text: str):
        super().__init__(document, text)
        self._dict = self.to_dict()

    @property
    def parameter(self) -> str:
        """The parameter that is varied."""
        return self._dict["parameter"]  # type: ignore[no-any-return]

    @property
    def value(self) -> Fraction:
        """The value in the scene itself."""
        return fraction(self._dict["value"])

    @property
    def critical(self) -> Union[None, Fraction, Tuple[Fraction, Fraction]]:
        """The least value above the first values with one motion at every load at which, or directly above which, some
        load has no motion, several or infinitely many. If it is irrational, returns two values that enclose it; None if
        there is no such value."""
        end = self._dict["critical"]
        return (fraction(end[0]), fraction(end[1])) if isinstance(end, list) else value(end)

    @property
    def one_motion(self) -> bool:
        """Whether the scene itself has one motion at every load."""
        return self._dict["at_value"]["one_motion"]  # type: ignore[no-any-return]

    @property
    def every_q(self) -> Optional[str]:
        """``unique``: the scene itself has one motion whatever else pushes it; or ``not unique``, ``undecided``. None if
        the theorem does not apply to its contacts."""
        told = self._dict["at_value"]["every_q"]
        return told and told["verdict"]  # type: ignore[no-any-return]

    def __repr__(self) -> str:
        return f"<slipproof.Critical {self.text().rstrip().rpartition(chr(10))[2].removeprefix('s ')}>"


def critical(scene: Any, *, x: str = "") -> Critical:
    """Finds exactly for which values of a parameter each load has one motion, and which loads have several.

    ``scene`` is as in :func:`solve`. ``x``: the parameter to vary, by default the coefficient of friction f of a
    bicycle, or a mechanism's first one. Raises ValueError if ``x`` is not a parameter, and for more than 32 modes.
    """
    if not isinstance(x, str):
        raise wrong_type("x", x, "the symbol of a parameter")
    return Critical(*_core.critical(*as_scene(scene, {})._source(), x))
