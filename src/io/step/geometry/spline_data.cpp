// SPDX-License-Identifier: MIT
#include "io/step/geometry/spline_data.h"

#include "base/error.h"
#include "basis/generators.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace nrb::io::step {
namespace {

enum class Knots { stated, bezier, uniform, quasi_uniform };

int read_degree(Attributes &attributes, const char *name) {
    const int64_t degree = attributes.integer(name);
    if (degree < 1 || degree > max_degree) {
        attributes.fail_attribute(Status::degree, name,
                                  "found " + std::to_string(degree) + ", expected 1 to " +
                                      std::to_string(max_degree));
    }
    return static_cast<int>(degree);
}

// Control points, all of one dimension.
class Net {
public:
    Net(Entities &entities, double length) noexcept : entities_(entities), length_(length) {}

    // The points of a list; how many.
    int64_t read(Attributes &attributes, const char *name) {
        int64_t count = 0;
        attributes.open(name);
        for (; attributes.more(name); ++count) {
            const int64_t number = attributes.reference(name);
            entities_.spend(3);
            add(read_point(entities_, number, attributes, name, length_), attributes, name);
        }
        return count;
    }

    [[nodiscard]] int dim() const noexcept { return dim_; }
    std::vector<double> take() noexcept { return std::move(points_); }

private:
    void add(const Point &point, const Attributes &attributes, const char *name) {
        dim_ = points_.empty() ? point.dim : dim_;
        if (point.dim != dim_) {
            attributes.fail_attribute(Status::syntax, name,
                                      "a point of " + std::to_string(point.dim) +
                                          " coordinates among those of " + std::to_string(dim_));
        }
        points_.insert(points_.end(), point.x.begin(), point.x.begin() + point.dim);
    }

