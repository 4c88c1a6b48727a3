"""Verdicts: the program's, from arrays."""

import json
import pickle

import numpy as np
import pytest

import slipproof


def problems(source):
    for line in (source / "cases/contact-problems/examples.jsonl").read_text().splitlines():
        yield json.loads(line)


def test_every_example_gets_the_programs_verdict(source, program):
    lines = program("certify", "cases/contact-problems/examples.jsonl", "--json", parse=False).splitlines()
    compared = 0
    for problem, line in zip(problems(source), map(json.loads, lines), strict=True):
        numbers = [problem.get("W", problem.get("M")), problem["q"], problem["z"]]
        if any(isinstance(x, str) for part in numbers for row in part for x in (row if isinstance(row, list) else [row])):
            continue  # fractions, which no array of binary64 holds
        if "mode" in problem:
            continue  # of which arrays have none
        verdict = slipproof.certify(*numbers, problem.get("mu"), w=problem.get("w"))
        assert {**verdict.to_dict(), "record": 0} == {**line, "record": 0}
        compared += 1
    assert compared >= 5


def test_a_file_gets_the_programs_lines(program):
    for name, options in (("cases/contact-problems/examples.jsonl", {}),
                          ("cases/contact-problems/pushed-block.json", {}),
                          ("cases/solvers/plain-enumerator.csv", dict(ignore_unknown=True))):
        flags = ["--ignore-unknown"] if options else []
        lines = program("certify", name, "--json", *flags, parse=False).splitlines()
        found = slipproof.certify_file(name, **options)
        assert [v.to_dict() for v in found] == [json.loads(line) for line in lines]
        assert len(found) == len(lines) and found[-1] == list(found)[-1]


def lemke_cases(k, n, seed=3):
    r = np.random.default_rng(seed)
    B = r.integers(-3, 4, (k, n, n)).astype(float)
    W = np.einsum("kij,klj->kil", B, B) + 2 * np.eye(n)
    return W, r.integers(-5, 6, (k, n)).astype(float)


def enumerated(W, q):
    """All solutions of an LCP in floating point, by all 2^n modes."""
    n = len(q)
    for bits in range(2**n):
        active = [i for i in range(n) if bits >> i & 1]
        z = np.zeros(n)
        if active:
            z[active] = np.linalg.solve(W[np.ix_(active, active)], -q[active])
        if (z >= -1e-12).all() and (W @ z + q >= -1e-12).all():
            return z
    raise AssertionError("a positive definite LCP has a solution")


def test_a_batch_is_its_problems():
    W, q = lemke_cases(20, 3)
    z = np.array([enumerated(*problem) for problem in zip(W, q)])
    z[5] += 1
    z[6, 2] = np.nan
    found = slipproof.certify(W, q, z)
    assert isinstance(found, slipproof.Verdicts) and len(found) == 20
    for i in range(20):
        alone = slipproof.certify(W[i], q[i], z[i])
        assert found[i].verdict == alone.verdict == {5: "wrong", 6: "invalid"}.get(i, "certified")
    assert found.counts() == {"certified": 18, "wrong": 1, "invalid": 1}
    assert found[6].reason == "z[2]: found nan, expected a finite number"
    assert found[2:4][1] == found[3]


def gauss_seidel(W, q, mu, sweeps=400):
    """Forces in Coulomb's cones, contact by contact, with steps by the largest entry of each block."""
    z = np.zeros_like(q)
    for _ in range(sweeps):
        for c in range(len(mu)):
            i = slice(3 * c, 3 * c + 3)
            u = W[i] @ z + q[i]
            u[0] += mu[c] * np.hypot(u[1], u[2])
            r = z[i] - u / np.abs(W[i, i]).sum(1).max()
            size = np.hypot(r[1], r[2])
            if mu[c] * size <= -r[0]:
                r[:] = 0
            elif size > mu[c] * r[0]:
                normal = (r[0] + mu[c] * size) / (1 + mu[c] ** 2)
                r[1:] *= mu[c] * normal / size
                r[0] = normal
            z[i] = r
    return z


def in_space(k, contacts, seed=5):
    r = np.random.default_rng(seed)
    B = r.normal(size=(k, 3 * contacts, 3 * contacts))
    W = np.einsum("kij,klj->kil", B, B) + 3 * contacts * np.eye(3 * contacts)
    q = r.normal(size=(k, 3 * contacts))
    q[:, ::3] -= 1
    mu = r.uniform(0, 1, size=(k, contacts))
    return W, q, mu, np.array([gauss_seidel(*one) for one in zip(W, q, mu)])


