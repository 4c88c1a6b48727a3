"""Random systems of bodies in space, of exact numbers, whose velocities fit all that holds them."""
from fractions import Fraction

from elements import Contact, Force, Gear, Joint, Span, Torque, texts
from linear import solutions
from motion import Body, Motion, Rates, unknowns, work_row
from series import Vector, apply, rotation

JOINTS = ("ball", "hinge", "slider", "cylindrical", "universal", "weld", "rod", "rope", "spring", "gear")

ARMED = ("ball", "hinge", "slider")  # may have an armature


class Draw:
    def __init__(self, rng):
        self.rng = rng

    def number(self, low=-3, high=3):
        return Fraction(self.rng.randint(2 * low, 2 * high), self.rng.choice((1, 2, 3)) * 2)

    def vector(self, low=-3, high=3):
        return Vector(*(self.number(low, high) for _ in range(3)))

    def quaternion(self):
        q = [self.rng.randint(-2, 2) for _ in range(4)]
        return q if any(q) else [1, 0, 0, 0]

    def frame(self):
        """Three directions of length 1 across each other."""
        return rotation(self.quaternion())

    def inertia(self):
        """That of a few points, which any inertia of a body is like; without products in every second."""
        if self.rng.random() < 0.5:
            a, b, c = (Fraction(self.rng.randint(1, 6), 2) for _ in range(3))
            return b + c, a + c, a + b, Fraction(0), Fraction(0), Fraction(0)
        points = [self.vector(-2, 2) for _ in range(4)]
        m = [Fraction(self.rng.randint(1, 4), 4) for _ in points]

        def moment(i, k):
            return sum(w * ((p.dot(p) if i == k else 0) - p[i] * p[k]) for w, p in zip(m, points))

        return tuple(moment(i, k) for i, k in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)))


