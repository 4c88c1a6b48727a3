"""Newton's method from random starts, in binary64, in every pattern of lift, stick and slip.

Forces of contacts that stick, and normal forces of those that slip, follow from linear equations, so that the angles of
the slips are left: one equation u_T x d = 0 for each. All starts of a pattern go at once. What converges, obeys the law
with margins and has a small residual is a solution; nothing is proved here, and nothing that the method misses is wrong.
"""
import itertools
from dataclasses import dataclass

import numpy as np

from families import into_cone

MARGIN = 1e-8  # of conditions, relative to the largest force or velocity
RESIDUAL = 1e-10


@dataclass
class Near:
    modes: tuple
    r: np.ndarray
    u: np.ndarray


@dataclass
class Floats:
    W: np.ndarray
    q: np.ndarray
    mu: np.ndarray

    @staticmethod
    def of(problem):
        return Floats(np.array(problem.W, dtype=float), np.array(problem.q, dtype=float), np.array(problem.mu, dtype=float))


def components(contacts, of=(0, 1, 2)):
    return np.array([3 * k + c for k in contacts for c in of], dtype=int)


class Pattern:
    """u_S = W r_S + q of the contacts that slip, and r = base + lever r_S of the others; dependent equations are solved
    with the least forces, and `open` has the directions in which forces are open."""

    def __init__(self, p, states):
        self.p, self.states = p, states
        self.slipping = [k for k, s in enumerate(states) if s == "slip"]
        self.linear = np.concatenate([components([k], (0, 1, 2) if s == "stick" else (0,)) for k, s in enumerate(states)
                                      if s in ("stick", "closed")] or [np.zeros(0, dtype=int)])
        S, L = components(self.slipping), self.linear
        self.S = S
        WLL = p.W[np.ix_(L, L)]
        left, sizes, right = np.linalg.svd(WLL) if L.size else (WLL, np.zeros(0), WLL)
        rank = int(np.sum(sizes > 1e-11 * max(sizes.max(initial=0), 1e-300)))
        inverse = right[:rank].T @ (left[:, :rank] / sizes[:rank]).T
        self.open = right[rank:].T
        self.base, self.lever = -inverse @ p.q[L], -inverse @ p.W[np.ix_(L, S)]
        self.W = p.W[np.ix_(S, S)] + p.W[np.ix_(S, L)] @ self.lever
        self.q = p.q[S] + p.W[np.ix_(S, L)] @ self.base
        self.mu = p.mu[self.slipping]
        k = len(self.slipping)
        self.N = self.W[::3].reshape(k, k, 3)  # rows of u_N
        self.T = np.delete(self.W, np.s_[::3], axis=0)  # rows of u_T

    def forces(self, slipping):
        r = np.zeros(len(self.p.q))
        r[self.S] = slipping
        r[self.linear] = self.base + self.lever @ slipping
        return r

    def state_at(self, angle):
        """Directions and what they turn to, r / r_N of the slips, the inverse of what normal forces do to u_N, and normal
        forces."""
        d = np.stack([np.cos(angle), np.sin(angle)], -1)
        turned = np.stack([-d[..., 1], d[..., 0]], -1)
        force = np.concatenate([np.ones(angle.shape + (1,)), -self.mu[:, None] * d], -1)
        inverse = np.linalg.inv((self.N * force[:, None]).sum(axis=-1))
        return d, turned, force, inverse, -inverse @ self.q[::3]

    def step(self, angle):
        d, turned, force, inverse, normal = self.state_at(angle)
        starts, k = angle.shape
        own = np.arange(k)
        slope = -self.mu[:, None] * turned * normal[..., None]  # of r_T at a normal force that is held
        dN = -inverse @ (self.N[..., 1:] * slope[:, None]).sum(axis=-1)
        dr = force[..., None] * dN[:, :, None, :]
        dr[:, own, 1:, own] += slope.swapaxes(0, 1)
        du = (self.T @ dr.reshape(starts, 3 * k, k)).reshape(starts, k, 2, k)
        u = (self.q.reshape(k, 3)[:, 1:].ravel() + (force * normal[..., None]).reshape(starts, -1) @ self.T.T).reshape(d.shape)
        value = d[..., 0] * u[..., 1] - d[..., 1] * u[..., 0]
        J = d[..., 0, None] * du[:, :, 1] - d[..., 1, None] * du[:, :, 0]
        J[:, own, own] += turned[..., 0] * u[..., 1] - turned[..., 1] * u[..., 0]
        return -np.linalg.solve(J, value[..., None])[..., 0]

    def angles(self, rng, starts, steps=20):
        """Where it converges."""
        angle, done = rng.uniform(-np.pi, np.pi, (starts, len(self.slipping))), []
        with np.errstate(all="ignore"):
            for _ in range(steps):
                try:
                    change = self.step(angle)
                except np.linalg.LinAlgError:
                    angle = angle + rng.normal(0, 1e-3, angle.shape)
                    continue
                change = np.nan_to_num(change, nan=1.0, posinf=1.0, neginf=-1.0)
                length = np.abs(change).max(axis=1)
                angle = angle + change * np.minimum(1, 1 / np.maximum(length, 1e-300))[:, None]
                done.append(angle[length < 1e-10])
                angle = angle[length >= 1e-10]
                if not angle.size:
                    break
        return different(np.concatenate(done)) if done else []

    def solutions(self, rng, starts):
        if not self.slipping:
            r = self.forces(np.zeros(0))
            points = [self.pressed(r) if self.open.size else r]
        elif self.open.size:
            return  # of a body that contacts hold along a line: in general it does not move
        else:
            points = [self.sliding_forces(angle) for angle in self.angles(rng, starts)]
        for r in points:
            u = self.p.W @ r + self.p.q
            if obeys_law(self.p, self.states, r, u):
                yield Near(self.states, r, u)

    def sliding_forces(self, angle):
        _, _, force, _, normal = self.state_at(angle[None])
        return self.forces((force[0] * normal[0][:, None]).reshape(-1))

    def pressed(self, r, rounds=1000):
        """Forces in the cones among those that the equations leave open, by Douglas and Rachford's reflections."""
        r, fixed = r.copy(), r[self.linear]
        x, least = r.copy(), 1e-5 * np.abs(fixed).max(initial=1e-300)
        closed = [k for k, s in enumerate(self.states) if s in ("stick", "closed")]
        for _ in range(rounds):
            inside = x.copy()
            for k in closed:
                inside[3 * k:3 * k + 3] = into_cone(x[3 * k:3 * k + 3], self.p.mu[k] * (1 - 1e-5), least)
            reflected = 2 * inside - x
            r[self.linear] = fixed + self.open @ (self.open.T @ (reflected[self.linear] - fixed))
            if all(is_in_cone(r[3 * k:3 * k + 3], self.p.mu[k] * (1 - 1e-6), least / 10) for k in closed):
                break
            x += r - inside
        return r


