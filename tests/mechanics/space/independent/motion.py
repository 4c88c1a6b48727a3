"""Bodies that move: places, directions and velocities of material points as series in time, from nothing but x(t) and the
rotation of each body."""
from fractions import Fraction

from series import UNITS, ZERO, Series, Vector, apply, apply_back, rotation


class Body:
    """A rigid body at the instant. Without a mass its motion is prescribed."""

    def __init__(self, name, at=ZERO, quaternion=(1, 0, 0, 0), mass=None, inertia=None, acceleration=ZERO, turning=ZERO):
        self.name, self.at, self.quaternion, self.mass = name, at, quaternion, mass
        self.inertia = inertia  # xx yy zz xy xz yz, in its own axes
        self.axes = rotation(quaternion)
        self.velocity = self.spin = ZERO
        self.acceleration, self.turning = acceleration, turning  # prescribed, of one that has no mass

    @property
    def moves_freely(self):
        return self.mass is not None

    def to_scene(self, own):
        return self.at + apply(self.axes, own)

    def to_own(self, place):
        return apply_back(self.axes, place - self.at)

    def scene_inertia(self):
        xx, yy, zz, xy, xz, yz = self.inertia
        rows = (Vector(xx, xy, xz), Vector(xy, yy, yz), Vector(xz, yz, zz))
        columns = [apply(self.axes, Vector(*(r.dot(apply_back(self.axes, u)) for r in rows))) for u in UNITS]
        return [[columns[k][i] for k in range(3)] for i in range(3)]


class Rates:
    """Velocity, spin, acceleration and turning of one body in a motion that is tried."""

    def __init__(self, velocity=ZERO, spin=ZERO, acceleration=ZERO, turning=ZERO):
        self.velocity, self.spin, self.acceleration, self.turning = velocity, spin, acceleration, turning


REST = Rates()


class Motion:
    """rates: of each body that moves; all others are at rest."""

    def __init__(self, rates):
        self.rates, self.turns, self.turn_rates = rates, {}, {}

    def _turn(self, body):
        """The columns of the rotation since the instant: 1 + 2 ([g] + [g]^2) / (1 + g.g), g = w t / 2 + alpha t^2 / 4."""
        if body.name not in self.turns:
            r = self.rates.get(body.name, REST)
            g = Vector(*(Series(0, w / 2, a / 4) for w, a in zip(r.spin, r.turning)))
            scale = (Series(1) + g.dot(g)).inverse() * 2
            columns = []
            for u in UNITS:
                u = Vector(*map(Series, u))
                columns.append(u + (g.cross(u) + g.cross(g.cross(u))) * scale)
            self.turns[body.name] = columns
        return self.turns[body.name]

    def centre(self, body):
        r = self.rates.get(body.name, REST)
        return Vector(*(Series(x, v, a / 2) for x, v, a in zip(body.at, r.velocity, r.acceleration)))

    def direction(self, body, own):
        return self.turned(body, apply(body.axes, own))

    def turned(self, body, scene):
        """A direction of the scene at the instant, carried along by the body."""
        return apply(self._turn(body), scene)

    def place(self, body, own):
        return self.centre(body) + self.direction(body, own)

    def velocity_of_matter(self, body, place):
        """The velocity of the body's material point that is at a place, which wanders over the body; up to t."""
        turn, centre = self._turn(body), self.centre(body)
        own = apply_back(turn, place - centre)  # which point it is
        rate = [Vector(*(x.derivative() for x in column)) for column in turn]
        return Vector(*(x.derivative() for x in centre)) + apply(rate, own)


def first_motion(bodies):
    """The velocities of now with accelerations 0, but for those that are prescribed."""
    return {b.name: Rates(b.velocity, b.spin, b.acceleration, b.turning) for b in bodies}


def unknowns(bodies):
    """(body, k): k from 0 to 2 along x, y, z, from 3 to 5 about them."""
    return [(b, k) for b in bodies if b.moves_freely for k in range(6)]


def unit(k, sort):
    """Rates with one of them 1: of the velocity and spin, or of the acceleration and turning."""
    straight, round_about = (UNITS[k], ZERO) if k < 3 else (ZERO, UNITS[k - 3])
    return Rates(straight, round_about) if sort == "velocity" else Rates(ZERO, ZERO, straight, round_about)


def work_row(function, bodies, among, speed):
    """Over the unknowns: the speed of a function in each unit velocity. `among`: the bodies that it depends on."""
    def moved(body, k):
        return speed(function(Motion({body.name: unit(k, "velocity")})))

    return [Fraction(moved(b, k) if b in among else 0) for b, k in unknowns(bodies)]


def acceleration_row(function, bodies, among, derivative):
    """The derivative at the instant as an affine form over the unknown accelerations: coefficients and constant."""
    now = first_motion(bodies)
    constant = Fraction(derivative(function(Motion(now))))
    row = []
    for body, k in unknowns(bodies):
        if body not in among:
            row.append(Fraction(0))
            continue
        r, more = now[body.name], unit(k, "acceleration")
        tried = dict(now) | {body.name: Rates(r.velocity, r.spin, more.acceleration, more.turning)}
        row.append(derivative(function(Motion(tried))) - constant)
    return row, constant
