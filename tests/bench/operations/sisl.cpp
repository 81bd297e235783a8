// SISL: s1018, s1750, s1730, s1940 and, of its inner functions, s1931.
#include "bench/operations/task.h"
#include "bench/rational.h"

#include <memory>
#include <sisl.h>
#include <stdexcept>

// As sislP.h declares it; that header does not compile as C++.
extern "C" void s1931(int, SISLCurve **, double **, double **, int *, int *, int *);

namespace {

using namespace bench;
using support::SplineData;
using Curve = std::shared_ptr<SISLCurve>;
constexpr int polynomial_kind = 1;
constexpr int rational_kind = 2; // coefficients (w x, w y, w z, w)
constexpr int copy_arrays = 1;

void require(int status) {
    if (status < 0) {
        throw std::runtime_error("SISL: status " + std::to_string(status));
    }
}

Curve make_curve(const SplineData &data) {
    std::vector<double> knots = data.knots[0], points = homogeneous(data);
    return {newCurve(static_cast<int>(data.counts[0]), data.degrees[0] + 1, knots.data(), points.data(),
                     rational_kind, data.dim, copy_arrays),
            freeCurve};
}

// For functions that know no weights: homogeneous points as a curve in four dimensions.
Curve make_homogeneous(const SplineData &data) {
    std::vector<double> knots = data.knots[0], points = homogeneous(data);
    return {newCurve(static_cast<int>(data.counts[0]), data.degrees[0] + 1, knots.data(), points.data(),
                     polynomial_kind, data.dim + 1, copy_arrays),
            freeCurve};
}

SplineData cartesian(int degree, int count, const double *knots, const double *records) {
    SplineData data{
        .degrees = {degree}, .counts = {count}, .knots = {{}}, .dim = 3, .points = {}, .weights = {}};
    data.knots[0].assign(knots, knots + count + degree + 1);
    for (int i = 0; i < count; ++i, records += 4) {
        for (int c = 0; c < 3; ++c) {
            data.points.push_back(records[c] / records[3]);
        }
        data.weights.push_back(records[3]);
    }
    return data;
}

SplineData data_of(const Curve &curve) {
    const double *records = curve->ikind == rational_kind ? curve->rcoef : curve->ecoef;
    return cartesian(curve->ik - 1, curve->in, curve->et, records);
}

Curve refined(const Curve &curve, std::vector<double> knots) {
    SISLCurve *out = nullptr;
    int status = 0;
    s1018(curve.get(), knots.data(), static_cast<int>(knots.size()), &out, &status);
    require(status);
    return {out, freeCurve};
}

Curve elevated(const Curve &curve) {
    SISLCurve *out = nullptr;
    int status = 0;
    s1750(curve.get(), curve->ik + 1, &out, &status);
    require(status);
    return {out, freeCurve};
}

Curve decomposed(const Curve &curve) {
    SISLCurve *out = nullptr;
    int status = 0;
    s1730(curve.get(), &out, &status);
    require(status);
    return {out, freeCurve};
}

Curve reduced(const Curve &curve, double tolerance) {
    SISLCurve *out = nullptr;
    int status = 0;
    double eps[] = {tolerance, tolerance, tolerance, tolerance}, error[4];
    constexpr int fixed_ends = 1, open = 1, rounds = 10;
    s1940(curve.get(), eps, fixed_ends, fixed_ends, open, rounds, &out, error, &status);
    require(status);
    return {out, freeCurve};
}

Work unary(const Curve &curve, const std::function<Curve(const Curve &)> &operation) {
    return {[=] { operation(curve); }, [=] { return std::vector<SplineData>{data_of(operation(curve))}; }};
}

struct Common {
    std::unique_ptr<double, decltype(&free)> knots{nullptr, free}, points{nullptr, free};
    int count = 0, order = 0;
};

Common compatible(const std::vector<Curve> &curves) {
    std::vector<SISLCurve *> list;
    for (const Curve &curve : curves) {
        list.push_back(curve.get());
    }
    double *knots = nullptr, *points = nullptr;
    int status = 0;
    Common common;
    s1931(static_cast<int>(list.size()), list.data(), &knots, &points, &common.count, &common.order, &status);
    common.knots.reset(knots);
    common.points.reset(points);
    require(status);
    return common;
}

Work compatible_work(const Task &task) {
    std::vector<Curve> curves;
    for (const SplineData &data : task.inputs) {
        curves.push_back(make_homogeneous(data));
    }
    return {[=] { compatible(curves); },
            [=] {
                const Common common = compatible(curves);
                std::vector<SplineData> results;
                for (size_t i = 0; i < curves.size(); ++i) {
                    const auto offset = 4 * static_cast<size_t>(common.count) * i;
                    results.push_back(cartesian(common.order - 1, common.count, common.knots.get(),
                                                common.points.get() + offset));
                }
                return results;
            }};
}

Work prepare(const Task &task) {
    switch (task.operation) {
    case Operation::refine:
        return unary(make_curve(task.inputs[0]),
                     [knots = task.knots](const Curve &curve) { return refined(curve, knots); });
    case Operation::elevate:
        return unary(make_curve(task.inputs[0]), elevated);
    case Operation::decompose:
        return unary(make_curve(task.inputs[0]), decomposed);
    case Operation::remove:
        return unary(make_homogeneous(task.inputs[0]),
                     [tolerance = task.tolerance](const Curve &curve) { return reduced(curve, tolerance); });
    case Operation::compatible:
        return compatible_work(task);
    default:
        return {};
    }
}

} // namespace

int main(int argc, char **argv) {
    return bench::run(argc, argv, "SISL", prepare);
}
