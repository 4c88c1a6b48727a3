"""Projected Gauss-Seidel: contact by contact, r <- the nearest force in the cone to r - rho (u + mu |u_T| e_N), as De Saxce
writes Coulomb's law. Many starts go at once, in binary64."""
import numpy as np

from newton import Floats, Near

RESIDUAL = 1e-12


def into_cones(r, mu):
    """The nearest points of cones, r of shape (starts, 3)."""
    normal, tangent = r[:, 0], np.hypot(r[:, 1], r[:, 2])
    height = np.maximum((normal + mu * tangent) / (1 + mu * mu), 0)
    inside = tangent <= mu * normal
    scale = np.where(inside, 1, mu * height / np.where(tangent > 0, tangent, 1))
    return np.stack([np.where(inside, normal, height), r[:, 1] * scale, r[:, 2] * scale], axis=1)


def steps_of(p):
    """1 over what a force at a contact does there; for contacts that nothing moves any."""
    sizes = [np.linalg.norm(p.W[3 * k:3 * k + 3, 3 * k:3 * k + 3], 2) for k in range(len(p.mu))]
    return [1 / s if s > 0 else 1.0 for s in sizes]


def change(p, rho, r, k):
    u = r @ p.W[3 * k:3 * k + 3].T + p.q[3 * k:3 * k + 3]
    own = r[:, 3 * k:3 * k + 3]
    towards = u.copy()
    towards[:, 0] += p.mu[k] * np.hypot(u[:, 1], u[:, 2])
    return into_cones(own - rho * towards, p.mu[k]) - own


def solutions_near(problem, rng, starts=20, sweeps=800):
    p = Floats.of(problem)
    rho, size = steps_of(p), max(np.abs(p.q).max(), 1e-3)
    r = rng.normal(0, 1, (starts, len(p.q))) * size * rng.choice([0, 1, 10], (starts, 1))
    with np.errstate(all="ignore"):
        for _ in range(sweeps):
            most = np.zeros(starts)
            for k in range(len(p.mu)):
                step = change(p, rho[k], r, k)
                r[:, 3 * k:3 * k + 3] += step
                most = np.maximum(most, np.abs(step).max(axis=1))
            r[~(np.abs(r).max(axis=1) < 1e12)] = 0
            if np.all(most <= 1e-16 * np.abs(r).max(axis=1)):
                break
        left = np.max([np.abs(change(p, rho[k], r, k)).max(axis=1) for k in range(len(p.mu))], axis=0)
    result = []
    for at, rest in zip(r, left):
        u = p.W @ at + p.q
        if rest <= RESIDUAL * max(np.abs(at).max(), 1e-3):
            if not any(np.abs(u - s.u).max() <= 1e-7 * max(np.abs(u).max(), size) for s in result):
                result.append(Near(("projected",) * len(p.mu), at, u))
    return result