def different(angles):
    """Those of a list that differ by more than 1e-6; one may be there twice."""
    keys = np.round(np.c_[np.cos(angles), np.sin(angles)], 6)
    return angles[np.unique(keys, axis=0, return_index=True)[1]]


def is_in_cone(r, mu, least):
    return r[0] >= least and np.hypot(r[1], r[2]) <= mu * (r[0] - least)


def obeys_law(p, states, r, u):
    """With margins."""
    force = max(np.abs(r).max(), 1e-300)
    speed = max(np.abs(u).max(), np.abs(p.q).max(), 1e-300)
    residual, margin = 0.0, np.inf
    for k, state in enumerate(states):
        (n, x, y), (un, ux, uy), mu = r[3 * k:3 * k + 3], u[3 * k:3 * k + 3], p.mu[k]
        if state == "lift":
            margin = min(margin, un / speed)
            continue
        residual = max(residual, abs(un) / speed)
        margin = min(margin, n / force)
        if state == "stick":
            residual = max(residual, abs(ux) / speed, abs(uy) / speed)
            margin = min(margin, (mu * n - np.hypot(x, y)) / force)
        if state == "slip":
            v = np.hypot(ux, uy)
            margin = min(margin, v / speed)
            residual = max(residual, abs(x * v + mu * n * ux) / force / speed, abs(y * v + mu * n * uy) / force / speed)
    return bool(residual < RESIDUAL and margin > MARGIN)


def all_patterns(mu):
    return itertools.product(*(("lift", "stick", "slip") if m > 0 else ("lift", "closed") for m in mu))


def solutions_near(problem, rng, starts=500):
    """Different ones, by their velocities and modes."""
    p, result = Floats.of(problem), []
    for states in all_patterns(p.mu):
        for found in Pattern(p, states).solutions(rng, starts):
            scale = max(np.abs(found.u).max(), 1e-300)
            if not any(s.modes == states and np.abs(s.u - found.u).max() < 1e-7 * scale for s in result):
                result.append(found)
    return result
