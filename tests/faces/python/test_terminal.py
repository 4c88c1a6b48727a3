"""The program on a terminal: progress with the time left, and Ctrl-C, which says how to go on."""

import json
import os
import pty
import re
import select
import shlex
import signal
import subprocess
import time

import pytest
from conftest import PROGRAM, SOURCE

LONG = 60


class Terminal:
    """A program whose standard error, and if asked for its output, is a terminal."""

    def __init__(self, *arguments, output_too=False, folder=SOURCE, **options):
        controller, terminal = pty.openpty()
        alone = {name: value for name, value in os.environ.items() if name != "LD_PRELOAD"}
        self.controller, self.seen = controller, ""
        self.output = None if output_too else open(folder / "output", "wb")
        self.process = subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=folder, env=alone, stdin=subprocess.DEVNULL,
                                        stdout=terminal if output_too else self.output, stderr=terminal, **options)
        os.close(terminal)

    def until(self, pattern):
        """Reads until the pattern is there."""
        end = time.monotonic() + LONG
        while not re.search(pattern, self.seen[-20_000:]):
            assert time.monotonic() < end, self.seen[-2000:]
            if not self.read():
                raise AssertionError(f"ended without {pattern}: {self.seen[-2000:]}")
        return self.seen

    def read(self):
        if not select.select([self.controller], [], [], 1)[0]:
            return True
        try:
            some = os.read(self.controller, 65536)
        except OSError:  # the other end is closed
            return False
        self.seen += some.decode(errors="replace")
        return bool(some)

    def end(self):
        while self.read():
            pass
        os.close(self.controller)
        if self.output:
            self.output.close()
        return self.process.wait(LONG)

    def interrupt(self):
        self.process.send_signal(signal.SIGINT)
        return self.end()


def continuation(seen):
    """The command line that goes on."""
    (line,) = re.findall(r"To go on:\r\n  (.*)\r\n", seen)
    return shlex.split(line)[1:]


@pytest.fixture(scope="module")
def many(tmp_path_factory):
    """A folder with many contact problems and an answer to each, as lines."""
    folder = tmp_path_factory.mktemp("many")
    matrix = [[4 if i == j else 1 for j in range(8)] for i in range(8)]
    lines = (json.dumps({"M": matrix, "q": [-i % 7 - 1] * 8, "z": [i % 3] * 8}) for i in range(30_000))
    (folder / "many.jsonl").write_text("\n".join(lines) + "\n")
    return folder


def run(folder, *arguments):
    return subprocess.run([PROGRAM, *arguments], cwd=folder, capture_output=True, text=True, check=False)


def test_certify_goes_on_with_the_record_after_the_last_line(many):
    terminal = Terminal("certify", "many.jsonl", "--json", folder=many)
    terminal.until(r"\[#* *\] +\d+ %.* records")
    assert terminal.interrupt() == -signal.SIGINT
    lines = (many / "output").read_text().splitlines()
    records = [json.loads(line)["record"] for line in lines]
    assert records == list(range(1, len(records) + 1)) and 0 < len(records) < 30_000
    assert "stopped by Ctrl-C; the lines of" in terminal.seen
    rest = continuation(terminal.seen)
    assert rest == ["certify", "many.jsonl", "--json", "--from", str(len(records) + 1)]
    (many / "few.jsonl").write_text("\n".join((many / "many.jsonl").read_text().splitlines()[: len(records) + 5]) + "\n")
    again = run(many, *["few.jsonl" if word == "many.jsonl" else word for word in rest]).stdout.splitlines()
    assert [json.loads(line)["record"] for line in again] == list(range(len(records) + 1, len(records) + 6))


def test_verify_goes_on_with_a_checkpoint(tmp_path):
    claims = str(SOURCE / "proofs/rozenblat-yashin/claims.toml")
    arguments = ("verify", claims, "--samples", "4000", "--only", "A1")
    first = Terminal(*arguments, folder=tmp_path)
    first.until(r"\[#* *\] +\d+ %")
    assert first.interrupt() == -signal.SIGINT
    assert "nothing is kept without --checkpoint" in first.seen
    proposed = continuation(first.seen)
    assert proposed == [*arguments, "--checkpoint", "slipproof.checkpoint"]
    second = Terminal(*proposed, folder=tmp_path)
    second.until(r"\[#+ *\] +\d+ %")
    assert second.interrupt() == -signal.SIGINT
    assert "every result so far is in slipproof.checkpoint" in second.seen and continuation(second.seen) == proposed
    kept = (tmp_path / "slipproof.checkpoint").stat().st_size
    assert kept > 1000


