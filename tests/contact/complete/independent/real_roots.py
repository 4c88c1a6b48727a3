"""Real roots of polynomials with integer coefficients, isolated by Descartes' rule of signs (Vincent, Collins, Akritas).
A polynomial is a list of coefficients, lowest first."""
from fractions import Fraction
from math import gcd

PRIME = (1 << 61) - 1


def trimmed(p):
    p = list(p)
    while p and p[-1] == 0:
        p.pop()
    return p


def primitive(p):
    """The multiple with integer coefficients without a common factor, of one with integers or Fractions."""
    p = trimmed(p)
    common = 1
    for c in p:
        d = Fraction(c).denominator
        common = common * d // gcd(common, d)
    p = [int(c * common) for c in p]
    factor = gcd(*p) if p else 1
    return [c // factor for c in p]


def product(a, b):
    result = [0] * (len(a) + len(b) - 1) if a and b else []
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            result[i + j] += x * y
    return result


def total(*polynomials):
    result = [0] * max(map(len, polynomials))
    for p in polynomials:
        for i, c in enumerate(p):
            result[i] += c
    return result


def multiple(factor, p):
    return [factor * c for c in p]


def at(p, t):
    """p(t) of a number or an Interval."""
    result = Fraction(0)
    for c in reversed(p):
        result = result * t + c
    return result


def quotient(a, b):
    """a / b, which must be exact."""
    a, b = trimmed(a), trimmed(b)
    result = [0] * (len(a) - len(b) + 1)
    for i in reversed(range(len(result))):
        result[i], rest = divmod(a[i + len(b) - 1], b[-1])
        assert rest == 0
        for j, c in enumerate(b):
            a[i + j] -= result[i] * c
    assert not any(a)
    return result


def divided(a, b):
    """Quotient and remainder, in Fractions."""
    a, b = [Fraction(c) for c in trimmed(a)], trimmed(b)
    result = [Fraction(0)] * max(len(a) - len(b) + 1, 0)
    for i in reversed(range(len(result))):
        result[i] = a[i + len(b) - 1] / b[-1]
        for j, c in enumerate(b):
            a[i + j] -= result[i] * c
    return result, trimmed(a)


def quotient_of(a, b):
    return divided(a, b)[0]


def common_factor(a, b):
    a, b = trimmed(a), trimmed(b)
    while b:
        a, b = b, divided(a, b)[1]
    return a


def is_squarefree(p):
    """True is certain: there is no double root modulo a prime that does not divide the leading coefficient. False may be
    a coincidence of this prime."""
    if p[-1] % PRIME == 0:
        return False
    a, b = [c % PRIME for c in p], trimmed([i * c % PRIME for i, c in enumerate(p)][1:])
    while b:
        inverse = pow(b[-1], -1, PRIME)
        a = a[:]
        while len(a) >= len(b):
            factor = a[-1] * inverse % PRIME
            shift = len(a) - len(b)
            for j, c in enumerate(b):
                a[shift + j] = (a[shift + j] - factor * c) % PRIME
            a = trimmed(a)
        a, b = b, a
    return len(a) == 1


def shifted(p):
    """p(x + 1)."""
    p = list(p)
    for i in range(len(p) - 1):
        for j in range(len(p) - 2, i - 1, -1):
            p[j] += p[j + 1]
    return p


def changes(p):
    signs = [c > 0 for c in p if c != 0]
    return sum(a != b for a, b in zip(signs, signs[1:]))


def in_unit_interval(p, numerator=0, level=0):
    """Roots in (0, 1): pairs (numerator, level) of intervals (numerator, numerator + 1) / 2^level with one root each, and
    (numerator, level, True) for roots that are such a number."""
    bound = changes(shifted(p[::-1]))
    if bound == 0:
        return
    if bound == 1:
        yield numerator, level, False
        return
    n = len(p) - 1
    left = [c << (n - i) for i, c in enumerate(p)]  # 2^n p(x / 2)
    right = shifted(left)
    yield from in_unit_interval(left, 2 * numerator, level + 1)
    if right[0] == 0:
        yield 2 * numerator + 1, level + 1, True
    yield from in_unit_interval(right, 2 * numerator + 1, level + 1)


def value(p, x, bits):
    """2^(bits n) p(x / 2^bits)."""
    result, scale = 0, 1
    for c in reversed(p):
        result = result * x + c * scale
        scale <<= bits
    return result


def refined(p, lower, upper, bits, wanted):
    """The interval (lower, upper) / 2^bits with one root, narrowed to one of the grid 2^-wanted. A secant proposes; only
    signs decide."""
    at = value(p, lower, bits)
    if at == 0:  # another root
        at = value([i * c for i, c in enumerate(p)][1:], lower, bits)
    left = at > 0
    while bits < wanted:
        step = min(wanted - bits, max(4, bits))
        lower, upper, bits = lower << step, upper << step, bits + step
        while upper - lower > 1:
            a, b = abs(value(p, lower, bits)), abs(value(p, upper, bits))
            guess = lower + (upper - lower) * a // (a + b) if a + b else lower
            for middle in (guess - 1, guess + 2, (lower + upper) // 2):
                if lower < middle < upper:
                    at = value(p, middle, bits)
                    if at == 0:
                        return middle, middle, bits
                    lower, upper = (middle, upper) if (at > 0) == left else (lower, middle)
    return lower, upper, bits


def real_roots(p, wanted):
    """Intervals (lower, upper) / 2^wanted, one for each real root of a squarefree polynomial."""
    p = primitive(p)
    if len(p) < 2:
        return []
    bound = max(abs(c) for c in p[:-1]) // abs(p[-1]) + 2
    e = bound.bit_length()
    result = []
    for side in (1, -1):
        mirrored = [c * side**i for i, c in enumerate(p)]
        for numerator, level, is_root in in_unit_interval([c << (e * i) for i, c in enumerate(mirrored)]):
            lower, upper, bits = numerator, numerator + (0 if is_root else 1), level - e
            if bits < 0:
                lower, upper, bits = lower << -bits, upper << -bits, 0
            if is_root:
                lower, upper = lower << wanted - bits, upper << wanted - bits
            else:
                lower, upper, bits = refined(mirrored, lower, upper, bits, wanted)
                lower, upper = lower << wanted - bits, upper << wanted - bits
            result.append((lower, upper) if side > 0 else (-upper, -lower))
    if p[0] == 0:
        result.append((0, 0))
    return sorted(result)
