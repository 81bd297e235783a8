#include "eval/magnitude.h"

#include "spline/axis_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace nrb {

namespace {

// Within 2^-64 and 2^64 no square of a product of two derivatives of order 2 comes near the limits.
constexpr int usual_exponent = 64;

// A multiple of it, so that few copies serve a spline of many sizes.
int rounded(int exponent) noexcept {
    return exponent / usual_exponent * usual_exponent;
}

// The exponent of a size; 0 of 0.
int exponent_of(double size) noexcept {
    return size > 0 && std::isfinite(size) ? rounded(std::ilogb(size)) : 0;
}

struct RecordSize {
    double coordinates = 0;
    double weight = 0;

    void add(const RecordSize &other) noexcept {
        coordinates = std::max(coordinates, other.coordinates);
        weight = std::max(weight, other.weight);
    }
};

// Cartesian points of weight 0 are of no influence; weights apart have a common factor taken out already
// (Spline::records()).
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

using Layers = KnotVector::Layers;

// Calls visit(i) for the control points of some layers of each axis.
template <class Visit>
void for_each_point(const Spline &spline, const std::array<Layers, 2> &layers, Visit &&visit) {
    const int64_t row = spline.axes() == 2 ? spline.count(1) : 1;
    for (int64_t i = layers[0].first; i < layers[0].end; ++i) {
        for (int64_t j = layers[1].first; j < layers[1].end; ++j) {
            visit(i * row + j);
        }
    }
}

bool is_usual(double size, int power) noexcept {
    return size == 0 || (std::isfinite(size) && rounded(std::ilogb(size) + power) == 0);
}

bool usual_spans(const Spline &spline, const Powers &powers) noexcept {
    for (int k = 0; k < spline.axes(); ++k) {
        const KnotVector &axis = spline.axis(k);
        for (int64_t i = axis.degree(); i < axis.count(); ++i) {
            if (!is_usual(axis[i + 1] - axis[i], powers.knots[static_cast<size_t>(k)])) {
                return false;
            }
        }
    }
    return true;
}

// Sizes of all windows of control points that are active together, and of all spans.
class Windows {
public:
    explicit Windows(const Spline &given) : spline_(given.effective()) {
        for (int64_t i = 0; i < spline_.point_count(); ++i) {
            sizes_.push_back(size_of(spline_, i));
        }
        for (int k = 0; k < spline_.axes(); ++k) {
            widen(axis_view(spline_, k, 1), spline_.axis(k).degree());
        }
    }

    // What brings the largest of them near 1.
    [[nodiscard]] Powers powers_of_largest() const noexcept {
        RecordSize largest;
        for (const RecordSize &size : sizes_) {
            largest.add(size);
        }
        Powers powers{.coordinates = -exact_exponent(largest.coordinates),
                      .weights = -exact_exponent(largest.weight)};
        for (int k = 0; k < spline_.axes(); ++k) {
            const Interval domain = spline_.axis(k).domain();
            powers.knots[static_cast<size_t>(k)] = -exact_exponent(domain.upper / 2 - domain.lower / 2);
        }
        return powers;
    }

    // Whether all are usual when they are multiplied by these.
    [[nodiscard]] bool usual(const Powers &powers) const noexcept {
        return usual_spans(spline_, powers) &&
               std::all_of(sizes_.begin(), sizes_.end(), [&](const RecordSize &size) {
                   return is_usual(size.coordinates, powers.coordinates) &&
                          is_usual(size.weight, powers.weights);
               });
    }

private:
    static int exact_exponent(double size) noexcept {
        return size > 0 && std::isfinite(size) ? std::ilogb(size) : 0;
    }
    // Every one becomes the largest of itself and the next `degree` along an axis.
    void widen(const AxisView &view, int degree) {
        for (int64_t o = 0; o < view.outer; ++o) {
            for (int64_t i = 0; i < view.count; ++i) {
                const int64_t end = std::min(i + degree + 1, view.count);
                for (int64_t j = 0; j < view.inner; ++j) {
                    const auto at = [&](int64_t layer) {
                        return static_cast<size_t>((o * view.count + layer) * view.inner + j);
                    };
                    for (int64_t layer = i + 1; layer < end; ++layer) {
                        sizes_[at(i)].add(sizes_[at(layer)]);
                    }
                }
            }
        }
    }

