"""Results as values: equal after a round trip, copied, iterated, and asked at other loads."""

import copy
import pickle
from fractions import Fraction

import numpy as np
import pytest

import slipproof

SCENE = "cases/ambiguous.toml"
LADDER = "cases/mechanisms/scenes/ladder.toml"
RECORD = dict(F=[3.27, 3.2], a=[3.0, np.nan], S2=[3.0] * 2, S3=[0.0] * 2, N2=[9.0] * 2, N3=[0.1] * 2)
W, Q, Z = [[2, 1], [1, 2]], [-5, -6], [4 / 3, 7 / 3]


def results():
    solution = slipproof.solve(SCENE)
    free = slipproof.solve("cases/city-bicycle.toml", F=None)
    yield from (solution, solution.scene, *solution.motions, *solution.rejected[:2], *solution.ranges)
    yield from (free, *free.cells, *free.cells[0].motions, free.cells[0].loads, free.cells[0].motions[0].a)
    yield from slipproof.solve("cases/mechanisms/scenes/three-axles.toml").continua
    yield from (slipproof.Mechanism.load("ladder"), slipproof.solve(LADDER))
    yield from (slipproof.certify(W, Q, Z), slipproof.certify(W, [Q, Q], [Z, [0, 0]]))
    yield slipproof.certify(W, Q, Z, method="enclosure")
    yield slipproof.certify_file("cases/contact-problems/pushed-block.json")
    yield slipproof.certify_file("cases/contact-problems/examples.jsonl")
    yield slipproof.certify_bicycles(RECORD, scene=SCENE)
    yield slipproof.consistent_modes(M=94, R=0.3, h=0.56, b2=0.34, b3=0.68, I1=0.01, I2=0.12, I3=0.2, r1=0.09, r2=0.036,
                                     L=0.17, J=15.7, f=0.8, g=9.81, F=np.array([300.0, 3000.0]))
    verified = slipproof.verify("proofs/block-on-incline/claims.toml", samples=20)
    yield from (verified, verified[0])
    yield from (slipproof.prove("x^2 >= 0"), slipproof.prove("x > 0"), slipproof.check("proofs/block-on-incline/claims.theorems"))
    yield from (slipproof.critical(SCENE), slipproof.search("painleve-rod", samples=5))
    yield slipproof.phase_diagram(SCENE, columns=4)
    yield slipproof.Body("b", mass=1)


def test_results_are_equal_after_a_round_trip_and_unequal_to_others():
    kept = list(results())
    assert {type(r).__name__ for r in kept} >= {"Solution", "Motion", "Verdict", "Verdicts", "BicycleVerdicts", "Cell", "Proof"}
    for result in kept:
        for again in (pickle.loads(pickle.dumps(result)), copy.copy(result), copy.deepcopy(result)):
            assert again == result and not again != result, result
            assert type(again) is type(result) and repr(again) == repr(result)
            if type(result).__hash__ is not None:
                assert hash(again) == hash(result)
        assert result != object() and result != "text"
    solutions = [r for r in kept if isinstance(r, slipproof.Solution)]
    assert len(set(solutions)) == len(solutions) == 3
    assert len({m for m in slipproof.solve(SCENE).motions}) == 3


def test_a_verdict_at_real_size_keeps_its_details():
    verdict = slipproof.certify(W, Q, Z, method="enclosure", refine=True)
    again = pickle.loads(pickle.dumps(pickle.loads(pickle.dumps(verdict))))
    assert again.words() == verdict.words() and again.refined() == verdict.refined() != None  # noqa: E711
    assert again.certificate() == verdict.certificate() and again.report() == verdict.report() and "<html" in again.report()
    some = slipproof.certify_file("cases/contact-problems/pushed-block.json")
    assert pickle.loads(pickle.dumps(some))[0].words() == some[0].words()


def test_records_answer_after_a_round_trip():
    found = slipproof.certify_bicycles(RECORD, scene=SCENE)
    again = pickle.loads(pickle.dumps(found))
    assert [v.to_dict() for v in again] == [v.to_dict() for v in found] and list(again.verdicts) == list(found.verdicts)
    assert found != slipproof.certify_bicycles({**RECORD, "a": [3.0, 3.0]}, scene=SCENE)


def test_solutions_motions_and_cells_are_iterable():
    solution = slipproof.solve(SCENE)
    assert list(solution) == list(solution.motions) and len(solution) == 3
    assert dict(solution.motions[0]) == dict(solution.motions[0].values)
    cell = slipproof.solve("cases/city-bicycle.toml", F=None).cells[0]
    assert list(cell) == list(cell.motions) and len(cell) == len(cell.motions)


@pytest.mark.parametrize("path", [SCENE, "cases/city-bicycle.toml", LADDER])
def test_a_solution_at_its_own_load_is_itself_and_at_others_that_of_its_cells(path):
    solution = slipproof.solve(path)
    assert solution.at(solution.load).motions == solution.motions
    symbol = solution.load_symbol
    free = solution.scene.replace(**{"P": None} if path == SCENE else {symbol: None}).solve()
    for load in (0, Fraction(7, 3), "1000", 0.1):
        there = solution.at(load)
        assert there == free.at(load) and there.load == Fraction(load)
        (cell,) = (c for c in free.cells if load in c.loads)
        found = sorted((m.modes, m.boundary_modes, {n: x(load) for n, x in m.values.items()}.get("N2")) for m in cell)
        assert found == sorted((m.modes, m.boundary_modes, m.values.get("N2")) for m in there)
    with pytest.raises(slipproof.InputError):
        solution.at("much")


def test_cells_and_loads_that_are_not_there_are_told():
    with pytest.raises(ValueError, match=r"found F = 327/100 in the scene, expected none for cells"):
        slipproof.solve(SCENE).cells  # noqa: B018
    rod = slipproof.solve("cases/mechanisms/scenes/painleve-rod.toml")
    with pytest.raises(ValueError, match="found a mechanism without a load, expected one with a load for cells"):
        rod.cells  # noqa: B018
    with pytest.raises(ValueError, match="load: found 5, expected none: the mechanism has no load"):
        rod.at(5)
