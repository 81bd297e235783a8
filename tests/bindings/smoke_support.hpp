// SPDX-License-Identifier: MIT
// How the smoke test of C++ prints what calls return: see smoke_reference.cpp.
#ifndef TESTS_BINDINGS_SMOKE_SUPPORT_HPP
#define TESTS_BINDINGS_SMOKE_SUPPORT_HPP

#include <nurbs/nurbs.hpp>

#include <bit>
#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

inline std::string call;

inline void begin(const char *name) {
    call = name;
    std::printf("%s|done|\n", name);
}

inline void by_hand(const char *name) {
    std::printf("%s|by hand|\n", name);
}

inline libnurbs::CallOptions watched() {
    return {0, [](double) { return true; }};
}

inline std::string written(const char *path, const std::string &text) {
    std::ofstream(path, std::ios::binary) << text;
    return path;
}

inline void print(double x) {
    std::printf("%016" PRIx64, std::bit_cast<std::uint64_t>(x));
}
inline void print(float x) {
    std::printf("%08" PRIx32, std::bit_cast<std::uint32_t>(x));
}
template <std::integral Integer>
void print(Integer x) {
    std::printf("%" PRId64, static_cast<std::int64_t>(x));
}
inline void print(libnurbs::Status status) {
    print(static_cast<std::int32_t>(status));
}

// All elements, those of arrays inside too.
template <class Range>
void print_all(const Range &values) {
    for (const auto &value : values) {
        if constexpr (requires { value.size(); }) {
            print_all(value);
        } else {
            print(value);
            std::putchar(' ');
        }
    }
}

template <class Value>
void show(const std::string &name, const Value &value) {
    std::printf("%s|%s|", call.c_str(), name.c_str());
    if constexpr (requires { value.begin(); }) {
        print_all(value);
    } else {
        print(value);
    }
    std::putchar('\n');
}

inline void show(const std::string &name, const std::string &text) {
    std::printf("%s|%s|%s\n", call.c_str(), name.c_str(), text.c_str());
}

inline void show(const std::string &name, const libnurbs::Statistics &statistics) {
    std::vector<std::int32_t> bytes;
    for (const std::byte byte : statistics.to_bytes()) {
        bytes.push_back(std::to_integer<std::int32_t>(byte));
    }
    show(name + ".bytes", bytes);
}

inline void show(const std::string &name, const libnurbs::Spline &spline);

inline void show(const std::string &name, const libnurbs::Face &face) {
    const std::vector<std::int64_t> sizes = face.loops();
    show(name + ".sizes", sizes);
    for (std::size_t loop = 0; loop < sizes.size(); ++loop) {
        for (std::int64_t i = 0; i < sizes[loop]; ++i) {
            show(name + ".curves", face.curve(static_cast<std::int64_t>(loop), i));
        }
    }
}

inline void show(const std::string &name, const libnurbs::Model &model) {
    const libnurbs::ModelCounts n = model.counts();
    show(name + ".counts", std::vector<std::int64_t>{n.parts, n.uses, n.faces, n.edges, n.vertices});
    for (std::int64_t i = 0; i < n.faces; ++i) {
        show(name + ".faces", libnurbs::ModelFace(model.face(i)).face);
    }
    for (std::int64_t i = 0; i < n.edges; ++i) {
        show(name + ".edges", libnurbs::ModelEdge(model.edge(i)).spline);
    }
}

inline void show(const std::string &name, const libnurbs::Spline &spline) {
    std::vector<std::int32_t> degrees;
    std::vector<std::vector<double>> knots;
    for (std::int32_t axis = 0; axis < spline.axes(); ++axis) {
        degrees.push_back(spline.degree(axis));
        knots.push_back(spline.knots(axis));
    }
    show(name + ".degrees", degrees);
    show(name + ".knots", knots);
    show(name + ".points", spline.homogeneous_points());
}

inline void show(const std::string &name, const libnurbs::Meet &meet) {
    show(name + ".nodes", libnurbs::MeetNodes(meet.nodes()).kinds);
    const std::int64_t branches = libnurbs::MeetCounts(meet.counts()).branches;
    for (std::int64_t i = 0; i < branches; ++i) {
        const std::pair<libnurbs::Spline, libnurbs::Spline> curves = meet.branch(i);
        show(name + ".branches", curves.first);
        show(name + ".branches", curves.second);
    }
}

inline void show(const std::string &name, const libnurbs::Mesh &mesh) {
    show(name + ".points", mesh.points());
    show(name + ".corners", mesh.triangles());
}

inline void show(const std::string &name, const libnurbs::List &list) {
    show(name + ".count", list.size());
    for (std::int64_t i = 0; i < list.size(); ++i) {
        show(name + "[" + std::to_string(i) + "]", list[i]);
    }
}

#endif // TESTS_BINDINGS_SMOKE_SUPPORT_HPP
