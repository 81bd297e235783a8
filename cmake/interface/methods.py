# SPDX-License-Identifier: MIT
"""Makes methods of the lines of an entry: finds the parameters behind the names, and what each of them is for."""

import difflib
import re

import extents
import model
import signature
from signature import Argument, By, Each, Several, Struct, Take


class MethodError(Exception):
    """A call does not suit its function."""


KINDS = {"nurbs": "spline", "nurbs_list": "list", "nurbs_statistics": "statistics", "nurbs_face": "face",
         "nurbs_model": "model", "nurbs_meet": "meet", "nurbs_mesh": "mesh"}


def similar(name, names):
    """; did you mean ...?"""
    close = difflib.get_close_matches(name, list(names), 1)
    return f"; did you mean {close[0]}?" if close else ""


class Maker:
    """Of one entry in one language."""

    def __init__(self, entry, language, manual, records, general):
        self.entry, self.language, self.manual = entry, language, manual
        self.records, self.general = records, general
        self.values = {parameter.name: self.value(parameter) for parameter in entry.function.parameters}
        self.note_strides()
        self.note_extents()

    # Parameters.

    def value(self, parameter):
        value = model.Value(parameter, self.kind(parameter))
        value.truth = value.is_output and parameter.name in self.general.get("truths", ())
        value.unsigned = value.is_output and parameter.name in self.general.get("unsigned", ())
        value.index = parameter.name in self.general.get("indices", ())
        return value

    def kind(self, parameter):
        name, base, pointers = parameter.name, parameter.base, parameter.pointers
        if base in self.manual.handles:
            if pointers == 2 and parameter.is_const:
                return "splines" if base == "nurbs" else "handles"
            return KINDS[base]
        if base == "char":
            return "texts" if pointers == 2 else "text" if parameter.direction == "out" else "path"
        if base in {struct.name for struct in self.manual.structs}:
            return "options"
        if base == "void":
            return "bytes"
        if name == "cap" or (name in ("count", "entries", "length") and pointers and "cap" in self.names()):
            return "cap" if name == "cap" else "count"
        return "array" if pointers and parameter.shape else "number"

    def names(self):
        return [parameter.name for parameter in self.entry.function.parameters]

    def note_strides(self):
        owner = None
        for value in self.values.values():
            name = value.name
            if not name.endswith("_stride"):
                owner = value
                continue
            value.kind = "component_stride" if name.endswith("_component_stride") else "stride"
            value.of = owner.name
            owner.strides += 1

    def note_extents(self):
        where = self.entry.text.get("where", {})
        shapes = {**self.entry.text.get("shape", {}), **self.entry.text.get(self.language, {}).get("shape", {})}
        numbers = {value.name for value in self.values.values()
                   if value.kind in ("number", "cap") and not value.is_output}
        arrays = {value.name for value in self.values.values() if value.kind == "array"}
        splines = [value.name for value in self.values.values()
                   if value.kind in ("spline", "splines", "statistics", "face") and not value.is_output
                   or value.base == "nurbs_data"]
        reader = extents.Reader(numbers, arrays, splines, where)
        for name in shapes.keys() - self.values.keys():
            raise MethodError(f"shape.{name}: there is no parameter {name}")
        for value in self.values.values():
            shape = shapes.get(value.name, value.parameter.shape)
            if value.kind in ("array", "splines", "handles", "texts", "bytes") and shape:
                value.extents = reader.shape(shape)
        self.definitions = {name: reader.term(text) for name, text in where.items() if name in numbers}

    # Methods.

    def method(self, line):
        parsed = signature.parse(self.whole(line))
        arguments = tuple(self.argument(argument) for argument in parsed.arguments)
        method = model.Method(self.entry, self.language, parsed.receiver, parsed.name, arguments, None, self.values,
                              self.definitions)
        method.result = self.result(parsed, method)
        if self.language == "rust" and "call" not in self.entry.text.get("rust", {}) or "(" not in line:
            self.receive(method)
        self.check(method)
        self.note_uses(method)
        return method

    def whole(self, line):
        """A name alone stands for the call of all languages under that name."""
        if "(" in line:
            return line
        return re.sub(r"^(\w+\.)?\w+\(", rf"\g<1>{line}(", self.entry.text["call"])

    def receive(self, method):
        """In Rust a function whose first argument is a spline is its method, and one that makes a spline belongs to
        the type; in that case the second of two splines a and b is called other."""
        first = method.arguments[0] if method.arguments else None
        if method.receiver or self.language != "rust":
            return
        if first and isinstance(first.pattern, Take) and self.values[first.pattern.name].kind == "spline":
            method.receiver = first.pattern.name
            method.arguments = tuple(Argument("other", argument.pattern) if argument.name == "b" else argument
                                     for argument in method.arguments[1:])
        elif method.made:
            method.receiver = "Spline"

    # Patterns.

    def argument(self, argument):
        pattern = self.complete(argument.pattern, False)
        default = argument.default
        if default is None and argument.optional and self.language != "cpp":
            default = self.default_of(argument.pattern)
        return Argument(argument.name, pattern, argument.optional, argument.allocated, default)

    def default_of(self, pattern):
        """What the call of all languages has for a parameter."""
        if not isinstance(pattern, Take) or "call" not in self.entry.text:
            return None
        for argument in signature.parse(self.entry.text["call"]).arguments:
            if argument.pattern == pattern:
                return argument.default
        return None

    def complete(self, pattern, is_result):
        """The pattern with all fields of its records, each with a name."""
        if isinstance(pattern, Take):
            self.require(pattern.name)
            return pattern
        if isinstance(pattern, Struct):
            return self.struct(pattern, is_result)
        if isinstance(pattern, Several):
            return Several(pattern.bracket, tuple(self.complete(item, is_result) for item in pattern.items))
        if isinstance(pattern, By):
            self.require(pattern.counts)
            return By(pattern.counts, self.complete(pattern.item, is_result))
        return Each(self.complete(pattern.item, is_result))

    def require(self, name):
        if name not in self.values:
            raise MethodError(f"the function has no parameter {name}{similar(name, self.values)}")

    def struct(self, pattern, is_result):
        record = self.records.get(pattern.record)
        if record is None:
            raise MethodError(f"there is no record [{pattern.record}]{similar(pattern.record, self.records)}")
        if record.struct:
            return Take(next(value.name for value in self.values.values() if value.base == record.struct))
        fields = pattern.fields or tuple(self.usual_fields(record))
        names = [name or self.name_in_order(record, place, inner) for place, (name, inner) in enumerate(fields)]
        for name in names:
            if name not in record.fields:
                raise MethodError(f"[{record.key}] has no field {name}{similar(name, record.fields)}")
        return Struct(record.key, tuple((name, self.complete(inner, is_result))
                                        for name, (_, inner) in zip(names, fields)))

    def name_in_order(self, record, place, pattern):
        if isinstance(pattern, Take) and pattern.name in record.fields:
            return pattern.name
        return list(record.fields)[place]

    def usual_fields(self, record):
        """Each field from the parameter of its name; those that the function does not have are left out."""
        made = [value.name for value in self.values.values() if value.kind in model.HANDLES and value.is_output]
        for name in record.fields:
            source = record.sources.get(name, name)
            if name in ("spline", "splines") and made:
                source = made[0]
            if source in self.values:
                yield name, Take(source)

    def result(self, parsed, method):
        """Where the line says nothing: what the function makes, unless an argument receives it."""
        if parsed.result:
            return self.complete(parsed.result, True)
        made = [value.name for value in method.made if value.name not in method.given]
        if made and parsed.receiver != made[0] and self.language != "fortran":
            return Take(made[0])
        return None

    # Checks.

    def check(self, method):
        if method.receiver not in ("", "out", *model.HANDLES.values(), *self.values):
            raise MethodError(f"the function has no parameter {method.receiver} that could be the receiver")
        self.check_arguments(method)
        self.check_results(method)
        self.check_numbers(method)

    def check_arguments(self, method):
        seen = set()
        for argument in method.arguments:
            for name in signature.taken(argument.pattern):
                if name in seen and self.language != "fortran":
                    raise MethodError(f"{name} is given twice")
                seen.add(name)
            outputs = [self.values[name] for name in signature.taken(argument.pattern) if self.values[name].is_output]
            if outputs and self.language != "fortran":
                raise MethodError(f"{outputs[0].name} is an output: it belongs after ->")
            if any(value.parameter.direction == "out" for value in outputs) and argument.default is not None:
                raise MethodError(f"{argument.name} is an output and cannot have a default")
        for value in method.left_out:
            if not value.nullable:
                raise MethodError(f"nobody gives {value.name}, which must not be NULL")

    def check_results(self, method):
        received = {*method.given, *method.returned, method.receiver}
        for value in self.values.values():
            passing = value.kind in ("count", "cap") or method.receiver == "out" and value in method.made
            passing = passing or value.nullable and value.name in self.entry.text.get("unreturned", ())
            if value.is_output and value.name not in received and not passing and self.language != "fortran":
                raise MethodError(f"the output {value.name} is in no result")

    def check_numbers(self, method):
        for value in method.computed:
            if value.name in method.definitions or method.sources(value.name):
                continue
            raise MethodError(f"nobody gives {value.name}, and no array that is given has that length; "
                              f"make it an argument, or define it: where.{value.name} = \"...\"")

    def note_uses(self, method):
        for argument in method.arguments:
            self.note_use(method, argument.pattern, False)
        if method.result:
            self.note_use(method, method.result, True)

    def note_use(self, method, pattern, is_result):
        if isinstance(pattern, Struct):
            record = self.records[pattern.record]
            record.uses.setdefault(self.language, []).append((method, pattern, is_result))
        for inner in inner_patterns(pattern):
            self.note_use(method, inner, is_result)


def inner_patterns(pattern):
    if isinstance(pattern, Struct):
        return [inner for _, inner in pattern.fields]
    if isinstance(pattern, Several):
        return pattern.items
    return [pattern.item] if isinstance(pattern, (Each, By)) else []
