// Open CASCADE: GeomAPI_ProjectPointOnCurve and ..OnSurf, prepared once, and GCPnts_AbscissaPoint. They look
// for perpendiculars only; the thorough way adds ends of curves, and edges and corners of surfaces. For
// lengths it is the one with a tolerance.
#include "bench/queries/question.h"

#include <GCPnts_AbscissaPoint.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <array>
#include <deque>
#include <limits>
#include <memory>

namespace {

using namespace bench;
using support::SplineData;
using Curve = Handle(Geom_BSplineCurve);
using Surface = Handle(Geom_BSplineSurface);
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

// Clamped, and simple inside.
struct Knots {
    TColStd_Array1OfReal values;
    TColStd_Array1OfInteger multiplicities;
    explicit Knots(const std::vector<double> &knots, int degree)
        : values(1, static_cast<int>(knots.size()) - 2 * degree), multiplicities(1, values.Upper()) {
        multiplicities.Init(1);
        multiplicities(1) = multiplicities(values.Upper()) = degree + 1;
        for (int i = 1; i <= values.Upper(); ++i) {
            values(i) = knots[static_cast<size_t>(degree + i - 1)];
        }
    }
};

gp_Pnt point_of(const SplineData &data, int i) {
    return {data.coordinate(i, 0), data.coordinate(i, 1), data.coordinate(i, 2)};
}

Curve make_curve(const SplineData &data) {
    const auto count = static_cast<int>(data.counts[0]);
    TColgp_Array1OfPnt points(1, count);
    TColStd_Array1OfReal weights(1, count);
    for (int i = 0; i < count; ++i) {
        points.SetValue(i + 1, point_of(data, i));
        weights.SetValue(i + 1, data.weight(i));
    }
    const Knots knots(data.knots[0], data.degrees[0]);
    return new Geom_BSplineCurve(points, weights, knots.values, knots.multiplicities, data.degrees[0]);
}

Surface make_surface(const SplineData &data) {
    const auto rows = static_cast<int>(data.counts[0]), columns = static_cast<int>(data.counts[1]);
    TColgp_Array2OfPnt points(1, rows, 1, columns);
    TColStd_Array2OfReal weights(1, rows, 1, columns);
    for (int i = 0; i < rows * columns; ++i) {
        points.SetValue(i / columns + 1, i % columns + 1, point_of(data, i));
        weights.SetValue(i / columns + 1, i % columns + 1, data.weight(i));
    }
    const Knots u(data.knots[0], data.degrees[0]), v(data.knots[1], data.degrees[1]);
    return new Geom_BSplineSurface(points, weights, u.values, v.values, u.multiplicities, v.multiplicities,
                                   data.degrees[0], data.degrees[1]);
}

// The best place of several.
template <class Place>
struct Best {
    Place place;
    double distance = infinity;
    void offer(const Place &other, double d) {
        if (d < distance) {
            place = other;
            distance = d;
        }
    }
};

// A curve to project onto, with its ends if they count.
class Projector {
public:
    Projector(const Projector &) = delete; // the projection points into itself
    Projector &operator=(const Projector &) = delete;
    Projector(const Curve &curve, bool ends) : curve_(curve), ends_(ends) {
        projection_.Init(curve, curve->FirstParameter(), curve->LastParameter());
    }
    Best<double> nearest(const gp_Pnt &point) {
        Best<double> best{none};
        projection_.Perform(point);
        if (projection_.NbPoints() > 0) {
            best.offer(projection_.LowerDistanceParameter(), projection_.LowerDistance());
        }
        if (ends_) {
            for (const double end : {curve_->FirstParameter(), curve_->LastParameter()}) {
                best.offer(end, curve_->Value(end).Distance(point));
            }
        }
        return best;
    }

private:
    Curve curve_;
    bool ends_;
    GeomAPI_ProjectPointOnCurve projection_;
};

// A surface to project onto, with its edges if they count.
class SheetProjector {
public:
    using Place = std::array<double, 2>;
    SheetProjector(const Surface &surface, bool edges) {
        projection_.Init(surface, 0.0, 1.0, 0.0, 1.0);
        for (int edge = 0; edges && edge < 4; ++edge) {
            const double at = edge % 2;
            const Handle(Geom_Curve) iso = edge < 2 ? surface->UIso(at) : surface->VIso(at);
            edges_.emplace_back(Curve::DownCast(iso), true);
        }
    }
    Best<Place> nearest(const gp_Pnt &point) {
        Best<Place> best{{none, none}};
        projection_.Perform(point);
        if (projection_.NbPoints() > 0) {
            Place place;
            projection_.LowerDistanceParameters(place[0], place[1]);
            best.offer(place, projection_.LowerDistance());
        }
        for (size_t edge = 0; edge < edges_.size(); ++edge) {
            const Best<double> on = edges_[edge].nearest(point);
            const double at = static_cast<double>(edge % 2);
            best.offer(edge < 2 ? Place{at, on.place} : Place{on.place, at}, on.distance);
        }
        return best;
    }

private:
    GeomAPI_ProjectPointOnSurf projection_;
    std::deque<Projector> edges_;
};

template <class F>
Ask each(const Question &question, F &&answer) {
    return [points = question.points, answer] {
        std::vector<double> params;
        for (size_t i = 0; i < points.size(); i += 3) {
            answer(gp_Pnt(points[i], points[i + 1], points[i + 2]), params);
        }
        return params;
    };
}

Ask length(const Question &question, bool thorough) {
    const auto curve = std::make_shared<GeomAdaptor_Curve>(make_curve(question.shape));
    const double tolerance = question.tolerance * GCPnts_AbscissaPoint::Length(*curve);
    return [=] {
        return std::vector{thorough ? GCPnts_AbscissaPoint::Length(*curve, tolerance)
                                    : GCPnts_AbscissaPoint::Length(*curve)};
    };
}

Ask prepare(const Question &question, bool thorough) {
    if (question.kind == Kind::length) {
        return length(question, thorough);
    }
    if (question.shape.axes() == 2) {
        const auto sheet = std::make_shared<SheetProjector>(make_surface(question.shape), thorough);
        return each(question, [sheet](const gp_Pnt &point, auto &params) {
            const auto best = sheet->nearest(point);
            params.insert(params.end(), best.place.begin(), best.place.end());
        });
    }
    const auto curve = std::make_shared<Projector>(make_curve(question.shape), thorough);
    return each(question, [curve](const gp_Pnt &point, auto &params) {
        params.push_back(curve->nearest(point).place);
    });
}

} // namespace

int main(int argc, char **argv) {
    return bench::run(
        argc, argv,
        {{"Open CASCADE", [](const Question &question) { return prepare(question, false); }},
         {"Open CASCADE, thorough", [](const Question &question) { return prepare(question, true); }}});
}
