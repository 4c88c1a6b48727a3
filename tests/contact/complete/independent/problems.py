"""Contact problems u = W r + q in space with Coulomb's law, in Fractions; components of a contact are normal, tangent,
tangent. All numbers are exact in binary64, so that the program reads what is written here."""
from dataclasses import dataclass, field
from fractions import Fraction

AXES = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
FLOOR = ((0, 0, 1), (1, 0, 0), (0, 1, 0))  # normal and tangents


@dataclass
class Problem:
    W: list
    q: list
    mu: list
    kind: str = ""
    planted: tuple = None  # forces and velocities that solve it, if some are known
    answer: list = None  # forces to be judged

    @property
    def contacts(self):
        return len(self.mu)

    @property
    def size(self):
        return len(self.q)

    def velocities(self, r):
        acting = [(j, x) for j, x in enumerate(r) if not (isinstance(x, Fraction) and x == 0)]
        return [sum((row[j] * x for j, x in acting), q) for row, q in zip(self.W, self.q)]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def dyadic(rng, size, denominator):
    """A multiple of 1/denominator, up to `size`."""
    return Fraction(rng.randint(-size * denominator, size * denominator), denominator)


def axes_of(normal):
    """A frame whose normal is along an axis of the scene."""
    first = next(a for a in AXES if dot(a, normal) == 0)
    return normal, first, cross(normal, first)


def tilted_frame(rng):
    """Nearly orthonormal: a turned floor, rounded to multiples of 1/256."""
    w, x, y, z = 8, rng.randint(-5, 5), rng.randint(-5, 5), rng.randint(-8, 8)
    n = w * w + x * x + y * y + z * z
    frame = (((2 * (x * z + w * y)), 2 * (y * z - w * x), w * w - x * x - y * y + z * z),
             (w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)),
             (2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)))
    return tuple(tuple(Fraction(round(Fraction(256 * a, n)), 256) for a in row) for row in frame)


@dataclass
class Scene:
    """Rigid bodies, each with its main axes along those of the scene; `mobility` is 1/mass and the inverse inertias."""

    mobility: list
    acceleration: list
    rows: list = field(default_factory=list)
    mu: list = field(default_factory=list)

    def touch(self, point, mu, frame=FLOOR, body=0, other=None, centers=None):
        """A contact of `body` with the ground, or with the body `other`, which its normal leaves."""
        for d in frame:
            row = [Fraction(0)] * (6 * len(self.mobility))
            for b, sign in ((body, 1), (other, -1)):
                if b is not None:
                    arm = point if centers is None else [p - c for p, c in zip(point, centers[b])]
                    row[6 * b:6 * b + 6] = [sign * x for x in (*d, *cross(arm, d))]
            self.rows.append(row)
        self.mu.append(Fraction(mu))

    def problem(self, kind=""):
        weight = [Fraction(m) for body in self.mobility for m in (body[0],) * 3 + tuple(body[1:])]
        free = [Fraction(a) for body in self.acceleration for a in body]
        scaled = [[x * m for x, m in zip(row, weight)] for row in self.rows]
        W = [[Fraction(dot(a, b)) for b in self.rows] for a in scaled]
        return Problem(W, [Fraction(dot(row, free)) for row in self.rows], list(self.mu), kind)


def inverse_inertia(rng):
    """Of a body that can be built: the inertias obey the triangle inequalities."""
    while True:
        inverse = [Fraction(rng.randint(2, 40), 8) for _ in range(3)]
        inertia = sorted(1 / x for x in inverse)
        if inertia[2] <= inertia[0] + inertia[1]:
            return inverse


def random_mu(rng, most):
    return Fraction(rng.randint(1, most * 32), 32)


def random_body(rng, contacts, most_mu):
    acceleration = [dyadic(rng, 2, 16) for _ in range(6)]
    acceleration[2] -= 1
    scene = Scene([[1, *inverse_inertia(rng)]], [acceleration])
    for _ in range(contacts):
        scene.touch([dyadic(rng, 2, 16) for _ in range(3)], random_mu(rng, most_mu), tilted_frame(rng))
    return scene.problem("body")


def random_any(rng, contacts, most_mu):
    n = 3 * contacts
    W = [[dyadic(rng, 2, 16) for _ in range(n)] for _ in range(n)]
    return Problem(W, [dyadic(rng, 2, 16) for _ in range(n)], [random_mu(rng, most_mu) for _ in range(contacts)], "any")


def random_symmetric(rng, contacts, most_mu):
    """B^T B, as of bodies on many contacts."""
    problem = random_any(rng, contacts, most_mu)
    B = [[dyadic(rng, 2, 8) for _ in range(problem.size)] for _ in range(problem.size)]
    columns = list(zip(*B))
    problem.W = [[dot(a, b) for b in columns] for a in columns]
    problem.kind = "symmetric"
    return problem


def random_problem(rng, index, contacts, most_mu):
    """Every third one: a body, a symmetric matrix, any matrix. In every ninth one contact has no friction."""
    makers = (random_body, random_symmetric, random_any)
    problem = makers[index % 3](rng, contacts, most_mu)
    if index % 9 < 3 and index % 2 == 0:
        problem.mu[rng.randrange(contacts)] = Fraction(0)
    return problem
