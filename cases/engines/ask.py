#!/usr/bin/env python3
"""Asks physics engines the scenes of this folder and records what they answer: see ENGINES.md."""

import argparse
import datetime
import json
import sys
import time
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

from asking.engines import HERE, Asked, Failed, NotAsked, table
from asking.scenes import scenes_of
from asking.threshold import Bisection
from asking.world import Refused


class Interview:
    """One engine and all scenes."""

    def __init__(self, engine, arguments, date):
        self.engine, self.limit, self.date = engine, arguments.limit, date
        self.bisects = not arguments.no_thresholds

    def lines(self, scenes):
        with Asked(self.engine, self.limit) as asked:
            self.asked = asked
            for scene in scenes:
                if self.engine.has(scene):
                    yield from self.about(scene)

    def settings(self):
        """What is asked, and the iterations for it."""
        yield "", None
        if self.engine.many:
            yield "many iterations", self.engine.many

    def about(self, scene):
        for name, iterations in self.settings():
            yield self.kept(scene, name or "default", lambda: self.one(scene, iterations)[1])
        if scene.rests and not self.engine.given.get("problem"):
            yield self.kept(scene, "drift", lambda: self.watched(scene, "drift"))
        if scene.undriven and (self.engine.shapes or scene.stays) and not self.engine.given.get("problem"):
            yield self.kept(scene, "energy", lambda: self.watched(scene, "energy"))
        if not self.bisects or not scene.expected or not scene.expected.get("threshold"):
            return
        for name, iterations in self.settings():
            asked = "threshold" + (f", {name}" if name else "")
            yield self.kept(scene, asked, lambda: self.threshold(scene, iterations))

    def one(self, scene, iterations, *settings):
        question = scene.question(iterations, *settings, shapes=self.engine.shapes)
        if self.engine.given.get("problem"):
            question["ask"]["problem"] = scene.problem(*settings)
        answer = self.asked.answer(question)
        if "refused" in answer:
            raise Refused(answer["refused"])
        if any(value is None or value != value for value in answer["motion"].values()):
            raise Failed("an acceleration that is no number")
        return question, answer

    def watched(self, scene, what):
        """How far bodies move in 1, 10 and 100 steps, or how much their energy rises in 1,000, at default settings."""
        question = scene.question(None, shapes=self.engine.shapes)
        question["ask"]["watch"] = what
        if what == "energy":  # 1,000 steps in which what slides comes to rest
            question["ask"]["step"] = max(question["ask"]["step"], 1e-3)
        answer = self.asked.answer(question)
        if "refused" in answer:
            raise Refused(answer["refused"])
        if any(value is None or value != value for value in answer[what].values()):
            raise Failed(f"{what}: no number")
        return answer

    def threshold(self, scene, iterations):
        answers = []

        def ask(setting):
            question, answer = self.one(scene, iterations, setting)
            answers.append(answer)
            return question, answer

        bisection = Bisection(scene, ask, self.engine.floor)
        at, within, floor = bisection.run()
        kept = {key: answers[-1][key] for key in ("version", "settings", "law")}
        return kept | {"parameter": bisection.parameter, "changes_at": at, "within": within, "floor": floor}

    def kept(self, scene, asked, answer):
        """A line of the record, whatever happens."""
        head = {"schema": "slipproof/engine-answer/1", "engine": self.engine.name, "scene": scene.name, "asked": asked,
                "date": self.date}
        try:
            return head | {key: value for key, value in answer().items() if key not in head}
        except Refused as reason:
            return head | {"refused": str(reason)}
        except Failed as reason:
            return head | {"failed": str(reason)}


def interview(engine, arguments, scenes, date):
    """Writes the answers of an engine, and gives a line of the summary."""
    begun = time.monotonic()
    try:
        engine.prepare(arguments.folder)
    except NotAsked as reason:
        return f"{engine.name:15} not asked: {reason}"
    lines = list(Interview(engine, arguments, date).lines(scenes))
    file = arguments.answers / f"{engine.name}.jsonl"
    write(file, lines + kept_of(file, lines, arguments.scenes))
    return f"{engine.name:15} {time.monotonic() - begun:5.0f} s: {counted(lines)}"


def kept_of(file, lines, folder):
    """What is recorded already and was not asked again, of scenes that are still there."""
    new = {(line["scene"], line["asked"]) for line in lines}
    old = [json.loads(line) for line in file.read_text().splitlines()] if file.exists() else []
    return [line for line in old
            if (line["scene"], line["asked"]) not in new and (folder / "scenes" / f"{line['scene']}.toml").exists()]


def write(file, lines):
    lines.sort(key=lambda line: (line["scene"], line["asked"]))
    new = file.with_suffix(".new")
    new.write_text("".join(json.dumps(line) + "\n" for line in lines))
    new.replace(file)


def counted(lines):
    def count(asked):
        mine = [line for line in lines if line["asked"] == asked]
        bad = {word: sum(word in line for line in mine) for word in ("refused", "failed")}
        return f"{asked} {len(mine) - sum(bad.values())}/{len(mine)}" + (f" ({bad['failed']} failed)" if bad["failed"] else "")
    return "; ".join(count(asked) for asked in dict.fromkeys(line["asked"] for line in lines))


def arguments_of(words):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("engines", nargs="*", metavar="ENGINE", help="who is asked; all, if nobody is named")
    parser.add_argument("--slipproof", default="slipproof", help="the program")
    parser.add_argument("--folder", type=Path, default=Path("build/engines"), help="where adapters are built and packages of npm are")
    parser.add_argument("--scenes", type=Path, default=HERE, help="a folder with scenes/ and expected/")
    parser.add_argument("--only", default="", metavar="TEXT", help="only scenes whose CLASS/NAME contains this")
    parser.add_argument("--no-thresholds", action="store_true", help="a quick look: no bisection")
    parser.add_argument("--answers", type=Path, default=HERE / "answers", help="where ENGINE.jsonl are written")
    parser.add_argument("--limit", type=float, default=20, help="seconds of processor time for one answer")
    parser.add_argument("--jobs", type=int, default=2, help="engines that are asked at the same time")
    parser.add_argument("--table", type=Path, default=HERE / "engines.toml", help="the engines")
    return parser.parse_args(words)


def main(words):
    arguments = arguments_of(words)
    engines = table(arguments.table)
    unknown = [name for name in arguments.engines if name not in engines]
    if unknown:
        print(f"ask.py: found {unknown[0]}, expected one of {', '.join(engines)}", file=sys.stderr)
        return 2
    arguments.folder = arguments.folder.resolve()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    arguments.answers.mkdir(parents=True, exist_ok=True)
    scenes = [scene for scene in scenes_of(arguments.scenes, arguments.slipproof) if arguments.only in scene.name]
    if not scenes:
        print(f"ask.py: found no scenes in {arguments.scenes / 'scenes'}", file=sys.stderr)
        return 3
    date = datetime.date.today().isoformat()
    asked = [engines[name] for name in arguments.engines or engines]
    print(f"{len(scenes)} scenes; engine, time, answered/asked:", flush=True)
    with ThreadPoolExecutor(arguments.jobs) as crew:
        for done in as_completed([crew.submit(interview, engine, arguments, scenes, date) for engine in asked]):
            print(done.result(), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
