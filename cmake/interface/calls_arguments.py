# SPDX-License-Identifier: MIT
"""The arguments of one good call: those of the table, and the others by rule.

    reader = ArgumentReader(manual, model, function, entry, outputs)
    reader.arguments()      [(header.Parameter, value), ...], see calls_model.py
    reader.result()         the slot of the function's answer
    reader.problems         what is wrong with the entry

The rules are those of README.md in tests/capi/calls.
"""

import re

import calls_model
from calls_model import (Bytes, CallsError, Handle, Handles, Items, NewHandle, NewStruct, Null, Number, Numbers, Packed, Path,
                         Slot, Struct, StructSize, inputs_of)
from calls_terms import Facts, Sizes, extent
from extents import Term
from shapes import Shapes

SETTINGS = {"without", "can_do_without"}  # of an entry, beside the arguments
INTEGERS = ("int32_t", "int64_t", "uint32_t", "nurbs_status")
ZERO = re.compile(r"(\w+_)?stride|flags|budget")  # what is 0 unless the entry says something else


class ArgumentReader:
    def __init__(self, manual, model, function, entry, outputs):
        """outputs: whether those are wanted that can be NULL."""
        self.manual, self.model, self.function = manual, model, function
        self.given = {key: value for key, value in entry.items() if key not in SETTINGS}
        self.without = set(entry.get("without", []))
        self.outputs = outputs
        self.shapes = Shapes(function)
        self.sizes = Sizes(self.argument, model.inputs)
        self.structs = {struct.name for struct in manual.structs}
        self.problems = []
        self.values = {}
        self.used = dict.fromkeys(calls_model.LENGTHS, 0)
        self.places = {"nurbs": ["out", "other"], "nurbs_list": ["list"], "nurbs_statistics": ["statistics"],
                       "nurbs_face": ["face"], "nurbs_model": ["model"],
                       "nurbs_meet": ["meet"], "nurbs_mesh": ["mesh"]}

    def arguments(self):
        self.check_names()
        for entry in self.function.parameters:
            self.attempt(entry, self.input_value)
        self.add_numbers()
        for index, entry in enumerate(self.function.parameters):
            if entry.name not in self.values and not self.problems:
                self.attempt(entry, lambda entry, index=index: self.output_value(entry, index))
        self.check_lengths()
        return [(entry, self.values.get(entry.name)) for entry in self.function.parameters]

    def result(self):
        if self.function.result in ("nurbs_status", "void"):
            return None
        base = "char" if "char" in self.function.result else self.function.result
        length = calls_model.LENGTHS["text"] if base == "char" else 1
        return self.slot(base, length)

    def attempt(self, entry, find):
        try:
            value = find(entry)
        except CallsError as error:
            self.problems.append(f"{entry.name}: {error}")
            return
        if value is not None:
            self.values[entry.name] = value

    def check_names(self):
        names = [entry.name for entry in self.function.parameters]
        for key in self.given.keys() - set(names):
            self.problems.append(f"{self.function.name} has no parameter {key}; it has {', '.join(names)}")
        optional = {entry.name for entry in self.function.parameters if entry.nullable and entry.direction != "in"}
        for key in self.without - optional:
            self.problems.append(f"without {key}, which is no output that may be NULL")

    # Inputs.

    def input_value(self, entry):
        """The value of an input; none for outputs, and for numbers that may follow from arrays."""
        if entry.direction == "out" or entry.direction == "in,out":
            if entry.name in self.given:
                raise CallsError("is an output, which goes to a place of its own")
            return None
        if entry.name in self.given:
            return self.given_value(entry, self.given[entry.name])
        if entry.pointers:
            if not entry.nullable or entry.base == "nurbs" and not entry.is_const:
                raise CallsError("is needed")
            return Null()
        if entry.name == "struct_size":
            return StructSize(self.function.parameters[0].base)
        return Number(0) if ZERO.fullmatch(entry.name) else None

    def given_value(self, entry, value):
        if entry.base in self.manual.handles:
            return self.handles(entry, value) if entry.pointers == 2 else self.handle(entry, value)
        if entry.base in self.structs:
            return self.struct(entry.base, value)
        if entry.base in ("void", "char"):
            return (Bytes if entry.base == "void" else Path)(self.one_of(value, self.model.texts, "text"))
        if not entry.pointers:
            return self.number(value, entry.base)
        return self.numbers(value, entry.base)

    def one_of(self, name, known, what):
        if name not in known:
            raise CallsError(f"{name!r} is no {what} of inputs.toml, which has {', '.join(known)}")
        return name

    def input_named(self, name, kind):
        what = "spline" if kind == "nurbs" else kind.removeprefix("nurbs_")
        return self.one_of(name, [key for key, value in self.model.inputs.items() if value.kind == kind], what)

    def handle(self, entry, value):
        name = self.input_named(value, entry.base)
        if not entry.is_const and self.model.inputs[name].shared:
            raise CallsError(f"is destroyed by the call, but {name} is shared")
        return Handle(name)

    def handles(self, entry, value):
        """Of several splines, by their names, or those of a list."""
        if isinstance(value, list):
            return Handles(tuple(self.input_named(name, entry.base) for name in value))
        count = re.fullmatch(r"\[(\d+)\]", entry.shape)
        if not count:
            raise CallsError(f"the number {entry.shape} of splines does not follow from a list: give their names")
        return Items(self.input_named(value, "nurbs_list"), int(count[1]))

    def struct(self, name, value):
        fields = {entry.name: entry for struct in self.manual.structs if struct.name == name for entry in struct.fields}
        for key in value.keys() - fields.keys():
            raise CallsError(f"{name} has no field {key}; it has {', '.join(sorted(fields))}")
        if any(entry.pointers and entry.shape for entry in fields.values()):
            return Packed(name, tuple(self.member(entry, value) for entry in fields.values()
                                      if entry.name in value or entry.name == "struct_size"))
        return Struct(name, tuple((key, Number(number)) for key, number in value.items()))

    def member(self, entry, value):
        if entry.name == "struct_size":
            return entry, StructSize(self.holder(entry))
        given = value[entry.name]
        return entry, self.numbers(given, entry.base) if entry.pointers else self.number(given, entry.base)

    def holder(self, entry):
        return next(struct.name for struct in self.manual.structs if any(field is entry for field in struct.fields))

    def number(self, value, base):
        if isinstance(value, str):
            return Number(self.constants(value), value)
        wanted = int if base in INTEGERS else (int, float)
        if isinstance(value, bool) or not isinstance(value, wanted):
            raise CallsError(f"{value!r} is no {base}")
        return Number(value)

    def constants(self, text):
        total = 0
        for name in text.split(" | "):
            if name not in self.manual.constants:
                raise CallsError(f"there is no constant {name}")
            total |= self.manual.constants[name].value
        return total

    def numbers(self, value, base):
        """An array: its numbers, the name of one, or "circle.knots", that of an input's call."""
        if isinstance(value, list):
            return Numbers(tuple(self.number(number, base) for number in value))
        name, dot, parameter = str(value).partition(".")
        if not dot:
            return Numbers(self.model.arrays[self.one_of(name, self.model.arrays, "array")], name)
        call = self.model.inputs[self.one_of(name, self.model.inputs, "input")].call
        given = {entry.name: of for entry, of in call.arguments if isinstance(of, Numbers)}
        if parameter not in given:
            raise CallsError(f"{name} is made without an array {parameter}; it has {', '.join(given)}")
        return given[parameter]

    # Numbers that follow from arrays.

    def add_numbers(self):
        """Each from an array whose first index goes up to it; [n] before [n][dim], where dim may have to follow first."""
        missing = [entry for entry in self.function.parameters if not entry.pointers and entry.name not in self.values]
        for _ in missing:
            for entry in missing:
                if entry.name not in self.values and entry.base in INTEGERS and entry.name not in self.given:
                    self.attempt(entry, self.number_of_records)
        for entry in missing:
            if entry.name not in self.values and entry.name not in self.given:
                self.problems.append(f"{entry.name}: is needed")

    def number_of_records(self, entry):
        for array in self.function.parameters:
            length = self.length(self.values.get(array.name))
            if length is None or not array.shape:
                continue
            first, *behind = self.shapes.terms(array.shape)
            if first != Term("parameter", entry.name):
                continue
            try:
                width = self.sizes.product(behind)
            except KeyError:  # another number has to be known first
                continue
            if length % width != 0:
                raise CallsError(f"{array.name} has {length} numbers, no multiple of {width}: {array.shape}")
            return Number(length // width)
        return None

    def length(self, value):
        """How many elements an array has, or None."""
        if isinstance(value, Numbers):
            return len(value.values)
        if isinstance(value, Handles):
            return len(value.names)
        return len(calls_model.encoded(self.model.texts[value.text])) if isinstance(value, Bytes) else None

    def argument(self, name):
        """What a term of a shape is given; numbers of pieces that only the call tells are those of the spline."""
        if name in self.shapes.arrays and self.shapes.arrays[name].direction == "out":
            spline = self.values[next(iter(self.shapes.splines))].name
            facts = Facts(spline, self.model.inputs[spline].call)
            return Numbers(tuple(Number(facts.spans(axis)) for axis in range(len(facts.degrees))))
        return self.values[name]

    def extent(self, index):
        """The number of elements of an array, strides included."""
        records, width = map(self.sizes.product, self.shapes.parts(self.function.parameters[index].shape))
        return extent(records, width, *(self.values[name].value for name in self.shapes.strides(index)))

    def check_lengths(self):
        for index, entry in enumerate(self.function.parameters):
            length = self.length(self.values.get(entry.name))
            if length is not None and entry.shape and not self.problems:
                self.attempt(entry, lambda entry, index=index, length=length: self.check_length(entry, index, length))

    def check_length(self, entry, index, length):
        wanted = self.extent(index)
        if length != wanted:
            raise CallsError(f"has {length} elements, but {entry.shape} asks for {wanted} here")

    # Outputs.

    def output_value(self, entry, index):
        if entry.name in self.without or entry.nullable and not self.outputs:
            return Null()
        if entry.base in self.structs and entry.direction == "in,out":
            fields = next(struct.fields for struct in self.manual.structs if struct.name == entry.base)
            return Packed(entry.base, ((fields[0], StructSize(entry.base)),))
        if entry.base in self.structs:
            return NewStruct(entry.base)
        if entry.base in self.manual.handles:
            return NewHandle(self.places[entry.base].pop(0))
        if not self.outputs:
            raise CallsError("cannot be NULL, so that this call can make no input")
        return self.slot(entry.base, self.extent(index) if entry.shape else 1)

    def slot(self, base, length):
        array = calls_model.ARRAYS[base]
        first = self.used[array]
        self.used[array] += length
        if self.used[array] > calls_model.LENGTHS[array]:
            raise CallsError(f"with {length} elements the outputs do not fit into Output::{array}")
        return Slot(array, first, length)
