// SPDX-License-Identifier: MIT
#include "io/binary/spline_bytes.h"

#include "base/checked.h"

#include <algorithm>
#include <bit>

namespace nrb::io {

namespace {

constexpr uint64_t periodic_flag = 1;
constexpr size_t at_knots = 128;

// Where the parts of a spline begin, and its size.
struct Places {
    Places(size_t knots, size_t points, size_t weights) noexcept
        : at_points(at_knots + aligned(8 * knots)), at_weights(at_points + aligned(8 * points)),
          size(weights == 0 ? at_points + 8 * points : at_weights + 8 * weights) {
        if (weights == 0) {
            at_weights = 0;
        }
    }
    size_t at_points, at_weights, size;
};

Places places_of(const Spline &spline) noexcept {
    size_t knots = 0;
    for (const KnotVectorPtr &axis : spline.knot_vectors()) {
        knots += axis->knots().size();
    }
    return {knots, spline.points().size(), spline.weights().size()};
}

struct Axis {
    int64_t count;
    int degree;
    bool periodic;
};

// Makes the same checks as nurbs_create() does for its arguments.
Axis axis_from(ByteReader &reader, int k) {
    const int64_t count = reader.take_integer();
    const uint64_t word = reader.take(), flags = word >> 32;
    const auto degree = static_cast<int32_t>(static_cast<uint32_t>(word));
    check_degree(degree, k);
    check_count(degree, count, k);
    if (flags > periodic_flag) {
        fail(Status::flags, "flags[%d] = 0x%llx, expected 0 or 1", k, static_cast<unsigned long long>(flags));
    }
    return {count, degree, flags != 0};
}

// The axes of a spline. Three axes are stored, of which the unused ones are skipped.
std::vector<Axis> axes_from(ByteReader &reader, int axes) {
    check_axes(axes);
    reader.need(2 * uint64_t{max_axes});
    std::vector<Axis> found;
    found.reserve(static_cast<size_t>(axes));
    for (int k = 0; k < axes; ++k) {
        found.push_back(axis_from(reader, k));
    }
    for (int word = 2 * axes; word < 2 * max_axes; ++word) {
        static_cast<void>(reader.take());
    }
    return found;
}

Spline::Axes knots_from(ByteReader &reader, const std::vector<Axis> &axes) {
    Spline::Axes made;
    int64_t offset = 0;
    for (const Axis &axis : axes) {
        const int64_t size = checked_sum(axis.count, axis.degree + 1, "knots");
        made.push_back(make_knot_vector(axis.degree, reader.take_doubles(size), axis.periodic,
                                        static_cast<int>(std::ssize(made)), offset));
        offset += size;
    }
    return made;
}

int64_t point_count(const std::vector<Axis> &axes) {
    int64_t count = 1;
    for (const Axis &axis : axes) {
        count = checked_product(count, axis.count, "points");
    }
    return count;
}

Form form_from(int32_t form) {
    if (form < 0 || form > static_cast<int32_t>(Form::homogeneous)) {
        fail(Status::syntax, "form = %d, expected 0 to 2", form);
    }
    return static_cast<Form>(form);
}

bool same(std::span<const double> a, std::span<const double> b) noexcept {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
        return std::bit_cast<uint64_t>(x) == std::bit_cast<uint64_t>(y);
    });
}

} // namespace

size_t size_in_bytes(const Spline &spline) noexcept {
    return places_of(spline).size;
}

void write_bytes(const Spline &spline, std::span<unsigned char> out) noexcept {
    const Places places = places_of(spline);
    ByteWriter writer(Kind::spline, {spline.axes(), spline.dim(), static_cast<int32_t>(spline.form())}, out);
    for (int k = 0; k < max_axes; ++k) {
        const bool given = k < spline.axes();
        writer.put(given ? spline.count(k) : 0);
        writer.put(!given ? uint64_t{0}
                          : static_cast<uint64_t>(spline.axis(k).degree()) |
                                (spline.axis(k).periodic() ? periodic_flag << 32 : 0));
    }
    writer.put(uint64_t{places.at_points});
    writer.put(uint64_t{places.at_weights});
    for (const KnotVectorPtr &axis : spline.knot_vectors()) {
        writer.put(axis->knots());
    }
    writer.align();
    writer.put(spline.points());
    if (places.at_weights != 0) {
        writer.align();
        writer.put(spline.weights());
    }
    writer.finish();
}

SplinePtr spline_from(std::span<const unsigned char> bytes) {
    ByteReader reader(bytes, Kind::spline);
    const int axis_count = reader.numbers()[0], dim = reader.numbers()[1];
    const std::vector<Axis> axes = axes_from(reader, axis_count);
    check_dimension(dim);
    const Form form = form_from(reader.numbers()[2]);
    const int64_t at_points = reader.take_integer(), at_weights = reader.take_integer();
    const int64_t count = point_count(axes);
    Spline::Axes knots = knots_from(reader, axes);
    reader.align();
    reader.check_place(at_points, "points");
    const int64_t width = form == Form::homogeneous ? int64_t{dim} + 1 : dim;
    std::vector<double> points =
        reader.take_doubles(checked_product(count, width, "points"), Spline::padding);
    std::vector<double> weights;
    if (form == Form::rational) {
        reader.align();
        reader.check_place(at_weights, "weights");
        weights = reader.take_doubles(count);
    } else if (at_weights != 0) {
        fail(Status::syntax, "weights at byte %lld of a spline that has none",
             static_cast<long long>(at_weights));
    }
    reader.end();
    return make_spline(std::move(knots), dim, form, std::move(points), std::move(weights));
}

bool same_bytes(const Spline &a, const Spline &b) noexcept {
    if (a.axes() != b.axes() || a.dim() != b.dim() || a.form() != b.form()) {
        return false;
    }
    for (int k = 0; k < a.axes(); ++k) {
        const KnotVector &x = a.axis(k), &y = b.axis(k);
        if (x.degree() != y.degree() || x.periodic() != y.periodic() || !same(x.knots(), y.knots())) {
            return false;
        }
    }
    return same(a.points(), b.points()) && same(a.weights(), b.weights());
}

} // namespace nrb::io
