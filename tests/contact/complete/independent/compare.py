"""Solutions that were found here, held against those that the program tells. A judge finds some of a problem once, and
then names the differences from a list that is told."""
import numpy as np

from elimination import all_solutions
from intervals import is_within
from newton import solutions_near

NEAR = 1e-6  # of velocities in binary64, relative to the largest
LEAST = 1e-6  # size below which numbers are 0 to projections of a problem without load


def has_velocities(told, u):
    return all(is_within(x, range_) for x, range_ in zip(u, told.u))


def has_forces(told, r):
    return all(is_within(x, range_) for x, range_ in zip(r, told.r))


def holds(told, found):
    """Whether a told solution is the one that was found, in mode, velocities and forces; of a family the forces are one
    choice."""
    forces = told.parameters > 0 or has_forces(told, found.r)
    return told.modes == found.modes and forces and has_velocities(told, found.u)


def is_near(problem, told, found):
    """Whether velocities in binary64 are those of a told solution, or of those that it stands for. They are as exact as
    the largest of the forces' parts."""
    at = np.clip(found.u, [float(lower) for lower, _ in told.u], [float(upper) for _, upper in told.u])
    parts = np.abs(np.array(problem.W, dtype=float)) @ np.abs(found.r)
    scale = max(np.abs(at).max(), np.abs(found.u).max(), parts.max(), max(abs(float(q)) for q in problem.q), LEAST)
    return np.abs(at - found.u).max() <= NEAR * scale


class Elimination:
    """All solutions, exactly, where at most two contacts slip."""

    def __init__(self, seed):
        del seed  # nothing is random

    def find(self, problem, count):
        found, undecided = all_solutions(problem)
        count[f"problems with {len(found)} solutions found here"] += 1
        for reason in undecided.values():
            count[f"patterns not decided here: {reason}"] += 1
        return found, bool(undecided)

    def differences(self, problem, found, told):
        solutions, may_be_more = found
        claimed = set()
        for solution in solutions:
            at = [i for i, t in enumerate(told.solutions) if holds(t, solution)]
            if len(at) != 1:
                yield f"{'/'.join(solution.modes)} is in {len(at)} of those that are told"
            claimed.update(at)
        for i, t in enumerate(told.solutions):
            if i not in claimed and not may_be_more:
                yield f"{'/'.join(t.modes)} is told, and was not found"

    def also_count(self, found, told, count):
        pass

    def number(self, found):
        return len(found[0])


class Newton:
    """What Newton's method finds from random starts."""

    def __init__(self, seed, starts=500):
        self.rng, self.starts = np.random.default_rng(seed), starts

    def find(self, problem, count):
        return solutions_near(problem, self.rng, self.starts)

    def differences(self, problem, found, told):
        for s in found:
            if not any(is_near(problem, t, s) for t in told.solutions):
                yield f"{'/'.join(s.modes)} with u = {s.u.tolist()}, r = {s.r.tolist()} is not told"

    def also_count(self, found, told, count):
        pass

    def number(self, found):
        return len(found)
