# SPDX-License-Identifier: MIT
"""Reads the table of the bindings, capi/bindings/table/*.toml, and checks it against nurbs.h.

    table.read(manual, top)    a model.Binding, or TableError with all problems, each with file, function and key

README.md in that folder describes the format.
"""

import re
import tomllib
from pathlib import Path

import extents
import methods
import model
import signature
from methods import similar

FOLDER = "capi/bindings/table"
GENERAL = "general.toml"
GROUP_KEYS = {"doc", "constants", *model.LANGUAGES}
ENTRY_KEYS = {"call", "doc", "section", "where", "shape", "into", "space_only", "otherwise", "called", "through", "packed",
              "by_hand", "watched", "lenient", "missing", "unreturned"}
LANGUAGE_KEYS = {"call", "doc", "shape", "module", "ranks", "failing", "by_hand", "dim_of",
                 "sizes", "called"}
RECORD_KEYS = {"doc", "defaults", "from", "struct", "by_hand", "of_splines"}
RECORD_LANGUAGE_KEYS = {"doc", "name", "outputs", "rename", "initial"}
MOST_PARAMETERS = 12  # of a new function


class TableError(Exception):
    """What is wrong with the table, one line for each problem."""


def read(manual, top):
    folder = Path(top) / FOLDER
    texts = {path.stem: tomllib.loads(path.read_text(encoding="utf-8")) for path in sorted(folder.glob("*.toml"))}
    return parse(manual, texts)


def parse(manual, texts):
    """texts: {name of a file without its ending: what it holds}"""
    return Reader(manual, texts).binding()


