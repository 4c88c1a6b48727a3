"""Claims, proofs, certificates, searches, pictures: the program's, byte for byte."""

import tomllib
from fractions import Fraction

import pytest

import slipproof
from slipproof._html import COLOURS

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
    rod = "proofs/impacts/rod-moreau.toml"
    gain = slipproof.search(rod, law="newton", wanted="gain", samples=20)
    assert gain.to_json() == program("search", rod, "--law", "newton", "--for", "gain", "--samples", 20, "--json", parse=False)


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


def test_a_formula_is_proved_or_refuted_for_all_numbers():
    proof = slipproof.prove("x^2 + y^2 >= 2*x*y")
    assert proof.proved and proof.statement.endswith("real x y\nshow x^2 + y^2 >= 2*x*y\n")
    false = slipproof.prove("x^2 + y^2 >= 3*x*y")
    x, y = false.counterexample["x"], false.counterexample["y"]
    assert false.verdict == "refuted" and x**2 + y**2 < 3 * x * y
    assert slipproof.prove("2 + 2 = 4").proved and slipproof.prove("x^2 >= 0 and x^2 + 1 > 0 or false").proved


def test_the_certificate_of_a_formula_is_one(tmp_path):
    proof = slipproof.prove("x^2 + y^2 + z^2 >= x*y + y*z + z*x")
    (tmp_path / "formula.statement").write_text(proof.statement)
    (tmp_path / "formula.cert").write_text(proof.certificate)
    assert slipproof.check(tmp_path).accepted
    (tmp_path / "formula.statement").write_text(proof.statement.replace("x*y", "2*x*y"))
    assert not slipproof.check(tmp_path).accepted


def test_claims_from_a_text_and_a_dict_get_the_files_verdicts(source, monkeypatch):
    folder = source / "proofs/block-on-incline"
    by_file = slipproof.verify(folder / "claims.toml", samples=30)
    text = (folder / "claims.toml").read_text()
    monkeypatch.chdir(folder)  # from which a text counts its paths
    by_text, by_dict = slipproof.verify(text, samples=30), slipproof.verify(tomllib.loads(text), samples=30)
    assert [(c.id, c.reading) for c in by_text] == [(c.id, c.reading) for c in by_file]
    assert [c.verdict for c in by_text] == [c.verdict for c in by_dict]
    # Without certificates a claim that is proved is one that was not refuted.
    assert all(a.verdict == b.verdict or (b.verdict == "proved") for a, b in zip(by_text, by_file))
    table = tomllib.loads(text)
    table["setting"][0]["colour"] = "red"
    with pytest.raises(slipproof.InputError, match="setting.*colour"):
        slipproof.verify(table)


def luminances(colour, kind):
    """A colour as seen by an eye without one kind of cones, in linear RGB; matrices of Machado et al. (2009)."""
    matrices = {"usual": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
                "protan": ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216), (-0.003882, -0.048116, 1.051998)),
                "deutan": ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413), (-0.011820, 0.042940, 0.968881)),
                "tritan": ((1.255528, -0.076749, -0.178779), (-0.078411, 0.930809, 0.147602), (0.004733, 0.691367, 0.303900))}
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in colour[:3]]
    seen = [sum(m * x for m, x in zip(row, linear)) for row in matrices[kind]]
    clipped = [min(max(x, 0), 1) for x in seen]
    return [12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055 for x in clipped]


def test_regions_differ_also_for_colour_blind_readers():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib.figure import Figure

    diagram = slipproof.phase_diagram("cases/ambiguous.toml", x="f", columns=60)
    ax = Figure().subplots()
    diagram.draw(ax)
    looks = [(c.patches[0].get_facecolor(), c.patches[0].get_hatch()) for c in ax.containers]
    assert len(looks) == len(diagram.bands()) >= 3 and len(set(looks)) == len(looks)
    colours = {matplotlib.colors.to_rgba(c) for c in COLOURS}
    assert {c for c, _ in looks} <= colours and len(colours) == 7
    for kind in ("usual", "protan", "deutan", "tritan"):
        seen = [luminances(c, kind) for c in colours]
        nearest = min(sum((a - b) ** 2 for a, b in zip(x, y)) ** 0.5 for i, x in enumerate(seen) for y in seen[:i])
        assert nearest > 0.1, (kind, nearest)
