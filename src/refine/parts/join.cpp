// SPDX-License-Identifier: MIT
#include "refine/parts/join.h"

#include "base/numbers.h"
#include "numeric/norm.h"
#include "refine/degree/elevate.h"
#include "refine/forms/homogeneous.h"
#include "refine/parts/cut.h"
#include "spline/axis_view.h"

#include <algorithm>
#include <cmath>

namespace nrb::refine {

namespace {

void check_same(int64_t found, int64_t expected, size_t part, const char *what, int k) {
    if (found != expected) {
        fail(Status::incompatible, "parts[%zu]: %s %lld on axis %d, expected %lld as in parts[0]", part, what,
             static_cast<long long>(found), k, static_cast<long long>(expected));
    }
}

void check_same_knots(const KnotVector &found, const KnotVector &expected, size_t part, int k) {
    check_same(found.count(), expected.count(), part, "count", k);
    check_same(found.periodic() ? 1 : 0, expected.periodic() ? 1 : 0, part, "periodicity", k);
    for (int64_t i = 0; i < std::ssize(found.knots()); ++i) {
        if (found[i] != expected[i]) {
            fail(Status::incompatible, "parts[%zu]: knots[%lld] = %s on axis %d, expected %s as in parts[0]",
                 part, static_cast<long long>(i), Number(found[i]).text, k, Number(expected[i]).text);
        }
    }
}

void check_spaces(std::span<const SplinePtr> parts) {
    const Spline &first = *parts[0];
    for (size_t i = 1; i < parts.size(); ++i) {
        const Spline &part = *parts[i];
        if (part.axes() != first.axes() || part.dim() != first.dim()) {
            fail(Status::incompatible,
                 "parts[%zu]: %d axes in dimension %d, expected %d in %d as in parts[0]", i, part.axes(),
                 part.dim(), first.axes(), first.dim());
        }
    }
}

// Raises all parts to the highest degree on axis k.
void raise(std::vector<SplinePtr> &parts, int k) {
    int degree = 0;
    for (const SplinePtr &part : parts) {
        degree = std::max(degree, part->axis(k).degree());
    }
    for (SplinePtr &part : parts) {
        part = elevate(part, k, degree - part->axis(k).degree());
    }
}

// The parts in a common form and with common degrees, clamped at the ends that are to be joined. On all axes
// but `axis` the knots must then be equal.
std::vector<SplinePtr> prepared(std::span<const SplinePtr> given, int axis) {
    check_spaces(given);
    std::vector<SplinePtr> parts(given.begin(), given.end());
    for (int k = 0; k < parts[0]->axes(); ++k) {
        if (k != axis) {
            raise(parts, k);
        }
    }
    for (size_t i = 1; i < parts.size(); ++i) {
        for (int k = 0; k < parts[0]->axes(); ++k) {
            if (k != axis) {
                check_same_knots(parts[i]->axis(k), parts[0]->axis(k), i, k);
            }
        }
    }
    const Form form = common_form(parts);
    for (size_t i = 0; i < parts.size(); ++i) {
        parts[i] = in_form(clamp_ends(parts[i], axis, {i > 0, i + 1 < parts.size()}), form);
    }
    raise(parts, axis);
    return parts;
}

// The control points of a part, seen along the axis.
struct Points {
    std::vector<double> points;
    std::vector<double> weights;
    int64_t layers;
    int64_t outer;
    int64_t inner; // control points of a layer

    [[nodiscard]] size_t place(int64_t o, int64_t layer, int64_t i) const noexcept {
        return static_cast<size_t>((o * layers + layer) * inner + i);
    }
};

Points points_of(const Spline &part, int axis) {
    const AxisView view = axis_view(part, axis, 1);
    return {{part.points().begin(), part.points().end()},
            {part.weights().begin(), part.weights().end()},
            view.count,
            view.outer,
            view.inner};
}

// The end layer of one part and the first layer of the next.
class Seam {
public:
    Seam(const Points &before, const Points &after, int dim, Form form)
        : before_(before), after_(after), dim_(static_cast<size_t>(dim)), form_(form) {}

    // The factor by which the weights of the later part are to be multiplied, from its weight of largest
    // magnitude: 1 if the weights agree already.
    [[nodiscard]] double factor() const noexcept {
        double largest = 0, factor = 1;
        for_each([&](size_t a, size_t b) {
            if (std::abs(weight(after_, b)) > largest) {
                largest = std::abs(weight(after_, b));
                factor = weight(before_, a) / weight(after_, b);
            }
        });
        return factor;
    }
    // The largest relative difference of the weights after multiplication by the factor.
    [[nodiscard]] double disagreement(double factor) const noexcept {
        double worst = 0;
        for_each([&](size_t a, size_t b) {
            const double wanted = weight(before_, a), found = factor * weight(after_, b);
            if (found != wanted) {
                worst =
                    std::max(worst, std::abs(found - wanted) / std::max(std::abs(found), std::abs(wanted)));
            }
        });
        return worst;
    }
    // The largest distance between two control points that would become one.
    [[nodiscard]] double gap(double factor) const noexcept {
        double worst = 0;
        for_each([&](size_t a, size_t b) { worst = std::max(worst, distance(a, b, factor)); });
        return worst;
    }

private:
    template <class Body>
    void for_each(Body &&body) const {
        for (int64_t o = 0; o < before_.outer; ++o) {
            for (int64_t i = 0; i < before_.inner; ++i) {
                body(before_.place(o, before_.layers - 1, i), after_.place(o, 0, i));
            }
        }
    }
    [[nodiscard]] double weight(const Points &p, size_t i) const noexcept {
        return form_ == Form::polynomial ? 1
               : form_ == Form::rational ? p.weights[i]
                                         : p.points[i * (dim_ + 1) + dim_];
    }
    [[nodiscard]] double distance(size_t a, size_t b, double factor) const noexcept {
        if (form_ == Form::rational && (before_.weights[a] == 0 || after_.weights[b] == 0)) {
            return 0; // no shape depends on where a point of weight 0 is
        }
        const bool homogeneous = form_ == Form::homogeneous;
        const size_t width = homogeneous ? dim_ + 1 : dim_;
        const double wa = homogeneous ? weight(before_, a) : 1, wb = homogeneous ? weight(after_, b) : 1;
        return norm_of(static_cast<int>(dim_), [&](int k) {
            const auto c = static_cast<size_t>(k);
            const double x = before_.points[a * width + c], y = after_.points[b * width + c];
            if (wa == 0 || wb == 0) { // a point at infinity is only close to itself
                return x == factor * y ? 0 : infinity;
            }
            return x / wa - y / wb;
        });
    }

