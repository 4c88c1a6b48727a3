"""One contact that slips in space: with d = (1 - t^2, 2 t) / (1 + t^2), turned by an exact angle, u_N = 0 gives r_N, and
u_T x d = 0 is a quartic in t."""
from fractions import Fraction

from pattern import direction_at, direction_polynomials, roots_of
from real_roots import at, common_factor, multiple, product, quotient_of, total


def one_slip(pattern, turn):
    W, q, mu = pattern.W, pattern.q, pattern.mu[0]
    x, y = direction_polynomials(turn)
    force = [[Fraction(1), 0, Fraction(1)], multiple(-mu, x), multiple(-mu, y)]
    row = [total(*(multiple(W[i][j], force[j]) for j in range(3))) for i in range(3)]
    if q[0] == 0:
        yield from unloaded_slip(pattern, row, turn)
        return
    ux = total(multiple(q[1], row[0]), multiple(-q[0], row[1]))
    uy = total(multiple(q[2], row[0]), multiple(-q[0], row[2]))
    rest = common_factor(ux, uy)  # where both are 0 the contact sticks
    if not rest:
        return
    ux, uy = quotient_of(ux, rest), quotient_of(uy, rest)
    for t in roots_of(total(product(ux, y), multiple(-1, product(uy, x))), 5 - len(rest)):
        d = direction_at(t, turn)
        normal = -q[0] / (W[0][0] - mu * (W[0][1] * d[0] + W[0][2] * d[1]))
        yield pattern.solution([normal, -mu * (normal * d[0]), -mu * (normal * d[1])], [d])


def unloaded_slip(pattern, row, turn):
    """u_N = 0 does not give r_N if q_N = 0, but d; and then u_T x d = 0 gives r_N."""
    q, mu = pattern.q, pattern.mu[0]
    for t in roots_of(row[0], 2):
        d = direction_at(t, turn)
        ux, uy = (at(row[i], t) / (1 + t * t) for i in (1, 2))
        normal = (q[2] * d[0] - q[1] * d[1]) / (ux * d[1] - uy * d[0])
        yield pattern.solution([normal, -mu * (normal * d[0]), -mu * (normal * d[1])], [d])
