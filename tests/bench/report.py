"""Prints the times of measure.py as Markdown; with --readme, puts the table into the README."""

import argparse
import json
import re
import subprocess
import sys
from pathlib import Path
from statistics import median

TOP = Path(__file__).resolve().parents[2]
OURS = "libnurbs"
PEERS = {
    "SISL": "libsisl-dev",
    "Open CASCADE": "libocct-modeling-data-dev",
    "Eigen": "libeigen3-dev",
    "GSL": "libgsl-dev",
    "SciPy": "python3-scipy",
}
OPERATION_PEERS = {**{name: PEERS[name] for name in ("SISL", "Open CASCADE")}, "SNL": "libsnl-dev"}
QUERY_ROUTES = (OURS, "SISL", "SISL, fast routines", "Open CASCADE", "Open CASCADE, thorough")
# Answers that count as right in the ratio: none is wrong, or the relative error is at most this.
RIGHT = 1e-10
BEGIN, END = "<!-- speed: written by tests/bench/run --readme -->", "<!-- end of speed -->"


def best(results, job, library):
    """The fastest route of a library, or None."""
    routes = results["times"].get(job, {}).get(library, {})
    return min((median(times) for times in routes.values()), default=None)


def number(x):
    return "–" if x is None else f"{x:.2f}" if x < 10 else f"{x:.1f}" if x < 100 else f"{x:.0f}"


def table(rows):
    head, *body = ([str(cell) for cell in row] for row in rows)
    rule = ["---"] + ["---:"] * (len(head) - 1)
    return "\n".join("| " + " | ".join(row) + " |" for row in (head, rule, *body))


def job_row(results, job):
    ours = best(results, job["name"], OURS)
    peers = [best(results, job["name"], peer) for peer in PEERS]
    known = [time for time in peers if time is not None]
    ratio = f"{min(known) / ours:.1f}" if known and ours else "–"
    return [job["title"], number(ours), *map(number, peers), ratio, f"{job['target']:g}"]


def main_table(results, targets):
    rows = [["ns per point", OURS, *PEERS, "best other / ours", "target"]]
    for job in results["jobs"]:
        if job["group"] == "main" and job["name"] in results["times"]:
            rows.append(job_row(results, job))
    return table(rows if targets else [row[:-1] for row in rows])


def operation_row(operation):
    times = {library: median(values) for library, values in operation["times"].items()}
    ours, peers = times.get(OURS), [times.get(peer) for peer in OPERATION_PEERS]
    known = [time for time in peers if time is not None]
    ratio = f"{min(known) / ours:.1f}" if known and ours else "–"
    return [operation["title"], number(ours), *map(number, peers), ratio]


def operation_table(results):
    rows = [["microseconds", OURS, *OPERATION_PEERS, "best other / ours"]]
    rows += [operation_row(operation) for operation in results["operations"].values() if operation["title"]]
    return table(rows) if len(rows) > 1 else ""


def query_cell(found):
    """Time, and how wrong the answers are."""
    if found is None:
        return "–"
    miss = f"{100 * found['wrong']:.3g} % wrong" if "wrong" in found else f"error {found['error']:.0e}"
    miss = miss.replace("0e+00", "0")
    return f"{number(median(found['times']))} ({miss})"


def query_row(query):
    routes = query["routes"]
    ours = routes.get(OURS)
    right = [median(found["times"]) for route, found in routes.items()
             if route != OURS and found.get("wrong", 0) == 0 and found.get("error", 0) <= RIGHT]
    ratio = f"{min(right) / median(ours['times']):.1f}" if right and ours else "–"
    return [query["title"], *(query_cell(routes.get(route)) for route in QUERY_ROUTES), ratio]


def query_table(results):
    rows = [["microseconds for each answer", *QUERY_ROUTES, "best right other / ours"]]
    rows += [query_row(query) for query in results["queries"].values()]
    return table(rows) if len(rows) > 1 else ""


def growth_table(results):
    """Of the operations that are measured for libnurbs alone, with growing numbers of control points."""
    rows = [["operation and control points", "ns per control point"]]
    for name, operation in results["operations"].items():
        if not operation["title"]:
            rows.append([name, number(1000 * median(operation["times"][OURS]) / operation["points"])])
    return table(rows) if len(rows) > 1 else ""


def own_table(results, group, title):
    rows = [[title, "ns per point"]]
    for job in results["jobs"]:
        if job["group"] == group and job["name"] in results["times"]:
            rows.append([job["title"], number(best(results, job["name"], OURS))])
    return table(rows) if len(rows) > 1 else ""


def scaling_tables(results):
    times = {name: median(values) for name, values in results["scaling"].items()}
    sizes = sorted((int(name[2:]), time) for name, time in times.items() if name.startswith("n="))
    if not sizes:
        return ""
    batches = table([["points in a call", "ns per point"], *([f"{n:,}", number(t)] for n, t in sizes)])
    large, points = times["large_fresh"] - times["large_warm"], 1e5
    first = table(
        [
            ["first calls", "ns"],
            ["one point on a new handle of 100 control points", number(times["single_fresh"])],
            ["one point on a handle that has had a call with 1000 points", number(times["single_warm"])],
            ["tables, for each span: what a first call with 1e5 points takes more than a second one, "
             "10000 control points", f"{large * points / results['spans']:.1f}"],
        ]
    )
    return batches + "\n\n" + first


def first_match(pattern, text):
    found = re.search(pattern, text, flags=re.MULTILINE)
    return found.group(1).strip() if found else "unknown"


def version(package):
    command = ["dpkg-query", "-W", "-f=${Version}", package]
    found = subprocess.run(command, capture_output=True, text=True).stdout
    return re.sub(r"^\d+:|[+-].*$", "", found)


def machine():
    info = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    cpu, family, model = (first_match(rf"^{key}\s*:(.*)$", info) for key in ("model name", "cpu family", "model"))
    compiler = subprocess.run(["g++", "-dumpfullversion"], capture_output=True, text=True).stdout.strip()
    system = first_match(r'^PRETTY_NAME="(.*)"$', Path("/etc/os-release").read_text(encoding="utf-8"))
    packages = {**PEERS, **OPERATION_PEERS}
    others = ", ".join(f"{name} {version(package)}" for name, package in packages.items() if version(package))
    return f"Measured on {cpu} (family {family}, model {model}), {system}, g++ {compiler}; {others}."


def update_readme(text):
    path = TOP / "README.md"
    before, rest = path.read_text(encoding="utf-8").split(BEGIN)
    path.write_text(f"{before}{BEGIN}\n{text}\n{END}{rest.split(END)[1]}", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results", type=Path)
    parser.add_argument("--readme", action="store_true")
    arguments = parser.parse_args()
    results = json.loads(arguments.results.read_text(encoding="utf-8"))
    own = [
        own_table(results, "variants", "curve of degree 3, random parameters"),
        own_table(results, "points", "curve of degree 3, random parameters"),
        growth_table(results),
        scaling_tables(results),
    ]
    errors = [f"**error**: {error}" for error in results["errors"]]
    pairs = arguments.results.parent / "table.md"
    beside = pairs.read_text(encoding="utf-8").strip() if pairs.exists() else ""
    tables = operation_table(results), query_table(results), beside, machine()
    print("\n\n".join(part for part in (main_table(results, True), *tables, *own, *errors) if part))
    if arguments.readme:
        update_readme("\n\n".join([main_table(results, False), *filter(None, tables)]))


if __name__ == "__main__":
    sys.exit(main())
