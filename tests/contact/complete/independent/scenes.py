"""Degenerate problems: dependent contacts, forces that are open, borders of modes. In most a motion is planted: it is
chosen with forces that obey the law, and the load is what they balance."""
from fractions import Fraction

from problems import FLOOR, Problem, Scene, axes_of, dot, dyadic, inverse_inertia, random_problem

DIRECTIONS = [(Fraction(a, 5), Fraction(b, 5)) for a, b in ((3, 4), (-4, 3), (5, 0), (0, -5), (-3, -4), (4, -3))]


def edge_mu(rng):
    """So that the edge of a cone has points in DIRECTIONS that are exact in binary64."""
    return Fraction(5 * rng.randint(1, 6), 16)


def load(rng):
    acceleration = [dyadic(rng, 1, 8) for _ in range(6)]
    acceleration[2] -= 2
    return acceleration


def body(rng):
    return Scene([[1, *inverse_inertia(rng)]], [load(rng)])


def box(rng, feet):
    """On four feet, and on four more between them."""
    scene, mu = body(rng), edge_mu(rng)
    places = [(x, y) for x in (-1, 1) for y in (-1, 1)] + [(1, 0), (-1, 0), (0, 1), (0, -1)]
    for x, y in places[:feet]:
        scene.touch((x, y, Fraction(-1, 2)), mu)
    return scene


def peg(rng):
    """In a hole: walls touch it at two heights."""
    scene, mu = body(rng), edge_mu(rng)
    for height in (-1, 1):
        for wall in rng.sample([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0)], rng.randint(1, 2)):
            scene.touch([-Fraction(w, 2) for w in wall[:2]] + [height], mu, axes_of(wall))
    return scene


def hand(rng):
    """Contacts from opposite sides, two or four."""
    scene = body(rng)
    for axis in rng.sample([(1, 0, 0), (0, 1, 0), (0, 0, 1)], rng.randint(1, 2)):
        for side in (1, -1):
            scene.touch([-side * a for a in axis], edge_mu(rng), axes_of(tuple(side * a for a in axis)))
    return scene


def stack(rng):
    """A box on two or three feet, and another on it."""
    centers = [(0, 0, 1), (0, 0, 3)]
    scene = Scene([[1, *inverse_inertia(rng)], [Fraction(1, 2), *inverse_inertia(rng)]], [load(rng), load(rng)])
    feet = [(1, 0), (-1, 1), (-1, -1)][:rng.randint(2, 3)]
    mu = edge_mu(rng)
    for x, y in feet:
        scene.touch((x, y, 0), mu, FLOOR, 0, None, centers)
    for x, y in feet[:rng.randint(1, len(feet))]:
        scene.touch((x, y, 2), mu, FLOOR, 1, 0, centers)
    return scene


def without_friction(rng):
    scene = rng.choice((peg, hand, lambda r: box(r, 4)))(rng)
    some = rng.random() < 0.5
    scene.mu = [Fraction(0) if not some or rng.random() < 0.5 else m for m in scene.mu]
    return scene


def twice(rng):
    """Contacts at one place, which share their load in any way."""
    scene = body(rng)
    points = [[dyadic(rng, 1, 4) for _ in range(3)] for _ in range(rng.randint(1, 2))]
    for point in points + [points[0]]:
        scene.touch(point, edge_mu(rng))
    return scene


def force_for(rng, mu, u):
    """That obeys the law with a velocity."""
    speed2 = u[1] * u[1] + u[2] * u[2]
    if u[0] > 0 or rng.random() < 0.15:
        return [Fraction(0)] * 3
    normal = Fraction(rng.randint(1, 16), 8)
    if speed2 == 0:
        part = rng.choice((Fraction(0), Fraction(1, 2), Fraction(1), Fraction(1)))
        d = rng.choice(DIRECTIONS)
        return [normal, mu * normal * part * d[0], mu * normal * part * d[1]]
    speed = abs(u[1]) if u[2] == 0 else abs(u[2]) if u[1] == 0 else abs(u[1]) * 5 / (3 if abs(u[1]) < abs(u[2]) else 4)
    if speed * speed != speed2:
        return None
    return [normal, -mu * normal * u[1] / speed, -mu * normal * u[2] / speed]


def planted(rng, scene, kind):
    """With a motion that is known: rest, or a slide of one body in one direction."""
    motion = [Fraction(0)] * (6 * len(scene.mobility))
    if rng.random() < 0.6:
        at, (a, b) = 6 * rng.randrange(len(scene.mobility)), rng.choice(DIRECTIONS)
        axes = rng.choice(((0, 1), (0, 1), (1, 2), (2, 0)))
        motion[at + axes[0]], motion[at + axes[1]] = a * 5 / 8, b * 5 / 8
    return plant(rng, scene.problem(kind), [dot(row, motion) for row in scene.rows])


def plant(rng, problem, u):
    """The problem with the load for which these are velocities; as it is where forces do not obey the law with them."""
    r = []
    for k, mu in enumerate(problem.mu):
        force = force_for(rng, mu, u[3 * k:3 * k + 3]) if u[3 * k] >= 0 else None
        if force is None:
            return problem
        r += force
    problem.q = [a - dot(row, r) for a, row in zip(u, problem.W)]
    problem.planted = r, u
    return problem


def borders(rng, index):
    """One to three contacts, any matrix; each sticks at the edge of its cone or within, slips, touches without load or
    lifts."""
    problem = random_problem(rng, index, rng.randint(1, 3), 1)
    problem.mu = [edge_mu(rng) for _ in problem.mu]
    problem.kind = "borders"
    u = []
    for _ in problem.mu:
        d, speed = rng.choice(DIRECTIONS), Fraction(5 * rng.randint(1, 8), 8) * rng.choice((0, 1))
        u += [Fraction(rng.choice((0, 0, 1)), 2), speed * d[0], speed * d[1]]
    return plant(rng, problem, u)


def dependent(rng, index):
    """W of low rank, even 0, and a load that forces can balance, or none."""
    contacts = rng.randint(1, 3)
    rank = rng.randint(0, 2)
    B = [[dyadic(rng, 1, 2) for _ in range(3 * contacts)] for _ in range(rank)]
    W = [[sum((row[i] * row[j] for row in B), Fraction(0)) for j in range(3 * contacts)] for i in range(3 * contacts)]
    problem = Problem(W, [Fraction(0)] * 3 * contacts, [edge_mu(rng) for _ in range(contacts)], "dependent")
    if index % 3 == 0:
        problem.q = [dyadic(rng, 1, 2) for _ in problem.q]
        return problem
    motion = [rng.choice((Fraction(0), Fraction(5, 8))) if i % 3 else Fraction(0) for i in range(problem.size)]
    return plant(rng, problem, motion)


SCENES = {"four feet": lambda rng: box(rng, 4), "eight feet": lambda rng: box(rng, 8), "peg": peg, "hand": hand,
          "stack": stack, "no friction": without_friction, "twice": twice}


def degenerate_problem(rng, index):
    kinds = [*SCENES, "borders", "dependent"]
    kind = kinds[index % len(kinds)]
    if kind == "borders":
        return borders(rng, index // len(kinds))
    if kind == "dependent":
        return dependent(rng, index // len(kinds))
    scene = SCENES[kind](rng)
    return planted(rng, scene, kind) if rng.random() < 0.7 else scene.problem(kind)
