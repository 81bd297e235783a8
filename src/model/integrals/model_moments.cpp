// SPDX-License-Identifier: MIT
#include "model/integrals/model_moments.h"

#include "base/representable.h"
#include "base/watch.h"
#include "face/integrals/face_integral.h"
#include "measure/elements.h"
#include "measure/moment_integrand.h"
#include "model/integrals/placed_body.h"
#include "model/rays/closed.h"
#include "model/rays/instances.h"
#include "model/sections/shared_borders.h"
#include "numeric/sum.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace nrb::model {

namespace {

using face::TrimmedSurface;
using measure::MomentOrder;

pieces::Frame frame_of(const std::vector<TrimmedSurface> &surfaces) {
    std::vector<const Spline *> all;
    all.reserve(surfaces.size());
    for (const TrimmedSurface &own : surfaces) {
        all.push_back(own.surface);
    }
    return measure::integral_frame(all);
}

// The instances of each part.
std::vector<std::vector<size_t>> instances_by_part(const Model &model,
                                                   const std::vector<Instance> &instances) {
    std::vector<std::vector<size_t>> found(model.parts.size());
    for (size_t i = 0; i < instances.size(); ++i) {
        found[static_cast<size_t>(instances[i].part)].push_back(i);
    }
    return found;
}

// The faces of one solid, or those faces of a part that bound none, oriented by their outer normals.
struct Shells {
    int64_t part;
    std::vector<TrimmedSurface> surfaces;
};

std::vector<Shells> shells_of(const Model &model) {
    const SharedBorders borders(model);
    std::map<std::pair<int64_t, int64_t>, size_t> number;
    std::vector<Shells> found;
    for (size_t i = 0; i < model.faces.size(); ++i) {
        const ModelFace &face = model.faces[i];
        const auto [at, is_new] = number.try_emplace({face.part, face.solid}, found.size());
        if (is_new) {
            found.push_back({face.part, {}});
        }
        const bool other_side = face.against != borders.is_turned(static_cast<int64_t>(i));
        found[at->second].surfaces.push_back({face.face->surface().get(), &face.face->trims(), other_side});
    }
    return found;
}

// Recovers the second moments S from the inertia tensor I = trace(S) E - S, where E is the identity. Since
// trace(I) = 2 trace(S), S = trace(I) E / 2 - I.
void set_second(const measure::Moments &found, double sign, Body &body) {
    const double half = (found.inertia[0] + found.inertia[4] + found.inertia[8]) / 2;
    for (size_t i = 0; i < 3; ++i) {
        for (size_t j = 0; j < 3; ++j) {
            body.second[i][j] = sign * ((i == j ? half : 0) - found.inertia[3 * i + j]);
        }
    }
}

// Moments are computed in units of the frame, in which they are representable. If the volume is 0 to
// rounding, there is no centroid, and only the volume is set.
Body body_of(const Shells &shells, MomentOrder order, double relative_tolerance) {
    pieces::Frame frame = frame_of(shells.surfaces);
    const measure::Integrals sums =
        face::integrate(shells.surfaces, measure::BoundaryIntegrand(3, order), frame, relative_tolerance);
    Body body{frame.exponent};
    std::copy_n(sums.values.end() - 3, 3, body.vector_area.begin());
    for (double &x : frame.centre) {
        x = std::ldexp(x, -frame.exponent);
    }
    frame.exponent = 0;
    const bool empty = !(std::abs(sums.values[0]) > 16 * eps * sums.size);
    const MomentOrder known = empty ? MomentOrder::content : order;
    const measure::Moments found =
        measure::moments_from(sums, 3, measure::enclosed_factors(3), frame, known, relative_tolerance);
    const double sign = found.content < 0 ? -1 : 1;
    body.volume = sign * found.content;
    body.error = found.error;
    std::ranges::copy(found.centroid, body.centroid.begin());
    if (known == MomentOrder::inertia) {
        set_second(found, sign, body);
    }
    return body;
}

// An area in units of 2^power.
struct Area {
    double value, error;
    int power;
};

Area area_of(const std::vector<TrimmedSurface> &surfaces, double relative_tolerance) {
    pieces::Frame frame = frame_of(surfaces);
    const measure::MomentIntegrand integrand(2, 3, MomentOrder::content);
    const measure::Integrals sums = face::integrate(surfaces, integrand, frame, relative_tolerance);
    const int power = 2 * std::exchange(frame.exponent, 0);
    const measure::Moments found =
        measure::moments_from(sums, 0, {1, 1, 1, 2}, frame, MomentOrder::content, relative_tolerance);
    return {found.content, found.error, power};
}

// The area under a placement that multiplies all distances by one factor, to rounding. The error covers the
// difference from such a similarity.
Area magnified(Area area, const Placement &placement) {
    int exponent = 0;
    const double factor = std::frexp(placement.growth_to_whole(), &exponent);
    const double uneven = placement.growth_to_whole() * placement.growth_to_part() - 1;
    area.value *= factor * factor;
    area.error = factor * factor * area.error + 4 * uneven * area.value;
    area.power += 2 * exponent;
    return area;
}

measure::Moments sum_of(const std::vector<Area> &areas) {
    int power = -5000;
    for (const Area &area : areas) {
        power = std::max(power, area.power);
    }
    CompensatedSum value, error;
    for (const Area &area : areas) {
        value.add(std::ldexp(area.value, area.power - power));
        error.add(std::ldexp(area.error, area.power - power));
    }
    measure::Moments found;
    found.content = std::ldexp(value.value(), power);
    found.error = std::ldexp(error.value(), power);
    require_representable({&found.content, 1}, "area");
    return found;
}

// The area of the faces of a part in one of its instances. For placements that are similarities, the area in
// the part is integrated once and scaled.
class PartArea {
public:
    PartArea(std::vector<face::FacePtr> &&faces, double relative_tolerance)
        : tolerance_(relative_tolerance), faces_(std::move(faces)) {}
    Area in(const Placement &placement) {
        if (!placement.keeps_ratios()) {
            return area_of(&placement);
        }
        if (!own_) {
            own_ = area_of(nullptr);
        }
        return magnified(*own_, placement);
    }
    [[nodiscard]] bool empty() const noexcept { return faces_.empty(); }

private:
    [[nodiscard]] Area area_of(const Placement *placement) const {
        std::vector<SplinePtr> kept;
        std::vector<TrimmedSurface> surfaces;
        for (const face::FacePtr &face : faces_) {
            kept.push_back(placement != nullptr ? placement->in_whole(face->surface()) : face->surface());
            surfaces.push_back({kept.back().get(), &face->trims()});
        }
        return model::area_of(surfaces, tolerance_);
    }