    Entities &entities_;
    double length_;
    int dim_ = 3;
    std::vector<double> points_;
};

std::vector<int64_t> read_integers(Entities &entities, Attributes &attributes, const char *name) {
    std::vector<int64_t> values;
    attributes.open(name);
    while (attributes.more(name)) {
        entities.spend(1);
        values.push_back(attributes.integer(name));
    }
    return values;
}

void append_reals(Entities &entities, Attributes &attributes, const char *name, std::vector<double> &values) {
    attributes.open(name);
    while (attributes.more(name)) {
        entities.spend(1);
        values.push_back(attributes.real(name));
    }
}

// Multiplicities are believed only if their sum is right, which the control points bound.
void check_multiplicities(const Attributes &attributes, const std::vector<int64_t> &multiplicities,
                          int64_t knots, const char *name) {
    int64_t sum = 0;
    for (const int64_t multiplicity : multiplicities) {
        if (multiplicity < 1 || multiplicity > knots) {
            attributes.fail_attribute(Status::multiplicity, name, "found " + std::to_string(multiplicity));
        }
        sum = std::min(sum + multiplicity, knots + 1);
    }
    if (sum != knots) {
        const int64_t all = std::accumulate(multiplicities.begin(), multiplicities.end(), int64_t{0});
        attributes.fail_attribute(Status::count, name,
                                  "their sum is " + std::to_string(all) + ", expected " +
                                      std::to_string(knots) + ", count + degree + 1");
    }
}

std::vector<double> expanded(Attributes &attributes, const std::vector<int64_t> &multiplicities,
                             const std::vector<double> &knots, const char *name) {
    if (knots.size() != multiplicities.size()) {
        attributes.fail_attribute(Status::count, name,
                                  std::to_string(knots.size()) + " knots for " +
                                      std::to_string(multiplicities.size()) + " multiplicities");
    }
    std::vector<double> all;
    for (size_t i = 0; i < knots.size(); ++i) {
        all.insert(all.end(), static_cast<size_t>(multiplicities[i]), knots[i]);
    }
    return all;
}

struct AxisSize {
    int degree = 0;
    int64_t count = 0;
    [[nodiscard]] int64_t knots() const noexcept { return count + degree + 1; }
};

void check_count(const Attributes &attributes, const AxisSize &size, Knots form, const char *name) {
    const bool pieces = form != Knots::bezier || (size.count - 1) % size.degree == 0;
    if (size.count <= size.degree || !pieces) {
        attributes.fail_attribute(Status::too_few_points, name,
                                  std::to_string(size.count) + " along an axis of degree " +
                                      std::to_string(size.degree) +
                                      (pieces ? "" : ", expected a multiple of the degree and 1 more"));
    }
}

// Distances of 1 from the start of the domain at 0.
KnotVectorPtr generated(const AxisSize &size, Knots form, int axis) {
    std::vector<double> knots(static_cast<size_t>(size.knots()));
    const auto spans = static_cast<double>(size.count - size.degree);
    if (form == Knots::bezier) {
        std::vector<double> breaks(static_cast<size_t>((size.count - 1) / size.degree) + 1);
        std::iota(breaks.begin(), breaks.end(), 0.0);
        bezier_knots(size.degree, std::ssize(breaks) - 1, breaks.data(), knots);
    } else if (form == Knots::uniform) {
        uniform_knots(size.degree, size.count, 0, spans, knots);
    } else {
        open_uniform_knots(size.degree, size.count, 0, spans, knots);
    }
    std::ranges::transform(knots, knots.begin(), [](double t) { return std::nearbyint(t); });
    return make_knot_vector(size.degree, std::move(knots), false, axis);
}

Knots form_of(const Attributes &attributes, const char *stated, const char *bezier, const char *uniform,
              const char *quasi_uniform) {
    if (attributes.has_part(stated)) {
        return Knots::stated;
    }
    if (attributes.has_part(bezier)) {
        return Knots::bezier;
    }
    if (attributes.has_part(quasi_uniform)) {
        return Knots::quasi_uniform;
    }
    if (!attributes.has_part(uniform)) {
        fail(Status::syntax, "%s: says nothing about its knots", attributes.label().c_str());
    }
    return Knots::uniform;
}

// One common weight cancels.
void drop_equal(std::vector<double> &weights) {
    if (!weights.empty() && weights.front() != 0 &&
        std::ranges::all_of(weights, [&](double w) { return w == weights.front(); })) {
        weights.clear();
    }
}

void check_weight_count(const Attributes &attributes, size_t weights, int64_t points) {
    if (std::cmp_not_equal(weights, points)) {
        attributes.fail_attribute(Status::count, "weights_data",
                                  std::to_string(weights) + " weights for " + std::to_string(points) +
                                      " control points");
    }
}

SplinePtr finished(Spline::Axes axes, Net &net, std::vector<double> weights) {
    drop_equal(weights);
    const Form form = weights.empty() ? Form::polynomial : Form::rational;
    const int dim = net.dim();
    return make_spline(std::move(axes), dim, form, net.take(), std::move(weights));
}

} // namespace

namespace {

KnotVectorPtr read_stated_axis(Entities &entities, Attributes &attributes, const AxisSize &size) {
    if (attributes.complex()) {
        attributes.part("B_SPLINE_CURVE_WITH_KNOTS");
    } else {
        for (const char *name : {"curve_form", "closed_curve", "self_intersect"}) {
            attributes.skip(name);
        }
    }
    const std::vector<int64_t> multiplicities = read_integers(entities, attributes, "knot_multiplicities");
    check_multiplicities(attributes, multiplicities, size.knots(), "knot_multiplicities");
    std::vector<double> knots;
    append_reals(entities, attributes, "knots", knots);
    return make_knot_vector(size.degree, expanded(attributes, multiplicities, knots, "knots"));
}

std::vector<double> read_weights(Entities &entities, Attributes &attributes, int64_t count) {
    std::vector<double> weights;
    if (attributes.complex() && attributes.has_part("RATIONAL_B_SPLINE_CURVE")) {
        attributes.part("RATIONAL_B_SPLINE_CURVE");
        append_reals(entities, attributes, "weights_data", weights);
        check_weight_count(attributes, weights.size(), count);
    }
    return weights;
}

} // namespace

SplinePtr read_b_spline_curve(Entities &entities, const Instance &instance, double length) {
    Attributes attributes(entities.instances(), instance);
    const Knots form = form_of(attributes, "B_SPLINE_CURVE_WITH_KNOTS", "BEZIER_CURVE", "UNIFORM_CURVE",
                               "QUASI_UNIFORM_CURVE");
    attributes.part("REPRESENTATION_ITEM");
    attributes.skip("name");
    attributes.part("B_SPLINE_CURVE");
    AxisSize size{read_degree(attributes, "degree"), 0};
    Net net(entities, length);
    size.count = net.read(attributes, "control_points_list");
    check_count(attributes, size, form, "control_points_list");
    KnotVectorPtr axis =
        form == Knots::stated ? read_stated_axis(entities, attributes, size) : generated(size, form, -1);
    std::vector<double> weights = read_weights(entities, attributes, size.count);
    return finished({std::move(axis)}, net, std::move(weights));
}

