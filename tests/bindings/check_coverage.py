#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the bindings with nurbs.h: every function with its arguments, every constant with its value.

    check_coverage.py [TOP]     TOP is the folder of the project
"""

import ast
import pathlib
import re
import sys

TOP = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
TOP = TOP if TOP.is_dir() else TOP.parents[2]
BINDINGS = TOP / "capi/bindings"

PYTHON_LETTERS = {"int32_t": "i", "nurbs_status": "i", "int64_t": "l", "uint32_t": "u", "double": "d"}
RUST_TYPES = {"int32_t": "i32", "int64_t": "i64", "uint32_t": "u32", "double": "f64", "float": "f32", "char": "c_char",
              "void": "c_void"}
FORTRAN_TYPES = {"int32_t": "integer(c_int32_t)", "uint32_t": "integer(c_int32_t)", "int64_t": "integer(c_int64_t)",
                 "nurbs_status": "integer(c_int32_t)", "double": "real(c_double)", "float": "real(c_float)",
                 "char": "character(kind=c_char)", "nurbs_read_options": "type(nurbs_read_options)"}
# Fortran does not tell the constant from the function nurbs_version.
FORTRAN_NAMES = {"NURBS_VERSION": "NURBS_HEADER_VERSION"}

problems = []


def expect(condition, *words):
    if not condition:
        problems.append(" ".join(str(word) for word in words))


def read(*paths):
    return "\n".join(path.read_text() for path in sorted(paths))


def without_comments(text):
    return re.sub(r"/\*.*?\*/|//[^\n]*", " ", text, flags=re.S)


# --- the header ---


def header_functions(text):
    """{name: (result, [(type, name)])}, types without spaces around stars."""
    functions = {}
    for result, name, arguments in re.findall(r"NURBS_API ([^;()]*?)(\w+)\(([^)]*)\);", text):
        words = [] if arguments == "void" else arguments.split(",")
        pairs = [re.fullmatch(r"(.*?)(\w+)", word.strip(), re.S) for word in words]
        functions[name] = (plain(result), [(plain(pair[1]), pair[2]) for pair in pairs])
    return functions


def plain(c_type):
    return re.sub(r"\s*\*", "*", " ".join(c_type.split()))


def bare(c_type):
    """The type without pointers and qualifiers, of "const nurbs*const*" for an array of handles too."""
    return re.sub(r"\bconst\b|\*", "", c_type).strip()


def header_constants(text):
    enumerated = re.findall(r"(NURBS_\w+)\s*=\s*(\d+)", text)
    defined = re.findall(r"#define (NURBS_[A-Z_]+)[ \\\n]+(0x[0-9a-fA-F]+|\d+)u?\s", text)
    constants = {name: int(value, 0) for name, value in enumerated + defined}
    part = [constants[f"NURBS_VERSION_{which}"] for which in ("MAJOR", "MINOR", "PATCH")]
    return constants | {"NURBS_VERSION": part[0] * 10000 + part[1] * 100 + part[2]}


def header_macros(text):
    return [name for name in re.findall(r"#define (NURBS_\w+)\(", text)]


# --- the bindings ---


def check_constants(language, wanted, found):
    for name, value in wanted.items():
        expect(name in found, language, "lacks the constant", name)
        expect(found.get(name, value) == value, language, name, "is", found.get(name), "and not", value)
    for name in sorted(found.keys() - wanted.keys()):
        expect(False, language, "has a constant that the header lacks:", name)


def check_cpp(functions, constants, macros):
    text = without_comments(read(TOP / "include/nurbs/nurbs.hpp", *(TOP / "include/nurbs/cpp").glob("*.hpp")))
    for name in [*functions, *constants, *macros]:
        expect(re.search(rf"\b{name}\b", text), "C++ lacks", name)


def evaluated(expression, names):
    """The value of an integer expression of the binding's own language, all of which read as Python here."""
    expression = re.sub(r"int\(z'([0-9a-f]+)', c_int32_t\)", r"0x\1", expression)
    return eval(expression, {"__builtins__": {}}, dict(names))  # noqa: S307 - the project's own files


def fortran_constants(text):
    found = {}
    for line in text.replace("&\n", " ").split("\n"):
        if "parameter ::" in line:
            for name, value in re.findall(r"(NURBS_\w+) = (int\([^)]*\)|[^,]+)", line):
                found[name] = evaluated(value.strip(), found)
    return found


def fortran_type(c_type):
    """Type of a dummy argument, and whether it is passed by value."""
    base = bare(c_type)
    if base in ("nurbs", "nurbs_list", "void"):
        return "type(c_ptr)", c_type.count("*") < 2
    return FORTRAN_TYPES[base], "*" not in c_type


