"""Joints and contacts: what a file says of each, and the functions of a motion that stay 0 or that its forces work along.

A function of places (`Place`) is the joint's own condition, such as the distance of two points; a function of rates
(`Rate`) a velocity, such as that of sliding.
"""
from fractions import Fraction

from series import UNITS, Vector


class Place:
    """Stays 0, or works, by its own value: velocities are its first derivative, accelerations its second."""

    def __init__(self, function):
        self.function = function

    @staticmethod
    def speed(value):
        return value.first

    @staticmethod
    def change(value):
        return value.second


class Rate:
    """Already a velocity."""

    def __init__(self, function):
        self.function = function

    @staticmethod
    def speed(value):
        return value.value

    @staticmethod
    def change(value):
        return value.first


def texts(values):
    return "[" + ", ".join(f'"{v}"' for v in values) + "]"


class Element:
    """`links`: functions that stay 0. `rows`: name of a force and the function that it works along, positive where it
    pushes. `loads`: functions and the force along them that is given. `armatures`: functions and the inertia against their
    speeds."""

    def __init__(self, among):
        self.among, self.links, self.rows, self.loads, self.armatures, self.text = [b.name for b in among], [], [], [], [], ""
        self.speeds = []  # functions and what their speeds must be
        self.friction, self.slides = Fraction(0), None

    def conditions(self):
        """All functions whose speeds are known, with these."""
        return [(f, 0) for f in self.links] + self.speeds


def each(function):
    """One function for each component of a vector-valued one."""
    return [Place(lambda m, i=i: function(m)[i]) for i in range(3)]


def spin(m, body):
    marks = [m.turned(body, u) for u in UNITS]
    twice = [mark.cross(Vector(*(x.derivative() for x in mark))) for mark in marks]
    return (twice[0] + twice[1] + twice[2]) * Fraction(1, 2)


def columns_differ(first, second):
    """Nine conditions that both bodies turn alike: each axis of the scene, carried by one and by the other."""
    return [f for u in UNITS for f in each(lambda m, u=u: m.turned(first, u) - m.turned(second, u))]


class Joint(Element):
    """The kinds whose conditions are about two points and axes. `to` need not be where `at` is for those that slide."""

    def __init__(self, name, kind, first, second, at, to, axis=None, other_axis=None, write_to=True,
                 armature=None):
        super().__init__((first, second))
        self.kind = kind

        def apart(m):
            return m.place(second, to) - m.place(first, at)

        here = first.axes
        along = None if axis is None else here[0] * axis[0] + here[1] * axis[1] + here[2] * axis[2]
        if kind in ("ball", "hinge", "weld", "universal"):
            self.links += each(apart)
        if kind in ("slider", "cylindrical"):
            self.links += each(lambda m: apart(m).cross(m.turned(first, along)))
        if kind in ("hinge", "cylindrical"):
            self.links += each(lambda m: m.turned(first, along) - m.turned(second, along))
        if kind in ("weld", "slider"):
            self.links += columns_differ(first, second)
        if kind == "universal":
            self.links.append(Place(lambda m: m.direction(first, axis).dot(m.direction(second, other_axis))))
        if armature is not None:
            marks = UNITS if kind == "ball" else (along,)
            rates = [Place(lambda m: apart(m).dot(m.turned(first, along))) if kind == "slider" else
                     Rate(lambda m, u=u: m.turned(first, u).dot(spin(m, second) - spin(m, first))) for u in marks]
            self.armatures += [(rate, armature) for rate in rates]
        self.text = (f'[[joint]]\nname = "{name}"\nkind = "{kind}"\nbetween = ["{first.name}", "{second.name}"]\n'
                     f'at = {texts(at)}\n')
        self.text += f"to = {texts(to)}\n" if write_to else ""
        self.text += f'armature = "{armature}"\n' if armature is not None else ""
        self.text += f"axis = {texts(axis)}\n" if axis is not None else ""
        self.text += f"to_axis = {texts(other_axis)}\n" if other_axis is not None else ""


class Span(Element):
    """Rod, taut rope, spring: something between two points at a known distance."""

    def __init__(self, name, kind, first, second, at, to, length, force=None):
        super().__init__((first, second))
        self.kind = kind

        def distance(m):
            between = m.place(first, at) - m.place(second, to)
            square = between.dot(between)
            # Where only one body is tried, the others stay: the distance of now is the same in each motion.
            return square.root(length)

        if kind == "rod":
            self.links.append(Place(distance))
        elif kind == "rope":
            self.rows = [(name, "N", Place(lambda m: -distance(m)))]
            self.speeds = [(f, 0) for _, _, f in self.rows]
        else:
            self.loads.append((Place(distance), -force))
        self.text = (f'[[joint]]\nname = "{name}"\nkind = "{kind}"\nbetween = ["{first.name}", "{second.name}"]\n'
                     f'at = {texts(at)}\nto = {texts(to)}\nlength = "{length}"\n')
        self.text += f'force = "{force}"\n' if force is not None else ""


