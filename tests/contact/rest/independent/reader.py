"""Reads what `slipproof rest --json` says, and checks it against the structure alone: forces that balance within their
cones, or a motion that no contact forbids and in which gravity and load gain power. Exact."""
from fractions import Fraction


def forces_wrong(structure, forces, load, share=1):
    """Why these forces do not hold the structure at this load and this share of all else that pushes, or ""."""
    r = {name: Fraction(value) for name, value in forces.items()}
    for name, row, constant, factor in structure.rows():
        if sum(r[f] * v for f, v in row.items()) + share * constant + factor * load:
            return f"the balance of {name} is not 0"
    for c in structure.contacts:
        normal, *tangents = (r[f] for f in c.forces())
        if normal < 0 or sum(t * t for t in tangents) > (c.mu * normal) ** 2:
            return f"the force of {c.name} is outside of its cone"
    return ""


def motion_wrong(structure, motion, load):
    """Why this virtual motion does not prove that the structure cannot rest, or ""."""
    v = {name: Fraction(value) for name, value in motion.items()}
    rows = structure.rows()
    unknown = set(v) - {name for name, *_ in rows}
    if unknown:
        return f"there are no accelerations {sorted(unknown)}"
    power = sum(v.get(name, 0) * (constant + factor * load) for name, _, constant, factor in rows)
    if power <= 0:
        return f"its power is {power}"
    sliding = {}
    for name, row, _, _ in rows:
        for force, k in row.items():
            sliding[force] = sliding.get(force, 0) + k * v.get(name, 0)
    for c in structure.contacts:
        normal, *tangents = (sliding.get(f, Fraction(0)) for f in c.forces())
        if normal < 0 or sum(t * t for t in tangents) * c.mu**2 > normal**2:
            return f"{c.name} would do work against it: {normal}, {tangents}"
    for pin in structure.pins:
        if any(sliding.get(f, 0) for f in pin.forces()):
            return f"{pin.name} would come apart"
    return ""


def load_wrong(structure, told):
    """Why an end of the load that is not there is not proved, or ""."""
    for side, key, unit in (("below", "from", -1), ("above", "to", 1)):
        endless = told["endless"][side]
        if bool(endless) != (told[key] is None and told["decided"] and not told["none"]):
            return f"found {'a' if endless else 'no'} proof that the load has no end {side}, and the end {told[key]}"
        if endless:
            message = forces_wrong(structure, endless["forces"], Fraction(endless["load"])) or forces_wrong(
                structure, endless["more"], unit, 0)
            if message:
                return f"{side}: {message}"
    return ""


def wrong(structure, answer):
    """Why this answer does not prove what it says, or "". An answer that says nothing is not wrong."""
    load = structure.load or Fraction(0)
    if structure.load is not None and (message := load_wrong(structure, answer["load"])):
        return message
    if answer["can_rest"] is True:
        return forces_wrong(structure, answer["forces"], load) if answer["forces"] else "no forces are given"
    if answer["can_rest"] is False:
        if not answer["why_not"]:
            return "no motion is given"
        return motion_wrong(structure, answer["why_not"]["motion"], load)
    return ""


def ends(told):
    """[lower, upper] as fractions, or None where there is no end."""
    return told and [Fraction(x) for x in told]


def exact_end(told):
    """An end that is one number, or None where there is no end."""
    if told is None:
        return None
    lower, upper = ends(told)
    if lower != upper:
        raise ValueError(f"found the end [{lower}, {upper}], expected an exact one")
    return lower
