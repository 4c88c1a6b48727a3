"""Results that the program also writes."""

from __future__ import annotations

import json
from typing import Any, Dict, Tuple

from ._result import Result


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
