"""Intervals of fixed-point numbers with 2^-BITS, rounded outward."""
from fractions import Fraction

BITS = 320
ONE = 1 << BITS


class Interval:
    __slots__ = ("lo", "hi")

    def __init__(self, lo, hi):
        self.lo, self.hi = lo, hi

    @staticmethod
    def of(x):
        """Of an integer, a Fraction, or an Interval."""
        if isinstance(x, Interval):
            return x
        scaled = Fraction(x) * ONE
        return Interval(scaled.numerator // scaled.denominator, -(-scaled.numerator // scaled.denominator))

    def __add__(self, other):
        other = Interval.of(other)
        return Interval(self.lo + other.lo, self.hi + other.hi)

    __radd__ = __add__

    def __neg__(self):
        return Interval(-self.hi, -self.lo)

    def __sub__(self, other):
        return self + -Interval.of(other)

    def __rsub__(self, other):
        return Interval.of(other) - self

    def __mul__(self, other):
        other = Interval.of(other)
        ends = (self.lo * other.lo, self.lo * other.hi, self.hi * other.lo, self.hi * other.hi)
        return Interval(min(ends) >> BITS, -(-max(ends) >> BITS))

    __rmul__ = __mul__

    def __truediv__(self, other):
        """Raises ZeroDivisionError if the divisor may be 0."""
        other = Interval.of(other)
        if other.lo <= 0 <= other.hi:
            raise ZeroDivisionError
        ends = [(x << BITS, y) for x in (self.lo, self.hi) for y in (other.lo, other.hi)]
        return Interval(min(x // y for x, y in ends), max(-(-x // y) for x, y in ends))

    def __rtruediv__(self, other):
        return Interval.of(other) / self

    def sign(self):
        """None if it is not decided."""
        return 1 if self.lo > 0 else -1 if self.hi < 0 else 0 if self.lo == self.hi == 0 else None

    def __float__(self):
        return float(Fraction(self.lo + self.hi, 2 * ONE))


def sign(x):
    """Of a number or of an Interval; None if it is not decided."""
    return x.sign() if isinstance(x, Interval) else (x > 0) - (x < 0)


def is_within(x, told):
    """Whether all of x, a number or an Interval, is in the range (lower, upper) of Fractions."""
    lower, upper = told
    lo, hi = (Fraction(x.lo, ONE), Fraction(x.hi, ONE)) if isinstance(x, Interval) else (x, x)
    return (lower is None or lower <= lo) and (upper is None or hi <= upper)
