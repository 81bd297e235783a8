/* SPDX-License-Identifier: MIT */
// The same spline again: from its own data in each of the ways to state them, with weights and without, in
// other forms.
#include "recorded/batteries/batteries.h"

#include <numeric>

namespace recorded {

namespace {

// The arguments of nurbs_create().
struct Data {
    explicit Data(const Subject &s) : weights(static_cast<size_t>(s.points)) {
        for (const AxisFacts &a : s.axis) {
            degrees.push_back(a.degree);
            counts.push_back(a.count);
            knots.insert(knots.end(), a.knots.begin(), a.knots.end());
            shorter.insert(shorter.end(), a.knots.begin() + 1, a.knots.end() - 1);
        }
        nurbs_weights(s.g, s.points, weights.data(), 0);
        for (int32_t k = 0; k < s.axes; ++k) {
            int32_t form = 0;
            nurbs_knot_form(s.g, k, &form);
            flags |= (form & NURBS_FORM_PERIODIC) != 0 ? NURBS_ON_AXIS(k, NURBS_PERIODIC) : 0;
        }
    }
    std::vector<int32_t> degrees;
    std::vector<int64_t> counts;
    std::vector<double> knots, shorter, weights;
    uint32_t flags = 0;
};

void from_knots(const Subject &s, const Data &data, const double *weights, uint32_t flags) {
    nurbs_create(s.axes, data.degrees.data(), data.counts.data(), data.knots.data(),
                 static_cast<int64_t>(data.knots.size()), s.dim, s.control.data(), 0, 0, weights, 0, flags,
                 unread);
    nurbs_create_short(s.axes, data.degrees.data(), data.counts.data(), data.shorter.data(),
                       static_cast<int64_t>(data.shorter.size()), s.dim, s.control.data(), 0, 0, weights, 0,
                       flags, unread);
    nurbs_create_bezier(s.axes, data.degrees.data(), s.dim, s.control.data(), 0, 0, weights, 0, unread);
}

// The distinct knots of all vectors, those outside the domain too.
void from_multiplicities(const Subject &s, const Data &data) {
    std::vector<int64_t> counts;
    std::vector<double> distinct;
    std::vector<int32_t> times;
    for (const AxisFacts &a : s.axis) {
        const size_t before = distinct.size();
        for (size_t i = 0; i < a.knots.size(); ++i) {
            if (i > 0 && a.knots[i] == a.knots[i - 1]) {
                ++times.back();
            } else {
                distinct.push_back(a.knots[i]);
                times.push_back(1);
            }
        }
        counts.push_back(static_cast<int64_t>(distinct.size() - before));
    }
    nurbs_create_multiplicities(s.axes, data.degrees.data(), data.counts.data(), counts.data(),
                                distinct.data(), times.data(), s.dim, s.control.data(), 0, 0,
                                data.weights.data(), 0, data.flags, unread);
}

// Weights of both signs.
void from_records(const Subject &s, const Data &data) {
    std::vector<double> records(static_cast<size_t>(s.points * (s.dim + 1)));
    if (nurbs_homogeneous_points(s.g, s.points, records.data(), 0, 0) != NURBS_OK) {
        return;
    }
    for (const int32_t sign : {1, -1}) {
        records[static_cast<size_t>(s.dim)] *= sign;
        Owned made;
        nurbs_create_homogeneous(s.axes, data.degrees.data(), data.counts.data(), data.knots.data(),
                                 static_cast<int64_t>(data.knots.size()), s.dim, records.data(), 0, 0,
                                 data.flags, made.place());
        if (made != nullptr) {
            nurbs_eval_derivs(made, 1, 4, s.params(4).data(), 0, 0, unread, 0, 0, 0);
            nurbs_insert_knot(made, 0, s.at(0, 0.4), 1, unread);
            nurbs_elevate(made, 0, 1, unread);
        }
    }
}

void power_basis(const Subject &s, const Data &data) {
    int64_t count = 0;
    if (nurbs_to_power(s.g, 0, nullptr, nullptr, nullptr, &count) != NURBS_OK) {
        return;
    }
    std::vector<double> coefficients(static_cast<size_t>(count)), breaks(data.knots.size());
    std::vector<int64_t> pieces(3);
    if (nurbs_to_power(s.g, count, coefficients.data(), breaks.data(), pieces.data(), unread) != NURBS_OK) {
        return;
    }
    const int64_t total = std::accumulate(pieces.begin(), pieces.end(), int64_t{s.axes});
    nurbs_create_power(s.axes, data.degrees.data(), pieces.data(), breaks.data(), total, s.dim,
                       coefficients.data(), 0, 0, s.rational ? NURBS_HOMOGENEOUS : 0, unread);
}

void hermite_form(const Subject &s) {
    int64_t count = 0;
    if (nurbs_to_hermite(s.g, 0, nullptr, nullptr, nullptr, &count) != NURBS_OK) {
        return;
    }
    std::vector<double> params(static_cast<size_t>(count)), places(static_cast<size_t>(count * s.dim)),
        tangents(places.size());
    nurbs_to_hermite(s.g, count, params.data(), places.data(), tangents.data(), unread);
    nurbs_create_hermite(count, params.data(), s.dim, places.data(), 0, 0, tangents.data(), 0, 0, unread);
    nurbs_curve_polyline(count, s.dim, places.data(), 0, 0, params.data(), 0, unread);
    nurbs_curve_polyline(count, s.dim, places.data(), 0, 0, nullptr, 0, unread);
}

void knot_vectors(const AxisFacts &a) {
    const auto knots = static_cast<int64_t>(a.knots.size());
    nurbs_knots_uniform(a.degree, a.count, a.lower, a.upper, knots, unread);
    nurbs_knots_open_uniform(a.degree, a.count, a.lower, a.upper, knots, unread);
    nurbs_knots_bezier(a.degree, 3, nullptr, 4 * a.degree + 2, unread);
    nurbs_knots_averaged(a.degree, a.count, a.knots.data(), knots, unread);
    nurbs_knots_periodic(a.degree, a.count - a.degree, a.knots.data() + a.degree, nullptr, knots, unread);
}

} // namespace

void call_conversions(const Subject &s) {
    const Data data(s);
    from_knots(s, data, data.weights.data(), data.flags);
    from_knots(s, data, nullptr, 0);
    from_multiplicities(s, data);
    from_records(s, data);
    nurbs_with_points(s.g, s.control.data(), 0, 0, nullptr, 0, unread);
    nurbs_with_points(s.g, s.control.data(), 0, 0, data.weights.data(), 0, unread);
    power_basis(s, data);
    hermite_form(s);
    for (const AxisFacts &a : s.axis) {
        knot_vectors(a);
    }
    nurbs_make_rational(s.g, unread);
    nurbs_to_homogeneous(s.g, unread);
    nurbs_from_homogeneous(s.g, unread);
    nurbs_normalize_weights(s.g, unread);
}

} // namespace recorded
