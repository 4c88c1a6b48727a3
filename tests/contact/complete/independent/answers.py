#!/usr/bin/env python3
"""Verdicts of `slipproof certify --all` on answers that are exactly right, in degenerate problems.

    answers.py SLIPPROOF COUNT [SEED]

Each answer is a planted solution. It must not be called wrong, inaccurate or not converged; nor unique, if elimination
finds other forces with the same velocities, or other velocities. Ends with exit code 1 if one is.
"""
import sys
from collections import Counter

from independent import problems
from degenerate import obeys_law
from elimination import all_solutions, linear_solutions
from program import certify_all, line_of

REFUSALS = ("wrong", "inaccurate", "not converged", "no solution", "invalid")


def other_solution(problem):
    """Another one than the planted one, exact; None if none was found."""
    found, _ = linear_solutions(problem)
    if problem.contacts <= 2:
        found += all_solutions(problem)[0]
    for s in found:
        if s.r != problem.planted[0] and not any(hasattr(x, "lo") for x in s.r):
            assert obeys_law(problem, s.r, s.u)
            return s.r
    return None


def main(program, count, seed="1"):
    counts, mistakes = Counter(), 0
    planted = [p for p in problems("degenerate", int(count), seed) if p.planted]
    for problem in planted:
        problem.answer = problem.planted[0]
    for problem, told in zip(planted, certify_all(program, planted)[0]):
        counts[f"{problem.kind}: {told.verdict or told.reason}"] += 1
        other = other_solution(problem) if told.verdict == "unique" else None
        if told.verdict in REFUSALS or other:
            mistakes += 1
            print(f"{problem.kind}: {told.verdict}" + (f", and r = {list(map(str, other))} is another" if other else ""))
            print(line_of(problem), flush=True)
    for words, n in sorted(counts.items()):
        print(f"{n:9}  {words}")
    print(f"{mistakes} of {len(planted)} verdicts are mistaken")
    return 1 if mistakes else 0


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
