// SPDX-License-Identifier: MIT
#include "fit/fit_image.h"

#include "base/finite.h"
#include "base/numbers.h"
#include "base/representable.h"
#include "base/watch.h"
#include "fit/span_samples.h"
#include "numeric/norm.h"
#include "refine/degree/elevate.h"
#include "refine/forms/homogeneous.h"
#include "refine/knots/insert.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace nrb::fit {

namespace {

constexpr int64_t work_of_a_point = 100;     // of mapping it
constexpr int64_t work_of_a_comparison = 10; // of two points
constexpr size_t points_between_counts = 256;

// Images under the map F at homogeneous samples (A, w): the numerators w F(A / w), and the weights w.
struct Numerators {
    std::vector<double> values;
    std::vector<double> weights; // empty: 1
};

// Appends those of packed samples, which have a weight each if `width` is more than dim.
void append_mapped(std::span<const double> samples, size_t dim, size_t width, const PointMap &map,
                   Numerators &result) {
    std::vector<double> points, images;
    for (size_t i = 0; i < samples.size(); i += width) {
        const double w = width > dim ? samples[i + dim] : 1;
        for (size_t c = 0; c < dim; ++c) {
            points.push_back(samples[i + c] / w);
        }
        if (width > dim) {
            result.weights.push_back(w);
        }
    }
    require_representable(points, "points of g");
    images.resize(points.size());
    map(points, images);
    require_representable(images, "the image");
    for (size_t i = 0; i < images.size(); ++i) {
        result.values.push_back(width > dim ? images[i] * samples[i / dim * width + dim] : images[i]);
    }
}

// Maps one block of samples at a time, because there may be many.
Numerators mapped(const Spline &sampled, size_t dim, bool rational, const PointMap &map) {
    constexpr size_t block = 4096;
    const std::span<const double> samples = sampled.points();
    const size_t width = dim + (rational ? 1 : 0), count = samples.size() / width;
    Numerators result;
    result.values.reserve(count * dim);
    result.weights.reserve(rational ? count : 0);
    for (size_t first = 0; first < count; first += block) {
        const size_t some = std::min(block, count - first);
        append_mapped(samples.subspan(first * width, some * width), dim, width, map, result);
        count_work(static_cast<int64_t>(some) * (work_of_a_point + static_cast<int64_t>(dim)));
    }
    return result;
}

// The layout of the samples along an axis. Consecutive ones are `inner` samples apart.
struct Lines {
    size_t spans;
    size_t places; // samples per span
    size_t inner;
};

// The largest error of each span of an axis.
std::vector<double> span_errors(const Numerators &numerators, std::span<const double> projected,
                                const Lines &lines, size_t dim) {
    std::vector<double> errors(lines.spans, 0.0);
    for (size_t i = 0; i * dim < projected.size(); ++i) {
        if (i % points_between_counts == 0) {
            count_work(points_between_counts * work_of_a_comparison);
        }
        const double gap =
            distance(numerators.values.data() + i * dim, projected.data() + i * dim, static_cast<int>(dim));
        double &error = errors[i / lines.inner / lines.places % lines.spans];
        error = std::max(error, numerators.weights.empty() ? gap : gap / std::abs(numerators.weights[i]));
    }
    return errors;
}

class ImageFit {
public:
    ImageFit(const SplinePtr &g, const PointMap &map, double tolerance, const Judge &judge)
        : fine_(g), map_(map), tolerance_(tolerance), judge_(judge), dim_(static_cast<size_t>(g->dim())) {
        for (int k = 0; k < g->axes(); ++k) {
            nodes_.emplace_back(g->axis(k).degree());
        }
    }

