"""Assertions for tests of solvers: what they accept, and what their messages say."""

import os
import subprocess
import sys
from fractions import Fraction

import pytest

import slipproof
from slipproof.testing import assert_certified, assert_motion

W, q, mu = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], [-10, 6, 0], 0.5


def message(call):
    with pytest.raises(AssertionError) as error:
        call()
    return str(error.value)


def test_right_answers_pass():
    assert assert_certified(W, q, [10, -5, 0], mu, dimension=3).verdict == "solution within rho"
    assert assert_certified(W, q, [10.4, -5.2, 0], mu, dimension=3, law="associated").verdict == "unique"
    assert assert_certified([[1, 2], [2, 1]], [-1, -1], [1, 0]).verdict == "ambiguous"
    assert assert_certified([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [-10, 6, 6], [10, -2.5, -2.5], 0.5, dimension=3,
                            law="diamond").verdict == "eps-solution"
    assert assert_certified(W, q, [10.001, -5, 0], mu, dimension=3, tolerance=1e-2)


def test_wrong_answers_say_what_is_broken_and_what_is_right():
    text = message(lambda: assert_certified(W, q, [10, -4, 0], mu, dimension=3))
    assert "the answer is wrong" in text
    assert "contact 1 violates |r_t| = mu r_n where the contact slides by 1.00e+00" in text
    assert "a solution, to all digits: z = [10.0, -5.0, 0.0]" in text
    text = message(lambda: assert_certified([[2, 1], [1, 2]], [-5, -6], [1, 2]))
    assert "contact 1 violates w = 0 where z > 0 by 1.00e+00" in text and "z = [4/3, 7/3]" in text
    text = message(lambda: assert_certified([[1, 2], [2, 1]], [-1, -1], [1, 0], only=True))
    assert "ambiguous" in text and "z = [1/3, 1/3]" in text
    assert "z[0]: found nan" in message(lambda: assert_certified([[2, 1], [1, 2]], [-5, -6], [float("nan"), 2]))


def test_only_asks_for_a_proof_that_there_is_no_other_solution():
    text = message(lambda: assert_certified(W, q, [10, -5, 0], mu, dimension=3, only=True))
    assert text.startswith("the answer is solution within rho") and "other solutions are not excluded" in text
    coupled, push = [[6, 2, -2], [2, 9, -8], [-2, -8, 9]], [0, 1, -2]
    assert assert_certified(coupled, push, [0, 0, 0], 3, dimension=3).verdict == "ambiguous"
    text = message(lambda: assert_certified(coupled, push, [0, 0, 0], 3, dimension=3, only=True))
    assert "the answer is ambiguous" in text and "another solution: z = [" in text
    assert assert_certified(W, q, [10.4, -5.2, 0], mu, dimension=3, law="associated", only=True).only
    assert assert_certified([[2, 1], [1, 2]], [-5, -6], [4 / 3, 7 / 3], only=True).only


def test_motions_by_their_numbers():
    motion = slipproof.solve("cases/city-bicycle.toml").motions[0]
    assert assert_motion("cases/city-bicycle.toml", {"a": motion.a}).modes == motion.modes
    assert assert_motion(slipproof.solve("cases/city-bicycle.toml"), {"a": float(motion.a), "N2": float(motion.N2)})
    text = message(lambda: assert_motion("cases/city-bicycle.toml", {"a": motion.a + Fraction(1, 100)}))
    assert f"expected {motion.a}" in text
    assert assert_motion("cases/ambiguous.toml", {"a": Fraction(327, 110)}).modes == ("stick/stick",)
    text = message(lambda: assert_motion("cases/ambiguous.toml", {"a": Fraction(327, 110)}, only=True))
    assert "has 3 motions, and the answer is one of them" in text
    assert "stick/lift: a = 79461/25520" in message(lambda: assert_motion("cases/ambiguous.toml", {"a": 0}))
    assert "a = nan" in message(lambda: assert_motion("cases/ambiguous.toml", {"a": float("nan")}))
    with pytest.raises(ValueError, match="found b, expected one of"):
        assert_motion("cases/city-bicycle.toml", {"b": 1})


def test_the_example_finds_all_mistakes_of_a_naive_solver(source):
    folder = source / "cases/examples/naive-solver"
    done = subprocess.run([sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-p", "slipproof.testing", str(folder)],
                          cwd=folder, capture_output=True, text=True, check=False,
                          env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
    assert "3 failed, 2 passed" in done.stdout, done.stdout + done.stderr
    for mistake in ("r = 0 where the contact opens by 4.00e+00", "z = [3, -3/2, 3, -5/4]", "|r_t| = mu r_n where the contact slides"):
        assert mistake in done.stdout
