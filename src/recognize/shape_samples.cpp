// SPDX-License-Identifier: MIT
#include "recognize/shape_samples.h"

#include "eval/evaluate.h"
#include "refine/knots/bezier_rows.h"

#include <algorithm>
#include <cmath>

namespace nrb::recognize {

namespace {

using Params = std::vector<double>;

bool finite(const Vector3 &p) noexcept {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

ConstRecords list(const Params &params) noexcept {
    return {params.data(), std::ssize(params), 1, 1, 1};
}

// Values and derivatives up to an order on the grid of parameters; for a curve, at the parameters of the
// first list.
std::vector<double> values_at(const Spline &spline, int order, const Params &u, const Params &v) {
    const bool curve = spline.axes() == 1;
    const int64_t width = int64_t{spline.dim()} * (order == 0 ? 1 : curve ? 2 : 3);
    const int64_t count = std::ssize(u) * (curve ? 1 : std::ssize(v));
    std::vector<double> values(static_cast<size_t>(count * width));
    const Records out{values.data(), count, width, width, 1};
    if (curve) {
        eval::evaluate_points(spline, {}, order, list(u), out);
    } else {
        eval::evaluate_grid(spline, {}, order, {list(u), list(v), {}}, out);
    }
    return values;
}

Params evenly(Interval domain, int count) {
    Params params;
    for (int i = 0; i < count; ++i) {
        const double s = static_cast<double>(i) / (count - 1);
        params.push_back((1 - s) * domain.lower + s * domain.upper);
    }
    params.back() = domain.upper;
    return params;
}

// At most `most` breaks of an axis. If there are few breaks, parameters inside their spans are added, since
// the chord of a whole span is meaningless if the span is closed.
Params some_breaks(const KnotVector &axis, size_t most) {
    const Params all = refine::breaks_of(axis);
    Params some;
    if (all.size() <= most) {
        const int parts = all.size() < 8 ? 5 : 1;
        for (size_t i = 0; i + 1 < all.size(); ++i) {
            const Params inner = evenly({all[i], all[i + 1]}, parts + 1);
            some.insert(some.end(), inner.begin(), inner.end() - 1);
        }
        some.push_back(all.back());
        return some;
    }
    for (size_t i = 0; i < most; ++i) {
        some.push_back(all[i * (all.size() - 1) / (most - 1)]);
    }
    return some;
}

// The longest chord from each parameter of an axis to the next, over a few parameters of the other axis.
std::vector<double> chords(const Spline &spline, int axis, const Params &params) {
    const bool curve = spline.axes() == 1;
    const Params others = curve ? Params{0} : evenly(spline.axis(1 - axis).domain(), 5);
    const auto values =
        axis == 0 ? values_at(spline, 0, params, others) : values_at(spline, 0, others, params);
    const size_t dim = static_cast<size_t>(spline.dim()), rows = params.size(), across = others.size();
    const size_t step = (axis == 0 ? across : 1) * dim, other = (axis == 0 ? 1 : rows) * dim;
    std::vector<double> lengths(rows - 1, 0.0);
    for (size_t i = 0; i + 1 < rows; ++i) {
        for (size_t j = 0; j < across; ++j) {
            const double *p = values.data() + i * step + j * other;
            const double chord = length(vector_of(p + step, spline.dim()) - vector_of(p, spline.dim()));
            lengths[i] = std::isfinite(chord) ? std::max(lengths[i], chord) : lengths[i];
        }
    }
    return lengths;
}

// About `wanted` parameters at even distances: intervals are halved until no chord is much longer than its
// share.
Params spread(const Spline &spline, int axis, size_t wanted) {
    Params params = some_breaks(spline.axis(axis), wanted);
    for (int round = 0; round < 40 && params.size() < 2 * wanted; ++round) {
        const std::vector<double> lengths = chords(spline, axis, params);
        double total = 0;
        for (const double length : lengths) {
            total += length;
        }
        Params finer;
        for (size_t i = 0; i + 1 < params.size(); ++i) {
            const double middle = params[i] / 2 + params[i + 1] / 2;
            finer.push_back(params[i]);
            if (lengths[i] * static_cast<double>(wanted) > 1.5 * total && middle > params[i]) {
                finer.push_back(middle);
            }
        }
        finer.push_back(params.back());
        if (finer.size() == params.size()) {
            break;
        }
        params = std::move(finer);
    }
    return params;
}

void centre(ShapeSamples &samples) {
    Vector3 low = samples.points.front(), high = low;
    for (const Vector3 &p : samples.points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    samples.centre = {low.x / 2 + high.x / 2, low.y / 2 + high.y / 2, low.z / 2 + high.z / 2};
    samples.size = length(0.5 * (high - low));
    for (Vector3 &p : samples.points) {
        p = p - samples.centre;
    }
    for (Vector3 &p : samples.feet) {
        p = p - samples.centre;
    }
}

// The difference of the parameters next to the one with an index.
double spacing(const Params &params, size_t i) noexcept {
    return params[std::min(i + 1, params.size() - 1)] - params[i == 0 ? 0 : i - 1];
}

// Samples points, and normals where the surface is regular. Near a pole, one of the derivatives is no more
// than rounding, and no normal is taken.
void sample_surface(const Spline &spline, ShapeSamples &samples) {
    const Params u = spread(spline, 0, 12), v = spread(spline, 1, 12);
    const std::vector<double> values = values_at(spline, 1, u, v);
    const int dim = spline.dim();
    const double *record = values.data();
    std::vector<std::pair<Vector3, Vector3>> steps;
    double longest = 0;
    for (size_t i = 0; i < u.size(); ++i) {
        for (size_t j = 0; j < v.size(); ++j, record += int64_t{3} * dim) {
            const Vector3 p = vector_of(record, dim);
            const Vector3 a = spacing(u, i) * vector_of(record + dim, dim);
            const Vector3 b = spacing(v, j) * vector_of(record + 2 * int64_t{dim}, dim);
            if (!finite(p)) {
                continue;
            }
            samples.points.push_back(p);
            const bool regular = finite(a) && finite(b);
            steps.emplace_back(regular ? a : Vector3{}, regular ? b : Vector3{});
            longest = std::max({longest, length(steps.back().first), length(steps.back().second)});
        }
    }
    for (size_t i = 0; i < steps.size(); ++i) {
        const auto &[a, b] = steps[i];
        samples.along = samples.along + a;
        const Vector3 normal = cross(a, b);
        if (length(normal) > 1e-4 * length(a) * length(b) && length(a) > 1e-5 * longest &&
            length(b) > 1e-5 * longest) {
            samples.feet.push_back(samples.points[i]);
            samples.normals.push_back(unit(normal));
        }
    }
}

void sample_curve(const Spline &spline, ShapeSamples &samples) {
    const std::vector<double> values = values_at(spline, 0, spread(spline, 0, 40), {});
    const auto dim = static_cast<size_t>(spline.dim());
    for (size_t i = 0; i < values.size(); i += dim) {
        const Vector3 p = vector_of(values.data() + i, spline.dim());
        if (finite(p)) {
            samples.points.push_back(p);
        }
    }
}

} // namespace

ShapeSamples shape_samples(const Spline &spline) {
    ShapeSamples samples;
    spline.axes() == 1 ? sample_curve(spline, samples) : sample_surface(spline, samples);
    if (!samples.points.empty()) {
        centre(samples);
    }
    return samples;
}

} // namespace nrb::recognize
