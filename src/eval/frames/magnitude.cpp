// SPDX-License-Identifier: MIT
#include "eval/frames/magnitude.h"

#include "base/numbers.h"
#include "spline/active_part.h"
#include "spline/at_origin.h"
#include "spline/axis_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace nrb::eval {

namespace {

// If sizes are within 2^-64 and 2^64, no square of a product of two second derivatives comes near the limits
// of double.
constexpr int usual_exponent = 64;

// The range of the sizes that are not 0.
class Range {
public:
    void add(double size) noexcept {
        least_ = size > 0 ? std::min(least_, size) : least_;
        most_ = std::max(most_, size);
    }
    [[nodiscard]] bool usual(int power) const noexcept {
        return most_ == 0 || (std::isfinite(most_) && std::ilogb(least_) + power > -usual_exponent &&
                              std::ilogb(most_) + power < usual_exponent);
    }
    // The exponent of the power of two that brings the middle of the two exponents to 0.
    [[nodiscard]] int power() const noexcept {
        return most_ > 0 && std::isfinite(most_) ? -((std::ilogb(least_) + std::ilogb(most_)) >> 1) : 0;
    }

private:
    double least_ = infinity;
    double most_ = 0;
};

// The largest |coordinate| and, if homogeneous, |weight| of one or several stored control points.
struct RecordSize {
    double coordinates = 0;
    double weight = 0;

    void add(const RecordSize &other) noexcept {
        coordinates = std::max(coordinates, other.coordinates);
        weight = std::max(weight, other.weight);
    }
};

// Cartesian points of weight 0 have no influence. The weights of rational splines do not count, because a
// common factor has already been taken out (Spline::records()).
RecordSize size_of(const Spline &spline, int64_t i) noexcept {
    RecordSize size;
    if (spline.form() == Form::rational && spline.weight(i) == 0) {
        return size;
    }
    const double *record = spline.points().data() + i * spline.stored_width();
    for (int c = 0; c < spline.dim(); ++c) {
        size.coordinates = std::max(size.coordinates, std::fabs(record[c]));
    }
    size.weight = spline.form() == Form::homogeneous ? std::fabs(record[spline.dim()]) : 0;
    return size;
}

// The sizes of all spans and of control points.
class Sizes {
public:
    explicit Sizes(const Spline &spline) : axes_(spline.knot_vectors()) {
        for (size_t k = 0; k < axes_.size(); ++k) {
            const KnotVector &axis = *axes_[k];
            for (int64_t i = axis.degree(); i < axis.count(); ++i) {
                spans_[k].add(axis[i + 1] - axis[i]);
            }
        }
    }
    void add(const RecordSize &size) noexcept {
        coordinates_.add(size.coordinates);
        weights_.add(size.weight);
    }

    // Whether all sizes are usual after multiplication by these powers of two.
    [[nodiscard]] bool usual(const Powers &powers) const noexcept {
        bool usual = coordinates_.usual(powers.coordinates) && weights_.usual(powers.weights);
        for (size_t k = 0; k < axes_.size(); ++k) {
            usual = usual && spans_[k].usual(powers.knots[k]);
        }
        return usual;
    }
    // Powers that make all sizes usual, if any powers do.
    [[nodiscard]] Powers powers() const noexcept {
        Powers powers{.coordinates = coordinates_.power(), .weights = weights_.power(), .knots = {}};
        for (size_t k = 0; k < axes_.size(); ++k) {
            powers.knots[k] = kept_apart({&axes_[k], 1}, spans_[k].power());
        }
        return powers;
    }

private:
    const Spline::Axes &axes_;
    Range coordinates_;
    Range weights_;
    std::array<Range, 2> spans_;
};

// Replaces every record size by the largest of itself and the next `degree` ones along an axis.
void widen(const AxisView &view, int degree, std::vector<RecordSize> &sizes) {
    for (int64_t o = 0; o < view.outer; ++o) {
        for (int64_t i = 0; i < view.count; ++i) {
            const int64_t end = std::min(i + degree + 1, view.count);
            for (int64_t j = 0; j < view.inner; ++j) {
                const auto at = [&](int64_t layer) {
                    return static_cast<size_t>((o * view.count + layer) * view.inner + j);
                };
                for (int64_t layer = i + 1; layer < end; ++layer) {
                    sizes[at(i)].add(sizes[at(layer)]);
                }
            }
        }
    }
}

// The sizes of all control points, each alone.
Sizes sizes_of_points(const Spline &spline) {
    Sizes sizes(spline);
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        sizes.add(size_of(spline, i));
    }
    return sizes;
}

