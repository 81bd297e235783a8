/* SPDX-License-Identifier: MIT */
// Every function with arrays that end where a page begins that is not mapped, and with arrays that begin
// where one ends (guarded/pages.h): no call reads or writes beside them. This file and its copy of the calls
// are compiled with functions that move all arrays there; all functions are called, and every array of each
// is there in some call.
#include "guarded/batches.h"

#include <array>
#include <csignal>
#include <cstdio>

namespace {

// The first message of a program that touched a guarding page, and its last.
void report(int) {
    const auto say = [](const char *text) { (void)!write(STDERR_FILENO, text, std::strlen(text)); };
    say(guarded::running);
    say(guarded::side == guarded::Side::end ? ": an array was left at its end\n"
                                            : ": an array was left at its start\n");
    _exit(1);
}

void run(const calls::Call &call, const calls::Inputs &in) {
    calls::Output o;
    const nurbs_status status = call.run(in, o);
    if (status != NURBS_OK) {
        std::fprintf(stderr, "%s: %s\n", call.name, nurbs_status_name(status));
        ++check_failures;
    }
    calls::destroy(o);
}

// Names and bytes, for which the table of the calls has no place.
void names_and_bytes(const calls::Inputs &in) {
    const nurbs *const splines[] = {in.curve, in.loop};
    const nurbs *const surface = in.surface;
    const char *const names[] = {"curve", "loop"};
    std::array<unsigned char, 1 << 14> bytes{};
    nurbs_list *list = nullptr;
    CHECK_OK(nurbs_list_create(2, splines, names, 1, &list));
    CHECK_OK(nurbs_list_to_bytes(list, std::ssize(bytes), bytes.data(), nullptr));
    CHECK_OK(nurbs_to_bytes(in.curve, std::ssize(bytes), bytes.data(), nullptr));
    CHECK_OK(nurbs_face_to_bytes(in.face, std::ssize(bytes), bytes.data(), nullptr));
    CHECK_OK(nurbs_model_to_bytes(in.model, std::ssize(bytes), bytes.data(), nullptr));
    nurbs_list *in_space = nullptr;
    CHECK_OK(nurbs_list_create(1, &surface, names, 1, &in_space));
    CHECK_OK(
        nurbs_list_write(in_space, NURBS_FORMAT_STEP, nullptr, std::ssize(bytes), bytes.data(), nullptr));
    CHECK_OK(nurbs_list_write_with(in_space, NURBS_FORMAT_STEP, nullptr, std::ssize(bytes), bytes.data(),
                                   nullptr, nullptr));
    CHECK_OK(
        nurbs_model_write(in.model, NURBS_FORMAT_STEP, nullptr, std::ssize(bytes), bytes.data(), nullptr));
    CHECK_OK(nurbs_model_write_with(in.model, NURBS_FORMAT_STEP, nullptr, std::ssize(bytes), bytes.data(),
                                    nullptr, nullptr));
    CHECK_OK(nurbs_mesh_write(in.mesh, NURBS_FORMAT_STL, nullptr, std::ssize(bytes), bytes.data(), nullptr));
    CHECK_OK(nurbs_mesh_write_with(in.mesh, NURBS_FORMAT_STL, nullptr, std::ssize(bytes), bytes.data(),
                                   nullptr, nullptr));
    nurbs_list_destroy(in_space);
    nurbs_list_destroy(list);
}

// The gaps of loops, which the good calls leave out.
void gaps_of_loops(const calls::Inputs &in) {
    const int64_t size = 1;
    const nurbs *const curves[] = {in.outline};
    double gap = -1;
    nurbs_face *face = nullptr;
    CHECK_OK(nurbs_face_create(in.surface, 1, &size, curves, nullptr, nullptr, 1e-3, 0, &gap, &face));
    nurbs_face_destroy(face);
    CHECK_OK(nurbs_face_create_with(in.surface, 1, &size, curves, nullptr, nullptr, 1e-3, 0, &gap, nullptr,
                                    &face));
    nurbs_face_destroy(face);
    CHECK(gap == 0);
}

void all_calls() {
    const calls::Inputs in = calls::make_inputs();
    calls::for_each_allocating([&](const calls::Call &call) { run(call, in); });
    for (const calls::Call &call : calls::scalar_calls()) {
        run(call, in);
    }
    evaluate_nothing(in);
    evaluate_batches();
    names_and_bytes(in);
    gaps_of_loops(in);
    calls::check_intact(in);
    calls::destroy(in);
}

// Prints what was done; what was not is a failure.
void check_complete() {
    int64_t calls = 0, arrays = 0;
    for (const guarded::Function &function : guarded::functions) {
        calls += function.calls;
        if (function.calls == 0) {
            std::fprintf(stderr, "%s was not called\n", function.name);
            ++check_failures;
        }
    }
    for (const guarded::Argument &array : guarded::arrays) {
        arrays += array.times;
        if (array.times == 0) {
            std::fprintf(stderr, "%s: %s was NULL or empty in all calls\n", array.function, array.name);
            ++check_failures;
        }
    }
    std::printf("%zu functions, %zu arrays: %lld calls with %lld arrays\n", std::size(guarded::functions),
                std::size(guarded::arrays), static_cast<long long>(calls), static_cast<long long>(arrays));
}

} // namespace

int main() {
    std::signal(SIGSEGV, report);
    std::signal(SIGBUS, report);
    const char *const path = "guarded_pages_test.igs";
    CHECK(calls::write_files(path));
    for (const guarded::Side side : {guarded::Side::end, guarded::Side::start}) {
        guarded::side = side;
        all_calls();
    }
    check_complete();
    calls::remove_files();
    return check_summary("guarded pages");
}
