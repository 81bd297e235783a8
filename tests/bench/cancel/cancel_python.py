# SPDX-License-Identifier: MIT
"""The same of Python's package, with the calls that tests/bindings/smoke_layer.py can make of calls.toml."""

import sys
import time
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parent), str(Path(__file__).resolve().parents[2] / "bindings")]

import make  # from this folder
import smoke_layer  # from tests/bindings, as smoke_table
import smoke_table

import nurbs


class Meter:
    def __init__(self, moment):
        self.start = self.last = time.perf_counter()
        self.stop, self.gap, self.stopped = self.start + moment / 1e3, 0.0, 0.0

    def __call__(self, done):
        now = time.perf_counter()
        self.gap, self.last = max(self.gap, now - self.last), now
        if now >= self.stop and not self.stopped:
            self.stopped = now
        return not self.stopped


def timed(call, moment):
    """Milliseconds of the call, its longest gap, and from the stop to the return."""
    meter = Meter(moment)
    try:
        call(meter)
    except nurbs.NurbsError:
        if not meter.stopped:
            raise
    end = time.perf_counter()
    gap = max(meter.gap, end - meter.last)
    return 1e3 * (end - meter.start), 1e3 * gap, 1e3 * (end - meter.stopped) if meter.stopped else 0.0


def measure(name, call):
    whole, gap, back = timed(call, float("inf"))
    for i in range(1, 6):
        _, next_gap, next_back = timed(call, whole * (0.6180339887498949 * i % 1) * 0.95)
        gap, back = max(gap, next_gap), max(back, next_back)
    print(f"{name} {whole:.1f} {gap:.1f} {back:.1f}", flush=True)


def main():
    smoke_table.model = make.read(smoke_table.manual)
    layer = smoke_layer.Layer()
    for call in make.watched(smoke_table.model):
        made = smoke_layer.LayerCall(layer, call, layer.planner.step(call))
        name = call.function.name
        if name.startswith("nurbs_read"):
            source = "big.igs" if "file" in name else Path("big.igs").read_bytes()
            function = nurbs.read_file if "file" in name else nurbs.read
            measure(name, lambda progress: function(source, progress=progress))
            continue
        try:
            measure(name, lambda progress: made.run(progress))
        except smoke_layer.Unlike as error:
            print(f"{name}: {error}")


if __name__ == "__main__":
    main()
