"""Contacts that stick with dependent equations, where forces are open: r = point + s_1 direction_1 + ..."""
from fractions import Fraction

import numpy as np

from intervals import BITS, ONE
from real_roots import is_squarefree, multiple, primitive, product, real_roots, total


def are_in_cones(problem, states, r):
    for k, state in enumerate(states):
        n, x, y = r[3 * k:3 * k + 3]
        if state != "lift" and n <= 0:
            return False
        if state == "stick" and x * x + y * y > (problem.mu[k] * n)**2:
            return False
    return True


def ends_of_conditions(problem, states, point, direction):
    """Where a condition of the law may change along the line of forces, in order."""
    for k, state in enumerate(states):
        lines = [[p, d] for p, d in zip(point[3 * k:3 * k + 3], direction[3 * k:3 * k + 3])]
        conditions = [lines[0]] if state != "lift" else []
        if state == "stick":
            n, x, y = (product(line, line) for line in lines)
            conditions.append(total(multiple(problem.mu[k]**2, n), multiple(-1, x), multiple(-1, y)))
        for p in map(primitive, conditions):
            if len(p) > 1:
                for lower, upper in real_roots(p if is_squarefree(p) else [p[1], 2 * p[2]], BITS):
                    yield Fraction(lower, ONE)
                    yield Fraction(upper, ONE)


def on_line(problem, states, point, direction):
    """Forces between the ends of conditions, or at one that is rational."""
    ends = sorted(set(ends_of_conditions(problem, states, point, direction))) or [Fraction(0)]
    for s in [*ends, ends[0] - 1, *((a + b) / 2 for a, b in zip(ends, ends[1:])), ends[-1] + 1]:
        yield [p + s * d for p, d in zip(point, direction)]


def by_projections(problem, states, point, directions, rounds=300):
    """Douglas and Rachford's reflections between the cones and the forces that the equations allow propose; the numbers of
    the directions are rounded, so that the equations hold exactly."""
    base, D = np.array(point, dtype=float), np.array(directions, dtype=float).T
    onto = np.linalg.pinv(D)
    least = 1e-4 * max(np.abs(base).max(), 1e-3)
    x = base.copy()
    for step in range(rounds):
        inside = x.copy()
        for k, state in enumerate(states):
            if state != "lift":
                inside[3 * k:3 * k + 3] = into_cone(x[3 * k:3 * k + 3], float(problem.mu[k]) * (1 - 1e-4), least)
        s = onto @ (2 * inside - x - base)
        x += base + D @ s - inside
        if step % 30 == 29:
            rounded = [Fraction(round(value * 2**30), 2**30) for value in s.tolist()]
            yield [p + sum(a * d[i] for a, d in zip(rounded, directions)) for i, p in enumerate(point)]


def into_cone(r, mu, least):
    """The nearest force with |r_T| <= mu (r_N - least)."""
    normal, tangent = r[0] - least, np.hypot(r[1], r[2])
    if tangent <= mu * normal:
        return r
    if mu * tangent <= -normal:
        return np.array([least, 0, 0])
    height = (normal + mu * tangent) / (1 + mu * mu)
    scale = mu * height / tangent if tangent > 0 else 0
    return np.array([least + height, r[1] * scale, r[2] * scale])


def member(problem, states, point, directions):
    """Forces that obey the law, and their velocities, which are the same for all; None if none were found. Along a line
    all are found, but those that touch a border only where the number is not rational."""
    u = problem.velocities(point)
    if any(state == "lift" and u[3 * k] < 0 for k, state in enumerate(states)):
        return None
    one = len(directions) == 1
    for r in on_line(problem, states, point, directions[0]) if one else by_projections(problem, states, point, directions):
        if are_in_cones(problem, states, r):
            return r, u
    return None
