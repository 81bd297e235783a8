// SPDX-License-Identifier: MIT
#include "io/faces/stated_offset.h"

#include "base/error.h"
#include "bounds/box.h"
#include "io/faces/make_face.h"
#include "model/shapes/curve_spline.h"

namespace nrb::io {

namespace {

constexpr double share = 0.25;              // of the tolerance; the rest is left to other errors
constexpr double share_of_size = 0x1p-30;   // of a curve in the plane
constexpr int64_t doubles_of_a_piece = 128; // while the offset is computed

double tolerance_for(const model::CurveShape &basis, double stated) {
    if (basis.place.dim == 2 && model::bounded(basis)) {
        return share_of_size * bounds::extent(*model::curve_spline(basis));
    }
    return share * (stated > 0 ? stated : usual_tolerance);
}

} // namespace

model::MadeCurve stated_offset(Limits &limits, const model::CurveShapePtr &basis,
                               const fit::CurveOffset &offset, double stated) {
    return stated_offset(limits, basis, std::span(&offset.distance, 1), offset.reference, stated);
}

model::MadeCurve stated_offset(Limits &limits, const model::CurveShapePtr &basis,
                               std::span<const double> distances, const Vector3 &reference, double stated) {
    const bool known = model::has_known_offset(*basis, {distances.front(), reference});
    const fit::OffsetRule rule{known ? usual_tolerance : tolerance_for(*basis, stated),
                               limits.left() / doubles_of_a_piece, &limits.patches()};
    model::MadeCurve made = model::offset_curve_shape(basis, distances, reference, rule, stated);
    made.missed = made.distance > rule.tolerance / share ? rule.tolerance / share : 0;
    return made;
}

std::string note_on(const model::MadeCurve &made) {
    std::string text;
    if (made.distance > 0) {
        text = std::string("its offset curve is approximated within ") + Number(made.distance).text;
        if (made.missed > 0) {
            text +=
                std::string(", which is more than the ") + Number(made.missed).text + " that it should be";
        }
    }
    if (made.turns_back) {
        text += text.empty() ? "its offset curve" : ", and";
        text += " runs against the basis where the radius of curvature of that is below the distance";
    }
    return text;
}

} // namespace nrb::io
