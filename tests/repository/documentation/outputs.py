"""outputs.py [--sentences] BUILD SOURCES PAGE...: what the pages show after `$ COMMAND` is what the command prints.

Commands of a page run in a folder of its own, one after the other, in which `cases`, `proofs`, `src` and the files
beside the page are the repository's, `build` is BUILD, and its programs are in the path. `$ cat FILE` writes a file
that is not there. A line `...` stands for any lines; a command without lines only has to run. A page about a program
that was not built is skipped from that command on. With --sentences, commands of slipproof and its checkers in sentences,
tables and indented lines run without a mistake; not those of one word, those about files that are not there, those without
`build/` and a file, and `prove`, which writes into `proofs`. In place of all papers they take a few, at 100 samples without
lines, and one mutant in 200: the soak tests of papers judge all, and `report proofs` takes minutes.
"""
import difflib
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

SENTENCES = sys.argv[1] == "--sentences"
ARGUMENTS = sys.argv[2 if SENTENCES else 1:]
BUILD, SOURCES = (os.path.abspath(path) for path in ARGUMENTS[:2])
PAGES = ARGUMENTS[2:]
ENVIRONMENT = {**os.environ, "PATH": BUILD + ":" + os.environ["PATH"], "LC_ALL": "C.UTF-8"}
SUCCESS, REFUTED, UNDECIDED = 0, 1, 4  # the exit codes of a command that did what it should


def sessions(page):
    """Of each block that begins with a command: its commands, each with the lines that follow it."""
    with open(page, encoding="utf-8") as file:
        text = file.read()
    for block in re.findall(r"^```(?:console|sh)?\n(\$ .*?)^```$", text, re.MULTILINE | re.DOTALL):
        commands = []
        for line in block.splitlines():
            if line.startswith("$ "):
                commands.append([line[2:], []])
            elif commands[-1][0].endswith("\\"):
                commands[-1][0] += "\n" + line
            else:
                commands[-1][1].append(line)
        yield commands


def matches(shown, printed):
    """Whether the lines are those that were printed, where `...` is any of them."""
    if not shown:
        return not printed
    if shown[0] == "...":
        return any(matches(shown[1:], printed[i:]) for i in range(len(printed) + 1))
    return bool(printed) and shown[0] == printed[0] and matches(shown[1:], printed[1:])


def commands_in_sentences(page, folder):
    """What a reader may copy out of a line; a file is there unless the command writes it."""
    with open(page, encoding="utf-8") as file:
        text = re.sub(r"^```.*?^```$", "", file.read(), flags=re.MULTILINE | re.DOTALL)
    marked = r"`(COMMAND[^`]*)`|<code>(COMMAND[^<]*)</code>|^ {4}(COMMAND.*?)(?: +#.*)?$".replace("COMMAND", "(?:build/)?slipproof")
    for command in map("".join, re.findall(marked, text, re.MULTILINE)):
        words = command.split()
        read = [word for before, word in zip(words, words[1:]) if re.search(r"[/.]", word) and before not in ("-o", "--out", "--only")]
        placeholder = any(re.search(r"\b[A-Z]{2,}\b", word) for word in words)
        whole = words[0].startswith("build/") and len(words) > (2 if words[0] == "build/slipproof" else 1)
        if (whole or read) and words[1] != "prove" and not placeholder and all(os.path.exists(os.path.join(folder, file)) for file in read):
            yield command


def shorter(command):
    few = re.sub(r"(?<= )proofs(?= |$)", "few", command)
    if "--samples" in few or not re.search(r"slipproof (verify|report (?!cases/engines))", few):
        return few
    return few + (" --every 200" if "--mutants" in few else " --samples 100 --lines 0")


def lay_out(page, folder):
    """The repository as commands of the page see it."""
    os.symlink(BUILD, os.path.join(folder, "build"))
    for name in ("cases", "proofs", "src"):
        os.symlink(os.path.join(SOURCES, name), os.path.join(folder, name))
    for paper in ("kerb", "ladder"):  # copies: a checker does not follow links to folders
        shutil.copytree(os.path.join(SOURCES, "proofs", paper), os.path.join(folder, "few", paper))
    for entry in os.scandir(os.path.dirname(page)):  # files beside the page
        if entry.is_file():
            os.symlink(entry.path, os.path.join(folder, entry.name))


class Outputs(unittest.TestCase):
    def run_page(self, page, folder):
        lay_out(page, folder)
        count = 0
        for commands in sessions(page):
            for command, shown in commands:
                target = re.fullmatch(r"cat (\S+)", command)
                if target and not os.path.exists(os.path.join(folder, target[1])):
                    with open(os.path.join(folder, target[1]), "w", encoding="utf-8") as file:
                        file.write("".join(line + "\n" for line in shown))
                    continue
                ran = subprocess.run(command, shell=True, cwd=folder, env=ENVIRONMENT, stdout=subprocess.PIPE,
                                     stderr=subprocess.STDOUT, text=True, timeout=120)
                if ran.returncode == 127 or "was built without" in ran.stdout:
                    self.skipTest(f"not built here: {command}")
                printed = [line.rstrip() for line in ran.stdout.splitlines()]
                shown = [line.rstrip() for line in shown]
                if shown and not matches(shown, printed):
                    self.fail(f"{page}: $ {command}\n" + "\n".join(difflib.unified_diff(shown, printed, "page", "program")))
                count += 1
        self.assertGreater(count, 0, f"{page} has no command")

    @unittest.skipUnless(SENTENCES, "takes long")
    def test_commands_in_sentences_run(self):
        ran = set()
        for page in PAGES:
            with tempfile.TemporaryDirectory() as folder:
                lay_out(os.path.join(SOURCES, page), folder)
                for command in commands_in_sentences(os.path.join(SOURCES, page), folder):
                    with self.subTest(page=page, command=command):
                        self.run_command(command, folder, ran)
        print(f"{len(ran)} commands ran", file=sys.stderr)
        self.assertGreater(len(ran), 20)

    def run_command(self, command, folder, ran):
        """Unless it ran for another page, or is a checker that is not built here."""
        name = command.removeprefix("build/")
        if name in ran or not os.path.exists(os.path.join(BUILD, name.split()[0])):
            return
        ran.add(name)
        start = time.monotonic()
        done = subprocess.run(shorter(command), shell=True, cwd=folder, env=ENVIRONMENT, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        print(f"{time.monotonic() - start:7.1f} s: {command}", file=sys.stderr, flush=True)
        if not re.search("was built without|[.]/run explorer", done.stdout):
            self.assertIn(done.returncode, (SUCCESS, REFUTED, UNDECIDED), done.stdout[-2000:])

    @unittest.skipIf(SENTENCES, "its own test")
    def test_outputs_are_those_of_the_program(self):
        for page in PAGES:
            with self.subTest(page), tempfile.TemporaryDirectory() as folder:
                self.run_page(os.path.join(SOURCES, page), folder)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
