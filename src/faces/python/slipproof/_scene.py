"""Scenes: a bicycle, or any mechanism, with exact numbers."""

from __future__ import annotations

import os
import tomllib
from pathlib import Path
from typing import Any, Dict, List, Mapping, Sequence, Tuple, Union

from . import _core
from ._errors import Diagnostic, InputError, wrong_type, wrong_value
from ._result import Result
from ._numbers import Ends, Number, ends_text, text_of
from ._solution import Solution
from ._space import Rest, SpaceSolution

_TABLE_OF = {"f": "road", "g": "road", "kind": "force", "F": "force", "P": "force", "name": ""}
_FILE = "scene"


def _quoted(text: str) -> str:
    escaped = "".join(c if c >= " " and c not in '"\\\x7f' else f"\\u{ord(c):04x}" for c in text)
    return f'"{escaped}"'


class _Toml:
    """Writes a dict as a scene file with one key on each line, and records the line of each key."""

    def __init__(self, document: Mapping[str, Any], is_mechanism: bool = False, has_lines: bool = False):
        self.is_mechanism = is_mechanism or has_lines
        self._has_lines = has_lines
        self.lines: List[str] = []
        self.keys: List[str] = []
        for key, value in document.items():
            if not isinstance(value, Mapping):
                self._add(f"{_quoted(self._name(key, ''))} = {self._value(value, key)}", key)
        for key, value in document.items():
            if isinstance(value, Mapping):
                self._table(self._name(key, ""), value)
        self.text = "\n".join(self.lines) + "\n"

    @staticmethod
    def _name(key: object, path: str) -> str:
        if isinstance(key, str):
            return key
        raise wrong_type(f"a key of {path or 'the scene'}", key, "str")

    def _add(self, line: str, key: str) -> None:
        self.lines.append(line)
        self.keys.append(key)

    def _table(self, name: str, table: Mapping[str, Any]) -> None:
        self._add(f"[{_quoted(name)}]", name)
        for key, value in table.items():
            path = f"{name}.{self._name(key, name)}"
            self._add(f"{_quoted(key)} = {self._value(value, path)}", path)

    def _value(self, value: Any, path: str) -> str:
        if isinstance(value, bool):
            return "true" if value else "false"
        if isinstance(value, int) and (self._has_lines or path in ("dimension", "mechanism.dimension")):
            return str(value)
        if isinstance(value, Mapping):
            inner = (f"{_quoted(self._name(k, path))} = {self._value(v, f'{path}.{k}')}" for k, v in value.items())
            return "{ " + ", ".join(inner) + " }"
        if isinstance(value, (list, tuple)) and (self.is_mechanism or path.startswith("mechanism.")):
            return "[" + ", ".join(self._value(v, f"{path}[{i + 1}]") for i, v in enumerate(value)) + "]"
        if isinstance(value, os.PathLike):
            value = os.fspath(value)
        return _quoted(text_of(value, path))

    def place(self, line: int) -> str:
        return self.keys[line - 1] if 0 < line <= len(self.keys) else ""


def as_toml(document: Mapping[str, Any]) -> _Toml:
    """A mechanism as its file."""
    return _Toml(document, is_mechanism=True)


def as_claims(document: Mapping[str, Any]) -> _Toml:
    """Claims as their file, in which whole numbers are lines of the paper."""
    return _Toml(document, has_lines=True)


def _bytes(text: str, file: str) -> Tuple[bytes, bytes]:
    return text.encode("utf-8", "surrogateescape"), os.fsencode(file)


def _tables(arguments: Mapping[str, Any]) -> Dict[str, Any]:
    """Keyword arguments as the tables of a scene file; those of a mechanism are at its top level."""
    if "mechanism" in arguments:
        return dict(arguments)
    document: Dict[str, Any] = {}
    for key, value in arguments.items():
        table = _TABLE_OF.get(key, "bicycle")
        if isinstance(value, Mapping) or not table:
            document[key] = value
        else:
            document.setdefault(table, {})[key] = value
    return document