def test_a_batch_in_space_is_its_problems():
    W, q, mu, z = in_space(24, 2)
    z[3] *= 1.01
    z[4, 0] = np.nan
    z[5] += 1
    singles = [slipproof.certify(*one, dimension=3) for one in zip(W, q, z, mu)]
    seen = []
    batch = slipproof.certify(W, q, z, mu, dimension=3, threads=2, progress=lambda done, every: seen.append((done, every)))
    plain = [{**v.to_dict(), "record": 0, "problem": ""} for v in singles]
    assert [{**v.to_dict(), "record": 0, "problem": ""} for v in batch] == plain
    assert list(batch.verdicts) == [v.verdict for v in singles] and [v.record for v in batch] == list(range(1, 25))
    assert batch.verdicts[4] == "invalid" and np.isnan(batch.backward_error[4]) and not batch.certified
    for i, verdict in enumerate(singles):
        assert ("rho" in verdict.details) != bool(np.isnan(batch.rho[i]))
        if "rho" in verdict.details:
            assert batch.rho[i] <= float(verdict.rho) <= batch.rho[i] * (1 + 1e-2)
    good = [i for i in range(24) if i not in (3, 4, 5)]
    assert slipproof.certify(W[good], q[good], z[good], mu[good], dimension=3).certified
    assert slipproof.certify(W, q, z, mu, dimension=3, threads=1) == batch and seen and seen[-1][1] == 24
    assert sum(batch.counts().values()) == 24 and pickle.loads(pickle.dumps(batch)) == batch
    found = slipproof.certify(W[:3], q[:3], mu=mu[:3], dimension=3, refine=True)
    assert found.certified and (found.rho < 1e-6).all()
    same = slipproof.certify(W[0], q[:6], np.tile(z[0], (6, 1)), 0.5, dimension=3)
    assert list(same.verdicts) == [slipproof.certify(W[0], q[i], z[0], 0.5, dimension=3).verdict for i in range(6)]
    with pytest.raises(slipproof.InputError, match="problem 2"):
        slipproof.certify(np.where(np.arange(24)[:, None, None] == 1, np.nan, W), q, z, mu, dimension=3)
    for wrong in (dict(W=W[:3]), dict(z=z[:3]), dict(mu=mu[:3])):
        with pytest.raises(ValueError, match=next(iter(wrong))):
            slipproof.certify(**{**dict(W=W, q=q, z=z, mu=mu), **wrong}, dimension=3)
    assert len(slipproof.certify(W[:0], q[:0], z[:0], mu[:0], dimension=3)) == 0


def test_bodies_in_a_batch():
    """A cube of mass 2 and side 2 on four feet, pushed by F: it stays, slides, or lifts."""
    feet = [(1, 1), (1, -1), (-1, 1), (-1, -1)]
    H = np.zeros((6, 12))
    for k, (x, y) in enumerate(feet):
        for t, d in enumerate(([0, 0, 1], [1, 0, 0], [0, 1, 0])):
            H[:3, 3 * k + t], H[3:, 3 * k + t] = d, np.cross([x, y, -1], d)
    M = np.diag([2, 2, 2, 1, 1, 1.0])
    f = np.array([[0, 0, -20, 0, 0, 0], [16, 0, -20, 0, -10, 0], [0, 0, 1, 0, 0, 0]], float)
    share = np.array([5, 0, 0] * 4, float)
    r = np.array([share, share - np.array([0, 2.5, 0] * 4), 0 * share])
    found = slipproof.certify_bodies(M, H, f, r, 0.5)
    assert found.certified and (found.backward_error < 1e-15).all() and (found.rho[found.rho == found.rho] < 1e-6).all()
    wrong = slipproof.certify_bodies(M, H, f, r * [[1.1], [1], [1]] + [[0], [0], [1]], 0.5, threads=1)
    assert list(wrong.verdicts[[0, 2]]) == ["wrong", "wrong"] and wrong[1].verdict == found[1].verdict
    v = np.array([[0, 0, 0, 0, 0, 0], [3, 0, 0, 0, 0, 0], [0, 0, 0.5, 0, 0, 0]])
    each = slipproof.certify_bodies(np.stack([M] * 3), np.stack([H] * 3), f, r, np.full((3, 4), 0.5), u=v @ H, v=v, w=0 * r)
    assert each.certified and list(each.verdicts) == list(found.verdicts)
    assert not slipproof.certify_bodies(M, H, f, r, 0.5, v=v + 1).certified
    assert slipproof.certify_bodies(M, H, f[2:], mu=0.5, refine=True).certified
    for name, value in (("M", M[:5]), ("H", H[:, :7]), ("r", r[:2]), ("mu", np.full((2, 4), 0.5)), ("v", v[:, :3]), ("r", None)):
        with pytest.raises(ValueError, match=name):
            slipproof.certify_bodies(**{**dict(M=M, H=H, f=f, r=r, mu=0.5), name: value})
    with pytest.raises(slipproof.InputError, match="problem 2"):
        slipproof.certify_bodies(M, H, np.where(np.arange(3)[:, None] == 1, np.inf, f), r, 0.5)


