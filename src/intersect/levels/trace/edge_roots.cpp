// SPDX-License-Identifier: MIT
#include "intersect/levels/trace/edge_roots.h"

#include "base/numbers.h"
#include "bernstein/de_casteljau.h"

#include <algorithm>
#include <cmath>

namespace nrb::intersect {

namespace {

constexpr double smallest_part = 0x1p-44;

class EdgeSearch {
public:
    explicit EdgeSearch(const LevelNet::Edge &whole) : whole_(whole) {}

    std::vector<double> run(bool above_at_start, bool above_at_end) {
        visit(whole_, 0, 1, above_at_start, above_at_end);
        return std::move(roots_);
    }

private:
    using Edge = LevelNet::Edge;

    // Where the ends have no signs of their own, halving goes on: what is known between them says on which side the change is.
    void visit(const Edge &edge, double from, double length, bool start, bool end) {
        const int changes = changes_of(edge, start, end);
        if (changes == 0) {
            return;
        }
        if (changes == 1 && has_sign(edge, 0, start) && has_sign(edge, edge.values.size() - 1, end)) {
            roots_.push_back(root(from, from + length, end));
            return;
        }
        if (length < smallest_part || edge.is_hidden()) {
            if (start != end) {
                roots_.push_back(hidden_root(from, from + length));
            }
            return;
        }
        Edge upper = edge;
        const Edge lower = upper.take_lower_half();
        const bool middle =
            upper.is_known(0) ? upper.values.front() > 0
            : changes > 1
                ? true
                : (has_any(upper, start) || (upper.is_hidden() && !lower.is_hidden()) ? start : end);
        visit(lower, from, length / 2, start, middle);
        visit(upper, from + length / 2, length / 2, middle, end);
    }

    // At an end of the whole, if that is hidden too, so that roots are in corners rather than beside them.
    [[nodiscard]] double hidden_root(double a, double b) const {
        if (a == 0 || b == 1) {
            return a == 0 ? a : b;
        }
        return std::abs(value(a)) <= std::abs(value(b)) ? a : b;
    }

    static bool has_sign(const Edge &edge, size_t i, bool above) noexcept {
        return edge.is_known(i) && (edge.values[i] > 0) == above;
    }
    static bool has_any(const Edge &edge, bool above) noexcept {
        for (size_t i = 0; i < edge.values.size(); ++i) {
            if (has_sign(edge, i, above)) {
                return true;
            }
        }
        return false;
    }

    // Of signs that are known.
    static int changes_of(const Edge &edge, bool start, bool end) noexcept {
        int changes = 0;
        bool last = start;
        for (size_t i = 0; i < edge.values.size(); ++i) {
            if (edge.is_known(i)) {
                changes += (edge.values[i] > 0) != last ? 1 : 0;
                last = edge.values[i] > 0;
            }
        }
        return changes + (last != end ? 1 : 0);
    }

    [[nodiscard]] double value(double t) const { return whole_.value(t); }

    // Regula falsi with halved weights of the end that stays (Illinois).
    [[nodiscard]] double root(double a, double b, bool above_at_end) const {
        const double sign = above_at_end ? 1 : -1;
        double fa = sign * value(a), fb = sign * value(b);
        int stayed = 0;
        for (int i = 0; i < 100 && b - a > 2 * eps; ++i) {
            double t = a + (b - a) * (fa / (fa - fb));
            t = t > a && t < b ? t : a + (b - a) / 2;
            if (!(t > a && t < b)) {
                break;
            }
            const double ft = sign * value(t);
            if (ft == 0) {
                return t;
            }
            if (ft < 0) {
                a = t;
                fa = ft;
                fb = stayed == -1 ? fb / 2 : fb;
                stayed = -1;
            } else {
                b = t;
                fb = ft;
                fa = stayed == 1 ? fa / 2 : fa;
                stayed = 1;
            }
        }
        return std::abs(fa) <= std::abs(fb) ? a : b;
    }

    const Edge &whole_;
    std::vector<double> roots_;
};

} // namespace

std::vector<double> edge_roots(const LevelNet::Edge &edge, bool above_at_start, bool above_at_end) {
    return EdgeSearch(edge).run(above_at_start, above_at_end);
}

} // namespace nrb::intersect
