#!/usr/bin/env python3
"""The scenes about rest: what `slipproof rest` says of each, against thresholds by hand.

    by_hand.py SLIPPROOF CASES

A threshold that is a fraction must be told as one, or lie in what is told, which must be narrow; one that is a root of a
polynomial must lie between what is told.
"""
import sys
from fractions import Fraction
from pathlib import Path

import asking

F = Fraction
G = F(981, 100)
NARROW = F(1, 10**8)


def ladder(m, mu_f, mu_w, tan, l, d):
    """The floor takes N = (m g + W)/(1 + mu_f mu_w) and pushes mu_f N to the wall; moments about the foot."""
    hold = 2 * mu_f * (tan + mu_w) / (1 + mu_f * mu_w)
    return m * G * (hold - 1) / ((l + d) / l - hold)


def pointed_ladder(m, mu, tan, d_of_l, e_of_b):
    """Each foot takes half of the push P = (m g + W d/l)/(2 tan) of the pane, and one foot less of W than the other."""
    return m * G * (mu - 1 / (2 * tan)) / (d_of_l / (2 * tan) - mu * (1 - e_of_b))


def flying_buttress(m_w, m_f, m_p, mu):
    """In widths of half the wall: the flyer falls below Q = m_f g/(2 mu - 1), the pier tips at
    13/2 Q = 3/2 (m_p + m_f) g; the wall tips to the left at the first, to the right at the second."""
    least, most = m_f * G / (2 * mu - 1), 3 * (m_p + m_f) * G / 13
    vertical = m_f * G / 2 - least / 2
    return (10 * least - m_w * G - 2 * vertical) / 8, (10 * most + m_w * G) / 8


def row_of_books(m, mu_h, mu_b):
    """The hands bear six books, the joints beside the outer ones four."""
    return max(6 * m * G / (2 * mu_h), 4 * m * G / (2 * mu_b))


def arch(t):
    """Hinges at the crown outside, at the haunches inside, at the springings outside; in units of the radius."""
    return 22 * t**3 - 359 * t**2 - 436 * t + 52


def push_on_arch(rho, R, t, b):
    """Hinges of the arch of five: outside at the right foot, inside above block 1, outside above block 3, inside above
    block 4. Blocks between hinges turn alike, at rates that close the chain; weights and push do no work together."""
    inner, outer = R - t / 2, R + t / 2
    cuts = [(F(1), F(0)), (F(4, 5), F(3, 5)), (F(7, 25), F(24, 25)), (F(-7, 25), F(24, 25)), (F(-4, 5), F(3, 5))]
    hinges = [(r * cuts[k][0], r * cuts[k][1]) for k, r in ((0, outer), (1, inner), (3, outer), (4, inner))]
    d1, d2, d3 = ((q[0] - p[0], q[1] - p[1]) for p, q in zip(hinges, hinges[1:]))

    def across(a, b):
        return a[0] * b[1] - a[1] * b[0]

    rates = [across(d2, d3), across(d3, d1), across(d1, d2)]
    speed, work, aside = (F(0), F(0)), F(0), None
    for hinge, step, rate, blocks in zip(hinges, (d1, d2, d3), rates, ((0,), (1, 2), (3,))):
        for k in blocks:
            p, q = cuts[k], cuts[k + 1]
            mass = 2 * b * rho * across(p, q) * (outer**2 - inner**2) / 2
            centre = (outer**3 - inner**3) / (outer**2 - inner**2) / 3
            work -= mass * G * (speed[1] + rate * (centre * (p[0] + q[0]) - hinge[0]))
            if k == 2:
                aside = speed[0] - rate * (centre * (p[1] + q[1]) - hinge[1])
        speed = (speed[0] - rate * step[1], speed[1] + rate * step[0])
    return -work / aside


def house_of_cards(tan):
    """The upper pair and the flat card weigh 3 m g, 3/4 on each lower card. Moments about its foot: m g/2 + 3/4 m g at the
    top, times cot theta, is the friction; the foot bears 7/4 m g."""
    return (F(1, 2) + F(3, 4)) / (1 + F(3, 4)) / tan


def number(told, value):
    if told is None or value is None:
        return told is value
    lower, upper = map(F, told)
    return lower <= value <= upper and upper - lower <= NARROW * max(1, abs(value))


def root(told):
    lower, upper = map(F, told)
    return arch(lower) * arch(upper) <= 0 and upper - lower <= NARROW


def table(a, b, c, d):
    """Where neighbours among the lines (p, q, r), p H + q P = r, cross."""
    lines = [a, b, c, d]
    found = set()
    for (p, q, r), (s, t, u) in zip(lines, lines[1:] + lines[:1]):
        found.add(((r * t - q * u) / (p * t - q * s), (p * u - r * s) / (p * t - q * s)))
    return found


def corners(told):
    return {(F(c["x"]), F(c["y"])) for c in told["inside"]}