class Reader:
    def __init__(self, manual, texts):
        self.manual = manual
        self.general = texts.get("general", {})
        self.texts = {name: text for name, text in texts.items() if name != "general"}
        self.functions = {function.name: function for function in manual.functions}
        self.problems = []
        self.records = {}

    def report(self, place, problem):
        self.problems.append(f"{place}: {problem}")

    def binding(self):
        groups = [self.group(name) for name in self.order()]
        for group in groups:
            for entry in group.entries:
                self.add_methods(entry)
        self.check_complete(groups)
        if self.problems:
            raise TableError("\n".join(self.problems))
        return model.Binding(self.manual, groups, self.general)

    def order(self):
        """Names of the files in the order that general.toml gives."""
        order = self.general.get("order", [])
        for name in self.texts.keys() - set(order):
            self.report(f"{GENERAL}: order", f"{name}.toml is not among the files")
        for name in set(order) - self.texts.keys():
            self.report(f"{GENERAL}: order", f"there is no file {name}.toml")
        return [name for name in order if name in self.texts]

    # Files.

    def group(self, name):
        text = self.texts[name]
        group = model.Group(name, text.get("group", {}))
        self.check_keys(f"{name}.toml: [group]", group.text, GROUP_KEYS)
        if "doc" not in group.text:
            self.report(f"{name}.toml: [group]", "needs doc = \"what the file is about\"")
        for key, value in text.items():
            if key.startswith("nurbs_"):
                self.add_entry(group, key, value)
            elif re.fullmatch(r"[A-Z][A-Za-z]+", key):
                self.add_record(group, key, value)
            elif key != "group":
                self.report(f"{name}.toml: [{key}]", "neither a function of nurbs.h nor a record (CamelCase)")
        return group

    def check_keys(self, place, text, known):
        for key in text.keys() - known:
            self.report(place, f"unknown key {key}{similar(key, known)}")

    def add_entry(self, group, name, text):
        place = f"{group.name}.toml: {name}"
        function = self.functions.get(name)
        if function is None:
            self.report(place, f"nurbs.h has no such function{similar(name, self.functions)}")
            return
        self.check_keys(place, text, ENTRY_KEYS | set(model.LANGUAGES))
        for language in model.LANGUAGES:
            self.check_keys(f"{place}: {language}", text.get(language, {}), LANGUAGE_KEYS)
        group.entries.append(model.Entry(function, group, text, by_hand=text.get("by_hand", "")))

    def add_record(self, group, key, text):
        fields = {name: value for name, value in text.items()
                  if name not in RECORD_KEYS and name not in model.LANGUAGES}
        place = f"{group.name}.toml: [{key}]"
        for name in text.get("defaults", {}).keys() - fields.keys():
            self.report(place, f"defaults: there is no field {name}{similar(name, fields)}")
        for language in model.LANGUAGES:
            self.check_keys(f"{place}: {language}", text.get(language, {}), RECORD_LANGUAGE_KEYS)
        if "doc" not in text and "by_hand" not in text:
            self.report(place, "needs doc")
        if key in self.records:
            self.report(place, f"is also in {self.records[key].group.name}.toml")
        options = {language: text[language] for language in model.LANGUAGES if language in text}
        record = model.Record(key, group, text.get("doc", ""), fields, text.get("defaults", {}), text.get("from", {}),
                              options, text.get("struct", ""), text.get("of_splines", 0), text.get("by_hand", ""))
        self.records[key] = record
        group.all_records.append(record)

    # Entries.

    def add_methods(self, entry):
        place = f"{entry.group.name}.toml: {entry.name}"
        if entry.text.get("watched"):
            self.add_watched(entry, place)
        for language in model.LANGUAGES:
            if entry.by_hand or entry.option(language, "by_hand"):
                continue
            lines = entry.option(language, "call")
            if lines is None:
                self.report(place, f"needs call = \"...\", or {language}.call, or by_hand = \"where\"")
                continue
            for line in lines if isinstance(lines, list) else [lines]:
                self.add_method(entry, language, line, place)

    def add_method(self, entry, language, line, place):
        try:
            maker = methods.Maker(entry, language, self.manual, self.records, self.general)
            entry.methods.setdefault(language, []).append(maker.method(line))
        except (signature.SignatureError, extents.ExtentError, methods.MethodError) as error:
            own = "call" in entry.text.get(language, {})
            self.report(f"{place}: {language + '.' if own else ''}call", str(error))

    def add_watched(self, entry, place):
        """nurbs_X_with has the parameters of nurbs_X and one more, which stands last or before a new handle. Where that
        would be too many it takes structs, and the core of each language has a function with all of them."""
        name = f"{entry.name}_with"
        form = self.functions.get(name)
        if form is None:
            self.report(place, f"watched: nurbs.h has no function {name}")
            return
        own = [(parameter.c_type, parameter.name) for parameter in entry.function.parameters]
        others = [(parameter.c_type, parameter.name) for parameter in form.parameters]
        end = len(own) - (own[-1][1] == "out")
        wanted = [*own[:end], ("const nurbs_call_options *", "call"), *own[end:]]
        entry.packed = others != wanted and len(wanted) > MOST_PARAMETERS
        if others != wanted and not entry.packed:
            self.report(place, f"watched: {name} has to have the parameters of {entry.name}, and "
                               "const nurbs_call_options *call last or before out")
            return
        entry.watched = form

    # All of it.

    def check_complete(self, groups):
        entries = {}
        for group in groups:
            for entry in group.entries:
                if entry.name in entries:
                    self.report(f"{group.name}.toml: {entry.name}", f"is also in {entries[entry.name]}.toml")
                entries[entry.name] = group.name
        watched = {entry.watched.name for group in groups for entry in group.entries if entry.watched}
        for function in self.manual.functions:
            if function.name not in entries.keys() | watched:
                self.report(f"nurbs.h: {function.name}", self.advice(function.name))
        for record in self.records.values():
            if not record.uses and not record.struct and not record.splines:
                self.report(f"{record.group.name}.toml: [{record.key}]", "no call uses it")

    def advice(self, name):
        """Of a function that is nowhere."""
        base = name.removesuffix("_with")
        if base != name and base in self.functions:
            return (f"has no entry in {FOLDER}; if it is {base} with call options, put watched = true into the entry of "
                    f"{base}")
        return f"has no entry in {FOLDER}: add [{name}] with call = \"...\" to a file there"
