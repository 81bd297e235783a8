#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The smoke test of Python's package: every good call through its classes and functions, where their names and those of
their arguments are the ones of nurbs.h or of the table; see smoke_reference.cpp. The others are printed with what is unlike.
"""

import ctypes
import inspect
import re

import numpy

import smoke_table
from smoke_table import TYPES, show, text_of

import calls_model  # from the project, as calls_terms, smoke and table
import smoke
import table
from calls_model import Bytes, Handle, Handles, Items, Null, Number, Numbers, Packed, Path, Slot, Struct
from calls_terms import Sizes

import nurbs

# Names of arguments of the package: what they are called in nurbs.h.
INSTEAD = {"contents": ("bytes",), "curves": ("boundaries",), "end": ("end_a",), "other_end": ("end_b",), "center": ("origin",),
           "breaks": ("pieces",), "from_basis": ("from",), "to_basis": ("to",), "inner": ("f",),
           "lam": ("lambda",), "relative": ("relative_chord",)}
# What the package takes from the shapes of arrays, those of structs too.
IN_SHAPES = ("counts", "dim", "degrees", "break_counts", "n", "axes")
OWNERS = {"spline": nurbs.Spline, "list": nurbs.SplineList, "statistics": nurbs.Statistics, "face": nurbs.Face,
          "model": nurbs.Model, "meet": nurbs.Meet, "mesh": nurbs.Mesh}


class Unlike(Exception):
    """The package has another name or other arguments for a call."""


class Layer:
    """Names are those of nurbs.h, or those that the table has for C++ and Rust."""

    def __init__(self):
        self.model = smoke_table.model
        self.planner = smoke.Planner(table.read(smoke_table.manual, smoke_table.TOP), "cpp")
        self.handles = {}  # made of others that are before them
        for name, entry in self.model.inputs.items():
            if entry.shared:
                self.handles[name] = self.made(entry.call)

    def made(self, call):
        return LayerCall(self, call, self.planner.step(call)).run()


class LayerCall:
    def __init__(self, layer, call, step):
        if step is None:
            raise Unlike("no method")
        self.layer, self.call, self.step = layer, call, step
        self.values = step.method.values
        self.sizes = Sizes(step.given, layer.model.inputs)
        self.own = {name: layer.made(layer.model.inputs[name].call) for name in call.made}
        self.used = set()
        # What structs hold are arguments of the package.
        self.fields = {field.name: of for value in step.values.values() if isinstance(value, (Packed, Struct))
                       for field, of in smoke.fields_of(value, smoke_table.manual)}

    def handle(self, name):
        return self.own[name] if name in self.own else self.layer.handles[name]

    def run(self, progress=lambda done: None):
        receiver, function = self.function()
        if not callable(function):  # a property, of all axes
            return function[self.step.given("axis").value] if "axis" in self.values else function
        given, rest = {}, []
        for name, declared in inspect.signature(function).parameters.items():
            if self.parameter(name) and declared.kind is declared.VAR_POSITIONAL:
                rest = self.one_by_one(self.argument(name))
            elif self.parameter(name):
                given[name] = self.argument(name)
        missing = [name for name in [*self.step.method.given, *self.fields] if name not in self.used | {receiver, *IN_SHAPES}
                   and not isinstance(self.given(name), (Null, Packed, Struct)) and self.given(name) != Number(0)]
        if missing:
            raise Unlike(f"nothing takes {', '.join(missing)}")
        if self.step.watched:
            given["progress"] = progress
        return function(*rest, **given)

    def given(self, name):
        """The value of a parameter of the C function, or of a field of a struct."""
        return self.fields[name] if name in self.fields else self.step.given(name)

    def one_by_one(self, array):
        """What is given as several arguments: the parameters of each axis of a grid, or the elements."""
        self.used.add("counts")
        counts = self.numbers("counts")
        return numpy.split(array, numpy.cumsum(counts)[:-1]) if counts else list(array)

    def function(self):
        """The parameter whose method it is, and the function."""
        short = self.step.method.entry.name.removeprefix("nurbs_")
        methods = [method for language in ("cpp", "rust") for method in self.step.method.entry.methods.get(language, ())]
        names = [*(method.name for method in methods), short, re.sub("^(curve|surface|create|list)_", "", short),
                 re.sub("^mesh_(surface|face|model)(_levels)?$", r"mesh\2", short)]
        if short in ("surface_intersections", "face_intersections", "model_intersections"):  # of a curve with a surface
            names = ["meet"]
        if short == "surface_self_intersections":  # of curves there are others
            names = ["meet_itself"]
        if short == "mesh_triangles" and self.step.given("flags") == Number(0):
            names = ["vertex_triangles"]
        handles = [value for value in self.values.values() if value.kind in OWNERS and not value.is_output]
        made = OWNERS[next((value.kind for value in self.step.method.made), "spline")]
        owners = [self.values[method.receiver] for method in methods if self.values.get(method.receiver) in handles]
        if any(method.receiver in ("Face", "Model") for method in methods):  # a class method, whatever it is given
            return "", getattr(made, methods[0].name)
        first = next(iter([*owners, *handles]), None)
        names = [name for name in names if name != "count"]  # of a sequence: how often it holds something
        for name in names:
            if first is not None and hasattr(self.handle(self.step.given(first.name).name), name):
                return first.name, getattr(self.handle(self.step.given(first.name).name), name)
            owner = made if first is None and hasattr(made, name) else nurbs
            if hasattr(owner, name) and callable(getattr(owner, name)):
                return "", getattr(owner, name)
        if short in ("create", "statistics_create"):
            return "", made
        raise Unlike(f"nothing is called {' or '.join(dict.fromkeys(names))}")

    def parameter(self, name):
        """The parameter of nurbs.h behind an argument of Python, if it is given."""
        methods = [method for language in ("cpp", "rust") for method in self.step.method.entry.methods.get(language, ())]
        behind = {argument.name: getattr(argument.pattern, "name", "") for method in methods for argument in method.arguments}
        owner = next((method.receiver for method in methods if method.receiver), "")
        others = [value.name for value in self.values.values()
                  if value.kind == "spline" and not value.is_output and value.name != owner]
        behind.setdefault("other", others[-1] if others else "")
        found = next((each for each in (name, behind.get(name), *INSTEAD.get(name, ()))
                      if each in self.values or each in self.fields), "")
        return "" if not found or isinstance(self.given(found), (Null, Slot)) else found

    def argument(self, name):
        parameter = self.parameter(name)
        self.used.add(parameter)
        value, given = self.values.get(parameter), self.given(parameter)
        match given:
            case Number():
                return given.value
            case Numbers() if parameter in self.fields:
                return self.of_data(parameter, given)
            case Numbers():
                return self.array(value, given)
            case Handle():
                return self.handle(given.name)
            case Handles():
                return [self.handle(other) for other in given.names]
            case Items():
                return [self.handle(given.list)[i] for i in range(given.count)]
            case Bytes():
                return calls_model.encoded(self.layer.model.texts[given.text])
            case Path():
                return smoke_table.file(given.text)
        raise Unlike(f"what {parameter} is")

    def of_data(self, name, given):
        """An array of a struct; parameters and values have rows."""
        width = {"params": "axes", "values": "dim"}.get(name)
        numbers = numpy.array([item.value for item in given.values], dtype=float)
        return numbers.reshape(-1, self.fields[width].value) if width else numbers

    def numbers(self, name):
        given = self.step.given(name)
        return [item.value for item in given.values] if isinstance(given, Numbers) else []

    def by_axis(self, value, array):
        """Knots or breaks of several axes, one after the other."""
        degrees, counts = self.numbers("degrees"), self.numbers("counts")
        if value.name == "breaks" and self.numbers("break_counts"):
            return numpy.split(array, numpy.cumsum(self.numbers("break_counts"))[:-1])
        extent = value.extents[0] if value.extents else None
        if (self.step.method.made and extent and (extent.op, extent.name) == ("call", "sum")
                and len(counts) > 1):  # parameters of a grid
            return numpy.split(array, numpy.cumsum(counts)[:-1])
        if value.name != "knots" or len(degrees) < 2:
            return None
        ends = numpy.cumsum([degree + count + 1 for degree, count in zip(degrees, counts)])
        return numpy.split(array, ends[:-1])

    def net(self, value):
        """The shape of an array of the control points of a new spline, or nothing."""
        counts = self.numbers("counts") or [degree + 1 for degree in self.numbers("degrees")]
        of_data = bool(value.extents) and (value.extents[0].op, value.extents[0].name) == ("call", "product")
        if value.name not in ("points", "weights", "values") or not counts or not (self.step.method.made or of_data):
            return None
        return counts if value.name == "weights" else [*counts, -1]

    def array(self, value, given):
        kind = {"double": float, "int32_t": numpy.int32, "int64_t": numpy.int64, "uint32_t": numpy.uint32}[value.base]
        numbers = numpy.array([item.value for item in given.values], dtype=kind)
        if self.by_axis(value, numbers) is not None:
            return self.by_axis(value, numbers)
        if self.net(value):
            return numbers.reshape(self.net(value))
        if len(value.extents) < 2:
            return numbers
        sizes = self.sizes.of(value.extents)[1:]
        one = value.extents[-1].op == "property" and value.extents[-1].name == "axes" and sizes[-1] == 1
        return numbers if one and len(sizes) == 1 else numbers.reshape(-1, *sizes)

    # Results.

    def show(self):
        found = self.run()
        lines = list(self.lines(found))
        print(f"{self.call.name}|done|")
        for parameter, texts in lines:
            show(self.call.name, parameter, texts)

    def lines(self, found):
        if isinstance(found, tuple(OWNERS.values())):
            yield from self.handle_lines(self.step.method.made[0].name, found)
        elif hasattr(found, "_fields"):
            for field in found._fields:
                parameter = self.output(field)
                if parameter:
                    yield from self.value_lines(parameter, getattr(found, field))
        else:
            outputs = [value.name for value in self.values.values()
                       if value.is_output and value.kind not in ("count", *OWNERS)]
            if len(outputs) != 1:
                raise Unlike("what it returns")
            yield from self.value_lines(outputs[0], found)

    def output(self, field):
        """The parameter of nurbs.h behind a field of a result."""
        for language in ("cpp", "rust"):
            for method in self.step.method.entry.methods.get(language, ()):
                for name, pattern in getattr(method.result, "fields", ()):
                    if name == field and hasattr(pattern, "name") and not pattern.last:
                        return pattern.name
        return field if field in self.values and self.values[field].is_output else ""

    def value_lines(self, parameter, found):
        value = self.values[parameter]
        if isinstance(found, tuple(OWNERS.values())):
            yield from self.handle_lines(parameter, found)
        elif value.kind == "options":
            return  # structs are not printed by smoke_reference.cpp
        elif isinstance(found, str):
            yield parameter, [found]
        elif found is not None:
            yield parameter, [text_of(item, TYPES[value.base]) for item in flat(found)]

    def handle_lines(self, name, found):
        if isinstance(found, nurbs.SplineList):
            yield f"{name}.count", [str(len(found))]
            for i, spline in enumerate(found):
                yield from self.handle_lines(f"{name}[{i}]", spline)
            return
        if isinstance(found, nurbs.Statistics):
            yield f"{name}.bytes", map(str, found.to_bytes())
            return
        if isinstance(found, nurbs.Face):
            yield f"{name}.sizes", map(str, found.loops)
            for curve in (curve for loop in found.curves for curve in loop):
                yield from self.handle_lines(f"{name}.curves", curve)
            return
        if isinstance(found, nurbs.Model):
            yield f"{name}.counts", map(str, found.counts)
            for face in found.faces:
                yield from self.handle_lines(f"{name}.faces", face)
            for edge in found.edges:
                yield from self.handle_lines(f"{name}.edges", edge.spline)
            return
        if isinstance(found, nurbs.Mesh):
            yield f"{name}.points", [text_of(x, ctypes.c_double) for x in numpy.ravel(found.points)]
            yield f"{name}.corners", map(str, numpy.ravel(found.vertex_triangles))
            return
        if isinstance(found, nurbs.Meet):
            yield f"{name}.nodes", map(str, found.nodes.kinds)
            for i in range(found.counts.branches):
                for curve in found.branch(i):
                    yield from self.handle_lines(f"{name}.branches", curve)
            return
        yield f"{name}.degrees", map(str, found.degrees)
        yield f"{name}.knots", [text_of(x, ctypes.c_double) for knots in found.knots for x in knots]
        yield f"{name}.points", [text_of(x, ctypes.c_double) for x in numpy.ravel(found.homogeneous_points)]


def flat(found):
    """All elements, those of arrays in tuples too."""
    if isinstance(found, numpy.ndarray):
        yield from found.ravel()
    elif isinstance(found, (tuple, list)):
        for item in found:
            yield from flat(item)
    else:
        yield found


def main():
    through = Layer()
    for call in smoke_table.model.calls():
        try:
            LayerCall(through, call, through.planner.step(call)).show()
        except Unlike as error:
            print(f"{call.name}|by hand|{error}")


if __name__ == "__main__":
    main()
