# SPDX-License-Identifier: MIT
"""What progress=True shows: tqdm's bar where it is installed, else a line of text."""

from __future__ import annotations

import importlib
import sys
from typing import Any, Protocol


class Bar(Protocol):
    """How much of a call is done, for people."""

    def show(self, done: float) -> None:
        """From 0 to 1, rising."""

    def close(self, complete: bool) -> None:
        """At the end of the call, `complete` if it was not ended before."""


class _TqdmBar:
    def __init__(self, tqdm: Any, name: str) -> None:
        self._bar = tqdm(desc=name, total=1.0, bar_format="{desc}: {percentage:3.0f}%|{bar}| {elapsed}<{remaining}")
        self._done = 0.0

    def show(self, done: float) -> None:
        self._bar.update(done - self._done)
        self._done = done

    def close(self, complete: bool) -> None:
        if complete:
            self.show(1.0)
        self._bar.close()


class _Line:
    """Percents on the standard error output, if there is one."""

    def __init__(self, name: str) -> None:
        self._name, self._percent = name, -1

    def show(self, done: float) -> None:
        percent = int(100 * done)
        if percent != self._percent:
            self._percent = percent
            self._write(f"\r{self._name}: {percent:3}%")

    def close(self, complete: bool) -> None:
        if complete:
            self.show(1.0)
        self._write("\n")

    def _write(self, text: str) -> None:
        if sys.stderr is not None:
            sys.stderr.write(text)
            sys.stderr.flush()


def new_bar(function: str) -> Bar:
    """A bar with the name of a function of the library."""
    name = function[len("nurbs_"):]
    try:
        tqdm = importlib.import_module("tqdm.auto").tqdm
    except ImportError:
        return _Line(name)
    return _TqdmBar(tqdm, name)