// The sizes of all windows of control points that are active together.
Sizes sizes_of_windows(const Spline &spline) {
    std::vector<RecordSize> sizes;
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        sizes.push_back(size_of(spline, i));
    }
    for (int k = 0; k < spline.axes(); ++k) {
        widen(axis_view(spline, k, 1), spline.axis(k).degree(), sizes);
    }
    Sizes result(spline);
    const bool surface = spline.axes() == 2;
    const int64_t row = surface ? spline.count(1) : 1, windows = surface ? row - spline.axis(1).degree() : 1;
    for (int64_t i = 0; i < spline.count(0) - spline.axis(0).degree(); ++i) {
        for (int64_t j = 0; j < windows; ++j) {
            result.add(sizes[static_cast<size_t>(i * row + j)]);
        }
    }
    return result;
}

// Whether a spline is of usual magnitude after multiplication by powers of two. In most splines each single
// point is.
bool usual_times(const Spline &spline, const Powers &powers) {
    return sizes_of_points(spline).usual(powers) || sizes_of_windows(spline).usual(powers);
}

// The largest |coordinate| of a control point that is not at infinity.
double largest_coordinate(const Spline &spline) noexcept {
    const bool homogeneous = spline.form() == Form::homogeneous;
    double largest = 0;
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        const RecordSize size = size_of(spline, i);
        const double length = homogeneous ? size.coordinates / size.weight : size.coordinates;
        largest = std::isfinite(length) ? std::max(largest, length) : largest;
    }
    return largest;
}

// The magnitude of a spline, found once and kept with it.
struct Extent {
    bool usual = true;
    bool moved = false; // whether runs take the spline moved to the origin, or parts of it
    double size = 0;
    double run_size = 0;
    Powers powers;  // by which the copy is multiplied
    SplinePtr copy; // of usual magnitude; null if not needed, or impossible
};

void take_copy(const Spline &source, Extent &extent) {
    const Sizes windows = sizes_of_windows(source);
    extent.usual = false;
    extent.powers = windows.powers();
    extent.copy = windows.usual(extent.powers) ? scaled(source, extent.powers) : nullptr;
    extent.run_size = largest_coordinate(source);
}

// Derivatives are those of the spline moved to the origin, which may be tiny although its place is not.
Extent find_extent(const Spline &given) {
    const Spline &spline = given.effective(), &moved = at_origin(given);
    Extent extent;
    extent.size = extent.run_size = largest_coordinate(spline);
    if (!usual_times(spline, {})) {
        take_copy(spline, extent);
    }
    extent.moved = &moved != &given && !usual_times(moved, extent.powers);
    if (extent.moved) {
        take_copy(moved, extent);
    }
    return extent;
}

const Extent &extent_of(const Spline &spline) {
    return spline.kept<Extent>(Spline::Cache::magnitude,
                               [&] { return std::make_shared<const Extent>(find_extent(spline)); });
}

int exponent_of(double size) noexcept {
    return size > 0 && std::isfinite(size) ? std::ilogb(size) : 0;
}

// The exponent of b - a, which may overflow. If a and b differ, b - a is not 0.
int exponent_of_difference(double a, double b) noexcept {
    const double difference = b - a;
    return std::isfinite(difference) ? std::ilogb(difference) : std::numeric_limits<double>::max_exponent;
}

// The exponent of the largest control point of the derivative of a part along axis k, ignoring weights and
// the factor p. If that derivative vanishes, the exponent of 1 / span.
int slope_exponent(const Spline &part, int k) noexcept {
    const KnotVector &axis = part.axis(k);
    const int p = axis.degree();
    const AxisView view = axis_view(part, k, 1);
    int largest = std::numeric_limits<int>::min();
    for (int64_t o = 0; o < view.outer; ++o) {
        for (int64_t i = 1; i < view.count; ++i) {
            const int length = exponent_of_difference(axis[i], axis[i + p]);
            for (int64_t j = 0; j < view.inner; ++j) {
                const int64_t before = (o * view.count + i - 1) * view.inner + j, here = before + view.inner;
                for (int c = 0; c < part.dim(); ++c) {
                    const double from = part.coordinate(before, c), to = part.coordinate(here, c);
                    if (std::isfinite(from) && std::isfinite(to) && from != to) {
                        largest = std::max(largest, exponent_of_difference(from, to) - length);
                    }
                }
            }
        }
    }
    return largest > std::numeric_limits<int>::min() ? largest
                                                     : -exponent_of_difference(axis[p], axis[p + 1]);
}

