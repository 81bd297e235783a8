// SPDX-License-Identifier: MIT
#include "face/face.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "bounds/box.h"
#include "face/checks/crossings.h"
#include "face/trims/monotone.h"
#include "refine/forms/parametrization.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace nrb::face {

namespace {

// Curves that run through more copies of the domain than this, all together, are taken for a mistake.
constexpr double most_copies = 65536;

void check_curve(const Spline &curve, size_t loop, size_t index) {
    const Spline::WeightRange weights = curve.all_weights();
    if (curve.rational() && !(weights.smallest > 0)) {
        fail(Status::weight_sign, "curve %zu of loop %zu has the weight %s; its weights must be positive",
             index, loop, Number(weights.smallest).text);
    }
}

// How far curves may leave the domain. Along an axis that is not closed: by so much of the period as the
// tolerance is of the size of the surface, which moves points by the tolerance if they move evenly. Along a
// closed axis: into other copies of the domain, up to most_copies for all curves together.
class Borders {
public:
    Borders(const Covering &covering, double tolerance) : covering_(covering), tolerance_(tolerance) {}

    void check(const PlacedCurve &placed, size_t loop, size_t index) {
        if (polygon_inside(*placed.curve)) {
            return;
        }
        const bounds::Box box = bounds::bounding_box(*placed.curve, whole_domain(*placed.curve), 0x1p-40);
        for (const int k : {0, 1}) {
            const auto at = static_cast<size_t>(k);
            const Interval domain = covering_.domain(k);
            const double over = std::max(domain.lower - box.lower[at], box.upper[at] - domain.upper);
            if (covering_.closed(k)
                    ? !in_few_copies(placed.curve->axis(0).count(), over / covering_.period(k))
                    : !is_allowed(k, over)) {
                fail(Status::outside_domain,
                     "curve %zu of loop %zu runs from %s to %s on axis %d, outside of the domain [%s, %s]",
                     index, loop, Number(box.lower[at]).text, Number(box.upper[at]).text, k,
                     Number(domain.lower).text, Number(domain.upper).text);
            }
        }
    }

private:
    // Each span of a curve may run through all of the copies.
    bool in_few_copies(int64_t spans, double copies) noexcept {
        copies_ += copies > 1 ? static_cast<double>(spans) * copies : 0;
        return copies_ <= most_copies;
    }
    [[nodiscard]] bool polygon_inside(const Spline &curve) const noexcept {
        bool inside = true;
        for (int64_t i = 0; i < curve.point_count() && inside; ++i) {
            for (const int k : {0, 1}) {
                const double x = curve.coordinate(i, k);
                inside = inside && covering_.domain(k).lower <= x && x <= covering_.domain(k).upper;
            }
        }
        return inside;
    }
    [[nodiscard]] bool is_allowed(int k, double over) const noexcept {
        const Interval domain = covering_.domain(k);
        if (over <= 64 * eps * std::max(std::abs(domain.lower), std::abs(domain.upper))) {
            return true;
        }
        const double size = covering_.extent();
        return over <= (size > 0 ? tolerance_ / size * covering_.period(k) : covering_.period(k));
    }

    const Covering &covering_;
    double tolerance_;
    double copies_ = 0;
};

// Errors name the edge.
MadeCurve named_curve_under(const SplinePtr &surface, const Covering &covering, const SplinePtr &edge,
                            size_t loop, size_t index, const UnderRule &rule, Effort &effort) {
    try {
        return curve_under(surface, covering, edge, rule, effort);
    } catch (const Error &error) {
        fail(error.status(), "edge %zu of loop %zu: %s", index, loop, error.what());
    }
}

void make_curves(FaceParts &parts, const Covering &covering) {
    const double precision = parts.precision > 0 ? parts.precision : share_of_fit * parts.tolerance;
    const UnderRule rule{parts.tolerance, precision, parts.prove, parts.nearest};
    Effort effort;
    for (const Loop &loop : parts.loops) {
        for (const Coedge &coedge : loop) {
            effort.allow(coedge.curve == nullptr ? *coedge.edge : *coedge.curve);
        }
    }
    for (size_t i = 0; i < parts.loops.size(); ++i) {
        for (size_t j = 0; j < parts.loops[i].size(); ++j) {
            Coedge &coedge = parts.loops[i][j];
            if (coedge.curve == nullptr) {
                const MadeCurve made =
                    named_curve_under(parts.surface, covering, coedge.edge, i, j, rule, effort);
                coedge.curve = coedge.against ? refine::reverse(*made.curve, 0, false) : made.curve;
                if (made.proven) {
                    coedge.deviation = {made.distance, true};
                }
            }
        }
    }
}

// While this exists, the progress that is reported leaves room for the check of crossings, which may take
// most of the time.
class BeforeCheck {
public:
    explicit BeforeCheck(const FaceParts &parts) noexcept {
        constexpr double share = 0.25;
        if (parts.check_crossings) {
            phase_.emplace(share);
        }
    }

private:
    std::optional<Phase> phase_;
};

Covering covering_of(const FaceParts &parts) {
    const BeforeCheck before(parts);
    return {*parts.surface, parts.tolerance};
}

} // namespace