    FittedImage run() {
        double share = 0.25 / static_cast<double>(nodes_.size());
        for (int round = 0; round < max_rounds && stalled_ < max_stalled; ++round) {
            const Phase phase(0.25);
            if (refine_where_needed(share * tolerance_)) {
                continue;
            }
            Cuts cuts;
            FittedImage image = candidate(cuts);
            if (image.deviation <= tolerance_) {
                return image;
            }
            if (!cut_where_asked(cuts)) {
                if (judge_ && --patience_ < 0 && accept_samples(image)) {
                    return image;
                }
                note_progress(image);
                share /= 4;
            }
        }
        fail_to_converge();
    }

private:
    static constexpr int max_rounds = 120;
    static constexpr int max_stalled = 3;
    static constexpr int sufficient_degree = 3;
    static constexpr double rounding = 8 * eps; // of the numerators: errors that more knots do not reduce
    static constexpr int64_t max_points = int64_t{1} << 18;
    static constexpr double max_values = 0x1p24; // numbers in the samples, of which there are a few copies

    // A proven bound may be far above the deviation, and so cost many control points. Accepts the deviation
    // at samples if that is within the tolerance.
    bool accept_samples(FittedImage &image) const {
        const double deviation = sampled_deviation(*records(), *image.spline);
        if (deviation <= tolerance_) {
            image.deviation = deviation;
            image.proven = false;
        }
        return !image.proven;
    }

    // Counts a stall where the deviation has hardly fallen although there are more control points, or
    // although all targets are at the level of rounding: then only rounding errors are left.
    void note_progress(const FittedImage &image) {
        const int64_t points = image.spline->point_count();
        const bool tried = points > last_points_ || at_rounding_;
        stalled_ += tried && image.deviation > 0.75 * last_deviation_ ? 1 : 0;
        last_points_ = points;
        last_deviation_ = image.deviation;
    }

    [[noreturn]] void fail_to_converge() const {
        fail(Status::not_converged, "tolerance = %s is not reached with %lld control points",
             Number(tolerance_).text, static_cast<long long>(fine_->point_count()));
    }

    [[nodiscard]] SplinePtr records() const {
        return fine_->rational() ? refine::to_homogeneous(*fine_) : fine_;
    }

    [[nodiscard]] Lines lines_of(size_t k) const {
        Lines lines{static_cast<size_t>(fine_->axis(static_cast<int>(k)).spans().size()),
                    nodes_[k].with_checks().size(), 1};
        for (size_t j = k + 1; j < nodes_.size(); ++j) {
            lines.inner *= static_cast<size_t>(fine_->axis(static_cast<int>(j)).spans().size()) *
                           nodes_[j].nodes().size();
        }
        return lines;
    }

    // A volume may have a hundred samples per control point. Their number is largest while the axis with the
    // largest share of check places is the one that is checked.
    void require_room_for_samples() const {
        double values = static_cast<double>(dim_ + (fine_->rational() ? 1 : 0)), checks = 1;
        for (size_t k = 0; k < nodes_.size(); ++k) {
            const auto nodes = static_cast<double>(nodes_[k].nodes().size());
            values *= static_cast<double>(fine_->axis(static_cast<int>(k)).spans().size()) * nodes;
            checks = std::max(checks, static_cast<double>(nodes_[k].with_checks().size()) / nodes);
        }
        if (checks * values > max_values) {
            fail_to_converge();
        }
    }

    // Returns whether degrees were raised or spans cut.
    bool refine_where_needed(double target) {
        require_room_for_samples();
        std::vector<std::vector<double>> more(nodes_.size());
        std::vector<char> raised(nodes_.size(), 0);
        const SplinePtr homogeneous = records();
        bool cut = false;
        at_rounding_ = true;
        const Phase phase;
        Steps steps(std::ssize(nodes_));
        for (size_t k = 0; k < nodes_.size(); ++k, steps.next()) {
            Places places;
            for (size_t j = 0; j < nodes_.size(); ++j) {
                places[j] = j == k ? nodes_[j].with_checks() : nodes_[j].nodes();
            }
            const Numerators numerators =
                mapped(*sampled(*homogeneous, places), dim_, fine_->rational(), map_);
            const double least = rounding * largest_magnitude(numerators.values);
            const double wanted = std::max(target, least);
            at_rounding_ = at_rounding_ && target <= least;
            const SplinePtr projected = projected_along(
                *fine_, static_cast<int>(k), nodes_, copied_watched<double>(numerators.values), fine_->dim());
            const std::vector<double> errors =
                span_errors(numerators, projected->points(), lines_of(k), dim_);
            raised[k] = cheaper_raised(fine_->axis(static_cast<int>(k)), errors, wanted) ? 1 : 0;
            if (raised[k] == 0) {
                more[k] = new_knots(static_cast<int>(k), errors, wanted);
            }
            cut = cut || raised[k] != 0 || !more[k].empty();
        }
        insert(more);
        raise(raised);
        return cut;
    }