// The powers of two that bring the control points and the first derivatives of a part near 1.
Powers powers_of_part(const Spline &part) noexcept {
    RecordSize largest;
    for (int64_t i = 0; i < part.point_count(); ++i) {
        largest.add(size_of(part, i));
    }
    Powers powers{.coordinates = -exponent_of(largest.coordinates),
                  .weights = -exponent_of(largest.weight),
                  .knots = {}};
    for (int k = 0; k < part.axes(); ++k) {
        powers.knots[static_cast<size_t>(k)] = kept_apart({&part.knot_vectors()[static_cast<size_t>(k)], 1},
                                                          slope_exponent(part, k) + powers.size(part));
    }
    return powers;
}

// Divides a list of parameters into runs. Copies are evaluated at the placed parameters, to which the rules
// for the domain have been applied.
class Runs {
public:
    using Body = std::function<void(const MagnitudeRun &)>;

    Runs(const Spline &spline, const AxisRules &rules, ConstRecords params, const Body &body)
        : spline_(spline), rules_(rules), params_(params), body_(body),
          order_(static_cast<size_t>(params.count)) {
        for (size_t k = 0; k < rules.size(); ++k) {
            placed_rules_[k] = {rules[k].left, rules[k].nan, Outside::extrapolate};
        }
        std::iota(order_.begin(), order_.end(), int64_t{0});
    }

    std::vector<int64_t> run() && {
        const Extent &extent = extent_of(spline_);
        if (extent.usual) {
            body_({spline_, rules_, params_, 0, 0});
        } else if (extent.copy != nullptr) {
            run_copy(*extent.copy, extent.powers, 0, params_.count);
        } else {
            run_parts();
        }
        return std::move(order_);
    }

private:
    using Spans = std::array<int64_t, max_axes>; // -1 for parameters that give NaN

    [[nodiscard]] double placed(int64_t i, size_t k) const noexcept {
        return place(params_(i, static_cast<int64_t>(k)), rules_[k],
                     spline_.axis(static_cast<int>(k)).domain());
    }

    [[nodiscard]] Spans spans_at(int64_t i) const noexcept {
        Spans spans{};
        for (int k = 0; k < spline_.axes(); ++k) {
            const auto at = static_cast<size_t>(k);
            const double t = placed(i, at);
            if (std::isnan(t)) {
                return {-1, -1, -1};
            }
            spans[at] = spline_.axis(k).find_span(t, rules_[at].left);
        }
        return spans;
    }

    void run_parts() {
        std::vector<Spans> spans;
        for (int64_t i = 0; i < params_.count; ++i) {
            spans.push_back(spans_at(i));
        }
        const auto spans_of = [&spans](int64_t i) -> const Spans & { return spans[static_cast<size_t>(i)]; };
        std::ranges::stable_sort(order_, {}, spans_of);
        for (size_t first = 0, end = 0; first < order_.size(); first = end) {
            for (end = first + 1; end < order_.size() && spans_of(order_[end]) == spans_of(order_[first]);) {
                ++end;
            }
            run_part(spans_of(order_[first]), static_cast<int64_t>(first), static_cast<int64_t>(end - first));
        }
    }

    void run_part(const Spans &spans, int64_t first, int64_t count) const {
        if (spans[0] < 0) {
            return run_copy(spline_, {}, first, count);
        }
        const Spline &source = extent_of(spline_).moved ? at_origin(spline_) : spline_.effective();
        const SplinePtr part = active_part(source, spans);
        const Powers powers = powers_of_part(*part);
        run_copy(*scaled(*part, powers), powers, first, count);
    }

    void run_copy(const Spline &copy, const Powers &powers, int64_t first, int64_t count) const {
        const int64_t axes = spline_.axes();
        std::vector<double> params;
        for (int64_t n = first; n < first + count; ++n) {
            for (size_t k = 0; k < static_cast<size_t>(axes); ++k) {
                params.push_back(std::ldexp(placed(order_[static_cast<size_t>(n)], k), powers.knots[k]));
            }
        }
        body_({copy, placed_rules_, {params.data(), count, axes, axes, 1}, first, powers.size(spline_)});
    }

    const Spline &spline_;
    const AxisRules &rules_;
    ConstRecords params_;
    const Body &body_;
    AxisRules placed_rules_;
    std::vector<int64_t> order_;
};

} // namespace

bool usual_magnitude(const Spline &spline) {
    return extent_of(spline).usual;
}

double active_size(const Spline &spline) {
    return extent_of(spline).size;
}

double size_of_runs(const Spline &spline) {
    return extent_of(spline).run_size;
}

std::vector<int64_t> for_each_magnitude(const Spline &spline, const AxisRules &rules, ConstRecords params,
                                        const std::function<void(const MagnitudeRun &)> &body) {
    return Runs(spline, rules, params, body).run();
}

} // namespace nrb::eval
