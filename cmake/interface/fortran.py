# SPDX-License-Identifier: MIT
"""Fortran: the constants, and interface blocks for every function."""

import re

import header
import layout

FOLDER = "capi/bindings/fortran"
WIDTH = 110
CONTINUATION = " " * 12
NUMBERS = {"int32_t": "integer(c_int32_t)", "uint32_t": "integer(c_int32_t)", "nurbs_status": "integer(c_int32_t)",
           "int64_t": "integer(c_int64_t)", "double": "real(c_double)", "float": "real(c_float)",
           "char": "character(kind=c_char)"}
# Fortran does not tell the constant NURBS_VERSION from the function nurbs_version.
RENAMED = {"NURBS_VERSION": "NURBS_HEADER_VERSION"}

CONSTANTS_HEAD = f"""\
! SPDX-License-Identifier: MIT
! {header.NOTICE}
!> The constants of nurbs.h, with its names and values. NURBS_VERSION is called NURBS_HEADER_VERSION, because Fortran
!> does not tell it from the function nurbs_version.
module nurbs_constants
    use, intrinsic :: iso_c_binding, only: c_int32_t
    implicit none
    public
"""

C_HEAD = f"""\
! SPDX-License-Identifier: MIT
! {header.NOTICE}
!> The functions of nurbs.h as they stand, argument by argument; that header is the manual. Here the indices of axes,
!> spans and list entries count from 0, flags are 32-bit patterns, and the optional arguments are those that may be
!> NULL. Outputs other than handles are intent(inout) because a failing call leaves them as they were.
module nurbs_c
    use, intrinsic :: iso_c_binding
    implicit none
    public
"""


# Constants.


def literal(constant):
    hexadecimal = re.fullmatch(r"0x([0-9a-fA-F]+)u?", constant.literal)
    if hexadecimal:
        return f"int(z'{hexadecimal[1]}', c_int32_t)"
    return constant.literal.strip("()")


def constant_lines(constant):
    name = RENAMED.get(constant.name, constant.name)
    line = f"    integer(c_int32_t), parameter :: {name} = {literal(constant)}"
    if len(line) > WIDTH:
        line = f"    integer(c_int32_t), parameter :: {name} = &\n        {literal(constant)}"
    return layout.with_comment(line, "!", constant.text, WIDTH)


def constants(manual):
    lines = [CONSTANTS_HEAD]
    for group in manual.groups:
        lines += layout.comment("    ! --- ", group.title, WIDTH)
        lines += [line for constant in group.constants for line in constant_lines(constant)]
        lines.append("")
    return "\n".join(lines) + "end module nurbs_constants\n"


# Functions.


def attributes(manual, parameter):
    """Type and attributes of a dummy argument."""
    texts = parameter.base == "char" and parameter.pointers == 2
    handle = texts or parameter.base in manual.handles or parameter.base == "void"
    if handle and parameter.pointers < 2:
        return "type(c_ptr), value"
    if parameter.pointers == 0:
        return f"{NUMBERS[parameter.base]}, value"
    kind = "type(c_ptr)" if handle else NUMBERS.get(parameter.base, f"type({parameter.base})")
    intent = "in" if parameter.is_const else "out" if handle else "inout"
    return f"{kind}, intent({intent})" + (", optional" if parameter.nullable else "")


def is_array(parameter):
    """Zero-terminated texts are arrays too, without a shape; bytes of any kind are passed by their address."""
    return parameter.base == "char" or bool(parameter.shape) and parameter.base != "void"


def declarations(manual, function):
    """One line for all arguments of the same attributes."""
    named = {}
    for parameter in function.parameters:
        name = parameter.name + ("(*)" if is_array(parameter) else "")
        named.setdefault(attributes(manual, parameter), []).append(name)
    for kind, names in named.items():
        yield from broken(f"{CONTINUATION}{kind} :: " + ", ".join(names))


def result_type(function):
    return "type(c_ptr)" if "*" in function.result else NUMBERS[function.result]


def broken(line):
    """A statement in lines that are short enough, cut at spaces."""
    lines = []
    while len(line) > WIDTH:
        cut = line.rindex(" ", 0, WIDTH - 1)
        lines.append(line[:cut] + " &")
        line = CONTINUATION + "    " + line[cut + 1:]
    return [*lines, line]


def interface(manual, function):
    kind = "subroutine" if function.result == "void" else "function"
    names = ", ".join(parameter.name for parameter in function.parameters)
    suffix = "" if kind == "subroutine" else " result(r)"
    yield from layout.comment("        !> ", function.brief, WIDTH)
    yield from broken(f"        {kind} {function.name}({names}) bind(c){suffix}")
    yield f"{CONTINUATION}import"
    yield from declarations(manual, function)
    if kind == "function":
        yield f"{CONTINUATION}{result_type(function)} :: r"
    yield f"        end {kind} {function.name}"


def field_type(manual, entry):
    if entry.base in manual.callbacks:
        return "type(c_funptr)"
    return "type(c_ptr)" if entry.pointers else NUMBERS[entry.base]


def structure(manual, struct):
    yield from layout.comment("    !> ", struct.text, WIDTH)
    yield f"    type, bind(c) :: {struct.name}"
    for entry in struct.fields:
        yield from layout.with_comment(f"        {field_type(manual, entry)} :: {entry.name}", "!", entry.described, WIDTH)
    yield f"    end type {struct.name}"
    yield ""


def functions(manual):
    lines = [C_HEAD]
    for struct in manual.structs:
        lines += structure(manual, struct)
    lines.append("    interface")
    for module in manual.modules:
        lines += layout.comment("        ! --- ", module.title, WIDTH)
        lines += [line for function in module.functions for line in interface(manual, function)]
    return "\n".join(lines) + "\n    end interface\nend module nurbs_c\n"


FILES = {f"{FOLDER}/nurbs_constants.f90": constants, f"{FOLDER}/nurbs_c.f90": functions}
