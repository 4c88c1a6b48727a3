"""The left side of Lagrange's equations for one rigid body, which SymPy forms once from its kinetic energy.

Coordinates are the place x of the centre of mass and a vector g with the rotation (1 - [g])^-1 (1 + [g]) R0, Cayley's
form, which is rational. At the instant g = 0; there w = 2 g' and alpha = 2 g'', and a rotation d theta is 2 dg.
"""
import sympy as sp

t = sp.Symbol("t")


def cross_matrix(v):
    return sp.Matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def lagrange_of_turning():
    """d/dt dT/dg' - dT/dg at g = 0, halved, over inertia J (in the scene's axes now), w and alpha."""
    g = sp.Matrix(sp.symbols("g:3"))
    rate = sp.Matrix(sp.symbols("h:3"))
    growth = sp.Matrix(sp.symbols("k:3"))
    J = sp.Matrix(3, 3, lambda i, k: sp.Symbol(f"J{min(i, k)}{max(i, k)}"))
    turn = sp.eye(3) + 2 / (1 + g.dot(g)) * (cross_matrix(g) + cross_matrix(g) ** 2)
    turn_rate = sum((turn.diff(g[i]) * rate[i] for i in range(3)), sp.zeros(3, 3))
    w_cross = turn_rate * turn.T  # [w]
    w = sp.Matrix([w_cross[2, 1], w_cross[0, 2], w_cross[1, 0]])
    seen = turn.T * w  # in the body's axes of the instant
    energy = (seen.T * J * seen)[0] / 2

    def now(e):
        return sp.expand(e.subs({x: 0 for x in g}))

    rows = []
    for i in range(3):
        momentum = sp.diff(energy, rate[i])
        change = sum(sp.diff(momentum, g[k]) * rate[k] + sp.diff(momentum, rate[k]) * growth[k] for k in range(3))
        rows.append(now(change - sp.diff(energy, g[i])) / 2)
    spin, turning = sp.symbols("w:3"), sp.symbols("a:3")
    halves = {rate[i]: spin[i] / 2 for i in range(3)} | {growth[i]: turning[i] / 2 for i in range(3)}
    rows = [sp.expand(r.subs(halves, simultaneous=True)) for r in rows]
    symbols = [J[0, 0], J[1, 1], J[2, 2], J[0, 1], J[0, 2], J[1, 2], *spin, *turning]
    return sp.lambdify(symbols, rows, modules=[{}])


def selfcheck(position):
    """The place of a body's point by series against SymPy's derivatives of the same motion, written with t."""
    x, v, a = sp.Matrix([1, -2, 3]), sp.Matrix([2, 1, -1]), sp.Matrix([1, 3, 2])
    w, turning, arm = sp.Matrix([1, 2, -2]), sp.Matrix([3, -1, 1]), sp.Matrix([1, 1, 2])
    angle = w * t + turning * t**2 / 2  # of the exponential, which differs from Cayley's form by t^3
    n = cross_matrix(angle)
    place = x + v * t + a * t**2 / 2 + (sp.eye(3) + n + n**2 / 2) * arm
    found = position(x, v, a, w, turning, arm)
    for i in range(3):
        for order, coefficient in enumerate(found[i].c):
            assert sp.diff(place[i], t, order).subs(t, 0) / sp.factorial(order) == sp.Rational(coefficient)
