#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plants faults in src, one at a time, and sees whether the tests notice.

usage: mutate.py SOURCE BUILD REACH REPORT [--count N] [--seed S] [--share K/N] [--patience SECONDS]

SOURCE is a checkout of its own (its files are changed and put back), BUILD a build of it with its tests, REACH the
reach.json of reach.py, made of the same sources. A fault flips an operator or changes a constant. For each one the
library and the programs of those tests that run the line are built, and these tests are run, quick ones first, until one
fails. Faults that do not compile, and those that leave the object code as it was, do not count, and others take their
places. REPORT gets a line of JSON for each fault; a run that was broken off goes on where it was. --share K/N: this
process takes each Nth fault, beginning with the Kth, so that N processes with a SOURCE and BUILD each can share the work.
A fault that no test has noticed when the time for tests is over (--patience, 300) counts as not noticed.
"""

import argparse
import hashlib
import json
import os
import pathlib
import random
import re
import subprocess
import sys
import time
from dataclasses import dataclass

# Operators have blanks on both sides in formatted code; template brackets, pointers and references have not.
SWAPS = {" + ": " - ", " - ": " + ", " * ": " / ", " / ": " * ", " < ": " <= ", " <= ": " < ", " > ": " >= ",
         " >= ": " > ", " == ": " != ", " != ": " == ", " && ": " || ", " || ": " && ", " += ": " -= ",
         " -= ": " += ", " *= ": " /= ", "++": "--", "std::min(": "std::max(", "std::max(": "std::min(",
         "true": "false", "false": "true"}
OPERATOR = re.compile("|".join(rf"\b{re.escape(word)}\b" if word.isalpha() else re.escape(word)
                               for word in sorted(SWAPS, key=len, reverse=True)))
NUMBER = re.compile(r"(?<![\w.])(\d+)(?![\w.]|\s*>)")
NOT_CODE = re.compile(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])+'|^[ \t]*#[^\n]*",
                      flags=re.DOTALL | re.MULTILINE)
DECLARATION = re.compile(r"static_assert|template|namespace|using |operator")


@dataclass(frozen=True)
class Fault:
    file: str
    offset: int
    old: str
    new: str
    line: int

    def __str__(self):
        return f"{self.file}:{self.line}: {self.old.strip()} -> {self.new.strip()}"


def faults_of(source, path):
    text = path.read_text(encoding="utf-8")
    code = NOT_CODE.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)
    lines = code.split("\n")
    name = str(path.relative_to(source))
    for pattern, new in ((OPERATOR, SWAPS.get), (NUMBER, lambda digits: str(int(digits) + 1))):
        for match in pattern.finditer(code):
            line = code.count("\n", 0, match.start()) + 1
            if not DECLARATION.search(lines[line - 1]):
                yield Fault(name, match.start(), match[0], new(match[0]), line)


def all_faults(source):
    files = sorted(path for path in (source / "src").rglob("*") if path.suffix in (".cpp", ".h"))
    return [fault for path in files for fault in faults_of(source, path)]


class Reach:
    """Which tests run a line."""

    def __init__(self, path):
        stored = json.loads(path.read_text())
        self.tests = stored["tests"]
        self.files = {name: {int(index): int(lines, 16) for index, lines in found.items()}
                      for name, found in stored["files"].items()}

    def tests_of(self, fault):
        reaching = [self.tests[index] for index, lines in self.files.get(fault.file, {}).items()
                    if lines >> fault.line & 1]
        return sorted(reaching, key=lambda test: test["seconds"])


class Build:
    """A build whose sources are changed one at a time."""

    def __init__(self, source, folder, built_folder):
        self.source, self.folder, self.built_folder = source, folder, built_folder
        self.objects = folder / "src/CMakeFiles/nurbs_objects.dir"

    def make(self, *targets):
        return subprocess.run(["ninja", "-C", str(self.folder), *targets], capture_output=True, check=False).returncode == 0

    def code(self):
        """What the library's objects hold, to tell whether a change changed anything."""
        return {path: hashlib.sha256(path.read_bytes()).digest() for path in self.objects.rglob("*.o")}

    def moved(self, path):
        """A path in the build that the tests were listed in, in this one."""
        return path.replace(self.built_folder, str(self.folder))

    def notices(self, test):
        command = [self.moved(word) for word in test["command"]]
        try:
            done = subprocess.run(command, cwd=self.moved(test["folder"]), capture_output=True, check=False,
                                  env={**os.environ, **test["environment"]}, timeout=20 * test["seconds"] + 20)
        except subprocess.TimeoutExpired:
            return True
        return done.returncode not in (0, 77)


