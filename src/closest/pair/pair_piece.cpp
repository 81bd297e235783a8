#include "closest/pair/pair_piece.h"

#include "numeric/norm.h"
#include "refine/knots/bezier_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::closest {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

} // namespace

PairFrame pair_frame(const Spline &a, const Spline &b) {
    const auto dim = static_cast<size_t>(a.dim());
    std::vector<double> lower(dim, std::numeric_limits<double>::infinity()), upper(dim, -lower[0]);
    for (const Spline *spline : {&a.effective(), &b.effective()}) {
        for (int64_t i = 0; i < spline->point_count(); ++i) {
            for (size_t c = 0; c < dim && spline->weight(i) != 0; ++c) {
                const double x = spline->coordinate(i, static_cast<int>(c));
                lower[c] = std::min(lower[c], x);
                upper[c] = std::max(upper[c], x);
            }
        }
    }
    PairFrame frame;
    double extent = 0; // half of it, which does not overflow
    for (size_t c = 0; c < dim; ++c) {
        const bool any = std::isfinite(lower[c]) && std::isfinite(upper[c]);
        frame.centre.push_back(any ? lower[c] / 2 + upper[c] / 2 : 0);
        extent = std::max(extent, any ? upper[c] / 2 - lower[c] / 2 : 0);
    }
    frame.exponent = extent > 0 ? std::ilogb(extent) + 1 : 0;
    return frame;
}

Place PairPiece::parameter(const Place &place) const noexcept {
    Place result{};
    for (size_t k = 0; k < static_cast<size_t>(axes_); ++k) {
        const double t = from_[k] * (1 - place[k]) + to_[k] * place[k];
        result[k] = std::clamp(place[k] >= 1 ? to_[k] : t, from_[k], to_[k]);
    }
    return result;
}

Place PairPiece::place(const Place &parameter) const noexcept {
    Place result{};
    for (size_t k = 0; k < static_cast<size_t>(axes_); ++k) {
        result[k] = std::clamp((parameter[k] - from_[k]) / (to_[k] - from_[k]), 0.0, 1.0);
    }
    return result;
}

PairPiece::PairPiece(const double *point, int dim) : values_(point, point + dim) {
    shape_.width = dim + 1;
    values_.push_back(1);
    update();
}

void PairPiece::update() {
    const int width = shape_.width;
    const int64_t count = coefficients();
    if (record(0)[width - 1] < 0) {
        std::for_each(values_.begin(), values_.end(), [](double &x) { x = -x; });
    }
    double least = std::numeric_limits<double>::infinity(), reach = 0;
    points_.resize(static_cast<size_t>(count * dim()));
    box_.assign(static_cast<size_t>(2 * dim()), -std::numeric_limits<double>::infinity());
    std::fill_n(box_.begin(), dim(), std::numeric_limits<double>::infinity());
    for (int64_t i = 0; i < count; ++i) {
        const double w = record(i)[width - 1];
        least = std::min(least, w);
        double *x = points_.data() + i * dim();
        for (int c = 0; c < dim(); ++c) {
            x[c] = record(i)[c] / w;
            auto &low = box_[static_cast<size_t>(c)], &high = box_[static_cast<size_t>(dim() + c)];
            low = std::min(low, x[c]);
            high = std::max(high, x[c]);
        }
        reach = std::max(reach, norm(x, dim()));
    }
    positive_ = least > 64 * weight_error_ && least > 0 && std::isfinite(reach);
    size_ = 0;
    for (int c = 0; c < dim(); ++c) {
        size_ = std::max(size_, upper()[c] - lower()[c]);
    }
    moved_ = apart_ + 4 * eps * reach;
    if (weight_error_ > 0) { // else a control point of weight 0 is 0, and has no place to be moved from
        moved_ += 1.05 * (record_error_ + reach * weight_error_) / least;
    }
    positive_ = positive_ && std::isfinite(moved_);
}

// The longest sum of distances between neighbours along an axis.
double PairPiece::legs(int axis) const noexcept {
    int64_t step = 1;
    for (int k = axes_; k-- > axis + 1;) {
        step *= degree(k) + 1;
    }
    double longest = 0;
    for (int64_t first = 0; first < coefficients(); ++first) {
        if (first / step % (degree(axis) + 1) != 0) {
            continue;
        }
        double sum = 0;
        for (int i = 0; i < degree(axis); ++i) {
            sum += distance(point(first + i * step), point(first + (i + 1) * step), dim());
        }
        longest = std::max(longest, sum);
    }
    return longest;
}

