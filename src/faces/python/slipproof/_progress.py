"""Progress of a long call."""

from __future__ import annotations

import sys
from typing import Any, Callable, Optional, Union

from ._errors import wrong_type

#: A function of (done, all), or True for a bar on standard error. An exception of it ends the call.
Progress = Union[None, bool, Callable[[int, int], object]]


class ProgressBar:
    """A progress bar in plain text. ``stream`` is standard error by default.

    >>> import io
    >>> stream = io.StringIO()
    >>> bar = ProgressBar(stream, width=10)
    >>> bar(3, 10); bar(10, 10)
    >>> stream.getvalue().split(chr(13))[1:]
    ['[###       ]  30 %', '[##########] 100 %\\n']
    """

    def __init__(self, stream: Any = None, width: int = 50):
        self._stream = sys.stderr if stream is None else stream
        self._width = width
        self._shown = -1

    def __call__(self, done: int, all: int) -> None:
        percent = 100 * done // max(all, 1)
        if percent == self._shown:
            return
        self._shown = percent
        filled = self._width * percent // 100
        end = "\n" if done >= all else ""
        self._stream.write(f"\r[{'#' * filled:{self._width}}] {percent:3} %{end}")
        self._stream.flush()


def reporter(progress: Progress) -> Optional[Callable[[int, int], object]]:
    """The function that receives the progress of the work."""
    if progress is None or progress is False:
        return None
    if progress is True:
        return ProgressBar()
    if not callable(progress):
        raise wrong_type("progress", progress, "a function of (done, all), or True")
    return progress