def test_all_solutions_in_space():
    W, q = [[1.25, 1, 0], [1, 5, 0], [0, 0, 5.0625]], [0.09375, 3.375, 2.09375]  # a leaning body
    found = slipproof.certify(W, q, mu=1.75, all=True)
    assert [s["modes"] for s in found.solutions] == [["lift"], ["stick"], ["slip"]]
    assert found.solutions[0]["w"] == ["3/32", "27/8", "67/32"]
    assert "all-solutions 3" in found.certificate()
    assert slipproof.certify(W, q, [0, 0, 0], mu=1.75, all=True).verdict == "ambiguous"
    assert slipproof.certify(W, q, [0, 0, 0], mu=0.25, all=True).verdict == "unique"
    with pytest.raises(AttributeError, match="no solutions"):
        slipproof.certify(W, q, [0, 0, 0], mu=0.25).solutions


def test_friction_in_the_plane_and_in_space():
    W = np.eye(2)
    assert slipproof.certify(W, [-9.81, 0.5], [9.81, -0.5], 0.3).verdict == "certified"
    assert slipproof.certify(W, [-9.81, 5], [9.81, -5], 0.3).verdict == "wrong"
    space = slipproof.certify(np.eye(3), [-9.81, 0.5, 0.5], [9.81, -0.5, -0.5], 0.3)
    assert space.verdict == "solution within rho" and space.certified and space.unique == "locally"
    assert slipproof.certify(np.eye(3), [-9.81, 0.5, 0.5], [9.81, -0.5, -0.5], [0.3]).verdict == space.verdict


def test_limits_and_motors_are_contacts():
    # A block of mass 1 on a floor is pushed by 5 to the right, against a limit, and by a motor that may exert b.
    rows = np.array([[0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0], [1, 0, 0], [0, 0, 0]], float)
    push = np.array([5, 0, -10])

    def verdict(mu_floor, b, r, with_limit=False):
        used = [0, 1, 2, *([3, 4, 5] if with_limit else []), 6, 7, 8]
        W, q, mu = rows[used] @ rows[used].T, rows[used] @ push, [mu_floor, *([0] if with_limit else []), b]
        W[-3, -3], W[-1, -1], q[-3] = 1, 1, -1
        return slipproof.certify(W, q, r, mu, dimension=3)

    held, given_way = verdict(0, 8, [10, 0, 0, 1, -5, 0]), verdict(0, 2, [10, 0, 0, 1, -2, 0])
    assert held.certified and given_way.certified
    assert not verdict(0, 8, [10, 0, 0, 1, -4, 0]).certified and not verdict(0, 2, [10, 0, 0, 1, -3, 0]).certified
    assert verdict(0.1, 2, [10, -1, 0, 1, -2, 0]).certified  # both rub
    assert verdict(0, 2, [10, 0, 0, 3, 0, 0, 1, -2, 0], with_limit=True).certified
    assert not verdict(0, 2, [10, 0, 0, 2, 0, 0, 1, -2, 0], with_limit=True).certified


def test_at_real_size_there_is_more_to_ask():
    W, q = lemke_cases(1, 80)
    found = slipproof.certify(W[0], q[0], refine=True)
    assert found.verdict in ("unique", "solution within rho", "eps-solution", "wrong")
    refined = found.refined()
    assert refined is not None
    again = slipproof.certify(W[0], q[0], refined["r"])
    assert again.verdict == "unique" and float(again.rho) < 1e-9
    assert again.certificate() and "<html" in again.report() and "solution" in again.words()


class Rows:
    """A sparse matrix as SciPy's, without SciPy."""

    def __init__(self, dense):
        self.shape = dense.shape
        self.indptr = np.concatenate([[0], np.cumsum((dense != 0).sum(axis=1))])
        self.indices = np.nonzero(dense)[1]
        self.data = dense[dense != 0]

    def tocsr(self):
        return self


def test_a_sparse_matrix_is_the_dense_one():
    W, q = lemke_cases(1, 12)
    W = np.where(abs(W[0]) > 8, W[0], 0)
    z = enumerated(W, q[0])
    dense = slipproof.certify(W, q[0], z, method="enclosure")
    assert slipproof.certify(Rows(W), q[0], z) == dense
    scipy_sparse = pytest.importorskip("scipy.sparse")
    for kind in ("csr_matrix", "csc_matrix", "coo_matrix", "lil_matrix"):
        assert slipproof.certify(getattr(scipy_sparse, kind)(W), q[0], z) == dense


