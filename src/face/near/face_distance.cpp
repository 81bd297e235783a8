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
#include "spline/same_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace nrb::face {

namespace {

constexpr int64_t all_pairs = std::numeric_limits<int64_t>::max() / 2; // work is limited

// A stratum of a face: its surface, or a curve of its boundary.
struct Stratum {
    const Spline *spline;
    const BoundaryCurve *curve;    // null: the surface
    const closest::Region *region; // of a surface
    const double *lower, *upper;   // of a box [dim]
};

struct FoundPlace {
    Point2 place;
    std::vector<double> point;
};

// The strata of a face on which nearest points may lie.
class Strata {
public:
    explicit Strata(const Face &face)
        : face_(face), region_(face), edges_(space_edges(face)),
          box_(bounds::bounding_box(*face.surface(), whole_domain(*face.surface()), infinity)) {
        for (const SpaceEdge &edge : edges_.all) {
            if (!edge.curve.at_end) { // ends of the domain are searched with the surface
                all_.push_back(
                    {edge.curve.space.get(), &edge.curve, nullptr, edge.lower.data(), edge.upper.data()});
            }
        }
        all_.push_back({face.surface().get(), nullptr, &region_, box_.lower.data(), box_.upper.data()});
    }

    [[nodiscard]] const std::vector<Stratum> &all() const noexcept { return all_; }
    [[nodiscard]] bool exact() const noexcept { return edges_.exact; }
    // The place in the face of a place on a stratum that a search found.
    [[nodiscard]] FoundPlace found(const Stratum &stratum, const std::array<double, max_axes> &params,
                                   const std::array<bool, max_axes> &left) const {
        return stratum.curve == nullptr
                   ? at({params[0], params[1]}, {left[0], left[1]})
                   : at(place_on(face_, *stratum.curve, params[0], left[0]), {false, false});
    }
    [[nodiscard]] FoundPlace any() const { return at(place_of(face_, edges_), {false, false}); }

private:
    // left: for each axis, whether the limit from below is meant.
    [[nodiscard]] FoundPlace at(const Point2 &place, const std::array<bool, 2> &left) const {
        eval::AxisRules rules;
        rules[0].left = left[0];
        rules[1].left = left[1];
        FoundPlace found{place, std::vector<double>(static_cast<size_t>(face_.surface()->dim()))};
        const auto dim = static_cast<int64_t>(found.point.size());
        eval::evaluate_points(*face_.surface(), rules, 0, {place.data(), 1, 2, 2, 1},
                              {found.point.data(), 1, dim, dim, 1});
        return found;
    }

    const Face &face_;
    FaceRegion region_;
    SpaceEdges edges_;
    bounds::Box box_;
    std::vector<Stratum> all_;
};

struct StrataPair {
    double at_least; // a proven bound on their distance
    const Stratum *a, *b;
};

std::vector<StrataPair> pairs_of(const Strata &a, const Strata &b, int dim) {
    std::vector<StrataPair> pairs;
    for (const Stratum &x : a.all()) {
        for (const Stratum &y : b.all()) {
            const double apart = norm_of(dim, [&](int c) {
                return std::max({x.lower[c] - y.upper[c], y.lower[c] - x.upper[c], 0.0});
            });
            pairs.push_back({apart * (1 - (dim + 4) * eps), &x, &y});
        }
    }
    return pairs;
}

// Branch and bound over pairs of strata.
class SmallestSearch {
public:
    SmallestSearch(const Face &a, const Face &b, double tolerance)
        : a_(a), b_(b), dim_(a.surface()->dim()), tolerance_(tolerance) {}

    // Begins with some point of each face, so that there is an answer at the limit of work. All pairs are
    // searched briefly before one of them takes long, since what is found in others may exclude it.
    FaceDistance run() {
        settle(a_.any(), b_.any());
        if (!std::isfinite(found_.at_most)) {
            fail(Status::not_representable, "the distance overflows double precision");
        }
        const bool exact = a_.exact() && b_.exact();
        std::vector<StrataPair> pairs = pairs_of(a_, b_, dim_);
        for (const int64_t budget :
             {int64_t{64}, int64_t{2048}, exact ? int64_t{65536} : 0, exact ? all_pairs : 0}) {
            look_at(pairs, budget);
        }
        if (!exact) {
            pairs = {{0, &a_.all().back(), &b_.all().back()}};
            search(pairs.front(), all_pairs, true);
        }
        for (const StrataPair &pair : pairs) {
            found_.at_least = std::min(found_.at_least, pair.at_least);
        }
        found_.at_least = std::min(found_.at_least, found_.at_most);
        found_.certified = found_.at_most - found_.at_least <= tolerance_ + rounding_;
        return found_;
    }

private:
    void look_at(std::vector<StrataPair> &pairs, int64_t budget) {
        std::ranges::sort(pairs, {}, &StrataPair::at_least);
        for (StrataPair &pair : pairs) {
            if (budget > 0 && pair.at_least + tolerance_ + rounding_ < found_.at_most && !work_ended()) {
                search(pair, budget, false);
            }
        }
    }
    // boundaries: whether nearest points on boundaries count, too. Then the pieces of both surfaces approach
    // the boundary by halving, in many steps. Else only nearest points inside of both are searched for.
    void search(StrataPair &pair, int64_t budget, bool boundaries) {
        const closest::PairDistance own =
            closest::pair_distance(*pair.a->spline, *pair.b->spline, tolerance_, budget,
                                   {pair.a->region, pair.b->region, boundaries}, found_.at_most);
        pair.at_least = std::max(pair.at_least, own.at_least);
        rounding_ = std::max(rounding_, own.rounding);
        if (own.at_most < found_.at_most) {
            settle(a_.found(*pair.a, own.params_a, own.left_a), b_.found(*pair.b, own.params_b, own.left_b));
        }
    }
    // Keeps two places if they are the nearest so far; their computed distance is what others are compared
    // with.
    void settle(const FoundPlace &a, const FoundPlace &b) {
        const double away = distance(a.point.data(), b.point.data(), dim_);
        if (away < found_.at_most) {
            found_.at_most = away;
            found_.a = a.place;
            found_.b = b.place;
        }
    }

    Strata a_, b_;
    int dim_;
    double tolerance_, rounding_ = 0;
    FaceDistance found_{infinity, infinity};
};

bool same_curves(const Loop &a, const Loop &b) {
    return std::ranges::equal(a, b, [](const Coedge &x, const Coedge &y) {
        return x.curve == y.curve || same_numbers(*x.curve, *y.curve);
    });
}

// Whether they are the same bit for bit, as copies are.
bool same_faces(const Face &a, const Face &b) {
    return &a == &b || (same_numbers(*a.surface(), *b.surface()) && a.joints().empty() &&
                        b.joints().empty() && std::ranges::equal(a.loops(), b.loops(), same_curves));
}

} // namespace

FaceDistance smallest_distance(const Face &a, const Face &b, double tolerance) {
    check_same_dimension(*a.surface(), *b.surface());
    const LimitedSearch limited;
    return SmallestSearch(a, b, tolerance).run();
}

FaceDistance largest_distance(const Face &from, const Face &to, double tolerance) {
    check_same_dimension(*from.surface(), *to.surface());
    const LimitedSearch limited;
    if (same_faces(from, to)) {
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
