#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plants faults in src, one at a time, and sees whether the tests notice.

usage: mutate.py BUILD REACH REPORT [--count N] [--seed S] [--patience SECONDS] [--jobs N]

To be run in a copy of the sources, whose files it changes and puts back. BUILD is the build there that reach.py made
REACH of, its reach.json. A fault flips an operator or changes a constant. For each one the library and the programs of
those tests that run the line are built, and these tests are run, N at once and quick ones first, until one fails. Faults
that do not compile, and those that leave the object code as it was, do not count, and others take their places. REPORT gets
a line of JSON for each fault; a run that was broken off goes on where it was. A fault that no test has noticed when the time
for tests is over (--patience, 300) counts as not noticed.

Two rates are printed: of all faults, and of those that can change an answer. The second leaves out the equivalent mutants,
which equivalent.txt lists: survivors that were read and cannot change an answer. The exit status is 1 if the second rate is
below 85 %. A survivor that is not in equivalent.txt is either a gap, to be closed by a test, or belongs there with its reason.
"""

import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import threading
import time
from dataclasses import dataclass

WANTED = 0.85
MEMORY = 8 << 30  # of a test; a fault may ask for any

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
    before: str  # the line, and as the fault makes it
    after: str

    def __str__(self):
        return f"{self.file}:{self.line}: {self.old.strip()} -> {self.new.strip()}"


def changed_line(text, match, new):
    """(the line of a match, the line with `new` in its place); a match has no line break."""
    start, end = text.rfind("\n", 0, match.start()) + 1, text.find("\n", match.end())
    return text[start:end].strip(), (text[start:match.start()] + new + text[match.end():end]).strip()


def faults_of(source, path):
    text = path.read_text(encoding="utf-8")
    code = NOT_CODE.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)
    lines = code.split("\n")
    name = str(path.relative_to(source))
    for pattern, swap in ((OPERATOR, SWAPS.get), (NUMBER, lambda digits: str(int(digits) + 1))):
        for match in pattern.finditer(code):
            line = code.count("\n", 0, match.start()) + 1
            if not DECLARATION.search(lines[line - 1]):
                new = swap(match[0])
                yield Fault(name, match.start(), match[0], new, line, *changed_line(text, match, new))


def in_order(fault, seed):
    """A key of a random order. It hangs on the fault's own text alone, so that a change elsewhere in the sources leaves the
    sample as it was, and with it the equivalent mutants."""
    return hashlib.sha256(f"{seed} {fault.file} {fault.before} {fault.after}".encode()).digest()


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
        """Those that run the line, or else one soon after it: initializers of members are not counted as lines."""
        found = self.files.get(fault.file, {})
        for line in range(fault.line, fault.line + 4):
            reaching = [self.tests[index] for index, lines in found.items() if lines >> line & 1]
            if reaching:
                return sorted(reaching, key=lambda test: test["seconds"])
        return []


class Build:
    """A build whose sources are changed one at a time."""

    def __init__(self, source, folder):
        self.source, self.folder = source, folder
        self.objects = folder / "src/CMakeFiles"

    def make(self, *targets):
        return subprocess.run(["ninja", "-C", str(self.folder), *targets], capture_output=True, check=False).returncode == 0

    def code(self):
        """What the library's objects hold, to tell whether a change changed anything."""
        return {path: hashlib.sha256(path.read_bytes()).digest() for path in self.objects.rglob("*.o")}

    def notices(self, test):
        command = ["prlimit", f"--as={MEMORY}", *test["command"]]
        try:
            done = subprocess.run(command, cwd=test["folder"], capture_output=True, check=False,
                                  env={**os.environ, **test["environment"], "LLVM_PROFILE_FILE": os.devnull},
                                  timeout=5 * test["seconds"] + 20)
        except subprocess.TimeoutExpired:
            return True
        return done.returncode not in (0, 77)


def plant(build, fault):
    path = build.source / fault.file
    text = path.read_text(encoding="utf-8")
    assert text[fault.offset:].startswith(fault.old)
    path.write_text(text[:fault.offset] + fault.new + text[fault.offset + len(fault.old):], encoding="utf-8")
    return lambda: path.write_text(text, encoding="utf-8")