// Each value is a mean of `degree` steps, off by degree eps / 2 of the same means of magnitudes.
std::optional<PairPiece> PairPiece::halve() {
    int axis = -1;
    double longest = -1;
    for (int k = 0; k < axes_; ++k) {
        const auto at = static_cast<size_t>(k);
        const double middle = from_[at] / 2 + to_[at] / 2;
        if (degree(k) > 0 && middle > from_[at] && middle < to_[at]) {
            const double found =
                positive_ ? legs(k) : (to_[at] - from_[at]) / std::max(std::abs(to_[at]), 1.0);
            if (!(found <= longest)) {
                longest = found;
                axis = k;
            }
        }
    }
    if (axis < 0) {
        return std::nullopt;
    }
    const double share = degree(axis) * eps;
    if (weight_error_ == 0) {
        apart_ += 1.01 * share * (moved_ + norm_of(dim(), [&](int c) {
                                      return std::max(std::abs(lower()[c]), std::abs(upper()[c]));
                                  }));
    } else {
        double most = 0, weight = 0;
        for (int64_t i = 0; i < coefficients(); ++i) {
            most = std::max(most, norm(record(i), dim()));
            weight = std::max(weight, std::abs(record(i)[dim()]));
        }
        record_error_ += share * most;
        weight_error_ += share * weight;
    }
    PairPiece lower = *this;
    nrb::halve(shape_, max_axes - axes_ + axis, values_.data(), lower.values_.data());
    const auto at = static_cast<size_t>(axis);
    lower.to_[at] = from_[at] = from_[at] / 2 + to_[at] / 2;
    update();
    lower.update();
    return lower;
}

std::vector<PairPiece> pair_pieces(const Spline &spline, const PairFrame &frame,
                                   const pieces::BernsteinNet::Breaks &more) {
    pieces::BernsteinNet::Breaks breaks;
    std::array<int, max_axes> degrees{};
    for (int k = 0; k < spline.axes(); ++k) {
        std::vector<double> &ends = breaks[static_cast<size_t>(k)];
        ends = refine::breaks_of(spline.axis(k));
        ends.insert(ends.end(), more[static_cast<size_t>(k)].begin(), more[static_cast<size_t>(k)].end());
        std::sort(ends.begin(), ends.end());
        ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
        degrees[static_cast<size_t>(k)] = spline.axis(k).degree();
    }
    const pieces::CentredRecords records =
        pieces::centred_records(spline, frame.centre, spline.rational(), pieces::weight_exponent(spline));
    const pieces::BernsteinNet net(spline, records, breaks, degrees);
    const auto count = static_cast<size_t>(net.shape().coefficients());
    const auto dim = static_cast<size_t>(spline.dim());
    // not a factor, which would overflow for the smallest models
    const auto scaled = [&frame](double x) { return std::ldexp(x, -frame.exponent); };
    std::vector<double> points(count * dim), weights(count, 1.0);
    std::vector<PairPiece> pieces(static_cast<size_t>(net.pieces()));
    for (size_t e = 0; e < pieces.size(); ++e) {
        PairPiece &piece = pieces[e];
        piece.axes_ = spline.axes();
        piece.index_ = static_cast<int64_t>(e);
        piece.shape_ = net.shape();
        piece.shape_.width = spline.dim() + 1;
        net.copy(piece.index_, points.data(), net.weighted() ? weights.data() : nullptr);
        for (size_t i = 0; i < count; ++i) {
            for (size_t c = 0; c < dim; ++c) {
                piece.values_.push_back(scaled(points[i * dim + c]));
            }
            piece.values_.push_back(weights[i]);
        }
        int64_t rest = piece.index_;
        for (int k = spline.axes(); k-- > 0;) {
            const auto &ends = breaks[static_cast<size_t>(k)];
            const int64_t n = std::ssize(ends) - 1;
            piece.from_[static_cast<size_t>(k)] = ends[static_cast<size_t>(rest % n)];
            piece.to_[static_cast<size_t>(k)] = ends[static_cast<size_t>(rest % n) + 1];
            rest /= n;
        }
        if (net.positive()) {
            piece.apart_ = 1.01 * 2 * net.error() * scaled(net.size(piece.index_));
        } else {
            piece.record_error_ = net.error() * scaled(net.largest_record());
            piece.weight_error_ = net.error() * net.largest_weight();
        }
        piece.update();
    }
    return pieces;
}

} // namespace nrb::closest
