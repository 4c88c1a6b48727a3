"""Tests of the naive solver, each against the truth: python3 -m pytest -p slipproof.testing

Three of the five fail, one for each mistake; the messages say which contact breaks which law, and what would be right.
"""

import pytest
from solver import solve

IDENTITY = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]


def test_a_point_that_friction_holds(assert_certified):
    q, mu = [-10, 3, 4], [1.0]
    assert_certified(IDENTITY, q, solve(IDENTITY, q, mu, 3), mu, dimension=3)


def test_a_point_that_slides(assert_certified):
    q, mu = [-10, 6, 8], [0.5]
    assert_certified(IDENTITY, q, solve(IDENTITY, q, mu, 3), mu, dimension=3)


def test_a_point_that_leaves_the_floor(assert_certified):
    q, mu = [1, 3, 4], [0.5]
    assert_certified(IDENTITY, q, solve(IDENTITY, q, mu, 3), mu, dimension=3)


def test_two_points_with_few_sweeps(assert_certified):
    W = [[2, 0, -1, 0], [0, 2, 0, -1], [-1, 0, 2, 0], [0, -1, 0, 2]]
    q, mu = [-3, 5, -3, 1], [0.5, 0.5]
    assert_certified(W, q, solve(W, q, mu, 2, sweeps=3), mu, dimension=2)


def test_the_pyramid_is_not_the_cone(assert_certified):
    q, mu = [-10, 6, 8], [0.5]
    assert_certified(IDENTITY, q, solve(IDENTITY, q, mu, 3, friction="pyramid"), mu, dimension=3)