    const Spline &spline_;
    std::vector<RecordSize> sizes_;
};

// What is found once for a spline.
struct Extent {
    bool usual = true;
    double size = 0;
    Powers powers;  // of the copy
    SplinePtr copy; // usual everywhere; none if the spline is, or if there is no such copy
};

// Of all points, without a look at which of them are active together.
class PlainSizes {
public:
    explicit PlainSizes(const Spline &given) : spline_(given.effective()) {
        const bool homogeneous = spline_.form() == Form::homogeneous;
        for (int64_t i = 0; i < spline_.point_count(); ++i) {
            const RecordSize size = size_of(spline_, i);
            coordinates_.add(size.coordinates);
            weights_.add(size.weight);
            const double length = homogeneous ? size.coordinates / size.weight : size.coordinates;
            longest_ = std::isfinite(length) ? std::max(longest_, length) : longest_;
        }
    }

    [[nodiscard]] double longest() const noexcept { return longest_; }
    // Whether each point is usual by itself, so that all windows are.
    [[nodiscard]] bool usual() const noexcept {
        return usual_spans(spline_, {}) && coordinates_.usual() && weights_.usual();
    }

private:
    struct Range { // of the sizes that are not 0
        double least = std::numeric_limits<double>::infinity();
        double most = 0;

        void add(double size) noexcept {
            least = size > 0 ? std::min(least, size) : least;
            most = std::max(most, size);
        }
        [[nodiscard]] bool usual() const noexcept {
            return most == 0 || (is_usual(least, 0) && is_usual(most, 0));
        }
    };

    const Spline &spline_;
    Range coordinates_;
    Range weights_;
    double longest_ = 0;
};

Extent find_extent(const Spline &spline) {
    const PlainSizes plain(spline);
    Extent extent{.usual = plain.usual(), .size = plain.longest(), .powers = {}, .copy = {}};
    if (extent.usual) {
        return extent;
    }
    const Windows windows(spline);
    extent.usual = windows.usual({});
    const Powers powers = windows.powers_of_largest();
    if (!extent.usual && windows.usual(powers)) {
        extent.powers = powers;
        extent.copy = scaled(spline, powers);
    }
    return extent;
}

const Extent &extent_of(const Spline &spline) {
    const Spline::AnyTable &found = spline.slot(Spline::Table::magnitude).get([&] {
        return Spline::AnyTable(std::make_shared<const Extent>(find_extent(spline)));
    });
    return *static_cast<const Extent *>(found.get());
}

// Of the length of a span, but so that no knot overflows.
int knot_power(const KnotVector &axis, int64_t span) noexcept {
    constexpr int most = 1000;
    const double half = axis[span + 1] / 2 - axis[span] / 2;
    const double largest = std::max(std::fabs(axis.knots().front()), std::fabs(axis.knots().back()));
    return -std::max(rounded(std::ilogb(half) + 1), rounded(std::ilogb(largest)) - most);
}

// For the control points that are active at a parameter, and its spans.
Powers powers_at(const Spline &spline, const std::array<double, 2> &placed, const AxisRules &rules) {
    Powers powers;
    std::array<Layers, 2> layers{{{0, 1}, {0, 1}}};
    for (size_t k = 0; k < static_cast<size_t>(spline.axes()); ++k) {
        const KnotVector &axis = spline.axis(static_cast<int>(k));
        const int64_t span = axis.find_span(placed[k], rules[k].left);
        layers[k] = {span - axis.degree(), span + 1};
        powers.knots[k] = knot_power(axis, span);
    }
    RecordSize largest;
    for_each_point(spline, layers, [&](int64_t i) { largest.add(size_of(spline, i)); });
    powers.coordinates = -exponent_of(largest.coordinates);
    powers.weights = -exponent_of(largest.weight);
    return powers;
}

// A list of parameters as a copy has them: where they are evaluated, whatever the rules say of the domain.
class Runs {
public:
    Runs(const Spline &spline, const AxisRules &rules, ConstRecords params)
        : spline_(spline), rules_(rules), params_(params) {
        for (size_t k = 0; k < rules.size(); ++k) {
            placed_rules_[k] = {rules[k].left, rules[k].nan, Outside::extrapolate};
        }
    }

