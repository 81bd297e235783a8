# SPDX-License-Identifier: MIT
"""Lengths in Rust, as usize, and the variables that hold those that are needed more than once."""

import re

PROPERTIES = {"axes": "{}.axes()? as usize", "dim": "{}.dimension()? as usize", "N": "{}.point_count()?",
              "rational": "usize::from({}.is_rational()?)"}
LOCALS = {"axes": ["axes"], "dim": ["dim"], "N": ["n", "count"], "rational": ["rational"]}
# Functions that are methods of a spline.
OF_SPLINE = {"degree": "{}.degree({})? as usize", "count": "{}.count({})?", "slots": "{}.slots({})?",
             "active": "{}.active({})?"}


class Locals:
    """Values that are written where they are used once, or else become variables. In statements they are @key@ until
    resolved."""

    def __init__(self, taken):
        self.taken = set(taken)  # names that have another meaning
        self.values, self.names = {}, {}

    def add(self, key, names, value):
        if key not in self.values:
            self.values[key] = value
            self.names[key] = next((name for name in names if name not in self.taken), "")
            self.taken.add(self.names[key])
        return f"@{key}@"

    def resolved(self, statements):
        """The statements, with each variable before its first use."""
        declared, lines = [], []
        for statement in statements:
            for key in self.needed(statement):
                if key not in declared and self.is_variable(key, statements):
                    declared.append(key)
                    lines.append(f"let {self.names[key]} = {self.written(self.values[key], statements)};")
            lines.append(self.written(statement, statements))
        return lines

    def keys(self, text):
        return re.findall(r"@(\w+)@", text)

    def needed(self, text):
        """Those first that others are made of."""
        for key in self.keys(text):
            yield from self.needed(self.values[key])
            yield key

    def is_variable(self, key, statements):
        return bool(self.names[key]) and self.uses(key, statements) > 1

    def uses(self, key, statements):
        direct = sum(self.keys(statement).count(key) for statement in statements)
        return direct + sum(self.keys(value).count(key) for other, value in self.values.items()
                            if key in self.keys(value) and self.uses(other, statements))

    def written(self, text, statements):
        def replaced(match):
            key = match[1]
            return self.names[key] if self.is_variable(key, statements) else self.values[key]
        while self.keys(text):
            text = re.sub(r"@(\w+)@", replaced, text)
        return text


class Terms:
    """Prints terms of extents.py. numbers: {parameter: (how it is written, its type)}; handle: of a spline."""

    def __init__(self, locals_, numbers, arrays, handle):
        self.locals, self.numbers, self.arrays, self.handle = locals_, numbers, arrays, handle

    def product(self, extents, per_row=1):
        """The number of elements, or of rows of so many elements."""
        factor, others = 1, []
        for extent in extents:
            if extent.op == "number":
                factor *= extent.name
            else:
                others.append(extent)
        factor //= per_row
        if any(extent.name == "product" for extent in others) and len(extents) > 1:
            texts = ([str(factor)] if factor > 1 else []) + [self.text(extent) for extent in others]
            return f"times(&[{', '.join(texts)}])"
        texts = ([str(factor)] if factor > 1 or not others else []) + [self.factor(extent) for extent in others]
        if len(others) == 1 and factor == 1:
            return self.text(others[0])
        return " * ".join(texts)

    def factor(self, term):
        text = self.text(term)
        return f"({text})" if term.op in ("+", "-") else text

    def text(self, term):
        if term.op == "number":
            return str(term.name)
        if term.op == "parameter":
            return self.parameter(term.name)
        if term.op == "property":
            return self.property(term.name, term.of)
        if term.op == "call":
            return self.called(term)
        left, right = term.arguments
        join = self.factor if term.op == "*" else self.text
        return f"{join(left)} {term.op} {join(right)}"

    def parameter(self, name):
        text, kind = self.numbers[name]
        return text if kind == "usize" else f"positive({text})"

    def property(self, name, of):
        handle = self.handle(of)
        names = LOCALS[name] if handle == "self" else []
        return self.locals.add(re.sub(r"\W", "_", f"{name}_of_{handle}"), names, PROPERTIES[name].format(handle))

    def called(self, term):
        if term.of and term.name in OF_SPLINE:
            raw = ", ".join(self.raw(argument) for argument in term.arguments)
            return self.locals.add(f"{term.name}_call", [f"{term.name}s" if term.name == "degree" else term.name],
                                   OF_SPLINE[term.name].format(self.handle(term.of), raw))
        if term.name == "product" and term.arguments[0].op == "+":
            text = f"bezier_points({self.raw(term.arguments[0].arguments[0])})"
            return self.locals.add("bezier_points", ["n"], text)
        text = f"{term.name}({', '.join(self.raw(argument) for argument in term.arguments)})"
        if term.name != "product":
            return text
        return self.locals.add(f"product_of_{term.arguments[0].name}", ["n"], text)

    def raw(self, term):
        """An argument of a function: as the caller gave it."""
        if term.op == "parameter":
            return self.numbers[term.name][0] if term.name in self.numbers else self.arrays(term.name)
        return self.text(term)

    def signed(self, term):
        """A difference, which may be negative, as i64."""
        if term.op in ("+", "-"):
            return f"{self.signed(term.arguments[0])} {term.op} {self.signed(term.arguments[1])}"
        if term.op == "call" and term.name == "size":
            return f"{self.arrays(term.arguments[0].name)}.len() as i64"
        if term.op == "parameter":
            text, kind = self.numbers[term.name]
            return f"i64::from({text})" if kind == "i32" else text
        return str(term.name)
