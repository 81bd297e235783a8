// SPDX-License-Identifier: MIT
#include "closest/pair/hausdorff.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "closest/locator.h"
#include "closest/pair/matched_bound.h"
#include "closest/pair/parameter_map.h"
#include "eval/evaluate.h"
#include "numeric/norm.h"
#include "pieces/best_first.h"
#include "pieces/tree/framed_pieces.h"
#include "spline/kind.h"
#include "spline/same_numbers.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace nrb::closest {

namespace {

constexpr int64_t budget_of_a_match = 500; // per point; not taken from the caller's budget
constexpr int64_t work_of_a_look = 400;    // at a piece: its memory
constexpr double same_point = 0x1p-40;     // of points that may coincide, before anything is proven

// Breaks for the axes of `spline` at which its pieces are to end so that they match pieces of `other`: those
// of the map or, without one, those of the straight map if both have the same number of axes.
pieces::BernsteinNet::Breaks alike_breaks(const Spline &spline, const Spline &other,
                                          const ParameterMap *map) {
    pieces::BernsteinNet::Breaks breaks;
    for (int k = 0; k < spline.axes() && (map != nullptr || spline.axes() == other.axes()); ++k) {
        breaks[static_cast<size_t>(k)] =
            map != nullptr ? map->breaks(k) : straight_map(spline, other).breaks(k);
    }
    return breaks;
}

using Others = std::vector<const pieces::BezierPiece *>;

// The pieces of a spline, each made when it is first needed.
class KnownPieces {
public:
    KnownPieces(const Spline &spline, const pieces::Frame &frame)
        : pieces_(pieces::piece_tree_of(spline), frame), moved_(pieces_.moved()) {}

    // The pieces that contain a place: two along an axis if it is at a knot, none if it is outside.
    [[nodiscard]] Others containing(const pieces::LocalParam &place) {
        Others found;
        for (const int64_t i : pieces_.tree().grid().containing(place)) {
            found.push_back(&piece(i));
        }
        return found;
    }
    // The most that rounding moves a piece with positive weights; if no bound for all pieces is known, the
    // maximum over those made so far.
    [[nodiscard]] double moved() const noexcept { return moved_; }

private:
    const pieces::BezierPiece &piece(int64_t i) {
        const auto [found, fresh] = made_.try_emplace(i);
        if (fresh) {
            found->second = pieces_.piece(i);
            moved_ = std::max(moved_, found->second.positive() ? found->second.moved() : 0);
        }
        return found->second;
    }

    pieces::FramedPieces pieces_;
    std::unordered_map<int64_t, pieces::BezierPiece> made_; // whose elements keep their addresses
    double moved_;
};

struct FarPiece {
    pieces::BezierPiece piece;
    bool bounded; // has been bounded by a nearest point
};
using Entry = pieces::BestFirst<FarPiece>::Entry;

// The nearest point of the other spline, in the frame.
struct NearPoint {
    Foot foot;
    std::vector<double> point;
    double at_least = 0; // lower bound on its distance
};

class FarthestSearch {
public:
    FarthestSearch(const Spline &from, const Spline &to, const pieces::Frame &frame, double tolerance,
                   int64_t budget, const Region *in_from, Region *in_to)
        : to_(to), in_from_(in_from), in_to_(in_to), frame_(frame), locator_(locator_of(to)),
          known_(to, frame), dim_(from.dim()), tolerance_(tolerance), budget_(budget),
          query_(static_cast<size_t>(dim_)),
          map_(matching_map(from, to, frame.unscaled(same_point), frame.unscaled(tolerance),
                            std::min(budget, budget_of_a_match))) {
        for (pieces::BezierPiece &piece :
             pieces::bezier_pieces(from, frame, alike_breaks(from, to, map_ ? &*map_ : nullptr))) {
            moved_ = std::max(moved_, piece.positive() ? piece.moved() : 0);
            push(infinity, std::move(piece), false);
        }
    }

    void run() {
        queue_.run(
            budget_, [&](const Entry &top) { return top.bound > limit(); },
            [&](Entry top) {
                count_work(work_of_a_look);
                const bool bounds = !top.item.bounded && top.item.piece.positive();
                bounds ? bound(std::move(top)) : divide(std::move(top));
            });
    }

