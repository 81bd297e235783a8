# SPDX-License-Identifier: MIT
"""The modules: which methods go where, what they use, and the types."""

import re
from dataclasses import dataclass

import header

from . import everything
from .passing import takes_structs
from .procedures import procedures
from .statements import STEP, comment, listed, statement
from .words import TYPES as NUMBERS
from .words import Words, literal

FOLDER = "capi/bindings/fortran"
SOURCES = "capi/bindings/table"
NOTICE = f"Generated from {header.PATH} and {SOURCES} by: {header.COMMAND} - do not edit."
CONVENTIONS = "Conventions: see the module nurbs."


@dataclass(frozen=True)
class Type:
    """A type with methods, by the module that it is in."""

    name: str
    extends: str
    doc: str
    shown: bool = True  # to programs


TYPES = {
    "inspection": Type("nurbs_inspected", "nurbs_handle", "A handle that can be asked what it is.", False),
    "evaluation": Type("nurbs_shape", "nurbs_inspected", "A handle that can be evaluated.", False),
    "splines": Type("nurbs_spline", "nurbs_shape", "A spline; an assignment makes another handle on the same data."),
    "lists": Type("nurbs_list", "nurbs_list_handle",
                  "Splines with names: parts of one, or what a file held, with notes on the rest. A list cannot be copied."),
    "fittings": Type("nurbs_statistics", "nurbs_statistics_handle",
                     "What fits need to know of data; an assignment makes another handle on the same sums."),
    "faces": Type("nurbs_face", "nurbs_face_handle", "A trimmed face; an assignment makes another handle on the same face."),
    "models": Type("nurbs_model", "nurbs_model_handle",
                   "Faces and the edges that they share, in parts; an assignment makes another handle on the same model."),
    "meets": Type("nurbs_meet", "nurbs_meet_handle",
                  "Curves where shapes meet; an assignment makes another handle on the same curves."),
    "meshes": Type("nurbs_mesh", "nurbs_mesh_handle",
                   "Triangles in place of shapes; an assignment makes another handle on the same triangles."),
}
#: Where names of other modules come from.
HOMES = {"nurbs_calls": r"nurbs_call\b",
         "nurbs_handles": r"nurbs_handle\b|nurbs_list_handle|nurbs_statistics_handle|nurbs_face_handle|nurbs_model_handle|"
                          r"nurbs_meet_handle|nurbs_mesh_handle|handles_of|as_many",
         **{f"nurbs_{module}": rf"\b{kind.name}\b" for module, kind in TYPES.items()}}


def files(binding):
    """{path: text}"""
    words = Words(binding)
    modules = {}
    for method in binding.methods("fortran"):
        modules.setdefault(home(method), []).append(method)
    made = in_order([Module(name, methods, binding, words) for name, methods in modules.items()])
    texts = {f"{FOLDER}/nurbs_{module.name}.f90": module.text() for module in made}
    watched = any(entry.watched for entry in binding.entries)
    texts[f"{FOLDER}/nurbs.f90"] = everything.module(made, NOTICE, watched)
    texts[f"{FOLDER}/nurbs_all.f90"] = everything.includes(made, NOTICE, watched)
    return texts


def in_order(modules):
    """Each after the types that it uses."""
    types = [module for name in TYPES for module in modules if module.name == name]
    return types + [module for module in modules if module not in types]


def home(method):
    """The module of a method."""
    return method.entry.option("fortran", "module", method.entry.group.file("fortran"))


