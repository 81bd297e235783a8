// SPDX-License-Identifier: MIT
#include "base/limits.h"
#include "base/numbers.h"
#include "io/iges/geometry/spline.h"

#include "base/checked.h"

namespace nrb::io::iges {
namespace {

SplineData::Axis make_axis(int64_t upper_index, int64_t degree, int axis, const Record &record) {
    constexpr int64_t highest = max_degree;
    if (upper_index < 0 || upper_index >= record.remaining()) {
        fail(Status::count,
             "upper index %lld of the control points where the record has %lld more parameters",
             static_cast<long long>(upper_index), static_cast<long long>(record.remaining()));
    }
    if (degree < 0 || degree > highest) {
        fail(Status::degree, "degree %lld not in [0, %lld]", static_cast<long long>(degree),
             static_cast<long long>(highest));
    }
    SplineData::Axis result;
    result.degree = static_cast<int>(degree);
    result.count = upper_index + 1;
    check_count(result.degree, result.count, axis);
    return result;
}

// Requires that `needed` parameters follow; those after them may be omitted.
void require(int64_t needed, const Record &record) {
    if (needed > record.remaining()) {
        fail(Status::syntax, "knots, weights and points need %lld parameters, the record has %lld more",
             static_cast<long long>(needed), static_cast<long long>(record.remaining()));
    }
}

void read_knots(Record &record, SplineData::Axis &axis, const char *name) {
    axis.knots.resize(static_cast<size_t>(axis.count + axis.degree + 1));
    for (size_t i = 0; i < axis.knots.size(); ++i) {
        axis.knots[i] = record.real(name, static_cast<int64_t>(i));
    }
}

// The parameter range of one axis. An omitted end is that of the domain. If both ends are equal, nobody
// filled them in, and the range is the whole domain.
void read_range(Record &record, SplineData::Axis &axis, const char *name) {
    const bool lower_blank = record.next_is_blank();
    const double lower = record.real(name, 0);
    const bool upper_blank = record.next_is_blank();
    const double upper = record.real(name, 1);
    axis.lower = lower_blank ? -infinity : lower;
    axis.upper = upper_blank ? infinity : upper;
    axis.whole = axis.lower == axis.upper;
}

// In IGES the first index varies fastest, in this library the last: entry (i, j) of counts (m, n) is at j * m
// + i in the file and goes to i * n + j.
template <class Read>
void for_each_in_file_order(const SplineData &data, Read &&read) {
    const int64_t m = data.axes.front().count;
    const int64_t n = data.axes.size() == 2 ? data.axes.back().count : 1;
    for (int64_t j = 0; j < n; ++j) {
        for (int64_t i = 0; i < m; ++i) {
            read(i * n + j);
        }
    }
}

void read_weights(Record &record, SplineData &data, int64_t point_count) {
    data.weights.resize(static_cast<size_t>(point_count));
    int64_t place = 0;
    for_each_in_file_order(
        data, [&](int64_t i) { data.weights[static_cast<size_t>(i)] = record.real("weights", place++); });
}

void read_points(Record &record, SplineData &data, int64_t point_count) {
    data.points.resize(static_cast<size_t>(3 * point_count));
    int64_t place = 0;
    for_each_in_file_order(data, [&](int64_t i) {
        for (size_t c = 0; c < 3; ++c) {
            data.points[static_cast<size_t>(3 * i) + c] = record.real("points", place);
        }
        ++place;
    });
}

int64_t knot_count(const SplineData::Axis &axis) {
    return axis.count + axis.degree + 1;
}

} // namespace

SplineData read_curve_data(Record &record) {
    SplineData data;
    const int64_t upper_index = record.integer("K");
    const int64_t degree = record.integer("M");
    data.axes.push_back(make_axis(upper_index, degree, -1, record));
    SplineData::Axis &axis = data.axes.front();
    record.skip(2);          // planar, closed
    record.integer("PROP3"); // polynomial or rational: the weights decide
    axis.periodic = record.integer("PROP4") == 1;
    require(knot_count(axis) + checked_product(4, axis.count, "weights and points"), record);
    read_knots(record, axis, "knots");
    read_weights(record, data, axis.count);
    read_points(record, data, axis.count);
    read_range(record, axis, "V");
    record.skip(3); // unit normal of a planar curve
    return data;
}

SplineData read_surface_data(Record &record) {
    SplineData data;
    const int64_t upper_u = record.integer("K1");
    const int64_t upper_v = record.integer("K2");
    const int64_t degree_u = record.integer("M1");
    const int64_t degree_v = record.integer("M2");
    data.axes.push_back(make_axis(upper_u, degree_u, 0, record));
    data.axes.push_back(make_axis(upper_v, degree_v, 1, record));
    SplineData::Axis &u = data.axes[0];
    SplineData::Axis &v = data.axes[1];
    record.skip(2);          // closed in u, closed in v
    record.integer("PROP3"); // polynomial or rational: the weights decide
    u.periodic = record.integer("PROP4") == 1;
    v.periodic = record.integer("PROP5") == 1;
    const int64_t point_count = checked_product(u.count, v.count, "points");
    const int64_t values = checked_product(4, point_count, "weights and points");
    require(checked_sum(values, knot_count(u) + knot_count(v), "weights, points and knots"), record);
    read_knots(record, u, "knots of axis 0");
    read_knots(record, v, "knots of axis 1");
    read_weights(record, data, point_count);
    read_points(record, data, point_count);
    read_range(record, u, "U");
    read_range(record, v, "V");
    return data;
}

} // namespace nrb::io::iges