    // Whether cutting the spans of an axis of less than the sufficient degree would take more knots than
    // raising its degree does, which repeats every knot.
    static bool cheaper_raised(const KnotVector &axis, const std::vector<double> &errors, double target) {
        const int times = sufficient_degree - axis.degree();
        double knots = 0;
        for (const double error : errors) {
            knots += std::max(0.0, parts_wanted(axis, error, target) - 1);
        }
        return times > 0 && knots > static_cast<double>(times * std::ssize(errors));
    }

    void raise(const std::vector<char> &raised) {
        for (size_t k = 0; k < nodes_.size(); ++k) {
            if (raised[k] != 0) {
                const auto axis = static_cast<int>(k);
                fine_ = refine::elevate(fine_, axis, sufficient_degree - fine_->axis(axis).degree());
                nodes_[k] = LocalNodes(sufficient_degree);
                require_room(fine_->point_count());
            }
        }
    }

    // Where the image is smooth, the error of a part is that of the span divided by parts^(degree + 1).
    static double parts_wanted(const KnotVector &axis, double error, double target) noexcept {
        return std::ceil(std::pow(error / target, 1.0 / (axis.degree() + 1)));
    }

    void require_room(int64_t points) const {
        if (points > max_points) {
            fail_to_converge();
        }
    }

    void insert(const std::vector<std::vector<double>> &more) {
        int64_t points = 1;
        for (size_t k = 0; k < nodes_.size(); ++k) {
            points *= fine_->count(static_cast<int>(k)) + std::ssize(more[k]);
        }
        require_room(points);
        for (size_t k = 0; k < nodes_.size(); ++k) {
            fine_ = refine::refine(fine_, static_cast<int>(k), more[k]);
        }
    }

    // Cuts the spans into quarters; returns whether there were any.
    bool cut_where_asked(const Cuts &cuts) {
        std::vector<std::vector<double>> more(nodes_.size());
        bool cut = false;
        for (size_t k = 0; k < nodes_.size(); ++k) {
            for (size_t s = 0; s < cuts[k].size(); ++s) {
                if (cuts[k][s] != 0) {
                    append_parts(fine_->axis(static_cast<int>(k)), s, 4, more[k]);
                    cut = true;
                }
            }
        }
        insert(more);
        return cut;
    }

    void append_parts(const KnotVector &axis, size_t s, int parts, std::vector<double> &knots) const {
        const int64_t span = axis.spans().indices()[s];
        double last = axis[span];
        for (int i = 1; i < parts; ++i) {
            const double knot = axis[span] + (axis[span + 1] - axis[span]) * (static_cast<double>(i) / parts);
            if (!(knot > last) || !(knot < axis[span + 1])) {
                fail_to_converge();
            }
            knots.push_back(knot);
            last = knot;
        }
    }

    [[nodiscard]] std::vector<double> new_knots(int k, const std::vector<double> &errors,
                                                double target) const {
        constexpr double most_parts = 8;
        constexpr double nearly = 0.6; // a cut makes neighbours a little worse: margin against endless cuts
        constexpr double share = 0.2;  // of the largest error; smaller ones may come from a neighbour
        const KnotVector &axis = fine_->axis(k);
        std::vector<double> knots;
        const double largest = *std::max_element(errors.begin(), errors.end());
        if (largest <= target) {
            return knots;
        }
        for (size_t s = 0; s < errors.size(); ++s) {
            if (errors[s] <= std::max(nearly * target, share * largest)) {
                continue;
            }
            const auto parts =
                static_cast<int>(std::clamp(parts_wanted(axis, errors[s], target), 2.0, most_parts));
            append_parts(axis, s, parts, knots);
        }
        return knots;
    }

