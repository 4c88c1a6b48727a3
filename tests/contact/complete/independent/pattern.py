"""Patterns of states, one for each contact: lift, stick, slip, or closed if it has no friction. Contacts that stick are
eliminated by exact linear algebra, and each condition of the law is decided in Fractions, or in intervals of width 2^-300
or so. What these cannot decide is never a solution, and is reported: `Undecided`."""
from dataclasses import dataclass
from fractions import Fraction

from families import member
from intervals import BITS, Interval, sign
from linear import solution_space, solve
from real_roots import is_squarefree, primitive, real_roots

TURNS = ((Fraction(1), Fraction(0)), (Fraction(3, 5), Fraction(4, 5)), (Fraction(5, 13), Fraction(-12, 13)))


class Undecided(Exception):
    pass


@dataclass
class Found:
    modes: tuple
    r: list  # numbers or Intervals
    u: list
    is_family: bool = False


def linear_components(states):
    """Forces that linear equations u = 0 determine."""
    return [i for k, s in enumerate(states) for i in range(3 * k, 3 * k + {"stick": 3, "closed": 1}.get(s, 0))]


def family(problem, states):
    """The motion of contacts that stick or lift where their equations are dependent."""
    linear = linear_components(states)
    space = solution_space([[problem.W[i][j] for j in linear] for i in linear], [-problem.q[i] for i in linear])
    if space is None:
        return []

    def forces(part):
        r = [Fraction(0)] * problem.size
        for i, x in zip(linear, part):
            r[i] = Fraction(x)
        return r

    point, directions = forces(space[0]), [forces(d) for d in space[1]]
    if any(sum(row[i] * d[i] for i in linear) for d in directions for row in problem.W):
        raise Undecided("open forces with several velocities")
    found = member(problem, states, point, directions)
    if found is None and len(directions) > 1:
        raise Undecided("several directions of open forces, none of which were found in the cones")
    return [Found(states, *found, True)] if found else []


class Pattern:
    """A problem in which the contacts that slip are left: u_S = W r_S + q, and r = base + lever r_S for all."""

    def __init__(self, problem, states):
        self.problem, self.states = problem, states
        self.slipping = [k for k, s in enumerate(states) if s == "slip"]
        linear = linear_components(states)
        S = [i for k in self.slipping for i in range(3 * k, 3 * k + 3)]
        W, q = problem.W, problem.q
        eliminated = solve([[W[i][j] for j in linear] for i in linear],
                           [[-q[i]] + [-W[i][j] for j in S] for i in linear])
        if eliminated is None:
            raise Undecided("the equations of contacts that stick are dependent")
        self.base, self.lever = {}, {}
        for i, row in zip(linear, eliminated):
            self.base[i], self.lever[i] = row[0], row[1:]
        self.q = [q[i] + sum(W[i][j] * self.base[j] for j in linear) for i in S]
        self.W = [[W[i][j] + sum(W[i][l] * self.lever[l][c] for l in linear) for c, j in enumerate(S)] for i in S]
        self.mu = [problem.mu[k] for k in self.slipping]

    def forces(self, slipping):
        r = [Fraction(0)] * self.problem.size
        for c, k in enumerate(self.slipping):
            r[3 * k:3 * k + 3] = slipping[3 * c:3 * c + 3]
        for i, base in self.base.items():
            r[i] = base + sum((f * x for f, x in zip(self.lever[i], slipping)), Fraction(0))
        return r

    def obeys_law(self, r, u, directions):
        """Of forces and velocities for which the pattern's equations hold."""
        conditions = []
        for k, state in enumerate(self.states):
            n, x, y = 3 * k, 3 * k + 1, 3 * k + 2
            if state == "lift":
                conditions.append((u[n], True))
                continue
            conditions.append((r[n], False))
            if state == "stick":
                mu = self.problem.mu[k]
                conditions.append((mu * mu * (r[n] * r[n]) - r[x] * r[x] - r[y] * r[y], True))
            if state == "slip":
                d = directions[self.slipping.index(k)]
                conditions.append((u[x] * d[0] + u[y] * d[1], False))
        signs = [(sign(value), or_zero) for value, or_zero in conditions]
        if any(s is not None and (s < 0 or s == 0 and not or_zero) for s, or_zero in signs):
            return False
        if any(s is None for s, _ in signs):
            raise Undecided("a condition holds with equality, or nearly")
        return True

    def solution(self, slipping, directions):
        r = self.forces(slipping)
        u = self.problem.velocities(r)
        for k, state in enumerate(self.states):
            zeros = {"lift": (), "closed": (0,), "slip": (0,), "stick": (0, 1, 2)}[state]
            for c in zeros:  # by the pattern's equations
                u[3 * k + c] = Fraction(0)
        return Found(self.states, r, u) if self.obeys_law(r, u, directions) else None


def is_regular(problem, states):
    linear = linear_components(states)
    return solve([[problem.W[i][j] for j in linear] for i in linear], [[] for _ in linear]) is not None


def direction_polynomials(turn):
    """(1 + t^2) d."""
    c, s = turn
    return [c, -2 * s, -c], [s, 2 * c, -s]


def direction_at(t, turn):
    circle = 1 + t * t
    c, s = (1 - t * t) / circle, 2 * t / circle
    return turn[0] * c - turn[1] * s, turn[1] * c + turn[0] * s


def roots_of(polynomial, degree):
    polynomial = primitive(polynomial)
    if len(polynomial) != degree + 1:
        raise Undecided("a slip in the direction that has no parameter, or a family of them")
    if not is_squarefree(polynomial):
        raise Undecided("a double root")
    return [Interval(*ends) for ends in real_roots(polynomial, BITS)]
