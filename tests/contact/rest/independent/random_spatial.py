"""Random structures in space: boxes on each other, tables on slopes, bodies in fingertips, ladders, bodies that touch
anywhere. Directions are rational, from quaternions of small integers."""
from fractions import Fraction

from structure import Body, Contact, Force, Structure, minus

UP = (Fraction(0), Fraction(0), Fraction(1))
RIGHT = (Fraction(1), Fraction(0), Fraction(0))


def coefficient(random):
    return random.choice([Fraction(1, 10), Fraction(1, 4), Fraction(1, 3), Fraction(1, 2), Fraction(3, 4), Fraction(1), Fraction(0)])


def frame(random):
    """Three rational directions at right angles."""
    while True:
        w, x, y, z = (random.randint(-2, 2) for _ in range(4))
        n = w * w + x * x + y * y + z * z
        if n:
            break
    rows = ((w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z))
    return [tuple(Fraction(v, n) for v in row) for row in rows]


def touch(s, of, on, point, normal, tangent, mu):
    s.contacts.append(Contact(f"c{len(s.contacts)}", of, on, point, normal, mu, tangent))


def pile(random, s, size):
    """Boxes on each other, each shifted; they touch in the corners of what they share."""
    below, top = None, Fraction(0)
    rectangle = [Fraction(-9), Fraction(9), Fraction(-9), Fraction(9)]
    for k in range(size):
        a, b, h = (Fraction(random.randint(2, 6)) for _ in range(3))
        x = (rectangle[0] + rectangle[1]) / 2 + Fraction(random.randint(-4, 4), 3)
        y = (rectangle[2] + rectangle[3]) / 2 + Fraction(random.randint(-4, 4), 3)
        mine = [x - a / 2, x + a / 2, y - b / 2, y + b / 2]
        shared = [max(mine[0], rectangle[0]), min(mine[1], rectangle[1]), max(mine[2], rectangle[2]), min(mine[3], rectangle[3])]
        if shared[0] >= shared[1] or shared[2] >= shared[3]:
            break
        s.bodies.append(Body(f"b{k}", Fraction(random.randint(1, 5)), (x, y, top + h / 2), f'{{ box = ["{a}", "{b}", "{h}"] }}'))
        mu = coefficient(random)
        for px in shared[:2]:
            for py in shared[2:]:
                touch(s, f"b{k}", below, (px, py, top), UP, RIGHT, mu)
        below, top, rectangle = f"b{k}", top + h, mine


def table(random, s, size):
    """One body on three to five feet, gravity leaning as on a slope."""
    s.gravity = (Fraction(random.randint(-4, 4)), Fraction(random.randint(-4, 4)), Fraction(-10))
    s.bodies.append(Body("b0", Fraction(random.randint(1, 5)), (Fraction(random.randint(-1, 1)), Fraction(0), Fraction(random.randint(1, 4)))))
    mu = coefficient(random)
    for _ in range(random.randint(3, 5)):
        point = (Fraction(random.randint(-4, 4)), Fraction(random.randint(-4, 4)), Fraction(0))
        touch(s, "b0", None, point, UP, RIGHT, random.choice([mu, coefficient(random)]))


def grasp(random, s, size):
    """Bodies that touch the ground, walls and each other at any points in any directions."""
    for k in range(random.randint(1, size)):
        at = tuple(Fraction(random.randint(-3, 3)) for _ in range(3))
        s.bodies.append(Body(f"b{k}", Fraction(random.randint(1, 5)), at))
        for _ in range(random.randint(2, 4)):
            on = random.choice([None, f"b{random.randrange(k)}"]) if k else None
            normal, tangent, _ = random.choice([frame(random), [UP, RIGHT, None]])
            if normal[2] < 0 and random.random() < 0.7:
                normal = tuple(-x for x in normal)
            point = tuple(x + Fraction(random.randint(-2, 2)) for x in at)
            touch(s, f"b{k}", on, point, normal, tangent, coefficient(random))


def squeezed(random, s, size):
    """A body between fingertips that press with given forces: each finger is on a body of its own that the ground guides
    by smooth contacts, or the ground itself."""
    s.bodies.append(Body("b0", Fraction(random.randint(1, 3)), (Fraction(0), Fraction(0), Fraction(0)), '{ box = ["2", "2", "2"] }'))
    zero = (Fraction(0),) * 3
    for k, sign in enumerate((-1, 1, 1)[:random.randint(2, 3)]):
        point = (Fraction(sign), Fraction(random.randint(-2, 2), 3), Fraction(random.randint(-2, 2), 3))
        touch(s, "b0", None, point, (Fraction(-sign), Fraction(0), Fraction(0)), UP, coefficient(random))
    push = Fraction(random.randint(0, 30))
    s.forces.append(Force("b0", (Fraction(random.randint(-1, 1)), Fraction(0), Fraction(0)), (Fraction(0), push, Fraction(0)), zero))
    touch(s, "b0", None, (Fraction(0), Fraction(1), Fraction(random.randint(-1, 1), 2)), (Fraction(0), Fraction(-1), Fraction(0)), RIGHT, coefficient(random))


def ladder(random, s, size):
    """A ladder with two feet and two ends at a wall, and a weight somewhere on it."""
    a, b, _ = random.choice([(3, 4, 5), (5, 12, 13), (8, 15, 17), (4, 3, 5)])
    s.bodies.append(Body("b0", Fraction(1), (Fraction(0), Fraction(a, 2), Fraction(b, 2))))
    mu, mu_w = coefficient(random), coefficient(random)
    for x in (Fraction(-1), Fraction(1)):
        touch(s, "b0", None, (x, Fraction(0), Fraction(0)), UP, RIGHT, mu)
        touch(s, "b0", None, (x, Fraction(a), Fraction(b)), (Fraction(0), Fraction(-1), Fraction(0)), RIGHT, mu_w)
    t = Fraction(random.randint(0, 4), 4)
    point = (Fraction(random.randint(-3, 3), 4), t * a, t * b)
    s.forces.append(Force("b0", point, (Fraction(0), Fraction(0), Fraction(-random.randint(0, 40))), (Fraction(0),) * 3))


KINDS = [pile, table, grasp, squeezed, ladder]


def structure(random, name, size):
    s = Structure(name, 3, (Fraction(random.choice([0, 0, 0, 1])), Fraction(0), Fraction(-10)))
    random.choice(KINDS)(random, s, random.randint(1, size))
    if random.random() < 0.6:
        body = random.choice(s.bodies)
        at = tuple(x + Fraction(random.randint(-2, 2), 2) for x in body.at)
        direction = tuple(Fraction(random.randint(-2, 2)) for _ in range(3))
        if any(direction):
            s.forces.append(Force(body.name, at, (Fraction(0),) * 3, direction))
            s.load = Fraction(random.randint(-3, 10), random.choice([1, 2]))
    return s
