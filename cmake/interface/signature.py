# SPDX-License-Identifier: MIT
"""The lines of the table that say how a function is called:

    [receiver.]name(argument, ...) [-> pattern]

    argument  name[[]][?][: pattern][= default]     [] the call allocates it, ? it may be left out; without a pattern
                                                    the argument is the parameter of that name
    pattern   parameter                             a parameter of the C function
              parameter[0:3]                        a part of an array
              Record, Record(field = pattern, ...)  a struct of these; fields without "=" go by their order or their name
              [pattern, ...]                        an array of single values
              (pattern, ...)                        a tuple
              each pattern                          arrays as rows: one struct or tuple for each element
              by counts pattern                     packed arrays as one array for each element of counts
"""

import re
from dataclasses import dataclass

TOKEN = re.compile(r"\s*(->|operator\[\]|\d+|[A-Za-z_]\w*|[\[\](){}.,:?=|-])")


class SignatureError(Exception):
    """A line does not follow the grammar."""


@dataclass(frozen=True)
class Take:
    """A parameter of the C function, or elements [first, last) of it."""

    name: str
    first: int = 0
    last: int = 0


@dataclass(frozen=True)
class Struct:
    """A record of the table. Fields are (name, pattern), the name "" where the order gives it."""

    record: str
    fields: tuple = ()


@dataclass(frozen=True)
class Several:
    """An array, "[", or a tuple, "("."""

    bracket: str
    items: tuple


@dataclass(frozen=True)
class Each:
    """Rows: the arrays inside are given element by element."""

    item: object


@dataclass(frozen=True)
class By:
    """Packed arrays in parts, whose lengths are in an array."""

    counts: str
    item: object


@dataclass(frozen=True)
class Argument:
    name: str
    pattern: object
    optional: bool = False
    allocated: bool = False
    default: str = None


@dataclass(frozen=True)
class Signature:
    receiver: str
    name: str
    arguments: tuple
    result: object = None


def taken(pattern):
    """Names of the parameters in a pattern, in their order."""
    if isinstance(pattern, Take):
        yield pattern.name
    elif isinstance(pattern, Struct):
        for _, inner in pattern.fields:
            yield from taken(inner)
    elif isinstance(pattern, Several):
        for inner in pattern.items:
            yield from taken(inner)
    elif isinstance(pattern, By):
        yield pattern.counts
        yield from taken(pattern.item)
    elif isinstance(pattern, Each):
        yield from taken(pattern.item)


def tokens(text):
    place, found = 0, []
    while text[place:].strip():
        match = TOKEN.match(text, place)
        if not match:
            raise SignatureError(f"cannot read {text[place:].strip()!r}")
        found.append(match[1])
        place = match.end()
    return found


def parse(text):
    return Parser(text).signature()


class Parser:
    """Recursive descent; each method reads what its name says."""

    def __init__(self, text):
        self.tokens = tokens(text)
        self.place = 0

    def next_is(self, *wanted):
        return self.tokens[self.place:self.place + len(wanted)] == list(wanted)

    def skip(self, token):
        found = self.next_is(token)
        self.place += found
        return found

    def expect(self, token):
        if not self.skip(token):
            found = self.tokens[self.place] if self.place < len(self.tokens) else "the end"
            raise SignatureError(f"expected {token!r}, found {found!r}")

    def word(self):
        if self.place == len(self.tokens) or not re.match(r"\w", self.tokens[self.place]):
            raise SignatureError(f"expected a name after {' '.join(self.tokens[:self.place])!r}")
        self.place += 1
        return self.tokens[self.place - 1]

    def listed(self, read, end):
        """What stands between brackets with commas."""
        items = []
        while not self.skip(end):
            items.append(read())
            if not self.next_is(end):
                self.expect(",")
        return tuple(items)

    def signature(self):
        receiver, name = "", self.word()
        if self.skip("."):
            receiver, name = name, self.word()
        self.expect("(")
        arguments = self.listed(self.argument, ")")
        result = self.pattern() if self.skip("->") else None
        if self.place != len(self.tokens):
            raise SignatureError(f"{' '.join(self.tokens[self.place:])!r} is left over")
        return Signature(receiver, name, arguments, result)

    def argument(self):
        name = self.word()
        allocated = self.next_is("[", "]")
        self.place += 2 * allocated
        optional = self.skip("?")
        pattern = self.pattern() if self.skip(":") else Take(name)
        default = self.default() if self.skip("=") else None
        return Argument(name, pattern, optional, allocated, default)

    def default(self):
        found = []
        while not (self.next_is(",") or self.next_is(")")):
            if self.place == len(self.tokens):
                raise SignatureError("a default without an end")
            found.append(self.tokens[self.place])
            self.place += 1
        return " ".join(found).replace("{ }", "{}").replace("- ", "-")

    def pattern(self):
        for bracket, end in ("[]", "()"):
            if self.skip(bracket):
                return Several(bracket, self.listed(self.pattern, end))
        name = self.word()
        if name == "each":
            return Each(self.pattern())
        if name == "by":
            return By(self.word(), self.pattern())
        if name[0].isupper():
            return Struct(name, self.listed(self.field, ")") if self.skip("(") else ())
        return self.part(name)

    def part(self, name):
        if not self.skip("["):
            return Take(name)
        first = int(self.word())
        self.expect(":")
        last = int(self.word())
        self.expect("]")
        return Take(name, first, last)

    def field(self):
        if self.place + 1 < len(self.tokens) and self.tokens[self.place + 1] == "=":
            name = self.word()
            self.expect("=")
            return name, self.pattern()
        return "", self.pattern()
