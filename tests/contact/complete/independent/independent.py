#!/usr/bin/env python3
"""`slipproof certify --all` against methods that share nothing with it.

    independent.py SLIPPROOF METHOD COUNT [SEED]

    one, two         one or two contacts: elimination, and real roots of polynomials, exactly
    three, four      three or four contacts: Newton's method from 500 random starts in each pattern
    degenerate       borders of modes and dependent contacts: exact linear modes, Newton, projected Gauss-Seidel

Where the program says that all solutions are told, those that are found here must be told; with one and two contacts also
the other way round. In each problem one told solution is then left out, which must be noticed if it was found here. A
difference, or a failure of the program, is printed with its problem, a line for `slipproof certify`, and ends with exit
code 1.
"""
import random
import sys
import time
from collections import Counter
from dataclasses import replace
from importlib.util import find_spec
from itertools import islice

if find_spec("numpy") is None:
    sys.exit(77)  # not asked

from compare import Elimination, Newton
from degenerate import Degenerate
from problems import random_problem
from program import certify_all, line_of
from scenes import degenerate_problem

BATCH = 100
METHODS = {"one": (1, Elimination), "two": (2, Elimination), "three": (3, Newton), "four": (4, Newton),
           "degenerate": (0, Degenerate)}


def problems(method, count, seed):
    rng = random.Random(f"{method} {seed}")
    for index in range(count):
        contacts = METHODS[method][0]
        yield degenerate_problem(rng, index) if contacts == 0 else random_problem(rng, index, contacts, 3)


class Comparison:
    def __init__(self, judge, seed):
        self.judge, self.rng, self.count, self.mistakes = judge, random.Random(seed), Counter(), 0

    def report(self, problem, words):
        self.mistakes += 1
        print(f"{words}, {problem.kind}\n{line_of(problem)}", flush=True)

    def add(self, problem, told):
        count = self.count
        count["problems"] += 1
        count[f"problems: {problem.kind}"] += 1
        if told.failed:
            count["failures of the program"] += 1
            self.report(problem, f"FAILURE: {told.reason}")
        found = self.judge.find(problem, count)
        count["solutions found here"] += self.judge.number(found)
        if told.complete:
            self.hold_against(problem, found, told)
        else:
            count["not told complete"] += 1
            count[f"not told complete: {problem.kind}"] += 1
            count["solutions found here of those not told complete"] += self.judge.number(found)
            print(f"{count['problems']}, {problem.kind}: {told.reason}", flush=True)

    def hold_against(self, problem, found, told):
        count = self.count
        count["told complete"] += 1
        count[f"told complete, with {len(told.solutions)} solutions"] += 1
        count["solutions told"] += len(told.solutions)
        count["families told"] += sum(s.parameters > 0 for s in told.solutions)
        for words in self.judge.differences(problem, found, told):
            count["differences"] += 1
            self.report(problem, f"DIFFERENCE: {words}")
        self.judge.also_count(found, told, count)
        if told.solutions:
            left_out = self.rng.randrange(len(told.solutions))
            fewer = replace(told, solutions=told.solutions[:left_out] + told.solutions[left_out + 1:])
            noticed = next(self.judge.differences(problem, found, fewer), None) is not None
            count["left out and noticed" if noticed else "left out, and not found here"] += 1


def main(program, method, count, seed="1"):
    begin, seconds = time.monotonic(), 0.0
    comparison = Comparison(METHODS[method][1](int(seed)), int(seed))
    source = problems(method, int(count), seed)
    while batch := list(islice(source, BATCH)):
        told, took = certify_all(program, batch)
        seconds += took
        for problem, t in zip(batch, told):
            comparison.add(problem, t)
    for words, n in sorted(comparison.count.items()):
        print(f"{n:9}  {words}")
    print(f"{comparison.mistakes} mistakes; the program took {seconds:.0f} s of {time.monotonic() - begin:.0f} s")
    noticed = comparison.count["left out and noticed"] > comparison.count["left out, and not found here"]
    return 0 if comparison.mistakes == 0 and noticed else 1


if __name__ == "__main__":
    if len(sys.argv) not in (4, 5) or sys.argv[2] not in METHODS:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