    [[nodiscard]] double at_least() const noexcept { return std::max(lower_, 0.0); }
    [[nodiscard]] double at_most() const noexcept { return std::max(queue_.bound(), at_least()); }
    // An allowance for the rounding of the pieces examined and of the nearest points.
    [[nodiscard]] double noise() const noexcept { return 8 * (moved_ + known_.moved()) + 256 * eps; }
    [[nodiscard]] const pieces::LocalParam &best() const noexcept { return best_; }

private:
    [[nodiscard]] double limit() const noexcept { return std::max(lower_, 0.0) + tolerance_ + noise(); }

    void push(double upper, pieces::BezierPiece piece, bool bounded) {
        if (upper <= limit()) {
            queue_.leave_out(upper);
        } else if (bounded || !outside(piece)) {
            queue_.push(upper, {std::move(piece), bounded});
        }
    }
    [[nodiscard]] bool outside(const pieces::BezierPiece &piece) const {
        return in_from_ != nullptr &&
               in_from_->side(piece.parameter({0, 0, 0}), piece.parameter({1, 1, 1})) < 0;
    }
    // Whether the box that the corners span on piece `other` lies inside in_to_, so that all of it counts.
    [[nodiscard]] bool holds(const pieces::BezierPiece &other,
                             const std::vector<pieces::LocalParam> &corners) const {
        if (in_to_ == nullptr) {
            return true;
        }
        pieces::LocalParam lower{1, 1, 1}, upper{0, 0, 0};
        for (const pieces::LocalParam &corner : corners) {
            for (size_t k = 0; k < max_axes; ++k) {
                lower[k] = std::min(lower[k], corner[k]);
                upper[k] = std::max(upper[k], corner[k]);
            }
        }
        return !corners.empty() && in_to_->side(other.parameter(lower), other.parameter(upper)) > 0;
    }

    // The nearest point of `to` for a point of the frame.
    NearPoint nearest(const double *x) {
        for (size_t c = 0; c < query_.size(); ++c) {
            query_[c] = frame_.original(c, x[c]);
        }
        NearPoint near;
        const double tolerance = frame_.unscaled(tolerance_ / 4);
        const BoundedFoot found =
            in_to_ != nullptr ? in_to_->nearest(query_.data(), tolerance) : nearest_of_all(tolerance);
        near.foot = found.foot;
        budget_ -= near.foot.examined;
        eval::AxisRules rules{};
        for (size_t k = 0; k < max_axes; ++k) {
            rules[k].left = (near.foot.left >> k & 1) != 0;
        }
        near.point.resize(query_.size());
        eval::evaluate_points(to_, rules, 0, {near.foot.params.data(), 1, to_.axes(), to_.axes()},
                              {near.point.data(), 1, dim_, dim_});
        near.at_least = frame_.scaled(found.at_least);
        for (size_t c = 0; c < query_.size(); ++c) {
            near.point[c] = frame_.coordinate(c, near.point[c]);
        }
        return near;
    }

    [[nodiscard]] BoundedFoot nearest_of_all(double tolerance) const {
        const Foot foot = locator_.nearest(
            {query_.data(), nullptr, tolerance, std::clamp<int64_t>(budget_, 1, pieces::default_budget)});
        const bool proven = (foot.status & (closest_certified | closest_coarse)) != 0;
        return {foot, proven ? foot.distance - tolerance - foot.noise : -infinity};
    }

    void bound(Entry top) {
        const pieces::BezierPiece &piece = top.item.piece;
        double upper = map_ ? std::min(top.bound, mapped(piece)) : top.bound;
        if (upper <= limit()) {
            return queue_.leave_out(upper);
        }
        const pieces::LocalParam middle{0.5, 0.5, 0.5};
        jet_.evaluate(piece, middle, false);
        const NearPoint near = nearest(jet_.value());
        const Others others = known_.containing(near.foot.params); // may raise known_.moved(), read below
        const double noise = frame_.scaled(near.foot.noise) + 8 * (dim_ + 2) * eps;
        const double lower = near.at_least - 8 * (dim_ + 2) * eps - piece.moved();
        if (lower > lower_ && (in_from_ == nullptr || in_from_->side(piece.parameter(middle)) >= 0)) {
            lower_ = lower;
            best_ = piece.parameter(middle);
        }
        upper = std::min(upper, from_point(piece, near.point) + noise + known_.moved() + piece.moved());
        if (upper > limit()) {
            upper = std::min(upper, matched(piece, near.foot.params, others));
        }
        push(upper, std::move(top.item.piece), true);
    }

