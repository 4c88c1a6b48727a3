"""Power series in time up to t^2 over fractions, and vectors of these: all that second derivatives at the instant see."""
from fractions import Fraction


class Series:
    __slots__ = ("c",)

    def __init__(self, c0, c1=0, c2=0):
        self.c = c0, c1, c2

    def __add__(self, other):
        a, b = self.c, series(other).c
        return Series(a[0] + b[0], a[1] + b[1], a[2] + b[2])

    def __sub__(self, other):
        a, b = self.c, series(other).c
        return Series(a[0] - b[0], a[1] - b[1], a[2] - b[2])

    def __mul__(self, other):
        if not isinstance(other, Series):
            return Series(*(product(x, other) for x in self.c))
        a, b = self.c, other.c
        return Series(product(a[0], b[0]), product(a[0], b[1]) + product(a[1], b[0]),
                      product(a[0], b[2]) + product(a[1], b[1]) + product(a[2], b[0]))

    def __neg__(self):
        return Series(*(-x for x in self.c))

    __rmul__ = __mul__

    def inverse(self):
        a, b, c = map(Fraction, self.c)
        return Series(1 / a, -b / a**2, b * b / a**3 - c / a**2)

    def root(self, first):
        """The square root whose value at the instant is `first`, which the caller knows."""
        a, b, c = map(Fraction, self.c)
        assert first * first == a
        second = b / (2 * first)
        return Series(first, second, (c - second * second) / (2 * first))

    def derivative(self):
        """Known up to t only; its last coefficient is not used."""
        return Series(self.c[1], 2 * self.c[2], 0)

    @property
    def value(self):
        return self.c[0]

    @property
    def first(self):
        return self.c[1]

    @property
    def second(self):
        """The second derivative."""
        return 2 * self.c[2]


def product(x, y):
    return x * y if x and y else 0  # most are


def series(x):
    return x if isinstance(x, Series) else Series(x)


class Vector(tuple):
    """Three components: fractions, series, or whatever has sums and products."""

    def __new__(cls, *components):
        return super().__new__(cls, components)

    def __add__(self, other):
        return Vector(*(x + y for x, y in zip(self, other)))

    def __sub__(self, other):
        return Vector(*(x - y for x, y in zip(self, other)))

    def __neg__(self):
        return Vector(*(-x for x in self))

    def __mul__(self, factor):
        return Vector(*(x * factor for x in self))

    __rmul__ = __mul__

    def dot(self, other):
        return self[0] * other[0] + self[1] * other[1] + self[2] * other[2]

    def cross(self, other):
        return Vector(self[1] * other[2] - self[2] * other[1], self[2] * other[0] - self[0] * other[2],
                      self[0] * other[1] - self[1] * other[0])


ZERO = Vector(Fraction(0), Fraction(0), Fraction(0))
UNITS = tuple(Vector(*(Fraction(i == k) for i in range(3))) for k in range(3))


def rotation(quaternion):
    """The columns of the rotation of a quaternion w x y z of any length."""
    w, axis = Fraction(quaternion[0]), Vector(*map(Fraction, quaternion[1:]))
    norm = w * w + axis.dot(axis)
    return [u + (axis.cross(u) * w + axis.cross(axis.cross(u))) * (2 / norm) for u in UNITS]


def apply(columns, v):
    return columns[0] * v[0] + columns[1] * v[1] + columns[2] * v[2]


def apply_back(columns, v):
    return Vector(*(c.dot(v) for c in columns))
