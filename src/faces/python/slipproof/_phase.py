"""Phase diagrams: the motions over a parameter and the load."""

from __future__ import annotations

import os
from math import atan2, degrees
from typing import Any, Dict, List, Mapping, Optional, Tuple

from . import _core
from ._arrays import whole
from ._result import Document
from ._errors import wrong_type, wrong_value
from ._html import COLOURS
from ._numbers import Ends, ends_text, fraction
from ._scene import as_scene


class PhaseDiagram(Document):
    """A phase diagram, exact in every column. ``svg`` is the picture; :meth:`draw` draws into axes of matplotlib."""

    def __init__(self, svg: str, document: str):
        super().__init__(document)
        self.svg = svg

    def _parts(self) -> Tuple[Any, ...]:
        return self.svg, self._json

    def save(self, path: "str | os.PathLike[str]") -> None:
        """Writes the SVG file ``path``: first under another name, so that the file is never incomplete."""
        _core.write_file(os.fspath(path), self.svg)

    def bands(self) -> Dict[str, List[Tuple[float, float, float]]]:
        """For plotting programs: for each set of motions (x, from, to), column by column, as floats."""
        document = self.to_dict()
        low, high = _ends(document["load"]["range"])
        result: Dict[str, List[Tuple[float, float, float]]] = {}
        for column in document["columns"]:
            x = _across(column["x"])
            for cell in column["cells"]:
                ends = cell["load"]
                bottom = low if ends[0] is None else max(low, float(fraction(ends[0])))
                top = high if ends[1] is None else min(high, float(fraction(ends[1])))
                if bottom < top:
                    result.setdefault(_set_name(cell), []).append((x, bottom, top))
        return result

    def draw(self, ax: Any = None) -> Any:
        """Draws the regions into the axes ``ax`` of matplotlib, by default the current ones, and returns the axes. Regions
        differ in colours that colour-blind readers can tell apart, and where these do not suffice in hatches."""
        if ax is None:
            import matplotlib.pyplot  # type: ignore[import]  # noqa: PLC0415 - not needed for anything else

            ax = matplotlib.pyplot.gca()
        document = self.to_dict()
        columns = sorted({x for bands in self.bands().values() for x, _, _ in bands})
        for i, (name, bands) in enumerate(self.bands().items()):
            left, width = _sides(columns, [x for x, _, _ in bands])
            ax.bar(left, [top - bottom for _, bottom, top in bands], width, [bottom for _, bottom, _ in bands],
                   align="edge", linewidth=0, label=name, **_look(i))
        ax.set_xlabel(document["x"]["symbol"])
        ax.set_ylabel(document["load"]["symbol"])
        ax.set_title(document["scene"])
        ax.legend()
        return ax

    def _repr_svg_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"<slipproof.PhaseDiagram, {len(self.to_dict()['columns'])} columns>"


_HATCHES = ("", "//", "..", "xx", "--")


def _look(region: int) -> Dict[str, Any]:
    """The colour of a region, and a hatch where colours occur again."""
    colour = COLOURS[region % len(COLOURS)]
    return {"facecolor": colour, "edgecolor": "white", "hatch": _HATCHES[region // len(COLOURS) % len(_HATCHES)]}


def _across(x: Any) -> float:
    """The value of a parameter, or the degrees of an angle."""
    if isinstance(x, Mapping):
        return degrees(atan2(float(fraction(x["sin"])), float(fraction(x["cos"]))))
    return float(fraction(x))


def _ends(texts: Any) -> Tuple[float, float]:
    return float(fraction(texts[0])), float(fraction(texts[1]))


def _set_name(cell: Mapping[str, Any]) -> str:
    motions = [" = ".join(motion["modes"] or motion["boundary_modes"]) for motion in cell["motions"]]
    return ", ".join([*motions, *(f"continuum of {mode}" for mode in cell["continua"])]) or "no motion"


def _sides(columns: List[float], xs: List[float]) -> Tuple[List[float], List[float]]:
    """The left end and the width of the bar of each column: it extends half-way to its neighbours."""
    middle = [(a + b) / 2 for a, b in zip(columns, columns[1:])]
    left = dict(zip(columns, [columns[0], *middle]))
    right = dict(zip(columns, [*middle, columns[-1]]))
    return [left[x] for x in xs], [right[x] - left[x] for x in xs]


def phase_diagram(scene: Any, *, x: str = "", y: str = "", x_range: Ends = None, y_range: Ends = None,
                  columns: int = 240, ax: Any = None) -> PhaseDiagram:
    """The phase diagram of a scene: a parameter on the horizontal axis, the load on the vertical axis.

    ``scene`` is as in :func:`solve`. ``x``: a parameter, or an angle of a mechanism in degrees; by default the
    coefficient of friction. ``y``: another load. ``x_range`` and ``y_range``: pairs of numbers; by default they are chosen
    from the scene. ``columns``: in how many values of x the motions are computed. With ``ax`` the diagram is also drawn
    into these axes of matplotlib. Raises ValueError for ranges and parameters that cannot be used, InputError.
    """
    for name, symbol in (("x", x), ("y", y)):
        if not isinstance(symbol, str):
            raise wrong_type(name, symbol, "the symbol of a parameter")
    made = as_scene(scene, {})
    diagram = PhaseDiagram(*_core.phase_diagram(*made._source(), x, y, ends_text("x_range", x_range),
                                                ends_text("y_range", y_range), whole("columns", columns, 2, 10_000)))
    if ax is not None:
        diagram.draw(ax)
    return diagram
