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


def times(path):
    """Ratios by row."""
    return {row: float(ratio) for row, ratio in (line.split() for line in path.read_text().splitlines())}


def main():
    folder = Path(sys.argv[1])
    before, after = counts(folder, "before"), counts(folder, "after")
    print("| row | time | instructions |\n| --- | ---: | ---: |")
    worst = [0.0, 0.0]
    forward, swapped = times(folder / "times.txt"), times(folder / "times_swapped.txt")
    for row, ratio in forward.items():
        ratios = [(ratio / swapped[row]) ** 0.5, after[row] / before[row] if before.get(row) else float("nan")]
        worst = [max(pair) for pair in zip(worst, ratios)]
        print(f"| {row} | {ratios[0]:.3f} | {ratios[1]:.4f} |")
    print(f"| largest | {worst[0]:.3f} | {worst[1]:.4f} |")


main()