def test_methods_are_what_they_are_called():
    W, q, z = np.array([[2.0, 1], [1, 2]]), [-5, -6], [4 / 3, 7 / 3]
    assert slipproof.certify(W, q, z, method="exact").verdict == "certified"
    assert slipproof.certify(W, q, z, method="enclosure").verdict == "unique"
    assert slipproof.certify(W, q, [1.3333, 2.3333], tolerance=1e-3).verdict == "certified"
    assert slipproof.certify(W, q, [1.3333, 2.3333]).verdict == "inaccurate"
    assert slipproof.certify(W, q, z, law="box").law == "box pyramid |t1| <= mu n, |t2| <= mu n"


def test_verdicts_in_notebooks_and_in_conditions():
    verdict = slipproof.certify([[1.0]], [-1.0], [1.0])
    assert verdict and "<table>" in verdict._repr_html_() and repr(verdict) == "<slipproof.Verdict certified>"
    with pytest.raises(AttributeError, match="this verdict has no rho; it has record, verdict"):
        verdict.rho  # noqa: B018
    assert not slipproof.certify([[1.0]], [-1.0], [2.0])


def test_each_law_is_one_that_solvers_claim():
    W, q, mu = np.eye(3), [-10, 6, 0], 0.5
    judged = lambda r, **law: slipproof.certify(W, q, r, mu, dimension=3, **law)
    assert judged([10, -5, 0]).verdict == "solution within rho"
    own = judged([10.4, -5.2, 0], law="associated")
    assert own.verdict == "unique" and own.certified and own.coulomb["verdict"] == "wrong"
    assert judged([10, -5, 0], law="associated").verdict == "wrong"
    assert judged([8.32, -4.16, 0], law="associated", compliance=0.25).verdict == "unique"
    assert judged([8.32, -4.16, 0], law="associated", compliance=[0.25] * 3, bias=0).verdict == "unique"
    assert judged([10, -2, 0], law="fixed", bounds=2).verdict == "unique"
    assert judged([10, -3, 0], law="regularised", slip_speed=4, function="soft").verdict == "eps-solution"
    assert judged([10, -5, 0], law="box").verdict == "solution within rho"
    assert judged([10.01, -5, 0]).verdict == "not converged"
    assert judged([12, -5, 0], refine=True, within=4).verdict == "not converged"
    assert judged([12, -5, 0], refine=True).verdict == "wrong"
    with pytest.raises(slipproof.InputError, match="bounds: found 0 numbers, expected 2"):
        judged([10, -2, 0], law="fixed")
    with pytest.raises(slipproof.InputError, match="compliance.*not negative"):
        judged([10, -2, 0], law="associated", compliance=-1)


def test_a_step_with_an_impact_is_judged_by_its_law_and_tells_its_energy():
    W, before = np.eye(2), [-2.0, 3.0]
    bounce = slipproof.Impact("newton", 0.5, before)
    assert slipproof.certify(W, before, [3, -1.5], 0.5, impact=bounce).verdict == "unique"
    assert slipproof.certify(W, before, [2, -1], 0.5, impact=bounce).verdict == "wrong"
    assert slipproof.certify(W, before, [3, -1.5], 0.5, impact=bounce).details["energy"]["work"] == -4.875
    many = slipproof.certify(W, [before] * 2, [[3, -1.5], [2, -1]], 0.5, impact=bounce._replace(before=[before] * 2), method="enclosure")
    assert list(many.verdicts) == ["unique", "wrong"]
    M, H = np.diag([3.0, 3.0, 25.0]), np.array([[0.0, 1], [1, 0], [-3, 4]])
    rod = slipproof.Impact("newton", 1, [[1.0, -2, 1]])
    found = slipproof.certify_bodies(M, H, [[3.0, -6, 25]], [[16.5, 3]], 1, dimension=2, impact=rod)
    assert found.certified and found[0].details["energy"] == {"before": 20, "work": 7.5, "gains": True}
    for wrong, message in ((("newton", 0.5, before), "Impact"), (slipproof.Impact("hertz", 0.5, before), "newton"),
                           (slipproof.Impact("newton", None, before), "restitution"),
                           (slipproof.Impact("newton", 2, before), "from 0 to 1"), (slipproof.Impact("newton", 1, [1]), "shape")):
        with pytest.raises((TypeError, ValueError), match=message):
            slipproof.certify(W, before, [3, -1.5], 0.5, impact=wrong)