    [[nodiscard]] FittedImage candidate(Cuts &cuts) const {
        Places places;
        for (size_t j = 0; j < nodes_.size(); ++j) {
            places[j] = nodes_[j].nodes();
        }
        const SplinePtr homogeneous = records();
        Numerators numerators = mapped(*sampled(*homogeneous, places), dim_, fine_->rational(), map_);
        SplinePtr image = with_numerators(
            control_points(*fine_, nodes_, std::move(numerators.values), fine_->dim())->points());
        const double deviation =
            judge_ ? judge_(fine_, image, cuts) : sampled_deviation(*homogeneous, *image);
        return {std::move(image), deviation, judge_ != nullptr};
    }

    [[nodiscard]] SplinePtr with_numerators(std::span<const double> numerators) const {
        std::vector<double> weights(fine_->weights().begin(), fine_->weights().end());
        std::vector<double> points;
        points.reserve(numerators.size() + numerators.size() / dim_);
        count_work(static_cast<int64_t>(numerators.size()));
        for (size_t i = 0; i < numerators.size(); ++i) {
            const double weight = fine_->weight(static_cast<int64_t>(i / dim_));
            const bool divided = fine_->form() == Form::rational && weight != 0;
            points.push_back(divided ? numerators[i] / weight : numerators[i]);
            if (fine_->form() == Form::homogeneous && i % dim_ + 1 == dim_) {
                points.push_back(weight);
            }
        }
        require_representable(points, "control points");
        return make_result(fine_->knot_vectors(), fine_->dim(), fine_->form(), std::move(points),
                           std::move(weights));
    }

    [[nodiscard]] double sampled_deviation(const Spline &before, const Spline &image) const {
        Places places;
        for (size_t j = 0; j < nodes_.size(); ++j) {
            const int intervals = 2 * (fine_->axis(static_cast<int>(j)).degree() + 1);
            for (int i = 0; i <= intervals; ++i) {
                places[j].push_back(static_cast<double>(i) / intervals);
            }
        }
        const bool rational = fine_->rational();
        const Numerators exact = mapped(*sampled(before, places), dim_, rational, map_);
        const SplinePtr other = sampled(rational ? *refine::to_homogeneous(image) : image, places);
        const std::span<const double> got = other->points();
        const size_t width = dim_ + (rational ? 1 : 0);
        double largest = 0;
        for (size_t i = 0; i * dim_ < exact.values.size(); ++i) {
            if (i % points_between_counts == 0) {
                count_work(points_between_counts * work_of_a_comparison);
            }
            const double gap = norm_of(static_cast<int>(dim_), [&](int c) {
                const auto at = static_cast<size_t>(c);
                return got[i * width + at] - exact.values[i * dim_ + at];
            });
            largest = std::max(largest, rational ? gap / std::abs(exact.weights[i]) : gap);
        }
        return largest;
    }

    SplinePtr fine_;
    const PointMap &map_;
    double tolerance_;
    const Judge &judge_;
    size_t dim_;
    std::vector<LocalNodes> nodes_;
    int patience_ = 3; // rounds that may still pass without a proof
    int stalled_ = 0;
    int64_t last_points_ = 0;
    double last_deviation_ = HUGE_VAL;
    bool at_rounding_ = false; // the targets of all axes are at the level of rounding
};

} // namespace

FittedImage fit_image(const SplinePtr &g, const PointMap &map, double tolerance, const Judge &judge) {
    return ImageFit(g, map, tolerance, judge).run();
}

} // namespace nrb::fit
