"""documentation.py PROGRAM FOLDER: what was written there says what the program's help says, and completes in bash."""
import os
import pty
import re
import shutil
import subprocess
import sys
import unittest

PROGRAM, FOLDER = sys.argv[1:3]
COMPLETION = FOLDER + "/completions/slipproof"


def run(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def options_of(*command):
    """The long names in the first column of a help text."""
    return set(re.findall(r"^ +(?:-\w,)?(--[\w-]+)", run(PROGRAM, *command, "--help"), re.MULTILINE))


COMMANDS = re.findall(r"^  (\w+) ", run(PROGRAM, "--help").partition("Subcommands:")[2], re.MULTILINE)
SOURCES = [FOLDER + "/man/slipproof.1"] + [f"{FOLDER}/man/slipproof-{command}.1" for command in COMMANDS]


def page(path):
    with open(path, encoding="ascii") as file:
        return file.read().replace("\\-", "-")


class Pages(unittest.TestCase):
    def test_every_command_has_one_with_all_of_its_options(self):
        self.assertGreater(len(COMMANDS), 10)
        self.assertTrue(options_of("map") > {"--out", "--x-range"})
        for command in COMMANDS:
            with self.subTest(command):
                written = set(re.findall(r"--[\w-]+", page(f"{FOLDER}/man/slipproof-{command}.1")))
                self.assertEqual(options_of(command) - written, set())
                heads = re.findall(r"^\.B (-.*)", page(f"{FOLDER}/man/slipproof-{command}.1"), re.MULTILINE)
                self.assertEqual(len(heads), len(set(heads)))
                self.assertIn(f"slipproof-{command}(1)", page(SOURCES[0]))

    def test_a_choice_stands_with_its_default(self):
        text = page(FOLDER + "/man/slipproof-certify.1")
        self.assertRegex(text, r"\.B --decimal nearest\|exact\n.* \[nearest\]\n")

    def test_man_has_nothing_to_complain_of(self):
        if not shutil.which("man"):
            self.skipTest("man is not installed")
        pages = SOURCES + [FOLDER + "/man/slipproof-check-contact.1"]
        shown = subprocess.run(["man", "--warnings", "-l", *(path + ".gz" for path in pages)], check=True,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                               env={**os.environ, "LC_ALL": "C.UTF-8"})
        self.assertEqual(shown.stderr, "")
        self.assertEqual(shown.stdout.count("EXIT STATUS"), len(pages))


def completed(*words):
    """What bash offers for the last word."""
    script = 'source "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _slipproof; printf "%s\\n" "${COMPREPLY[@]}"'
    return run("bash", "--norc", "-c", script, COMPLETION, "slipproof", *words).split()


class Completion(unittest.TestCase):
    def test_commands(self):
        self.assertEqual(completed("se"), ["search"])
        self.assertEqual(set(completed("")), set(COMMANDS) | {"-h", "--help", "--version"})

    def test_options_of_every_command(self):
        for command in COMMANDS:
            with self.subTest(command):
                self.assertEqual({word for word in completed(command, "--")}, options_of(command))

    def test_values(self):
        self.assertEqual(completed("certify", "--law", ""), ["coulomb", "cone", "box", "diamond", "fixed", "associated", "regularised"])
        self.assertEqual(completed("certify", "--law", "=", "b"), ["box"])
        self.assertEqual(completed("certify", "--law", "="), ["coulomb", "cone", "box", "diamond", "fixed", "associated", "regularised"])
        self.assertEqual(completed("solve", "--digits", ""), [])

    def test_files_and_shipped_mechanisms(self):
        self.assertEqual(completed("solve", COMPLETION[:-1]), [COMPLETION])
        self.assertEqual(completed("show", "ladd"), ["ladder"])
        self.assertEqual(completed("certify", "--mechanism", "gri"), ["gripper"])
        self.assertEqual(completed("certify", "--scene", "ladd"), [])

    def test_keys_typed_into_a_shell(self):
        child, terminal = pty.fork()
        if child == 0:
            os.environ["TERM"] = "dumb"
            os.execlp("bash", "bash", "--norc", "-i")
        with os.fdopen(terminal, "r+b", buffering=0) as keys:
            keys.write(f"source '{COMPLETION}'; slipproof() {{ printf '<%s>' \"$@\"; }}\n".encode())
            keys.write(b"slipproof certi\t--la\tdia\t; exit\n")
            shown = b""
            try:
                while part := keys.read(4096):
                    shown += part
            except OSError:  # the shell has ended
                pass
        os.waitpid(child, 0)
        self.assertIn(b"<certify><--law><diamond>", shown)

    def test_zsh_can_read_its_own(self):
        if not shutil.which("zsh"):
            self.skipTest("zsh is not installed")
        run("zsh", "-n", FOLDER + "/completions/_slipproof")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
