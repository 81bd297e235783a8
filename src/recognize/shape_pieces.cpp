#include "recognize/shape_pieces.h"

#include "pieces/bernstein_net.h"
#include "refine/knots/bezier_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::recognize {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
// The frame is orthonormal to 10 eps: z is a unit vector to 2 eps, x across it to 2 eps more, y their
// product; three products and sums add 3 eps.
constexpr double frame_error = 16 * eps;

double norm3(const double *p) noexcept {
    return std::hypot(p[0], p[1], p[2]);
}

// The sum of the steps from coefficient to coefficient along an axis.
double spread(const ShapePiece &piece, size_t axis) noexcept {
    const auto &degrees = piece.shape.degrees;
    int64_t step = 1;
    for (size_t k = axis + 1; k < degrees.size(); ++k) {
        step *= degrees[k] + 1;
    }
    double sum = 0;
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        const bool last = i / step % (degrees[axis] + 1) == degrees[axis];
        if (!last && piece.at(i)[3] != 0 && piece.at(i + step)[3] != 0) {
            sum += length(piece.point(i + step) - piece.point(i));
        }
    }
    return sum / static_cast<double>(piece.coefficients()) * (degrees[axis] + 1);
}

int widest_axis(const ShapePiece &piece) noexcept {
    int widest = -1;
    double most = -1;
    for (size_t k = 0; k < piece.shape.degrees.size(); ++k) {
        const double extent = piece.shape.degrees[k] > 0 ? spread(piece, k) : -2;
        if (extent > most || (piece.shape.degrees[k] > 0 && widest < 0)) {
            widest = static_cast<int>(k);
            most = extent;
        }
    }
    return widest;
}

} // namespace

bool ShapePiece::certify() noexcept {
    if (values[3] < 0 || (values[3] == 0 && values[values.size() - 1] < 0)) {
        std::for_each(values.begin(), values.end(), [](double &x) { x = -x; });
    }
    double least = std::numeric_limits<double>::infinity();
    size_ = 0;
    for (int64_t i = 0; i < coefficients(); ++i) {
        const double *p = at(i);
        if (p[3] == 0 && weight_error_ == 0 && p[0] == 0 && p[1] == 0 && p[2] == 0) {
            continue;
        }
        if (!(p[3] > 64 * weight_error_)) {
            return false;
        }
        least = std::min(least, p[3]);
        size_ = std::max(size_, norm3(p) / p[3] * (1 + 8 * eps));
    }
    moved_ = apart_ + 1.05 * (record_error_ + size_ * weight_error_) / least;
    return std::isfinite(moved_) && std::isfinite(least);
}

void ShapePiece::balance() noexcept {
    int64_t step = 1;
    for (size_t k = shape.degrees.size(); k-- > 0; step *= shape.degrees[k] + 1) {
        const int degree = shape.degrees[k];
        const double first = at(0)[3], last = at(degree * step)[3];
        if (degree == 0 || !(first > 0) || !(last > 0)) {
            continue;
        }
        const int exponent = (std::ilogb(first) - std::ilogb(last)) / degree;
        for (int64_t i = 0; i < coefficients() && exponent != 0; ++i) {
            const auto layer = static_cast<int>(i / step % (degree + 1));
            for (int64_t c = 4 * i; c < 4 * i + 4; ++c) {
                auto &value = values[static_cast<size_t>(c)];
                value = std::ldexp(value, exponent * layer);
            }
        }
    }
}

// Each value is a mean of `degree` steps, off by degree eps / 2 of the same means of magnitudes: of the
// weight, and of the size times the weight.
bool ShapePiece::halve_into(ShapePiece &lower) {
    const int axis = widest_axis(*this);
    if (axis < 0) {
        return false;
    }
    const double share = shape.degrees[static_cast<size_t>(axis)] * eps;
    if (weight_error_ == 0) {
        apart_ += 1.01 * share * size_;
    } else {
        double record = 0, weight = 0;
        for (int64_t i = 0; i < coefficients(); ++i) {
            record = std::max(record, norm3(at(i)));
            weight = std::max(weight, std::abs(at(i)[3]));
        }
        record_error_ += share * record;
        weight_error_ += share * weight;
    }
    lower = *this;
    halve(shape, axis, values.data(), lower.values.data());
    return true;
}

std::vector<ShapePiece> shape_pieces(const Spline &spline, const Shape &shape) {
    const auto dim = static_cast<size_t>(spline.dim());
    std::vector<double> centre{shape.origin.x, shape.origin.y, shape.origin.z};
    centre.resize(dim);
    pieces::BernsteinNet::Breaks breaks;
    std::array<int, max_axes> degrees{};
    for (int k = 0; k < spline.axes(); ++k) {
        breaks[static_cast<size_t>(k)] = refine::breaks_of(spline.axis(k));
        degrees[static_cast<size_t>(k)] = spline.axis(k).degree();
    }
    const pieces::CentredRecords records =
        pieces::centred_records(spline, centre, spline.rational(), pieces::weight_exponent(spline));
    const pieces::BernsteinNet net(spline, records, breaks, degrees);
    const auto count = static_cast<size_t>(net.shape().coefficients());
    std::vector<double> points(count * dim), weights(net.weighted() ? count : 0);
    std::vector<ShapePiece> pieces(static_cast<size_t>(net.pieces()));
    for (size_t e = 0; e < pieces.size(); ++e) {
        ShapePiece &piece = pieces[e];
        piece.shape = net.shape();
        piece.shape.width = 4;
        net.copy(static_cast<int64_t>(e), points.data(), weights.data());
        double reach = 0;
        for (size_t i = 0; i < count; ++i) {
            const double *x = points.data() + i * dim;
            const Vector3 p{x[0], x[1], dim > 2 ? x[2] : 0.0};
            piece.values.insert(piece.values.end(), {dot(shape.x, p), dot(shape.y, p), dot(shape.z, p),
                                                     weights.empty() ? 1.0 : weights[i]});
            reach = std::max(reach, length(p));
        }
        if (net.positive()) { // |A - A*| <= error H w, |w - w*| <= error w
            piece.balance();
            piece.apart_ = 1.01 * (2 * net.error() + frame_error) * net.size(static_cast<int64_t>(e));
        } else {
            piece.record_error_ = net.error() * net.largest_record() + frame_error * reach;
            piece.weight_error_ = net.error() * net.largest_weight();
        }
    }
    return pieces;
}

} // namespace nrb::recognize
