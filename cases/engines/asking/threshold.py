"""Where an engine changes its mind: the value of a parameter at which something begins to move.

The contacts, brakes and clutches that are in other states below than above the threshold decide: whether a contact
opens is seen by its gap, whether it slides by its slip, both as accelerations. They rest at one end of the interval and
move at the other. Motion is what exceeds a floor, a part of the scene's natural acceleration. Bisection finds where
the motion of the engine passes the floor. There a line through two motions must lead to a kink close by:

    motion                  *             o  asked on the side that moves
                         o                *  where the line is checked
      floor - - - - - *- - -
                   o                      The threshold is where the line meets the rest that the engine has just
      rest  o----/                        beyond: nothing, rounding, or the creep of a soft contact.

Where it does not, the engine only creeps past the floor. The floor begins at a hundredth and is made ten times smaller
as long as that leads to the same kink.
"""

import math
from fractions import Fraction

from .space import cross, dot
from .world import Refused, natural

GRID = 2.0**-30  # of the interval: where engines are asked
NARROW = 2.0**-24  # of the interval: where bisection ends
FLOORS = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)  # an engine that creeps at rest by more than the first has no threshold
CLOSE = 1 / 16  # of the interval: how far from the kink what moves as much as the floor may be


class Creeps(Exception):
    """There is no kink where the motion passes the floor."""


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
    """[(element, kind, sign)]: what is positive above and 0 below (sign 1) or the other way round (-1); kind is `gap`,
    in space `slip`, or in the plane the sign with which a slip counts. All have the sign of the first."""
    result = []
    for element, (below, above) in enumerate(zip(states(change["below"]), states(change["above"]))):
        if below & above:
            continue
        for one, other, sign in ((below, above, 1), (above, below, -1)):
            if other == {"lift"}:
                result.append((element, "gap", sign))
            elif other == {"slip"} and one == {"stick"}:
                result.append((element, "slip", sign))
            elif other in ({"slip+"}, {"slip-"}) and one == {"stick"}:
                result.append((element, 1 if other == {"slip+"} else -1, sign))
    unique = {(element, kind if isinstance(kind, str) else abs(kind)): (element, kind, sign) for element, kind, sign in result}
    if not unique:
        raise Refused("no contact tells both sides of the threshold apart")
    result = list(unique.values())
    return [one for one in result if one[2] == result[0][2]]


def acceleration(bodies, values, number, point):
    body = bodies[number]
    if len(point) == 3:
        return acceleration_in_space(body, values, point)
    own = list(body.get("acceleration", [0, 0])) + [body.get("turning", 0)]
    for i, name in enumerate(body["names"]):
        if name:
            own[i] = values[name[0]] * name[1]
    x, y = (p - q for p, q in zip(point, body["at"]))
    return own[0] - own[2] * y, own[1] + own[2] * x, own[2]


def acceleration_in_space(body, values, point):
    own = list(body.get("acceleration", [0, 0, 0])) + list(body.get("turning", [0, 0, 0]))
    for i, name in enumerate(body["names"]):
        if name:
            own[i] = values[name[0]] * name[1]
    turning = cross(own[3:], [p - q for p, q in zip(point, body["at"])])
    return [a + b for a, b in zip(own, turning)]


def quantity(built, values, element, kind):
    """The gap or slip of an element as an acceleration, from the accelerations of the bodies."""
    contacts = built["contacts"]
    if element >= len(contacts):
        brake = built["friction"][element - len(contacts)]
        turning = [acceleration(built["bodies"], values, brake[side], [0, 0])[2] for side in ("first", "second")]
        return kind * (turning[0] - turning[1])
    contact = contacts[element]
    of, on = (acceleration(built["bodies"], values, contact[side], contact["at"]) for side in ("of", "on"))
    if kind == "slip":
        apart = [p - q for p, q in zip(of, on)]
        return math.hypot(dot(contact["tangent"], apart), dot(contact["second"], apart))
    along = contact["normal"] if kind == "gap" else contact["tangent"]
    return (1 if kind == "gap" else kind) * sum(d * (p - q) for d, p, q in zip(along, of, on))


