#include "closest/patch/patch_critical.h"
#include "closest/patch/patch_matrix.h"
#include "numeric/norm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nrb::closest {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr std::array along{0.0, 0.25, 0.5, 0.75, 1.0}; // places on an axis

} // namespace

// Whether a line of parameters along an axis is one point.
bool PatchCritical::is_point(const PatchItem &whole, AxisValues at, size_t axis) const {
    const auto dim = static_cast<size_t>(pieces_.shape().dim);
    std::vector<double> first(dim), other(dim);
    descent_.point(whole.values, at, first.data());
    return std::all_of(along.begin(), along.end(), [&](double t) {
        at[axis] = t;
        descent_.point(whole.values, at, other.data());
        return distance(first.data(), other.data(), pieces_.shape().dim) <= 64 * noise_;
    });
}

// Whether the distance is critical in all directions that meet in a line of parameters which is one point.
bool PatchCritical::is_critical_point(const Face &face, const PatchItem &whole, AxisValues at,
                                      size_t axis) const {
    const PatchJet here = descent_.jet(whole.values, at);
    return std::all_of(along.begin(), along.end(), [&](double t) {
        at[axis] = t;
        const PatchJet jet = descent_.jet(whole.values, at);
        bool critical = true;
        for (size_t j = 0; j < face.side.size(); ++j) { // an edge that is a point: like a corner
            critical = critical && (face.side[j] < 0 || jet.gradient[j] * here.gradient[j] > 0);
        }
        for (int l = 0; l < face.shape.axes; ++l) {
            const auto j = static_cast<size_t>(face.axis[static_cast<size_t>(l)]);
            const double noise = 64 * noise_ * std::sqrt(jet.metric[j][j]) + noise_ * noise_;
            critical = critical && std::abs(jet.gradient[j]) <= noise;
        }
        return critical;
    });
}

// Where a tangent vanishes at a pole the derivative along it does too, whatever the point: there all
// directions count. At a cusp, where points elsewhere along the axis are others, it is one all the same.
bool PatchCritical::is_real(const Face &face, const PatchItem &whole, const AxisValues &at) {
    const PatchJet here = descent_.jet(whole.values, at);
    double largest = 0;
    for (int k = 0; k < face.shape.axes; ++k) {
        const auto i = static_cast<size_t>(face.axis[static_cast<size_t>(k)]);
        largest = std::max(largest, here.metric[i][i]);
    }
    for (int k = 0; k < face.shape.axes; ++k) {
        const auto i = static_cast<size_t>(face.axis[static_cast<size_t>(k)]);
        if (here.metric[i][i] <= eps * largest && is_point(whole, at, i) &&
            !is_critical_point(face, whole, at, i)) {
            doubtful_ = doubtful_ || !is_at_pole(whole, at, true);
            return false;
        }
    }
    return true;
}

int32_t PatchCritical::kind(const Face &face, const PatchItem &whole, const AxisValues &at) const {
    const PatchJet jet = descent_.jet(whole.values, at);
    const int n = face.shape.axes;
    bool rises = true, falls = true, doubtful = false;
    const auto count = [&](double value, double error) {
        rises = rises && value > error;
        falls = falls && value < -error;
        doubtful = doubtful || !(std::abs(value) > error);
    };
    for (int k = 0; k < pieces_.shape().axes; ++k) {
        const auto i = static_cast<size_t>(k);
        if (face.side[i] >= 0) {
            const double inwards = face.side[i] == 0 ? jet.gradient[i] : -jet.gradient[i];
            count(inwards, 8 * noise_ * std::sqrt(jet.metric[i][i]) + noise_ * noise_);
        }
    }
    if (n > 0) {
        SmallMatrix hessian(n, n);
        double trace = 0;
        bool vanishes = false;
        for (int k = 0; k < n; ++k) {
            for (int l = 0; l < n; ++l) {
                const auto i = static_cast<size_t>(face.axis[static_cast<size_t>(k)]);
                const auto j = static_cast<size_t>(face.axis[static_cast<size_t>(l)]);
                const double scale = std::sqrt(jet.metric[i][i] * jet.metric[j][j]);
                hessian(k, l) =
                    scale > noise_ * noise_ ? (jet.metric[i][j] + jet.curvature[i][j]) / scale : 0.0;
            }
            trace += std::abs(hessian(k, k));
            const auto i = static_cast<size_t>(face.axis[static_cast<size_t>(k)]);
            vanishes = vanishes || (hessian(k, k) == 0 && is_point(whole, at, i));
        }
        const SmallVector values =
            Eigen::SelfAdjointEigenSolver<SmallMatrix>(hessian, Eigen::EigenvaluesOnly).eigenvalues();
        for (int k = 0; k < n && !(vanishes && n == 1); ++k) { // nothing to count along a point
            count(values(k), 1e4 * eps * (1 + trace));
        }
    }
    return rises      ? critical_minimum
           : falls    ? critical_maximum
           : doubtful ? critical_undecided
                      : critical_saddle;
}

} // namespace nrb::closest
