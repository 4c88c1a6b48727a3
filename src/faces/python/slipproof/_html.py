"""Tables and pictures for notebooks."""

from __future__ import annotations

from fractions import Fraction
from html import escape
from typing import List, Optional, Sequence, Tuple

from ._numbers import Interval

#: Colours that readers with any kind of colour blindness can tell apart: those of Okabe and Ito, without black.
COLOURS = ("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#f0e442")
_WIDTH, _LEFT, _ROW = 640, 130, 20


def table(head: Sequence[str], rows: Sequence[Sequence[str]], caption: str = "") -> str:
    """An HTML table of texts."""
    lines: List[str] = ["<table>"]
    if caption:
        lines.append(f"<caption>{escape(caption)}</caption>")
    lines.append("<tr>" + "".join(f"<th>{escape(cell)}</th>" for cell in head) + "</tr>")
    for row in rows:
        lines.append("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>")
    return "\n".join([*lines, "</table>"])


def _window(intervals: Sequence[Interval], load: Optional[Fraction]) -> Tuple[float, float]:
    """A range from below all finite ends to above them."""
    ends = [float(x) for i in intervals for x in (i.lower, i.upper) if x is not None]
    ends += [float(load)] if load is not None else []
    low, high = (min(ends), max(ends)) if ends else (-1.0, 1.0)
    margin = (high - low) / 8 or max(abs(low), 1.0)
    return low - margin, high + margin


def phase_line(ranges: Sequence[Tuple[str, Interval]], load: Optional[Fraction], symbol: str) -> str:
    """SVG with a bar for each mode over the loads at which it is consistent, and a line at the load."""
    low, high = _window([interval for _, interval in ranges], load)

    def at(x: Optional[Fraction], infinite: float) -> float:
        return _LEFT + (_WIDTH - _LEFT - 10) * ((infinite if x is None else float(x)) - low) / (high - low)

    height = _ROW * len(ranges) + 30
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH} {height}" width="{_WIDTH}" '
             f'height="{height}" font-family="sans-serif" font-size="12" fill="currentColor">',
             f"<title>{escape(symbol)} at which each mode is consistent</title>"]
    for row, (mode, interval) in enumerate(ranges):
        y = _ROW * row + 4
        left, right = at(interval.lower, low), at(interval.upper, high)
        parts.append(f'<text x="{_LEFT - 8}" y="{y + 12}" text-anchor="end">{escape(mode)}</text>')
        parts.append(f'<rect x="{left:.1f}" y="{y}" width="{max(right - left, 2):.1f}" height="14" '
                     f'fill="{COLOURS[row % len(COLOURS)]}"><title>{escape(str(interval))}</title></rect>')
    bottom = _ROW * len(ranges) + 18
    parts.append(f'<text x="{_LEFT}" y="{bottom}">{low:.6g}</text>')
    parts.append(f'<text x="{_WIDTH - 10}" y="{bottom}" text-anchor="end">{escape(symbol)} = {high:.6g}</text>')
    if load is not None:
        x = at(load, 0)
        parts.append(f'<line x1="{x:.1f}" y1="0" x2="{x:.1f}" y2="{bottom - 14}" stroke="currentColor"/>')
        parts.append(f'<text x="{x:.1f}" y="{bottom + 10}" text-anchor="middle">{escape(symbol)} = {load}</text>')
    return "\n".join([*parts, "</svg>"])
