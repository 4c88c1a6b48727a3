#!/usr/bin/env python3
"""Mistakes in the shipped drawings in space, and in the numbers of their scenes: `slipproof show`, or `solve`, names at
least 95 % of them.

    mistakes.py SLIPPROOF CASES
"""
import shutil
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

HERE = Path(__file__).parent


def said(program, cases, name):
    """All messages on a file, as one line; empty if there are none. `show` tells those about a mechanism, `solve` those
    about the numbers of its scene, too."""
    scene = cases / f"{Path(name).name}.toml"
    for command, file in (("show", cases / f"{name}.toml"), ("solve", scene)):
        if command == "show" and file == scene:
            continue
        run = subprocess.run([program, command, file], capture_output=True, text=True)
        words = " ".join((run.stderr + run.stdout).split())
        if run.returncode or "warning: " in words:
            return words if run.returncode else words[words.find("warning: "):]
    return ""


def spoiled(text, changes):
    for old, new in zip(changes[::2], changes[1::2]):
        assert text.count(old) == 1, f"not there exactly once: {old}"
        text = text.replace(old, new)
    return text


def main():
    program, cases = sys.argv[1], Path(sys.argv[2])
    rows = tomllib.loads((HERE / "mistakes.toml").read_text())["case"]
    wrong, missed = [], []
    for file in sorted({row["file"] for row in rows}):
        if messages := said(program, cases, file):
            wrong.append(f"{file}, unchanged: {messages}")
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(cases, copies := Path(folder) / "cases")
        for row in rows:
            file = copies / f"{row['file']}.toml"
            file.write_text(spoiled((cases / f"{row['file']}.toml").read_text(), row["change"]))
            messages = said(program, copies, row["file"])
            shutil.copy(cases / f"{row['file']}.toml", file)
            if not messages:
                missed.append(row["what"])
            if row["says"] not in messages or not row["says"] and messages:
                wrong.append(f"{row['what']}: expected {row['says']!r}, found {messages}")
    print(f"{len(rows) - len(missed)} of {len(rows)} mistakes are noticed" + "".join(f"\nnot noticed: {m}" for m in missed))
    if wrong or len(rows) < 60 or 20 * len(missed) > len(rows):
        sys.exit("\n".join(wrong) or "too few")


main()
