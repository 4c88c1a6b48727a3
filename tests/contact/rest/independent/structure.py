"""Structures of rigid bodies at rest, exactly: their balance, derived here from points and directions alone, and their
files for slipproof. Shares nothing with the program: no equation of its comes in."""
from dataclasses import dataclass, field
from fractions import Fraction


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def times(k, a):
    return tuple(k * x for x in a)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def wrench(direction, arm):
    """A force of length 1 in this direction at this arm: force and couple; in the plane three numbers, in space six."""
    if len(direction) == 2:
        return (*direction, arm[0] * direction[1] - arm[1] * direction[0])
    return (*direction, *cross(arm, direction))


@dataclass
class Body:
    name: str
    mass: Fraction
    at: tuple
    shape: str = ""


@dataclass
class Contact:
    """`of` is pushed by `on` along the normal; `on` is None for the ground. Tangents: one in the plane, the normal turned
    clockwise; two in space, T1 and T2 = normal x T1."""
    name: str
    of: str
    on: str
    point: tuple
    normal: tuple
    mu: Fraction
    tangent: tuple = None

    def directions(self):
        if len(self.normal) == 2:
            return [self.normal, (self.normal[1], -self.normal[0])]
        return [self.normal, self.tangent, cross(self.normal, self.tangent)]

    def forces(self):
        letters = ["N", "S"] if len(self.normal) == 2 else ["N", "T1", "T2"]
        return [f"{letter}_{self.name}" for letter in letters]


@dataclass
class Pin:
    """A joint in the plane: any force on `first`, and its reaction on `second`, which is None for the ground."""
    name: str
    first: str
    second: str
    point: tuple

    def forces(self):
        return [f"R_{self.name}_x", f"R_{self.name}_y"]


@dataclass
class Force:
    """The constant part, and the part that is multiplied by the load F."""
    of: str
    point: tuple
    constant: tuple
    load: tuple


@dataclass
class Structure:
    name: str
    dimension: int
    gravity: tuple
    bodies: list = field(default_factory=list)
    contacts: list = field(default_factory=list)
    forces: list = field(default_factory=list)
    pins: list = field(default_factory=list)
    load: Fraction = None  # the value of F in the scene

    def body(self, name):
        return next(b for b in self.bodies if b.name == name)

    def rows(self):
        """The balance: (name of the acceleration, {force: coefficient}, constant, coefficient of F); their sum is 0."""
        letters = ["ax", "ay", "alpha"] if self.dimension == 2 else ["ax", "ay", "az", "alphax", "alphay", "alphaz"]
        rows, first = [], {}
        for b in self.bodies:
            first[b.name] = len(rows)
            names = letters if len(self.bodies) == 1 else [f"{letter}_{b.name}" for letter in letters]
            weight = wrench(times(b.mass, self.gravity), (Fraction(0),) * self.dimension)
            rows += [[n, {}, w, Fraction(0)] for n, w in zip(names, weight)]
        at = {b.name: b.at for b in self.bodies}
        axes = [(Fraction(1), Fraction(0)), (Fraction(0), Fraction(1))]
        pairs = [(c.of, c.on, c.point, c.forces(), c.directions()) for c in self.contacts]
        pairs += [(p.first, p.second, p.point, p.forces(), axes) for p in self.pins]
        for of, on, point, forces, directions in pairs:
            for body, sign in ((of, 1), (on, -1)):
                if body is not None:
                    for force, d in zip(forces, directions):
                        for k, w in enumerate(wrench(d, minus(point, at[body]))):
                            if w:
                                rows[first[body] + k][1][force] = sign * w
        for f in self.forces:
            arm = minus(f.point, at[f.of])
            for k, (constant, load) in enumerate(zip(wrench(f.constant, arm), wrench(f.load, arm))):
                rows[first[f.of] + k][2] += constant
                rows[first[f.of] + k][3] += load
        return rows

    def write(self, folder):
        """Writes NAME.toml, the scene, and NAME-mechanism.toml into the folder; the scene's path."""
        mus = sorted({c.mu for c in self.contacts})
        symbol = {mu: f"mu{k}" for k, mu in enumerate(mus)}
        out = ['schema = "slipproof/mechanism/1"', f'name = "{self.name}"']
        out += ["dimension = 3"] if self.dimension == 3 else []
        out += [f"gravity = {text(self.gravity)}", "[parameters]"] + [f'{s} = "{s} >= 0"' for s in symbol.values()]
        out += ["[load]", 'symbol = "F"'] if self.load is not None else []
        for b in self.bodies:
            inertia = f'"{b.mass}/100"' if self.dimension == 2 else text([b.mass / 100] * 3)
            out += ["[[body]]", f'name = "{b.name}"', f'mass = "{b.mass}"', f"inertia = {inertia}", f"at = {text(b.at)}"]
            out += [f"shape = {b.shape}"] if b.shape else []
        for c in self.contacts:
            of = self.body(c.of).at
            on = self.body(c.on).at if c.on else (0,) * self.dimension
            out += ["[[contact]]", f'name = "{c.name}"', f'of = "{c.of}"', f"point = {text(minus(c.point, of))}"]
            out += [f'on = "{c.on}"'] if c.on else []
            out += [f"normal = {text(c.normal)}", f"through = {text(minus(c.point, on))}", f'friction = "{symbol[c.mu]}"']
            out += [f"tangent = {text(c.tangent)}"] if c.tangent else []
        for p in self.pins:
            first, second = (self.body(n).at if n else (0, 0) for n in (p.first, p.second))
            out += ["[[joint]]", f'name = "{p.name}"', 'kind = "pin"', f'between = ["{p.first}", "{p.second or "ground"}"]']
            out += [f"at = {text(minus(p.point, first))}", f"to = {text(minus(p.point, second))}"]
        for f in self.forces:
            parts = [affine(constant, load) for constant, load in zip(f.constant, f.load)]
            out += ["[[force]]", f'on = "{f.of}"', f"at = {text(minus(f.point, self.body(f.of).at))}", f"is = {text(parts)}"]
        (folder / f"{self.name}-mechanism.toml").write_text("\n".join(out) + "\n")
        values = [f'{s} = "{mu}"' for mu, s in symbol.items()] + ([f'F = "{self.load}"'] if self.load is not None else [])
        scene = folder / f"{self.name}.toml"
        scene.write_text("\n".join([f'name = "{self.name}"', f'mechanism = "{self.name}-mechanism.toml"', "[values]"] + values) + "\n")
        return scene


def text(numbers):
    return "[" + ", ".join(f'"{x}"' for x in numbers) + "]"


def affine(constant, load):
    return f"{constant}" if not load else f"{constant} + ({load})*F"
