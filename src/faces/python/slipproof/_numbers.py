"""Numbers in and out: always exact."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from numbers import Integral
from typing import Any, Dict, Generic, Iterator, Mapping, NamedTuple, Optional, Sequence, Tuple, TypeVar, Union

from ._errors import wrong_type, wrong_value
from ._result import Result

#: What counts as a number: a float is taken exactly as it is, a text as it is written (``"3/4"``, ``"0.1"``).
Number = Union[int, float, Fraction, Decimal, str]
Ends = Optional[Tuple[Number, Number]]


def _digits(n: int) -> str:
    return str(n) if n.bit_length() < 10_000 else format(Decimal(n), "f")  # Python limits the length of str(int)


def _integer(digits: str) -> int:
    return int(digits) if len(digits) < 4_000 else int(Decimal(digits))


def ends_text(name: str, ends: Any) -> Optional[Tuple[str, str]]:
    """A pair of numbers as texts. ``name`` is its name in messages."""
    if ends is None:
        return None
    if isinstance(ends, str) or not hasattr(ends, "__len__") or len(ends) != 2:
        raise wrong_type(name, ends, "a pair of numbers")
    first, last = ends
    return text_of(first, f"{name}[0]"), text_of(last, f"{name}[1]")


def text_of(value: Any, name: str) -> str:
    """The number as a text that the library reads. ``name`` is its name in messages."""
    if isinstance(value, str):
        return value
    if isinstance(value, bool) or not hasattr(value, "as_integer_ratio"):
        if isinstance(value, Integral) and not isinstance(value, bool):
            return _digits(int(value))
        if isinstance(value, Fraction):
            return f"{_digits(value.numerator)}/{_digits(value.denominator)}"
        raise wrong_type(name, value, "a number: int, float, Fraction, Decimal, or a text such as '3/4'")
    try:
        numerator, denominator = value.as_integer_ratio()
    except (ValueError, OverflowError):  # NaN, infinities
        raise wrong_value(name, value, "a finite number") from None
    text = _digits(int(numerator))
    return text if denominator == 1 else f"{text}/{_digits(int(denominator))}"


def fraction(text: str) -> Fraction:
    """The Fraction of a text from the library, ``-3/4`` or ``5``."""
    numerator, _, denominator = text.partition("/")
    return ratio((_integer(numerator), _integer(denominator) if denominator else 1))


def ratio(pair: Tuple[int, int]) -> Fraction:
    """A Fraction from numbers that are already in lowest terms."""
    return Fraction(*pair, _normalize=False)


class Bounds(NamedTuple):
    """The proved bounds of a number: ``lower`` <= number <= ``upper``."""

    lower: Fraction
    upper: Fraction

    def __str__(self) -> str:
        return f"[{float(self.lower)}, {float(self.upper)}]"


SpaceNumber = Union[Fraction, Bounds]


def enclosed(ends: Sequence[str]) -> SpaceNumber:
    """The number between two ends of a document, exactly where they are the same."""
    lower, upper = fraction(ends[0]), fraction(ends[1])
    return lower if lower == upper else Bounds(lower, upper)


class Affine:
    """``alpha + beta F``: a force or an acceleration as a function of the load F.

    >>> x = Affine(Fraction(1, 2), Fraction(3))
    >>> x(2)
    Fraction(13, 2)
    >>> print(x)
    1/2 + 3 F
    """

    __slots__ = ("alpha", "beta")

    def __init__(self, alpha: Fraction, beta: Fraction):
        self.alpha = alpha
        self.beta = beta

    def __call__(self, F: Number) -> Fraction:
        """The value at a load, exactly."""
        return self.alpha + self.beta * Fraction(text_of(F, "F"))

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Affine):
            return self.alpha == other.alpha and self.beta == other.beta
        return self.beta == 0 and self.alpha == other

    def __hash__(self) -> int:
        return hash((self.alpha, self.beta)) if self.beta else hash(self.alpha)

    def __str__(self) -> str:
        if not self.beta:
            return str(self.alpha)
        sign = "-" if self.beta < 0 else "+" if self.alpha else ""
        return f"{self.alpha if self.alpha else ''} {sign} {abs(self.beta)} F".replace("  ", " ").strip()

    def __repr__(self) -> str:
        return f"Affine({self.alpha!r}, {self.beta!r})"


def value(text: Any) -> Any:
    """Converts a number of a document: a text, or [alpha, beta]; None stays None."""
    if text is None:
        return None
    if isinstance(text, str):
        return fraction(text)
    return Affine(fraction(text[0]), fraction(text[1]))


N = TypeVar("N")


class Values(Mapping[str, N], Generic[N]):
    """Numbers by name, each made when it is accessed."""

    __slots__ = ("_texts", "_made")

    def __reduce__(self) -> Tuple[Any, ...]:
        return Values.of, (dict(self),)

    @classmethod
    def of(cls, numbers: Mapping[str, Any]) -> "Values[Any]":
        """Numbers that are there already."""
        made: "Values[Any]" = Values(dict.fromkeys(numbers))
        made._made.update(numbers)
        return made

    def __init__(self, texts: Mapping[str, Any]):
        self._texts = texts
        self._made: Dict[str, Any] = {}

    def __getitem__(self, name: str) -> N:
        made = self._made.get(name)
        if made is None:
            made = self._made[name] = self._make(self._texts[name])
        return made  # type: ignore[no-any-return]

    def _make(self, text: Any) -> Any:
        return value(text)

    def __iter__(self) -> Iterator[str]:
        return iter(self._texts)

    def __len__(self) -> int:
        return len(self._texts)

    def __repr__(self) -> str:
        return "{" + ", ".join(f"{name}: {self[name]}" for name in self) + "}"


class Interval(Result):
    """A set of loads from ``lower`` to ``upper``; None stands for an infinite end.

    >>> i = Interval(Fraction(1), None, True, False)
    >>> print(i, 1 in i, 0 in i)
    [1, +oo) True False
    """

    __slots__ = ("lower", "upper", "lower_closed", "upper_closed")

    def __init__(self, lower: Optional[Fraction], upper: Optional[Fraction], lower_closed: bool, upper_closed: bool):
        self.lower, self.upper = lower, upper
        self.lower_closed, self.upper_closed = lower_closed, upper_closed

    def _parts(self) -> Tuple[Any, ...]:
        return self.lower, self.upper, self.lower_closed, self.upper_closed

    @classmethod
    def read(cls, ends: Any, closed: Any) -> "Interval":
        """Makes an interval from the two ``ends`` in a document and which of them belong to it, ``closed``."""
        return cls(value(ends[0]), value(ends[1]), closed[0], closed[1])

    @property
    def is_point(self) -> bool:
        """Whether it is one load."""
        return self.lower is not None and self.lower == self.upper

    def __contains__(self, load: Number) -> bool:
        x = Fraction(text_of(load, "load"))
        above = self.lower is None or x > self.lower or (self.lower_closed and x == self.lower)
        return above and (self.upper is None or x < self.upper or (self.upper_closed and x == self.upper))

    def __str__(self) -> str:
        if self.is_point:
            return f"{{{self.lower}}}"
        left = "(-oo" if self.lower is None else f"{'[' if self.lower_closed else '('}{self.lower}"
        right = "+oo)" if self.upper is None else f"{self.upper}{']' if self.upper_closed else ')'}"
        return f"{left}, {right}"

    def __repr__(self) -> str:
        return f"<{self}>"
