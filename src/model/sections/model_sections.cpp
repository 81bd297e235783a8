// SPDX-License-Identifier: MIT
#include "model/sections/model_sections.h"

#include "base/watch.h"
#include "model/sections/section_joints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace nrb::model {

namespace {

using intersect::Meet;

// The same plane, with a normal whose largest coordinate is about 1.
SectionPlane scaled(const SectionPlane &plane) noexcept {
    const int exponent = size_exponent(plane.normal);
    return {times_power(plane.normal, -exponent), std::ldexp(plane.offset, -exponent)};
}

// Groups planes by their normals. A plane whose scaled offset overflows is out of reach, and is left out.
std::vector<ParallelPlanes> sorted(std::span<const SectionPlane> planes) {
    struct Level {
        double offset;
        int64_t level;
        auto operator<=>(const Level &) const = default;
    };
    std::map<std::array<double, 3>, std::vector<Level>> by_normal;
    for (size_t i = 0; i < planes.size(); ++i) {
        const auto &[normal, offset] = planes[i];
        if (std::isfinite(offset)) {
            by_normal[{normal.x, normal.y, normal.z}].push_back({offset, static_cast<int64_t>(i)});
        }
    }
    std::vector<ParallelPlanes> groups;
    for (auto &[normal, levels] : by_normal) {
        std::ranges::sort(levels);
        groups.push_back({{normal[0], normal[1], normal[2]}, {}, {}});
        for (const Level &level : levels) {
            groups.back().offsets.push_back(level.offset);
            groups.back().levels.push_back(level.level);
        }
    }
    return groups;
}

FaceSections cut_faces(const Model &model, const SharedBorders &borders,
                       const std::vector<Instance> &instances, const std::vector<Placement> &placements,
                       const std::vector<ParallelPlanes> &groups, double tolerance) {
    FaceCutter cutter(model, borders, tolerance);
    std::vector<std::vector<int64_t>> of_part(model.parts.size());
    int64_t placed = 0;
    for (size_t i = 0; i < model.faces.size(); ++i) {
        of_part[static_cast<size_t>(model.faces[i].part)].push_back(static_cast<int64_t>(i));
    }
    for (const Instance &instance : instances) {
        placed += std::ssize(of_part[static_cast<size_t>(instance.part)]);
    }
    FaceSections found;
    Steps steps(placed);
    for (size_t i = 0; i < instances.size(); ++i) {
        for (const int64_t face : of_part[static_cast<size_t>(instances[i].part)]) {
            for (const ParallelPlanes &planes : groups) {
                cutter.add(face, static_cast<int64_t>(i), placements[i], planes, found);
                count_work(100);
            }
            steps.next();
        }
    }
    return found;
}

} // namespace

Meet model_sections(const Model &model, std::span<const SectionPlane> planes, double tolerance) {
    // The caller's limit of work is for all faces. Without one, each level of a face has the usual limit of
    // its own.
    const LimitedSearch whole;
    std::vector<SectionPlane> own;
    std::vector<Vector3> normals;
    for (const SectionPlane &plane : planes) {
        own.push_back(scaled(plane));
        normals.push_back(own.back().normal);
    }
    const std::vector<Instance> instances = instances_of(model);
    std::vector<Placement> placements;
    for (size_t i = 0; i < instances.size(); ++i) {
        placements.emplace_back(instances, i);
    }
    const SharedBorders borders(model);
    FaceSections found = cut_faces(model, borders, instances, placements, sorted(own), tolerance);
    SectionJoints(model, borders, placements, normals, found).run();
    found.meet.tidy_nodes();
    return with_loops(arranged(std::move(found.meet)));
}

} // namespace nrb::model
