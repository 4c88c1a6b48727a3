"""front.py PAGE NAME=TEXT...: makes the front page of PAGE, the explorer with a scene: front.html says what stands around it.

Each @NAME@ of front.html becomes its text.
"""
import html
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
TITLE = "slipproof: exact, provable answers about dry friction"


def read(name):
    with open(os.path.join(HERE, name), encoding="utf-8") as file:
        return file.read()


def parts(given):
    """The parts of front.html by their names."""
    text = read("front.html")
    for name, value in given.items():
        text = text.replace(f"@{name}@", html.escape(value))
    pieces = re.split(r"<!-- ([A-Z]+)\b.*?-->\n", text)
    return dict(zip(pieces[1::2], pieces[2::2]))


def main(page, *given):
    part = parts(dict(argument.split("=", 1) for argument in given))
    with open(page, encoding="utf-8") as file:
        text = file.read()
    for old, new in [
            ("<title>Explorer</title>", f'<link rel="icon" href="data:,">\n<title>{TITLE}</title>'),
            ("</style>", read("front.css") + "</style>"),
            ("<body>\n", "<body data-front>\n" + part["TOP"]),
            ("</header>", part["LEAD"] + "</header>"),
            ("</main>", part["MORE"] + "</main>")]:
        if old not in text:
            sys.exit(f"{page}: found no {old}, expected the explorer's page")
        text = text.replace(old, new, 1)
    with open(page, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main(*sys.argv[1:])
