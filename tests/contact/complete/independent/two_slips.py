"""Two contacts that slip in space: u_N = 0 twice gives both r_N by Cramer's rule, and u_T x d = 0 twice are two equations,
of degree (4, 2) and (2, 4) in (t_1, t_2). Their resultant has degree 20 in t_1. It has a factor of degree 4, where Cramer's
determinant and both numerators are 0; the other 16 roots are the candidates. For each t_2 is a rational function of t_1:
the root of the remainder of the second equation divided by the first."""
from fractions import Fraction

from intervals import sign
from pattern import Undecided, direction_at, direction_polynomials, roots_of
from real_roots import at, multiple, primitive, product, quotient, total, trimmed


def times_each(by_first, by_second):
    """A product of a polynomial in t_1 and one in t_2: a polynomial in t_2 with coefficients that are some in t_1."""
    return [multiple(c, by_first) for c in by_second]


def added(*bivariate):
    width = max(map(len, bivariate))
    return [total(*(b[i] if i < len(b) else [0] for b in bivariate)) for i in range(width)]


def slip_equations(pattern, turn):
    """Both u_T x d, times Cramer's determinant and (1 + t^2) of the two; the determinant; and the first numerator, which
    depends on t_2 only."""
    W, q = pattern.W, pattern.q
    x, y = direction_polynomials(turn)
    force = [[[1, 0, 1], multiple(-mu, x), multiple(-mu, y)] for mu in pattern.mu]

    def row(i, contact):
        return total(*(multiple(W[i][3 * contact + j], force[contact][j]) for j in range(3)))

    determinant = added(times_each(row(0, 0), row(3, 1)), multiple_of(-1, times_each(row(3, 0), row(0, 1))))
    first = total(multiple(-q[0], row(3, 1)), multiple(q[3], row(0, 1)))
    second = total(multiple(-q[3], row(0, 0)), multiple(q[0], row(3, 0)))

    def velocity(i):
        return added(multiple_of(q[i], determinant), times_each(row(i, 0), first), times_each(second, row(i, 1)))

    F1 = added(in_first(velocity(1), y), multiple_of(-1, in_first(velocity(2), x)))
    F2 = added(in_second(velocity(4), y), multiple_of(-1, in_second(velocity(5), x)))
    return F1, F2, determinant, first


def multiple_of(factor, bivariate):
    return [multiple(factor, c) for c in bivariate]


def in_first(bivariate, p):
    return [product(c, p) for c in bivariate]


def in_second(bivariate, p):
    result = [[0]] * (len(bivariate) + len(p) - 1)
    for i, c in enumerate(bivariate):
        for j, f in enumerate(p):
            result[i + j] = total(result[i + j], multiple(f, c))
    return result


def integers(bivariate):
    width = max(map(len, bivariate))
    flat = [Fraction(c) for row in bivariate for c in list(row) + [0] * (width - len(row))]
    common = 1
    for c in flat:
        common *= (c * common).denominator
    return [[int(c * common) for c in flat[i:i + width]] for i in range(0, len(flat), width)]


def remainder(F, G):
    """Of a^k F divided by G of degree 2 in t_2, with a its leading coefficient: R_0 + R_1 t_2, and k."""
    F, steps = [list(c) for c in F], 0
    while len(F) > 2:
        lead = F.pop()
        F = [product(G[2], c) for c in F]
        for i in (0, 1):
            at = len(F) - 2 + i
            F[at] = total(F[at], multiple(-1, product(lead, G[i])))
        steps += 1
    return F[0], F[1], steps


def resultant_with_quadratic(R0, R1, G):
    """Of R_0 + R_1 t_2 and G."""
    return total(product(G[0], product(R1, R1)), multiple(-1, product(G[1], product(R0, R1))), product(G[2], product(R0, R0)))


def two_slips(pattern, turn):
    W, q, mu = pattern.W, pattern.q, pattern.mu
    F1, F2, determinant, first = slip_equations(pattern, turn)
    F1, F2, determinant, first = integers(F1), integers(F2), integers(determinant), integers([[c] for c in first])
    if not trimmed(F1[2]) or not first[2][0]:
        raise Undecided("an equation of lower degree")
    R0, R1, steps = remainder(F2, F1)
    resultant = resultant_with_quadratic(R0, R1, F1)
    for _ in range(steps):
        resultant = quotient(resultant, F1[2])
    D0, D1, more = remainder(determinant, first)
    spurious = primitive(resultant_with_quadratic(D0, D1, first))
    resultant = primitive(resultant)
    if len(resultant) != 21 or len(spurious) != 5:
        raise Undecided("a slip in the direction that has no parameter, or a family of them")
    for t1 in roots_of(quotient(resultant, spurious), 16):
        divisor = at(R1, t1)
        if sign(divisor) is None:
            raise Undecided("two slips with the same first direction")
        t2 = -at(R0, t1) / divisor
        d = [direction_at(t1, turn), direction_at(t2, turn)]
        a = [[W[i][3 * j] - mu[j] * (W[i][3 * j + 1] * d[j][0] + W[i][3 * j + 2] * d[j][1]) for j in (0, 1)] for i in (0, 3)]
        cramer = a[0][0] * a[1][1] - a[0][1] * a[1][0]
        normal = [(a[0][1] * q[3] - a[1][1] * q[0]) / cramer, (a[1][0] * q[0] - a[0][0] * q[3]) / cramer]
        yield pattern.solution([f for N, m, e in zip(normal, mu, d) for f in (N, -m * (N * e[0]), -m * (N * e[1]))], d)
