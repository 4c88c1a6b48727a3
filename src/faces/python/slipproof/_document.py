"""Results that the program writes, too."""

from __future__ import annotations

import json
from typing import Any, Dict


class Document:
    """What a command of the program writes with ``--json``."""

    def __init__(self, document: str):
        self._json = document

    def to_json(self) -> str:
        """That document, byte for byte."""
        return self._json

    def to_dict(self) -> Dict[str, Any]:
        """The same as a dict."""
        return json.loads(self._json)  # type: ignore[no-any-return]


class Report(Document):
    """What a command writes with ``--json``, and what it prints without."""

    def __init__(self, document: str, text: str):
        super().__init__(document)
        self._text = text

    def text(self) -> str:
        """What the command prints."""
        return self._text
