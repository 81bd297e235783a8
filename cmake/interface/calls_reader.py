# SPDX-License-Identifier: MIT
"""Reads the good calls of tests/capi/calls/*.toml, and checks them against nurbs.h.

    calls_reader.read(manual, top)      calls_model.Model, or CallsError with all problems

README.md in that folder describes the format.
"""

import tomllib
from difflib import get_close_matches
from pathlib import Path

import calls_model
from calls_arguments import ArgumentReader
from calls_model import Call, CallsError, Input, Model, Number, inputs_of
from calls_watched import watched_calls

INPUTS = "inputs"


def read(manual, top):
    paths = sorted((Path(top) / calls_model.FOLDER).glob("*.toml"))
    return parse(manual, {path.stem: tomllib.loads(path.read_text(encoding="utf-8")) for path in paths})


def parse(manual, tables):
    """tables: {name of a file without its ending: what it holds}"""
    return Reader(manual).model_of(dict(tables))


def similar(name, names):
    """Names that may be meant, for a message."""
    return ", ".join(get_close_matches(name, names, cutoff=0.5) or sorted(names))


class Reader:
    def __init__(self, manual):
        self.manual = manual
        self.functions = {function.name: function for function in manual.functions}
        self.model = Model()
        self.problems = []

    def model_of(self, tables):
        self.read_inputs(tables.pop(INPUTS, {}))
        for name, table in tables.items():
            self.model.groups[name] = [call for word, entry in table.items() for call in self.call(name, word, entry)]
        for calls in self.model.groups.values():
            calls += list(watched_calls(self.manual, list(calls)))
        names = [call.name for call in self.model.calls()]
        self.problems += [f"{name} stands in two files" for name in sorted(set(names)) if names.count(name) > 1]
        if self.problems:
            raise CallsError("\n".join(self.problems))
        return self.model

    # What calls are given.

    def read_inputs(self, table):
        for key in table.keys() - {"arrays", "texts", "shared", "made"}:
            self.problems.append(f"{INPUTS}.toml: {key} is none of arrays, texts, shared, made")
        for name, text in table.get("texts", {}).items():
            self.model.texts[name] = text if isinstance(text, str) else bytes.fromhex(text["hex"])
        for name, values in table.get("arrays", {}).items():
            self.model.arrays[name] = tuple(Number(value) for value in values)
        for kind in ("shared", "made"):
            for name, entry in table.get(kind, {}).items():
                self.read_input(name, dict(entry), kind == "shared")

    def read_input(self, name, entry, shared):
        function = self.function(f"{INPUTS}.toml: {name}", entry.pop("function", ""))
        for call in self.filled(f"{INPUTS}.toml: {name}", name, function, entry, False):
            kinds = [parameter.base for parameter, _ in call.arguments if parameter.pointers == 2 and not parameter.is_const]
            if len(kinds) != 1:
                self.problems.append(f"{INPUTS}.toml: {name}: {function.name} does not make one spline or list")
            else:
                self.model.inputs[name] = Input(name, kinds[0], shared, call)

    # Calls.

    def call(self, group, name, entry):
        """One, or none if something is wrong with it."""
        place = f"{group}.toml: {name}"
        if not isinstance(entry, dict):
            self.problems.append(f"{place} is no table of arguments")
            return []
        return self.filled(place, name, self.function(place, name.split(" ")[0]), entry, True)

    def function(self, place, short):
        function = self.functions.get("nurbs_" + short)
        if function is None:
            names = [name.removeprefix("nurbs_") for name in self.functions]
            self.problems.append(f"{place}: there is no function nurbs_{short}; there is {similar(short, names)}")
        return function

    def filled(self, place, name, function, entry, outputs):
        if function is None:
            return []
        reader = ArgumentReader(self.manual, self.model, function, entry, outputs)
        arguments, result = reader.arguments(), reader.result()
        self.problems += [f"{place}: {problem}" for problem in reader.problems]
        call = Call(name, function, arguments, result, self.needed(arguments), entry.get("can_do_without", False))
        return [] if reader.problems else [call]

    def needed(self, arguments):
        """Inputs that are not shared, each after those that its own call needs."""
        names = []
        for _, value in arguments:
            for name in inputs_of(value):
                made = self.model.inputs[name]
                names += [] if made.shared else [*made.call.made, name]
        return list(dict.fromkeys(names))
