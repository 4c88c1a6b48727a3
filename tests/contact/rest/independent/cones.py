"""The ends of the loads at which a structure in space can rest, by CVXOPT: second-order cone programs in floating point."""
import cvxopt
import cvxopt.solvers
import numpy

cvxopt.solvers.options.update(show_progress=False, abstol=1e-10, reltol=1e-10, feastol=1e-10, maxiters=200)


def forces_of(contact):
    return contact.forces() if contact.mu else contact.forces()[:1]


def balance(structure):
    """Rows of full rank over the forces and F, and the right sides; None if they contradict each other. CVXOPT wants no
    row that others say already: elimination with full pivots finds these."""
    names = [f for c in structure.contacts for f in forces_of(c)]
    index = {f: k for k, f in enumerate(names)}
    rows = structure.rows()
    matrix = numpy.zeros((len(rows), len(names) + 2))
    for i, (_, row, constant, factor) in enumerate(rows):
        for f, v in row.items():
            if f in index:
                matrix[i, index[f]] = float(v)
        matrix[i, -2:] = float(factor), -float(constant)
    chosen, work, left = [], matrix.copy(), list(range(len(rows)))
    while left:
        block = numpy.abs(work[left, :-1])
        i, j = numpy.unravel_index(numpy.argmax(block), block.shape)
        if block[i, j] < 1e-9:
            if numpy.abs(work[left, -1]).max() > 1e-9:
                return None
            break
        pivot = left.pop(int(i))
        chosen.append(pivot)
        for k in left:
            work[k] -= work[pivot] * (work[k, j] / work[pivot, j])
    return matrix[chosen, :-1], matrix[chosen, -1], index


def constraints(structure, index, count):
    """G x <= 0 for the normal forces of smooth contacts, and -G x in the cone for each of the others."""
    smooth = [index[c.forces()[0]] for c in structure.contacts if not c.mu]
    lines = cvxopt.spmatrix([-1.0] * len(smooth), range(len(smooth)), smooth, (len(smooth), count))
    cones = []
    for c in structure.contacts:
        if c.mu:
            k = index[c.forces()[0]]
            cones.append(cvxopt.spmatrix([-float(c.mu), -1.0, -1.0], [0, 1, 2], [k, k + 1, k + 2], (3, count)))
    return lines, cones


def extreme(structure, sign):
    """max sign*F: ("optimal", F), ("infeasible", None), ("unbounded", None) or, without an answer, ("unknown", None)."""
    rows = balance(structure)
    if rows is None:
        return "infeasible", None
    a, b, index = rows
    count = len(index) + 1
    scale = max(1.0, float(numpy.abs(b).max(initial=0)))
    lines, cones = constraints(structure, index, count)
    cost = cvxopt.matrix([0.0] * (count - 1) + [-float(sign)])
    try:
        answer = cvxopt.solvers.socp(cost, Gl=lines, hl=cvxopt.matrix(0.0, (lines.size[0], 1)), Gq=cones,
                                     hq=[cvxopt.matrix(0.0, (3, 1)) for _ in cones],
                                     A=cvxopt.sparse(cvxopt.matrix(a)), b=cvxopt.matrix(b / scale))
    except (ValueError, ArithmeticError):
        return "unknown", None
    if answer["status"] == "optimal":
        return "optimal", answer["x"][count - 1] * scale
    return {"primal infeasible": "infeasible", "dual infeasible": "unbounded"}.get(answer["status"], "unknown"), None