class Bisection:
    """Places are parts of the interval, 0 where the scene rests and 1 where it moves."""

    def __init__(self, scene, ask, floor=1e-6):
        threshold = scene.expected["threshold"]
        if len(threshold["changes"]) != 1:
            raise Refused("not one threshold")
        self.scene, self.ask, self.parameter = scene, ask, threshold["parameter"]
        self.floors = [one for one in FLOORS if one >= floor]
        self.deciding = deciding(threshold["changes"][0])
        ends = [Fraction(threshold[end]["exact"]) for end in ("from", "to")]
        self.rest, self.move = ends if self.deciding[0][2] > 0 else ends[::-1]
        self.known = {}

    def value(self, place):
        return self.rest + Fraction(place) * (self.move - self.rest)

    def seen(self, value):
        """What each deciding element shows at a value of the parameter, and the scene's natural acceleration there."""
        question, answer = self.ask(f"{self.parameter}={value}")
        built = question["ask"]["world"]
        if len(built["contacts"]) != len(question["contacts"]):
            raise Refused("a contact that is open from the beginning")
        shown = [quantity(built, answer["motion"], element, kind) for element, kind, _ in self.deciding]
        return shown, natural(built)

    def motions(self, place):
        """What each deciding element shows, in parts of the largest natural acceleration of both ends."""
        if not self.known:
            ends = [self.seen(self.value(end)) for end in (0, 1)]
            self.scale = max(scale for _, scale in ends)
            self.known = {end: [q / self.scale for q in shown] for end, (shown, _) in enumerate(ends)}
        if place not in self.known:
            self.known[place] = [q / self.scale for q in self.seen(self.value(place))[0]]
        return self.known[place]

    def motion(self, place):
        return max(self.motions(place))

    def run(self):
        """(value, about how far it may be off, floor), or Refused if the engine has no threshold."""
        best, reach = None, None
        for floor in self.floors:
            if not self.motion(0) <= floor < self.motion(1):
                continue
            try:
                rests, moves = self.passing(floor)
                place, off = self.kink(rests, moves)
            except Creeps:
                if best:
                    break
                continue
            if best and abs(place - best[0]) > reach:
                break
            best, reach = (place, off, floor), max(moves - place, NARROW)
        if best:
            place, off, floor = best
            return float(self.value(place)), off * float(abs(self.move - self.rest)), floor
        alike = all((self.motion(0) <= floor) == (self.motion(1) <= floor) for floor in self.floors)
        raise Refused("the engine sees no difference between both ends of the interval" if alike else
                      "the engine creeps, and has no threshold")

    def passing(self, floor):
        """A place that rests, and one beside it that moves by one to three times the floor, if nothing jumps. Of several
        such places the one nearest to the end that moves."""
        rests = max(place for place in self.known if self.motion(place) <= floor)
        moves, bisect = min(place for place in self.known if place > rests), True
        while moves - rests > NARROW and self.motion(moves) > 3 * floor:
            guess = None if bisect else self.where(2 * floor, moves)
            place = guess if guess and rests < guess < moves else on_grid((rests + moves) / 2)
            before = moves - rests
            if self.motion(place) > floor:
                moves = place
            else:
                rests = place
            bisect = moves - rests > before / 2
        return rests, moves

    def where(self, motion, moves):
        """Where a line through the last place that moves and the next one known beyond has a motion."""
        beyond = min((place for place in self.known if place > moves), default=None)
        rise = beyond and self.motion(beyond) - self.motion(moves)
        return on_grid(moves - (self.motion(moves) - motion) * (beyond - moves) / rise) if rise else None

    def kink(self, rests, moves):
        """(place, about how far it may be off). Raises Creeps."""
        if moves - rests <= NARROW:  # it jumps, or is that steep
            return (rests + moves) / 2, (moves - rests) / 2
        element = max(range(len(self.deciding)), key=lambda i: self.motions(moves)[i])
        farther = self.farther(element, moves)

        def line(first, second, level):
            p, q = self.motions(first)[element], self.motions(second)[element]
            if q <= p:
                raise Creeps
            return first - (p - level) * (second - first) / (q - p)

        motion, beyond = self.motions(moves)[element], on_grid(2 * line(moves, farther, 0) - moves)
        if beyond < 0 or moves - beyond > 2 * CLOSE:
            raise Creeps
        left = self.motions(beyond)[element]
        if abs(left) > motion / 2:
            raise Creeps
        place = line(moves, farther, left)
        middle = on_grid((moves + place) / 2)
        if not place < middle < moves or abs(self.motions(middle)[element] - (motion + left) / 2) > (motion - left) / 8:
            raise Creeps
        return place, max(abs(place - line(middle, moves, left)), GRID)

    def farther(self, element, moves):
        """A place that moves by about two to four times as much."""
        motion = self.motions(moves)[element]
        place = min((place for place in self.known if place > moves), default=None)
        if place is None:  # the end itself
            raise Creeps
        while self.motions(place)[element] > 4 * motion:
            rise = self.motions(place)[element] - motion
            place = on_grid(moves + (place - moves) * min(2 * motion / rise, 0.5))
            if place <= moves:
                raise Creeps
        return place


def on_grid(place):
    return round(place / GRID) * GRID
