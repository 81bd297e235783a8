// SPDX-License-Identifier: MIT
#include "build/coons/coons.h"

#include "build/coons/coons_patch.h"
#include "numeric/norm.h"
#include "refine/forms/homogeneous.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nrb::build {

namespace {

// The functions along an axis: along axis 1 boundaries 0 and 1 with their cross tangents, along axis 0
// boundaries 2 and 3.
BlendAxis blend_axis(const PatchCurves &curves, int axis) {
    const size_t first = axis == 0 ? 2 : 0;
    std::vector<Quotient> functions;
    for (const std::vector<SplinePtr> *family : {&curves.boundaries, &curves.cross}) {
        for (size_t i = first; i < first + 2 && !family->empty(); ++i) {
            functions.push_back(as_quotient((*family)[i]));
        }
    }
    return make_blend_axis(functions, curves.cross.empty() ? 1 : 3);
}

SplinePtr patch(const PatchCurves &curves, const CornerPair &own, const CornerMatrix &m) {
    const Form form = std::max(refine::common_form(curves.boundaries), refine::common_form(curves.cross));
    return coons_patch(blend_axis(curves, 0), blend_axis(curves, 1), own, m, form);
}

void set_mean(const CornerPair &pair, int i, int j, CornerMatrix &m) {
    std::transform(pair.along1.at(i, j), pair.along1.at(i, j) + m.dim(), pair.along0.at(i, j), m.at(i, j),
                   [](double a, double b) { return std::midpoint(a, b); });
}

} // namespace

SplinePtr surface_coons(const PatchCurves &curves, double tolerance) {
    const CornerPair pair = corner_pair(curves, 2);
    check_positions(pair, tolerance);
    CornerMatrix m(2, curves.dim());
    for (int corner = 0; corner < corner_count; ++corner) {
        set_mean(pair, corner / 2, corner % 2, m);
    }
    return patch(curves, pair, m);
}

namespace {

double length(Interval domain) noexcept {
    return domain.upper - domain.lower;
}

// The corner data of a Hermite patch: means of what is given twice, and twists by the rule.
class HermiteCorners {
public:
    HermiteCorners(const PatchCurves &curves, const TwistRule &twists)
        : dim_(curves.dim()), lengths_{length(curves.domain(0)), length(curves.domain(1))},
          has_cross_(!curves.cross.empty()), twists_(twists), pair_(corner_pair(curves, 4)), m_(4, dim_) {
        for (int corner = 0; corner < corner_count; ++corner) {
            set_corner(corner / 2, corner % 2);
        }
        for (int corner = 0; corner < corner_count; ++corner) {
            set_twist(corner / 2, corner % 2);
        }
    }
    [[nodiscard]] const CornerPair &pair() const noexcept { return pair_; }
    [[nodiscard]] const CornerMatrix &matrix() const noexcept { return m_; }
    // The largest difference between a twist and those of the cross tangents.
    [[nodiscard]] double twist_gap() const noexcept {
        double largest = 0;
        for (int i = 2; i < 4 && has_cross_; ++i) {
            for (int j = 2; j < 4; ++j) {
                largest = std::max({largest, distance(m_.at(i, j), pair_.along1.at(i, j), dim_),
                                    distance(m_.at(i, j), pair_.along0.at(i, j), dim_)});
            }
        }
        return largest;
    }

private:
    void set_corner(int i, int j) {
        set_mean(pair_, i, j, m_);
        if (has_cross_) {
            set_mean(pair_, i + 2, j, m_);
            set_mean(pair_, i, j + 2, m_);
        } else {
            std::copy_n(pair_.along0.at(i + 2, j), dim_, m_.at(i + 2, j));
            std::copy_n(pair_.along1.at(i, j + 2), dim_, m_.at(i, j + 2));
        }
    }
    void set_twist(int i, int j) {
        if (twists_.rule == twist_compatible || twists_.rule == twist_average) {
            return set_mean(pair_, i + 2, j + 2, m_);
        }
        for (int c = 0; c < dim_; ++c) {
            m_.at(i + 2, j + 2)[c] = twist(i, j, c);
        }
    }
    [[nodiscard]] double twist(int i, int j, int c) const noexcept {
        switch (twists_.rule) {
        case twist_given:
            return twists_.given[(2 * i + j) * dim_ + c];
        case twist_bilinear:
            return bilinear(c);
        case twist_adini:
            return adini(i, j, c);
        default:
            return 0;
        }
    }
    [[nodiscard]] double bilinear(int c) const noexcept {
        return ((m_.at(1, 1)[c] - m_.at(0, 1)[c]) - (m_.at(1, 0)[c] - m_.at(0, 0)[c])) / lengths_[0] /
               lengths_[1];
    }
    // The mixed derivative of (1 - u) c0(v) + u c1(v) + (1 - v) c2(u) + v c3(u) minus the bilinear patch, u
    // and v being mapped to [0, 1].
    [[nodiscard]] double adini(int i, int j, int c) const noexcept {
        const double across0 = pair_.along1.at(1, j + 2)[c] - pair_.along1.at(0, j + 2)[c];
        const double across1 = pair_.along0.at(i + 2, 1)[c] - pair_.along0.at(i + 2, 0)[c];
        return across0 / lengths_[0] + across1 / lengths_[1] - bilinear(c);
    }