class Scene(Result):
    """A bicycle or a mechanism with its numbers, read once and solved as often as needed. Immutable.

    From keyword arguments, ``Scene(R="0.34", h=..., f="0.8", g="9.81", F=300)``; from a dict with the tables of a scene
    file, in which ``mechanism`` may be a file, a name, or a dict with the tables of a mechanism's file; from a file with
    :meth:`load`; from its text with :meth:`parse`. Numbers, in SI units, are int, float (taken exactly),
    Fraction, Decimal, or texts as in a file. Raises InputError with all mistakes.
    """

    __slots__ = ("_scene", "_text", "_file")

    def __init__(self, document: Union[Mapping[str, Any], None] = None, /, **arguments: Any):
        if document is not None and not isinstance(document, Mapping):
            raise wrong_type("scene", document, "a dict; Scene.load(path) reads a file")
        toml = _Toml(_merged(document or {}, _tables(arguments)))
        self._text, self._file = toml.text, _FILE
        try:
            self._scene = _core.Scene(*_bytes(toml.text, _FILE))
        except InputError as error:
            raise InputError([_in_dict(d, toml) for d in error.diagnostics]) from None

    @classmethod
    def load(cls, path: Union[str, "os.PathLike[str]"]) -> "Scene":
        """Reads the scene file ``path`` (TOML). Raises FileNotFoundError, InputError for mistakes in it."""
        return cls._of(_read(path), os.fspath(path))

    @classmethod
    def parse(cls, text: str, file: str = _FILE) -> "Scene":
        """Reads the ``text`` of a scene file; ``file`` is its name in messages. Raises InputError."""
        if not isinstance(text, str):
            raise wrong_type("text", text, "str")
        return cls._of(text, file)

    @classmethod
    def _of(cls, text: str, file: str) -> "Scene":
        scene = cls.__new__(cls)
        scene._text, scene._file, scene._scene = text, file, _core.Scene(*_bytes(text, file))
        return scene

    @property
    def name(self) -> str:
        """Its name, or that of its file."""
        return self._scene.name

    @property
    def notes(self) -> List[str]:
        """Defaults and derived values that the scene does not give."""
        return self._scene.notes

    @property
    def is_mechanism(self) -> bool:
        """Whether it uses a mechanism's file; if not, it is a bicycle in the short form."""
        return "mechanism" in self.to_dict()

    def _source(self) -> Tuple[bytes, bytes]:
        return _bytes(self._text, self._file)

    def to_toml(self) -> str:
        """The text of a scene file; numbers stay as they were given."""
        return self._text

    def to_dict(self) -> Dict[str, Any]:
        """The scene as a dict; numbers are int, or texts as they were written."""
        return tomllib.loads(self._text, parse_float=lambda text: text.replace("_", ""))

    def replace(self, **changes: Any) -> "Scene":
        """The same scene with other numbers, ``changes`` by name: ``scene.replace(F=300)``; None removes one. Raises
        InputError."""
        document = self.to_dict()
        if self.is_mechanism:
            tables = {k: v for k, v in changes.items() if k in ("name", "mechanism", "along", "values", "state")}
            values = {k: v for k, v in changes.items() if k not in tables}
            if values:
                tables["values"] = {**tables.get("values", {}), **values}
            if "mechanism" not in tables and isinstance(document["mechanism"], str):
                document["mechanism"] = _from_here(document["mechanism"], self._file)
        else:
            tables = _tables(changes)
        return Scene(_merged(document, tables))

    def _with_load(self, symbol: str, load: Number) -> "Scene":
        """The scene with this load, in whatever form it had another one."""
        other: Dict[str, Any] = {} if self.is_mechanism else {"P": None}
        return self.replace(**other, **{symbol: load})

    @property
    def dimension(self) -> int:
        """2 for a scene in the plane, 3 for one in space."""
        return self._scene.dimension

    def solve(self) -> Solution:
        """Every motion at its load; without a load, the motions at every load. In space, a SpaceSolution, for which the
        load must have a value."""
        solution = Solution(self) if self.dimension == 2 else SpaceSolution(self)
        solution._solution  # noqa: B018 - solved here, not at the first look
        return solution

    def rest(self, *, parameter: str = "", tilt: Union[bool, Sequence[Number]] = False,
             map: Sequence[str] = (), x_range: Ends = None, y_range: Ends = None) -> Rest:
        """Whether it can rest, whether it must, and at which loads; with ``parameter``, at which of its values; with
        ``tilt``, up to which angle gravity can turn about this axis (in the plane ``tilt=True``); with ``map``, at which
        values of these two loads, within ``x_range`` and ``y_range``, pairs of numbers. Raises InputError for a scene that
        moves, and for symbols that are no loads."""
        if isinstance(tilt, bool):
            if tilt and self.dimension == 3:
                raise wrong_value("tilt", tilt, "an axis, such as (0, 1, 0)")
            axis: Sequence[Number] = (0, 0, 1) if tilt else ()
        elif len(tilt) != 3:
            raise wrong_value("tilt", tilt, "three coordinates of an axis")
        else:
            axis = tilt
        if isinstance(map, str) or len(map) not in (0, 2) or not all(isinstance(symbol, str) for symbol in map):
            raise wrong_value("map", map, "the symbols of two loads")
        if not map and (x_range or y_range):
            raise wrong_value("map", map, "the symbols of the loads that have ranges")
        return Rest(*self._scene.rest(parameter, [text_of(x, "tilt") for x in axis], list(map),
                                      ends_text("x_range", x_range), ends_text("y_range", y_range)))

    def __repr__(self) -> str:
        return f"<slipproof.Scene {self.name!r}>"

    def _parts(self) -> Tuple[Any, ...]:
        return self._text, self._file

    def __reduce__(self) -> Tuple[Any, ...]:
        return Scene.parse, self._parts()