    double tolerance_;
    std::vector<face::FacePtr> faces_;
    std::optional<Area> own_;
};

} // namespace

measure::Moments area(const Model &model, double relative_tolerance) {
    const std::vector<Instance> instances = instances_of(model);
    const std::vector<std::vector<size_t>> of_part = instances_by_part(model, instances);
    std::vector<std::vector<face::FacePtr>> faces(model.parts.size());
    for (const ModelFace &face : model.faces) {
        faces[static_cast<size_t>(face.part)].push_back(face.face);
    }
    std::vector<Area> areas;
    Steps steps(std::ssize(of_part));
    for (size_t part = 0; part < of_part.size(); ++part, steps.next()) {
        PartArea own(std::move(faces[part]), relative_tolerance);
        for (const size_t i : of_part[part]) {
            if (!own.empty()) {
                areas.push_back(own.in(Placement(instances, i)));
            }
        }
    }
    return sum_of(areas);
}

measure::Moments volume(const Model &model, MomentOrder order, double relative_tolerance) {
    check_closed(model);
    const std::vector<Instance> instances = instances_of(model);
    const std::vector<std::vector<size_t>> of_part = instances_by_part(model, instances);
    const std::vector<Shells> all = shells_of(model);
    std::vector<Body> bodies;
    Steps steps(std::ssize(all));
    for (const Shells &shells : all) {
        const Body body = body_of(shells, order, relative_tolerance);
        for (const size_t i : of_part[static_cast<size_t>(shells.part)]) {
            bodies.push_back(placed(body, instances[i].placement));
        }
        steps.next();
    }
    return moments_of(bodies, order);
}

} // namespace nrb::model