# m g = 80, b = 2/5, c = h = 4/5, mu = 1/4: it slides to the right, tips about its right foot, slides to the left, tips about
# its left foot.
TABLE = table((F(1), F(-1, 4), F(20)), (F(1), F(1, 2), F(40)), (F(-1), F(-1, 4), F(20)), (F(-1), F(-3, 2), F(40)))
LADDER = ladder(F(10), F(1, 4), F(1, 5), F(12, 5), F(2), F(1))
POINTED = pointed_ladder(F(10), F(7, 20), F(12, 5), F(3, 2), F(1, 4))
LEAST, MOST = flying_buttress(F(20000), F(2000), F(60000), F(7, 10))
ARCH, HOUSE = push_on_arch(F(600), F(1, 10), F(1, 50), F(1, 40)), house_of_cards(F(12, 5))
BOOKS = row_of_books(F(1, 2), F(2, 5), F(1, 5))
# scene, options, what is asked of the answer, and whether it is so
QUESTIONS = [
    ("ladder", [], f"W up to {LADDER}", lambda a: a["can_rest"] and number(a["load"]["to"], LADDER)),
    ("pointed-ladder", [], f"W up to {POINTED}", lambda a: a["can_rest"] and number(a["load"]["to"], POINTED)),
    ("three-legged-table", [], "W up to m g/2", lambda a: a["can_rest"] and number(a["load"]["to"], 4 * G)),
    ("tower-of-books", ["--parameter", "q"], "q up to 1", lambda a: a["can_rest"] and number(a["parameter"]["to"], F(1))),
    ("arch-of-four", ["--parameter", "t"], "t from the root", lambda a: a["can_rest"] and root(a["parameter"]["from"])),
    ("flying-buttress", [], f"F from {LEAST} to {MOST}",
     lambda a: a["can_rest"] and number(a["load"]["from"], LEAST) and number(a["load"]["to"], MOST)),
    ("flying-buttress", [], "it can fall, too", lambda a: a["must_rest"] is False),
    ("two-cards", ["--parameter", "mu"], "mu from 5/24", lambda a: a["can_rest"] and number(a["parameter"]["from"], F(5, 24))),
    ("house-of-cards", ["--parameter", "mu"], f"mu from {HOUSE}", lambda a: a["can_rest"] and number(a["parameter"]["from"], HOUSE)),
    ("arch-of-five", [], f"F up to {ARCH} either way",
     lambda a: a["can_rest"] and number(a["load"]["from"], -ARCH) and number(a["load"]["to"], ARCH)),
    ("row-of-books", [], f"P from {BOOKS}", lambda a: a["can_rest"] and number(a["load"]["from"], BOOKS) and a["load"]["to"] is None),
    ("plate-in-two-fingertips", [], "M = 0 only", lambda a: a["can_rest"] and number(a["load"]["from"], F(0)) and number(a["load"]["to"], F(0))),
    ("plate-in-three-fingertips", [], "M up to 2 q sqrt((mu P)^2 - (m g/4)^2) = 4/25",
     lambda a: a["can_rest"] and number(a["load"]["from"], F(-4, 25)) and number(a["load"]["to"], F(4, 25))),
    ("wedge-in-groove", [], "it can stay, and it can come out", lambda a: a["can_rest"] and a["must_rest"] is False),
    ("wedge-in-groove", [], "any pull", lambda a: a["load"]["to"] is None),
    ("wedge-in-groove", ["--parameter", "mu"], "mu from 5/12", lambda a: number(a["parameter"]["from"], F(5, 12))),
    ("block-on-slope", [], "F from (3 - 4 mu)/5 m g to (3 + 4 mu)/5 m g, or what tips it",
     lambda a: a["can_rest"] and number(a["load"]["from"], F(-1, 25) * 10 * G) and number(a["load"]["to"], F(31, 25) * 10 * G)),
    ("block-on-slope", ["--parameter", "mu_s"], "mu_s from 3/4", lambda a: number(a["parameter"]["from"], F(3, 4))),
    ("block-on-board", ["--tilt", "0,1,0"], "tips at 1/3", lambda a: a["can_rest"] and number(a["tilt"]["tangent"], F(1, 3))),
    ("block-on-board", ["--tilt", "1,0,0"], "slides at 1/2", lambda a: number(a["tilt"]["tangent"], F(1, 2))),
    ("block-on-board", ["--tilt", "4/5,3/5,0"], "slides at 1/2, as about any axis", lambda a: number(a["tilt"]["tangent"], F(1, 2))),
    ("table-pulled-at-its-edge", ["--map", "H", "P"], f"corners {TABLE}",
     lambda a: a["map"]["exact"] and corners(a["map"]) == TABLE and len(a["map"]["borders"]) == 4),
    ("block-on-board", ["--tilt", "3/5,4/5,0"], "tips at 5/12", lambda a: number(a["tilt"]["tangent"], F(5, 12))),
]


def main():
    slipproof, cases = sys.argv[1], Path(sys.argv[2])
    wrong = []
    for scene, options, asked, answers in QUESTIONS:
        answer = asking.ask(slipproof, cases / f"{scene}.toml", *options)
        try:
            right = bool(answers(answer))
        except (KeyError, TypeError):
            right = False
        if not right:
            told = {key: answer.get(key) for key in ("failed", "can_rest", "must_rest", "load", "tilt", "parameter")}
            wrong.append(f"{scene} {' '.join(options)}: expected {asked}, found {told}")
    unasked = {file.stem for file in cases.glob("*.toml")} - {scene for scene, *_ in QUESTIONS}
    wrong += [f"{scene}: no question is asked about it" for scene in sorted(unasked)]
    if wrong:
        sys.exit("\n".join(wrong))


main()