    int dim_;
    std::array<double, 2> lengths_;
    bool has_cross_;
    TwistRule twists_;
    CornerPair pair_;
    CornerMatrix m_;
};

// The cubic whose values and derivatives at the ends are row or column i of m.
SplinePtr hermite_cubic(const CornerMatrix &m, int i, bool row, Interval domain) {
    const auto entry = [&](int j) { return row ? m.at(i, j) : m.at(j, i); };
    const double third = (domain.upper - domain.lower) / 3;
    const auto dim = static_cast<size_t>(m.dim());
    std::vector<double> points(4 * dim);
    for (size_t c = 0; c < dim; ++c) {
        points[c] = entry(0)[c];
        points[dim + c] = entry(0)[c] + third * entry(2)[c];
        points[2 * dim + c] = entry(1)[c] - third * entry(3)[c];
        points[3 * dim + c] = entry(1)[c];
    }
    const auto [a, b] = domain;
    return make_result({make_knot_vector(3, {a, a, a, a, b, b, b, b})}, m.dim(), Form::polynomial,
                       std::move(points));
}

// Cross tangents that are the Hermite cubics of the tangents and twists at the corners.
std::vector<SplinePtr> cross_of_corners(const PatchCurves &curves, const CornerMatrix &m) {
    const Interval u = curves.domain(0), v = curves.domain(1);
    return {hermite_cubic(m, 2, true, v), hermite_cubic(m, 3, true, v), hermite_cubic(m, 2, false, u),
            hermite_cubic(m, 3, false, u)};
}

} // namespace

HermitePatch surface_coons_hermite(const PatchCurves &curves, const TwistRule &twists, double tolerance) {
    const HermiteCorners corners(curves, twists);
    check_positions(corners.pair(), tolerance);
    const CornerGaps gaps = curves.cross.empty() ? CornerGaps{} : corner_gaps(curves);
    check_tangents(gaps, tolerance);
    if (twists.rule == twist_compatible) {
        check_twists(gaps, tolerance);
    }
    if (!curves.cross.empty()) {
        return {patch(curves, corners.pair(), corners.matrix()), corners.twist_gap()};
    }
    const PatchCurves whole{curves.boundaries, cross_of_corners(curves, corners.matrix())};
    CornerPair own{corners.matrix(), corners.matrix()};
    for (int corner = 0; corner < corner_count; ++corner) {
        const int i = corner / 2, j = corner % 2;
        std::copy_n(corners.pair().along1.at(i, j), curves.dim(), own.along1.at(i, j));
        std::copy_n(corners.pair().along0.at(i, j), curves.dim(), own.along0.at(i, j));
    }
    return {patch(whole, own, corners.matrix()), 0};
}

} // namespace nrb::build
