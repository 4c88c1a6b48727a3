"""Mechanisms: any system of rigid bodies with dry friction, in the plane or in space."""

from __future__ import annotations

import os
import tomllib
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

from . import _core
from ._arrays import one_of, whole
from ._bodies import Body, Contact, Force, Friction, Joint, Torque
from ._certify import _mechanism
from ._errors import InputError, wrong_type, wrong_value
from ._html import table
from ._numbers import Number
from ._progress import Progress, reporter
from ._result import Report, Result
from ._scene import Scene, as_toml
from ._solution import Solution

_SCHEMA = "slipproof/mechanism/1"


class Search(Report):
    """The result of a search. ``verdict``: ``found`` and ``none found`` are about the samples; ``unique`` is proved for
    the whole domain; ``undecided`` if no point of the domain was found, or one in space is undecided."""

    def __init__(self, document: str, text: str, verdict: str):
        super().__init__(document, text)
        self.verdict = verdict

    def _parts(self) -> Tuple[Any, ...]:
        return self._json, self._text, self.verdict

    def __repr__(self) -> str:
        return f"<slipproof.Search {self.verdict}>"


class Mechanism(Result):
    """A mechanism: from a file, or a shipped one, with :meth:`load`; from a text or a dict with :meth:`parse`; from
    bodies with :meth:`of`.

    >>> import slipproof
    >>> ladder = slipproof.Mechanism.load("ladder")
    >>> ladder.parameters
    ('m', 'l', 'I', 'd', 'mu_f', 'mu_w', 'g')
    >>> s = ladder.solve(dict(m=12, l=2, I=16, d=1, mu_f="0.5", mu_w="0.2", g="9.81", theta={"tan_half": "1/2"}), load=100)
    >>> s.motions[0].phi
    Fraction(0, 1)
    """

    __slots__ = ("_path", "_about", "_document")

    def __init__(self, path: str, about: Dict[str, Any], document: Optional[Dict[str, Any]] = None):
        self._path, self._about, self._document = path, about, document

    def _parts(self) -> Tuple[Any, ...]:
        return self._path, self._about, self._document

    @classmethod
    def load(cls, path: Union[str, "os.PathLike[str]"]) -> "Mechanism":
        """Reads a mechanism from the file ``path``, or the shipped one with this name. Raises FileNotFoundError if there
        is neither, InputError for mistakes in it."""
        name = _mechanism("path", path)
        return cls(os.fsdecode(name), _core.describe_mechanism(name))

    @classmethod
    def parse(cls, mechanism: Union[str, Mapping[str, Any]], file: str = "mechanism") -> "Mechanism":
        """Reads ``mechanism``: the text of a mechanism's file, or a dict with its tables (``schema`` may be left out,
        numbers may be numbers). ``file`` is its name in messages. Raises InputError."""
        if isinstance(mechanism, Mapping):
            return cls._of({"schema": _SCHEMA, **mechanism}, file)
        if not isinstance(mechanism, str):
            raise wrong_type("mechanism", mechanism, "a text or a dict; Mechanism.load(path) reads a file")
        about = _core.describe_mechanism(os.fsencode(file), mechanism.encode("utf-8", "surrogateescape"))
        return cls(file, about, tomllib.loads(mechanism, parse_float=lambda text: text.replace("_", "")))

    @classmethod
    def of(cls, name: str, *, bodies: Sequence[Body], gravity: Union[str, Sequence[Number]],
           parameters: Optional[Mapping[str, Any]] = None, contacts: Sequence[Contact] = (),
           joints: Sequence[Joint] = (), friction: Sequence[Friction] = (), forces: Sequence[Force] = (),
           torques: Sequence[Torque] = (), load: Optional[Mapping[str, str]] = None,
           dimension: Optional[int] = None, **tables: Any) -> "Mechanism":
        """A mechanism of bodies, called ``name``. Raises InputError with all mistakes.

        ``bodies``, ``contacts``, ``joints``, ``friction``, ``forces`` and ``torques`` are its parts. ``gravity``: an
        acceleration (m/s^2), or "none". ``parameters``: by symbol a domain such as ``"mu >= 0"``, or a dict with domain,
        unit and meaning. ``load``: a dict with the symbol of the force that is varied. ``dimension``: 2, or 3 in space; by
        default as many as ``gravity`` has components, or 2. ``tables`` are others of its file: ``angles``,
        ``definitions``, ``assume``, ...

        >>> import slipproof
        >>> from slipproof import Body, Contact, Force
        >>> feet = [Contact(name, "crate", [x, -1], normal=[0, 1], friction="mu") for name, x in (("left", -1), ("right", 1))]
        >>> crate = slipproof.Mechanism.of("crate", gravity=[0, -10], parameters={"mu": "mu >= 0"}, load={"symbol": "F"},
        ...     bodies=[Body("crate", mass=2, inertia=3, at=[0, 1])], contacts=feet, forces=[Force("crate", ["F", 0])])
        >>> [motion.modes for motion in crate.solve({"mu": "1/2"}, load=4).motions]
        [('stick/stick',)]
        """
        document: Dict[str, Any] = {"schema": _SCHEMA, "name": name, "gravity": gravity}
        in_space = isinstance(gravity, (list, tuple)) and len(gravity) == 3
        if dimension is not None or in_space:
            document["dimension"] = 3 if dimension is None else dimension
        if parameters:
            document["parameters"] = dict(parameters)
        if load is not None:
            document["load"] = dict(load)
        document.update(tables)
        for key, parts in (("body", bodies), ("contact", contacts), ("joint", joints), ("friction", friction),
                           ("force", forces), ("torque", torques)):
            if parts:
                document[key] = [part.to_dict() for part in parts]
        return cls._of(document, "mechanism")

    @classmethod
    def _of(cls, document: Dict[str, Any], file: str) -> "Mechanism":
        toml = as_toml(document)
        try:
            return cls(file, _core.describe_mechanism(os.fsencode(file), toml.text.encode("utf-8", "surrogateescape")),
                       document)
        except InputError as error:
            raise InputError([(toml.place(d.line) or file, 0, 0, d.message) for d in error.diagnostics]) from None

    def _text(self) -> Optional[bytes]:
        return None if self._document is None else as_toml(self._document).text.encode("utf-8", "surrogateescape")

    def to_dict(self) -> Dict[str, Any]:
        """The tables of its file."""
        if self._document is None:
            raise wrong_value("mechanism", self._path, "one from a text, a dict or bodies")
        return dict(self._document)

    @property
    def name(self) -> str:
        """Its name in the file."""
        return self._about["name"]  # type: ignore[no-any-return]

    @property
    def dimension(self) -> int:
        """2 in the plane, 3 in space."""
        return self._about["dimension"]  # type: ignore[no-any-return]

    @property
    def parameters(self) -> Tuple[str, ...]:
        """The symbols that need values in a scene, apart from angles and the load."""
        return tuple(p["symbol"] for p in self._about["parameters"])

    @property
    def angles(self) -> Tuple[str, ...]:
        """The names of its angles; a value is {"tan_half": x}, {"cos": c, "sin": s}, {"tan": t} or {"degrees": d}."""
        return tuple(self._about["angles"])

    @property
    def load_symbol(self) -> Optional[str]:
        """The symbol of its load; None if it has none."""
        return self._about["load"]  # type: ignore[no-any-return]

    @property
    def elements(self) -> Tuple[str, ...]:
        """Its contacts and friction elements, in the order of their states in a mode."""
        return tuple(self._about["elements"])

    def show(self) -> str:
        """What the program understands of it, and what looks wrong, as ``slipproof show`` prints it."""
        return _core.show_mechanism(os.fsencode(self._path), self._text())

    def scene(self, values: Mapping[str, Any], *, load: Optional[Number] = None, along: Optional[str] = None,
              state: Optional[Mapping[str, str]] = None, name: Optional[str] = None) -> Scene:
        """A scene of it, called ``name``, with ``values`` for its parameters and angles, in the units of its file, and
        optionally a ``load``. ``along``: the parameter that is the load in place of its own. ``state``: the states of
        motion of elements that move already. Raises ValueError for a load without a symbol, InputError."""
        if not isinstance(values, Mapping):
            raise wrong_type("values", values, "a dict")
        own = self._path if self._document is None else self._document
        document: Dict[str, Any] = {"name": name or self.name, "mechanism": own, "values": dict(values)}
        if along is not None:
            document["along"] = along
        if state is not None:
            document["state"] = dict(state)
        if load is not None:
            symbol = along or self.load_symbol
            if symbol is None:
                raise wrong_value("load", load, "none: the mechanism has no load")
            document["values"][symbol] = load
        return Scene(document)

    def solve(self, values: Mapping[str, Any], *, load: Optional[Number] = None, along: Optional[str] = None,
              state: Optional[Mapping[str, str]] = None) -> Solution:
        """Every motion at these ``values``; without a ``load``, at every load. ``along`` and ``state`` are those of
        :meth:`scene`. Raises what that raises."""
        return self.scene(values, load=load, along=along, state=state).solve()

    def search(self, *, within: str = "", wanted: Optional[str] = None, samples: Optional[int] = None, seed: int = 1,
               hysteresis: bool = False, law: Optional[str] = None, threads: int = 0, progress: Progress = None) -> Search:
        """Searches samples of the domain, for every load (in space, for one), for points with no motion, several, or a
        continuum, or at which an impact gains energy.

        ``within`` narrows the domain, ``"mu < 1"``; with ``wanted`` (none, several, continuum, gain) the search ends at
        the first such place. ``law``: search impacts by it (newton, moreau, poisson), whatever the file says. ``samples``: points of the domain, by default 30 to 2000; ``seed`` of them. ``hysteresis``:
        report several motions that become one if static coefficients equal the kinetic ones, too. ``threads``: 0 for all
        cores. ``progress``: a function of (done, all), or True. Raises ValueError, InputError.
        """
        if not isinstance(within, str):
            raise wrong_type("within", within, "str")
        return Search(*_core.search(
            os.fsencode(self._path), self._text(), within, None if samples is None else whole("samples", samples, 1, 1_000_000_000),
            whole("seed", seed, 0, 2**64 - 1),
            None if wanted is None else one_of("wanted", wanted, ("none", "several", "continuum", "gain")), bool(hysteresis),
            None if law is None else one_of("law", law, ("newton", "moreau", "poisson")), whole("threads", threads, 0, 4096), reporter(progress)))

    def __repr__(self) -> str:
        return f"<slipproof.Mechanism {self.name!r}>"

    def _repr_html_(self) -> str:
        rows = [[p["symbol"], p["unit"], p["meaning"]] for p in self._about["parameters"]]
        return table(["symbol", "unit", "meaning"], rows, self.name)


def shipped_mechanisms() -> List[str]:
    """The names of the mechanisms that come with slipproof."""
    return _core.shipped_mechanisms()


def as_mechanism(mechanism: Union[str, "os.PathLike[str]", Mapping[str, Any], Mechanism]) -> Mechanism:
    """Converts a file, a shipped one's name, a text or a dict to a Mechanism."""
    if isinstance(mechanism, Mechanism):
        return mechanism
    is_text = isinstance(mechanism, Mapping) or (isinstance(mechanism, str) and "\n" in mechanism)
    return Mechanism.parse(mechanism) if is_text else Mechanism.load(mechanism)  # type: ignore[arg-type]


def search(mechanism: Union[str, "os.PathLike[str]", Mapping[str, Any], Mechanism], **options: Any) -> Search:
    """Does :meth:`Mechanism.search` with its ``options``. ``mechanism`` is a file, a shipped one's name, a text, a dict or
    a Mechanism. Raises FileNotFoundError, InputError, and what the method raises."""
    return as_mechanism(mechanism).search(**options)
