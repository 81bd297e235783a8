"""Adds up the results of several test runs; prints what failed, what was skipped and why, and the three numbers.

usage: summary.py [NAME=RESULTS.xml | passed:NAME | failed:NAME]...

RESULTS.xml is what `ctest --output-junit` writes. Exit status 0 if nothing failed and something passed.
"""

import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path


def skip_reason(case):
    """The reason as the test prints it: after "SKIPPED:" in either case, or the line after GoogleTest's "Skipped"."""
    output = case.findtext("system-out") or ""
    match = re.search(r"(?:SKIPPED|skipped):\s*(.*)|Skipped\n(.*)", output)
    return next((group.strip() for group in match.groups() if group), "") if match else "no reason given"


def ctest_results(name, path):
    """(verdict, test, detail) of each test; a file that is missing or empty is a failure of its own."""
    if not Path(path).is_file():
        return [("failed", f"{name}: ctest", "left no results")]
    cases = ElementTree.parse(path).getroot().findall("testcase")
    if not cases:
        return [("failed", f"{name}: ctest", "ran no test")]
    return [case_result(name, case) for case in cases]


def case_result(name, case):
    test = f"{name}: {case.get('name')}"
    if case.get("status") == "run":
        return "passed", test, ""
    message = case.find("skipped")
    if message is not None and "SKIP" in (message.get("message") or "").upper():
        return "skipped", test, skip_reason(case)
    failure = case.find("failure")
    return "failed", test, (failure.get("message") if failure is not None else "was not run") or ""


def all_results(arguments):
    for argument in arguments:
        verdict, separator, name = argument.partition(":")
        if separator and verdict in ("passed", "failed"):
            yield verdict, name, ""
        else:
            yield from ctest_results(*argument.split("=", 1))


def main():
    results = list(all_results(sys.argv[1:]))
    numbers = {kind: sum(verdict == kind for verdict, _, _ in results) for kind in ("passed", "failed", "skipped")}
    for kind in ("skipped", "failed"):
        for verdict, test, detail in results:
            if verdict == kind:
                print(f"{kind}: {test}" + (f" ({detail})" if detail else ""))
    print(", ".join(f"{number} {kind}" for kind, number in numbers.items()))
    return 1 if numbers["failed"] or not numbers["passed"] else 0


if __name__ == "__main__":
    sys.exit(main())
