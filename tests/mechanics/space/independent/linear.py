"""Exact linear algebra over fractions."""
from fractions import Fraction


def reduced(rows, columns=None):
    """The reduced row echelon form, without rows of zeros: one for each set of rows that span the same space."""
    rows = [list(r) for r in rows]
    width = len(rows[0]) if rows else 0
    done = 0
    for column in range(width if columns is None else columns):
        pivot = next((i for i in range(done, len(rows)) if rows[i][column] != 0), None)
        if pivot is None:
            continue
        rows[done], rows[pivot] = rows[pivot], rows[done]
        scale = rows[done][column]
        rows[done] = [x / scale for x in rows[done]]
        for i, row in enumerate(rows):
            if i != done and row[column] != 0:
                factor = row[column]
                rows[i] = [x - factor * y if y else x for x, y in zip(row, rows[done])]
        done += 1
    return rows[:done] if columns is None else (rows[:done], rows[done:])


def solutions(rows, right):
    """A solution of rows x = right, and a basis of the solutions of rows x = 0; nothing if there is none."""
    unknowns = len(rows[0])
    echelon = reduced([list(r) + [b] for r, b in zip(rows, right)])
    pivots = [next(k for k, x in enumerate(row) if x != 0) for row in echelon]
    if unknowns in pivots:
        return None
    one = [Fraction(0)] * unknowns
    for row, pivot in zip(echelon, pivots):
        one[pivot] = row[unknowns]
    basis = []
    for free in (k for k in range(unknowns) if k not in pivots):
        direction = [Fraction(0)] * unknowns
        direction[free] = Fraction(1)
        for row, pivot in zip(echelon, pivots):
            direction[pivot] = -row[free]
        basis.append(direction)
    return one, basis


def solved_for(rows, wanted, unknowns):
    """The first `wanted` of the unknowns, which rows determine, over the other columns."""
    echelon, _ = reduced(rows, unknowns)
    pivots = {next(k for k, x in enumerate(row) if x != 0): row for row in echelon}
    return [pivots[k][unknowns:] for k in range(wanted)]
