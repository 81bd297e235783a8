"""Runs all programs on all jobs, in turns, several times, and writes every time to one file.

Each job is measured by one program after the other before the next job begins, and the whole is repeated, so that a
disturbance of the machine does not meet one library alone.
"""

import argparse
import json
import os
import re
import subprocess
import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parent
LIBRARIES = {
    "bench_nurbs": "libnurbs",
    "bench_sisl": "SISL",
    "bench_occt": "Open CASCADE",
    "bench_eigen": "Eigen",
    "bench_eigen_native": "Eigen",
    "bench_gsl": "GSL",
    "bench_scipy.py": "SciPy",
}
OPERATIONS = {
    "bench_operations_nurbs": "libnurbs",
    "bench_operations_sisl": "SISL",
    "bench_operations_occt": "Open CASCADE",
    "bench_operations_snl": "SNL",
}
QUERIES = ("bench_queries_nurbs", "bench_queries_sisl", "bench_queries_occt")
# One thread; freed memory stays in the process, which helps those who return new arrays.
ENVIRONMENT = {
    **os.environ,
    "OPENBLAS_NUM_THREADS": "1",
    "MALLOC_MMAP_MAX_": "0",
    "MALLOC_TRIM_THRESHOLD_": str(2**40),
}


def commands(folder):
    """Programs that were built, with the command that starts them."""
    found = {name: [str(folder / name)] for name in LIBRARIES if (folder / name).exists()}
    python = ["/usr/bin/python3", "-B"]
    has_scipy = subprocess.run([*python, "-c", "import scipy"], capture_output=True).returncode == 0
    if has_scipy:
        found["bench_scipy.py"] = [*python, str(SOURCE / "bench_scipy.py")]
    return found


def entries(command, options):
    """The benchmarks of one run; a program that fails without an answer is one error."""
    done = subprocess.run([*command, *options], env=ENVIRONMENT, capture_output=True, text=True)
    try:
        found = json.loads(done.stdout)["benchmarks"] if done.stdout.strip() else []
    except ValueError:
        found = []
    if not found and done.returncode:
        message = f"exit status {done.returncode} {done.stderr.strip()[-200:]}"
        found = [{"name": "?/?", "error_occurred": True, "error_message": message}]
    return [entry for entry in found if entry.get("run_type", "iteration") == "iteration"]


def nanoseconds(entry):
    """Of process time for each point. Times that a benchmark takes itself stand in the field for real time."""
    kind = "real_time" if "manual_time" in entry["name"] else "cpu_time"
    return entry[kind] / entry["points"]


class Results:
    def __init__(self, jobs):
        self.jobs = jobs
        self.times = {}  # [job][library][route]: a list
        self.operations = {}  # [name]: {title, points, times: {library: a list, microseconds of process time}}
        # [name]: {title, routes: {route: {times: a list, microseconds of process time for each answer; wrong, error}}}
        self.queries = {}
        self.scaling = {}  # [name]: a list
        self.spans = None
        self.errors = set()

    def add(self, job, library, entry):
        if entry.get("error_occurred"):
            self.errors.add(f"{job}, {library}, {entry['name']}: {entry['error_message']}")
            return
        route = entry["name"].split("/")[1]
        routes = self.times.setdefault(job, {}).setdefault(library, {})
        routes.setdefault(route, []).append(nanoseconds(entry))

    def add_operation(self, library, entry):
        name = entry["name"].split("/")[0]
        if entry.get("error_occurred"):
            self.errors.add(f"{name}, {library}: {entry['error_message']}")
            return
        new = {"title": entry.get("label", ""), "points": entry["points"], "times": {}}
        times = self.operations.setdefault(name, new)["times"]
        times.setdefault(library, []).append(entry["cpu_time"])

    def add_query(self, entry):
        name, route = entry["name"].split("/")[:2]
        if entry.get("error_occurred"):
            self.errors.add(f"{name}, {route}: {entry['error_message']}")
            return
        routes = self.queries.setdefault(name, {"title": entry["label"], "routes": {}})["routes"]
        misses = {key: entry[key] for key in ("wrong", "error") if key in entry}
        found = routes.setdefault(route, {"times": [], **misses})
        found["times"].append(entry["cpu_time"] / entry["answers"])

    def add_scaling(self, entry):
        if entry.get("error_occurred"):
            self.errors.add(f"{entry['name']}: {entry['error_message']}")
            return
        self.spans = entry.get("spans", self.spans)
        self.scaling.setdefault(entry["name"].split("/")[0], []).append(nanoseconds(entry))

    def write(self, path):
        data = {**vars(self), "errors": sorted(self.errors)}
        path.write_text(json.dumps(data, indent=1), encoding="utf-8")


def one_pass(results, folder, arguments):
    options = ["--benchmark_format=json", f"--benchmark_min_time={arguments.min_time}"]
    data = str(folder / "data")
    for job in results.jobs:
        if not re.search(arguments.only, job["name"]):
            continue
        for program, command in commands(folder).items():
            if job["group"] == "main" or program == "bench_nurbs":
                for entry in entries(command, [data, *options, f"--benchmark_filter=^{job['name']}/"]):
                    results.add(job["name"], LIBRARIES[program], entry)
    if re.search(arguments.only, "operations"):
        for program, library in OPERATIONS.items():
            if (folder / "operations" / program).exists():
                for entry in entries([str(folder / "operations" / program)], options):
                    results.add_operation(library, entry)
    if re.search(arguments.only, "queries"):
        for program in QUERIES:
            if (folder / "queries" / program).exists():
                for entry in entries([str(folder / "queries" / program)], options):
                    results.add_query(entry)
    large = ["--large"] if arguments.large else []
    if re.search(arguments.only, "scaling"):
        for entry in entries([str(folder / "bench_scaling"), data, *large], options):
            results.add_scaling(entry)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, help="where the programs are, and the folder data")
    parser.add_argument("--passes", type=int, default=5)
    parser.add_argument("--only", default="", metavar="REGEX",
                        help="jobs whose name matches, operations, queries or scaling")
    parser.add_argument("--large", action="store_true", help="also a call with 1e8 points (4 GB)")
    parser.add_argument("--min-time", type=float, default=0.05, help="seconds for each time")
    arguments = parser.parse_args()
    jobs = json.loads((arguments.folder / "data" / "jobs.json").read_text(encoding="utf-8"))
    results = Results(jobs)
    for number in range(arguments.passes):
        print(f"pass {number + 1} of {arguments.passes}", file=sys.stderr, flush=True)
        one_pass(results, arguments.folder, arguments)
    results.write(arguments.folder / "results.json")
    print("\n".join(sorted(results.errors)), file=sys.stderr)
    return 1 if results.errors else 0


if __name__ == "__main__":
    sys.exit(main())
