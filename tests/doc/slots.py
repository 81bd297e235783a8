# SPDX-License-Identifier: MIT
"""The arguments of a function, those in structs too, as the header describes them and ctypes passes them.

A field of a struct is what the parameter of its name is in the plain form of the function: nurbs_X of nurbs_X_with.
"""

import ctypes
from dataclasses import dataclass

INTEGERS = {"int32_t": ctypes.c_int32, "int64_t": ctypes.c_int64, "uint32_t": ctypes.c_uint32,
            "nurbs_status": ctypes.c_int32}
NUMBERS = {**INTEGERS, "double": ctypes.c_double, "float": ctypes.c_float}
BEYOND = 64  # bytes after the fields that are known, as a newer header would have them


@dataclass
class Slot:
    """A parameter, or a field of a struct that is passed and read."""

    entry: object
    holder: object = None  # the parameter that points to the struct
    twin: object = None  # what a field is in the plain form
    used: bool = True
    is_callback: bool = False

    @property
    def key(self):
        return f"{self.holder.name}.{self.entry.name}" if self.holder else self.entry.name

    @property
    def is_pointer(self):
        return self.entry.pointers > 0 or self.is_callback

    @property
    def nullable(self):
        """What the plain form requires is required, though other functions with the struct may do without."""
        return (self.twin or self.entry).nullable

    @property
    def direction(self):
        if not self.holder:
            return self.entry.direction
        array = self.entry.pointers > 0 and self.entry.base in NUMBERS and not self.entry.is_const
        answer = self.holder.direction != "in" and not self.is_pointer and self.entry.name != "struct_size"
        return "out" if array or answer else "in"


def struct_of(manual, entry):
    """The struct that a parameter points to, or None."""
    return next((struct for struct in manual.structs if struct.name == entry.base and entry.pointers == 1), None)


def fields(manual, function, holder):
    """Slots of a struct. It stands for parameters of the plain form if that has no such struct itself."""
    plain = manual.plain(function)
    twins = {entry.name: entry for entry in plain.parameters} if plain else {}
    replaces = plain and holder.name not in twins and holder.name != "call"
    for entry in struct_of(manual, holder).fields:
        twin = twins.get(entry.name) if replaces else None
        used = not replaces or twin is not None or entry.name == "struct_size"
        yield Slot(entry, holder, twin, used, entry.base in manual.callbacks)


def slots(manual, function):
    """Each struct stands before its fields."""
    for entry in function.parameters:
        yield Slot(entry)
        if struct_of(manual, entry) and entry.direction != "out":
            yield from fields(manual, function, entry)


def callback_type(manual, name):
    kinds = [ctypes.c_void_p if entry.pointers else NUMBERS[entry.base] for entry in manual.callbacks[name].parameters]
    return ctypes.CFUNCTYPE(NUMBERS[manual.callbacks[name].result], *kinds)


def struct_class(manual, struct, beyond=BEYOND):
    """As C lays it out, and room for fields that are not known."""
    def kind(entry):
        if entry.base in manual.callbacks:
            return callback_type(manual, entry.base)
        return ctypes.c_void_p if entry.pointers else NUMBERS[entry.base]

    known = [(entry.name, kind(entry)) for entry in struct.fields]
    return type(struct.name, (ctypes.Structure,), {"_fields_": [*known, ("beyond", ctypes.c_ubyte * beyond)]})


def known_size(kind):
    """sizeof a struct without what lies beyond."""
    return kind.beyond.offset


def put(made, slot, value):
    """Sets a field: to a number, a function, or the address of an array, which the caller keeps."""
    if value is None:
        value = type(getattr(made, slot.entry.name))() if slot.is_callback else None
    elif slot.entry.pointers:
        value = ctypes.addressof(value)
    elif not slot.is_callback:
        value = value.value
    setattr(made, slot.entry.name, value)


def passed(found, values):
    """The arguments of a call, for ctypes, of the values by the keys of their slots."""
    for slot in found:
        if slot.holder and values[slot.holder.name] is not None:
            put(values[slot.holder.name], slot, values[slot.key])
    arguments = [values[slot.key] for slot in found if not slot.holder]
    return [ctypes.byref(value) if isinstance(value, ctypes.Structure) else value for value in arguments]