class Trial:
    """The tests that run the line of one fault; programs are built when they are needed."""

    def __init__(self, build, patience):
        self.build, self.end = build, time.monotonic() + patience
        self.built, self.building = {}, threading.Lock()
        self.noticing, self.run = None, 0

    def compiles(self, test):
        program = pathlib.Path(test["command"][0]).name
        with self.building:
            if program not in self.built:
                self.built[program] = self.build.make(program)
            return self.built[program]

    def over(self):
        return self.noticing is not None or time.monotonic() > self.end

    def take(self, test):
        if self.over():
            return
        if not self.compiles(test):
            self.noticing = "the program does not compile"
        elif self.build.notices(test):
            self.noticing = test["name"]
        self.run += 1


def first_noticing(build, tests, patience, jobs):
    """(name of a test that fails or None, number of tests run)."""
    trial = Trial(build, patience)
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        list(pool.map(trial.take, tests))
    return trial.noticing, trial.run


def tried(build, fault, reach, before, given):
    """(verdict, detail) of a fault."""
    put_back = plant(build, fault)
    try:
        if not build.make("nurbs"):
            return "does not compile", ""
        if build.code() == before:
            return "same code", ""
        tests = reach.tests_of(fault)
        if not tests:
            return "survived", "no test runs the line"
        noticing, run = first_noticing(build, tests, given.patience, given.jobs)
        return ("noticed", noticing) if noticing else ("survived", f"{run} of {len(tests)} tests that run the line")
    finally:
        put_back()


def read_report(path):
    if not path.exists():
        return []
    return [json.loads(line) for line in path.read_text().splitlines()]


def read_equivalent(path):
    """{(file, line before, line after)} of the faults that cannot change an answer."""
    return set(re.findall(r"^(\S+): .+\n- (.+)\n\+ (.+)$", path.read_text(encoding="utf-8"), flags=re.MULTILINE))


def counted(report):
    return [entry for entry in report if entry["verdict"] in ("noticed", "survived")]


def summary(report, equivalent):
    """Whether enough faults were noticed."""
    counting = counted(report)
    survivors = [entry for entry in counting if entry["verdict"] == "survived"]
    gaps = [entry for entry in survivors
            if (entry["fault"].split(":")[0], entry.get("before"), entry.get("after")) not in equivalent]
    noticed = len(counting) - len(survivors)
    real = noticed + len(gaps)
    print(f"{noticed} of {len(counting)} faults were noticed ({noticed / max(1, len(counting)):.1%}), of those that can change "
          f"an answer {noticed} of {real} ({noticed / max(1, real):.1%}); survivors among these:")
    for entry in gaps:
        print(f"  {entry['fault']}   ({entry['detail']})")
    return noticed >= WANTED * real


def main():
    parser = argparse.ArgumentParser(usage=argparse.SUPPRESS, description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("build", "reach", "report"):
        parser.add_argument(name, type=pathlib.Path)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--patience", type=float, default=300)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    given = parser.parse_args()
    source = pathlib.Path(__file__).resolve().parents[2]
    equivalent = read_equivalent(pathlib.Path(__file__).resolve().with_name("equivalent.txt"))
    reach = Reach(given.reach)
    build = Build(source, given.build.resolve())
    faults = all_faults(source)
    faults.sort(key=lambda fault: in_order(fault, given.seed))
    build.make()
    before = build.code()
    report = read_report(given.report)
    done = {entry["fault"] for entry in report}
    for fault in faults:
        if len(counted(report)) >= given.count:
            break
        if str(fault) not in done:
            start = time.monotonic()
            verdict, detail = tried(build, fault, reach, before, given)
            report.append({"fault": str(fault), "before": fault.before, "after": fault.after, "verdict": verdict,
                           "detail": detail, "seconds": round(time.monotonic() - start, 1)})
            with given.report.open("a") as file:
                file.write(json.dumps(report[-1]) + "\n")
            print(report[-1], flush=True)
    build.make()
    return 0 if summary(report, equivalent) else 1


if __name__ == "__main__":
    sys.exit(main())
