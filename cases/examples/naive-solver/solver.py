"""A naive solver of contact problems u = W r + q, as many engines begin: sweeps over the contacts."""


def solve(W, q, mu, dimension, sweeps=50, friction="cone"):
    """Impulses r of each contact, the normal part first. Three mistakes are in it; the tests find them."""
    n = len(q)
    r = [0.0] * n
    for _ in range(sweeps):
        for first in range(0, n, dimension):
            # Mistake 1: the bound is that of the last sweep's normal impulse, and after the first sweep it is not updated
            # before friction is limited.
            bound = mu[first // dimension] * r[first]
            for i in range(first, first + dimension):
                u = q[i] + sum(W[i][j] * r[j] for j in range(n))
                r[i] -= u / W[i][i]
            r[first] = max(r[first], 0.0)
            tangential = r[first + 1:first + dimension]
            if friction == "cone":
                length = sum(t * t for t in tangential) ** 0.5
                # Mistake 2: where the contact opens, bound is 0 and length may be, too: what is left of friction stays.
                if length > bound > 0:
                    tangential = [t * bound / length for t in tangential]
            else:
                # Mistake 3: each direction for itself is a pyramid, whatever the caller meant by friction.
                tangential = [max(-bound, min(bound, t)) for t in tangential]
            r[first + 1:first + dimension] = tangential
    return r