    const Points &before_;
    const Points &after_;
    size_t dim_;
    Form form_;
};

void scale_weights(Points &part, double factor, Form form) {
    if (factor != 1) {
        for (double &w : form == Form::homogeneous ? part.points : part.weights) {
            w *= factor;
        }
    }
}

// Appends the knots of a part after its first degree + 1, shifted so that its domain begins at the last knot
// so far.
void append_knots(std::vector<double> &knots, const KnotVector &part, size_t index) {
    const double start = knots.back(), lower = part.domain().lower;
    for (int64_t i = part.degree() + 1; i < std::ssize(part.knots()); ++i) {
        const double moved = start == lower ? part[i] : start + (part[i] - lower);
        if (!std::isfinite(moved - knots.front())) {
            fail(Status::not_representable, "parts[%zu]: moved to begin at %s, its knots overflow", index,
                 Number(start).text);
        }
        if (part[i] > part[i - 1] && !(moved > knots.back())) {
            fail(Status::knots_merge,
                 "parts[%zu]: moved to begin at %s, knots[%lld] = %s and knots[%lld] = %s would become one",
                 index, Number(start).text, static_cast<long long>(i - 1), Number(part[i - 1]).text,
                 static_cast<long long>(i), Number(part[i]).text);
        }
        knots.push_back(moved);
    }
}

// The layers of all parts one after another, without the first skip[i] layers of part i.
std::vector<double> side_by_side(const std::vector<Points> &parts, const std::vector<int64_t> &skip,
                                 std::vector<double> Points::*array) {
    std::vector<double> result;
    for (int64_t o = 0; o < parts[0].outer; ++o) {
        for (size_t i = 0; i < parts.size(); ++i) {
            const std::vector<double> &values = parts[i].*array;
            const auto row = std::ssize(values) / parts[i].outer;
            const auto from = values.begin() + o * row;
            result.insert(result.end(), from + skip[i] * (row / parts[i].layers), from + row);
        }
    }
    return result;
}

// Whether the two end layers become one. Updates the largest distance between such layers.
bool meet(const Seam &seam, double factor, JoinRule rule, size_t index, double &gap) {
    constexpr double rounding = 4 * eps;
    const double here = seam.gap(factor), weights = seam.disagreement(factor);
    gap = std::max(gap, here);
    if (here <= rule.tolerance && weights <= rounding) {
        return true;
    }
    if (rule.keep_gaps) {
        return false;
    }
    if (here <= rule.tolerance) {
        fail(Status::incompatible,
             "parts[%zu]: its first weights are not a multiple of the last weights of parts[%zu]; after "
             "scaling "
             "they differ by up to %s of themselves",
             index, index - 1, Number(weights).text);
    }
    fail(Status::gap, "parts[%zu] begins %s away from the end of parts[%zu], expected at most %s", index,
         Number(here).text, index - 1, Number(rule.tolerance).text);
}

} // namespace

Joined join(std::span<const SplinePtr> given, int axis, JoinRule rule) {
    const std::vector<SplinePtr> parts = prepared(given, axis);
    const Form form = parts[0]->form();
    const int degree = parts[0]->axis(axis).degree(), dim = parts[0]->dim();
    std::vector<Points> nets;
    std::vector<int64_t> skip(parts.size(), 0);
    std::vector<double> knots;
    double gap = 0;
    for (size_t i = 0; i < parts.size(); ++i) {
        nets.push_back(points_of(*parts[i], axis));
        const KnotVector &own = parts[i]->axis(axis);
        if (i == 0) {
            knots.assign(own.knots().begin(), own.knots().end());
            continue;
        }
        const Seam seam(nets[i - 1], nets[i], dim, form);
        const double factor = seam.factor();
        const bool one = degree > 0 && meet(seam, factor, rule, i, gap);
        if (one) {
            scale_weights(nets[i], factor, form);
            skip[i] = 1;
            knots.pop_back();
        }
        append_knots(knots, own, i);
    }
    Spline::Axes axes = parts[0]->knot_vectors();
    axes[static_cast<size_t>(axis)] = make_knot_vector(degree, std::move(knots), false, axis);
    return {make_result(std::move(axes), dim, form, side_by_side(nets, skip, &Points::points),
                        side_by_side(nets, skip, &Points::weights)),
            gap};
}

} // namespace nrb::refine
