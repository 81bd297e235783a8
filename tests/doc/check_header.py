"""Every function of nurbs.h is documented in the uniform way that generators of bindings read.

usage: check_header.py nurbs.h

A function has \\brief and \\since, a \\param with its direction for every parameter and for no other, \\return unless it is
void, and for every array the shape in brackets. Parameters described by reference ("a,b,c as for nurbs_create()") take
their shape from the function referred to. Handles, options, paths and single results are not arrays.
"""

import re
import sys
from dataclasses import dataclass, field

HANDLES = ("nurbs", "nurbs_list")
STRUCTS = ("nurbs_read_options",)
# Pointers to one value that is written; arrays have names in the plural.
SINGLE_RESULTS = ("angle", "area", "at_least", "at_most", "axes", "bound", "complete", "content", "convexity",
                  "count", "curvature_gap", "degree", "deviation", "dim", "entity_type", "entries", "error", "factor",
                  "form", "gap", "geometric", "index", "knot", "length", "line", "metres", "moved", "openness",
                  "optimality", "order", "periodic", "position_gap", "proven", "rank", "ratio", "rational", "reason",
                  "removed", "result", "shape", "size", "slots", "status", "type", "value", "volume", "weight")


@dataclass
class Function:
    name: str
    result: str
    parameters: list  # (type, name)
    comment: str
    described: dict = field(default_factory=dict)  # name -> (direction, text)


def functions(text):
    pattern = r"/\*\*((?:(?!\*/).)*)\*/\s*NURBS_API\s+([^;(]*?)(\w+)\s*\(([^)]*)\)\s*;"
    for comment, result, name, parameters in re.findall(pattern, text, flags=re.DOTALL):
        comment = re.sub(r"^\s*\* ?", "", comment, flags=re.MULTILINE)
        yield Function(name, result.strip(), [parameter(p) for p in parameters.split(",") if p.strip() != "void"],
                       comment, descriptions(comment))


def parameter(text):
    kind, name = re.fullmatch(r"\s*(.*?[\s*])(\w+)\s*", text, flags=re.DOTALL).groups()
    return " ".join(kind.replace("*", " *").split()), name


def descriptions(comment):
    found = {}
    for direction, names, text in re.findall(
            r"\\param\[(in|out|in,out)\]\s+(\S+)\s*((?:(?!\n\\).)*)", comment, flags=re.DOTALL):
        for name in names.split(","):
            found[name] = (direction, " ".join(text.split()))
    return found


def pointed_to(kind):
    """Type that a pointer points to, without const; None for a value or a pointer to a pointer."""
    return kind.replace("const", "").replace("*", "").strip() if kind.count("*") == 1 else None


def is_array(kind, name):
    target = pointed_to(kind)
    if target is None or target in HANDLES or target in STRUCTS or name == "path":
        return False
    return "const" in kind or name not in SINGLE_RESULTS


def shape_of(function, name, by_name, seen=()):
    _, text = function.described[name]
    if text.startswith("["):
        return text[:text.index("]") + 1]
    reference = re.match(r"(?:a full knot vector, )?as for (nurbs_\w+)\(\)", text)
    if reference and reference[1] not in seen and reference[1] in by_name:
        other = by_name[reference[1]]
        if name in other.described:
            return shape_of(other, name, by_name, seen + (function.name,))
    return None


def parameter_problems(function, by_name):
    names = [name for _, name in function.parameters]
    for name in function.described:
        if name not in names:
            yield f"\\param {name} is not a parameter"
    for kind, name in function.parameters:
        if name not in function.described:
            yield f"no \\param for {name}"
            continue
        direction, text = function.described[name]
        if not text:
            yield f"\\param {name} says nothing"
        written = "*" in kind and "const" not in kind and name != "g" and name != "list"
        if written != (direction != "in"):
            yield f"\\param {name} is marked {direction}"
        if is_array(kind, name) and shape_of(function, name, by_name) is None:
            yield f"no shape in brackets for the array {name}"


def problems(function, by_name):
    for tag in ("brief", "since") + (() if function.result == "void" else ("return",)):
        if not re.search(rf"\\{tag}\s+\S", function.comment):
            yield f"no \\{tag}"
    yield from parameter_problems(function, by_name)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        text = file.read()
    found = list(functions(text))
    by_name = {function.name: function for function in found}
    messages = [f"{function.name}: {problem}" for function in found for problem in problems(function, by_name)]
    declared = len(re.findall(r"^NURBS_API ", text, flags=re.MULTILINE))
    if declared != len(found) or not found:
        messages.append(f"{declared} functions are declared, {len(found)} of them with a comment before them")
    print("\n".join(messages) or f"{len(found)} functions are documented")
    return 1 if messages else 0


if __name__ == "__main__":
    sys.exit(main())
