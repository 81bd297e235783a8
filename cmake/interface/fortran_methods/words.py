# SPDX-License-Identifier: MIT
"""How C's types, shapes and default values are said in Fortran."""

import re

from table import TableError

TYPES = {"double": "real(c_double)", "float": "real(c_float)", "int32_t": "integer(c_int32_t)",
         "uint32_t": "integer(c_int32_t)", "nurbs_status": "integer(c_int32_t)", "int64_t": "integer(c_int64_t)"}


class Words:
    """What general.toml says of Fortran alone."""

    def __init__(self, binding):
        self.binding = binding
        own = binding.general["fortran"]
        self.stored, self.wide = own["stored"], own["wide"]
        self.narrow, self.assumed = own["narrow"], own["assumed"]
        self.notes = own["notes"]
        self.records = binding.all_records

    # Types.

    def is_index(self, value):
        return value.index and value.base in ("int32_t", "int64_t")

    def is_narrow(self, value):
        """Whether a number of 64 bits is a default integer in Fortran."""
        return value.base == "int64_t" and (value.name in self.narrow or not value.is_output and value.name not in self.wide)

    def type_of(self, value):
        if value.truth:
            return "logical"
        return TYPES["int32_t" if self.is_narrow(value) else value.base]

    # Shapes.

    def extents(self, value):
        """In Fortran's order: a column for each component, unless an array is taken as it is stored."""
        if value.name in self.stored:
            return tuple(reversed(value.extents))
        return value.extents[:1] + tuple(reversed(value.extents[1:]))

    def is_transposed(self, value):
        """Whether the library has the rows one after the other and cannot be told otherwise."""
        return len(value.extents) > 1 and value.strides == 0 and value.name not in self.stored

    def is_fixed(self, value):
        """Whether the dummy argument has a constant shape: the compiler sees to it."""
        constant = all(extent.op == "number" for extent in value.extents)
        return constant and not (value.name in self.assumed and not value.is_output)

    # Default values.

    def default(self, method, argument):
        """Of an optional number: that of the argument, or of the field of a record of C++."""
        text = argument.default if argument.default is not None else self.field_default(method, argument.pattern.name)
        if text is None:
            entry = method.entry
            raise TableError(f"{entry.group.name}.toml: {entry.name}: fortran.call: {argument.name} may be left out, but "
                             f"has no default: write {argument.name}? = ...")
        return text

    def field_default(self, method, parameter):
        for other in method.entry.methods.get("cpp", ()):
            for argument in other.arguments:
                for name, pattern in getattr(argument.pattern, "fields", ()):
                    if getattr(pattern, "name", "") == parameter:
                        return self.records[argument.pattern.record].defaults.get(name)
        return None


def literal(text, value):
    """A default value in Fortran: 0d0, full_turn, ior(A, B), -infinity()."""
    text = str(text)
    if " | " in text:
        return f"ior({', '.join(text.split(' | '))})"
    if re.fullmatch(r"-?\d+", text):
        return text + ("d0" if value.base == "double" else "")
    return text.replace("infinity", "infinity()")
