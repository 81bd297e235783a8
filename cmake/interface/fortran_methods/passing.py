# SPDX-License-Identifier: MIT
"""What is passed for each parameter of a C function, and what is done before and after the call for it."""

from dataclasses import dataclass, field

from model import HANDLES
from signature import Each, Several, Struct

from . import words as fortran


@dataclass
class Output:
    """Where something that the library writes goes."""

    value: object
    target: str  # the dummy argument or a component of it
    optional: bool = False
    allocated: bool = False
    part: tuple = ()  # (first, last) elements
    local: str = ""  # a variable that the library fills in place of the target


@dataclass
class Passing:
    """Texts of the actual arguments, and what belongs to them."""

    method: object
    dummies: list
    words: object
    sizes: object
    texts: dict = field(default_factory=dict)  # parameter -> text
    outputs: list = field(default_factory=list)
    handles: list = field(default_factory=list)  # (variable, how it is handed over)
    locals: list = field(default_factory=list)  # (attributes, name)
    before: list = field(default_factory=list)  # statements

    def __post_init__(self):
        if self.method.receiver in self.method.values and self.method.values[self.method.receiver] not in self.method.made:
            self.texts[self.method.receiver] = "this%handle"
        for dummy in self.dummies:
            self.take(dummy, dummy.argument.pattern)
        if self.method.result:
            self.output(Output(self.method.values[self.method.result.name], "value"))
        for value in self.method.made:
            self.make(value)
        for value in self.method.computed:
            self.texts[value.name] = self.sizes.number(value.name, value.base != "int64_t")
        for value in self.method.values.values():
            if value.kind in ("stride", "component_stride"):
                self.texts[value.name] = self.stride(value)

    # Inputs.

    def take(self, dummy, pattern):
        if isinstance(pattern, Several):
            for place, item in enumerate(pattern.items):
                self.texts[item.name] = f"{dummy.name}({place + 1})"
        elif isinstance(pattern, Struct):
            self.take_record(dummy, pattern, "")
        elif isinstance(pattern, Each):
            self.take_record(dummy, pattern.item, "rows")
        elif dummy.value.is_output:
            if dummy.kind == "options":
                self.answers(dummy)
            elif dummy.kind not in HANDLES:
                self.output(Output(dummy.value, dummy.name, dummy.optional, dummy.allocated))
        else:
            self.texts[pattern.name] = getattr(self, f"input_{dummy.kind}")(dummy)

    def take_record(self, dummy, pattern, rows):
        for name, part in pattern.fields:
            value = self.method.values[part.name]
            elements = (part.first, part.last) if part.last else ()
            self.output(Output(value, f"{dummy.name}%{name}", part=elements,
                               local=f"{part.name}_c" if rows or elements else ""))

    def answers(self, dummy):
        """A struct that the library fills, which says its own size."""
        self.texts[dummy.value.name] = dummy.name
        given = f"if (present({dummy.name})) " * dummy.optional
        self.before.append(f"{given}{dummy.name}%struct_size = c_sizeof({dummy.name})")

    def input_spline(self, dummy):
        return f"{dummy.name}%handle"

    input_statistics = input_face = input_model = input_meet = input_mesh = input_spline

    def input_splines(self, dummy):
        return self.converted(dummy, "type(c_ptr)", f"handles_of({dummy.name})", 1)

    input_handles = input_splines

    def input_path(self, dummy):
        return f"{dummy.name}//c_null_char"

    def input_bytes(self, dummy):
        return f"c_loc({dummy.name})"

    def input_options(self, dummy):
        return dummy.name

    def input_number(self, dummy):
        value, text = dummy.value, dummy.name
        if dummy.optional:
            text = f"given({text}, {fortran.literal(self.words.default(self.method, dummy.argument), value)})"
        return self.in_c(value, text)

    def input_array(self, dummy):
        value, text = dummy.value, dummy.name
        if self.words.is_transposed(value):
            text = f"transpose({text})"
        text = self.in_c(value, text)
        if text == dummy.name:
            return text
        return self.converted(dummy, fortran.TYPES[value.base], text, len(value.extents))

    def in_c(self, value, text):
        """A number or array with the indices and bits of C."""
        if self.words.is_index(value):
            return f"{text} - 1_c_int64_t" if self.words.is_narrow(value) else f"{text} - 1"
        return f"int({text}, c_int64_t)" if self.words.is_narrow(value) else text

    def converted(self, dummy, kind, text, rank):
        """An array that may be left out gets a copy: a variable that is not allocated counts as absent."""
        if not dummy.optional:
            return text
        local = f"{dummy.name}_c"
        self.locals.append((f"{kind}, allocatable", f"{local}({', '.join(':' * rank)})"))
        self.before.append(f"if (present({dummy.name})) {local} = {text}")
        return local

    def stride(self, value):
        owner = self.method.values[value.of]
        stored = owner.name in self.words.stored or len(owner.extents) < 2
        if owner.name not in self.texts or stored:
            return "0_c_int64_t"
        return f"{'column' if value.kind == 'component_stride' else 'step'}({self.texts[owner.name]})"

    # Outputs.

    def output(self, output):
        value = output.value
        output.local = output.local or self.sizes.replaced.get(value.name, "")
        if not output.local and (value.truth or self.words.is_narrow(value) or self.words.is_transposed(value)
                                 or value.kind == "text"):
            output.local = self.local_name(value, output)
        self.outputs.append(output)
        self.texts[value.name] = output.local or output.target
        if output.local and all(output.local != name.partition("(")[0] for _, name in self.locals):
            self.locals.append(self.local(output))

    def local_name(self, value, output):
        if value.kind == "text":
            return "buffer"
        return "answer" if value.truth and not value.extents else f"{output.target}_c"

    def local(self, output):
        value = output.value
        if value.kind == "text":
            return "character(kind=c_char), allocatable", f"{output.local}(:)"
        kind = fortran.TYPES[value.base]
        if not value.extents:
            return kind, output.local
        if all(extent.op == "number" for extent in value.extents):
            return kind, f"{output.local}({', '.join(str(extent.name) for extent in reversed(value.extents))})"
        return f"{kind}, allocatable", f"{output.local}({', '.join(':' * len(value.extents))})"

    def make(self, value):
        """A handle; out is the spline or list itself where the procedure is its own."""
        local = "made" if len(self.method.made) == 1 else f"made_{value.name}"
        owner = next((dummy.name for dummy in self.dummies if dummy.value is value), "this")
        self.locals.append(("type(c_ptr)", local))
        self.texts[value.name] = local
        self.handles.append((local, f"call {owner}%replace({local})"))

    # Calls.

    def call(self, texts):
        """The function with these of its parameters."""
        return self.written(self.method.entry.name, self.method.values, texts)

    def watched_call(self, texts):
        """The form of it that has `call`, last or before a new handle. Where that takes structs, nurbs_calls has a
        function with all of the arguments."""
        names = list(self.method.values)
        names.insert(len(names) - (names[-1] == "out"), "call")
        return self.written(watched_name(self.method.entry), names, {**texts, "call": "watched(call)"})

    @staticmethod
    def written(function, names, texts):
        """After an argument that is left out, the names are written."""
        words, named = [], False
        for name in names:
            if name in texts:
                words.append(f"{name}={texts[name]}" if named else texts[name])
            named = named or name not in texts
        return f"{function}({', '.join(words)})"


def watched_name(entry):
    return entry.name.removeprefix("nurbs_") + "_watched" if takes_structs(entry) else entry.watched.name


def takes_structs(entry):
    """Whether the watched form has structs where the function has arguments."""
    own = {parameter.name for parameter in entry.function.parameters}
    return not own <= {parameter.name for parameter in entry.watched.parameters}
