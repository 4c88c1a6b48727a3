"""Contact problems in numbers that are no binary64, and one matrix for many of them."""

import json
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import slipproof

W, Q = [[2, 1], [1, 2]], [-5, -6]
THIRDS = [Fraction(4, 3), Fraction(7, 3)]


def test_exact_answers_are_certified_without_any_error():
    for z in (THIRDS, ["4/3", "7/3"], [Fraction(4, 3), "7/3"]):
        verdict = slipproof.certify(W, Q, z, tolerance=0)
        assert verdict.verdict == "certified" and verdict.max_relative_error == "0"
    assert slipproof.certify(W, Q, [4 / 3, 7 / 3], tolerance=0).verdict == "inaccurate"  # no binary64 is 4/3


def test_a_decimal_a_text_and_a_float_are_what_they_say():
    tenth, solution = Decimal("0.1"), [Fraction(1, 10)]
    for q in ([-tenth], ["-0.1"], [Fraction(-1, 10)]):
        assert slipproof.certify([[1]], q, solution, tolerance=0).verdict == "certified"
        assert slipproof.certify([[1]], q, [0.1], tolerance=0).verdict == "inaccurate"
    assert slipproof.certify([[1]], [-0.1], [0.1], tolerance=0).verdict == "certified"
    assert slipproof.certify([["1", 0.1], [0, 1]], [-1, -1], [Fraction(1) - Fraction(0.1), 1], tolerance=0).certified
    large = 2**60 + 1
    assert slipproof.certify([[1]], [-large], [large], tolerance=0).certified
    assert slipproof.certify([[1]], [-large], [2**60], tolerance=0).verdict == "inaccurate"


def test_lines_with_fractions_get_the_programs_verdict(source, program):
    lines = (source / "cases/contact-problems/examples.jsonl").read_text().splitlines()
    told = program("certify", "cases/contact-problems/examples.jsonl", "--json", parse=False).splitlines()
    compared = 0
    for line, verdict in zip(map(json.loads, lines), map(json.loads, told), strict=True):
        if '"' not in json.dumps([line.get(k) for k in "WMqz"]) or "mode" in line:
            continue
        found = slipproof.certify(line.get("W", line.get("M")), line["q"], line["z"], line.get("mu"), w=line.get("w"))
        assert {**found.to_dict(), "record": 0} == {**verdict, "record": 0}
        compared += 1
    assert compared


def test_friction_is_exact_too():
    W3 = [[1, 0], [0, 1]]
    assert slipproof.certify(W3, [-3, 1], [3, -1], "1/3", dimension=2).verdict == "certified"
    assert slipproof.certify(W3, [-3, 1], [3, -1], [Fraction(1, 3)]).verdict == "certified"
    assert slipproof.certify(W3, [-3, 1], [3, -1], Decimal("0.3")).verdict == "wrong"
    assert slipproof.certify(W3, [-3, 1], [3, -1], "1/3", method="exact").certified


def test_where_binary64_is_needed_other_numbers_are_refused():
    assert slipproof.certify(W, Q, ["1.25", Fraction(19, 8)], method="enclosure").verdict == \
        slipproof.certify(W, Q, [1.25, 2.375], method="enclosure").verdict
    with pytest.raises(ValueError, match=r"z\[0\]: found 4/3, expected a float64 without rounding"):
        slipproof.certify(W, Q, THIRDS, method="enclosure")
    with pytest.raises(ValueError, match=r"q\[1\]: found 1/3, expected a float64"):
        slipproof.certify(np.eye(3), [-1, "1/3", 0], [1, 0, 0], 0.5)


@pytest.mark.parametrize("z, message", [
    (["1", "x"], r"z\[1\]: found 'x', expected a digit"), ([Fraction(1), None], r"z\[1\]: found NoneType, expected a number"),
    ([Fraction(1), float("nan")], r"z\[1\]: found nan, expected a finite number"),
    ([Fraction(1), 1j], r"z\[1\]: found complex, expected a number"), (["1", "3/0"], r"z\[1\]: found a zero denominator"),
    (["1", True], r"z\[1\]: found bool, expected a number"), (["1"], r"z: found shape \(1,\), expected \(2,\)"),
    ([["1", "2"]], r"z: found shape \(1, 2\), expected 1 dimension")])
def test_what_is_no_number_is_told_with_its_place(z, message):
    with pytest.raises((TypeError, ValueError), match=message):
        slipproof.certify(W, Q, z)


def test_one_matrix_and_one_friction_serve_many_problems():
    r = np.random.default_rng(5)
    B = r.integers(-3, 4, (4, 4)).astype(float)
    many_q, many_z = r.integers(-5, 6, (30, 4)).astype(float), r.integers(0, 3, (30, 4)).astype(float)
    common = B @ B.T + np.eye(4)
    for mu in (None, 0.5, [0.5, 0.25]):
        one = slipproof.certify(common, many_q, many_z, mu, dimension=None if mu is None else 2)
        all_given = slipproof.certify(np.array([common] * 30), many_q, many_z,
                                      None if mu is None else np.broadcast_to(mu, (30, 2)))
        assert one == all_given and len(one) == 30
        assert list(one.verdicts) == [v.verdict for v in one] and isinstance(one.verdicts, np.ndarray)
    exact = slipproof.certify(W, [Q, ["-4", "-5"]], [THIRDS, [1, 2]], tolerance=0)
    assert list(exact.verdicts) == ["certified", "certified"]
    with pytest.raises(ValueError, match=r"W: found shape \(3, 3\), expected \(2, 2, 2\)"):
        slipproof.certify(np.eye(3), [Q, Q], [Q, Q])