def plant(build, fault):
    path = build.source / fault.file
    text = path.read_text(encoding="utf-8")
    assert text[fault.offset:].startswith(fault.old)
    path.write_text(text[:fault.offset] + fault.new + text[fault.offset + len(fault.old):], encoding="utf-8")
    return lambda: path.write_text(text, encoding="utf-8")


def first_noticing(build, tests, patience):
    """(name of the first test that fails or None, number of tests run); programs are built when they are needed."""
    built = set()
    end = time.monotonic() + patience
    for index, test in enumerate(tests):
        program = pathlib.Path(test["command"][0]).name
        if program not in built and not build.make(program):
            return "the program does not compile", index
        built.add(program)
        if build.notices(test):
            return test["name"], index + 1
        if time.monotonic() > end:
            return None, index + 1
    return None, len(tests)


def tried(build, fault, reach, before, patience):
    """(verdict, detail) of a fault."""
    put_back = plant(build, fault)
    try:
        if not build.make("nurbs", "nurbs_objects"):
            return "does not compile", ""
        if build.code() == before:
            return "same code", ""
        tests = reach.tests_of(fault)
        if not tests:
            return "survived", "no test runs the line"
        noticing, run = first_noticing(build, tests, patience)
        return ("noticed", noticing) if noticing else ("survived", f"{run} of {len(tests)} tests that run the line")
    finally:
        put_back()


def read_report(path):
    if not path.exists():
        return []
    return [json.loads(line) for line in path.read_text().splitlines()]


def counted(report):
    return [entry for entry in report if entry["verdict"] in ("noticed", "survived")]


def summary(report):
    counting = counted(report)
    survivors = [entry for entry in counting if entry["verdict"] == "survived"]
    noticed = len(counting) - len(survivors)
    print(f"{noticed} of {len(counting)} faults were noticed ({noticed / max(1, len(counting)):.1%}); survivors:")
    for entry in survivors:
        print(f"  {entry['fault']}   ({entry['detail']})")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    for name in ("source", "build", "reach", "report"):
        parser.add_argument(name, type=pathlib.Path)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--share", default="1/1")
    parser.add_argument("--patience", type=float, default=300)
    given = parser.parse_args()
    source = given.source.resolve()
    reach = Reach(given.reach)
    folder = pathlib.Path(reach.tests[0]["command"][0]).parts
    build = Build(source, given.build.resolve(), str(pathlib.Path(*folder[:folder.index("tests")])))
    faults = all_faults(source)
    random.Random(given.seed).shuffle(faults)
    first, step = (int(word) for word in given.share.split("/"))
    build.make()
    before = build.code()
    report = read_report(given.report)
    done = {entry["fault"] for entry in report}
    for fault in faults[first - 1::step]:
        if len(counted(report)) >= given.count // step:
            break
        if str(fault) not in done:
            start = time.monotonic()
            verdict, detail = tried(build, fault, reach, before, given.patience)
            report.append({"fault": str(fault), "verdict": verdict, "detail": detail,
                           "seconds": round(time.monotonic() - start, 1)})
            with given.report.open("a") as file:
                file.write(json.dumps(report[-1]) + "\n")
            print(report[-1], flush=True)
    build.make()
    summary(report)
    return 0


if __name__ == "__main__":
    sys.exit(main())
