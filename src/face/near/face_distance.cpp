// SPDX-License-Identifier: MIT
#include "face/near/face_distance.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "bounds/box.h"
#include "closest/pair/hausdorff.h"
#include "closest/pair/pair_search.h"
#include "eval/evaluate.h"
#include "face/near/face_region.h"
#include "numeric/norm.h"
#include "spline/kind.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace nrb::face {

namespace {

constexpr int64_t all_pairs = std::numeric_limits<int64_t>::max() / 2; // work is limited

// A place of a face.
Point2 place_of(const Face &face, const SpaceEdges &edges) {
    if (edges.all.empty()) {
        return {face.covering().domain(0).lower, face.covering().domain(1).lower};
    }
    const BoundaryCurve &first = edges.all.front().curve;
    return place_on(face, first, first.plane->axis(0).domain().lower, false);
}

// The surface of a face, or a curve of its boundary.
struct Stratum {
    const Spline *spline;
    const BoundaryCurve *curve;    // null: the surface
    const closest::Region *region; // of the surface
    const double *lower, *upper;   // of a box [dim]
};

// A face, and what nearest points may lie on.
class Strata {
public:
    explicit Strata(const Face &face)
        : face_(face), region_(face), edges_(space_edges(face)),
          box_(bounds::bounding_box(*face.surface(), whole_domain(*face.surface()), infinity)) {
        for (const SpaceEdge &edge : edges_.all) {
            all_.push_back(
                {edge.curve.space.get(), &edge.curve, nullptr, edge.lower.data(), edge.upper.data()});
        }
        all_.push_back({face.surface().get(), nullptr, &region_, box_.lower.data(), box_.upper.data()});
    }

    [[nodiscard]] const std::vector<Stratum> &all() const noexcept { return all_; }
    [[nodiscard]] bool exact() const noexcept { return edges_.exact; }
    [[nodiscard]] Point2 any_place() const { return place_of(face_, edges_); }
    [[nodiscard]] Point2 place(const Stratum &stratum, const std::array<double, max_axes> &params) const {
        return stratum.curve == nullptr ? Point2{params[0], params[1]}
                                        : place_on(face_, *stratum.curve, params[0], false);
    }
    [[nodiscard]] std::vector<double> point(const Point2 &place) const {
        std::vector<double> x(static_cast<size_t>(face_.surface()->dim()));
        const auto dim = static_cast<int64_t>(x.size());
        eval::evaluate_points(*face_.surface(), {}, 0, {place.data(), 1, 2, 2, 1},
                              {x.data(), 1, dim, dim, 1});
        return x;
    }

private:
    const Face &face_;
    FaceRegion region_;
    SpaceEdges edges_;
    bounds::Box box_;
    std::vector<Stratum> all_;
};

struct StrataPair {
    double apart; // their boxes
    const Stratum *a, *b;
};

// Of fewer dimensions first: they give a distance as far as which the others are looked at.
int rank(const StrataPair &pair) noexcept {
    return (pair.a->curve == nullptr ? 1 : 0) + (pair.b->curve == nullptr ? 1 : 0);
}

std::vector<StrataPair> pairs_of(const Strata &a, const Strata &b, int dim) {
    std::vector<StrataPair> pairs;
    for (const Stratum &x : a.all()) {
        for (const Stratum &y : b.all()) {
            const double apart = norm_of(dim, [&](int c) {
                return std::max({x.lower[c] - y.upper[c], y.lower[c] - x.upper[c], 0.0});
            });
            pairs.push_back({apart, &x, &y});
        }
    }
    std::ranges::sort(pairs, [](const StrataPair &x, const StrataPair &y) {
        return std::pair(rank(x), x.apart) < std::pair(rank(y), y.apart);
    });
    return pairs;
}

class SmallestSearch {
public:
    SmallestSearch(const Face &a, const Face &b, double tolerance)
        : a_(a), b_(b), dim_(a.surface()->dim()), tolerance_(tolerance) {}

    // At the limit of work the points may be any.
    FaceDistance run() {
        settle(a_.any_place(), b_.any_place());
        if (!std::isfinite(found_.at_most)) {
            fail(Status::not_representable, "the distance overflows double precision");
        }
        for (const StrataPair &pair : pairs_of(a_, b_, dim_)) {
            look_at(pair);
        }
        if (!a_.exact() || !b_.exact()) {
            prove_without_curves();
        }
        found_.at_least = std::min(found_.at_least, found_.at_most);
        found_.certified = found_.at_most - found_.at_least <= tolerance_ + rounding_;
        return found_;
    }

private:
    void look_at(const StrataPair &pair) {
        if (pair.apart > found_.at_most) {
            return;
        }
        if (work_ended()) {
            found_.at_least = std::min(found_.at_least, pair.apart);
            return;
        }
        search(pair, false);
    }
    // By pieces of both surfaces alone, which come near the boundary by halving: in many steps.
    void prove_without_curves() {
        found_.at_least = infinity;
        search({0, &a_.all().back(), &b_.all().back()}, true);
    }
    void search(const StrataPair &pair, bool boundaries) {
        const closest::PairDistance own =
            closest::pair_distance(*pair.a->spline, *pair.b->spline, tolerance_, all_pairs,
                                   {pair.a->region, pair.b->region, boundaries}, found_.at_most);
        found_.at_least = std::min(found_.at_least, own.at_least);
        rounding_ = std::max(rounding_, own.rounding);
        if (own.at_most < found_.at_most) {
            settle(a_.place(*pair.a, own.params_a), b_.place(*pair.b, own.params_b));
        }
    }
    // The distance of the places, which is what others are compared with.
    void settle(const Point2 &a, const Point2 &b) {
        const double away = distance(a_.point(a).data(), b_.point(b).data(), dim_);
        if (away < found_.at_most) {
            found_.at_most = away;
            found_.a = a;
            found_.b = b;
        }
    }

    Strata a_, b_;
    int dim_;
    double tolerance_, rounding_ = 0;
    FaceDistance found_{infinity, infinity};
};

} // namespace

FaceDistance smallest_distance(const Face &a, const Face &b, double tolerance) {
    check_same_dimension(*a.surface(), *b.surface());
    const LimitedSearch limited;
    return SmallestSearch(a, b, tolerance).run();
}

FaceDistance largest_distance(const Face &from, const Face &to, double tolerance) {
    check_same_dimension(*from.surface(), *to.surface());
    const LimitedSearch limited;
    if (&from == &to) {
        return {0, 0, place_of(from, space_edges(from)), {}, true};
    }
    const FaceRegion in_from(from);
    FaceRegion in_to(to);
    const closest::FarthestPoint found =
        closest::one_sided_distance(*from.surface(), *to.surface(), tolerance, all_pairs, &in_from, &in_to);
    const Point2 place =
        found.at_least == 0 ? place_of(from, space_edges(from)) : Point2{found.params[0], found.params[1]};
    return {found.at_least, found.at_most, place, {}, found.certified};
}

} // namespace nrb::face
