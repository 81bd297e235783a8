/* SPDX-License-Identifier: MIT */
// The splines that the calls share, and the arrays that they write to.
#include "calls/calls.h"

#include "iges_text.h"

#include <cstdio>

namespace calls {

namespace {

nurbs *make_homogeneous() {
    static const int32_t degree = 2;
    static const int64_t count = 3;
    static const double knots[] = {0, 0, 0, 1, 1, 1}, records[] = {1, 0, 1, 0, 1, 0, -1, 0, 1};
    nurbs *g = nullptr;
    CHECK_OK(nurbs_create_homogeneous(1, &degree, &count, knots, 6, 2, records, 0, 0, 0, &g));
    return g;
}

// One conic piece over knots that are not clamped.
nurbs *make_segment() {
    static const int32_t degree = 2;
    static const int64_t count = 3;
    static const double knots[] = {0, 1, 2, 3, 4, 5}, points[] = {0, 0, 1, 1, 2, 0}, weights[] = {1, 3, 5};
    nurbs *g = nullptr;
    CHECK_OK(nurbs_create(1, &degree, &count, knots, 6, 2, points, 0, 0, weights, 0, 0, &g));
    return g;
}

} // namespace

const char *file_path = nullptr;

bool write_file(const char *path) {
    const IgesText file = small_file();
    file_path = path;
    std::FILE *f = std::fopen(path, "wb");
    const auto size = static_cast<size_t>(file.size);
    return f != nullptr && std::fwrite(file.bytes, 1, size, f) == size && std::fclose(f) == 0;
}

Inputs make_inputs() {
    const IgesText file = small_file();
    Inputs in{make(circle()),     make(loop()),  make(trough()), make(cube()),
              make_homogeneous(), make(twist()), make_segment(), nullptr};
    CHECK_OK(nurbs_read(file.bytes, file.size, nullptr, &in.list));
    return in;
}

void destroy(const Inputs &in) {
    for (nurbs *g : {in.curve, in.loop, in.surface, in.volume, in.homogeneous, in.twist, in.segment}) {
        nurbs_destroy(g);
    }
    nurbs_list_destroy(in.list);
}

void check_intact(const Inputs &in) {
    CHECK_POINTS(in.curve, circle().points);
    CHECK_WEIGHTS(in.curve, circle().weights);
    CHECK_KNOTS(in.curve, 0, circle().knots);
    CHECK_POINTS(in.loop, loop().points);
    CHECK_POINTS(in.surface, trough().points);
    CHECK_POINTS(in.volume, cube().points);
    CHECK_POINTS(in.twist, twist().points);
}

Output::Output() {
    FILL(values);
    FILL(singles);
    FILL(spans);
    FILL(states);
    FILL(text);
}

void destroy(const Output &o) {
    nurbs_destroy(o.out == check_poison() ? nullptr : o.out);
    nurbs_list_destroy(o.list);
}

void check_nothing_written(const Output &o) {
    CHECK(o.out == nullptr || o.out == check_poison());
    CHECK(o.list == nullptr);
    CHECK_UNTOUCHED(o.values);
    CHECK_UNTOUCHED(o.singles);
    CHECK_UNTOUCHED(o.spans);
    CHECK_UNTOUCHED(o.states);
    CHECK_UNTOUCHED(o.text);
}

} // namespace calls