@dataclass
class Module:
    name: str
    methods: list
    binding: object
    words: object

    def __post_init__(self):
        self.type = TYPES.get(self.name)

    def owner(self, method):
        """The type that a method belongs to, or "" of a procedure for everybody."""
        return self.type.name if method.receiver else ""

    def text(self):
        body = "\n".join(self.body())
        lines = ["! SPDX-License-Identifier: MIT", f"! {NOTICE}", *comment(f"{self.doc()} {CONVENTIONS}", 0),
                 f"module nurbs_{self.name}", *self.uses(body), f"{STEP}implicit none", f"{STEP}private",
                 *listed("public ::", self.public(), 1), "", body, f"end module nurbs_{self.name}"]
        return "\n".join(lines) + "\n"

    def doc(self):
        groups = [group for group in self.binding.groups if group.file("fortran") == self.name]
        return " ".join([self.words.notes.get(self.name) or groups[0].doc])

    def uses(self, body):
        yield f"{STEP}use, intrinsic :: iso_c_binding"
        yield f"{STEP}use nurbs_constants"
        yield from statement(f"use nurbs_c, only: {', '.join(self.functions(body))}", 1)
        yield f"{STEP}use nurbs_support"
        yield from (f"{STEP}use {module}" for module, names in HOMES.items()
                    if module != f"nurbs_{self.name}" and re.search(names, body))

    def functions(self, body):
        """What the module needs of nurbs_c: compilers take long to go through all of it again and again."""
        structs = [struct.name for struct in self.binding.manual.structs if f"type({struct.name})" in body]
        entries = [method.entry for method in self.methods]
        watched = [entry.watched.name for entry in entries if entry.watched and not takes_structs(entry)]
        return dict.fromkeys([*(entry.name for entry in entries), *watched, *structs])

    def public(self):
        return [method.name for method in self.methods if not self.owner(method)]

    def records(self):
        groups = dict.fromkeys(method.entry.group.name for method in self.methods)
        return [record for group in self.binding.groups if group.name in groups
                for record in group.records("fortran") if record.uses.get("fortran")]

    def body(self):
        for record in self.records():
            yield from self.record(record)
        if self.type:
            yield from self.own_type()
        yield "contains"
        yield from self.procedures()

    # Types.

    def record(self, record):
        name, first = record.name("fortran"), record.options.get("fortran", {}).get("initial", {})
        yield from comment(record.doc, 1)
        yield f"{STEP}type, public :: {name}"
        for field, text, value, pattern in record.members("fortran"):
            size = f"({self.elements(value, pattern)})" if self.elements(value, pattern) else ""
            yield (f"{STEP * 2}{NUMBERS[value.base]} :: {field}{size} = {literal(first.get(field, 0), value)} "
                   f"! {text.rstrip('.')}")
        yield f"{STEP}end type {name}"
        yield ""

    def elements(self, value, pattern):
        """How many a field has, 0 for a number; fields of rows are numbers."""
        if pattern.last:
            return pattern.last - pattern.first
        fixed = len(value.extents) == 1 and value.extents[0].op == "number"
        return value.extents[0].name if fixed else 0

    def own_type(self):
        methods = [method for method in self.methods if self.owner(method)]
        made = {method.name: procedures(method, self.type.name, self.words) for method in methods}
        several = {name: [procedure.name for procedure in found] for name, found in made.items() if len(found) > 1}
        single = [bound(name, found[0].name) for name, found in made.items() if len(found) == 1]
        yield from comment(self.type.doc, 1)
        yield f"{STEP}type, extends({self.type.extends}), public :: {self.type.name}"
        yield f"{STEP}contains"
        yield from listed("procedure ::", single, 2)
        yield from listed("procedure, private ::", [name for names in several.values() for name in names], 2)
        yield from (f"{STEP * 2}generic :: {name} => {', '.join(names)}" for name, names in several.items())
        yield f"{STEP}end type {self.type.name}"
        yield ""

    # Procedures.

    def procedures(self):
        group = None
        several = len({method.entry.group.name for method in self.methods}) > 1
        for method in self.methods:
            if several and method.entry.group is not group:
                yield from ["", *comment(method.entry.group.doc.rstrip("."), 1, "! ")]
            group = method.entry.group
            if method.entry.section:
                yield from ["", f"{STEP}! {method.entry.section}"]
            for procedure in procedures(method, self.owner(method), self.words):
                yield ""
                yield from procedure.lines()


def bound(name, procedure):
    return name if name == procedure else f"{name} => {procedure}"
