"""Engines: their table, how their adapters are built and started, and how one is asked under a time limit."""

import contextlib
import json
import os
import select
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent.parent
building = threading.Lock()


class NotAsked(Exception):
    """Why an engine is not asked at all."""


class Failed(Exception):
    """The adapter gave no answer to a line."""


class Engine:
    def __init__(self, name, given):
        self.name = name
        self.many = given.get("many")
        self.floor = 1e-5 if given.get("binary32") else 1e-6  # what counts as motion at a threshold
        self.program, *self.arguments = given["program"]
        self.given = given
        self.shapes = given.get("shapes", False)  # it finds the contacts of whole shapes
        self.command = None

    def has(self, scene):
        """Whether it is asked such a scene at all."""
        if self.shapes:
            return scene.in_space and scene.on_floor()
        return not self.given.get("plane" if scene.in_space else "space")

    def prepare(self, folder):
        """Builds the adapter in a folder, where the packages of npm are, too. Raises NotAsked."""
        source = HERE / "adapters" / self.program
        missing = [p for p in self.given.get("npm", []) if not (folder / "node_modules" / p).is_dir()]
        if missing:
            raise NotAsked(f"{missing[0]} of npm is not installed")
        start = {".mjs": lambda: [self.tool("node"), str(source)], ".py": lambda: [self.python(), "-B", str(source)],
                 ".cpp": lambda: [str(self.compiled(source, folder))]}[source.suffix]()
        self.command = start + self.arguments
        self.folder = folder

    @staticmethod
    def tool(name):
        if not shutil.which(name):
            raise NotAsked(f"{name} is not installed")
        return name

    def python(self):
        module = self.given.get("module")
        if module and subprocess.run([sys.executable, "-c", f"import {module}"], capture_output=True).returncode:
            raise NotAsked(f"the module {module} of Python is not installed")
        return sys.executable

    def compiled(self, source, folder):
        with building:  # engines share adapters
            return self.compiled_alone(source, folder)

    def compiled_alone(self, source, folder):
        program = folder / source.stem
        shared = source.parent / "adapter.hpp"
        if program.exists() and program.stat().st_mtime > max(source.stat().st_mtime, shared.stat().st_mtime):
            return program
        flags = list(self.given.get("libraries", []))
        package = self.given.get("pkg-config")
        if package:
            asked = subprocess.run([self.tool("pkg-config"), "--cflags", "--libs", package], capture_output=True, text=True)
            version = subprocess.run(["pkg-config", "--modversion", package], capture_output=True, text=True)
            if asked.returncode:
                raise NotAsked(f"the library {package} is not installed")
            flags = asked.stdout.split() + flags + [f'-DENGINE_VERSION="{version.stdout.strip()}"']
        built = subprocess.run([self.tool("c++"), "-O2", str(source), "-o", str(program), *flags, f"-std={self.given.get('standard', 'c++20')}"],
                               capture_output=True, text=True)
        if built.returncode:
            raise NotAsked(f"its adapter does not compile here: {first_error(built.stderr)}")
        return program


def first_error(text):
    return next((line for line in text.splitlines() if "error" in line), text[:200])


class Asked:
    """A running adapter. It is started when it is asked, and again after it crashed or was too slow."""

    def __init__(self, engine, limit):
        self.engine, self.limit = engine, limit
        self.process = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()

    def stop(self):
        if self.process:
            self.process.kill()
            self.process.wait()
            for stream in (self.process.stdin, self.process.stdout, self.said):
                with contextlib.suppress(OSError):  # what could not be written any more
                    stream.close()
        self.process = None

    def start(self):
        self.said = tempfile.TemporaryFile("w+")
        # Threads of OpenBLAS wait for each other by spinning, which takes long where others use the processors, too.
        self.process = subprocess.Popen(self.engine.command, cwd=self.engine.folder, stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, stderr=self.said, env=os.environ | {"OPENBLAS_NUM_THREADS": "1"})
        self.rest = b""

    def answer(self, question):
        """The answer to a question, both as objects; from a fresh adapter where one that has worked before gives none.
        Raises Failed."""
        fresh = not self.process
        try:
            return self.try_once(question)
        except Failed:
            if fresh:
                raise
            return self.try_once(question)

    def try_once(self, question):
        if not self.process:
            self.start()
        try:
            self.process.stdin.write(json.dumps(question).encode() + b"\n")
            self.process.stdin.flush()
            return json.loads(self.line())
        except (BrokenPipeError, json.JSONDecodeError):
            reason = self.why()
            self.stop()
            raise Failed(reason) from None
        except TimeoutError:
            self.stop()
            raise Failed(f"no answer in {self.limit:g} s") from None

    def worked(self):
        """Seconds of processor time that the adapter has used."""
        after_name = Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return sum(map(int, after_name[11:13])) / os.sysconf("SC_CLK_TCK")

    def line(self):
        """Its next line. Raises TimeoutError after the limit of processor time, which does not depend on what else the
        machine does, or as long without any."""
        begun = last = self.worked()
        since = time.monotonic()
        while b"\n" not in self.rest:
            if not select.select([self.process.stdout], [], [], min(self.limit, 1))[0]:
                now = self.worked()
                if now > last:
                    last, since = now, time.monotonic()
                if now - begun >= self.limit or time.monotonic() - since >= self.limit:
                    raise TimeoutError
                continue
            more = os.read(self.process.stdout.fileno(), 1 << 16)
            if not more:
                raise BrokenPipeError
            self.rest += more
        line, self.rest = self.rest.split(b"\n", 1)
        return line

    def why(self):
        try:
            code = self.process.wait(1)
        except subprocess.TimeoutExpired:
            return "an answer that is no JSON"
        self.said.seek(0)  # what it wrote to standard error
        words = [line.strip() for line in self.said if line.strip()]
        told = next((line for line in reversed(words) if "rror" in line or "ssert" in line), words[-1] if words else "")
        return (f"crashed by signal {-code}" if code < 0 else f"ended with {code}") + (f": {told[:160]}" if told else "")


def table(file=HERE / "engines.toml"):
    with open(file, "rb") as opened:
        return {name: Engine(name, given) for name, given in tomllib.load(opened).items()}
