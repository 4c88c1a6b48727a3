"""outputs.py BUILD SOURCES PAGE...: what the pages show after `$ COMMAND` is what the command prints.

Commands of a page run in a folder of its own, one after the other, in which `cases`, `proofs`, `src` and the files
beside the page are the repository's, `build` is BUILD, and its programs are in the path. `$ cat FILE` writes a file
that is not there. A line `...` stands for any lines; a command without lines only has to run. A page about a program
that was not built is skipped from that command on.
"""
import difflib
import os
import re
import subprocess
import sys
import tempfile
import unittest

BUILD, SOURCES = (os.path.abspath(path) for path in sys.argv[1:3])
PAGES = sys.argv[3:]


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


class Outputs(unittest.TestCase):
    def run_page(self, page, folder):
        os.symlink(BUILD, os.path.join(folder, "build"))
        for name in ("cases", "proofs", "src"):
            os.symlink(os.path.join(SOURCES, name), os.path.join(folder, name))
        for entry in os.scandir(os.path.dirname(page)):  # files beside the page
            if entry.is_file():
                os.symlink(entry.path, os.path.join(folder, entry.name))
        environment = {**os.environ, "PATH": BUILD + ":" + os.environ["PATH"], "LC_ALL": "C.UTF-8"}
        count = 0
        for commands in sessions(page):
            for command, shown in commands:
                target = re.fullmatch(r"cat (\S+)", command)
                if target and not os.path.exists(os.path.join(folder, target[1])):
                    with open(os.path.join(folder, target[1]), "w", encoding="utf-8") as file:
                        file.write("".join(line + "\n" for line in shown))
                    continue
                ran = subprocess.run(command, shell=True, cwd=folder, env=environment, stdout=subprocess.PIPE,
                                     stderr=subprocess.STDOUT, text=True, timeout=120)
                if ran.returncode == 127 or "was built without" in ran.stdout:
                    self.skipTest(f"not built here: {command}")
                printed = [line.rstrip() for line in ran.stdout.splitlines()]
                shown = [line.rstrip() for line in shown]
                if shown and not matches(shown, printed):
                    self.fail(f"{page}: $ {command}\n" + "\n".join(difflib.unified_diff(shown, printed, "page", "program")))
                count += 1
        self.assertGreater(count, 0, f"{page} has no command")

    def test_outputs_are_those_of_the_program(self):
        for page in PAGES:
            with self.subTest(page), tempfile.TemporaryDirectory() as folder:
                self.run_page(os.path.join(SOURCES, page), folder)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
