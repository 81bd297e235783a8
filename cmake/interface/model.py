# SPDX-License-Identifier: MIT
"""What the backends turn into text: groups of entries, each with one method for each language, and records.

    binding.groups             in the order of the files: Group
    group.entries              in the order of the table: Entry, one for each function of nurbs.h
    group.records(language)    the structs that belong to it: Record
    entry.methods[language]    Method; several where a language has overloads, none where it is by hand
    method.arguments           what the caller gives, in order; patterns of signature.py whose leaves are parameters
    method.result              the pattern of what comes back, or None
    method.values              {parameter of the C function: Value}, in the order of the C function
    method.computed            numbers that the caller does not give: method.definitions[name], a term, or else
    method.sources(name)       the arrays that are given and have the number in their shapes
"""

from dataclasses import dataclass, field

import signature

LANGUAGES = ("cpp", "rust", "fortran")
#: Kinds of handles, and the types that own them: in C++ and Rust the name, in Fortran nurbs_ and the kind.
HANDLES = {"spline": "Spline", "list": "List", "statistics": "Statistics", "face": "Face", "model": "Model",
           "meet": "Meet", "mesh": "Mesh"}


@dataclass
class Value:
    """A parameter of a C function and its part in a call.

    kind   "spline", "list", "statistics", "face", "model", "meet", "mesh": a handle; "splines", "handles": an array of those of splines,
           of others;
           "number"; "array" of numbers, also with strides; "stride", "component_stride": of the array `of`; "text":
           characters; "path": a zero-terminated text; "texts": an array of those; "bytes"; "options": a struct; "count": how much there is for the
           parameter cap, "cap" itself
    """

    parameter: object  # header.Parameter
    kind: str
    extents: tuple = ()  # terms of extents.py, of arrays
    strides: int = 0  # how many parameters with strides follow: 0, 1 or 2
    of: str = ""
    truth: bool = False  # an answer of yes or no
    index: bool = False  # counts axes, control points, ...: from 1 in Fortran
    unsigned: bool = False  # a sum of bits in a signed output

    @property
    def name(self):
        return self.parameter.name

    @property
    def base(self):
        """The C type of an element."""
        return self.parameter.base

    @property
    def is_output(self):
        return self.parameter.direction != "in"

    @property
    def nullable(self):
        return self.parameter.nullable

    @property
    def is_counted(self):
        """Whether its length is known after a first call with cap = 0 only."""
        return any("cap" in extent.names() for extent in self.extents)


@dataclass
class Record:
    """A struct. Which of the fields a language has follows from the first method that uses it there."""

    key: str
    group: object
    doc: str
    fields: dict  # name -> text
    defaults: dict = field(default_factory=dict)  # name -> value; such a record is an input
    sources: dict = field(default_factory=dict)  # name -> parameter, where they differ
    options: dict = field(default_factory=dict)  # language -> {"name": ..., "outputs": ..., "rename": {...}}
    struct: str = ""  # the struct of nurbs.h that it holds
    splines: int = 0  # it is an array of so many splines
    by_hand: str = ""
    uses: dict = field(default_factory=dict)  # language -> [(method, signature.Struct, whether it is a result)]

    def name(self, language):
        return self.options.get(language, {}).get("name", self.key)

    def outputs(self, language):
        """The name of the struct of arrays of the caller that are filled, or ""."""
        return self.options.get(language, {}).get("outputs", "")

    def is_used(self, language):
        return bool(self.uses.get(language)) or self.struct != "" or self.splines > 0

    def has_defaults(self, manual):
        """Whether a function of nurbs.h fills the struct that it holds; if not, all of it is answers."""
        return f"{self.struct}_init" in {function.name for function in manual.functions}

    def renamed(self, language, name):
        return self.options.get(language, {}).get("rename", {}).get(name, name)

    def members(self, language):
        """(name, text, value, pattern) of each field, as the first method that uses it has them."""
        method, use, _ = self.uses[language][0]
        for name, pattern in use.fields:
            value = method.values[pattern.name] if isinstance(pattern, signature.Take) else None
            yield self.renamed(language, name), self.fields[name], value, pattern


