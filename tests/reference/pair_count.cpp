#include "reference/pair_count.h"

#include "reference/pair_chart.h"
#include "reference/patch_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace reference {

namespace {

constexpr int64_t most_cells = 400000;

// A place where curves leave a cell, in units of pieces.
struct Hit {
    PairPlace at{};
    double radius = 0;
    size_t axis = 0;
    bool upper = false; // of its cell
    size_t vertex = 0;
};

struct PairDoubt {
    const char *what;
};

Vector middle_of(const support::SplineData &data) {
    Vector least{HUGE_VAL, HUGE_VAL, HUGE_VAL}, most{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (int64_t i = 0; i < data.point_count(); ++i) {
        for (size_t c = 0; c < 3; ++c) {
            least[c] = std::min(least[c], data.coordinate(i, static_cast<int>(c)));
            most[c] = std::max(most[c], data.coordinate(i, static_cast<int>(c)));
        }
    }
    return {(least[0] + most[0]) / 2, (least[1] + most[1]) / 2, (least[2] + most[2]) / 2};
}

double size_of(const Patch &patch) {
    return patch.bounded ? std::hypot(patch.most[0] - patch.least[0], patch.most[1] - patch.least[1],
                                      patch.most[2] - patch.least[2])
                         : HUGE_VAL;
}

class PairCounter {
public:
    PairCounter(const support::SplineData &a, const support::SplineData &b)
        : a_(a, middle_of(a)), b_(b, middle_of(a)), noise_(a_.noise() + b_.noise()) {}

    std::vector<PairCurve> curves() {
        std::vector<Cell> cells;
        for (const int32_t a : a_.roots()) {
            for (const int32_t b : b_.roots()) {
                cells.push_back({a, b});
            }
        }
        while (!cells.empty()) {
            const Cell cell = cells.back();
            cells.pop_back();
            if (!look_at(cell)) {
                divide(cell, no_side, cells);
            }
        }
        join();
        return chains();
    }

private:
    struct Cell {
        int32_t a, b;
    };
    struct Side {
        size_t axis;
        bool upper;
        [[nodiscard]] double at() const { return upper ? 1 : -1; }
    };
    static constexpr Side no_side{4, false};

    [[nodiscard]] bool apart(const Cell &cell) const {
        const Patch &a = a_[cell.a], &b = b_[cell.b];
        for (size_t c = 0; c < 3; ++c) {
            if (a.bounded && b.bounded && (a.least[c] > b.most[c] || b.least[c] > a.most[c])) {
                return true;
            }
        }
        return false;
    }
    [[nodiscard]] bool bounded(const Cell &cell) const { return a_[cell.a].bounded && b_[cell.b].bounded; }
    [[nodiscard]] PairSystem system(const Cell &cell) const { return {a_[cell.a], b_[cell.b], noise_}; }

    // Whether nothing is left to do in it.
    bool look_at(const Cell &cell) {
        if (++looks_ > most_cells) {
            throw PairDoubt{"too many cells"};
        }
        if (apart(cell)) {
            return true;
        }
        if (!bounded(cell)) {
            return false;
        }
        const PairSystem here = system(cell);
        const size_t free = here.longest();
        const PairChart chart(here, free);
        if (!chart.regular()) {
            return false;
        }
        if (chart.excludes(4, 0)) {
            return true;
        }
        if (!(chart.contraction() < 0.9)) {
            return false;
        }
        add_arcs(cell, free);
        return true;
    }

    // The larger of both, or both; of a side the parts along it.
    void divide(const Cell &cell, const Side &side, std::vector<Cell> &cells) {
        const Patch &a = a_[cell.a], &b = b_[cell.b];
        const bool both = !bounded(cell);
        const bool divide_a = both || 2 * size_of(a) > size_of(b),
                   divide_b = both || 2 * size_of(b) > size_of(a);
        if ((divide_a && a.depth == PatchTree::most_depth) ||
            (divide_b && b.depth == PatchTree::most_depth)) {
            throw PairDoubt{"a cell that is not regular"};
        }
        const auto is_at = [&](int which, size_t axis) {
            return axis > 1 || (which >> axis & 1) == (side.upper ? 1 : 0);
        };
        for (int i = 0; i < (divide_a ? 4 : 1); ++i) {
            for (int j = 0; j < (divide_b ? 4 : 1); ++j) {
                if ((divide_a && !is_at(i, side.axis)) || (divide_b && !is_at(j, side.axis - 2))) {
                    continue;
                }
                cells.push_back(
                    {divide_a ? a_.child(cell.a, i) : cell.a, divide_b ? b_.child(cell.b, j) : cell.b});
            }
        }
    }

    void add_arcs(const Cell &cell, size_t free) {
        std::vector<Hit> hits;
        for (size_t axis = 0; axis < 4; ++axis) {
            for (const bool upper : {false, true}) {
                add_hits(cell, {axis, upper}, hits);
            }
        }
        std::ranges::sort(hits, {}, [&](const Hit &hit) { return hit.at[free]; });
        if (hits.size() % 2 != 0) {
            throw PairDoubt{"an odd number of places"};
        }
        for (size_t i = 0; i + 1 < hits.size(); ++i) {
            if (!(hits[i + 1].at[free] - hits[i].at[free] > hits[i].radius + hits[i + 1].radius)) {
                throw PairDoubt{"places that are not told apart"};
            }
        }
        for (size_t i = 0; i < hits.size(); i += 2) {
            arcs_.push_back({hits_.size(), hits_.size() + 1});
            hits_.push_back(hits[i]);
            hits_.push_back(hits[i + 1]);
        }
    }

    void add_hits(const Cell &cell, const Side &side, std::vector<Hit> &hits) {
        std::vector<Cell> cells{cell};
        while (!cells.empty()) {
            const Cell part = cells.back();
            cells.pop_back();
            if (!look_at_side(part, side, hits)) {
                divide(part, side, cells);
            }
        }
    }

    bool look_at_side(const Cell &cell, const Side &side, std::vector<Hit> &hits) {
        if (++looks_ > most_cells) {
            throw PairDoubt{"too many cells"};
        }
        if (apart(cell)) {
            return true;
        }
        if (!bounded(cell)) {
            return false;
        }
        const PairChart chart(system(cell), side.axis);
        if (!chart.regular()) {
            return false;
        }
        if (chart.excludes(side.axis, side.at())) {
            return true;
        }
        return chart.contraction() < 0.9 && find_hit(cell, side, chart, hits);
    }

    [[nodiscard]] Vector difference(const Cell &cell, const PairPlace &x) const {
        const Vector a = a_.point(cell.a, {x[0], x[1]}), b = b_.point(cell.b, {x[2], x[3]});
        return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    // One zero at most, which is within |M F(x)| / (1 - contraction) of any x in the margin. Whether that decides.
    bool find_hit(const Cell &cell, const Side &side, const PairChart &chart, std::vector<Hit> &hits) const {
        PairPlace x{};
        x[side.axis] = side.at();
        double radius = HUGE_VAL;
        for (int i = 0; i < 60; ++i) {
            const Vector step = chart.step(difference(cell, x));
            const double size = std::max({std::abs(step[0]), std::abs(step[1]), std::abs(step[2])});
            const double bound = (size + chart.noise()) / (1 - chart.contraction());
            if (!(bound < radius)) {
                break;
            }
            radius = bound;
            const PairPlace here = x;
            chart.move(step, x);
            for (size_t k = 0; k < 4; ++k) {
                x[k] = std::clamp(x[k], -1 - Patch::margin, 1 + Patch::margin);
            }
            if (size <= chart.noise()) {
                x = here;
                break;
            }
        }
        radius =
            (chart.size_of_step(difference(cell, x)) + chart.noise()) / (1 - chart.contraction()) * 1.0001;
        double beyond = 0; // of the cell, at most
        for (size_t k = 0; k < 4; ++k) {
            beyond = std::max(beyond, k == side.axis ? 0 : std::abs(x[k]));
        }
        if (beyond - radius > 1) {
            return true;
        }
        // A quarter: so what is found from a smaller cell is in the margin of this one, where there is one zero at most.
        if (!(radius < Patch::margin / 4 && beyond + radius < 1)) {
            return false;
        }
        hits.push_back(hit_at(cell, side, x, radius));
        return true;
    }

    [[nodiscard]] Hit hit_at(const Cell &cell, const Side &side, const PairPlace &x, double radius) const {
        Hit hit;
        hit.axis = side.axis;
        hit.upper = side.upper;
        for (size_t k = 0; k < 4; ++k) {
            const Patch &patch = k < 2 ? a_[cell.a] : b_[cell.b];
            const double lower = patch.lower[k % 2], upper = patch.upper[k % 2], half = (upper - lower) / 2;
            hit.at[k] = lower + half * (x[k] + 1);
            hit.radius = std::max(hit.radius, half * radius + 1e-15 * upper);
        }
        const Patch &own = side.axis < 2 ? a_[cell.a] : b_[cell.b];
        hit.at[side.axis] = side.upper ? own.upper[side.axis % 2] : own.lower[side.axis % 2];
        return hit;
    }

    [[nodiscard]] const PatchTree &tree(size_t axis) const { return axis < 2 ? a_ : b_; }
    [[nodiscard]] bool is_end(const Hit &hit) const {
        return hit.at[hit.axis] == (hit.upper ? tree(hit.axis).pieces(static_cast<int>(hit.axis % 2)) : 0);
    }

    static bool is_same(const Hit &x, const Hit &y) {
        double apart = 0;
        for (size_t k = 0; k < 4; ++k) {
            apart = std::max(apart, k == x.axis ? 0 : std::abs(x.at[k] - y.at[k]));
        }
        return apart <= x.radius + y.radius;
    }

    // The upper side of one cell is the lower side of another one, each place of it is found from both.
    void join() {
        std::vector<size_t> order(hits_.size());
        std::iota(order.begin(), order.end(), size_t{0});
        const auto level = [&](const Hit &hit) { // ends of an axis that closes are one
            const bool end = is_end(hit) && tree(hit.axis).closes(static_cast<int>(hit.axis % 2));
            return end ? 0.0 : hit.at[hit.axis];
        };
        const size_t none = hits_.size();
        std::ranges::sort(order, [&](size_t x, size_t y) {
            return std::pair(hits_[x].axis, level(hits_[x])) < std::pair(hits_[y].axis, level(hits_[y]));
        });
        for (Hit &hit : hits_) {
            hit.vertex = none;
        }
        vertices_ = 0;
        for (size_t i = 0; i < order.size(); ++i) {
            Hit &hit = hits_[order[i]];
            for (size_t j = i + 1; j < order.size() && hit.vertex == none; ++j) {
                Hit &other = hits_[order[j]];
                if (other.axis != hit.axis || level(other) != level(hit)) {
                    break;
                }
                if (other.upper != hit.upper && other.vertex == none && is_same(hit, other)) {
                    hit.vertex = other.vertex = vertices_++;
                }
            }
            if (hit.vertex == none) {
                if (!is_end(hit) || tree(hit.axis).closes(static_cast<int>(hit.axis % 2))) {
                    throw PairDoubt{"an arc that ends inside"};
                }
                hit.vertex = vertices_++;
            }
        }
    }

    [[nodiscard]] PairPlace params(const Hit &hit) const {
        PairPlace at{};
        for (size_t k = 0; k < 4; ++k) {
            at[k] = tree(k).param(static_cast<int>(k % 2), hit.at[k]);
        }
        return at;
    }

    std::vector<PairCurve> chains() {
        std::vector<size_t> of(vertices_), arcs_at(vertices_, 0);
        std::iota(of.begin(), of.end(), size_t{0});
        const auto root = [&](size_t i) {
            while (of[i] != i) {
                i = of[i] = of[of[i]];
            }
            return i;
        };
        for (const auto &[first, second] : arcs_) {
            const size_t x = hits_[first].vertex, y = hits_[second].vertex;
            ++arcs_at[x];
            ++arcs_at[y];
            of[root(x)] = root(y);
        }
        std::vector<PairCurve> curves;
        std::vector<size_t> index(vertices_, vertices_);
        for (const Hit &hit : hits_) {
            size_t &own = index[root(hit.vertex)];
            if (own == vertices_) {
                own = curves.size();
                curves.push_back({true, params(hit), {}});
            }
            if (arcs_at[hit.vertex] == 1) {
                curves[own].closed = false;
                curves[own].ends.push_back(params(hit));
            }
        }
        return curves;
    }

    PatchTree a_, b_;
    double noise_;
    int64_t looks_ = 0;
    std::vector<Hit> hits_;
    std::vector<std::array<size_t, 2>> arcs_;
    size_t vertices_ = 0;
};

} // namespace

int64_t PairCount::closed() const {
    return std::ranges::count(curves, true, &PairCurve::closed);
}

PairCount count_curves(const support::SplineData &a, const support::SplineData &b) {
    PairCount count;
    try {
        count.curves = PairCounter(a, b).curves();
    } catch (const PairDoubt &doubt) {
        count.doubt = doubt.what;
    }
    return count;
}

} // namespace reference
