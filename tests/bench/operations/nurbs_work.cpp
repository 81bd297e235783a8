// libnurbs, through its C API.
#include "bench/operations/nurbs_work.h"

#include "support/handle.h"

#include <algorithm>
#include <numbers>

namespace bench {

namespace {

using support::Handle;
using support::SplineData;
using Curve = std::shared_ptr<nurbs>;
using List = std::unique_ptr<nurbs_list, decltype(&nurbs_list_destroy)>;
using Unary = std::function<nurbs *(const nurbs *)>;

Work unary(const Task &task, const Unary &operation) {
    const Curve curve = support::create(task.inputs[0]);
    return {
        [=] { nurbs_destroy(operation(curve.get())); },
        [=] { return std::vector<SplineData>{support::read_back(Handle(operation(curve.get())).get())}; }};
}

nurbs *refined(const nurbs *g, const std::vector<double> &knots) {
    nurbs *out = nullptr;
    support::require_ok(nurbs_refine(g, 0, std::ssize(knots), knots.data(), &out));
    return out;
}

nurbs *elevated(const nurbs *g) {
    nurbs *out = nullptr;
    support::require_ok(nurbs_elevate(g, 0, 1, &out));
    return out;
}

List decomposed(const nurbs *g) {
    nurbs_list *list = nullptr;
    support::require_ok(nurbs_decompose(g, &list));
    return {list, nurbs_list_destroy};
}

std::vector<SplineData> items(const List &list) {
    int64_t count = 0;
    support::require_ok(nurbs_list_count(list.get(), &count));
    std::vector<SplineData> results;
    for (int64_t i = 0; i < count; ++i) {
        nurbs *item = nullptr;
        support::require_ok(nurbs_list_get(list.get(), i, &item));
        results.push_back(support::read_back(Handle(item).get()));
    }
    return results;
}

nurbs *reduced(const nurbs *g, double tolerance) {
    nurbs *out = nullptr;
    support::require_ok(nurbs_reduce_knots(g, 0, tolerance, nullptr, &out));
    return out;
}

Work list_work(const std::function<List()> &operation) {
    return {[=] { operation(); }, [=] { return items(operation()); }};
}

Work decompose_work(const Task &task) {
    const Curve curve = support::create(task.inputs[0]);
    return list_work([=] { return decomposed(curve.get()); });
}

Work compatible_work(const Task &task) {
    std::vector<Curve> curves;
    for (const SplineData &data : task.inputs) {
        curves.push_back(support::create(data));
    }
    return list_work([=] {
        std::vector<const nurbs *> handles;
        for (const Curve &curve : curves) {
            handles.push_back(curve.get());
        }
        nurbs_list *list = nullptr;
        support::require_ok(nurbs_make_compatible(std::ssize(handles), handles.data(), 0, 0, nullptr, &list));
        return List(list, nurbs_list_destroy);
    });
}

// A new spline from the handles of the inputs.
using Make = std::function<nurbs_status(const nurbs *const *, nurbs **)>;

Work making(const Task &task, const Make &make) {
    std::vector<Curve> curves;
    for (const SplineData &data : task.inputs) {
        curves.push_back(support::create(data));
    }
    const auto made = [=] {
        const nurbs *handles[4] = {};
        std::ranges::transform(curves, handles, [](const Curve &curve) { return curve.get(); });
        nurbs *out = nullptr;
        support::require_ok(make(handles, &out));
        return Handle(out);
    };
    return {[=] { made(); }, [=] { return std::vector<SplineData>{support::read_back(made().get())}; }};
}

Work make_work(const Task &task) {
    switch (task.operation) {
    case Operation::circle:
        return making(task, [](const nurbs *const *, nurbs **out) {
            return nurbs_curve_circle(3, circle_center, nullptr, nullptr, circle_radius, NURBS_ARC_THIRDS,
                                      out);
        });
    case Operation::revolve:
        return making(task, [](const nurbs *const *profile, nurbs **out) {
            return nurbs_revolve(*profile, nullptr, nullptr, 2 * std::numbers::pi, NURBS_ARC_THIRDS, out);
        });
    case Operation::ruled:
        return making(task, [](const nurbs *const *ends, nurbs **out) {
            return nurbs_ruled(ends[0], ends[1], 0, out);
        });
    case Operation::coons:
        return making(task, [](const nurbs *const *boundaries, nurbs **out) {
            return nurbs_surface_coons(boundaries, 0, out);
        });
    default:
        return {};
    }
}

} // namespace

Work nurbs_work(const Task &task) {
    switch (task.operation) {
    case Operation::refine:
        return unary(task, [knots = task.knots](const nurbs *g) { return refined(g, knots); });
    case Operation::elevate:
        return unary(task, elevated);
    case Operation::decompose:
        return decompose_work(task);
    case Operation::remove:
        return unary(task, [tolerance = task.tolerance](const nurbs *g) { return reduced(g, tolerance); });
    case Operation::compatible:
        return compatible_work(task);
    default:
        return make_work(task);
    }
}

} // namespace bench
