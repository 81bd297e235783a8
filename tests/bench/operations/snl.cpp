// SNL: the member functions of snlCurve, which change a copy.
#include "bench/operations/task.h"

#include <memory>
#include <snlCurve.h>

namespace {

using namespace bench;
using support::SplineData;
using Curve = std::shared_ptr<snlCurve>;

// The curve takes the arrays, which it frees.
Curve make_curve(const SplineData &data) {
    const auto count = static_cast<unsigned>(data.counts[0]);
    auto *points = new snlCtrlPoint[count];
    for (unsigned i = 0; i < count; ++i) {
        const double w = data.weight(i);
        points[i].components(w * data.coordinate(i, 0), w * data.coordinate(i, 1), w * data.coordinate(i, 2),
                             w);
    }
    auto *knots = new knot[data.knots[0].size()];
    std::copy(data.knots[0].begin(), data.knots[0].end(), knots);
    return std::make_shared<snlCurve>(
        count, points,
        new snlKnotVector(knots, static_cast<unsigned>(data.knots[0].size()), data.degrees[0]));
}

SplineData data_of(snlCurve &curve) {
    SplineData data{.degrees = {curve.degree()},
                    .counts = {curve.size()},
                    .knots = {{}},
                    .dim = 3,
                    .points = {},
                    .weights = {}};
    const snlKnotVector &knots = curve.knotVector();
    for (unsigned i = 0; i < static_cast<unsigned>(knots.size()); ++i) {
        data.knots[0].push_back(knots.val(i));
    }
    const snlCtrlPoint *points = curve.controlPointNet().getCtrlPts();
    for (int i = 0; i < curve.size(); ++i) {
        const double w = points[i].elements[3];
        for (int c = 0; c < 3; ++c) {
            data.points.push_back(points[i].elements[c] / w);
        }
        data.weights.push_back(w);
    }
    return data;
}

Work unary(const Task &task, const std::function<void(snlCurve &)> &change) {
    const Curve curve = make_curve(task.inputs[0]);
    return {[=] {
                snlCurve copy(*curve);
                change(copy);
            },
            [=] {
                snlCurve copy(*curve);
                change(copy);
                return std::vector<SplineData>{data_of(copy)};
            }};
}

void insert(snlCurve &curve, const std::vector<double> &knots) {
    for (const double knot : knots) {
        curve.insertKnot(knot, true);
    }
}

void decompose(snlCurve &curve) {
    int *added = nullptr;
    curve.createBezierSegments(&added);
    delete[] added;
}

// Every curve with the first, then with the last again, as each call changes both.
Work compatible_work(const Task &task) {
    std::vector<Curve> curves;
    for (const SplineData &data : task.inputs) {
        curves.push_back(make_curve(data));
    }
    const auto changed = [=] {
        std::vector<Curve> copies;
        for (const Curve &curve : curves) {
            copies.push_back(std::make_shared<snlCurve>(*curve));
        }
        for (size_t i = 1; i < copies.size(); ++i) {
            copies[0]->makeCompatible(copies[i].get());
        }
        for (size_t i = 1; i + 1 < copies.size(); ++i) {
            copies[0]->makeCompatible(copies[i].get());
        }
        return copies;
    };
    return {[=] { changed(); },
            [=] {
                std::vector<SplineData> results;
                for (const Curve &curve : changed()) {
                    results.push_back(data_of(*curve));
                }
                return results;
            }};
}

Work prepare(const Task &task) {
    switch (task.operation) {
    case Operation::refine:
        return unary(task, [knots = task.knots](snlCurve &curve) { insert(curve, knots); });
    case Operation::elevate:
        return unary(task, [](snlCurve &curve) { curve.elevateDegree(1); });
    case Operation::decompose:
        return unary(task, decompose);
    case Operation::compatible:
        return compatible_work(task);
    default: // knots are removed one at a time, by their place in the list
        return {};
    }
}

} // namespace

int main(int argc, char **argv) {
    return bench::run(argc, argv, "SNL", prepare);
}
