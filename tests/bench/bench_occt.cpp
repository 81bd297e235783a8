// Open CASCADE: the adaptors, which keep the polynomial of the last span, and the B-splines themselves.
#include "bench/harness.h"
#include "bench/quotient.h"

#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <memory>

namespace {

using namespace bench;
using support::SplineData;

struct Knots {
    TColStd_Array1OfReal values;
    TColStd_Array1OfInteger multiplicities;
};

// The ends occur degree + 1 times, the knots inside once.
Knots make_knots(const SplineData &data, size_t axis) {
    const int degree = data.degrees[axis], distinct = static_cast<int>(data.counts[axis]) - degree + 1;
    Knots result{TColStd_Array1OfReal(1, distinct), TColStd_Array1OfInteger(1, distinct)};
    for (int i = 0; i < distinct; ++i) {
        result.values.SetValue(i + 1, data.knots[axis][static_cast<size_t>(degree + i)]);
        result.multiplicities.SetValue(i + 1, i == 0 || i == distinct - 1 ? degree + 1 : 1);
    }
    return result;
}

gp_Pnt control_point(const SplineData &data, int64_t i) {
    return {data.coordinate(i, 0), data.coordinate(i, 1), data.coordinate(i, 2)};
}

Handle(Geom_BSplineCurve) make_curve(const SplineData &data) {
    const auto count = static_cast<int>(data.counts[0]);
    TColgp_Array1OfPnt points(1, count);
    TColStd_Array1OfReal weights(1, count);
    for (int i = 0; i < count; ++i) {
        points.SetValue(i + 1, control_point(data, i));
        weights.SetValue(i + 1, data.weight(i));
    }
    const Knots knots = make_knots(data, 0);
    return new Geom_BSplineCurve(points, weights, knots.values, knots.multiplicities, data.degrees[0]);
}

Handle(Geom_BSplineSurface) make_surface(const SplineData &data) {
    const auto rows = static_cast<int>(data.counts[0]), columns = static_cast<int>(data.counts[1]);
    TColgp_Array2OfPnt points(1, rows, 1, columns);
    TColStd_Array2OfReal weights(1, rows, 1, columns);
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j) {
            points.SetValue(i + 1, j + 1, control_point(data, i * columns + j));
            weights.SetValue(i + 1, j + 1, data.weight(i * columns + j));
        }
    }
    const Knots u = make_knots(data, 0), v = make_knots(data, 1);
    return new Geom_BSplineSurface(points, weights, u.values, v.values, u.multiplicities, v.multiplicities,
                                   data.degrees[0], data.degrees[1]);
}

void store(const gp_XYZ &vector, double *out) {
    out[0] = vector.X();
    out[1] = vector.Y();
    out[2] = vector.Z();
}

template <class Curve>
void evaluate(const Curve &curve, int order, double t, double *out) {
    gp_Pnt point;
    gp_Vec first, second;
    switch (order) {
    case 0:
        curve.D0(t, point);
        break;
    case 1:
        curve.D1(t, point, first);
        store(first.XYZ(), out + 3);
        break;
    default:
        curve.D2(t, point, first, second);
        store(first.XYZ(), out + 3);
        store(second.XYZ(), out + 6);
    }
    store(point.XYZ(), out);
}

template <class Surface>
void evaluate(const Surface &surface, int order, double u, double v, double *out) {
    gp_Pnt point;
    gp_Vec du, dv, duu, dvv, duv;
    switch (order) {
    case 0:
        surface.D0(u, v, point);
        break;
    case 1:
        surface.D1(u, v, point, du, dv);
        store(du.XYZ(), out + 3);
        store(dv.XYZ(), out + 6);
        break;
    default:
        surface.D2(u, v, point, du, dv, duu, dvv, duv);
        store(du.XYZ(), out + 3);
        store(dv.XYZ(), out + 6);
        store(duu.XYZ(), out + 9);
        store(duv.XYZ(), out + 12);
        store(dvv.XYZ(), out + 15);
    }
    store(point.XYZ(), out);
}

template <class Curve>
Work curve_points(std::shared_ptr<Curve> curve, const Job &job, const Case &data, Output &output) {
    return [curve, order = job.order, &data, &output] {
        double *out = output.values.data();
        for (const double t : data.params) {
            evaluate(*curve, order, t, out);
            out += 3 * (order + 1);
        }
    };
}

template <class Surface>
void surface_point(const Surface &surface, const Job &job, double u, double v, double *out) {
    evaluate(surface, job.order, u, v, out);
    if (job.normal) {
        unit_normal(out + 3, out + 6, out + 9);
    }
}

template <class Surface>
Work surface_points(std::shared_ptr<Surface> surface, const Job &job, const Case &data, Output &output) {
    return [surface, job, &data, &output] {
        double *out = output.values.data();
        for (size_t i = 0; i < data.params.size(); i += 2, out += 3 * job.vectors()) {
            surface_point(*surface, job, data.params[i], data.params[i + 1], out);
        }
    };
}

template <class Surface>
Work surface_grid(std::shared_ptr<Surface> surface, const Job &job, const Case &data, Output &output) {
    return [surface, job, &data, &output] {
        double *out = output.values.data();
        const double *u = data.params.data(), *v = u + data.grid[0];
        for (int64_t i = 0; i < data.grid[0]; ++i) {
            for (int64_t j = 0; j < data.grid[1]; ++j, out += 3 * job.vectors()) {
                surface_point(*surface, job, u[i], v[j], out);
            }
        }
    };
}

template <class Surface>
Work surface_work(std::shared_ptr<Surface> surface, const Job &job, const Case &data, Output &output) {
    return job.params == Params::grid ? surface_grid(surface, job, data, output)
                                      : surface_points(surface, job, data, output);
}

bool offers(const Job &job) {
    return job.group == Group::main && job.axes <= 2;
}

Work prepare_adaptor(const Job &job, const Case &data, Output &output) {
    if (job.axes == 1) {
        return curve_points(std::make_shared<GeomAdaptor_Curve>(make_curve(data.spline)), job, data, output);
    }
    return surface_work(std::make_shared<GeomAdaptor_Surface>(make_surface(data.spline)), job, data, output);
}

// The handle keeps the object, so the shared pointer does not delete it.
template <class T>
std::shared_ptr<T> shared(const opencascade::handle<T> &object) {
    return {object.get(), [object](T *) {}};
}

Work prepare_spline(const Job &job, const Case &data, Output &output) {
    if (job.axes == 1) {
        return curve_points(shared(make_curve(data.spline)), job, data, output);
    }
    return surface_work(shared(make_surface(data.spline)), job, data, output);
}

} // namespace

int main(int argc, char **argv) {
    return run(argc, argv, {{"adaptor", offers, prepare_adaptor}, {"Geom", offers, prepare_spline}},
               peer_tolerance);
}
