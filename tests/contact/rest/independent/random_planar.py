"""Random structures in the plane: piles, walls, leaning rods, arches, chains, bodies that touch anywhere. Small denominators, so
that some of them stand exactly at their limit."""
from fractions import Fraction

from structure import Body, Contact, Force, Pin, Structure, minus, times

HALF = Fraction(1, 2)
UP = (Fraction(0), Fraction(1))
TRIPLES = [(3, 4, 5), (4, 3, 5), (5, 12, 13), (12, 5, 13), (8, 15, 17), (15, 8, 17), (20, 21, 29)]


def coefficient(random):
    return random.choice([Fraction(0), Fraction(1, 10), Fraction(1, 4), Fraction(1, 3), HALF, Fraction(3, 4), Fraction(1), Fraction(2)])


def box(s, name, at, width, height, mass):
    s.bodies.append(Body(name, mass, at, f'{{ box = ["{width}", "{height}"] }}'))


def number(s):
    return f"c{len(s.contacts)}"


def touch(s, of, on, point, normal, mu):
    s.contacts.append(Contact(number(s), of, on, point, normal, mu))


def pile(random, s, size):
    """Blocks on each other, each shifted; some beside the tower, against it."""
    middle, top, below = Fraction(0), Fraction(0), None
    width_below = Fraction(100)
    for k in range(size):
        width, height = Fraction(random.randint(2, 8)), Fraction(random.randint(1, 4))
        x = middle + Fraction(random.randint(-6, 6), random.choice([2, 3, 4]))
        left = max(x - width / 2, middle - width_below / 2)
        right = min(x + width / 2, middle + width_below / 2)
        if right <= left:
            x, left, right = middle, middle - min(width, width_below) / 2, middle + min(width, width_below) / 2
        mu = coefficient(random)
        box(s, f"b{k}", (x, top + height / 2), width, height, Fraction(random.randint(1, 6)))
        touch(s, f"b{k}", below, (left, top), UP, mu)
        touch(s, f"b{k}", below, (right, top), UP, mu)
        middle, top, below, width_below = x, top + height, f"b{k}", width


