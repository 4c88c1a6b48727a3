"""Claims, proofs, certificates, searches, pictures: the program's, byte for byte."""

from fractions import Fraction

import pytest

import slipproof

MEANS = """slipproof-statement 1
theorem means
real x y
assume positive: x > 0 and y > 0
show {} >= 2/(1/x + 1/y)
"""


def test_claims_get_the_programs_verdicts(program):
    path = "proofs/block-on-incline/claims.toml"
    found = slipproof.verify(path, samples=60, seed=5)
    assert found.to_json() == program("verify", path, "--samples", 60, "--seed", 5, "--json", parse=False)
    assert found.text() == program("verify", path, "--samples", 60, "--seed", 5, parse=False)
    assert found.summary in found.text().splitlines()[-1]
    some = found[0]
    assert found.find(some.id, some.reading) is some
    with pytest.raises(KeyError, match="found no claim A99"):
        found.find("A99")


def test_statements_are_proved_or_refuted(tmp_path):
    proof = slipproof.prove(MEANS.format("(x + y)/2"))
    assert proof.proved and proof.theorem == "means"
    false = slipproof.prove(MEANS.format("(x + y)/4"))
    x, y = false.counterexample["x"], false.counterexample["y"]
    assert false.verdict == "refuted" and not (x + y) / 4 >= 2 / (1 / x + 1 / y)
    (tmp_path / "means.statement").write_text(MEANS.format("(x + y)/2"))
    (tmp_path / "means.cert").write_text(proof.certificate)
    checked = slipproof.check(tmp_path)
    assert checked.accepted and checked[0].theorem == "means"
    (tmp_path / "means.cert").write_text(proof.certificate.replace("1", "2"))
    assert not slipproof.check(tmp_path).accepted
    assert slipproof.prove(tmp_path / "means.statement").certificate == proof.certificate


def test_a_search_is_the_programs(program):
    found = slipproof.search("painleve-rod", samples=30, seed=2)
    assert found.to_json() == program("search", "painleve-rod", "--samples", 30, "--seed", 2, "--json", parse=False)
    assert found.verdict == "found"
    narrowed = slipproof.Mechanism.load("painleve-rod").search(within="mu < 1/10", samples=20)
    assert narrowed.verdict == "none found"


@pytest.mark.parametrize("path, options, flags", [
    ("cases/city-bicycle.toml", dict(x="f", columns=12), ["--x", "f", "--columns", "12"]),
    ("cases/mechanisms/scenes/ladder.toml", dict(x="theta", columns=8, y_range=(0, "1000")),
     ["--x", "theta", "--columns", "8", "--y-range", "0", "1000"])])
def test_pictures_are_the_programs(program, path, options, flags):
    diagram = slipproof.phase_diagram(path, **options)
    assert diagram.svg == program("map", path, *flags, parse=False)
    assert diagram.to_json() == program("map", path, *flags, "--json", parse=False)
    bands = diagram.bands()
    assert bands and all(low < high for some in bands.values() for _, low, high in some)


@pytest.mark.parametrize("path, x, every_q", [
    ("cases/ambiguous.toml", "", "not unique"), ("cases/ambiguous.toml", "h", "not unique"),
    ("cases/touring-bicycle.toml", "", "unique"), ("cases/mechanisms/scenes/ladder.toml", "", "at most one"),
    ("cases/mechanisms/scenes/block-on-incline.toml", "", None)])
def test_critical_values_are_the_programs(program, path, x, every_q):
    found = slipproof.critical(path, x=x)
    flags = ["--x", x] if x else []
    assert found.text() == program("critical", path, *flags, parse=False)
    assert found.to_json() == program("critical", path, *flags, "--json", parse=False)
    assert found.every_q == every_q
    at_own = slipproof.solve(path).to_dict()["every_q"]
    assert (at_own and at_own["verdict"]) == every_q


def test_critical_values_are_fractions():
    found = slipproof.critical(slipproof.Scene.load("cases/ambiguous.toml"))
    assert (found.parameter, found.value, found.critical, found.one_motion) == ("f", 1, Fraction(21, 25), False)
    assert slipproof.critical("cases/mechanisms/scenes/ladder.toml").critical is None
    assert slipproof.critical("cases/touring-bicycle.toml").one_motion


def test_a_diagram_is_drawn_into_axes():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib.figure import Figure

    ax = Figure().subplots()
    diagram = slipproof.phase_diagram("cases/city-bicycle.toml", x="f", columns=6, ax=ax)
    assert ax.get_xlabel() == "f" and ax.get_ylabel() == "F"
    assert {t.get_text() for t in ax.get_legend().get_texts()} == set(diagram.bands())


def test_progress_is_told_and_may_end_the_call():
    told = []
    slipproof.verify("proofs/block-on-incline/claims.toml", samples=200, progress=lambda *at: told.append(at))
    assert told[-1][0] == told[-1][1] and told == sorted(told)

    class Enough(Exception):
        pass

    def enough(done, all):
        raise Enough

    with pytest.raises(Enough):
        slipproof.verify("proofs/rozenblat-yashin/claims.toml", samples=3000, progress=enough)
