# SPDX-License-Identifier: MIT
"""The one reader of nurbs.h: functions, structs, constants, macros and their comments, as Python objects.

    header = header.read(TOP)        the header of the project in the folder TOP

The rules that the comments follow are written in the header itself, in its section "Bindings".
"""

import re
from dataclasses import dataclass, field
from pathlib import Path

PATH = "include/nurbs/nurbs.h"
COMMAND = "python3 cmake/interface/generate.py ."
NOTICE = f"Generated from {PATH} by: {COMMAND} - do not edit."
NULL_MARK = re.compile(r"or NULL\b")
# A parameter described by another function takes its shape, and whether it may be NULL, from there.
REFERENCE = re.compile(r"as for (nurbs_\w+)\(\)")


class HeaderError(Exception):
    """The header does not follow its rules."""


@dataclass
class Parameter:
    name: str
    c_type: str  # as in "const double *"
    direction: str = ""  # "in", "out" or "in,out"; empty without a description
    shape: str = ""  # "[n][dim]", empty for single values
    nullable: bool = False
    null: str = ""  # what NULL means, as it goes on after "or NULL": " for all of it", ", which ..."
    text: str = ""  # the rest

    @property
    def base(self):
        """The type without pointers and qualifiers."""
        return re.sub(r"\bconst\b|\*", "", self.c_type).strip()

    @property
    def pointers(self):
        return self.c_type.count("*")

    @property
    def is_const(self):
        return re.search(r"\bconst\b", self.c_type) is not None


@dataclass
class Function:
    name: str
    result: str  # C type
    parameters: list
    module: "Module"
    brief: str  # the first sentence
    text: str  # the whole description
    returns: str
    since: str
    tags: tuple  # of its comment, in their order
    described: dict = field(default_factory=dict)  # name -> (direction, text as written)
    statuses: tuple = ()  # names, those by reference included


@dataclass
class Constant:
    name: str
    literal: str  # "0x01u", or an expression of other constants
    value: int
    text: str


@dataclass
class Group:
    """Constants that belong together."""

    title: str
    text: str
    constants: list = field(default_factory=list)
    is_status: bool = False


@dataclass
class Macro:
    name: str
    parameters: list
    body: str
    text: str


@dataclass
class Struct:
    name: str
    fields: list  # (C type, name, text)
    text: str


@dataclass
class Module:
    """A chapter of the manual."""

    name: str
    title: str
    text: str
    functions: list = field(default_factory=list)


@dataclass
class Header:
    preamble: str = ""
    modules: list = field(default_factory=list)
    functions: list = field(default_factory=list)
    groups: list = field(default_factory=list)
    macros: list = field(default_factory=list)
    structs: list = field(default_factory=list)
    handles: dict = field(default_factory=dict)  # opaque type -> text
    aliases: dict = field(default_factory=dict)  # name -> (C type, text)

    @property
    def constants(self):
        return {constant.name: constant for group in self.groups for constant in group.constants}

    @property
    def version(self):
        return ".".join(str(self.constants[f"NURBS_VERSION_{part}"].value) for part in ("MAJOR", "MINOR", "PATCH"))


def read(top):
    return parse((Path(top) / PATH).read_text(encoding="utf-8"))


def parse(text):
    return Reader().read(text)


# --- text of comments ---


def cleaned(comment):
    """A comment without the stars at the beginnings of its lines."""
    return re.sub(r"^[ \t]*\*(?: |$)?", "", comment, flags=re.M).strip()


def one_line(text):
    return " ".join(text.split())


def first_sentence(text):
    """Up to a full stop (not a product's dot, which has a space before it) or to a formula."""
    text = one_line(re.split(r"\n\s*\n", text)[0])
    match = re.match(r".*?[^\s.]\.(?=\s+(?:[A-Z(]|[a-z]+_)|$)", text)
    return match[0] if match else text.rstrip(":,") + "."


def tag(comment, name):
    """Text of \\name, up to the next tag."""
    match = re.search(rf"\\{name}\s+((?:(?!\n\\).)*)", comment, flags=re.S)
    return match[1].strip() if match else ""


def without_tags(comment):
    """A description: without its parameters and what follows them."""
    return re.split(r"\n\\|\n?@\{", re.sub(r"^\\brief\s+", "", comment))[0].strip()


