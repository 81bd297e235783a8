#include "query/closest/patch_critical.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

namespace nrb {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_axes, max_axes>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_axes, 1>;

} // namespace

// Where a tangent vanishes, at a pole, the derivative along it does too, whatever the point: there all
// directions count.
bool PatchCritical::is_real(const Face &face, const PatchItem &whole, const AxisValues &at) const {
    const PatchJet here = descent_.jet(whole.values, at);
    double largest = 0;
    for (int k = 0; k < face.shape.axes; ++k) {
        const auto i = static_cast<size_t>(face.axis[static_cast<size_t>(k)]);
        largest = std::max(largest, here.metric[i][i]);
    }
    for (int k = 0; k < face.shape.axes; ++k) {
        const auto i = static_cast<size_t>(face.axis[static_cast<size_t>(k)]);
        if (here.metric[i][i] > eps * largest) {
            continue;
        }
        for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            AxisValues other = at;
            other[i] = t;
            const PatchJet jet = descent_.jet(whole.values, other);
            for (size_t j = 0; j < face.side.size(); ++j) { // an edge that is a point: like a corner
                if (face.side[j] >= 0 && !(jet.gradient[j] * here.gradient[j] > 0)) {
                    return false;
                }
            }
            for (int l = 0; l < face.shape.axes; ++l) {
                const auto j = static_cast<size_t>(face.axis[static_cast<size_t>(l)]);
                if (std::abs(jet.gradient[j]) > 64 * noise_ * std::sqrt(jet.metric[j][j]) + noise_ * noise_) {
                    return false;
                }
            }
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
            vanishes = vanishes || hessian(k, k) == 0;
        }
        const SmallVector values =
            Eigen::SelfAdjointEigenSolver<SmallMatrix>(hessian, Eigen::EigenvaluesOnly).eigenvalues();
        for (int k = 0; k < n && !(vanishes && n == 1); ++k) { // nothing to count along a point
            count(values(k), 1e4 * eps * (1 + trace));
        }
    }
    return rises      ? NURBS_CRITICAL_MINIMUM
           : falls    ? NURBS_CRITICAL_MAXIMUM
           : doubtful ? NURBS_CRITICAL_UNDECIDED
                      : NURBS_CRITICAL_SADDLE;
}

} // namespace nrb
