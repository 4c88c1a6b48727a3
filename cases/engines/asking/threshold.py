"""Where an engine changes its mind: bisection of a parameter between two modes of motion.

The contacts, brakes and clutches that are in other states below than above the threshold decide: whether a contact
opens is seen by its gap, whether it slides by its slip, both as accelerations. What an engine leaves of them in the
state in which they are 0, at the end of the interval, is its noise; what counts as motion must be four times as large.
"""

from fractions import Fraction

from .world import Refused

NARROW = Fraction(1, 2**24)  # of the whole interval, where bisection ends, and a grid for its points


def state(column):
    """The state of an element in one motion, which may be in several modes: at a border between them."""
    if len(column) == 1:
        return next(iter(column))
    slips = column - {"lift"}
    return next(iter(slips)) if len(slips) == 1 else "stick"


def states(side):
    """For each element of the mechanism the states that it has in the motions on this side of the threshold."""
    motions = [[state(set(column)) for column in zip(*(mode.split("/") for mode in motion))]
               for motion in side["motions"]]
    if not motions or side["continua"]:
        raise Refused("there is no motion, or a continuum, on one side of the threshold")
    return [set(column) for column in zip(*motions)]


def deciding(change):
    """[(element, kind, sign)]: what is positive above and 0 below (sign 1), the other way round (-1) or changes its
    sign from minus to plus (2) or back (-2); kind is `gap`, or the sign with which a slip counts."""
    result = []
    for element, (below, above) in enumerate(zip(states(change["below"]), states(change["above"]))):
        if below & above:
            continue
        for one, other, sign in ((below, above, 1), (above, below, -1)):
            if other == {"lift"}:
                result.append((element, "gap", sign))
            elif other == {"slip+"} and one == {"slip-"}:
                result.append((element, 1, 2 * sign))
            elif other in ({"slip+"}, {"slip-"}) and one == {"stick"}:
                result.append((element, 1 if other == {"slip+"} else -1, sign))
    unique = {(element, kind if kind == "gap" else abs(kind)): (element, kind, sign) for element, kind, sign in result}
    if not unique:
        raise Refused("no contact tells both sides of the threshold apart")
    return list(unique.values())


def acceleration(bodies, values, number, point):
    body = bodies[number]
    own = list(body.get("acceleration", [0, 0])) + [body.get("turning", 0)]
    for i, name in enumerate(body["names"]):
        if name:
            own[i] = values[name[0]] * name[1]
    x, y = (p - q for p, q in zip(point, body["at"]))
    return own[0] - own[2] * y, own[1] + own[2] * x, own[2]


def quantity(built, values, element, kind):
    """The gap or slip of an element as an acceleration, from the accelerations of the bodies."""
    contacts = built["contacts"]
    if element >= len(contacts):
        brake = built["friction"][element - len(contacts)]
        turning = [acceleration(built["bodies"], values, brake[side], [0, 0])[2] for side in ("first", "second")]
        return kind * (turning[0] - turning[1])
    contact = contacts[element]
    of, on = (acceleration(built["bodies"], values, contact[side], contact["at"]) for side in ("of", "on"))
    along = contact["normal"] if kind == "gap" else contact["tangent"]
    return (1 if kind == "gap" else kind) * sum(d * (p - q) for d, p, q in zip(along, of, on))


class Bisection:
    def __init__(self, scene, ask):
        threshold = scene.expected["threshold"]
        if len(threshold["changes"]) != 1:
            raise Refused("not one threshold")
        self.scene, self.ask, self.parameter = scene, ask, threshold["parameter"]
        self.ends = [Fraction(threshold[end]["exact"]) for end in ("from", "to")]
        self.deciding = deciding(threshold["changes"][0])

    def seen(self, value):
        """What each deciding element shows at a value of the parameter."""
        question, answer = self.ask(f"{self.parameter}={value}")
        built = question["ask"]["world"]
        if len(built["contacts"]) != len(question["contacts"]):
            raise Refused("a contact that is open from the beginning")
        return [quantity(built, answer["motion"], element, kind) for element, kind, _ in self.deciding]

    def run(self):
        """(value, half the width of the last interval), or Refused if the engine sees both ends alike."""
        shown = [self.seen(end) for end in self.ends]
        largest = max(abs(q) for end in shown for q in end)
        self.noise = [0 if abs(sign) == 2 else 4 * abs(shown[0 if sign > 0 else 1][i]) + 1e-9 * largest
                      for i, (_, _, sign) in enumerate(self.deciding)]
        if self.above(shown[0]) or not self.above(shown[1]):
            raise Refused("the engine sees no difference between both ends of the interval")
        self.low, self.high = self.ends
        self.moving = []
        for end, at in zip(self.ends, shown):
            self.remember(end, at)
        self.narrow()
        return float((self.low + self.high) / 2), float((self.high - self.low) / 2)

    def narrow(self):
        """Halves the interval, and later looks beside the place where a line through the last two motions is 0."""
        span, halvings = self.high - self.low, 0
        while self.high - self.low > span * NARROW:
            guess = self.guess(span * NARROW / 2) if halvings >= 5 else None
            width = max((self.high - self.low) / 4096, span * NARROW / 2)
            if guess and self.low < guess - width and guess + width < self.high:
                self.split(guess + width)
                if guess - width > self.low:
                    self.split(guess - width)
                halvings = 3
            else:
                self.split((self.low + self.high) / 2)
                halvings += 1

    def split(self, value):
        shown = self.seen(value)
        self.remember(value, shown)
        if self.above(shown):
            self.high = value
        else:
            self.low = value

    def remember(self, value, shown):
        """Keeps the last two places where the first deciding element moves, and how."""
        if abs(shown[0]) > self.noise[0]:
            self.moving = self.moving[-1:] + [(value, shown[0])]

    def guess(self, grid):
        """On a grid, so that what slipproof exported for another engine is found again."""
        if len(self.moving) < 2 or self.moving[0][1] == self.moving[1][1]:
            return None
        (a, p), (b, q) = self.moving
        root = a - Fraction(p) * (b - a) / Fraction(q - p)
        return self.ends[0] + round((root - self.ends[0]) / grid) * grid

    def above(self, shown):
        """Whether any deciding element is as it should be above the threshold."""
        return any((q > noise) == (sign > 0) for q, noise, (_, _, sign) in zip(shown, self.noise, self.deciding))
