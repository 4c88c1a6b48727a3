"""draw.py: writes loads.svg, the loads that leave the body of the page's table each of its seven sets of motions.

Rows of the picture are cut where the set changes, by bisection in floating point.
"""
import cmath
import json
import math
import pathlib

import bodies

STEPS, ROWS = 150, 200
NAMES = {"1": "slips", "s": "sticks", "S": "sticks, or slips in two ways", "3": "slips in three ways",
         "o": "lifts", "O": "lifts, or slips in two ways", "7": "lifts, sticks or slips"}
COLOURS = {"1": "#f4f1ea", "s": "#9fc5b3", "S": "#e0a458", "3": "#b5493b", "o": "#eef2f7", "O": "#8fa8cf", "7": "#5b4a8a"}


def roots(coefficients):
    """Of a quartic, from the highest coefficient down, by Durand and Kerner."""
    p = [c / coefficients[0] for c in coefficients]
    z = [(0.4 + 0.9j) ** i for i in range(4)]
    for _ in range(200):
        for i in range(4):
            value = (((z[i] + p[1]) * z[i] + p[2]) * z[i] + p[3]) * z[i] + p[4]
            z[i] -= value / math.prod(z[i] - z[j] for j in range(4) if j != i)
    return z


def set_of(w, m, mu, q):
    """A letter of NAMES."""
    first = lambda i, x, y: w[i][0] - mu * (w[i][1] * x + w[i][2] * y)
    f = lambda x, y: -q[0] * (x * first(2, x, y) - y * first(1, x, y)) + first(0, x, y) * (x * q[2] - y * q[1])
    samples = [f(math.cos(k * math.pi / 4), math.sin(k * math.pi / 4)) for k in range(8)]
    slips = 0
    for z in roots([sum(s * cmath.exp(-1j * k * n * math.pi / 4) for k, s in enumerate(samples)) for n in (2, 1, 0, -1, -2)]):
        x, y = z.real / abs(z), z.imag / abs(z)
        force = -q[0] / first(0, x, y)
        speed = (force * first(1, x, y) + q[1]) * x + (force * first(2, x, y) + q[2]) * y
        slips += abs(abs(z) - 1) < 1e-6 and force > 0 and speed > 0
    p = [-sum(a * b for a, b in zip(row, q)) for row in m]
    sticks, lifts = math.hypot(p[1], p[2]) < mu * p[0], q[0] > 0
    return "7" if lifts and sticks else ("oO" if lifts else "sS" if sticks else "13")[slips > 1]


def inverse(w):
    minor = lambda i, j: w[i - 2][j - 2] * w[i - 1][j - 1] - w[i - 2][j - 1] * w[i - 1][j - 2]
    det = sum(w[0][j] * minor(0, j) for j in range(3))
    return [[minor(j, i) / det for j in range(3)] for i in range(3)]


def regions(at, left, right, low, high):
    """Of each letter but the background: its runs, (y, from, to), one a row."""
    found = {}
    for row in range(ROWS + 1):
        y = low + (high - low) * row / ROWS
        xs = [left + (right - left) * i / STEPS for i in range(STEPS + 1)]
        letters, start = [at(x, y) for x in xs], left
        for i in range(STEPS + 1):
            if i < STEPS and letters[i] == letters[i + 1]:
                continue
            end = right
            if i < STEPS:
                a, b = xs[i], xs[i + 1]
                for _ in range(12):
                    a, b = ((a + b) / 2, b) if at((a + b) / 2, y) == letters[i] else (a, (a + b) / 2)
                end = a
            if letters[i] not in "1o":
                found.setdefault(letters[i], []).append((y, start, end))
            start = end
    return found


def main():
    with open(bodies.FOLDER / "bodies.jsonl", encoding="utf-8") as lines:
        table = [json.loads(line) for line in lines][:7]
    w = [[float(x) for x in row] for row in bodies.problem(table[0])["W"]]
    m, mu = inverse(w), float(table[0]["contacts"][0]["mu"])
    loads = [[int(x) for x in body["force"]] for body in table]
    left, right, low, high, scale, shift = -24, 96, -30, 18, 3.1, 396
    text = ['<svg xmlns="http://www.w3.org/2000/svg" role="img" aria-labelledby="title description" viewBox="0 0 790 250" '
            'font-family="system-ui, sans-serif" font-size="11">',
            '<title id="title">Seven sets of motions of one body on one contact</title>',
            '<desc id="description">Two planes of loads, pressed and lifted, cut into the regions of the seven sets; '
            'circles are the loads of the table.</desc>', '<rect width="790" height="250" fill="#fff"/>']
    for panel, (normal, background, title) in enumerate(((-1, "1", "pressed with 1"), (1, "o", "lifted with 1"))):
        px, py = lambda x: 10 + panel * shift + (x - left) * scale, lambda y: 26 + (high - y) * scale
        text.append(f'<text x="{px(left):.0f}" y="16">{title}, and pushed along the tangents by</text>')
        text.append(f'<rect x="{px(left):.1f}" y="{py(high):.1f}" width="{(right - left) * scale:.1f}" '
                    f'height="{(high - low) * scale:.1f}" fill="{COLOURS[background]}" stroke="#999" stroke-width="0.5"/>')
        found = regions(lambda x, y: set_of(w, m, mu, (normal, x, y)), left, right, low, high)
        for letter, runs in sorted(found.items()):
            assert len({y for y, _, _ in runs}) == len(runs), f"{letter}: a row has two runs"
            outline = [(a, y) for y, a, _ in runs] + [(b, y) for y, _, b in reversed(runs)]
            points = " ".join(f"{px(x):.1f},{py(y):.1f}" for x, y in outline)
            text.append(f'<polygon points="{points}" fill="{COLOURS[letter]}"/>')
        text.append(f'<path d="M{px(left):.1f} {py(0):.1f}H{px(right):.1f}M{px(0):.1f} {py(high):.1f}V{py(low):.1f}" '
                    'stroke="#777" stroke-width="0.4" fill="none"/>')
        text += [f'<text x="{px(x):.0f}" y="{py(low) + 13:.0f}" text-anchor="middle">{x}</text>' for x in range(0, 91, 30)]
        text += [f'<text x="{px(left) + 3:.0f}" y="{py(y) + 4:.0f}">{y}</text>' for y in (-20, 0, 10)]
        text += [f'<circle cx="{px(x):.1f}" cy="{py(y):.1f}" r="2.4" fill="#fff" stroke="#000"/>'
                 for n, x, y in loads if n == normal]
    for i, (letter, name) in enumerate(NAMES.items()):
        x, y = 10 + (i % 4) * 195, 206 + (i // 4) * 20
        text.append(f'<rect x="{x}" y="{y}" width="12" height="12" fill="{COLOURS[letter]}" stroke="#999" stroke-width="0.5"/>'
                    f'<text x="{x + 18}" y="{y + 10}">{name}</text>')
    (bodies.FOLDER / "loads.svg").write_text("\n".join(text) + "\n</svg>\n", encoding="utf-8")


if __name__ == "__main__":
    main()
