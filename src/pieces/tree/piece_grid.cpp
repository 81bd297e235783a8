// SPDX-License-Identifier: MIT
#include "pieces/tree/piece_grid.h"

#include "base/finite.h"
#include "base/numbers.h"
#include "numeric/norm.h"
#include "pieces/extraction.h"
#include "refine/knots/bezier_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::pieces {

namespace {

int64_t multiplicity(const KnotVector &axis, double t) noexcept {
    const auto knots = axis.knots();
    const auto [first, last] = std::equal_range(knots.begin(), knots.end(), t);
    return last - first;
}

int exponent_of(double x) noexcept {
    return x > 0 && std::isfinite(x) ? std::ilogb(x) : 0;
}

} // namespace

PieceGrid::PieceGrid(const Spline &spline) : axes_(spline.axes()), frame_(frame_of(spline)) {
    set_axes(spline);
    squares_ = std::make_unique<PatchSquares>(shape_);
    set_extraction(spline);
    copy(spline);
}

void PieceGrid::set_axes(const Spline &spline) {
    shape_.dim = spline.dim();
    shape_.lanes = (spline.dim() + 1 + 3) / 4 * 4;
    shape_.weighted = spline.rational();
    int steps = 0;
    value_error_ = eps;
    for (int k = 0; k < axes_; ++k) {
        const KnotVector &axis = spline.axis(k);
        const auto at = static_cast<size_t>(k);
        breaks_[at] = refine::breaks_of(axis);
        periodic_[at] = axis.periodic();
        for (const double t : breaks_[at]) {
            const int64_t m = multiplicity(axis, t);
            jumps_[at].push_back(m > axis.degree() ? 1 : 0);
            kinks_[at].push_back(m >= axis.degree() ? 1 : 0);
        }
        count_ *= count(k);
        steps += axis.degree() + 1;
        value_error_ += axis.degree() > 0 ? (2 * axis.degree() + 1) * eps : 0;
        if (axis.degree() > 0) {
            map_[static_cast<size_t>(shape_.axes)] = k;
            shape_.degrees[static_cast<size_t>(shape_.axes++)] = axis.degree();
        }
    }
    allowance_ = 64 * steps * eps;
}

void PieceGrid::set_extraction(const Spline &spline) {
    for (int k = 0; k < axes_; ++k) {
        const KnotVector &axis = spline.axis(k);
        const auto at = static_cast<size_t>(k);
        const int n = axis.degree() + 1;
        layers_[at] = n;
        counts_[at] = axis.count();
        first_[at] = first_layers(axis, breaks_[at]);
        const LayerTable rows = PieceRows(axis, breaks_[at]).rows(0, std::ssize(breaks_[at]) - 1);
        extraction_[at].assign(static_cast<size_t>(rows.rows() * n), 0.0);
        for (int64_t r = 0; r < rows.rows(); ++r) {
            const LayerTable::Row &row = rows.row(r);
            double *out = extraction_[at].data() + r * n + row.first - first_[at][static_cast<size_t>(r / n)];
            *out = 1; // for rows that copy a layer
            std::copy_n(rows.coefficients(row), row.size, out);
        }
    }
}

// Axes of degree 0 have one layer for each piece.
NetPart PieceGrid::records_of(const Index &spans) const noexcept {
    Index first{};
    for (size_t k = 0; k < static_cast<size_t>(axes_); ++k) {
        first[k] = first_[k][static_cast<size_t>(spans[k])];
    }
    const int along = shape_.axes > 0 ? spline_axis(0) : max_axes - 1;
    NetPart net;
    net.first = records_.data() + ((first[0] * counts_[1] + first[1]) * counts_[2] + first[2]) * shape_.lanes;
    net.middle = along == 0 ? layers_[1] : 1;
    net.middle_stride = counts_[2] * shape_.lanes;
    net.run = (along < 2 ? layers_[2] : 1) * shape_.lanes;
    net.stride = (along == 0 ? counts_[1] * counts_[2] : along == 1 ? counts_[2] : 1) * shape_.lanes;
    return net;
}

// Computes the same sums as a BernsteinNet, with no more roundings.
void PieceGrid::patch(int64_t i, double *work, double *out) const noexcept {
    const Index spans = index(i);
    const NetPart records = records_of(spans);
    if (shape_.axes == 0) {
        std::copy_n(records.first, shape_.lanes, out);
    }
    double *from = shape_.axes % 2 == 0 ? out : work, *to = shape_.axes % 2 == 0 ? work : out;
    for (int k = 0; k < shape_.axes; ++k) {
        const auto axis = static_cast<size_t>(spline_axis(k));
        const int n = shape_.degree(k) + 1;
        const double *matrix = extraction_[axis].data() + spans[axis] * n * n;
        k == 0 ? apply_to_part(records, n, matrix, to) : apply_matrix(shape_, k, matrix, from, to);
        std::swap(from, to);
    }
    if (out[shape_.dim] < 0) { // if the weights have one sign, they may as well be positive
        std::for_each_n(out, shape_.values(), [](double &x) { x = 0.0 - x; });
    }
}