void make_curves(FaceParts &parts) {
    const auto lacks = [](const Loop &loop) {
        return std::ranges::any_of(loop, [](const Coedge &coedge) { return coedge.curve == nullptr; });
    };
    if (std::ranges::any_of(parts.loops, lacks)) {
        make_curves(parts, Covering(*parts.surface, parts.tolerance));
    }
}

Face::Face(FaceParts parts, std::vector<double> *gaps)
    : surface_(parts.surface), tolerance_(parts.tolerance), covering_(covering_of(parts)) {
    if (parts.loops.empty()) {
        parts.loops = natural_loops(covering_);
        parts.as_oriented = true;
        parts.check_crossings = false;
    }
    {
        const BeforeCheck before(parts);
        make_curves(parts, covering_);
    }
    loops_ = std::move(parts.loops);
    std::vector<ClosedLoop> closed;
    const TrimPieces plane = pieces(closed, gaps, parts.keep_gaps);
    const bool turn = !parts.as_oriented;
    trims_ = parts.check_crossings ? uncrossed_map(plane, closed, turn) : map(plane, turn);
    for (size_t i = 0; i < loops_.size(); ++i) {
        if (trims_->turned()[i]) {
            loops_[i] = turned(loops_[i]);
        }
    }
}

Face::Face(const std::shared_ptr<const Face> &face, SplinePtr surface, double tolerance)
    : surface_(std::move(surface)), loops_(face->loops_), tolerance_(tolerance), has_gaps_(face->has_gaps_),
      covering_(face->covering_.over_moved(*surface_)), joints_(face->joints_),
      trims_(face, face->trims_.get()) {
    for (Loop &loop : loops_) {
        for (Coedge &coedge : loop) {
            coedge.edge = nullptr;
            coedge.deviation.reset();
        }
    }
}

std::unique_ptr<const TrimMap> Face::map(const TrimPieces &plane, bool turn, bool astray) const {
    const std::vector<LoopShape> shapes = loop_shapes(plane, loops_.size(), covering_);
    return std::make_unique<const TrimMap>(fold(plane, covering_), covering_, shapes, turn, astray);
}

// If the loops have no common inside, the reason may be that they cross, which is the better message.
std::unique_ptr<const TrimMap> Face::uncrossed_map(const TrimPieces &plane, std::span<const ClosedLoop> loops,
                                                   bool turn) const {
    const Crossings crossings(*surface_, covering_, loops, tolerance_);
    std::unique_ptr<const TrimMap> trims;
    try {
        trims = map(plane, turn);
    } catch (const Error &error) {
        if (error.status() == Status::orientation) {
            crossings.check_hits();
            crossings.check(*map(plane, turn, true));
        }
        throw;
    }
    crossings.check(*trims);
    return trims;
}

// The gaps of all loops are reported, even if the first one is too large.
TrimPieces Face::pieces(std::vector<ClosedLoop> &closed, std::vector<double> *gaps, bool keep) {
    TrimPieces plane;
    Borders borders(covering_, tolerance_);
    std::vector<double> found;
    for (size_t i = 0; i < loops_.size(); ++i) {
        for (size_t j = 0; j < loops_[i].size(); ++j) {
            check_curve(*loops_[i][j].curve, i, j);
        }
        closed.push_back({placed(*surface_, covering_, loops_[i], tolerance_), {}});
        ClosedLoop &own = closed.back();
        const PlacedLoop &loop = own.placed;
        for (size_t j = 0; j < loop.curves.size(); ++j) {
            borders.check(loop.curves[j], i, j);
        }
        double largest = 0;
        for (const Joint &joint : append_monotone(loop.curves, static_cast<int32_t>(i), loop.turn, plane)) {
            const double gap = gap_between(*surface_, covering_, joint.from, joint.to);
            largest = std::max(largest, gap);
            joints_.push_back(joint);
            if (!(gap <= tolerance_)) {
                own.segments.push_back(joint);
            }
        }
        found.push_back(largest);
    }
    if (gaps != nullptr) {
        *gaps = found;
    }
    const auto open =
        std::find_if(found.begin(), found.end(), [this](double gap) { return !(gap <= tolerance_); });
    has_gaps_ = open != found.end();
    if (!keep && has_gaps_) {
        fail(Status::gap, "loop %td has a gap of %s, larger than the tolerance %s", open - found.begin(),
             Number(*open).text, Number(tolerance_).text);
    }
    return plane;
}

} // namespace nrb::face
