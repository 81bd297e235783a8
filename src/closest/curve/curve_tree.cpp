// SPDX-License-Identifier: MIT
#include "closest/curve/curve_tree.h"

#include "base/finite.h"
#include "base/numbers.h"
#include "base/watch.h"
#include "numeric/norm.h"
#include "pieces/bernstein_net.h"
#include "refine/knots/bezier_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::closest {

namespace {

// A leaf whose deviation from its chord is at most this part of the chord's length is not halved any further.
constexpr double straight = 1.0 / 16;

// The most halvings of a span. Leaves take ten times the memory of control points, so in curves of many spans
// the spans stay whole.
constexpr int most_halvings(int64_t spans) noexcept {
    return spans <= 1 << 12 ? 3 : spans <= 1 << 16 ? 1 : 0;
}

// The control points of a piece divided by their weights, with the bounds derived from them.
class PieceView {
public:
    PieceView(const double *records, int degree, int dim, int lanes) noexcept
        : records_(records), degree_(degree), dim_(dim), lanes_(lanes) {}

    [[nodiscard]] double weight(int i) const noexcept { return records_[(i + 1) * lanes_ - 1]; }
    [[nodiscard]] double x(int i, int c) const noexcept { return records_[i * lanes_ + c] / weight(i); }
    [[nodiscard]] bool positive() const noexcept {
        for (int i = 0; i <= degree_; ++i) {
            if (!(weight(i) > 0)) {
                return false;
            }
        }
        return true;
    }
    [[nodiscard]] double chord() const noexcept {
        return norm_of(dim_, [this](int c) { return x(degree_, c) - x(0, c); });
    }
    // The largest distance of a control point from the chord. By the convex hull property this bounds the
    // distance of the piece from its chord if the weights are positive; infinite otherwise.
    [[nodiscard]] double deviation() const noexcept {
        if (!positive()) {
            return infinity;
        }
        double largest = 0;
        for (int i = 1; i < degree_; ++i) {
            largest = std::max(largest, from_chord(i));
        }
        return largest;
    }

private:
    [[nodiscard]] double from_chord(int i) const noexcept {
        double along = 0, length = 0;
        for (int c = 0; c < dim_; ++c) {
            const double chord = x(degree_, c) - x(0, c);
            along += (x(i, c) - x(0, c)) * chord;
            length += chord * chord;
        }
        const double place = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
        return norm_of(dim_, [&](int c) { return x(i, c) - x(0, c) - place * (x(degree_, c) - x(0, c)); });
    }

    const double *records_;
    int degree_;
    int dim_;
    int lanes_;
};

constexpr int64_t work_of_a_record = 32; // a record is extracted, and halved a few times

} // namespace

// The boxes of a level: their lower ends and their upper ends, [count][dim] each.
struct CurveTree::Boxes {
    std::vector<double> lower;
    std::vector<double> upper;
};

CurveTree::CurveTree(const Spline &curve)
    : dim_(curve.dim()), degree_(curve.axis(0).degree()), lanes_((curve.dim() + 4) / 4 * 4),
      periodic_(curve.axis(0).periodic()), centre_(pieces::centre_of(curve)) {
    const pieces::CentredRecords records = pieces::centred_records(
        curve, centre_, curve.rational(), curve.rational() ? pieces::weight_exponent(curve) : 0);
    pieces::BernsteinNet::Breaks breaks{refine::breaks_of(curve.axis(0)), {}, {}};
    const int degrees[] = {degree_, 0, 0};
    const pieces::BernsteinNet net(curve, records, breaks, degrees);
    // rounding of the net, of the halvings and of what a search computes
    rounding_ = net.error() / std::numeric_limits<double>::epsilon() + 6 * degree_ + 2 * lanes_ + 20;
    const double extent = largest_magnitude(records.sizes);
    size_ = std::max(extent, norm(centre_.data(), dim_));
    exponent_ = extent > 0 && std::isfinite(extent) ? std::ilogb(extent) : 0;
    const auto count = static_cast<size_t>(degree_ + 1);
    std::vector<double> points(count * static_cast<size_t>(dim_)), weights(count, 1.0);
    std::vector<double> padded(count * static_cast<size_t>(lanes_));
    for (int64_t piece = 0; piece < net.pieces(); ++piece) {
        count_work(work_of_a_record * (degree_ + 1) * lanes_);
        net.copy(piece, points.data(), weights.data());
        for (size_t i = 0; i < count; ++i) {
            double *record = padded.data() + i * static_cast<size_t>(lanes_);
            const double *point = points.data() + i * static_cast<size_t>(dim_);
            std::transform(point, point + dim_, record,
                           [this](double x) { return std::ldexp(x, -exponent_); });
            record[lanes_ - 1] = weights[i];
        }
        if (std::all_of(weights.begin(), weights.end(), [](double w) { return w < 0; })) {
            std::for_each(padded.begin(), padded.end(), [](double &x) { x = 0.0 - x; });
        }
        const auto e = static_cast<size_t>(piece);
        add_span(padded.data(), {breaks[0][e], breaks[0][e + 1]}, most_halvings(net.pieces()));
    }
    const double ratio = weight_ratio();
    rounding_ *= net.positive() ? 1 : ratio;
    sound_ = ratio < 0x1p400;
    add_blocks();
    add_levels();
}