def wall(random, s, size):
    """Courses of bricks with joints anywhere; upright joints touch or not."""
    courses = random.randint(2, 5)
    length = max(2, size // courses)
    mu, sides = coefficient(random), random.random() < 0.5
    lower = [(None, Fraction(-1), Fraction(4 * length + 2))]
    for row in range(courses):
        if len(s.bodies) >= size:
            break
        left = Fraction(random.randint(0, 3))
        bricks = []
        for k in range(length):
            width = Fraction(random.randint(2, 4))
            name = f"b{row}_{k}"
            overlaps = [(n, max(left, a), min(left + width, b)) for n, a, b in lower if max(left, a) < min(left + width, b)]
            if not overlaps:
                break
            box(s, name, (left + width / 2, row + HALF), width, Fraction(1), width)
            for n, a, b in overlaps:
                touch(s, name, n, (a, Fraction(row)), UP, mu)
                touch(s, name, n, (b, Fraction(row)), UP, mu)
            if sides and bricks and bricks[-1][2] == left:
                for y in (Fraction(row), Fraction(row + 1)):
                    touch(s, name, bricks[-1][0], (left, y), (Fraction(1), Fraction(0)), mu)
            bricks.append((name, left, left + width))
            left += width + random.choice([Fraction(0), Fraction(0), HALF])
        lower = bricks


def rods(random, s, size):
    """Rods that lean against each other in pairs, rods at walls, and blocks laid over the pairs."""
    x, mu, mu_top = Fraction(0), coefficient(random), coefficient(random)
    while len(s.bodies) + 3 <= max(size, 3):
        a, b, c = random.choice(TRIPLES)
        length = Fraction(random.choice([2, 4, 5]))
        dx, dy = length * Fraction(a, c), length * Fraction(b, c)
        k = len(s.bodies)
        top = (x + dx, dy)
        for name, foot in ((f"r{k}", x), (f"r{k + 1}", x + 2 * dx)):
            at = ((foot + top[0]) / 2, dy / 2)
            ends = [minus((foot, Fraction(0)), at), minus(top, at)]
            line = ", ".join(f'["{p}", "{q}"]' for p, q in ends)
            s.bodies.append(Body(name, Fraction(random.randint(1, 4)), at, f"{{ line = [{line}] }}"))
            touch(s, name, None, (foot, Fraction(0)), UP, mu)
        if random.random() < 0.3:  # a wall in place of the second rod's top
            touch(s, f"r{k}", None, top, (Fraction(-1), Fraction(0)), mu_top)
            touch(s, f"r{k + 1}", None, top, (Fraction(1), Fraction(0)), mu_top)
        else:
            touch(s, f"r{k}", f"r{k + 1}", top, (Fraction(-1), Fraction(0)), mu_top)
        if random.random() < 0.5:
            width = Fraction(random.randint(1, 3))
            lid = (top[0] + Fraction(random.randint(-2, 2), 4), dy + HALF)
            box(s, f"lid{k}", lid, width, Fraction(1), Fraction(random.randint(1, 3)))
            of = random.choice([f"r{k}", f"r{k + 1}"])
            touch(s, f"lid{k}", of, top, UP, mu_top)
            touch(s, f"lid{k}", of, (top[0] + Fraction(random.choice([-1, 1]), 4), dy), UP, mu_top)
        x += 2 * dx + 1


def circle_point(t):
    return ((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t))


def arch(random, s, size):
    """Stones between joints in rational directions, over half a circle or less."""
    stones = random.randint(2, max(2, min(size, 12)))
    cuts = sorted(random.sample(range(1, 40), stones - 1))
    start = random.choice([Fraction(0), Fraction(1, 8)])
    halves = [start + (1 - start) * Fraction(k, 40) for k in [0] + cuts] + [None]
    joints = [circle_point(t) for t in halves[:-1]]
    joints = joints + [(-p, q) for p, q in reversed(joints)]
    joints = sorted(set(joints), reverse=True)
    inner, outer, mu = Fraction(10), 10 + Fraction(random.randint(1, 12), 4), coefficient(random)
    for k, (p, q) in enumerate(zip(joints, joints[1:])):
        area = (outer**2 - inner**2) / 2 * (p[0] * q[1] - p[1] * q[0])
        scale = (outer**3 - inner**3) / (outer**2 - inner**2) / 3
        at = (scale * (p[0] + q[0]), scale * (p[1] + q[1]))
        corners = [minus(times(r, d), at) for r, d in ((inner, p), (outer, p), (outer, q), (inner, q))]
        polygon = ", ".join(f'["{x}", "{y}"]' for x, y in corners)
        s.bodies.append(Body(f"b{k}", area, at, f"{{ polygon = [{polygon}] }}"))
    last = len(s.bodies) - 1
    for k, d in enumerate(joints):
        of, on = (f"b{k}", f"b{k - 1}" if k else None) if k <= last else (f"b{last}", None)
        normal = (-d[1], d[0]) if k <= last else (d[1], -d[0])
        for r in (inner, outer):
            touch(s, of, on, times(r, d), normal, mu)


def anywhere(random, s, size):
    """Bodies without shape, which touch the ground and each other at any points in any rational directions."""
    for k in range(random.randint(1, size)):
        at = (Fraction(random.randint(-5, 5)), Fraction(random.randint(-5, 5)))
        s.bodies.append(Body(f"b{k}", Fraction(random.randint(1, 5)), at))
        for _ in range(random.randint(1, 4)):
            on = random.choice([None, f"b{random.randrange(k)}"]) if k else None
            a, b, c = random.choice(TRIPLES + [(0, 1, 1), (0, 1, 1), (1, 0, 1)])
            normal = (Fraction(random.choice([a, -a]), c), Fraction(random.choice([b, b, b, -b]), c))
            point = (at[0] + Fraction(random.randint(-4, 4), 2), at[1] + Fraction(random.randint(-4, 4), 2))
            touch(s, f"b{k}", on, point, normal, coefficient(random))


def linkage(random, s, size):
    """A chain of rods with pins, between supports; some rods lie on others."""
    foot = (Fraction(0), Fraction(0))
    for k in range(random.randint(1, min(size, 8))):
        a, b, _ = random.choice(TRIPLES)
        head = (foot[0] + a, foot[1] + random.choice([b, -b, 0]))
        at = ((foot[0] + head[0]) / 2, (foot[1] + head[1]) / 2)
        s.bodies.append(Body(f"b{k}", Fraction(random.randint(1, 5)), at))
        if k and random.random() < 0.8:
            s.pins.append(Pin(f"p{k}", f"b{k - 1}", f"b{k}", foot))
        elif k == 0 and random.random() < 0.5:
            s.pins.append(Pin("p0", "b0", None, foot))
        else:
            touch(s, f"b{k}", None, foot, UP, coefficient(random))
        if random.random() < 0.5 or k == 0:
            touch(s, f"b{k}", None, head, random.choice([UP, UP, (Fraction(-1), Fraction(0)), (Fraction(-3, 5), Fraction(4, 5))]), coefficient(random))
        foot = head


MOST_CONTACTS = 400  # more make the comparison slow
KINDS = [pile, wall, rods, arch, anywhere, linkage]


def structure(random, name, size):
    kind, size = random.choice(KINDS), random.randint(1, size)
    gravity = (Fraction(random.choice([0, 0, 0, 1, 2])), Fraction(-10))
    while True:
        s = Structure(name, 2, gravity)
        kind(random, s, size)
        if len(s.contacts) <= MOST_CONTACTS:
            break
        size -= 1
    if random.random() < 0.5:
        body = random.choice(s.bodies)
        at = (body.at[0] + Fraction(random.randint(-2, 2), 2), body.at[1] + Fraction(random.randint(-2, 2), 2))
        direction = (Fraction(random.randint(-2, 2)), Fraction(random.randint(-2, 2)))
        if direction != (0, 0):
            zero = (Fraction(0), Fraction(0))
            constant = random.choice([zero, (Fraction(random.randint(-5, 5)), Fraction(0))])
            s.forces.append(Force(body.name, at, constant, direction))
            s.load = Fraction(random.randint(-3, 10), random.choice([1, 2]))
    return s
