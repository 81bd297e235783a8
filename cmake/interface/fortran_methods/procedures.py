# SPDX-License-Identifier: MIT
"""A procedure for a method: its head, its declarations, and what it does.

What a procedure does with outputs that it allocates, if it fails, is `fortran.failing` in the table: "emptied" (the usual
case: as many elements as were found, none), "kept" (as they were), or "cleared" (intent(out)).
"""

from dataclasses import dataclass

from .dummies import Declarations, dummies
from .passing import Passing
from .sizes import Sizes
from .statements import STEP, block, comment, declarations, indented, statement

OK = "code == NURBS_OK"
#: Names of methods that hide what Fortran or the module needs under that name.
RENAMED = {"count": "get_count", "dimension": "get_dimension"}


@dataclass
class Procedure:
    """One specific procedure. flat: an array that has one rank less, and the ending of the name for it."""

    method: object
    owner: str  # the type that it belongs to, or ""
    words: object
    flat: str = ""
    ending: str = ""

    def __post_init__(self):
        method = self.method
        self.dummies = dummies(method)
        self.sizes = Sizes(method, self.dummies, self.words, self.flat)
        self.failing = method.entry.option("fortran", "failing", "emptied")
        self.note_replaced()
        self.passing = Passing(method, self.dummies, self.words, self.sizes)
        self.outputs = self.passing.outputs

    @property
    def name(self):
        return RENAMED.get(self.method.name, self.method.name) + self.ending

    @property
    def is_function(self):
        return self.method.result is not None

    @property
    def is_watched(self):
        """Whether there is a form of the function that can be told to end."""
        return self.method.entry.watched is not None

    @property
    def is_counted(self):
        return self.sizes.count is not None

    # Text.

    def lines(self):
        body, variables = self.sizes.settle(self.body())
        yield from comment(self.doc(), 1)
        yield from statement(self.head(), 1, 2)
        yield from declarations([*self.declared(), *self.local_variables(body, variables)], 2)
        for name, text in variables:
            yield from statement(f"{name} = {text}", 2)
        yield from indented(body, 2)
        yield f"{STEP}end {'function' if self.is_function else 'subroutine'} {self.name}"

    def doc(self):
        """Where an array may have one rank less, there are two texts."""
        texts = self.method.entry.option("fortran", "doc")
        return texts[0 if self.flat else 1] if isinstance(texts, list) else self.method.entry.doc("fortran")

    def head(self):
        names = ["this"] * bool(self.owner) + [dummy.name for dummy in self.dummies] + ["status"]
        names += ["call"] * self.is_watched
        if not self.is_function:
            return f"subroutine {self.name}({', '.join(names)})"
        kind = self.result_type() + " " if not self.result_value().extents else ""
        return f"{kind}function {self.name}({', '.join(names)}) result(value)"

    def result_value(self):
        return self.method.values[self.method.result.name]

    def result_type(self):
        return self.words.type_of(self.result_value())

    # Declarations.

    def declared(self):
        made = Declarations(self.method, self.words, self.flat)
        if self.owner:
            yield f"class({self.owner}), intent({'inout' if self.method.receiver == 'out' else 'in'})", "this"
        yield from (made.of(dummy) for dummy in self.dummies)
        yield "integer(c_int32_t), intent(out), optional", "status"
        if self.is_watched:
            yield "type(nurbs_call), intent(in), optional, target", "call"

    def local_variables(self, body, variables):
        if self.is_function and self.result_value().extents:
            extents = ", ".join(str(extent.name) for extent in self.result_value().extents)
            yield self.result_type(), f"value({extents})"
        if any("code" in text for text in body):
            yield "integer(c_int32_t)", "code"
        yield from (("integer(c_int64_t)", name) for name, _ in variables)
        if self.is_counted:
            yield "integer(c_int64_t)", self.sizes.count_name
        yield from self.passing.locals

    # What it does.

    def body(self):
        checks = self.checks()
        if self.is_counted:
            yield from self.counted(checks)
        else:
            yield from self.once(checks)
        yield from (handing for _, handing in self.passing.handles)
        if not self.settled_at_once(checks):
            yield "call settle(code, status)"

    def settled_at_once(self, checks):
        """Whether a single call is all, and nothing depends on its success."""
        simple = not checks and not self.is_counted and not self.passing.handles and not self.is_watched
        return simple and all(self.always(output) for output in self.outputs)

    def once(self, checks):
        """One call, before which all sizes are known."""
        yield from self.room(self.outputs)
        yield from self.first_values()
        yield from checks
        yield from self.passing.before
        if self.settled_at_once(checks):
            yield f"call settle({self.passing.call(self.passing.texts)}, status)"
        else:
            yield from self.guarded(self.calls(self.passing.texts), checks)
        yield from self.afterwards()

    @staticmethod
    def guarded(statements, checks):
        return block(OK, statements) if checks else statements

    def calls(self, texts):
        """The function with these arguments, or the form of it that is watched."""
        plain = f"code = {self.passing.call(texts)}"
        if not self.is_watched:
            return [plain]
        return ["if (present(call)) then", f"code = {self.passing.watched_call(texts)}", "else", plain, "end if"]

    def counted(self, checks):
        """A call that says how much there is, room for that, and a call that fills it."""
        early = [output for output in self.outputs if output.value in self.replaced()]
        yield from self.room(early)
        yield f"{self.sizes.count_name} = 0"
        yield from self.first_values()
        yield from checks
        yield from self.passing.before
        yield from self.guarded(self.calls(self.counting()), checks)
        room = list(self.room([output for output in self.outputs if output not in early]))
        filling = self.calls(self.filling())
        if self.failing == "kept":
            yield from block(OK, [*room, *filling])
        else:
            yield from room
            yield from block(OK, filling)
        yield from self.afterwards()

    def counting(self):
        """Of the call that counts: no outputs but those that say how much there is."""
        early = [value.name for value in self.replaced()]
        return {**{name: text for name, text in self.passing.texts.items()
                   if not self.method.values[name].is_output or name in early},
                self.cap().name: "0_c_int64_t", self.sizes.count.name: self.sizes.count_name}

    def filling(self):
        early = [value.name for value in self.replaced()]
        texts = {name: text for name, text in self.passing.texts.items() if name not in early}
        more = " + 1" if any(output.value.kind == "text" for output in self.outputs) else ""
        texts[self.cap().name] = self.sizes.count_name + more
        if not self.sizes.count.nullable:
            texts[self.sizes.count.name] = self.sizes.count_name
        return texts

    def cap(self):
        return next(value for value in self.method.values.values() if value.kind == "cap")

    def replaced(self):
        """Outputs of the call that counts from which the sizes of others follow."""
        named = set().union(*(extent.names() for value in self.method.values.values() for extent in value.extents))
        return [value for value in self.method.values.values()
                if self.is_counted and value.kind == "array" and value.is_output and value.name in named]

    def note_replaced(self):
        for value in self.replaced():
            self.sizes.replaced[value.name] = f"{self.sizes.by_parameter[value.name].name}_c"

    # Before the call.

    def checks(self):
        """code = ..., and nothing if there is nothing to check."""
        conditions = self.sizes.conditions()
        if not conditions:
            return []
        fitting = f"code = fitting([{', '.join(conditions)}])"
        first = self.handle_first()
        made = [f"{name} = c_null_ptr" for name, _ in self.passing.handles]
        return [*made, f"code = held({first})", f"if ({OK}) {fitting}"] if first else [*made, fitting]

    def handle_first(self):
        """A spline of nothing is found before shapes that do not suit it in its own methods, and where its number of
        points or its weights say what suits it."""
        if self.method.receiver not in ("", "out"):
            return "this%handle"
        texts = [number.wide for number in self.sizes.numbers.values()]
        return next((text.partition("(")[2].rstrip(")") for text in texts if text.startswith(("points_of", "rational_of"))),
                    "")

    def first_values(self):
        for output in self.outputs:
            target = self.target_before(output)
            if target:
                yield f"{target} = 0"

    def target_before(self, output):
        """What has a value from the start: what is true or false, results, and outputs that are cleared."""
        if output.value.truth:
            return output.local
        cleared = self.failing == "cleared" and not output.value.extents and output.value.kind != "text"
        return output.target if self.is_function or cleared else ""

    def room(self, outputs):
        """Allocates what the library writes to, the local variables too."""
        arrays = [self.shaped(output) for output in outputs]
        arrays = [array for array in arrays if array]
        if outputs:
            arrays += [f"{dummy.name}({self.sizes.count_name})" for dummy in self.dummies if dummy.kind == "records"]
        if self.failing != "cleared":
            held = [dummy.name for dummy in self.dummies if dummy.allocated]
            yield from (f"if (allocated({name})) deallocate ({name})" for name in held
                        if any(array.startswith(f"{name}(") for array in arrays))
        if arrays:
            yield f"allocate ({', '.join(arrays)})"

    def shaped(self, output):
        """NAME(extents) of what is allocated for an output, or ""."""
        value = output.value
        if value.kind == "text":
            return f"{output.local}({self.sizes.count_name} + 1)"
        if output.local and any(extent.op != "number" for extent in value.extents):
            extents = reversed(value.extents)
        elif output.allocated and not output.local:
            extents = self.words.extents(value)
        else:
            return ""
        return f"{output.local or output.target}({', '.join(self.length(extent) for extent in extents)})"

    def length(self, extent):
        return str(extent.name) if extent.op == "number" else self.sizes.wide(extent)

    # After the call.

    def afterwards(self):
        """Outputs that are not what the library wrote."""
        yield from (self.conversion(output) for output in self.outputs if output.local and self.always(output))
        later = [text for output in self.outputs if not self.always(output) for text in self.after_success(output)]
        yield from block(OK, later)

    def always(self, output):
        """Whether it is what it is also after a failure."""
        if output.local:
            whole = output.allocated and self.failing != "kept" and not self.words.is_index(output.value)
            return output.value.truth or output.value.kind == "text" or whole
        return not self.words.is_index(output.value)

    def after_success(self, output):
        text = self.conversion(output)
        yield f"if (present({output.target})) {text}" if output.optional else text

    def conversion(self, output):
        text = self.converted(output)
        if output.optional and self.always(output):
            return f"if (present({output.target})) {output.target} = {text}"
        return f"{output.target} = {text}"

    def converted(self, output):
        value, text = output.value, output.local or output.target
        if value.kind == "text":
            return f"string({text}(:{self.sizes.count_name}))"
        if output.part:
            return f"{text}({output.part[0] + 1}:{output.part[1]})"
        if self.words.is_transposed(value):
            text = rows_of(text, len(value.extents))
        if self.words.is_narrow(value):
            text = f"int({text})"
        if self.words.is_index(value):
            text += " + 1"
        return f"{text} /= 0" if value.truth else text


def rows_of(text, rank):
    """An array as it is stored, with its last index first."""
    if rank == 2:
        return f"transpose({text})"
    sizes = [f"size({text}, {k})" for k in (rank, *range(1, rank))]
    return f"reshape({text}, [{', '.join(sizes)}], order=[{', '.join(map(str, (*range(2, rank + 1), 1)))}])"


def procedures(method, owner, words):
    """Those of a method: two where an array may have one rank less."""
    ranks = method.entry.option("fortran", "ranks", [])
    if not ranks:
        return [Procedure(method, owner, words)]
    return [Procedure(method, owner, words, ranks[0], "_1"), Procedure(method, owner, words, "", "_n")]