def descriptions(comment):
    found = {}
    pattern = r"\\param\[(in|out|in,out)\]\s+(\S+)\s*((?:(?!\n\\).)*)"
    for direction, names, text in re.findall(pattern, comment, flags=re.S):
        for name in names.split(","):
            found[name] = (direction, one_line(text))
    return found


def split_shape(text):
    """The brackets at the beginning of a description, which may be nested and joined by dots, and the rest."""
    depth = end = 0
    for place, letter in enumerate(text):
        depth += (letter == "[") - (letter == "]")
        if depth == 0 and letter not in "].":
            break
        end = place + 1
    shape = text[:end] if text.startswith("[") else ""
    if depth != 0:
        raise HeaderError(f"brackets do not match: {text}")
    return shape.rstrip("."), text[len(shape.rstrip(".")):].lstrip()


def split_null(text):
    """What follows "or NULL": what it means, up to a colon, and the description."""
    before, colon, after = text.partition(": ")
    return before.rstrip("."), after if colon else ""


# --- the reader ---

TOKEN = re.compile(
    r"/\*(?P<doc>\*(?!<))?(?P<comment>.*?)\*/"
    r"|^#define (?P<macro>\w+)(?P<args>\([^)]*\))?(?P<body>(?:\\\n|[^\n/]|/(?!\*))*)(?:/\*\*<(?P<after>.*?)\*/)?"
    r"|^typedef struct (?P<handle>\w+) \w+;"
    r"|^typedef struct (?P<struct>\w+) \{(?P<fields>.*?)\} \w+;"
    r"|^typedef (?P<type>[\w ]+) (?P<alias>\w+);"
    r"|^enum \{(?P<enum>.*?)\};"
    r"|^NURBS_API (?P<result>[^;()]*?)(?P<function>\w+)\((?P<parameters>[^)]*)\);",
    flags=re.S | re.M)


