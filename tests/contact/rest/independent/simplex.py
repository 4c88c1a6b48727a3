"""Linear programs over fractions by the simplex method with Bland's rule, for small ones: max c x with A x = b, x >= 0.
What a test compares with; QSopt_ex solves the larger ones."""
from fractions import Fraction


def pivot(rows, basis, r, k):
    inverse = 1 / rows[r][k]
    rows[r] = {j: v * inverse for j, v in rows[r].items()}
    for i, row in enumerate(rows):
        factor = row.get(k)
        if i == r or not factor:
            continue
        for j, v in rows[r].items():
            new = row.get(j, 0) - factor * v
            if new:
                row[j] = new
            else:
                row.pop(j, None)
    basis[r] = k


def climb(rows, basis, allowed):
    """rows[-1] is the objective, maximised, as c - z; the right-hand side stands in column -1. False if unbounded."""
    while True:
        entering = min((j for j, v in rows[-1].items() if j >= 0 and v > 0 and j < allowed), default=None)
        if entering is None:
            return True
        ratios = [(row.get(-1, Fraction(0)) / row[entering], basis[i], i) for i, row in enumerate(rows[:-1]) if row.get(entering, 0) > 0]
        if not ratios:
            return False
        pivot(rows, basis, min(ratios)[2], entering)


def maximise(equations, count, objective):
    """Equations: ({column: coefficient}, right-hand side). The answer: ("optimal", value), ("unbounded", None) or
    ("infeasible", None)."""
    rows = []
    for k, (left, right) in enumerate(equations):
        sign = -1 if right < 0 else 1
        row = {j: sign * v for j, v in left.items() if v}
        row[count + k] = Fraction(1)
        if right:
            row[-1] = sign * Fraction(right)
        rows.append(row)
    basis = [count + k for k in range(len(rows))]
    first = {}
    for row in rows:
        for j, v in row.items():
            if j < count:
                first[j] = first.get(j, 0) + v
    rows.append({j: v for j, v in first.items() if v})
    climb(rows, basis, count)
    if rows[-1].get(-1, 0) != 0:
        return "infeasible", None
    rows.pop()
    for r in range(len(basis) - 1, -1, -1):  # artificial columns leave, or their equation says nothing
        if basis[r] >= count:
            entering = min((j for j in rows[r] if 0 <= j < count), default=None)
            if entering is None:
                del rows[r], basis[r]
            else:
                pivot(rows, basis, r, entering)
    rows = [{j: v for j, v in row.items() if j < count} for row in rows]
    last = dict(objective)
    for i, row in enumerate(rows):
        factor = objective.get(basis[i], 0)
        if factor:
            for j, v in row.items():
                last[j] = last.get(j, 0) - factor * v
    rows.append({j: v for j, v in last.items() if v})
    if not climb(rows, basis, count):
        return "unbounded", None
    return "optimal", -rows[-1].get(-1, Fraction(0))
