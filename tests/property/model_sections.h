// Sections of models through the C interface, for tests.
#pragma once

#include "property/models.h"
#include "property/sections.h"

namespace model_sections {

using namespace support;
using namespace support::models;
using surface_sections::Branch;
using surface_sections::dot;
using surface_sections::Found;
using surface_sections::MeetHandle;
using surface_sections::Point3;

struct Plane {
    Point3 normal;
    double offset;
};

struct Way {
    int64_t level = -1;
    std::vector<size_t> branches;
    bool closed = false;
    double gap = 0;
};

struct Section {
    Found found;
    std::vector<Way> ways;
    std::vector<int64_t> faces, instances, next_nodes, node_faces;
    std::vector<double> gaps;

    [[nodiscard]] int64_t open() const { return std::ranges::count(ways, false, &Way::closed); }
};

inline void add_ways(const nurbs_meet *meet, Section &section) {
    int64_t count = 0;
    require_ok(nurbs_meet_ways(meet, 0, nullptr, nullptr, nullptr, nullptr, nullptr, &count));
    const auto n = static_cast<size_t>(count);
    std::vector<int64_t> levels(n), firsts(n), sizes(n);
    std::vector<int32_t> closed(n);
    std::vector<double> gaps(n);
    require_ok(nurbs_meet_ways(meet, count, levels.data(), firsts.data(), sizes.data(), closed.data(),
                               gaps.data(), nullptr));
    size_t next = 0;
    for (size_t i = 0; i < n; ++i) {
        Way way{levels[i], {}, closed[i] == 1, gaps[i]};
        EXPECT_EQ(firsts[i], static_cast<int64_t>(next));
        for (int64_t k = 0; k < sizes[i]; ++k) {
            way.branches.push_back(next++);
        }
        section.ways.push_back(std::move(way));
    }
    EXPECT_EQ(next, section.found.branches.size());
}

inline Section section_in(const nurbs_meet *meet) {
    Section section;
    section.found = surface_sections::found_in(meet);
    const size_t branches = section.found.branches.size(), nodes = section.found.nodes.size();
    section.faces.resize(branches);
    section.instances.resize(branches);
    section.next_nodes.resize(nodes);
    section.node_faces.resize(nodes);
    section.gaps.resize(nodes);
    require_ok(nurbs_meet_faces(meet, std::ssize(section.faces), section.faces.data(),
                                section.instances.data(), nullptr));
    require_ok(nurbs_meet_joints(meet, std::ssize(section.gaps), section.next_nodes.data(),
                                 section.gaps.data(), section.node_faces.data(), nullptr, nullptr));
    add_ways(meet, section);
    return section;
}

inline Section section_of(const nurbs_model *model, const std::vector<Plane> &planes, double tolerance,
                          const nurbs_call_options *call = nullptr) {
    std::vector<double> normals, offsets;
    for (const Plane &plane : planes) {
        normals.insert(normals.end(), plane.normal.begin(), plane.normal.end());
        offsets.push_back(plane.offset);
    }
    nurbs_meet *meet = nullptr;
    require_ok(nurbs_model_sections_with(model, std::ssize(planes), normals.data(), offsets.data(), tolerance,
                                         call, &meet));
    return section_in(MeetHandle(meet).get());
}

inline Point3 cross(const Point3 &a, const Point3 &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Point3 minus(const Point3 &a, const Point3 &b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// Many points of a way, one after the other.
inline std::vector<Point3> polygon_of(const Section &section, const Way &way, int each = 128) {
    std::vector<Point3> points;
    for (const size_t i : way.branches) {
        const Branch &branch = section.found.branches[i];
        const std::vector<Point3> own = surface_sections::points_on(branch.space.get(), branch.params(each));
        points.insert(points.end(), own.begin(), own.end());
    }
    return points;
}

// What a way encloses, > 0 if it runs anticlockwise as seen from the tip of the normal: half the integral of n . (x cross dx), with
// what is missed between points counted as for arcs, of two thirds of the triangles by which every second point is off.
inline double area_of(const Section &section, const Way &way, const Point3 &normal) {
    const double length = std::sqrt(dot(normal, normal));
    const auto sum = [&](int each) {
        const std::vector<Point3> points = polygon_of(section, way, each);
        double twice = 0;
        for (size_t i = 0; i < points.size(); ++i) {
            const Point3 from = minus(points[i], points[0]),
                         to = minus(points[(i + 1) % points.size()], points[0]);
            twice += dot(normal, cross(from, to)) / length;
        }
        return twice / 2;
    };
    return (4 * sum(256) - sum(128)) / 3;
}

inline double area_of(const Section &section, int64_t level, const Point3 &normal) {
    double sum = 0;
    for (const Way &way : section.ways) {
        sum += way.level == level ? area_of(section, way, normal) : 0;
    }
    return sum;
}

inline double length_of(const Section &section, const Way &way) {
    double sum = 0;
    for (const size_t i : way.branches) {
        double own = 0;
        require_ok(nurbs_curve_length(section.found.branches[i].space.get(), nullptr, 1e-10, &own, nullptr));
        sum += own;
    }
    return sum;
}

// How often the ways of a level run around a place of their plane, and how near to it they come.
struct Winding {
    double turns = 0, nearest = HUGE_VAL;
};
inline Winding winding_of(const Section &section, int64_t level, const Point3 &normal, const Point3 &x) {
    Winding winding;
    for (const Way &way : section.ways) {
        if (way.level != level) {
            continue;
        }
        const std::vector<Point3> points = polygon_of(section, way, 48);
        for (size_t i = 0; i < points.size(); ++i) {
            const Point3 a = minus(points[i], x), b = minus(points[(i + 1) % points.size()], x);
            winding.turns += std::atan2(dot(normal, cross(a, b)) / std::sqrt(dot(normal, normal)), dot(a, b));
            winding.nearest = std::min(winding.nearest, std::sqrt(dot(a, a)));
        }
    }
    winding.turns /= 2 * 3.14159265358979323846;
    return winding;
}

// Curves lie in their planes and on their faces, branches end in nodes of their planes, and those that go on in each other begin where
// the others end, to within the gaps that are told.
inline void check_section(const nurbs_model *model, const Section &section, const std::vector<Plane> &planes,
                          double tolerance) {
    const Found &found = section.found;
    std::vector<std::vector<Point3>> ends(found.nodes.size());
    for (size_t i = 0; i < found.branches.size(); ++i) {
        const Branch &branch = found.branches[i];
        const Plane &plane = planes[static_cast<size_t>(branch.level)];
        const double length = std::sqrt(dot(plane.normal, plane.normal));
        const Face face = face_of(model, section.faces[i]);
        nurbs *made = nullptr;
        require_ok(nurbs_face_surface(face.get(), &made));
        const Handle surface(made);
        const std::vector<double> t = branch.params(40);
        const std::vector<Point3> points = surface_sections::points_on(branch.space.get(), t);
        const std::vector<surface_sections::Place> places = surface_sections::places_on(branch.on.get(), t);
        for (size_t k = 0; k < t.size(); ++k) {
            ASSERT_LE(std::abs(dot(plane.normal, points[k]) - plane.offset) / length, 1.01 * tolerance);
            const surface_sections::Ground ground(surface.get(), std::array<bool, 2>{true, true});
            ASSERT_LE(ground.gap(places[k], points[k]), 2 * tolerance);
        }
        for (const size_t end : {size_t{0}, size_t{1}}) {
            if (branch.nodes[end] >= 0) {
                ends[static_cast<size_t>(branch.nodes[end])].push_back(end == 0 ? points.front()
                                                                                : points.back());
            }
        }
    }
    for (size_t i = 0; i < found.nodes.size(); ++i) {
        if (const int64_t next = section.next_nodes[i]; next >= 0) {
            const auto other = static_cast<size_t>(next);
            ASSERT_EQ(section.next_nodes[other], static_cast<int64_t>(i));
            ASSERT_EQ(ends[i].size(), 1U);
            ASSERT_NEAR(surface_sections::distance(ends[i][0], ends[other][0]), section.gaps[i],
                        1e-9 * (1 + section.gaps[i]) + 1e-12);
        }
    }
    for (const Way &way : section.ways) {
        for (const size_t i : way.branches) {
            ASSERT_EQ(found.branches[i].level, way.level);
            ASSERT_EQ(found.branches[i].loop >= 0, way.closed);
        }
    }
}

} // namespace model_sections
