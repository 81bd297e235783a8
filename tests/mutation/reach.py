#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs every test of a build with clang's coverage, one at a time, and writes which lines each of them reached.

usage: reach.py BUILD OUTPUT [--jobs N]

BUILD is a build of the preset `coverage`. OUTPUT gets reach.json, which mutate.py reads, and report.txt with the share of
lines and branches of src and capi that the tests reached together. The exit status is 1 if fewer than 95 % of the lines
are reached, or if a test fails: of a fault that is planted it could tell nothing.

reach.json: {"tests": [{"name", "command", "folder", "environment", "seconds"}], "files": {FILE: {TEST INDEX: LINES}}},
where LINES is a hexadecimal number whose bit n says that line n was run.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import time

LABELS = {"unit", "property", "capi", "fuzz"}  # tests of the library's own code
WANTED_LINES = 0.95


def run(command, **options):
    return subprocess.run(command, capture_output=True, text=True, errors="replace", check=True, **options).stdout


def tool(name):
    """The tool of LLVM, which some distributions know with its version only."""
    for word in (name, f"{name}-14"):
        if subprocess.run(["which", word], capture_output=True, check=False).returncode == 0:
            return word
    sys.exit(f"{name} is not installed")


def properties_of(test):
    return {entry["name"]: entry["value"] for entry in test.get("properties", [])}


def tests_of(build):
    """The tests of the library's own code that are programs of the build."""
    found = []
    for test in json.loads(run(["ctest", "--show-only=json-v1"], cwd=build))["tests"]:
        known = properties_of(test)
        command = test.get("command", [])
        if LABELS & set(known.get("LABELS", [])) and command and pathlib.Path(command[0]).is_relative_to(build):
            found.append({"name": test["name"], "command": command,
                          "folder": known.get("WORKING_DIRECTORY", str(build)),
                          "environment": dict(entry.split("=", 1) for entry in known.get("ENVIRONMENT", []))})
    return found


class Reach:
    """What the tests reach, from the counters that their processes leave."""

    def __init__(self, source, build, output):
        self.source, self.build, self.output = source, build, output
        self.library = next(build.glob("capi/libnurbs.so"))
        self.profdata, self.cov = tool("llvm-profdata"), tool("llvm-cov")
        self.failures = []
        (output / "raw").mkdir(parents=True, exist_ok=True)

    def lines(self, profile, program):
        """{file: lines as a number whose bits are set} that are reached according to one profile."""
        text = run([self.cov, "export", "--format=lcov", "--skip-functions", f"--instr-profile={profile}",
                    str(program), f"--object={self.library}", str(self.source / "src"), str(self.source / "capi")])
        found, name = {}, None
        for line in text.splitlines():
            if line.startswith("SF:"):
                name = os.path.relpath(line[3:], self.source)
            elif line.startswith("DA:"):
                number, count = line[3:].split(",")[:2]
                if int(count) > 0:
                    found[name] = found.get(name, 0) | 1 << int(number)
        return found

    def of_test(self, index, test):
        raw = self.output / "raw" / f"{index}.profraw"
        profile = self.output / "raw" / f"{index}.profdata"
        start = time.monotonic()
        done = subprocess.run(test["command"], cwd=test["folder"], capture_output=True, check=False,
                              env={**os.environ, **test["environment"], "LLVM_PROFILE_FILE": str(raw)})
        test["seconds"] = round(time.monotonic() - start, 3)
        if done.returncode not in (0, 77):
            self.failures.append(test["name"])
        if not raw.exists():
            return {}
        run([self.profdata, "merge", "-sparse", str(raw), "-o", str(profile)])
        raw.unlink()
        return self.lines(profile, test["command"][0])

    def report(self, programs):
        merged = self.output / "all.profdata"
        listed = self.output / "profiles.txt"
        listed.write_text("".join(f"{path}\n" for path in sorted((self.output / "raw").glob("*.profdata"))))
        run([self.profdata, "merge", "-sparse", f"--input-files={listed}", "-o", str(merged)])
        objects = [f"--object={path}" for path in programs]
        return run([self.cov, "report", f"--instr-profile={merged}", "--show-branch-summary",
                    str(self.library), *objects, str(self.source / "src"), str(self.source / "capi")])


def totals(report):
    """Shares of the lines and branches reached, from the last row of llvm-cov's table."""
    row = next(line for line in report.splitlines() if line.startswith("TOTAL"))
    percents = [float(word) / 100 for word in re.findall(r"([\d.]+)%", row)]
    return percents[2], percents[3]  # after regions and functions


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    given = parser.parse_args()
    source = pathlib.Path(__file__).resolve().parents[2]
    reach = Reach(source, given.build.resolve(), given.output.resolve())
    tests = tests_of(reach.build)
    files = {}
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        for index, found in enumerate(pool.map(reach.of_test, range(len(tests)), tests)):
            for name, lines in found.items():
                files.setdefault(name, {})[index] = f"{lines:x}"
    (reach.output / "reach.json").write_text(json.dumps({"tests": tests, "files": files}))
    report = reach.report(sorted({test["command"][0] for test in tests}))
    (reach.output / "report.txt").write_text(report)
    lines, branches = totals(report)
    print(f"{len(tests)} tests reach {lines:.1%} of the lines and {branches:.1%} of the branches")
    for name in reach.failures:
        print(f"{name} fails")
    return 0 if lines >= WANTED_LINES and not reach.failures else 1


if __name__ == "__main__":
    sys.exit(main())