def fortran_dummies(body):
    dummies = {}
    for attributes, names in re.findall(r"^ *([^!\n]*?) :: (.*)$", body, re.M):
        parts = attributes.split(", ")
        for name in names.split(","):
            dummies[name.strip().replace("(*)", "")] = (parts[0], "value" in parts)
    return dummies


def check_fortran(functions, constants, macros):
    folder = BINDINGS / "fortran"
    text = re.sub(r" *& *\n *", " ", (folder / "nurbs_c.f90").read_text())
    wanted = {FORTRAN_NAMES.get(name, name): value for name, value in constants.items()}
    check_constants("Fortran", wanted, fortran_constants((folder / "nurbs_constants.f90").read_text()))
    for name, (_, arguments) in functions.items():
        kind = "(?:function|subroutine)"
        match = re.search(rf"{kind} {name}\(([^)]*)\) bind\(c\)(.*?)end {kind}", text, re.S)
        expect(match, "Fortran lacks", name)
        if match:
            names = [word.strip() for word in match[1].split(",") if word.strip()]
            expect(names == [n for _, n in arguments], "Fortran:", name, "has the arguments", names)
            dummies = fortran_dummies(match[2])
            for c_type, argument in arguments:
                expect(dummies.get(argument) == fortran_type(c_type), "Fortran:", name, argument, dummies.get(argument))
    thin = read(*folder.glob("*.f90")).lower()
    for name in macros:
        expect(f"function {name.lower()}(" in thin, "Fortran lacks", name)


def python_prototypes(path):
    for node in ast.parse(path.read_text()).body:
        if isinstance(node, ast.Assign) and node.targets[0].id == "PROTOTYPES":
            return ast.literal_eval(node.value)
    return {}


def check_python(functions, constants, macros):
    folder = BINDINGS / "python/nurbs"
    namespace = {}
    exec((folder / "constants.py").read_text(), namespace)  # noqa: S102 - the project's own file
    check_constants("Python", constants, {k: v for k, v in namespace.items() if k.startswith("NURBS_")})
    for name in macros:
        expect(callable(namespace.get(name[6:].lower())), "Python lacks", name)
    prototypes = python_prototypes(folder / "_library.py")
    code = read(*(path for path in folder.glob("*.py")))
    for name, (result, arguments) in functions.items():
        head = {"void": "v", "const char*": "s"}.get(result) or PYTHON_LETTERS[result]
        letters = "".join(PYTHON_LETTERS.get(c_type, "p") for c_type, _ in arguments)
        expect(prototypes.get(name) == f"{head} {letters}", "Python:", name, "has the prototype", prototypes.get(name))
        expect(f"lib.{name}" in code, "Python does not use", name)


def rust_type(c_type):
    base = bare(c_type)
    one = "*const " if "const" in c_type else "*mut "
    stars = one * c_type.count("*")
    return stars + RUST_TYPES.get(base, base)


def check_rust(functions, constants, macros):
    source = BINDINGS / "rust/src"
    text = without_comments((source / "sys.rs").read_text())
    found = {}
    for name, value in re.findall(r"pub const (NURBS_\w+): \w+ =\s*([^;]+);", text):
        found[name] = evaluated(" ".join(value.split()), found)
    check_constants("Rust", constants, found)
    safe = read(*(path for path in source.glob("*.rs") if path.name != "sys.rs"))
    for name in macros:
        expect(f"fn {name[6:].lower()}(" in safe, "Rust lacks", name)
    for name, (result, arguments) in functions.items():
        match = re.search(rf"pub fn {name}\(([^)]*)\)(?:\s*-> ([^;]+))?;", text)
        expect(match, "Rust lacks", name)
        words = [word.strip().removeprefix("r#") for word in match[1].split(",")] if match else []
        pairs = [tuple(word.split(": ")) for word in words if word]
        expect(pairs == [(n, rust_type(t)) for t, n in arguments], "Rust:", name, "has the arguments", pairs)
        returned = "c_void" if match and not match[2] else match and match[2]
        expect(not match or returned == rust_type(result), "Rust:", name, "returns", returned)
        expect(re.search(rf"\bsys::{name}\b", safe), "Rust does not use", name)


def main():
    text = without_comments((TOP / "include/nurbs/nurbs.h").read_text())
    header = header_functions(text), header_constants(text), header_macros(text)
    expect(len(header[0]) == text.count("NURBS_API nurbs") + text.count("NURBS_API void")
           + text.count("NURBS_API int") + text.count("NURBS_API const"), "a function of the header was not understood")
    for check in (check_cpp, check_fortran, check_python, check_rust):
        check(*header)
    print("\n".join(problems) or f"{len(header[0])} functions and {len(header[1])} constants are in every binding")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
