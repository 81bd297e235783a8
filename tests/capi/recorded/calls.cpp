/* SPDX-License-Identifier: MIT */
#include "guarded/batches.h"
#include "recorded/batteries/batteries.h"
#include "recorded/sections.h"

namespace recorded {

namespace {

void run(const calls::Call &call, const calls::Inputs &in) {
    calls::Output o;
    CHECK(call.run(in, o) == NURBS_OK);
    calls::destroy(o);
}

void section_of(const char *kind, const calls::Call &call, const calls::Inputs &in) {
    record.section(std::string(kind) + " " + call.name, [&] { run(call, in); });
}

} // namespace

void record_calls(const std::string &path) {
    CHECK(calls::write_files(path.c_str()));
    const calls::Inputs in = calls::make_inputs();
    calls::for_each_allocating([&](const calls::Call &call) { section_of("call", call, in); });
    for (const calls::Call &call : calls::scalar_calls()) {
        section_of("scalar", call, in);
    }
    record.section("nothing", [&] { evaluate_nothing(in); });
    if (!record.quick()) {
        record.section("batches", evaluate_batches);
    }
    calls::destroy(in);
    calls::remove_files();
}

} // namespace recorded
