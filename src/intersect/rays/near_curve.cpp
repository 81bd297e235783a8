// SPDX-License-Identifier: MIT
#include "intersect/rays/near_curve.h"

#include "base/watch.h"
#include "bernstein/de_casteljau.h"
#include "intersect/rays/ray_tree.h"
#include "intersect/rays/turned_patches.h"

#include <array>
#include <optional>
#include <vector>

namespace nrb::intersect {

namespace {

constexpr int most_halvings = 2000; // per ray
constexpr int most_curve_depth = 50;
constexpr size_t most_waiting = 64; // the tree over at most 2^63 pieces is no deeper
constexpr int64_t curve_lanes = TurnedPatches::lanes;

// A subdivision search for one ray and one curve, in the frame of the pieces.
class CurveSearch {
public:
    CurveSearch(const Spline &curve, const RayQuery &query, double distance)
        : tree_(ray_tree_of(curve)), grid_(tree_.grid()), placed_(grid_, query), noise_(placed_.room(grid_)),
          degree_(grid_.shape().axes > 0 ? grid_.shape().degree(0) : 0),
          range_{placed_.in_frame(query.range.lower), placed_.in_frame(query.range.upper)},
          distance_(1.001 * grid_.scaled(distance)) {}

    CurvePassage run() {
        std::array<int32_t, most_waiting> nodes{0};
        for (size_t waiting = 1; waiting > 0;) {
            const int32_t node = nodes[--waiting];
            if (!meets_range(tree_.meets(node, placed_.ray, distance_ + noise_))) {
                continue;
            }
            if (tree_.is_piece(node)) {
                look_at(tree_.piece(node));
                continue;
            }
            nodes[waiting++] = tree_.right(node);
            nodes[waiting++] = node + 1;
        }
        found_.ts = {placed_.of_query(found_.ts.lower), placed_.of_query(found_.ts.upper)};
        return found_;
    }

private:
    struct Part {
        std::vector<double> values;
        double lower, length, moved;
        int depth;
    };
    // The ranges of the control points: x and y across the ray, t along it.
    struct Ranges {
        bool certain = true; // whether all weights are certainly positive
        Interval x{infinity, -infinity}, y = x, t = x;
    };

    [[nodiscard]] bool meets_range(Interval x) const noexcept {
        return x.lower <= x.upper && x.upper >= range_.lower && x.lower <= range_.upper;
    }
    static void add(Interval &range, double x) noexcept {
        range.lower = std::min(range.lower, x);
        range.upper = std::max(range.upper, x);
    }
    [[nodiscard]] Ranges ranges(const Part &part) const {
        Ranges r;
        for (int i = 0; i <= degree_; ++i) {
            const double *v = part.values.data() + i * curve_lanes;
            if (!patches_->has_point(v)) {
                continue;
            }
            r.certain = r.certain && grid_.positive() && v[3] > 0;
            add(r.x, v[0] / v[3]);
            add(r.y, v[1] / v[3]);
            add(r.t, v[2] / v[3]);
        }
        return r;
    }
    static double from_zero(Interval x) noexcept { return std::max({x.lower, -x.upper, 0.0}); }

    void look_at(int64_t piece) {
        if (!patches_) {
            patches_.emplace(grid_);
            patches_->set_ray(placed_);
        }
        const Interval all = grid_.part(piece)[0];
        std::vector<Part> parts(1, Part{std::vector<double>(static_cast<size_t>((degree_ + 1) * curve_lanes)),
                                        all.lower, all.upper - all.lower, noise_, 0});
        patches_->fill(piece, parts.front().values.data());
        while (!parts.empty()) {
            Part part = std::move(parts.back());
            parts.pop_back();
            count_work(20 * (degree_ + 1));
            const Ranges r = ranges(part);
            const Interval ts{r.t.lower - part.moved - distance_, r.t.upper + part.moved + distance_};
            if (!r.certain) {
                put(part, range_);
            } else if (!meets_range(ts) ||
                       std::hypot(from_zero(r.x), from_zero(r.y)) > distance_ + part.moved) {
                continue;
            } else if (is_small(part, r)) {
                put(part, ts);
            } else {
                halve(std::move(part), parts);
            }
        }
    }
    [[nodiscard]] bool is_small(const Part &part, const Ranges &r) {
        const double size = std::max({r.x.upper - r.x.lower, r.y.upper - r.y.lower, r.t.upper - r.t.lower});
        return size <= std::max(distance_ / 8, 4 * part.moved) || part.depth >= most_curve_depth ||
               --halvings_ < 0;
    }
    void put(const Part &part, Interval ts) noexcept {
        if (ts.lower < found_.ts.lower) {
            found_.param = part.lower + part.length / 2;
        }
        add(found_.ts, ts.lower);
        add(found_.ts, ts.upper);
    }
    void halve(Part part, std::vector<Part> &parts) const {
        part.length /= 2;
        part.moved += 2 * degree_ * eps * (grid_.radius() + length(placed_.ray.origin));
        ++part.depth;
        Part first = part;
        subdivide(degree_, curve_lanes, 0.5, part.values.data(), first.values.data());
        part.lower += part.length;
        parts.push_back(std::move(part));
        parts.push_back(std::move(first));
    }

    const RayTree &tree_;
    const pieces::PieceGrid &grid_;
    PlacedRay placed_;
    double noise_; // rounding of the pieces and of the ray
    int degree_;
    Interval range_;
    double distance_;
    std::optional<TurnedPatches> patches_; // made for the first piece
    int halvings_ = most_halvings;
    CurvePassage found_;
};

} // namespace

CurvePassage passage_near(const Spline &curve, const RayQuery &query, double distance) {
    return CurveSearch(curve, query, distance).run();
}

} // namespace nrb::intersect
