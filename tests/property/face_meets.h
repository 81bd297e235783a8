// Where faces meet, through the C interface, for tests.
#pragma once

#include "property/crossings.h"
#include "property/models.h"

namespace face_meets {

using namespace surface_crossings;
using support::models::Face;

// By kinds of branches.
struct FaceMeet {
    Crossing crossing;
    std::vector<int32_t> kinds;

    [[nodiscard]] int64_t count(int32_t kind) const { return std::ranges::count(kinds, kind); }
    [[nodiscard]] double length(int32_t kind) const {
        double sum = 0;
        for (size_t i = 0; i < kinds.size(); ++i) {
            double own = 0;
            require_ok(
                nurbs_curve_length(crossing.found.branches[i].space.get(), nullptr, 1e-9, &own, nullptr));
            sum += kinds[i] == kind ? own : 0;
        }
        return sum;
    }
    [[nodiscard]] bool complete() const { return crossing.found.complete; }
};

inline FaceMeet face_meet_in(const nurbs_meet *meet) {
    FaceMeet found{crossing_in(meet), {}};
    found.kinds.resize(found.crossing.found.branches.size());
    require_ok(nurbs_meet_kinds(meet, std::ssize(found.kinds), found.kinds.data(), nullptr));
    return found;
}

inline FaceMeet face_meet(const nurbs_face *a, const nurbs_face *b, double tolerance) {
    nurbs_meet *meet = nullptr;
    require_ok(nurbs_face_intersections(a, b, tolerance, &meet));
    return face_meet_in(MeetHandle(meet).get());
}

} // namespace face_meets
