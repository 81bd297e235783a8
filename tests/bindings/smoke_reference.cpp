// SPDX-License-Identifier: MIT
// Prints what the good calls of tests/capi/calls return in C, for the smoke tests of the other languages:
//
//     eval|points|3ff0000000000000 0000000000000000 ...
//
// call, parameter, and the elements that the call wrote: bits of doubles and floats, integers, characters. Of a
// spline the degrees, the knots of all axes, and the homogeneous points; of a list the number of splines, and each
// of them: out.degrees, list[0].knots.
#include "calls/calls.h"
#include "generated/smoke_slots.h"

#include <bit>
#include <cinttypes>
#include <cstring>
#include <string>

namespace {

std::string where;

template <class Value, class Print>
void print(const char *name, std::span<const Value> values, const Print &print_one) {
    std::printf("%s%s|", where.c_str(), name);
    Value unwritten;
    std::memset(&unwritten, 0x5a, sizeof unwritten); // as FILL() leaves it
    const char *space = "";
    for (const Value &value : values) {
        if (std::memcmp(&value, &unwritten, sizeof value) != 0) {
            std::printf("%s", space);
            print_one(value);
            space = " ";
        }
    }
    std::puts("");
}

void print_doubles(const char *name, std::span<const double> values) {
    print(name, values, [](double x) { std::printf("%016" PRIx64, std::bit_cast<uint64_t>(x)); });
}

template <class Integer>
void print_integers(const char *name, std::span<const Integer> values) {
    print(name, values, [](Integer x) { std::printf("%" PRId64, static_cast<int64_t>(x)); });
}

// What f(arguments..., &answer) answers.
template <class Value, class Ask, class... Arguments>
Value answer(Ask ask, Arguments... arguments) {
    Value value{};
    CHECK_OK(ask(arguments..., &value));
    return value;
}

void print_spline(const char *name, const nurbs *g) {
    const std::string before = where;
    where += name;
    std::vector<int32_t> degrees;
    std::vector<double> knots;
    for (int32_t k = 0; k < answer<int32_t>(nurbs_axes, g); ++k) {
        degrees.push_back(answer<int32_t>(nurbs_degree, g, k));
        const int64_t count = answer<int64_t>(nurbs_count, g, k) + degrees.back() + 1;
        std::vector<double> own(static_cast<size_t>(count));
        CHECK_OK(nurbs_knots(g, k, count, own.data()));
        knots.insert(knots.end(), own.begin(), own.end());
    }
    const auto count = answer<int64_t>(nurbs_point_count, g);
    std::vector<double> points(static_cast<size_t>(count * (answer<int32_t>(nurbs_dimension, g) + 1)));
    CHECK_OK(nurbs_homogeneous_points(g, count, points.data(), 0, 0));
    print_integers<int32_t>(".degrees", degrees);
    print_doubles(".knots", knots);
    print_doubles(".points", points);
    where = before;
}

void print_statistics(const char *name, const nurbs_statistics *statistics) {
    int64_t length = 0;
    CHECK_OK(nurbs_statistics_to_bytes(statistics, 0, nullptr, &length));
    std::vector<unsigned char> bytes(static_cast<size_t>(length));
    CHECK_OK(nurbs_statistics_to_bytes(statistics, length, bytes.data(), nullptr));
    const std::vector<int32_t> numbers(bytes.begin(), bytes.end());
    print_integers<int32_t>((std::string(name) + ".bytes").c_str(), numbers);
}

void print_face(const std::string &name, const nurbs_face *face) {
    int64_t loops = 0;
    CHECK_OK(nurbs_face_loops(face, 0, nullptr, &loops));
    std::vector<int64_t> sizes(static_cast<size_t>(loops));
    CHECK_OK(nurbs_face_loops(face, loops, sizes.data(), nullptr));
    print_integers<int64_t>((name + ".sizes").c_str(), sizes);
    for (int64_t loop = 0; loop < loops; ++loop) {
        for (int64_t i = 0; i < sizes[static_cast<size_t>(loop)]; ++i) {
            nurbs *curve = nullptr;
            CHECK_OK(nurbs_face_curve(face, loop, i, &curve));
            print_spline((name + ".curves").c_str(), curve);
            nurbs_destroy(curve);
        }
    }
}

void print_model(const std::string &name, const nurbs_model *model) {
    int64_t counts[5];
    CHECK_OK(nurbs_model_counts(model, &counts[0], &counts[1], &counts[2], &counts[3], &counts[4]));
    print_integers<int64_t>((name + ".counts").c_str(), counts);
    for (int64_t i = 0; i < counts[2]; ++i) {
        nurbs_face *face = nullptr;
        CHECK_OK(nurbs_model_face(model, i, nullptr, nullptr, nullptr, nullptr, &face));
        print_face(name + ".faces", face);
        nurbs_face_destroy(face);
    }
    for (int64_t i = 0; i < counts[3]; ++i) {
        nurbs *edge = nullptr;
        CHECK_OK(nurbs_model_edge(model, i, nullptr, nullptr, nullptr, &edge));
        print_spline((name + ".edges").c_str(), edge);
        nurbs_destroy(edge);
    }
}

void print_meet(const std::string &name, const nurbs_meet *meet) {
    int64_t branches = 0, nodes = 0;
    CHECK_OK(nurbs_meet_counts(meet, &branches, &nodes, nullptr));
    std::vector<int32_t> kinds(static_cast<size_t>(nodes));
    CHECK_OK(nurbs_meet_nodes(meet, nodes, nullptr, kinds.data(), nullptr, nullptr, nullptr));
    print_integers<int32_t>((name + ".nodes").c_str(), kinds);
    for (int64_t i = 0; i < branches; ++i) {
        nurbs *curves[2] = {nullptr, nullptr};
        CHECK_OK(nurbs_meet_branch(meet, i, &curves[0], &curves[1]));
        for (nurbs *curve : curves) {
            print_spline((name + ".branches").c_str(), curve);
            nurbs_destroy(curve);
        }
    }
}

void print_mesh(const std::string &name, const nurbs_mesh *mesh) {
    int64_t points = 0, triangles = 0;
    CHECK_OK(nurbs_mesh_counts(mesh, &points, nullptr, &triangles, nullptr, nullptr, nullptr));
    std::vector<double> xyz(static_cast<size_t>(3 * points));
    std::vector<int64_t> corners(static_cast<size_t>(3 * triangles));
    CHECK_OK(nurbs_mesh_points(mesh, points, xyz.data(), nullptr));
    CHECK_OK(nurbs_mesh_triangles(mesh, 0, triangles, corners.data(), nullptr));
    print_doubles((name + ".points").c_str(), xyz);
    print_integers<int64_t>((name + ".corners").c_str(), corners);
}

void print_list(const char *name, const nurbs_list *list) {
    const std::string before = where;
    where += name;
    const auto count = answer<int64_t>(nurbs_list_count, list);
    print_integers<int64_t>(".count", {&count, 1});
    for (int64_t i = 0; i < count; ++i) {
        nurbs *g = nullptr;
        CHECK_OK(nurbs_list_get(list, i, &g));
        print_spline(("[" + std::to_string(i) + "]").c_str(), g);
        nurbs_destroy(g);
    }
    where = before;
}

void print_slot(const Slot &slot, const calls::Output &o) {
    const auto first = static_cast<size_t>(slot.first), length = static_cast<size_t>(slot.length);
    const std::string place = slot.place;
    if (place == "values") {
        print_doubles(slot.parameter, std::span(o.values).subspan(first, length));
    } else if (place == "singles") {
        print<float>(slot.parameter, std::span(o.singles).subspan(first, length),
                     [](float x) { std::printf("%08" PRIx32, std::bit_cast<uint32_t>(x)); });
    } else if (place == "spans") {
        print_integers<int64_t>(slot.parameter, std::span(o.spans).subspan(first, length));
    } else if (place == "states") {
        print_integers<int32_t>(slot.parameter, std::span(o.states).subspan(first, length));
    } else if (place == "text") {
        std::printf("%s%s|%s\n", where.c_str(), slot.parameter, o.text + first);
    } else if (place == "list") {
        print_list(slot.parameter, o.list);
    } else if (place == "statistics") {
        print_statistics(slot.parameter, o.statistics);
    } else if (place == "face") {
        print_face(slot.parameter, o.face);
    } else if (place == "model") {
        print_model(slot.parameter, o.model);
    } else if (place == "meet") {
        print_meet(slot.parameter, o.meet);
    } else if (place == "mesh") {
        print_mesh(slot.parameter, o.mesh);
    } else {
        print_spline(slot.parameter, place == "out" ? o.out : o.other);
    }
}

void print_call(const calls::Inputs &in, const calls::Call &call) {
    calls::Output o;
    CHECK_OK(call.run(in, o));
    where = std::string(call.name) + "|";
    std::printf("%sdone|\n", where.c_str());
    for (const Slot &slot : slots) {
        if (std::strcmp(slot.call, call.name) == 0) {
            print_slot(slot, o);
        }
    }
    destroy(o);
}

} // namespace

int main() {
    CHECK(calls::write_files("smoke_reference.igs"));
    const calls::Inputs in = calls::make_inputs();
    for (const calls::Call &call : calls::scalar_calls()) {
        print_call(in, call);
    }
    calls::for_each_allocating([&in](const calls::Call &call) { print_call(in, call); });
    destroy(in);
    return check_failures == 0 ? 0 : 1;
}