// The largest magnitude of a weight of the leaves over the smallest positive weight.
double CurveTree::weight_ratio() const noexcept {
    double smallest = infinity, largest = 0;
    for (size_t i = static_cast<size_t>(lanes_) - 1; i < records_.size(); i += static_cast<size_t>(lanes_)) {
        largest = std::max(largest, std::abs(records_[i]));
        smallest = records_[i] > 0 ? std::min(smallest, records_[i]) : smallest;
    }
    return largest / smallest;
}

void CurveTree::add_span(const double *records, Interval span, int halvings) {
    const PieceView view(records, degree_, dim_, lanes_);
    const double middle = span.lower / 2 + span.upper / 2;
    const double deviation = view.deviation();
    const bool divisible = span.lower < middle && middle < span.upper;
    if (deviation <= straight * view.chord() || halvings == 0 || !divisible) {
        records_.insert(records_.end(), records, records + (degree_ + 1) * lanes_);
        domains_.push_back(span);
        return;
    }
    std::vector<double> upper(records, records + (degree_ + 1) * lanes_), lower(upper.size());
    halve({{0, 0, degree_}, lanes_}, 2, upper.data(), lower.data());
    add_span(lower.data(), {span.lower, middle}, halvings - 1);
    add_span(upper.data(), {middle, span.upper}, halvings - 1);
}

void CurveTree::add_blocks() {
    blocks_.resize(static_cast<size_t>(block_count() * block_size()));
    for (int64_t i = 0; i < block_count() * fan; ++i) {
        const PieceView view(records(std::min(i, leaves() - 1)), degree_, dim_, lanes_);
        double *block = blocks_.data() + i / fan * block_size() + i % fan;
        double square = 0;
        const bool positive = view.positive();
        for (int c = 0; c < dim_; ++c) {
            const double chord = positive ? view.x(degree_, c) - view.x(0, c) : 0;
            block[c * fan] = positive ? view.x(0, c) : 0;
            block[(dim_ + c) * fan] = chord;
            square += chord * chord;
        }
        const double inverse = 1 / square;
        block[2 * dim_ * fan] = std::isfinite(inverse) ? inverse : 0;
        block[(2 * dim_ + 1) * fan] =
            std::isfinite(inverse) || !positive ? view.deviation() : view.deviation() + view.chord();
    }
}

CurveTree::Boxes CurveTree::leaf_boxes() const {
    const auto dim = static_cast<size_t>(dim_);
    Boxes boxes{std::vector<double>(static_cast<size_t>(leaves()) * dim, infinity),
                std::vector<double>(static_cast<size_t>(leaves()) * dim, -infinity)};
    for (int64_t leaf = 0; leaf < leaves(); ++leaf) {
        const PieceView view(records(leaf), degree_, dim_, lanes_);
        const bool positive = view.positive();
        for (size_t c = 0; c < dim; ++c) {
            double &lower = boxes.lower[static_cast<size_t>(leaf) * dim + c];
            double &upper = boxes.upper[static_cast<size_t>(leaf) * dim + c];
            for (int i = 0; i <= degree_; ++i) {
                const double x = view.x(i, static_cast<int>(c));
                lower = positive ? std::min(lower, x) : -infinity;
                upper = positive ? std::max(upper, x) : infinity;
            }
        }
    }
    return boxes;
}

void CurveTree::add_levels() {
    // The box of a parent encloses those of eight consecutive children. Unused places of a node that has
    // fewer children hold zeros; a search counts the children and never reads these.
    const auto dim = static_cast<size_t>(dim_);
    Boxes boxes = leaf_boxes();
    do {
        const size_t below = boxes.lower.size() / dim, count = (below + fan - 1) / fan;
        Boxes above{std::vector<double>(count * dim, infinity), std::vector<double>(count * dim, -infinity)};
        for (size_t i = 0; i < below; ++i) {
            for (size_t c = 0; c < dim; ++c) {
                double &lower = above.lower[i / fan * dim + c], &upper = above.upper[i / fan * dim + c];
                lower = std::min(lower, boxes.lower[i * dim + c]);
                upper = std::max(upper, boxes.upper[i * dim + c]);
            }
        }
        const size_t nodes = (count + fan - 1) / fan;
        std::vector<double> level(nodes * static_cast<size_t>(node_size()), 0.0);
        for (size_t i = 0; i < count; ++i) {
            double *node = level.data() + i / fan * static_cast<size_t>(node_size()) + i % fan;
            for (size_t c = 0; c < dim; ++c) {
                node[c * fan] = above.lower[i * dim + c];
                node[(dim + c) * fan] = above.upper[i * dim + c];
            }
        }
        levels_.push_back(std::move(level));
        boxes = std::move(above);
    } while (boxes.lower.size() / dim > fan);
}

int64_t CurveTree::leaf_at(double t) const noexcept {
    const auto after = std::upper_bound(domains_.begin(), domains_.end(), t,
                                        [](double x, const Interval &leaf) { return x < leaf.lower; });
    return std::max<int64_t>(after - domains_.begin() - 1, 0);
}

bool CurveTree::joined(int64_t leaf) const noexcept {
    if (leaf + 1 == leaves() && !periodic_) {
        return false;
    }
    const PieceView view(records(leaf), degree_, dim_, lanes_),
        next(records(after(leaf)), degree_, dim_, lanes_);
    const double gap = norm_of(dim_, [&](int c) { return view.x(degree_, c) - next.x(0, c); });
    return gap <= std::ldexp(2 * rounding_ * std::numeric_limits<double>::epsilon() * size_, -exponent_);
}

} // namespace nrb::closest