def test_search_names_what_it_was_given(tmp_path):
    terminal = Terminal("search", "painleve-rod", "--within", "mu < 1/10", "--samples", "900000000", folder=tmp_path)
    terminal.until(r"%")
    assert terminal.interrupt() == -signal.SIGINT
    assert "  " + shlex.join([PROGRAM, "search", "painleve-rod", "--within", "mu < 1/10"]) in terminal.seen


def test_prove_keeps_the_certificates(tmp_path):
    easy = "slipproof-statement 1\ntheorem {}\nreal x y\nshow x^2 + y^2 >= 2*x*y\n"
    hard = ("slipproof-statement 1\ntheorem hard\nreal a b c d e f\n"
            "assume p: a > 0 and b > 0 and c > 0 and d > 0 and e > 0 and f > 0\n"
            "show a/(b + c) + b/(c + d) + c/(d + e) + d/(e + f) + e/(f + a) + f/(a + b) >= 3\n")
    (tmp_path / "a.statement").write_text(easy.format("a"))
    (tmp_path / "hard.statement").write_text(hard)
    terminal = Terminal("prove", "a.statement", "hard.statement", "--again", "--effort", "1000000000000", folder=tmp_path)
    terminal.until(r"hard: \d+ million steps")
    assert terminal.interrupt() == -signal.SIGINT
    assert "each certificate so far is in its file" in terminal.seen and (tmp_path / "a.cert").exists()
    assert continuation(terminal.seen) == ["prove", "a.statement", "hard.statement", "--effort", "1000000000000"]
    assert "kept" in run(tmp_path, "prove", "a.statement").stdout
    # A theorem file is written whole, with what was found until then.
    both = easy.format("a") + hard
    (tmp_path / "mine.theorems").write_text(both)
    terminal = Terminal("prove", "mine.theorems", "--effort", "1000000000000", folder=tmp_path)
    terminal.until(r"hard: \d+ million steps")
    assert terminal.interrupt() == -signal.SIGINT
    certificate = (tmp_path / "a.cert").read_text()
    assert (tmp_path / "mine.theorems").read_text() == easy.format("a") + certificate + hard


def test_progress_has_the_time_left_and_makes_way_for_output(many):
    terminal = Terminal("certify", "many.jsonl", "--json", folder=many, output_too=True)
    terminal.until(r"\] +\d+ %, \d+ (s|min) left")
    terminal.interrupt()
    shown = re.sub(r"\r[^\r\n]*\x1b\[K", "", terminal.seen)
    lines = [line for line in shown.split("\r\n") if line.startswith("{")]
    assert lines and all("record" in json.loads(line) for line in lines)  # none has a bar in it


def test_nothing_is_shown_where_nobody_looks(many):
    with open(many / "errors", "wb") as errors, open(many / "output", "wb") as output:
        process = subprocess.Popen([PROGRAM, "certify", "many.jsonl", "--json"], cwd=many, stdout=output, stderr=errors)
        end = time.monotonic() + LONG
        while (many / "output").stat().st_size == 0 and time.monotonic() < end:
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        assert process.wait(LONG) == -signal.SIGINT
    told = (many / "errors").read_text()
    assert "\r" not in told and "\x1b" not in told and told.startswith("slipproof: stopped by Ctrl-C; the lines of")


def test_a_signal_that_is_ignored_stays_so(tmp_path):
    command = f"trap '' INT; exec {shlex.quote(PROGRAM)} search painleve-rod --samples 200 --quiet"
    process = subprocess.Popen(["sh", "-c", command], cwd=tmp_path, stdout=subprocess.PIPE, text=True)
    time.sleep(0.2)
    process.send_signal(signal.SIGINT)
    out, _ = process.communicate(timeout=LONG)
    assert process.returncode in (0, 1, 4) and out.startswith("s ")
