# SPDX-License-Identifier: MIT
"""The good calls of tests/capi/calls/*.toml as data, for generators of tests in any language.

    model = calls_reader.read(manual, top)     manual: what header.read(top) gives

    model.arrays             {name: (Number, ...)}, arrays that several calls share
    model.texts              {name: text or bytes}, the contents of files
    model.inputs             {name: Input}, splines and lists, in an order in which they can be made
    model.groups             {name: [Call, ...]}, a group for each file: "data", "evaluation", ...
    model.calls()            the calls of all groups

    call.name                "eval surface": the function without nurbs_, and words that tell its calls apart
    call.function            header.Function
    call.arguments           [(header.Parameter, value), ...] in the order of the header
    call.value("params")     one of them
    call.result              Slot of the answer of a function that returns no status and not nothing, otherwise None
    call.made                names of the inputs that are made for this call alone, each after those that it needs
    call.can_do_without      whether it may succeed though memory ran out: what it wanted memory for was a buffer

An input whose `shared` is true is made once, and all calls are given the same one; the others are made for each call that
needs them, and destroyed after it. Both are made by a call without outputs but the new handle: input.call.

A value is one of these:

    Number       an argument that is a number
    Numbers      an array of numbers that the function reads
    Handle       an input; consumed if the parameter is not const, as that of nurbs_destroy() is
    Handles      an array of inputs
    Items        an array of the splines of a list: as many as it says, from the first one on
    Bytes, Path  the contents of a text, and the path of a file that holds it
    Struct       a struct of nurbs.h: as its function NURBS_..._init leaves it, but for the fields given
    Packed       a struct of nurbs.h with arrays; what is not given is 0
    NewStruct    a struct that the function fills, StructSize its size
    NewHandle    where a new handle goes: "out" (the first one), "other" (the second one), "list", "statistics", "face",
                 "model", "meet" or "mesh"
    Slot         where other outputs go: an array of the test's struct Output, the first element, and how many elements
                 the function may write there by its shape, strides included
    Null         NULL

Numbers are exact: Python's int and float are what the table has, and repr() of a float gives it back.
"""

from dataclasses import dataclass, field

FOLDER = "tests/capi/calls"
# The arrays of the struct Output, for the types of outputs, and their lengths.
ARRAYS = {"double": "values", "float": "singles", "int64_t": "spans", "int32_t": "states", "nurbs_status": "states",
          "char": "text", "void": "text"}
LENGTHS = {"values": 1024, "singles": 64, "spans": 64, "states": 64, "text": 128}


class CallsError(Exception):
    """What is wrong with the calls, one line for each problem."""


@dataclass(frozen=True)
class Null:
    pass


@dataclass(frozen=True)
class Number:
    value: int | float
    constants: str = ""  # "NURBS_START", "NURBS_A | NURBS_B": if it was written so


@dataclass(frozen=True)
class Numbers:
    values: tuple  # of Number
    name: str = ""  # in model.arrays, if it is one of those


@dataclass(frozen=True)
class Handle:
    name: str


@dataclass(frozen=True)
class Handles:
    names: tuple


@dataclass(frozen=True)
class Items:
    list: str
    count: int


@dataclass(frozen=True)
class Bytes:
    text: str


@dataclass(frozen=True)
class Path:
    text: str


@dataclass(frozen=True)
class Struct:
    type: str
    fields: tuple  # (name, Number)


@dataclass(frozen=True)
class Packed:
    type: str
    fields: tuple  # (header.Field, value)


@dataclass(frozen=True)
class NewStruct:
    type: str


@dataclass(frozen=True)
class StructSize:
    type: str


@dataclass(frozen=True)
class NewHandle:
    place: str


@dataclass(frozen=True)
class Slot:
    array: str
    first: int
    length: int


@dataclass
class Call:
    name: str
    function: object
    arguments: list = field(default_factory=list)
    result: object = None
    made: list = field(default_factory=list)
    can_do_without: bool = False

    def value(self, parameter):
        return next(value for entry, value in self.arguments if entry.name == parameter)


@dataclass
class Input:
    name: str
    kind: str  # "nurbs", "nurbs_list", ...
    shared: bool
    call: Call


@dataclass
class Model:
    arrays: dict = field(default_factory=dict)
    texts: dict = field(default_factory=dict)
    inputs: dict = field(default_factory=dict)
    groups: dict = field(default_factory=dict)

    def calls(self):
        return [call for group in self.groups.values() for call in group]


def encoded(text):
    return text.encode() if isinstance(text, str) else text


def inputs_of(value):
    """Names of the inputs in a value."""
    if isinstance(value, Handle):
        return [value.name]
    if isinstance(value, Items):
        return [value.list]
    return list(value.names) if isinstance(value, Handles) else []
