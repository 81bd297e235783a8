// SPDX-License-Identifier: MIT
#include "refine/forms/hermite.h"

#include "base/representable.h"
#include "refine/parts/cut.h"

#include <algorithm>
#include <cmath>

namespace nrb::refine {

namespace {

void check_cubic(const Spline &curve) {
    if (curve.rational()) {
        fail(Status::rational, "g is rational, expected a polynomial curve");
    }
    const int degree = curve.axis(0).degree();
    if (degree > 3) {
        fail(Status::degree, "degree %d of g, expected at most 3", degree);
    }
}

void check_smooth(const KnotVector &axis) {
    const std::vector<double> breaks = rough_knots(axis, 1);
    if (breaks.size() > 2) {
        fail(Status::continuity, "knot %s occurs %d times, expected at most %d times in a curve of degree %d",
             Number(breaks[1]).text, multiplicity(axis.knots(), breaks[1]), std::max(axis.degree() - 1, 0),
             axis.degree());
    }
}

void add_record(const Spline &net, int64_t layer, std::vector<double> &records) {
    const auto first = net.points().begin() + layer * net.dim();
    records.insert(records.end(), first, first + net.dim());
}

// degree (b - a) / h, where degree (b - a) may overflow.
double slope(double a, double b, int degree, double h) noexcept {
    const double leg = degree * (b - a);
    return std::isfinite(leg) ? leg / h : 8 * (degree * (b / 8 - a / 8) / h);
}

// Appends the derivative of a Bezier piece along the leg from a layer to the next one.
void add_slope(const Spline &net, int64_t layer, double h, std::vector<double> &slopes) {
    const int degree = net.axis(0).degree(), dim = net.dim();
    for (int64_t at = layer * dim; at < (layer + 1) * dim; ++at) {
        const auto value = [&](int64_t i) { return net.points()[static_cast<size_t>(i)]; };
        slopes.push_back(degree == 0 ? 0.0 : slope(value(at), value(at + dim), degree, h));
    }
}

} // namespace

HermiteData hermite_data(const SplinePtr &curve) {
    check_cubic(*curve);
    check_smooth(curve->axis(0));
    const PartedSpline pieces = bezier_pieces(curve);
    const Spline &whole = pieces.whole();
    const KnotVector &axis = whole.axis(0);
    const int64_t layers = axis.degree() + 1, spans = pieces.parts(0);
    const auto span_length = [&axis, layers](int64_t e) { return axis[(e + 1) * layers] - axis[e * layers]; };
    HermiteData data;
    for (int64_t i = 0; i <= spans; ++i) {
        const bool above = i == 0 || (i < spans && span_length(i) > span_length(i - 1));
        const double h = span_length(above ? i : i - 1);
        data.params.push_back(axis[i * layers]);
        add_record(whole, i * layers - (i == spans ? 1 : 0), data.points);
        add_slope(whole, i * layers - (above ? 0 : 2), h, data.tangents);
    }
    require_representable(data.tangents, "tangent");
    return data;
}

} // namespace nrb::refine