    // An upper bound by the map, over all pieces of the other spline that contain the image of the middle.
    double mapped(const pieces::BezierPiece &piece) {
        double best = infinity;
        const pieces::LocalParam middle = (*map_)(piece.parameter({0.5, 0.5, 0.5}));
        for (const pieces::BezierPiece *other : known_.containing(middle)) {
            std::vector<pieces::LocalParam> corners = MatchedBound::corners_of(piece);
            for (pieces::LocalParam &corner : corners) {
                corner = other->place((*map_)(piece.parameter(corner)));
            }
            if (holds(*other, corners)) {
                best = std::min(best, MatchedBound::upper(piece, *other, corners, limit()));
            }
        }
        return best;
    }

    // The largest distance of a control point from a point, which bounds that of the whole piece by the
    // convex hull property.
    [[nodiscard]] double from_point(const pieces::BezierPiece &piece,
                                    const std::vector<double> &point) const noexcept {
        double most = 0;
        for (int64_t i = 0; i < piece.coefficients(); ++i) {
            const double own = distance(piece.point(i), point.data(), dim_);
            most = std::isnan(own) ? infinity : std::max(most, own);
        }
        return most * (1 + (dim_ + 4) * eps);
    }

    // An upper bound by matching; at a knot, the pieces on either side may match.
    double matched(const pieces::BezierPiece &piece, const pieces::LocalParam &foot, const Others &others) {
        double best = infinity;
        for (const pieces::BezierPiece *other : others) {
            const std::vector<pieces::LocalParam> corners = bound_.corners(piece, *other, other->place(foot));
            if (holds(*other, corners)) {
                best = std::min(best, MatchedBound::upper(piece, *other, corners, limit()));
            }
        }
        return best;
    }

    void divide(Entry top) {
        std::optional<pieces::BezierPiece> half = top.item.piece.halve();
        if (!half) {
            return queue_.leave_out(top.bound);
        }
        push(top.bound, std::move(*half), false);
        push(top.bound, std::move(top.item.piece), false);
    }

    const Spline &to_;
    const Region *in_from_;
    Region *in_to_;
    const pieces::Frame &frame_;
    const Locator &locator_;
    KnownPieces known_; // of `to`
    int dim_;
    double tolerance_;
    int64_t budget_;
    std::vector<double> query_;
    std::optional<ParameterMap> map_;
    double moved_ = 0; // most that rounding moves the pieces of `from`
    double lower_ = -infinity;
    pieces::LocalParam best_{};
    pieces::BestFirst<FarPiece> queue_;
    PieceJet jet_;
    MatchedBound bound_;
};

// The result for identical splines: the distance is 0 everywhere.
FarthestPoint nowhere_else(const Spline &from) noexcept {
    FarthestPoint result;
    for (int k = 0; k < from.axes(); ++k) {
        result.params[static_cast<size_t>(k)] = from.axis(k).domain().lower;
    }
    result.certified = true;
    return result;
}

} // namespace

FarthestPoint one_sided_distance(const Spline &from, const Spline &to, double tolerance, int64_t budget) {
    return one_sided_distance(from, to, tolerance, budget, nullptr, nullptr);
}

FarthestPoint one_sided_distance(const Spline &from, const Spline &to, double tolerance, int64_t budget,
                                 const Region *in_from, Region *in_to) {
    check_same_dimension(from, to);
    const LimitedSearch limited;
    if (in_to == nullptr && same_numbers(from, to)) {
        return nowhere_else(from);
    }
    const pieces::Frame frame = pieces::frame_of({{&from, &to}});
    const double scaled_tolerance = std::min(frame.scaled(tolerance), 1e300);
    FarthestSearch search(from, to, frame, scaled_tolerance, budget, in_from, in_to);
    search.run();
    FarthestPoint result;
    result.at_least = frame.unscaled(search.at_least());
    result.at_most = frame.unscaled(search.at_most());
    if (!std::isfinite(result.at_least)) {
        fail(Status::not_representable, "the distance overflows double precision");
    }
    result.params = search.best();
    if (search.at_least() == 0) {
        for (int k = 0; k < from.axes(); ++k) {
            const Interval domain = from.axis(k).domain();
            auto &t = result.params[static_cast<size_t>(k)];
            t = std::clamp(t, domain.lower, domain.upper);
        }
    }
    const double gap = search.at_most() - search.at_least(), noise = search.noise();
    result.certified = std::isfinite(gap + noise) && gap <= scaled_tolerance + 2 * noise;
    return result;
}

} // namespace nrb::closest