class Reader:
    """Goes through the declarations in their order, with the last comment and the open groups in mind."""

    def __init__(self):
        self.header = Header()
        self.comment = ""
        self.open = []  # modules and groups of constants

    def read(self, text):
        for match in TOKEN.finditer(text):
            kind = next(name for name in ("comment", "macro", "handle", "struct", "alias", "enum", "function")
                        if match[name] is not None)
            getattr(self, "read_" + kind)(match)
            if kind != "comment":
                self.comment = ""
        declared = len(re.findall(r"^NURBS_API ", text, flags=re.M))
        if declared != len(self.header.functions) or self.open:
            raise HeaderError(f"{declared} functions are declared, {len(self.header.functions)} understood, "
                              f"{len(self.open)} groups stay open")
        for function in self.header.functions:
            self.describe(function)
        for function in self.header.functions:
            function.statuses = tuple(self.statuses(function)) if function.result == "nurbs_status" else ()
        return self.header

    # Comments.

    def read_comment(self, match):
        if not match["doc"]:
            return
        text = cleaned(match["comment"])
        opened = re.match(r"\\(defgroup|name|file)\s+([^\n]*)\n?(.*)", text, flags=re.S)
        if text == "@}":
            self.open.pop()
        elif not opened:
            self.comment = text
        elif opened[1] == "file":
            self.header.preamble = re.sub(r"^\\brief ", "", opened[3])
        else:
            self.open.append(self.group(opened[1], opened[2], opened[3].removesuffix("@{").strip()))

    def group(self, kind, title, text):
        if kind == "name":
            group = Group(title, text)
            self.header.groups.append(group)
            return group
        module = Module(*title.split(" ", 1), text)
        self.header.modules.append(module)
        return module

    def innermost(self, kind):
        return next((entry for entry in reversed(self.open) if isinstance(entry, kind)), None)

    # Declarations.

    def read_macro(self, match):
        group = self.innermost(Group)
        body = one_line(match["body"].replace("\\\n", " "))
        text = without_tags(one_line(match["after"] or "") or self.comment)
        if group is None or not body:
            return  # the include guard and NURBS_API
        if match["args"]:
            names = match["args"].strip("()").split(", ")
            self.header.macros.append(Macro(match["macro"], names, body, text))
        else:
            group.constants.append(Constant(match["macro"], body, self.value(body), text))

    def value(self, expression):
        plain = re.sub(r"\b(0x[0-9A-Fa-f]+|\d+)u\b", r"\1", expression)
        known = {name: constant.value for name, constant in self.header.constants.items()}
        return eval(plain, {"__builtins__": {}}, known)  # noqa: S307 - the project's own file

    def read_enum(self, match):
        group = Group("Statuses", without_tags(self.comment), is_status=True)
        for name, value, text in re.findall(r"(\w+) =\s+(\d+),?\s+(?:/\*\*<(.*?)\*/)?", match["enum"], flags=re.S):
            group.constants.append(Constant(name, value, int(value), one_line(text)))
        self.header.groups.append(group)

    def read_handle(self, match):
        self.header.handles[match["handle"]] = without_tags(self.comment)

    def read_struct(self, match):
        fields = re.findall(r"(\w+) (\w+);\s*/\*\*<(.*?)\*/", match["fields"], flags=re.S)
        if len(fields) != re.sub(r"/\*.*?\*/", "", match["fields"], flags=re.S).count(";"):
            raise HeaderError(f"{match['struct']}: a field is not of the form: TYPE NAME; /**< TEXT */")
        members = [(kind, name, one_line(text)) for kind, name, text in fields]
        self.header.structs.append(Struct(match["struct"], members, without_tags(self.comment)))

    def read_alias(self, match):
        self.header.aliases[match["alias"]] = (match["type"], without_tags(self.comment))

    def read_function(self, match):
        words = [] if match["parameters"] == "void" else match["parameters"].split(",")
        module = self.innermost(Module)
        text = without_tags(self.comment) if "\\brief" in self.comment else ""
        function = Function(match["function"], plain_type(match["result"]), [parameter(word) for word in words], module,
                            first_sentence(text), text, one_line(tag(self.comment, "return")),
                            tag(self.comment, "since"), tuple(re.findall(r"^\\(\w+)", self.comment, flags=re.M)),
                            descriptions(self.comment))
        self.header.functions.append(function)
        module.functions.append(function)

    # What needs all functions.

    def describe(self, function):
        for entry in function.parameters:
            if entry.name in function.described:
                entry.direction = function.described[entry.name][0]
                entry.shape, entry.nullable, entry.null, entry.text = self.description(function, entry.name)

    def description(self, function, name, seen=()):
        """Shape, whether it may be NULL, what that means, and text."""
        shape, text = split_shape(function.described[name][1])
        mark = NULL_MARK.match(text)
        null, text = split_null(text[mark.end():]) if mark else ("", text.lstrip(":,. "))
        reference = REFERENCE.match(text)
        if shape or mark or not reference or reference[1] == function.name or reference[1] in seen:
            return shape, bool(mark), null, text
        other = next((entry for entry in self.header.functions if entry.name == reference[1]), None)
        if other is None or name not in other.described:
            return shape, False, "", text
        return *self.description(other, name, (*seen, function.name))[:3], text

    def statuses(self, function, seen=()):
        """What \\return lists; "as for nurbs_eval(), without _FLAGS" and "_FLAGS instead of _FORM" included."""
        found = []
        other = re.match(r"as for (nurbs_\w+)\(\)", function.returns)
        if other and other[1] not in seen:
            source = next(entry for entry in self.header.functions if entry.name == other[1])
            found += self.statuses(source, (*seen, function.name))
        text = full_statuses(function.returns)
        dropped = re.findall(r"(?:without|instead of) (NURBS_ERROR_\w+)", text)
        found += re.findall(r"\bNURBS_OK\b|\bNURBS_ERROR_\w+", text)
        return [name for name in dict.fromkeys(found) if name not in dropped]


def full_statuses(text):
    """_AXES is short for NURBS_ERROR_AXES."""
    return re.sub(r"(?<!\w)_(?=[A-Z])", "NURBS_ERROR_", text)


def plain_type(text):
    """A C type with one space before its stars."""
    return re.sub(r"\* (?=\*)", "*", re.sub(r"\s*\*", " *", one_line(text)))


def parameter(text):
    kind, name = re.fullmatch(r"\s*(.*?[\s*])(\w+)\s*", text, flags=re.S).groups()
    return Parameter(name, plain_type(kind))
