"""What results have in common: equality, copies, pickles, and the documents that the program also writes."""

from __future__ import annotations

import json
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


class Document(Result):
    """The output of a command of the program with ``--json``."""

    def __init__(self, document: str):
        self._json = document

    def _parts(self) -> Tuple[Any, ...]:
        return (self._json,)

    def to_json(self) -> str:
        """The document, byte for byte."""
        return self._json

    def to_dict(self) -> Dict[str, Any]:
        """The document as a dict."""
        return json.loads(self._json)  # type: ignore[no-any-return]


class Report(Document):
    """The output of a command with ``--json``, and its text output without."""

    def __init__(self, document: str, text: str):
        super().__init__(document)
        self._text = text

    def _parts(self) -> Tuple[Any, ...]:
        return self._json, self._text

    def text(self) -> str:
        """The text that the command prints."""
        return self._text
