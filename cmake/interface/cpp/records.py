# SPDX-License-Identifier: MIT
"""C++ structs: results, settings, arrays of the caller that are filled, options of nurbs.h; and constants."""

import model
from signature import Struct, Take

from . import words


def lines(record, binding):
    if record.splines:
        yield from words.comment(record.doc)
        yield f"using {record.key} = std::array<Spline, {record.splines}>;"
    elif record.struct:
        yield from (options(record) if record.has_defaults(binding.manual) else answers(record))
    else:
        yield from struct(record, binding)
        if record.outputs("cpp"):
            yield from outputs(record)


def struct(record, binding):
    yield from words.comment(record.doc)
    yield f"struct {record.name('cpp')} {{"
    is_input = not any(is_result for _, _, is_result in record.uses["cpp"])
    for name, text, value, pattern in record.members("cpp"):
        start = initial(record, name) if is_input else ""
        yield from member(f"    {member_type(value, pattern, binding)} {name}{start};", words.text(text))
    yield "};"


def member(line, text):
    """With its comment behind it, or before it where the line would be too long."""
    if len(f"{line} ///< {text}") <= words.WIDTH:
        yield f"{line} ///< {text}"
    else:
        yield from words.comment(text, "    ")
        yield line


def initial(record, name):
    """ = 1, or {} for an array; nothing for what the caller has to give."""
    if name not in record.defaults:
        return ""
    value = record.defaults[name]
    return "{}" if value == "{}" else f" = {words.default(value)}"


def member_type(value, pattern, binding):
    if isinstance(pattern, Struct):
        return pattern.record
    if isinstance(pattern, Take) and pattern.last:
        return words.array_of(words.SCALARS[value.base], [pattern.last - pattern.first])
    if value.kind in model.HANDLES:
        return model.HANDLES[value.kind]
    if value.kind == "options":
        return words.struct_type(value, binding)
    if value.kind == "text":
        return "std::string"
    if value.kind == "array":
        return words.owned(value)
    return words.scalar(value)


def outputs(record):
    """Arrays of the caller."""
    yield ""
    name = record.outputs("cpp")
    required = [field for field, _, value, _ in record.members("cpp") if not value.nullable]
    needed = f", {' and '.join(required)} excepted" if required else ""
    yield from words.comment(f"Where they are written. An output without elements is not wanted{needed}.")
    yield f"struct {name} {{"
    for field, _, value, _ in record.members("cpp"):
        kind = words.RECORDS[value.base][1] if value.strides else f"std::span<{words.SCALARS[value.base]}>"
        yield f"    {kind} {field}{'{}' if value.nullable else ''};"
    yield "};"


def options(record):
    """Each library says the size that it knows, and none that of another: the constructor is always inlined."""
    yield from words.comment(f"{record.doc} Later versions of this header may know more of them: where libraries that were "
                             "compiled with two versions meet in one program, each has to say its own size, and none the "
                             "other's.")
    yield f"struct {record.key} : {record.struct} {{"
    yield f"    [[gnu::always_inline]] {record.key}() : {record.struct}{{}} {{"
    yield f"        detail::call({record.struct}_init, this, static_cast<std::int64_t>(sizeof({record.struct})));"
    yield "    }"
    yield "};"


def answers(record):
    """A struct that the library fills."""
    yield from words.comment(record.doc)
    yield f"struct {record.key} : {record.struct} {{"
    yield f"    [[gnu::always_inline]] {record.key}() noexcept : {record.struct}{{}} {{"
    yield f"        struct_size = static_cast<std::int64_t>(sizeof({record.struct}));"
    yield "    }"
    yield "};"


def constants(prefix, text, binding):
    yield from words.comment(text)
    for name, constant in binding.manual.constants.items():
        if name.startswith(prefix):
            kind = "std::uint32_t" if binding.is_unsigned(constant) else "std::int32_t"
            yield f"inline constexpr {kind} {words.constant(name)} = {name};"
