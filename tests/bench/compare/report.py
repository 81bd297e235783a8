"""Prints times and counts of two builds, row by row, and the largest of both."""

import re
import sys
from pathlib import Path


def counts(folder, name):
    """Instructions by row, from the files that callgrind wrote."""
    found = {}
    for path in folder.glob(f"{name}.counts.*"):
        text = path.read_text()
        row = re.search(r"^desc: Trigger: Client Request: (.*)$", text, re.MULTILINE)
        total = re.search(r"^(?:summary|totals): (\d+)", text, re.MULTILINE)
        if row and total:
            found[row[1]] = int(total[1])
    return found


def main():
    folder = Path(sys.argv[1])
    before, after = counts(folder, "before"), counts(folder, "after")
    print("| row | time | instructions |\n| --- | ---: | ---: |")
    worst = [0.0, 0.0]
    for line in (folder / "times.txt").read_text().splitlines():
        row, time = line.split()
        ratios = [float(time), after[row] / before[row] if before.get(row) else float("nan")]
        worst = [max(pair) for pair in zip(worst, ratios)]
        print(f"| {row} | {ratios[0]:.3f} | {ratios[1]:.4f} |")
    print(f"| largest | {worst[0]:.3f} | {worst[1]:.4f} |")


main()
