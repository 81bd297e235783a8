# SPDX-License-Identifier: MIT
"""C++ functions and member functions, as lines."""

import model
from signature import Several, Struct

from . import parameters, words
from .body import Body


def lines(method, binding):
    """All forms of a method, with comments."""
    fills = method.entry.fills("cpp")
    yield from form(method, binding, fills, False, method.entry.doc("cpp", method))
    if fills:
        several = isinstance(method.result, Struct)
        yield from returning_form(method, binding, False, f"The same, as {'vectors' if several else 'a vector'}.")
    if method.entry.watched:
        yield from watched(method, binding, fills)


def watched(method, binding, fills):
    yield from form(method, binding, fills, True, "The same; `call` can watch and end it.")
    if fills:
        yield from returning_form(method, binding, True, "The same; `call` can watch and end it.")


def form(method, binding, fills, is_watched, doc):
    body = Body(method, binding, is_watched)
    result = "void" if fills else returned(method)
    yield from function(method, binding, result, fills, is_watched, doc, body.filling() if fills else body.returning())


def returning_form(method, binding, is_watched, doc):
    body = Body(method, binding, is_watched)
    yield from function(method, binding, returned(method), False, is_watched, doc, body.filled())


def function(method, binding, result, fills, is_watched, doc, body):
    texts = parameters.listed(method, binding, fills, not is_watched)
    if is_watched:
        texts.append("const CallOptions &call")
    before, after = around(method, result)
    yield from words.comment(doc)
    yield f"{before}Returned<{result}> {method.name}({', '.join(texts)}){after} {{"
    yield from body
    yield "}"


def around(method, result):
    """What stands before and behind the declaration: a member function of an object, of a class, or a free function."""
    heeded = "" if result == "void" else "[[nodiscard]] "
    if method.receiver in method.values:
        return heeded, " const"
    if method.receiver:
        return f"{heeded if method.receiver != 'Spline' else ''}static ", ""
    return f"{heeded if method.entry.fills('cpp') else ''}inline ", ""


def returned(method):
    """Type of the result."""
    if method.result is None:
        return "void"
    if isinstance(method.result, Struct):
        return method.result.record
    if isinstance(method.result, Several):
        return "std::pair<Spline, Spline>"
    value = method.values[method.result.name]
    if value.kind in model.HANDLES:
        return model.HANDLES[value.kind]
    if value.kind == "text":
        return "std::string"
    return words.owned(value) if value.kind == "array" else words.scalar(value)