namespace {

// Rows of the net, all of one length: u from row to row.
void read_rows(Attributes &attributes, Net &net, AxisSize &u, AxisSize &v) {
    const char *name = "control_points_list";
    attributes.open(name);
    for (; attributes.more(name); ++u.count) {
        const int64_t count = net.read(attributes, name);
        v.count = u.count == 0 ? count : v.count;
        if (count != v.count) {
            attributes.fail_attribute(Status::count, name,
                                      "a row of " + std::to_string(count) + " points behind one of " +
                                          std::to_string(v.count));
        }
    }
}

Spline::Axes read_stated_axes(Entities &entities, Attributes &attributes, const AxisSize &u,
                              const AxisSize &v) {
    if (attributes.complex()) {
        attributes.part("B_SPLINE_SURFACE_WITH_KNOTS");
    } else {
        for (const char *name : {"surface_form", "u_closed", "v_closed", "self_intersect"}) {
            attributes.skip(name);
        }
    }
    const std::vector<int64_t> u_times = read_integers(entities, attributes, "u_multiplicities");
    check_multiplicities(attributes, u_times, u.knots(), "u_multiplicities");
    const std::vector<int64_t> v_times = read_integers(entities, attributes, "v_multiplicities");
    check_multiplicities(attributes, v_times, v.knots(), "v_multiplicities");
    std::vector<double> u_knots, v_knots;
    append_reals(entities, attributes, "u_knots", u_knots);
    append_reals(entities, attributes, "v_knots", v_knots);
    return {make_knot_vector(u.degree, expanded(attributes, u_times, u_knots, "u_knots"), false, 0),
            make_knot_vector(v.degree, expanded(attributes, v_times, v_knots, "v_knots"), false, 1)};
}

std::vector<double> read_net_weights(Entities &entities, Attributes &attributes, const AxisSize &u,
                                     const AxisSize &v) {
    std::vector<double> weights;
    if (!attributes.complex() || !attributes.has_part("RATIONAL_B_SPLINE_SURFACE")) {
        return weights;
    }
    attributes.part("RATIONAL_B_SPLINE_SURFACE");
    attributes.open("weights_data");
    for (size_t rows = 1; attributes.more("weights_data"); ++rows) {
        append_reals(entities, attributes, "weights_data", weights);
        check_weight_count(attributes, weights.size(), static_cast<int64_t>(rows) * v.count);
    }
    check_weight_count(attributes, weights.size(), u.count * v.count);
    return weights;
}

} // namespace

SplinePtr read_b_spline_surface(Entities &entities, const Instance &instance, double length) {
    Attributes attributes(entities.instances(), instance);
    const Knots form = form_of(attributes, "B_SPLINE_SURFACE_WITH_KNOTS", "BEZIER_SURFACE", "UNIFORM_SURFACE",
                               "QUASI_UNIFORM_SURFACE");
    attributes.part("REPRESENTATION_ITEM");
    attributes.skip("name");
    attributes.part("B_SPLINE_SURFACE");
    AxisSize u{read_degree(attributes, "u_degree"), 0}, v{read_degree(attributes, "v_degree"), 0};
    Net net(entities, length);
    read_rows(attributes, net, u, v);
    check_count(attributes, u, form, "control_points_list");
    check_count(attributes, v, form, "control_points_list");
    if (net.dim() != 3) {
        attributes.fail_attribute(Status::dimension, "control_points_list",
                                  "points of 2 coordinates, expected 3");
    }
    Spline::Axes axes = form == Knots::stated ? read_stated_axes(entities, attributes, u, v)
                                              : Spline::Axes{generated(u, form, 0), generated(v, form, 1)};
    std::vector<double> weights = read_net_weights(entities, attributes, u, v);
    return finished(std::move(axes), net, std::move(weights));
}

} // namespace nrb::io::step
