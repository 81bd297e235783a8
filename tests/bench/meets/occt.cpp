// SPDX-License-Identifier: MIT
// Meets of surfaces by Open CASCADE: GeomAPI_IntSS, curves in space alone.     bench_meets_occt PAIR TOLERANCE
#include "bench/meets/job.h"

#include <GeomAPI_IntSS.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Curve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <memory>

namespace {

using namespace bench::meets;

struct Knots {
    TColStd_Array1OfReal values;
    TColStd_Array1OfInteger multiplicities;
};
Knots knots_of(const std::vector<double> &knots) {
    const int distinct = static_cast<int>(knots.size()) - 2 * degree;
    Knots made{TColStd_Array1OfReal(1, distinct), TColStd_Array1OfInteger(1, distinct)};
    for (int i = 0; i < distinct; ++i) {
        made.values.SetValue(i + 1, knots[static_cast<size_t>(degree + i)]);
        made.multiplicities.SetValue(i + 1, i == 0 || i == distinct - 1 ? degree + 1 : 1);
    }
    return made;
}

Handle(Geom_BSplineSurface) surface_of(const Net &net) {
    TColgp_Array2OfPnt points(1, net.counts[0], 1, net.counts[1]);
    for (int i = 0; i < net.counts[0]; ++i) {
        for (int j = 0; j < net.counts[1]; ++j) {
            const Point &x = net.points[static_cast<size_t>(i * net.counts[1] + j)];
            points.SetValue(i + 1, j + 1, {x[0], x[1], x[2]});
        }
    }
    const Knots u = knots_of(net.knots[0]), v = knots_of(net.knots[1]);
    return new Geom_BSplineSurface(points, u.values, v.values, u.multiplicities, v.multiplicities, degree,
                                   degree);
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: bench_meets_occt PAIR TOLERANCE\n");
        return 2;
    }
    const Pair pair = pair_of(argv[1]);
    const double tolerance = std::atof(argv[2]);
    Handle(Geom_BSplineSurface) a, b;
    std::unique_ptr<GeomAPI_IntSS> meet;
    const auto prepare = [&] {
        meet = nullptr;
        a = surface_of(pair.a);
        b = surface_of(pair.b);
    };
    const double ms = milliseconds(prepare, [&] { meet = std::make_unique<GeomAPI_IntSS>(a, b, tolerance); });
    if (!meet->IsDone()) {
        std::fprintf(stderr, "GeomAPI_IntSS is not done\n");
        return 1;
    }
    Curves curves(pair);
    for (int i = 1; i <= meet->NbLines(); ++i) {
        const Handle(Geom_Curve) &line = meet->Line(i);
        const double first = line->FirstParameter(), last = line->LastParameter();
        curves.add([&](double share) {
            const gp_Pnt at = line->Value((1 - share) * first + share * last);
            return Point{at.X(), at.Y(), at.Z()};
        });
    }
    curves.tell(ms, -1);
    return 0;
}
