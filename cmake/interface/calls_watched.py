# SPDX-License-Identifier: MIT
"""The good calls of the functions nurbs_X_with: those of nurbs_X, with options that set no limit.

Where the function takes structs instead of the arguments of nurbs_X, the fields have their names.
"""

from calls_model import Call, Null, Number, Packed, Slot, Struct, StructSize

OPTIONS = "nurbs_call_options"


def watched_calls(manual, calls):
    """One for each call of the plain form."""
    forms = {function.name: function for function in manual.functions}
    structs = {struct.name: struct for struct in manual.structs}
    for call in calls:
        form = forms.get(call.function.name + "_with")
        if form is not None:
            yield watched(call, form, structs)


def watched(call, form, structs):
    known = {entry.name: value for entry, value in call.arguments}
    arguments = [(entry, known[entry.name] if entry.name in known else packed(entry, known, structs))
                 for entry in form.parameters]
    plain, _, words = call.name.partition(" ")
    return Call(f"{plain}_with {words}".strip(), form, arguments, None, call.made, call.can_do_without)


def packed(entry, known, structs):
    if entry.base == OPTIONS:
        return Struct(OPTIONS, ())
    fields = [(member, value_of(member, entry, known)) for member in structs[entry.base].fields]
    return Packed(entry.base, tuple((member, value) for member, value in fields if value not in (Null(), Number(0))))


def value_of(member, entry, known):
    if member.name == "struct_size":
        return StructSize(entry.base)
    value = known.get(member.name, Null())
    # What the library writes into the struct itself begins as 0.
    return Number(0) if isinstance(value, Slot) and not member.pointers else value
