"""bodies.py make|check|count PROGRAM CHECKER: the contact problems of the bodies in bodies.jsonl, and their certificates.

`make` writes examples/NAME.json, exact in binary64, and examples.contact, a certificate of all motions for each, found
by PROGRAM (slipproof). `check` finds mistakes: a body that cannot be built, a problem that is not the body's, motions
other than those of its line, a certificate that CHECKER (slipproof-check-contact) does not accept, or one about
another problem. A line with `at_least` has that many motions and no certificate, as others may be in patterns that stay
open; `count`, which takes a minute or two, finds them.

A line has the mass, the moments of inertia about the principal axes, a force at the centre of mass (and a moment), and
for each contact its point from the centre of mass, mu, and a quaternion of whole numbers that turns the principal axes
into normal and tangents; without it they are the principal axes. Components along a turned normal and tangents are in
units of the quaternion's square, so that no root occurs.
"""
import hashlib
import json
import pathlib
import subprocess
import sys
from fractions import Fraction

FOLDER = pathlib.Path(__file__).resolve().parent
CERTIFICATES = FOLDER / "examples.contact"


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def axes(quaternion):
    """Normal and tangents, each of the length w^2 + x^2 + y^2 + z^2."""
    w, x, y, z = map(Fraction, quaternion)
    return [[w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)],
            [2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)],
            [2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z]]


def problem(body):
    """u = W r + q, from the six accelerations of the body."""
    mass, inertia = Fraction(body["mass"]), [Fraction(j) for j in body["inertia"]]
    assert mass > 0 and all(j > 0 for j in inertia), f"{body['name']}: found no positive mass and inertia"
    assert 2 * max(inertia) < sum(inertia), f"{body['name']}: a moment of inertia is not below the sum of the others"
    rows = []  # of each velocity: the force and the moment that do its work
    for contact in body["contacts"]:
        point = [Fraction(x) for x in contact["point"]]
        rows += [axis + cross(point, axis) for axis in axes(contact.get("axes", [1, 0, 0, 0]))]
    load = [Fraction(x) for x in body["force"] + body.get("moment", ["0", "0", "0"])]
    mobility = [1 / mass] * 3 + [1 / j for j in inertia]
    product = lambda a, b: sum(x * y * m for x, y, m in zip(a, b, mobility))
    return {"W": [[product(a, b) for b in rows] for a in rows], "q": [product(a, load) for a in rows],
            "mu": [Fraction(contact["mu"]) for contact in body["contacts"]]}


def problem_of(body):
    return FOLDER / "examples" / f"{body['name']}.json"


def number(value):
    """As JSON has it: exactly, in binary64."""
    assert Fraction(float(value)) == value, f"{value} is not exact in binary64"
    return str(value) if value.denominator == 1 else repr(float(value))


def text(body):
    found = problem(body)
    row = lambda values: "[" + ", ".join(map(number, values)) + "]"
    matrix = ",\n  ".join(map(row, found["W"]))
    return (f'{{"title": "{body["name"].replace("-", " ")}", "dimension": 3,\n "W": [\n  {matrix}],\n'
            f' "q": {row(found["q"])},\n "mu": {row(found["mu"])}}}\n')


def name_of_problem(body):
    """SHA-256 of the canonical form (src/proofs/check_contact/FORMAT.md)."""
    found = problem(body)
    lines = ["slipproof-contact-problem 1", f"dimension 3 free 0 contacts {len(found['mu'])}",
             " ".join(["mu", *map(str, found["mu"])]), "matrix"]
    lines += [f"{i} {j} {x}" for i, row in enumerate(found["W"]) for j, x in enumerate(row) if x]
    lines.append(" ".join(["constant", *map(str, found["q"])]))
    return hashlib.sha256("".join(line + "\n" for line in lines).encode()).hexdigest()


def run(program, file, *options):
    ran = subprocess.run([program, "certify", file, "--all", "--refine", *options], capture_output=True, text=True)
    assert ran.returncode in (0, 1), ran.stderr
    return json.loads(ran.stdout.splitlines()[0])


def certify(program, file, *options):
    """The modes of all motions. If the forces of one are open, it is among `continua`."""
    answer = run(program, file, *options)
    assert "all" in answer, f"{file}: {answer.get('left_out')}"
    motions = answer["all"]["found"], answer["all"].get("continua", [])
    return sorted([motion["modes"][0] for motion in motions[0]] + [motion["mode"] for motion in motions[1]])


def make(body, program):
    file, certificate = problem_of(body), FOLDER / "one.contact"
    file.write_text(text(body), encoding="utf-8")
    if "motions" in body:
        certify(program, file, "--certificate", certificate)
        with open(CERTIFICATES, "a", encoding="utf-8") as certificates:
            certificates.write(certificate.read_text(encoding="utf-8"))
        certificate.unlink()


def check(body, program, accepted):
    file = problem_of(body)
    assert file.read_text(encoding="utf-8") == text(body), f"{file}: it is not the problem of its body"
    if "motions" not in body:
        return
    found = certify(program, file)
    assert found == sorted(body["motions"]), f"{file}: found {found}, expected {sorted(body['motions'])}"
    established = f"{len(found)} motions and no others" if len(found) > 1 else "one motion and no other"
    about = [line for line in accepted.splitlines() if line.endswith(name_of_problem(body))]
    assert len(about) == 1 and f" {established}," in about[0], f"{file}: found {about}, expected {established}"


def main(task, program, checker):
    with open(FOLDER / "bodies.jsonl", encoding="utf-8") as lines:
        bodies = [json.loads(line) for line in lines]
    if task == "count":
        for body in bodies:
            if "at_least" in body:
                told = run(program, problem_of(body))["all"]
                count = told["solutions"] + len(told.get("continua", []))
                assert count == body["at_least"], f"{body['name']}: {count}"
                print(f"{body['name']}: {count} motions and no others")
        return
    if task == "make":
        CERTIFICATES.unlink(missing_ok=True)
        for body in bodies:
            make(body, program)
    accepted = subprocess.run([checker, CERTIFICATES], capture_output=True, text=True).stdout
    for body in bodies:
        check(body, program, accepted)
    count = sum("motions" in body for body in bodies)
    last = accepted.splitlines()[-1]
    expected = f"s ACCEPTED {count} accepted, 0 rejected, 0 missing, 0 undecided, 0 unreadable"
    assert last == expected, f"found {last}, expected {expected}"
    print(f"{len(bodies)} bodies, {count} certificates: each has the motions of its line and no others")


if __name__ == "__main__":
    main(*sys.argv[1:])
