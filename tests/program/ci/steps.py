"""steps.py PROGRAM CASES: runs the steps of cases/ci, the GitHub Action and the GitLab template, with answers that are
right and with answers that are not. Of what a runner does this does: a step's `if`, its inputs in `env`, bash with -e."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

try:
    import yaml
except ImportError:
    sys.exit(77)

program, cases = (pathlib.Path(word).resolve() for word in sys.argv[1:])
problems = cases / "contact-problems"
wrong, right = str(problems / "examples.jsonl"), str(problems / "pushed-block.json")


def run(script, variables, folder):
    path = f"{folder / 'bin'}:{program.parent}:{os.environ['PATH']}"
    return subprocess.run(["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", script], cwd=folder,
                          env=os.environ | {"PATH": path} | variables, capture_output=True, text=True, check=False)


def github(folder, **given):
    """The first step that fails, or the last one."""
    action = yaml.safe_load((cases / "ci/action.yml").read_text())
    known = {name: given.pop(name.replace("-", "_"), one.get("default")) for name, one in action["inputs"].items()}
    assert not given and None not in known.values(), given
    for step in action["runs"]["steps"]:
        if step.get("if") == "inputs.package != ''" and not known["package"]:
            continue
        variables = {key: re.sub(r"\$\{\{ inputs\.([a-z-]+) \}\}", lambda name: known[name[1]], value)
                     for key, value in step["env"].items()}
        done = run(step["run"], variables, folder)
        if done.returncode:
            break
    return done, {name: folder / one["value"] for name, one in action["outputs"].items()}


def gitlab(folder, **given):
    job = yaml.safe_load((cases / "ci/gitlab.yml").read_text())[".slipproof"]
    variables = job["variables"] | {f"SLIPPROOF_{key.upper()}": value for key, value in given.items()}
    return run("\n".join(job["before_script"] + job["script"]), variables, folder), {
        "junit": folder / job["artifacts"]["reports"]["junit"]}


def check(template):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        done, files = template(folder, answers=right)
        assert done.returncode == 0, done
        done, files = template(folder, answers=wrong, fail_on="wrong")
        assert done.returncode == 1 and "3 of 10 records fail" in done.stdout + done.stderr, done
        suites = xml.parse(files["junit"]).getroot()
        assert len(suites.findall(".//failure")) == 3, suites
        assert all(file.stat().st_size for file in files.values())
        done, _ = template(folder, answers=wrong, arguments="--tolerance no")
        assert done.returncode not in (0, 1), done
        # A package is installed first, by apt-get, which only says here what it was told.
        (folder / "bin").mkdir()
        (folder / "bin/apt-get").write_text('#!/bin/sh\necho "$@" >>told\n')
        (folder / "bin/apt-get").chmod(0o755)
        (folder / "slipproof_1.deb").write_text("")
        done, _ = template(folder, answers=right, package="./slipproof_*.deb")
        assert done.returncode == 0, done
        told = (folder / "told").read_text().split()
        assert told[:3] == ["update", "install", "-y"] and pathlib.Path(folder, told[3]).name == "slipproof_1.deb", told


check(github)
check(gitlab)
