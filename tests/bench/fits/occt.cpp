// SPDX-License-Identifier: MIT
// Fits by Open CASCADE: GeomAPI_Interpolate, GeomAPI_PointsToBSplineSurface and GeomAPI_PointsToBSpline, which takes the
// data with parameters of its own.     bench_fits_occt FOLDER JOB
#include "bench/fits/job.h"

#include <GeomAPI_Interpolate.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>

#include <cmath>
#include <map>

namespace {

using namespace bench::fits;

gp_Pnt point(const std::vector<double> &values, size_t i) {
    return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

void curve(const std::string &folder, const std::string &name) {
    const std::vector<double> values = read(folder, name);
    const auto count = static_cast<int>(values.size() / 3);
    Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, count);
    for (int i = 0; i < count; ++i) {
        points->SetValue(i + 1, point(values, static_cast<size_t>(i)));
    }
    tell(milliseconds([&] {
             GeomAPI_Interpolate made(points, Standard_False, 1e-12);
             made.Perform();
             if (!made.IsDone()) {
                 std::exit(1);
             }
         }),
         count);
}

void surface(const std::string &folder, const std::string &name, int count) {
    const std::vector<double> values = read(folder, name);
    TColgp_Array2OfPnt points(1, count, 1, count);
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) {
            points.SetValue(i + 1, j + 1, point(values, static_cast<size_t>(i * count + j)));
        }
    }
    tell(milliseconds([&] {
             GeomAPI_PointsToBSplineSurface made;
             made.Interpolate(points, Approx_ChordLength);
             if (!made.IsDone()) {
                 std::exit(1);
             }
         }),
         int64_t{count} * count);
}

void tolerance(const std::string &folder, const std::string &name, double within) {
    const std::vector<double> values = read(folder, name + "_values"), given = read(folder, name + "_params");
    const auto n = static_cast<int>(given.size());
    TColgp_Array1OfPnt points(1, n);
    TColStd_Array1OfReal params(1, n);
    for (int i = 0; i < n; ++i) {
        points.SetValue(i + 1, point(values, static_cast<size_t>(i)));
        params.SetValue(i + 1, given[static_cast<size_t>(i)]);
    }
    Handle(Geom_BSplineCurve) made;
    const double ms = milliseconds([&] {
        GeomAPI_PointsToBSpline fit(points, params, 3, 3, GeomAbs_C2, within);
        if (!fit.IsDone()) {
            std::exit(1);
        }
        made = fit.Curve();
    });
    tell(ms, made->NbPoles(), largest_distance(given, values, [&](double t, double *at) {
             const gp_Pnt found = made->Value(t);
             at[0] = found.X(), at[1] = found.Y(), at[2] = found.Z();
         }));
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: bench_fits_occt FOLDER JOB\n");
        return 2;
    }
    const std::string folder = argv[1], job = argv[2];
    const std::map<std::string, std::function<void()>> jobs{
        {"curve_1e3", [&] { curve(folder, "spiral_1000"); }},
        {"curve_1e5", [&] { curve(folder, "spiral_100000"); }},
        {"surface_100", [&] { surface(folder, "heights_100", 100); }},
        {"tolerance_1e5", [&] { tolerance(folder, "flower_100000", 1e-4); }},
    };
    const auto found = jobs.find(job);
    if (found == jobs.end()) {
        return 77;
    }
    try {
        found->second();
    } catch (const Standard_Failure &failure) {
        std::fprintf(stderr, "Open CASCADE: %s\n", failure.GetMessageString());
        return 1;
    }
    return 0;
}
