// SPDX-License-Identifier: MIT
#include "recognize/shape_pieces.h"

#include "base/numbers.h"

#include <algorithm>
#include <cmath>

namespace nrb::recognize {

namespace {

// The frame is orthonormal to 10 eps: z is a unit vector to 2 eps, x is orthogonal to it to 2 eps more, and y
// is their cross product. Three products and their sum add 3 eps.
constexpr double frame_error = 16 * eps;

// The sum of the lengths of the legs of the control net along an axis.
double spread(const pieces::BezierPiece &piece, int axis) noexcept {
    int64_t step = 1;
    for (int k = piece.axes(); k-- > axis + 1;) {
        step *= piece.degree(k) + 1;
    }
    double sum = 0;
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        const bool last = i / step % (piece.degree(axis) + 1) == piece.degree(axis);
        if (!last && piece.has_point(i) && piece.has_point(i + step)) {
            sum += length(point_of(piece, i + step) - point_of(piece, i));
        }
    }
    return sum / static_cast<double>(piece.coefficients()) * (piece.degree(axis) + 1);
}

// Applies a Moebius transformation to the parameter of each axis that makes the weights at its ends nearly
// equal, so that the middle of the parameter is near the middle of the piece. It is exact, since weights are
// multiplied by powers of two.
void balance(const BernsteinShape &shape, std::vector<double> &values) noexcept {
    int64_t step = 1;
    for (size_t k = shape.degrees.size(); k-- > 0; step *= shape.degrees[k] + 1) {
        const int degree = shape.degrees[k];
        const double first = values[3], last = values[static_cast<size_t>(4 * degree * step + 3)];
        if (degree == 0 || !(first > 0) || !(last > 0)) {
            continue;
        }
        const int exponent = (std::ilogb(first) - std::ilogb(last)) / degree;
        for (size_t i = 0; i < values.size() && exponent != 0; ++i) {
            const auto layer = static_cast<int>(static_cast<int64_t>(i / 4) / step % (degree + 1));
            values[i] = std::ldexp(values[i], exponent * layer);
        }
    }
}

// The coefficients with respect to the axes of the shape; `reach` becomes the largest length of one.
std::vector<double> turned(const pieces::BezierPiece &piece, const Shape &shape, double &reach) {
    std::vector<double> values;
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        const double *x = piece.record(i);
        const Vector3 p{x[0], x[1], piece.dim() > 2 ? x[2] : 0.0};
        values.insert(values.end(), {dot(shape.x, p), dot(shape.y, p), dot(shape.z, p), piece.weight(i)});
        reach = std::max(reach, length(p));
    }
    return values;
}

} // namespace

int widest_axis(const pieces::BezierPiece &piece) noexcept {
    int widest = -1;
    double most = -1;
    for (int k = 0; k < piece.axes(); ++k) {
        const double extent = piece.degree(k) > 0 ? spread(piece, k) : -2;
        if (extent > most || (piece.degree(k) > 0 && widest < 0)) {
            widest = k;
            most = extent;
        }
    }
    return widest;
}

std::vector<pieces::BezierPiece> shape_pieces(const Spline &spline, const Shape &shape) {
    std::vector<double> centre{shape.origin.x, shape.origin.y, shape.origin.z};
    centre.resize(static_cast<size_t>(spline.dim()));
    pieces::BezierNet net(spline, {std::move(centre), 0});
    std::vector<pieces::BezierPiece> result;
    result.reserve(static_cast<size_t>(net.count()));
    for (int64_t e = 0; e < net.count(); ++e) {
        pieces::BezierPiece &piece = result.emplace_back(net, e, spline.axes());
        double reach = 0;
        std::vector<double> values = turned(piece, shape, reach);
        pieces::Rounding rounding = net.rounding(e, frame_error);
        if (rounding.relative()) {
            balance(piece.shape(), values);
        } else {
            rounding.record += frame_error * reach;
        }
        piece.replace(4, std::move(values), rounding);
    }
    return result;
}

} // namespace nrb::recognize
