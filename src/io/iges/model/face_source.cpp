// SPDX-License-Identifier: MIT
#include "io/iges/model/face_source.h"

#include "io/faces/domain_curve.h"
#include "io/faces/make_face.h"
#include "model/shapes/nearest_place.h"
#include "model/shapes/surface_spline.h"
#include "refine/forms/parametrization.h"

#include <algorithm>
#include <iterator>

namespace nrb::io::iges {
namespace {

std::vector<SplinePtr> curves_of(const std::vector<LoopSource> &loops) {
    std::vector<SplinePtr> result;
    for (const LoopSource &loop : loops) {
        std::ranges::copy_if(loop.curves, std::back_inserter(result),
                             [](const SplinePtr &curve) { return curve != nullptr; });
    }
    return result;
}

// The spline of a surface around its boundary. The extent follows from the curves in space; without them,
// from those in the domain.
model::MadeSurface surface_of(Geometry &geometry, const model::SurfaceShape &shape,
                              const std::vector<LoopSource> &loops, std::vector<Vector3> points) {
    for (const LoopSource &loop : loops) {
        for (const SpaceCurve &edge : loop.edges) {
            append_points(*edge.spline, points);
        }
    }
    const std::vector<SplinePtr> curves = curves_of(loops);
    if (points.empty() && !curves.empty()) {
        return {model::surface_spline(shape, range_under(shape, curves))};
    }
    return surface_around(geometry.entities(), shape, points, geometry.units().resolution);
}

// If a curve cannot be converted to the parameters of the spline, all are dropped, to be made from the edges.
void carry_over(const model::SurfaceShape &shape, const Spline &surface, bool all_digits, LoopSource &loop) {
    try {
        for (SplinePtr &curve : loop.curves) {
            if (curve != nullptr) {
                curve = in_spline_parameters(shape, surface, curve);
                curve = all_digits ? curve : snapped_to_ends(curve, surface);
            }
        }
    } catch (const Error &) {
        if (loop.edges.empty()) {
            throw;
        }
        loop.curves.clear();
    }
}

// Reverses a loop; some curves may still be missing.
void turn(face::Loop &loop) {
    std::reverse(loop.begin(), loop.end());
    for (face::Coedge &coedge : loop) {
        coedge.curve = coedge.curve == nullptr ? nullptr : refine::reverse(*coedge.curve, 0, false);
        coedge.against = !coedge.against;
    }
}

class PartsMaker {
public:
    PartsMaker(const FaceSource &source, double tolerance, int64_t first_key)
        : source_(source), tolerance_(tolerance), next_key_(first_key) {}

    MadeParts run(bool second) {
        made_.parts.surface = source_.surface;
        made_.parts.nearest = model::nearest_place(*source_.shape, source_.surface);
        if (source_.whole_domain) {
            add_boundary_of_domain();
        }
        for (const LoopSource &loop : source_.loops) {
            made_.parts.loops.emplace_back();
            const bool domain_rules = loop.edges.empty() || (loop.both() && loop.domain_rules != second);
            domain_rules ? add_curves(loop) : add_edges(loop);
            if (source_.mirrored) {
                turn(made_.parts.loops.back());
            }
        }
        return std::move(made_);
    }

private:
    void add_boundary_of_domain() {
        for (face::Loop &loop : face::natural_loops(face::Covering(*source_.surface, tolerance_))) {
            made_.parts.loops.emplace_back();
            for (face::Coedge &coedge : loop) {
                add_own(std::move(coedge), nullptr);
            }
        }
    }
    void add_curves(const LoopSource &loop) {
        if (std::ranges::find(loop.curves, nullptr) != loop.curves.end()) {
            fail(Status::syntax, "an edge that cannot be read has no curve in the domain");
        }
        const bool paired = loop.curves.size() == loop.edges.size();
        for (size_t i = 0; i < loop.curves.size(); ++i) {
            const SpaceCurve *const edge = paired ? &loop.edges[i] : nullptr;
            face::Coedge coedge{loop.curves[i], nullptr};
            if (edge != nullptr) {
                const SplinePtr curve = curve_under(loop.curves[i], *edge);
                coedge.edge = curve == nullptr ? nullptr : edge->spline;
                coedge.curve = curve == nullptr ? coedge.curve : curve;
                coedge.against = edge->against;
            }
            add(std::move(coedge), edge);
        }
    }
    void add_edges(const LoopSource &loop) {
        const bool paired = loop.curves.size() == loop.edges.size();
        for (size_t i = 0; i < loop.edges.size(); ++i) {
            const SpaceCurve &edge = loop.edges[i];
            add({paired ? curve_under(loop.curves[i], edge) : nullptr, edge.spline, 0, edge.against}, &edge);
        }
    }

    // The curve in the domain, oriented as the edge runs in the boundary, if it lies under the edge; else
    // null. Both directions are tried, since files disagree on it.
    [[nodiscard]] SplinePtr curve_under(const SplinePtr &curve, const SpaceCurve &edge) const {
        if (curve == nullptr) {
            return nullptr;
        }
        const SplinePtr along = edge.against ? refine::reverse(*edge.spline, 0, false) : edge.spline;
        if (lies_under(*source_.surface, *curve, *along, tolerance_)) {
            return curve;
        }
        SplinePtr back = refine::reverse(*curve, 0, false);
        return lies_under(*source_.surface, *back, *along, tolerance_) ? back : nullptr;
    }

    void add(face::Coedge coedge, const SpaceCurve *edge) {
        if (edge != nullptr && edge->edge >= 0) {
            coedge.key = edge->edge + 1;
            made_.parts.loops.back().push_back(std::move(coedge));
        } else {
            add_own(std::move(coedge), edge == nullptr ? nullptr : edge->shape);
        }
    }
    void add_own(face::Coedge coedge, model::CurveShapePtr shape) {
        coedge.key = next_key_++;
        made_.own.push_back(
            {coedge.edge == nullptr ? nullptr : std::move(shape), made_.parts.loops.size() - 1});
        made_.parts.loops.back().push_back(std::move(coedge));
    }

    const FaceSource &source_;
    double tolerance_;
    int64_t next_key_;
    MadeParts made_;
};

} // namespace

FaceSource make_source(Geometry &geometry, const Surface &surface, std::vector<LoopSource> loops,
                       bool whole_domain, const std::vector<Vector3> &poles) {
    const bool mirrored = surface.map.swapped != (surface.map.scale[0] * surface.map.scale[1] < 0);
    FaceSource source{surface.shape, nullptr, std::move(loops), whole_domain, mirrored};
    model::MadeSurface made = surface_of(geometry, *source.shape, source.loops, poles);
    source.surface = std::move(made.spline);
    source.distance = made.distance;
    for (LoopSource &loop : source.loops) {
        carry_over(*source.shape, *source.surface, geometry.units().all_digits, loop);
    }
    return source;
}

MadeParts parts_of(const FaceSource &source, bool second, double tolerance, int64_t first_key) {
    return PartsMaker(source, tolerance, first_key).run(second);
}

bool has_two_ways(const FaceSource &source) noexcept {
    return std::any_of(source.loops.begin(), source.loops.end(),
                       [](const LoopSource &loop) { return loop.both(); });
}

} // namespace nrb::io::iges
