"""Degenerate problems: whatever any method finds is told, where all is told."""
import numpy as np

import newton
import projections
from compare import has_forces, has_velocities, is_near
from elimination import all_solutions, linear_solutions


def obeys_law(problem, r, u):
    """Coulomb's law, exactly."""
    if problem.velocities(r) != u:
        return False
    for k, mu in enumerate(problem.mu):
        (n, x, y), (un, ux, uy) = r[3 * k:3 * k + 3], u[3 * k:3 * k + 3]
        limit, speed = (mu * n)**2, ux * ux + uy * uy
        opposite = x * ux <= 0 and y * uy <= 0 and limit * ux * ux == x * x * speed and limit * uy * uy == y * y * speed
        if n < 0 or un < 0 or n * un != 0 or x * x + y * y > limit or not opposite:
            return False
    return True


class Degenerate:
    """Exact solutions: a planted one, and those of elimination. Others: by Newton, and by projected Gauss-Seidel."""

    most_contacts = 3  # for patterns in which contacts slip

    def __init__(self, seed):
        self.rng = np.random.default_rng(seed)

    def find(self, problem, count):
        small = problem.contacts <= self.most_contacts
        exact = []
        if problem.planted:
            assert obeys_law(problem, *problem.planted)
            exact.append(("a planted solution", *problem.planted))
        solutions, undecided = (all_solutions if small else linear_solutions)(problem)
        exact += [("/".join(s.modes), s.r, s.u) for s in solutions]
        by_newton = newton.solutions_near(problem, self.rng, 100) if small else []
        by_projection = projections.solutions_near(problem, self.rng)
        for how, number in (("planted", len(exact) - len(solutions)), ("elimination", len(solutions)),
                            ("Newton", len(by_newton)), ("projections", len(by_projection))):
            count[f"solutions found here: by {how}"] += number
        count["patterns not decided here"] += len(undecided)
        return exact, by_newton + by_projection

    def differences(self, problem, found, told):
        exact, near = found
        for how, _, u in exact:
            if not any(has_velocities(t, u) for t in told.solutions):
                yield f"{how} with u = {[float(x) for x in u]} is not told"
        for s in near:
            if not any(is_near(problem, t, s) for t in told.solutions):
                yield f"{'/'.join(s.modes)} with u = {s.u.tolist()}, r = {s.r.tolist()} is not told"

    def also_count(self, found, told, count):
        """Velocities that are told with one choice of forces, as if there were no other."""
        for t in told.solutions:
            forces = [r for _, r, u in found[0] if t.parameters == 0 and has_velocities(t, u)]
            if any(not has_forces(t, r) for r in forces):
                count["told without a family, and other forces were found here"] += 1

    def number(self, found):
        return len(found[0]) + len(found[1])
