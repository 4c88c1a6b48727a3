"""All solutions of a contact problem by elimination, where at most two contacts slip in space."""
import itertools

from one_slip import one_slip
from pattern import TURNS, Pattern, Undecided, family, is_regular
from two_slips import two_slips


def solutions_of(problem, states):
    """Those of one pattern. Raises Undecided."""
    slips = states.count("slip")
    pattern = Pattern(problem, states) if slips or is_regular(problem, states) else None
    if slips == 0:
        if pattern is None:
            return family(problem, states)
        found = pattern.solution([], [])
        return [found] if found else []
    if slips > 2:
        raise Undecided("three slips")
    for turn in TURNS:
        try:
            return [s for s in (one_slip, two_slips)[slips - 1](pattern, turn) if s]
        except (Undecided, ZeroDivisionError) as failure:
            reason = str(failure) or "a divisor that may be 0"
    raise Undecided(reason)


def all_patterns(problem):
    return itertools.product(*(("lift", "stick", "slip") if m else ("lift", "closed") for m in problem.mu))


def linear_solutions(problem, most_closed=3):
    """Those in which no contact slips in space and few are closed."""
    found, undecided = [], {}
    for closed in range(most_closed + 1):
        for contacts in itertools.combinations(range(problem.contacts), closed):
            states = tuple("lift" if k not in contacts else "stick" if m else "closed" for k, m in enumerate(problem.mu))
            try:
                found += solutions_of(problem, states)
            except Undecided as failure:
                undecided[states] = str(failure)
    return found, undecided


def all_solutions(problem, most_slips=2):
    """Those of all patterns, and for patterns that are not decided why, by pattern."""
    found, undecided = [], {}
    for states in all_patterns(problem):
        if states.count("slip") > most_slips:
            continue
        try:
            found += solutions_of(problem, states)
        except Undecided as failure:
            undecided[states] = str(failure)
    return found, undecided
