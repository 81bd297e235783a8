// SPDX-License-Identifier: MIT
// Wild weights, high degrees, parameters outside, single precision.
#include "bench/table/rows.h"
#include "bench/table/shapes.h"

#include <string>

namespace bench {

namespace {

constexpr size_t places = 10000;

template <int kDegree>
void add_curve(Rows &rows, const std::string &job, const Net &net) {
    const auto pair = std::make_shared<CurvePoints<kDegree>>(net, places);
    rows.add({job, "Eigen", places, [=] { pair->run(); }, [=] { pair->run_other(); },
              [=] { return pair->difference(); }});
}

void add_outside(Rows &rows) {
    const auto inside = std::make_shared<CurvePoints<3>>(Net(1, 3, 100), places);
    const auto outside = std::make_shared<CurvePoints<3>>(Net(1, 3, 100), places);
    for (size_t i = 0; i < places; ++i) {
        outside->params[i] += 97.0 * (static_cast<double>(i % 10) - 5);
    }
    rows.add({"parameters ten periods around, NURBS_WRAP",
              "ours, inside",
              places,
              [=] { outside->run(NURBS_WRAP); },
              [=] { inside->run(); },
              {}});
}

void add_singles(Rows &rows) {
    for (const int32_t axes : {1, 2}) {
        const Net net(axes, 3, axes == 1 ? 100 : 20);
        const auto handle = std::shared_ptr<nurbs>(net.make());
        const auto params = std::make_shared<std::vector<double>>(net.params(places));
        const auto doubles = std::make_shared<std::vector<double>>(3 * places);
        const auto singles = std::make_shared<std::vector<float>>(3 * places);
        rows.add(
            {axes == 1 ? "curve in single precision" : "surface in single precision",
             "ours, double",
             places,
             [=] {
                 require_ok(
                     nurbs_eval_f32(handle.get(), places, params->data(), 0, 0, singles->data(), 0, 0, 0));
             },
             [=] {
                 require_ok(nurbs_eval(handle.get(), places, params->data(), 0, 0, doubles->data(), 0, 0, 0));
             },
             {}});
    }
}

} // namespace

void add_forms(Rows &rows) {
    add_curve<3>(rows, "curve, all weights wild", Net(1, 3, 100, Weights::all));
    add_curve<3>(rows, "curve, a sixth of the weights wild", Net(1, 3, 100, Weights::some));
    add_curve<3>(rows, "curve, one weight wild", Net(1, 3, 100, Weights::one));
    add_curve<10>(rows, "curve of degree 10", Net(1, 10, 100));
    add_curve<15>(rows, "curve of degree 15", Net(1, 15, 100));
    add_curve<31>(rows, "curve of degree 31", Net(1, 31, 100));
    add_outside(rows);
    add_singles(rows);
}

} // namespace bench