class System:
    """`ground` and `bodies`; the elements' text is the scene's."""

    def __init__(self, rng, kinds, contacts):
        self.draw, self.rng = Draw(rng), rng
        self.ground = Body("ground")
        self.bodies, self.elements = [], []
        for index in range(rng.randint(1, 5)):
            self.bodies.append(self.body(f"b{index}"))
        if rng.random() < 0.4:
            d = self.draw
            self.bodies.insert(0, Body("moved", d.vector(), d.quaternion(), None, None, d.vector(), d.vector()))
            self.bodies[0].velocity, self.bodies[0].spin = d.vector(-2, 2), d.vector(-2, 2)
        self.gravity = self.draw.vector()
        self.count = 0
        self.hold_all(kinds, contacts)
        self.push()

    def body(self, name):
        d = self.draw
        inertia = d.inertia()
        while not positive(inertia):
            inertia = d.inertia()
        return Body(name, d.vector(), d.quaternion(), Fraction(self.rng.randint(1, 8), 2), inertia)

    def name(self, kind):
        self.count += 1
        return f"{kind}{self.count}"

    def hold_all(self, kinds, contacts):
        """Each body at one before it, by a joint of the next kind; then loops and contacts."""
        kinds = list(kinds)
        free = [b for b in self.bodies if b.moves_freely]
        for index, body in enumerate(free):
            before = [b for b in self.bodies if not b.moves_freely] + free[:index] + [self.ground]
            self.join(kinds.pop(0) if kinds else self.rng.choice(JOINTS), self.rng.choice(before), body)
        for kind in kinds:  # loops
            first, second = self.two()
            self.join(kind, first, second)
        for _ in range(contacts):
            self.touch(*self.two())
        if self.bodies[0].name == "moved":  # which must have a part
            self.touch(self.rng.choice(free), self.bodies[0])

    def two(self):
        """Two bodies, the first of which moves freely."""
        first = self.rng.choice([b for b in self.bodies if b.moves_freely])
        return first, self.rng.choice([b for b in self.bodies + [self.ground] if b is not first])

    def join(self, kind, first, second):
        d, name = self.draw, self.name(kind)
        at = d.vector()
        if kind in ("rod", "rope", "spring"):
            length = Fraction(self.rng.randint(1, 6), 2)
            to = second.to_own(first.to_scene(at) + d.frame()[0] * length)
            self.elements.append(Span(name, kind, first, second, at, to, length, d.number() if kind == "spring" else None))
            return
        if kind == "gear":
            return self.gear(first, second)
        axis = None if kind in ("ball", "weld") else d.frame()[0]
        place, write_to = first.to_scene(at), True
        if kind in ("slider", "cylindrical") and self.rng.random() < 0.7:
            place = place + apply(first.axes, axis) * d.number()
        else:
            write_to = self.rng.random() < 0.7
        other = None
        if kind == "universal":
            axis, other, _ = (first.to_own(first.at + v) for v in d.frame())
            other = second.to_own(second.at + apply(first.axes, other))
        armature = Fraction(self.rng.randint(1, 6), 2) if kind in ARMED and self.rng.random() < 0.5 else None
        self.elements.append(Joint(name, kind, first, second, at, second.to_own(place), axis, other, write_to, armature))

    def gear(self, carrier, second):
        """`second` and another body, both on hinges of the carrier, in every second with one axis."""
        free = [b for b in self.bodies if b.moves_freely and b is not second and b is not carrier]
        axis = self.draw.frame()[0]
        axes = [axis, self.rng.choice((axis, self.draw.frame()[0]))]
        wheels = [self.rng.choice(free), second] if free else [second]
        for body, along in zip(wheels, axes):
            at = self.draw.vector()
            to = body.to_own(carrier.to_scene(at))
            self.elements.append(Joint(self.name("hinge"), "hinge", carrier, body, at, to, along))
        if free:
            ratio = self.draw.number(1, 3) * self.rng.choice((1, -1))
            self.elements.append(Gear(self.name("gear"), wheels[0], second, carrier, axes, ratio))

    def touch(self, of, on):
        d, name = self.draw, self.name("c")
        point, frame = d.vector(), d.frame()
        radius = self.rng.choice((Fraction(0), Fraction(self.rng.randint(1, 4), 2)))
        friction = self.rng.choice((Fraction(1, 2), Fraction(1), Fraction(3, 4), None))
        centre = of.to_scene(point)
        speed = self.rng.choice((0, 0, Fraction(self.rng.randint(1, 4), 2))) if friction is not None else 0
        cosine, sine, _ = rotation((self.rng.randint(-3, 3), 0, 0, self.rng.randint(1, 3)))[0]
        sliding = speed * cosine, speed * sine, speed
        kind = self.rng.choice(("plane", "plane", "sphere", "hollow"))
        if kind == "plane":
            through = on.to_own(centre - frame[0] * radius + frame[1] * d.number() + frame[2] * d.number())
            self.elements.append(Contact(name, of, on, point, radius, frame, friction, sliding, through))
            return
        on_radius = Fraction(self.rng.randint(1, 4), 2)
        if kind == "hollow":
            on_radius = -(radius + on_radius)
        on_point = on.to_own(centre - frame[0] * (radius + on_radius))
        self.elements.append(Contact(name, of, on, point, radius, frame, friction, sliding, None, on_point, on_radius))

    def push(self):
        d = self.draw
        for _ in range(self.rng.randint(0, 2)):
            on, other = self.two()
            other = other if other.moves_freely and self.rng.random() < 0.5 else None
            self.elements.append(Force(on, d.vector(), d.vector(), self.rng.random() < 0.5, other))
        for _ in range(self.rng.randint(0, 1)):
            on, other = self.two()
            self.elements.append(Torque(on, d.vector(), other if other.moves_freely and self.rng.random() < 0.5 else None))

    def slides(self):
        return any(e.slides is not None for e in self.elements)

    def set_velocities(self):
        """Random ones that fit; False if there is only one, or none."""
        given = {b.name: Rates(b.velocity, b.spin) for b in self.bodies if not b.moves_freely}
        columns = unknowns(self.bodies)
        rows, right = [], []
        for e in self.elements:
            for f, speed in e.conditions():
                rows.append(work_row(f.function, self.bodies, [b for b in self.bodies if b.name in e.among], f.speed))
                right.append(Fraction(speed - f.speed(f.function(Motion(given)))))
        found = solutions(rows, right) if rows else ([Fraction(0)] * len(columns), [])
        if found is None or not found[1]:
            return False
        rates = found[0]
        for direction in found[1]:
            factor = self.draw.number(-2, 2)
            rates = [r + factor * x for r, x in zip(rates, direction)]
        for (body, k), rate in zip(columns, rates):
            v = list(body.velocity) + list(body.spin)
            v[k] = rate
            body.velocity, body.spin = Vector(*v[:3]), Vector(*v[3:])
        return True

    def text(self):
        lines = ['schema = "slipproof/mechanism/1"', 'name = "random bodies in space"', "dimension = 3",
                 f"gravity = {texts(self.gravity)}"]
        for b in self.bodies:
            lines.append(f'[[body]]\nname = "{b.name}"')
            if b.moves_freely:
                inertia = b.inertia if any(b.inertia[3:]) else b.inertia[:3]
                lines.append(f'mass = "{b.mass}"\ninertia = {texts(inertia)}')
            else:
                lines.append(f"acceleration = {texts(b.acceleration)}\nturning = {texts(b.turning)}")
            lines.append(f"at = {texts(b.at)}\nturn = {texts(b.quaternion)}\nvelocity = {texts(b.velocity)}\n"
                         f"spin = {texts(b.spin)}\n")
        return "\n".join(lines + [e.text for e in self.elements])


def positive(inertia):
    xx, yy, zz, xy, xz, yz = inertia
    minor = xx * yy - xy * xy
    return xx > 0 and minor > 0 and zz * minor - xx * yz * yz - yy * xz * xz + 2 * xy * xz * yz > 0
