#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the programs that watch and cancel long calls in each language, of calls.toml.

    make.py FOLDER      writes cancel_c.cpp, cancel_cpp.cpp, cancel_rust.rs, cancel_fortran.f90 and big.igs
"""

import math
import re
import sys
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
TOP = HERE.parents[2]
sys.path.insert(0, str(TOP / "cmake/interface"))

import calls  # noqa: E402 - from the project
import calls_arguments  # noqa: E402 - from the project
import calls_model  # noqa: E402 - from the project
import calls_reader  # noqa: E402 - from the project
import calls_terms  # noqa: E402 - from the project
import header  # noqa: E402 - from the project
import smoke  # noqa: E402 - from the project
import smoke_cpp  # noqa: E402 - from the project
import smoke_fortran  # noqa: E402 - from the project
import smoke_rust  # noqa: E402 - from the project
import table  # noqa: E402 - from the project
from calls_model import Handle  # noqa: E402 - from the project

# A cubic Bezier curve in space; the file is made of many.
CURVE = ("126,3,3,0,0,1,0,0.,0.,0.,0.,1.,1.,1.,1.,1.,1.,1.,1.,", "0.,0.,0.,1.,2.,0.,3.,2.,0.,4.,0.,0.,0.,1.;")
Facts = calls_terms.Facts
MANY = {"few_points": 60, "many_points": 3000, "many_places": 2000, "many_params": 300, "many_targets": 900,
        "wild_net": 4800, "wild_knots": 88, "wild_curve_knots": 1604}


def big_file(count):
    """The same curve many times, as IGES."""
    lines = ["a file of many curves".ljust(72) + "S      1",
             "1H,,1H;,4Htest,8Htest.igs,4Hnone,4Hnone,32,38,6,308,15,4Htest,1.,2,2HMM,".ljust(72) + "G      1",
             "1,0.01,15H20260101.000000,1.E-6,10.,2Hme,4Hhere,11,0,15H20260101.000000;".ljust(72) + "G      2"]
    for i in range(count):
        first = [126, 2 * i + 1, 0, 1, 0, 0, 0, 0]
        lines.append("".join(f"{number:8d}" for number in first) + "00000000" + f"D{2 * i + 1:7d}")
        lines.append("".join(f"{number:8d}" for number in (126, 0, 0, 2, 0)) + " " * 24 + "       0" + f"D{2 * i + 2:7d}")
    for i in range(count):
        lines += [f"{text:<64}{2 * i + 1:8d}P{2 * i + k + 1:7d}" for k, text in enumerate(CURVE)]
    lines.append(f"S      1G      2D{2 * count:7d}P{2 * count:7d}".ljust(72) + "T      1")
    return "\n".join(lines) + "\n"


def facts_of_source(name, call):
    """Refinement keeps what lengths depend on here: the dimension and the number of axes."""
    source = next((model_inputs[value.name] for _, value in call.arguments if isinstance(value, Handle)), None)
    return Facts(name, call) if source is None else facts_of_source(source.name, source.call)


def many(name, count):
    if name == "many_params":
        return [(i + 0.5) / count for i in range(count)]
    if name == "wild_curve_knots":
        return open_knots(1600)
    if name == "wild_knots":
        return open_knots(40) * 2
    return [0.5 + 0.4 * math.sin(12.9898 * (i + 1) ** 2) for i in range(count)]


def open_knots(count):
    """Of degree 3."""
    return [min(max(i - 3, 0), count - 3) / (count - 3) for i in range(count + 4)]


model_inputs = {}


def read(manual):
    text = tomllib.loads((HERE / "calls.toml").read_text(encoding="utf-8"))
    text["inputs"]["texts"] = {"file": "a file\n"}
    text["inputs"]["arrays"] |= {name: many(name, count) for name, count in MANY.items()}
    calls_model.LENGTHS.update(values=16384, states=1024)  # as in cancel.hpp
    calls_arguments.Facts = calls_terms.Facts = facts_of_source
    reader = calls_reader.Reader(manual)
    global model_inputs
    model_inputs = reader.model.inputs
    return reader.model_of({"inputs": text["inputs"], "long": text["long"]})


def watched(model):
    return [call for call in model.calls() if call.function.name.endswith("_with")]


def c_program(manual, binding, model):
    """Lambdas with nurbs.h alone."""
    yield from ['#include "cancel.hpp"', "namespace arrays {"]
    for name, values in model.arrays.items():
        yield from calls.array("inline constexpr double", name, map(calls.number, values))
    yield "}"
    yield from ["struct Inputs {"]
    names = list(model.inputs)
    yield f"    nurbs *{', *'.join(names)};"
    yield "};"
    for entry in model.inputs.values():
        lines = list(calls.body(model, entry.call, ""))
        yield f"nurbs_status make_{entry.name}(const Inputs &in, nurbs **out) {{ (void)in;"
        yield from lines
        yield "}"
    yield "int main() { Inputs in{}; Output o;"
    yield from (f"    good(make_{name}(in, &in.{name}));" for name in names)
    for call in watched(model):
        lines = " ".join(calls.body(model, call, "o.")).replace("texts::file, 7", "big.data(), std::ssize(big)")
        lines = lines.replace("file_path", '"big.igs"').replace("sizeof call);", "sizeof call); call.progress = meter.progress; "
                                                                "call.user = &meter;", 1)
        yield f'    measure("{call.function.name}", [&](Meter &meter) -> nurbs_status {{ {lines} }}, o);'
    yield "}"


def cpp_program(manual, binding, model):
    yield from ['#include "cancel.hpp"', "#include <nurbs/nurbs.hpp>", "namespace n = libnurbs;",
                "inline constexpr double infinity = std::numeric_limits<double>::infinity();"]
    plan = smoke.plan(binding, model, "cpp")
    yield "int main() { Output o;"
    for step in plan.inputs:
        before, call = smoke_cpp.made(step, binding, model)
        yield from before
        yield f"    const n::Spline {step.call.name} = {call};".replace("in.", "")
    for step in plan.groups["long"]:
        if not step.watched:
            continue
        writer = smoke_cpp.Writer(step, binding, model)
        text = writer.call()
        lines = " ".join([*writer.before, f"static_cast<void>({text});"]).replace("watched()", "call").replace("in.", "")
        lines = lines.replace("std::as_bytes(std::span(file))", "std::as_bytes(std::span(big))").replace("file_path()", '"big.igs"')
        yield (f'    measure("{step.call.function.name}", [&](Meter &meter) -> nurbs_status {{ return status_of([&] {{ '
               f'const n::CallOptions call{{0, std::ref(meter)}}; {lines} }}); }}, o);')
    yield "}"


def rust_program(manual, binding, model):
    yield from ["mod cancel;", "use cancel::measure;", "use nurbs::{List, Spline};"]
    plan = smoke.plan(binding, model, "rust")
    yield "fn main() -> nurbs::Result<()> { let big = std::fs::read(\"big.igs\").unwrap();"
    for step in plan.inputs:
        text = smoke_rust.Writer(step, binding, model).call()
        yield f"    let {smoke_rust.own(step.call.name)} = {text};".replace("given.", "")
    for step in plan.groups["long"]:
        if step.watched:
            text = smoke_rust.Writer(step, binding, model).call().replace("&mut Call::new().progress(|_| true)", "call")
            text = text.replace("given.", "")
            text = text.replace("FILE.as_bytes()", "&big").replace('written("smoke_calls_rust.file", FILE)', '"big.igs"')
            yield f'    measure("{step.call.function.name}", |call| {{ {text}; Ok(()) }});'
    yield "    Ok(()) }"


def fortran_program(manual, binding, model):
    words, plan = smoke_fortran.Words(binding), smoke.plan(binding, model, "fortran")
    yield from ["program cancel_fortran", "use, intrinsic :: iso_c_binding", "use nurbs", "use cancel", "implicit none"]
    yield from (f"type(nurbs_spline) :: {name}" for name in model.inputs)
    yield "character(len=:), allocatable :: file_text"
    yield "call read_all('big.igs', file_text)"
    for step, entry in zip(plan.inputs, model.inputs.values()):
        for text in smoke_fortran.maker(step, entry, words, model)[1]:
            yield from smoke_fortran.statement(text, 0)
    steps = [step for step in plan.groups["long"] if step.watched]
    for step in steps:
        yield f"call measure('{step.call.function.name}', call_{step.method.entry.name})"
    yield "contains"
    for step in steps:
        name = f"call_{step.method.entry.name}"
        writer = smoke_fortran.Writer(step, words, model)
        declared, lines = writer.lines()
        kept = [line for line in lines if not line.startswith("call show(")]
        text = [re.sub(r", call=watching\)$", ", call=watching, status=code)", line) for line in kept]
        text = [line.replace("written('smoke_calls_fortran.file', file_text)", "'big.igs'") for line in text]
        yield from [f"subroutine {name}(watching, code)", "type(nurbs_call), intent(in) :: watching",
                    "integer(c_int32_t), intent(out) :: code"]
        yield from (line for line in declared if "watching" not in line)
        for line in text:
            yield from smoke_fortran.statement(line, 0)
        yield f"end subroutine {name}"
    yield "end program cancel_fortran"


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    manual = header.read(TOP)
    binding, model = table.read(manual, TOP), read(manual)
    for name, make in (("cancel_c.cpp", c_program), ("cancel_cpp.cpp", cpp_program), ("cancel_rust.rs", rust_program),
                       ("cancel_fortran.f90", fortran_program)):
        (folder / name).write_text("\n".join(make(manual, binding, model)) + "\n", encoding="utf-8")
    (folder / "big.igs").write_text(big_file(20000), encoding="ascii")


if __name__ == "__main__":
    main()