void PieceGrid::copy(const Spline &spline) {
    BezierNet net(spline, {frame_.centre, 0});
    const double largest = largest_magnitude(net.sizes());
    const bool overflows =
        !std::isfinite(largest) && spline.form() != Form::homogeneous; // norms overflow, not coordinates
    frame_.exponent = overflows ? std::numeric_limits<double>::max_exponent : exponent_of(largest);
    net.rescale(frame_.exponent);
    const CentredRecords &records = net.records();
    const auto width = static_cast<size_t>(records.width), dim = static_cast<size_t>(shape_.dim);
    records_.assign(records.sizes.size() * static_cast<size_t>(shape_.lanes), 0.0);
    double *out = records_.data();
    for (size_t i = 0; i < records.values.size(); i += width, out += shape_.lanes) {
        for (size_t c = 0; c < dim; ++c) {
            out[c] = frame_.scaled(records.values[i + c]);
        }
        out[dim] = records.weighted ? records.values[i + dim] : 1.0;
    }
    positive_ = net.positive();
    set_sizes(spline.effective(), net.sizes());
    // Homogeneous records are accurate relative to the magnitudes of points and centre, not to their
    // difference.
    const bool centred = spline.form() != Form::homogeneous;
    rounding_ = net.rounding_of_all(centred ? radius_ : frame_.scaled(largest));
}

// The radius is that of the control points; where their positions are not certain, it is the size to which
// the errors of the net are relative.
void PieceGrid::set_sizes(const Spline &spline, const std::vector<double> &sizes) {
    double smallest = infinity, largest = 0;
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        const double w = std::abs(spline.weight(i));
        smallest = std::min(smallest, w > 0 ? w : infinity);
        largest = std::max(largest, w);
        const double point = norm_of(spline.dim(), [&](int c) {
            return frame_.coordinate(static_cast<size_t>(c), spline.coordinate(i, c));
        });
        const double whole =
            norm_of(spline.dim(), [&](int c) { return frame_.scaled(spline.coordinate(i, c)); });
        if (w != 0 && std::isfinite(point) && std::isfinite(whole)) {
            radius_ = std::max(radius_, point * (1 + 8 * eps));
            size_ = std::max(size_, whole);
        }
    }
    if (!positive_) {
        radius_ = frame_.scaled(*std::max_element(sizes.begin(), sizes.end()));
    }
    ratio_ = positive_ ? 1 : largest / smallest;
}

PieceGrid::Index PieceGrid::index(int64_t piece) const noexcept {
    Index result{};
    for (int k = axes_; k-- > 0; piece /= count(k)) {
        result[static_cast<size_t>(k)] = piece % count(k);
    }
    return result;
}

int64_t PieceGrid::piece(const Index &index) const noexcept {
    int64_t result = 0;
    for (int k = 0; k < axes_; ++k) {
        result = result * count(k) + index[static_cast<size_t>(k)];
    }
    return result;
}

std::array<Interval, max_axes> PieceGrid::part(int64_t piece) const noexcept {
    const Index at = index(piece);
    std::array<Interval, max_axes> result{};
    for (int k = 0; k < axes_; ++k) {
        const int64_t i = at[static_cast<size_t>(k)];
        result[static_cast<size_t>(k)] = {break_at(k, i), break_at(k, i + 1)};
    }
    return result;
}

int64_t PieceGrid::neighbour(int axis, int64_t i, bool up) const noexcept {
    const int64_t n = count(axis), next = up ? i + 1 : i - 1;
    const bool wraps = (next < 0 || next == n) && periodic(axis);
    if ((next < 0 || next == n) && !wraps) {
        return -1;
    }
    const bool jump = wraps ? jumps(axis, 0) || jumps(axis, n) : jumps(axis, std::max(i, next));
    return jump ? -1 : (next + n) % n;
}

int64_t PieceGrid::find(int axis, double t) const noexcept {
    const auto &breaks = breaks_[static_cast<size_t>(axis)];
    const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, t);
    return above - breaks.begin() - 1;
}

std::vector<int64_t> PieceGrid::containing(const AxisValues &parameters) const {
    std::vector<int64_t> found{0};
    for (int k = 0; k < axes_; ++k) {
        const auto &ends = breaks_[static_cast<size_t>(k)];
        const double t = parameters[static_cast<size_t>(k)];
        const auto at = std::lower_bound(ends.begin(), ends.end(), t) - ends.begin();
        std::vector<int64_t> next;
        for (const int64_t base : found) {
            if (at > 0 && at <= count(k)) {
                next.push_back(base * count(k) + at - 1);
            }
            if (at < count(k) && break_at(k, at) == t) {
                next.push_back(base * count(k) + at);
            }
        }
        found = std::move(next);
    }
    return found;
}

void PieceGrid::place(const double *x, double *out) const noexcept {
    std::fill_n(out, shape_.lanes, 0.0);
    for (int c = 0; c < shape_.dim; ++c) {
        out[c] = frame_.difference(x[c], frame_.centre[static_cast<size_t>(c)]);
    }
}

double PieceGrid::scaled(double length) const noexcept {
    return frame_.scaled(length);
}

double PieceGrid::unscaled(double length) const noexcept {
    return frame_.unscaled(length);
}

double PieceGrid::magnitude(const double *x) const noexcept {
    return norm_of(shape_.dim, [&](int c) { return frame_.scaled(x[c]); });
}

const PieceGrid &piece_grid_of(const Spline &spline) {
    return spline.kept<PieceGrid>(Spline::Cache::grid,
                                  [&] { return std::make_shared<const PieceGrid>(spline); });
}

} // namespace nrb::pieces
