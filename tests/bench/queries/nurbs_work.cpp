// libnurbs, through its C API, all points in one call.
#include "bench/queries/nurbs_work.h"

#include "support/handle.h"

namespace bench {

namespace {

Ask closest(const Question &question) {
    const std::shared_ptr<nurbs> g = support::create(question.shape);
    return [g, points = question.points, axes = question.shape.axes()] {
        const auto n = static_cast<int64_t>(points.size() / 3);
        std::vector<double> params(points.size() / 3 * static_cast<size_t>(axes)), feet(points.size());
        std::vector<double> distances(points.size() / 3);
        support::require_ok(nurbs_closest_points(g.get(), n, points.data(), 0, 0, nullptr, 0, 0,
                                                 params.data(), 0, 0, feet.data(), 0, 0, distances.data(), 0,
                                                 nullptr, 0));
        return params;
    };
}

Ask length(const Question &question) {
    const std::shared_ptr<nurbs> g = support::create(question.shape);
    return [g, tolerance = question.tolerance] {
        double value = 0;
        support::require_ok(nurbs_curve_length(g.get(), nullptr, tolerance, &value, nullptr));
        return std::vector{value};
    };
}

} // namespace

Ask nurbs_ask(const Question &question) {
    return question.kind == Kind::closest ? closest(question) : length(question);
}

} // namespace bench