class Gear(Element):
    """The second body's turning over the first's, each about an axis of the carrier on which it is hinged."""

    def __init__(self, name, first, second, carrier, axes, ratio):
        super().__init__((first, second, carrier))
        self.kind = "gear"

        def turned(m, body, axis):
            """The rate at which a mark across the axis turns about it, as the carrier sees it."""
            along = carrier.to_scene(axis) - carrier.at
            side = next(v for v in map(along.cross, UNITS) if v.dot(v) != 0)

            def rate(mark):
                return mark.cross(Vector(*(x.derivative() for x in mark))).dot(m.turned(carrier, along))

            return (rate(m.turned(body, side)) - rate(m.turned(carrier, side))) * (1 / side.dot(side))

        self.links.append(Rate(lambda m: turned(m, second, axes[1]) - turned(m, first, axes[0]) * ratio))
        self.text = (f'[[joint]]\nname = "{name}"\nkind = "gear"\nbetween = ["{first.name}", "{second.name}"]\n'
                     f'ratio = "{ratio}"\ncarrier = "{carrier.name}"\naxis = {texts(axes[0])}\n')
        self.text += f"to_axis = {texts(axes[1])}\n" if axes[1] != axes[0] else ""


class Contact(Element):
    """A sphere, or a point where the radius is 0, on a plane or on a sphere; `frame`: normal and both tangents in the
    scene now. `sliding`: the velocity along both tangents of the material points that touch, and its length."""

    def __init__(self, name, of, on, point, radius, frame, friction, sliding=(0, 0, 0), through=None, on_point=None,
                 on_radius=None):
        super().__init__((of, on))
        self.friction = friction or Fraction(0)
        self.slides = None if sliding[2] == 0 else (sliding[0] / sliding[2], sliding[1] / sliding[2])
        self.kind = "plane" if on_point is None else "sphere" if on_radius > 0 else "hollow sphere"
        own = [on.to_own(on.at + v) for v in frame]
        between_centres = 0 if on_radius is None else radius + on_radius

        def normal_and_gap(m):
            centre = m.place(of, point)
            if on_point is None:
                n = m.turned(on, frame[0])
                return n, n.dot(centre - m.place(on, through)) - radius, centre
            between = centre - m.place(on, on_point)
            distance = between.dot(between).root(between_centres)  # negative in a hollow sphere
            return between * distance.inverse(), distance - between_centres, centre

        def slip(m, k):
            n, _, centre = normal_and_gap(m)
            touched = centre - n * radius
            apart = m.velocity_of_matter(of, touched) - m.velocity_of_matter(on, touched)
            return apart.dot(m.turned(on, frame[k]))

        self.rows = [(name, "N", Place(lambda m: normal_and_gap(m)[1]))]
        if friction is not None:
            self.rows += [(name, f"T{k}", Rate(lambda m, k=k: slip(m, k))) for k in (1, 2)]
        self.speeds = [(f, speed) for (_, _, f), speed in zip(self.rows, (0, *sliding))]
        self.text = f'[[contact]]\nname = "{name}"\nof = "{of.name}"\npoint = {texts(point)}\n'
        self.text += f'radius = "{radius}"\n' if radius else ""
        self.text += f'on = "{on.name}"\n'
        self.text += (f"normal = {texts(own[0])}\nthrough = {texts(through)}\n" if on_point is None
                      else f'on_point = {texts(on_point)}\non_radius = "{on_radius}"\n')
        self.text += f'friction = "{friction}"\ntangent = {texts(own[1])}\n' if friction is not None else ""


class Force(Element):
    def __init__(self, on, at, force, follows, back_on):
        super().__init__((on,) if back_on is None else (on, back_on))
        is_now = force if not follows else on.to_scene(force) - on.at
        place = on.to_scene(at)
        for k in range(3):
            self.loads.append((Place(lambda m, k=k: m.place(on, at)[k]), is_now[k]))
            if back_on is not None:
                own = back_on.to_own(place)
                self.loads.append((Place(lambda m, k=k, own=own: m.place(back_on, own)[k]), -is_now[k]))
        self.text = f'[[force]]\non = "{on.name}"\nat = {texts(at)}\nis = {texts(force)}\n'
        self.text += 'axes = "body"\n' if follows else ""
        self.text += f'back_on = "{back_on.name}"\n' if back_on is not None else ""


class Torque(Element):
    def __init__(self, on, couple, back_on):
        super().__init__((on,) if back_on is None else (on, back_on))

        for k in range(3):
            self.loads.append((Rate(lambda m, k=k: spin(m, on)[k]), couple[k]))
            if back_on is not None:
                self.loads.append((Rate(lambda m, k=k: spin(m, back_on)[k]), -couple[k]))
        self.text = f'[[torque]]\non = "{on.name}"\nis = {texts(couple)}\n'
        self.text += f'back_on = "{back_on.name}"\n' if back_on is not None else ""