def _in_dict(diagnostic: Diagnostic, toml: _Toml) -> Tuple[str, int, int, str]:
    if diagnostic.file != _FILE:
        return diagnostic
    return (toml.place(diagnostic.line) or _FILE, 0, 0, diagnostic.message)


def _merged(document: Mapping[str, Any], more: Mapping[str, Any]) -> Dict[str, Any]:
    result = dict(document)
    for key, value in more.items():
        if isinstance(value, Mapping):
            inner = _merged(result.get(key, {}), value)
            result[key] = inner
        elif value is None:
            result.pop(key, None)
        else:
            result[key] = value
    return result


def _from_here(mechanism: str, file: str) -> str:
    """The path of a mechanism's file, relative to the folder of the scene if the file is there."""
    beside = Path(file).parent / mechanism
    return str(beside) if beside.exists() else mechanism


def _read(path: Union[str, "os.PathLike[str]"]) -> str:
    if not isinstance(path, (str, os.PathLike)):
        raise wrong_type("path", path, "a path")
    with open(path, encoding="utf-8", errors="surrogateescape") as file:
        return file.read()


def as_scene(scene: Any, changes: Mapping[str, Any]) -> Scene:
    """Converts a file, a dict or a Scene to a Scene."""
    if scene is None:
        return Scene(**changes)
    if isinstance(scene, Mapping):
        return Scene(scene, **changes)
    made = scene if isinstance(scene, Scene) else Scene.load(scene)
    return made.replace(**changes) if changes else made


def solve(scene: Union[None, str, "os.PathLike[str]", Mapping[str, Any], Scene] = None, /, **numbers: Any) -> Solution:
    """Every motion of a scene, exactly.

    ``scene`` is a file, a dict with the file's tables, or a :class:`Scene`. ``numbers``, in SI units, are its numbers by
    name, or replace some of them; None removes one. Without a load, finds the loads of every mode. Raises
    FileNotFoundError, InputError with all mistakes, TypeError for what is no number.

    >>> import slipproof
    >>> s = slipproof.solve(R="1/4", h=1, b="0.4", M2="1/20", M3="1/20", J="0.4", f=1, g="9.81",
    ...     kind="internal", P="3.27")
    >>> [m.modes[0] for m in s.motions]
    ['stick/stick', 'stick/slip+', 'stick/lift']
    >>> s.motions[0].a
    Fraction(327, 110)
    """
    return as_scene(scene, numbers).solve()
