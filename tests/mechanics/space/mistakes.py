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


def said(program, file):
    """All messages, as one line; empty if there are none. Of a scene those about its numbers, too."""
    run = subprocess.run([program, "solve" if "scenes" in file.parts else "show", file], capture_output=True, text=True)
    words = " ".join((run.stderr + run.stdout if run.returncode else run.stderr or run.stdout).split())
    return words if run.returncode else words[words.find("warning: "):] if "warning: " in words else ""


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
        if messages := said(program, cases / f"{file}.toml"):
            wrong.append(f"{file}, unchanged: {messages}")
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(cases, Path(folder) / "cases")
        for row in rows:
            file = Path(folder) / "cases" / f"{row['file']}.toml"
            file.write_text(spoiled((cases / f"{row['file']}.toml").read_text(), row["change"]))
            messages = said(program, file)
            shutil.copy(cases / f"{row['file']}.toml", file)
            if not messages:
                missed.append(row["what"])
            if row["says"] not in messages or not row["says"] and messages:
                wrong.append(f"{row['what']}: expected {row['says']!r}, found {messages}")
    print(f"{len(rows) - len(missed)} of {len(rows)} mistakes are noticed" + "".join(f"\nnot noticed: {m}" for m in missed))
    if wrong or len(rows) < 60 or 20 * len(missed) > len(rows):
        sys.exit("\n".join(wrong) or "too few")


main()
