"""random_loads.py PROBLEMS: one contact in space, random matrices, mu and loads in small whole numbers, decided exactly.

The theorems of proofs/one-contact are compared with Sturm's sequences, which know nothing of them: the direction of slip
is d = (1 - t^2, 2 t)/(1 + t^2), t a root of a quartic F, and a slip is a root at which r_N and v are positive.
"""
import random
import sys
from collections import Counter
from fractions import Fraction
from math import gcd, lcm

DIRECTIONS = [(1, 0, 1), (0, 1, 1), (3, 4, 5), (4, 3, 5), (-3, 4, 5), (5, -12, 13), (-1, 0, 1), (0, -1, 1)]
SETS = {(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1), (0, 1, 2), (1, 0, 2), (0, 0, 3)}  # lift, stick, number of slips


def trimmed(p):
    while p and p[-1] == 0:
        p = p[:-1]
    return p


def plus(p, q, factor=1):
    length = max(len(p), len(q))
    return trimmed([a + factor * b for a, b in zip(p + [0] * (length - len(p)), q + [0] * (length - len(q)))])


def times(p, q):
    result = [0] * max(len(p) + len(q) - 1, 0)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            result[i + j] += a * b
    return trimmed(result)


def whole(p):
    """p times a positive number, with whole coefficients."""
    denominator = lcm(*(Fraction(a).denominator for a in p))
    return [int(a * denominator) for a in p]


def derivative(p):
    return trimmed([i * a for i, a in enumerate(p)][1:])


def remainder(p, q):
    """Of p by q, times a positive number."""
    while len(p) >= len(q):
        p = trimmed(plus([abs(q[-1]) * a for a in p], [0] * (len(p) - len(q)) + q, p[-1] * (1 if q[-1] < 0 else -1))[:len(p) - 1])
    divisor = gcd(*p)
    return [a // divisor for a in p]


def signs(f, g):
    """Tarski's query: the sum of the signs of g at the real roots of f."""
    sequence = [f, times(derivative(f), g)]
    while sequence[-1]:
        sequence.append([-a for a in remainder(sequence[-2], sequence[-1])])
    ends = [[p[-1] * side ** (len(p) - 1) for p in sequence[:-1]] for side in (-1, 1)]
    changes = [sum((a > 0) != (b > 0) for a, b in zip(end, end[1:])) for end in ends]
    return changes[0] - changes[1]


def inverse(w):
    (a, b, c), (_, d, e), (_, _, f) = w
    adjoint = [[d * f - e * e, c * e - b * f, b * e - c * d], [0, a * f - c * c, b * c - a * e], [0, 0, a * d - b * b]]
    det = a * adjoint[0][0] + b * adjoint[0][1] + c * adjoint[0][2]
    return [[Fraction(adjoint[min(i, j)][max(i, j)], det) for j in range(3)] for i in range(3)]


def decide(w, mu, q):
    """Lift, stick, the number of slips, the sum of their indices, and whether another load has several motions."""
    one, x, y = [1, 0, 1], [1, 0, -1], [0, 2]  # times 1 + t^2: 1 and d
    row = lambda i: plus([w[i][0] * a for a in one], plus([w[i][1] * a for a in x], [w[i][2] * a for a in y]), -mu)
    along = lambda a, b, c, d: plus(times(a, c), times(b, d))
    across = lambda a, b: plus(times(x, b), times(y, a), -1)  # d x (a, b)
    scaled = lambda p, factor: [factor * a for a in p] if factor else []
    f = plus(scaled(across(row(1), row(2)), -q[0]), times(row(0), across([q[1]], [q[2]])))
    v = plus(scaled(along(x, y, row(1), row(2)), -q[0]), times(row(0), along(x, y, [q[1]], [q[2]])))
    f, presses, moves = whole(f), whole(scaled(row(0), -q[0])), whole(times(v, row(0)))
    m = inverse(w)
    p = [-sum(a * b for a, b in zip(line, q)) for line in m]
    cone = mu * mu * p[0] * p[0] - p[1] * p[1] - p[2] * p[2]
    count = lambda g: sum(signs(f, times(g, h)) for h in ([1], presses, moves, times(presses, moves)))
    if q[0] == 0 or cone == 0 or len(f) < 5 or len(trimmed(v)) == 0 or signs(f, times(presses, presses)) != signs(f, [1]) \
            or signs(f, times(moves, moves)) != signs(f, [1]) or signs(f, times(derivative(f), derivative(f))) != signs(f, [1]):
        return None  # on a border, or d = (-1, 0)
    slips, indices = count([1]), count(scaled(derivative(f), -1))
    assert slips % 4 == 0 and indices % 4 == 0
    square = plus(plus(scaled(times(x, x), m[1][1]), scaled(times(x, y), 2 * m[1][2])), scaled(times(y, y), m[2][2]))
    unique = plus(square, times(one, plus(scaled(x, m[0][1]), scaled(y, m[0][2]))), mu)  # d . M (d + mu n)
    unique = whole(unique)
    several = m[1][1] + mu * m[0][1] < 0 or signs(unique, [1]) > 0
    return int(q[0] > 0), int(p[0] > 0 and cone > 0), slips // 4, indices // 4, several


def two_slips(rng, w, mu):
    """A load under which the contact may slip in two given directions; None if a force or a speed is negative there."""
    columns = []
    for sign, (x, y, n) in zip((1, -1), rng.sample(DIRECTIONS, 2)):
        edge = n, -mu * x, -mu * y
        columns += [[0, sign * x, sign * y], [-sign * sum(a * b for a, b in zip(row, edge)) for row in w]]
    det = lambda a, b, c: sum(a[i] * (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2]) for i in range(3))
    weights = [(-1) ** i * det(*columns[:i], *columns[i + 1:]) for i in range(4)]
    if min(weights) <= 0 <= max(weights):
        return None
    return [abs(weights[0]) * a + abs(weights[1]) * b for a, b in zip(*columns[:2])]


def drawn(rng):
    a = [[rng.randint(-4, 4) for _ in range(3)] for _ in range(3)]
    w = [[sum(x * y for x, y in zip(p, q)) + (i == j) for j, q in enumerate(a)] for i, p in enumerate(a)]
    mu = Fraction(rng.randint(1, 12), 4)
    tries = (two_slips(rng, w, mu) for _ in range(20))
    return w, mu, next((q for q in tries if q), [rng.randint(-9, 9) for _ in range(3)])


def main(problems):
    rng, seen, borders = random.Random(1), Counter(), 0
    for _ in range(problems):
        w, mu, q = drawn(rng)
        try:
            found = decide(w, mu, q)
        except AssertionError as wrong:
            raise AssertionError(f"W {w} mu {mu} q {q}") from wrong
        if found is None:
            borders += 1
            continue
        lift, stick, slips, indices, several = found
        assert (lift, stick, slips) in SETS, f"W {w} mu {mu} q {q}: found {found}"
        assert lift + stick + indices == 1, f"W {w} mu {mu} q {q}: the indices add up to {lift + stick + indices}"
        assert several or lift + stick + slips == 1, f"W {w} mu {mu} q {q}: several motions below the critical mu"
        seen[lift, stick, slips] += 1
    assert set(seen) == SETS, f"found {dict(seen)} only"
    print(f"{problems} problems, {borders} on a border: {dict(sorted(seen.items()))}")


if __name__ == "__main__":
    main(int(sys.argv[1]))