    void operator()(const std::function<void(const MagnitudeRun &)> &body) {
        const Extent &extent = extent_of(spline_);
        if (extent.copy != nullptr) {
            return run(0, params_.count, extent.powers, *extent.copy, body);
        }
        for (int64_t first = 0, end = 0; first < params_.count; first = end) {
            const Powers powers = at(first);
            for (end = first + 1; end < params_.count && at(end) == powers;) {
                ++end;
            }
            run(first, end - first, powers, powers == Powers{} ? spline_ : copy(powers), body);
        }
    }

private:
    [[nodiscard]] double placed(int64_t i, size_t k) const noexcept {
        return place(params_(i, static_cast<int64_t>(k)), rules_[k],
                     spline_.axis(static_cast<int>(k)).domain());
    }

    [[nodiscard]] Powers at(int64_t i) const {
        std::array<double, 2> t{};
        for (size_t k = 0; k < static_cast<size_t>(spline_.axes()); ++k) {
            t[k] = placed(i, k);
            if (std::isnan(t[k])) {
                return {};
            }
        }
        return powers_at(spline_, t, rules_);
    }

    // Sizes that alternate share copies.
    const Spline &copy(const Powers &powers) {
        for (const auto &[known, made] : copies_) {
            if (known == powers) {
                return *made;
            }
        }
        copies_.emplace_back(powers, scaled(spline_, powers));
        return *copies_.back().second;
    }

    void run(int64_t first, int64_t count, const Powers &powers, const Spline &shown,
             const std::function<void(const MagnitudeRun &)> &body) const {
        if (&shown == &spline_) {
            ConstRecords params = params_;
            params.data = params_.record(first);
            params.count = count;
            return body({spline_, rules_, params, first, 0});
        }
        const int64_t axes = spline_.axes();
        std::vector<double> params(static_cast<size_t>(count * axes));
        for (int64_t i = 0; i < count; ++i) {
            for (int64_t k = 0; k < axes; ++k) {
                const auto at = static_cast<size_t>(k);
                params[static_cast<size_t>(i * axes + k)] =
                    std::ldexp(placed(first + i, at), powers.knots[at]);
            }
        }
        body({shown, placed_rules_, {params.data(), count, axes, axes, 1}, first, powers.size(spline_)});
    }

    const Spline &spline_;
    const AxisRules &rules_;
    ConstRecords params_;
    AxisRules placed_rules_;
    std::vector<std::pair<Powers, SplinePtr>> copies_;
};

} // namespace

bool usual_magnitude(const Spline &spline) {
    return extent_of(spline).usual;
}

double active_size(const Spline &spline) {
    return extent_of(spline).size;
}

void for_each_magnitude(const Spline &spline, const AxisRules &rules, ConstRecords params,
                        const std::function<void(const MagnitudeRun &)> &body) {
    Runs(spline, rules, params)(body);
}

Pending::Pending(const Records &out)
    : out_(out), values_(out.data == nullptr ? 0 : static_cast<size_t>(out.count * out.width)) {}

Records Pending::part(int64_t first, int64_t count) noexcept {
    double *data = out_.data == nullptr ? nullptr : values_.data() + first * out_.width;
    return {data, count, out_.width, out_.width, 1};
}

void Pending::multiply(int64_t first, int64_t count, int exponent) noexcept {
    const Records own = part(first, count);
    for (int64_t i = 0; own.data != nullptr && i < count * own.width; ++i) {
        own.data[i] = std::ldexp(own.data[i], exponent);
    }
}

void Pending::write() const noexcept {
    for (int64_t i = 0; out_.data != nullptr && i < out_.count; ++i) {
        for (int64_t c = 0; c < out_.width; ++c) {
            out_(i, c) = values_[static_cast<size_t>(i * out_.width + c)];
        }
    }
}

} // namespace nrb
