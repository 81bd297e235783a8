// SPDX-License-Identifier: MIT
#include "io/step/write/write_spline.h"

#include "io/written/spline_facts.h"

#include <string>
#include <vector>

namespace nrb::io::step {
namespace {

struct Multiplicities {
    std::vector<double> knots;
    std::vector<int64_t> times;
};

Multiplicities multiplicities(const KnotVector &axis) {
    Multiplicities result;
    for (const double knot : axis.knots()) {
        if (!result.knots.empty() && result.knots.back() == knot) {
            ++result.times.back();
        } else {
            result.knots.push_back(knot);
            result.times.push_back(1);
        }
    }
    return result;
}

std::vector<int64_t> write_points(ExchangeText &text, const Spline &spline, double length) {
    std::vector<int64_t> points(static_cast<size_t>(spline.point_count()));
    const auto dim = static_cast<size_t>(spline.dim());
    std::vector<double> point(dim);
    for (size_t i = 0; i < points.size(); ++i) {
        for (size_t c = 0; c < dim; ++c) {
            point[c] = length * spline.coordinate(static_cast<int64_t>(i), static_cast<int>(c));
        }
        points[i] = text.add("CARTESIAN_POINT", no_name, Reals{point});
    }
    return points;
}

// In rows along the last axis.
template <class Row>
void for_each_row(const Spline &spline, const Row &row) {
    const auto size = static_cast<size_t>(spline.count(1));
    for (size_t i = 0; i < static_cast<size_t>(spline.count(0)); ++i) {
        row(i * size, size);
    }
}

int64_t write_curve(ExchangeText &text, const Spline &curve, std::string_view name, double length) {
    const std::vector<int64_t> points = write_points(text, curve, length);
    const auto [knots, times] = multiplicities(curve.axis(0));
    const int degree = curve.axis(0).degree();
    const bool around = closed(curve, 0);
    if (!has_weights(curve)) {
        const int64_t number = text.reserve();
        text.add_as(number, "B_SPLINE_CURVE_WITH_KNOTS", Text{stated_name(name, number)}, degree,
                    Refs{points}, unspecified, around, not_told, Integers{times}, Reals{knots}, unspecified);
        return number;
    }
    const int64_t number = text.begin_complex();
    text.part("BOUNDED_CURVE");
    text.part("B_SPLINE_CURVE", degree, Refs{points}, unspecified, around, not_told);
    text.part("B_SPLINE_CURVE_WITH_KNOTS", Integers{times}, Reals{knots}, unspecified);
    text.part("CURVE");
    text.part("GEOMETRIC_REPRESENTATION_ITEM");
    text.part("RATIONAL_B_SPLINE_CURVE", Reals{weights_of(curve)});
    text.part("REPRESENTATION_ITEM", Text{stated_name(name, number)});
    text.end_complex();
    return number;
}

int64_t write_surface(ExchangeText &text, const Spline &surface, std::string_view name, double length) {
    const std::vector<int64_t> points = write_points(text, surface, length);
    const Multiplicities u = multiplicities(surface.axis(0)), v = multiplicities(surface.axis(1));
    const int degrees[] = {surface.axis(0).degree(), surface.axis(1).degree()};
    const bool around[] = {closed(surface, 0), closed(surface, 1)};
    const auto net = [&] {
        for_each_row(surface, [&](size_t first, size_t size) {
            text.attribute(Refs{std::span(points).subspan(first, size)});
        });
    };
    if (!has_weights(surface)) {
        const int64_t number = text.reserve();
        text.add_as(number, "B_SPLINE_SURFACE_WITH_KNOTS", Text{stated_name(name, number)}, degrees[0],
                    degrees[1], net, unspecified, around[0], around[1], not_told, Integers{u.times},
                    Integers{v.times}, Reals{u.knots}, Reals{v.knots}, unspecified);
        return number;
    }
    const std::vector<double> weights = weights_of(surface);
    const int64_t number = text.begin_complex();
    text.part("BOUNDED_SURFACE");
    text.part("B_SPLINE_SURFACE", degrees[0], degrees[1], net, unspecified, around[0], around[1], not_told);
    text.part("B_SPLINE_SURFACE_WITH_KNOTS", Integers{u.times}, Integers{v.times}, Reals{u.knots},
              Reals{v.knots}, unspecified);
    text.part("GEOMETRIC_REPRESENTATION_ITEM");
    text.part("RATIONAL_B_SPLINE_SURFACE", [&] {
        for_each_row(surface, [&](size_t first, size_t size) {
            text.attribute(Reals{std::span(weights).subspan(first, size)});
        });
    });
    text.part("REPRESENTATION_ITEM", Text{stated_name(name, number)});
    text.part("SURFACE");
    text.end_complex();
    return number;
}

} // namespace

std::string_view stated_name(std::string_view name, int64_t number) {
    return io::stated_name(name, "#" + std::to_string(number));
}

int64_t write_spline(ExchangeText &text, const Spline &spline, std::string_view name, double length) {
    return spline.axes() == 1 ? write_curve(text, spline, name, length)
                              : write_surface(text, spline, name, length);
}

} // namespace nrb::io::step
