"""Linear equations in Fractions."""


def reduced(rows, columns):
    """Row-reduces in the first `columns` columns; returns rows that are not 0 there, their pivots, and the others."""
    rows, done, pivots = [list(r) for r in rows], [], []
    for k in range(columns):
        at = next((i for i, r in enumerate(rows) if r[k] != 0), None)
        if at is None:
            continue
        head = rows.pop(at)
        head = [x / head[k] if x else x for x in head]
        for group in (rows, done):
            for r in group:
                if r[k] != 0:
                    factor = r[k]
                    r[:] = [x - factor * y if y else x for x, y in zip(r, head)]
        done.append(head)
        pivots.append(k)
    return done, pivots, rows


def solve(A, columns):
    """X with A X = columns; None if A is singular."""
    n = len(A)
    done, pivots, _ = reduced([list(a) + list(c) for a, c in zip(A, columns)], n)
    return [row[n:] for row in done] if len(pivots) == n else None


def solution_space(A, b):
    """A point and directions of {x: A x = b}; None if it is empty."""
    n = len(A[0]) if A else 0
    done, pivots, rest = reduced([list(a) + [x] for a, x in zip(A, b)], n)
    if any(row[n] != 0 for row in rest):
        return None
    point = [0 * row[n] for row in done[:1]] * n if done else [0] * n
    for row, pivot in zip(done, pivots):
        point[pivot] = row[n]
    directions = []
    for free in set(range(n)) - set(pivots):
        direction = [0] * n
        direction[free] = 1
        for row, pivot in zip(done, pivots):
            direction[pivot] = -row[free]
        directions.append(direction)
    return point, directions
