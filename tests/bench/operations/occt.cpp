// Open CASCADE: Geom_BSplineCurve, GeomConvert_BSplineCurveToBezierCurve, GeomFill_Profiler; for shapes
// GeomConvert of Geom_Circle and Geom_SurfaceOfRevolution, GeomFill::Surface, GeomFill_BSplineCurves.
#include "bench/operations/task.h"

#include <GeomConvert.hxx>
#include <GeomConvert_BSplineCurveToBezierCurve.hxx>
#include <GeomFill.hxx>
#include <GeomFill_BSplineCurves.hxx>
#include <GeomFill_Profiler.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <gp_Ax2.hxx>

namespace {

using namespace bench;
using support::SplineData;
using Curve = Handle(Geom_BSplineCurve);
using Surface = Handle(Geom_BSplineSurface);
constexpr double same_knot = 1e-15; // tolerance for knots that are one

struct Knots {
    std::vector<double> values;
    std::vector<int> multiplicities;
};

Knots distinct(const std::vector<double> &knots) {
    Knots result;
    for (const double knot : knots) {
        if (result.values.empty() || result.values.back() != knot) {
            result.values.push_back(knot);
            result.multiplicities.push_back(0);
        }
        ++result.multiplicities.back();
    }
    return result;
}

Curve make_curve(const SplineData &data) {
    const auto count = static_cast<int>(data.counts[0]);
    TColgp_Array1OfPnt points(1, count);
    TColStd_Array1OfReal weights(1, count);
    for (int i = 0; i < count; ++i) {
        points.SetValue(i + 1, {data.coordinate(i, 0), data.coordinate(i, 1), data.coordinate(i, 2)});
        weights.SetValue(i + 1, data.weight(i));
    }
    const Knots knots = distinct(data.knots[0]);
    const auto size = static_cast<int>(knots.values.size());
    return new Geom_BSplineCurve(points, weights, TColStd_Array1OfReal(knots.values[0], 1, size),
                                 TColStd_Array1OfInteger(knots.multiplicities[0], 1, size), data.degrees[0]);
}

SplineData data_of(int degree, const std::vector<double> &knots, const TColgp_Array1OfPnt &points,
                   const TColStd_Array1OfReal *weights) {
    SplineData data{.degrees = {degree},
                    .counts = {points.Size()},
                    .knots = {knots},
                    .dim = 3,
                    .points = {},
                    .weights = {}};
    for (int i = points.Lower(); i <= points.Upper(); ++i) {
        data.points.insert(data.points.end(), {points(i).X(), points(i).Y(), points(i).Z()});
        data.weights.push_back(weights != nullptr ? weights->Value(i) : 1);
    }
    return data;
}

std::vector<double> flat(const TColStd_Array1OfReal &knots, const TColStd_Array1OfInteger &multiplicities) {
    std::vector<double> result;
    for (int i = knots.Lower(); i <= knots.Upper(); ++i) {
        result.insert(result.end(), static_cast<size_t>(multiplicities(i)), knots(i));
    }
    return result;
}

SplineData data_of(const Curve &curve) {
    return data_of(curve->Degree(), flat(curve->Knots(), curve->Multiplicities()), curve->Poles(),
                   curve->Weights());
}

Work unary(const Task &task, const std::function<void(const Curve &)> &change) {
    const Curve curve = make_curve(task.inputs[0]);
    const auto changed = [=] {
        const Curve copy = Curve::DownCast(curve->Copy());
        change(copy);
        return copy;
    };
    return {[=] { changed(); }, [=] { return std::vector<SplineData>{data_of(changed())}; }};
}

void insert(const Curve &curve, const std::vector<double> &knots) {
    const auto size = static_cast<int>(knots.size());
    const TColStd_Array1OfReal values(knots[0], 1, size);
    TColStd_Array1OfInteger once(1, size);
    once.Init(1);
    curve->InsertKnots(values, once, same_knot);
}

// From the last to the first, so that the indices of the others stay.
void remove(const Curve &curve, const std::vector<double> &knots, double tolerance) {
    size_t left = knots.size();
    for (int i = curve->NbKnots() - 1; i > 1 && left > 0; --i) {
        if (curve->Knot(i) == knots[left - 1]) {
            curve->RemoveKnot(i, 0, tolerance);
            --left;
        }
    }
}

Work decompose_work(const Task &task) {
    const Curve curve = make_curve(task.inputs[0]);
    const auto each = [](const Curve &whole, const auto &take) {
        GeomConvert_BSplineCurveToBezierCurve converter(whole);
        for (int i = 1; i <= converter.NbArcs(); ++i) {
            take(converter.Arc(i), i);
        }
    };
    return {[=] { each(curve, [](const Handle(Geom_BezierCurve) &, int) {}); },
            [=] {
                std::vector<SplineData> results;
                each(curve, [&](const Handle(Geom_BezierCurve) & arc, int i) {
                    const double lower = curve->Knot(i), upper = curve->Knot(i + 1);
                    std::vector<double> knots(static_cast<size_t>(arc->Degree()) + 1, lower);
                    knots.insert(knots.end(), knots.size(), upper);
                    TColgp_Array1OfPnt points(1, arc->NbPoles());
                    TColStd_Array1OfReal weights(1, arc->NbPoles());
                    arc->Poles(points);
                    arc->Weights(weights);
                    results.push_back(data_of(arc->Degree(), knots, points, &weights));
                });
                return results;
            }};
}

void make_compatible(GeomFill_Profiler &profiler, const std::vector<Curve> &curves) {
    for (const Curve &curve : curves) {
        profiler.AddCurve(curve);
    }
    profiler.Perform(same_knot);
}

Work compatible_work(const Task &task) {
    std::vector<Curve> curves;
    for (const SplineData &data : task.inputs) {
        curves.push_back(make_curve(data));
    }
    return {[=] {
                GeomFill_Profiler profiler;
                make_compatible(profiler, curves);
            },
            [=] {
                GeomFill_Profiler profiler;
                make_compatible(profiler, curves);
                TColStd_Array1OfReal knots(1, profiler.NbKnots());
                TColStd_Array1OfInteger multiplicities(1, profiler.NbKnots());
                profiler.KnotsAndMults(knots, multiplicities);
                std::vector<SplineData> results;
                for (int i = 1; i <= static_cast<int>(curves.size()); ++i) {
                    TColgp_Array1OfPnt points(1, profiler.NbPoles());
                    TColStd_Array1OfReal weights(1, profiler.NbPoles());
                    profiler.Poles(i, points);
                    profiler.Weights(i, weights);
                    results.push_back(
                        data_of(profiler.Degree(), flat(knots, multiplicities), points, &weights));
                }
                return results;
            }};
}

SplineData data_of(const Surface &surface) {
    surface->SetUNotPeriodic();
    SplineData data{.degrees = {surface->UDegree(), surface->VDegree()},
                    .counts = {surface->NbUPoles(), surface->NbVPoles()},
                    .knots = {flat(surface->UKnots(), surface->UMultiplicities()),
                              flat(surface->VKnots(), surface->VMultiplicities())},
                    .dim = 3,
                    .points = {},
                    .weights = {}};
    for (int i = 1; i <= surface->NbUPoles(); ++i) {
        for (int j = 1; j <= surface->NbVPoles(); ++j) {
            const gp_Pnt pole = surface->Pole(i, j);
            data.points.insert(data.points.end(), {pole.X(), pole.Y(), pole.Z()});
            data.weights.push_back(surface->Weight(i, j));
        }
    }
    return data;
}

Work making(const std::function<Surface()> &make) {
    return {[=] { make(); }, [=] { return std::vector<SplineData>{data_of(make())}; }};
}

Work circle_work() {
    const auto make = [] {
        const gp_Ax2 axes({circle_center[0], circle_center[1], circle_center[2]}, {0, 0, 1}, {1, 0, 0});
        return GeomConvert::CurveToBSplineCurve(new Geom_Circle(axes, circle_radius));
    };
    return {[=] { make(); },
            [=] {
                const Curve curve = make();
                curve->SetNotPeriodic();
                return std::vector<SplineData>{data_of(curve)};
            }};
}

Work make_work(const Task &task) {
    std::vector<Curve> curves;
    for (const SplineData &data : task.inputs) {
        curves.push_back(make_curve(data));
    }
    switch (task.operation) {
    case Operation::circle:
        return circle_work();
    case Operation::revolve:
        return making([=] {
            const gp_Ax1 axis({0, 0, 0}, {0, 0, 1});
            return GeomConvert::SurfaceToBSplineSurface(new Geom_SurfaceOfRevolution(curves[0], axis));
        });
    case Operation::ruled:
        return making([=] { return Surface::DownCast(GeomFill::Surface(curves[0], curves[1])); });
    case Operation::coons: // around the surface; Coons' rule is the style that is called after stretching
        return making([=] {
            return GeomFill_BSplineCurves(curves[2], curves[1], curves[3], curves[0], GeomFill_StretchStyle)
                .Surface();
        });
    default:
        return {};
    }
}

Work prepare(const Task &task) {
    switch (task.operation) {
    case Operation::refine:
        return unary(task, [knots = task.knots](const Curve &curve) { insert(curve, knots); });
    case Operation::elevate:
        return unary(task, [](const Curve &curve) { curve->IncreaseDegree(curve->Degree() + 1); });
    case Operation::decompose:
        return decompose_work(task);
    case Operation::remove:
        return unary(task, [knots = task.knots, tolerance = task.tolerance](const Curve &curve) {
            remove(curve, knots, tolerance);
        });
    case Operation::compatible:
        return compatible_work(task);
    default:
        return make_work(task);
    }
}

} // namespace

int main(int argc, char **argv) {
    return bench::run(argc, argv, "Open CASCADE", prepare);
}
