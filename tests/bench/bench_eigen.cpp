// Eigen's unsupported/Splines: polynomial curves, here in homogeneous space, of a degree known when compiled.
#include "bench/harness.h"
#include "bench/quotient.h"
#include "bench/rational.h"

#include <memory>
#include <unsupported/Eigen/Splines>

namespace {

using namespace bench;

template <int Degree>
using Curve = Eigen::Spline<double, 4, Degree>;

template <int Degree>
Curve<Degree> make_curve(const support::SplineData &data) {
    const std::vector<double> points = homogeneous(data);
    const auto count = static_cast<Eigen::Index>(data.counts[0]);
    using Knots = typename Curve<Degree>::KnotVectorType;
    using Points = typename Curve<Degree>::ControlPointVectorType;
    return {Knots(Eigen::Map<const Knots>(data.knots[0].data(), count + Degree + 1)),
            Points(Eigen::Map<const Points>(points.data(), 4, count))};
}

template <int Degree, int Order>
void evaluate(const Curve<Degree> &curve, double t, double *out) {
    if constexpr (Order == 0) {
        const Eigen::Array4d point = curve(t);
        divide<1, 0>(point.data(), out);
    } else {
        const Eigen::Array<double, 4, Order + 1> derivatives = curve.template derivatives<Order>(t);
        divide<1, Order>(derivatives.data(), out);
    }
}

template <int Degree, int Order>
Work points(const Case &data, Output &output) {
    return [curve = make_curve<Degree>(data.spline), &data, &output] {
        double *out = output.values.data();
        for (const double t : data.params) {
            evaluate<Degree, Order>(curve, t, out);
            out += 3 * (Order + 1);
        }
    };
}

bool offers(const Job &job) {
    return job.group == Group::main && job.axes == 1;
}

Work prepare(const Job &job, const Case &data, Output &output) {
    switch (10 * job.degree + job.order) {
    case 31:
        return points<3, 1>(data, output);
    case 32:
        return points<3, 2>(data, output);
    case 50:
        return points<5, 0>(data, output);
    case 90:
        return points<9, 0>(data, output);
    default:
        return points<3, 0>(data, output);
    }
}

} // namespace

int main(int argc, char **argv) {
    return run(argc, argv, {{BENCH_ROUTE, offers, prepare}}, peer_tolerance);
}