@dataclass
class Method:
    entry: object
    language: str
    receiver: str  # "g": the parameter whose method it is; "out": what it makes; "Spline": a class; ""
    name: str
    arguments: tuple  # of signature.Argument, records with all their fields
    result: object
    values: dict = field(default_factory=dict)  # {name: Value}
    definitions: dict = field(default_factory=dict)  # {name of a number that the caller does not give: Term}

    @property
    def given(self):
        """Names of the parameters that the caller gives or that receive results, in the order of the arguments."""
        return [name for argument in self.arguments for name in signature.taken(argument.pattern)]

    @property
    def returned(self):
        return list(signature.taken(self.result)) if self.result else []

    @property
    def made(self):
        """The outputs that are handles."""
        return [value for value in self.values.values() if value.kind in HANDLES and value.is_output]

    @property
    def is_counted(self):
        return any(value.is_counted for value in self.values.values())

    @property
    def computed(self):
        """Numbers that the C function takes and the caller does not give, without strides and cap."""
        own = {self.receiver, *self.given}
        return [value for value in self.values.values()
                if value.kind == "number" and not value.is_output and value.name not in own]

    @property
    def left_out(self):
        """Pointers that this method passes as NULL."""
        own = {self.receiver, *self.given}
        return [value for value in self.values.values()
                if not value.is_output and value.kind in ("array", "splines", "handles", "options", "path", "texts", "bytes", *HANDLES)
                and value.name not in own]

    def sources(self, name):
        """(array, place of the extent) of the arrays that are given whose shape has this number, in order of arguments;
        an extent that is more than the name, as [pieces + 1], comes last."""
        found = []
        for given in dict.fromkeys([*self.given, *self.returned]):
            value = self.values.get(given)
            for place, extent in enumerate(value.extents if value else ()):
                if name in extent.names():
                    found.append((value, place))
        return sorted(found, key=lambda source: (source[0].is_output, source[0].extents[source[1]].op != "parameter"))


@dataclass
class Entry:
    """A function of nurbs.h in the table."""

    function: object  # header.Function
    group: object
    text: dict  # the entry as it stands in the file
    methods: dict = field(default_factory=dict)  # language -> [Method]
    by_hand: str = ""
    watched: object = None  # header.Function: nurbs_X_with, the form of this one that takes nurbs_call_options
    packed: bool = False  # nurbs_X_with takes structs: the core has a function of that name with all arguments

    @property
    def name(self):
        return self.function.name

    @property
    def section(self):
        return self.text.get("section", "")

    def option(self, language, key, otherwise=None):
        """What a language says for itself, or what holds for all."""
        return self.text.get(language, {}).get(key, self.text.get(key, otherwise))

    def doc(self, language, method=None):
        """Its own text, that of all languages, or the first sentence of the header. Of overloads each may have one."""
        texts = self.option(language, "doc", self.function.brief)
        return texts if isinstance(texts, str) else texts[self.methods[language].index(method)]

    def fills(self, language):
        """Whether there is a second form that writes to arrays of the caller."""
        return language in self.text.get("into", [])


@dataclass
class Group:
    """A file of the table."""

    name: str
    text: dict
    entries: list = field(default_factory=list)
    all_records: list = field(default_factory=list)

    @property
    def doc(self):
        return self.text["doc"]

    def file(self, language):
        """The name of the file or module that it goes to, without folder and ending."""
        return self.text.get(language, self.name)

    @property
    def constants(self):
        """{prefix of constants of the header: text}"""
        return self.text.get("constants", {})

    def records(self, language):
        return [record for record in self.all_records if record.is_used(language) and not record.by_hand]


@dataclass
class Binding:
    manual: object  # header.Header
    groups: list
    general: dict = field(default_factory=dict)  # general.toml

    def is_unsigned(self, constant):
        """Whether it is one of bits, with the u in the header or not."""
        return constant.literal.endswith("u") or any(constant.name.startswith(name) for name in self.general["unsigned"])

    @property
    def entries(self):
        return [entry for group in self.groups for entry in group.entries]

    @property
    def all_records(self):
        return {record.key: record for group in self.groups for record in group.all_records}

    def methods(self, language):
        return [method for entry in self.entries for method in entry.methods.get(language, ())]
