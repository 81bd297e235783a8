// SPDX-License-Identifier: MIT
// A Bezier piece of a curve relative to a query point, with the operations of a closest-point search.
// Included once per instruction set: see base/simd.h.
#if defined(NURBS_CLOSEST_CURVE_SEGMENT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef NURBS_CLOSEST_CURVE_SEGMENT_INL_H_
#undef NURBS_CLOSEST_CURVE_SEGMENT_INL_H_
#else
#define NURBS_CLOSEST_CURVE_SEGMENT_INL_H_
#endif

#include <algorithm>
#include <cmath>
#include <limits>

#include <hwy/highway.h>

#include "bernstein/de_casteljau.h"

HWY_BEFORE_NAMESPACE();
namespace nrb::closest {
namespace HWY_NAMESPACE {

// The degree and the number of lanes, as compile-time constants where they are known (kDegree >= 0,
// kLanes > 0).
template <int kDegree, int kLanes>
struct SegmentShape {
    int some_degree;
    int some_lanes;

    [[nodiscard]] HWY_INLINE int degree() const noexcept { return kDegree >= 0 ? kDegree : some_degree; }
    [[nodiscard]] HWY_INLINE int lanes() const noexcept { return kLanes > 0 ? kLanes : some_lanes; }
    [[nodiscard]] HWY_INLINE int size() const noexcept { return (degree() + 1) * lanes(); }
};

// Values at a place of a segment (D, w), the homogeneous piece with the query point as its origin and
// positive weights: `square` is the squared distance f = |D|^2 / w^2, `first` is g = (D . D') w - (D . D) w',
// so that f' = 2 g / w^3, and `second` is g'.
struct Slope {
    double square;
    double first;
    double second;
};

template <class Shape>
class SegmentTools {
public:
    // work: size() doubles.
    SegmentTools(const Shape &shape, double *work) noexcept : shape_(shape), work_(work) {}

    // de Casteljau's algorithm; the last three levels of its triangle give the value and the first and second
    // derivatives.
    [[nodiscard]] HWY_INLINE Slope slope(const double *HWY_RESTRICT segment, double s) const noexcept {
        const int p = shape_.degree(), lanes = shape_.lanes();
        double *HWY_RESTRICT b = work_;
        std::copy_n(segment, shape_.size(), b);
        const double r = 1 - s;
        for (int level = p; level > 2; --level) {
            casteljau_step(int64_t{level} * lanes, lanes, s, b);
        }
        double dd = 0, dd1 = 0, d1d1 = 0, dd2 = 0, w = 0, w1 = 0, w2 = 0;
        for (int c = 0; c < lanes; ++c) {
            double x0 = b[c], x1 = 0, x2 = 0;
            if (p >= 2) {
                const double u = b[c], v = b[lanes + c], z = b[2 * lanes + c];
                const double lower = r * u + s * v, upper = r * v + s * z;
                x0 = r * lower + s * upper;
                x1 = p * (upper - lower);
                x2 = double(p) * (p - 1) * ((z - v) - (v - u));
            } else if (p == 1) {
                x0 = r * b[c] + s * b[lanes + c];
                x1 = b[lanes + c] - b[c];
            }
            if (c == lanes - 1) {
                w = x0, w1 = x1, w2 = x2;
            } else {
                dd += x0 * x0, dd1 += x0 * x1, d1d1 += x1 * x1, dd2 += x0 * x2;
            }
        }
        return {dd / (w * w), dd1 * w - dd * w1, (d1d1 + dd2) * w - dd1 * w1 - dd * w2};
    }

    // The squared distance of control point i, which is an end of the segment.
    [[nodiscard]] HWY_INLINE double end_square(const double *segment, int i) const noexcept {
        const double *record = segment + i * shape_.lanes();
        const double w = record[shape_.lanes() - 1];
        double sum = 0;
        for (int c = 0; c < shape_.lanes() - 1; ++c) {
            sum += record[c] * record[c];
        }
        return sum / (w * w);
    }

    // Splits at s into the lower and the upper part; either may be stored in the segment itself.
    HWY_INLINE void split(const double *segment, double s, double *lower, double *upper) const noexcept {
        std::copy(segment, segment + (segment == upper ? 0 : shape_.size()), upper);
        subdivide(shape_.degree(), shape_.lanes(), s, upper, lower);
    }

    // Whether sign (|D|^2 - R^2 w^2) >= 0 is certain on the whole segment, with R^2 = square. It is if all
    // Bernstein coefficients of this polynomial are >= 0 by at least their rounding errors.
    // binomials[i] = binomial(p, i). Each coefficient is, up to a positive factor, a sum of at most p + 1
    // products of control points, with at most `lanes` terms each; (p + lanes + 8) eps times the sum of the
    // magnitudes bounds the error.
    [[nodiscard]] HWY_INLINE bool beyond(const double *HWY_RESTRICT segment, double square, double sign,
                                         const double *binomials, double *HWY_RESTRICT norms) const noexcept {
        const int p = shape_.degree(), lanes = shape_.lanes();
        double *HWY_RESTRICT scaled = work_; // binomial times record, with the weight times -R^2
        for (int i = 0; i <= p; ++i) {
            const double *record = segment + i * lanes;
            const double binomial = binomials[i];
            double sum = 0;
            for (int c = 0; c < lanes; ++c) {
                scaled[i * lanes + c] = binomial * record[c];
                sum += c == lanes - 1 ? square * record[c] * record[c] : record[c] * record[c];
            }
            scaled[(i + 1) * lanes - 1] *= -square;
            norms[i] = binomial * std::sqrt(sum);
        }
        const double unit = (p + lanes + 8) * std::numeric_limits<double>::epsilon();
        for (int k = 0; k <= 2 * p; ++k) {
            double value = 0, magnitude = 0;
            for (int i = std::max(0, k - p), j = k - i; i <= j; ++i, --j) {
                const double twice = i == j ? 1 : 2;
                double dot = 0;
                for (int c = 0; c < lanes; ++c) {
                    dot += segment[i * lanes + c] * scaled[j * lanes + c];
                }
                value += twice * binomials[i] * dot;
                magnitude += twice * norms[i] * norms[j];
            }
            if (!(sign * value >= unit * magnitude)) {
                return false;
            }
        }
        return true;
    }

private:
    Shape shape_;
    double *work_;
};

} // namespace HWY_NAMESPACE
} // namespace nrb::closest
HWY_AFTER_NAMESPACE();

#endif
