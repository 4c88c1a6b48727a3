"""Errors for input that cannot be used: the place, what was found and what was expected."""

from __future__ import annotations

from typing import NamedTuple, Optional, Sequence, Tuple, Union


class Diagnostic(NamedTuple):
    """One mistake in an input. Lines and columns count from 1; 0 if there is no place."""

    file: str
    line: int
    column: int
    message: str

    @property
    def place(self) -> str:
        """``file:line:column``, or the known part of it; for a dict the path of the key, ``bicycle.R``."""
        if not self.line:
            return self.file
        return f"{self.file}:{self.line}:{self.column}"

    def _part(self, word: str, end: Optional[str]) -> Optional[str]:
        start = self.message.find(word)
        if start < 0:
            return None
        text = self.message[start + len(word):]
        return text[: text.find(end)] if end and end in text else text

    @property
    def found(self) -> Optional[str]:
        """What was found, if the message says so."""
        return self._part("found ", ", expected ")

    @property
    def expected(self) -> Optional[str]:
        """What was expected, if the message says so."""
        return self._part("expected ", None)

    def __str__(self) -> str:
        return f"{self.place}: {self.message}" if self.place else self.message


class InputError(ValueError):
    """A file, a dict or an array that cannot be used. All mistakes are reported at once.

    >>> import slipproof
    >>> try:
    ...     slipproof.solve("cases/city-bicycle.toml", R="0.3x")
    ... except slipproof.InputError as error:
    ...     print(error.place, error.found)
    bicycle.R 'x'
    """

    __module__ = "slipproof"

    def __init__(self, diagnostics: Sequence[Union[Diagnostic, Tuple[str, int, int, str]]]):
        self.diagnostics: Tuple[Diagnostic, ...] = tuple(Diagnostic(*d) for d in diagnostics)
        super().__init__("\n".join(str(d) for d in self.diagnostics))

    @property
    def place(self) -> str:
        """The place of the first mistake."""
        return self.diagnostics[0].place

    @property
    def found(self) -> Optional[str]:
        """What was found there, if the message says so."""
        return self.diagnostics[0].found

    @property
    def expected(self) -> Optional[str]:
        """What was expected there, if the message says so."""
        return self.diagnostics[0].expected

    def __reduce__(self):  # type: ignore[no-untyped-def]
        return type(self), (tuple(tuple(d) for d in self.diagnostics),)


class TooMuchWork(RuntimeError):
    """Raised if more work would be needed than is allowed."""

    __module__ = "slipproof"


def wrong_type(name: str, value: object, expected: str) -> TypeError:
    """The error for an argument of a type that cannot be used."""
    return TypeError(f"{name}: found {type(value).__name__}, expected {expected}")


def wrong_value(name: str, found: object, expected: str) -> ValueError:
    """The error for an argument of the right type that cannot be used."""
    return ValueError(f"{name}: found {found}, expected {expected}")
