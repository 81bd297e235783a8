// SPDX-License-Identifier: MIT
#include "io/written/spline_facts.h"

#include "base/error.h"
#include "io/iges/text.h"
#include "reduce/periodic_form.h"

namespace nrb::io {

void check_writable(const Spline &spline, const char *format) {
    if (spline.axes() > 2) {
        fail(Status::axes, "a volume, which %s has no entity for", format);
    }
    const bool curve = spline.axes() == 1;
    if (spline.dim() != 3 && !(curve && spline.dim() == 2)) {
        fail(Status::dimension, "has dimension %d, expected %s", spline.dim(), curve ? "2 or 3" : "3");
    }
    for (int k = 0; k < spline.axes(); ++k) {
        if (spline.axis(k).degree() < 1) {
            fail(Status::degree, "has degree 0 on axis %d, expected 1 or more", k);
        }
    }
    for (int64_t i = 0; spline.form() == Form::homogeneous && i < spline.point_count(); ++i) {
        if (!(spline.weight(i) > 0)) {
            fail(Status::weight_sign,
                 "control point %lld is homogeneous with the weight %s, expected one above 0",
                 static_cast<long long>(i), Number(spline.weight(i)).text);
        }
    }
}

void check_surface(const Spline &surface, size_t face, const char *format) {
    try {
        check_writable(surface, format);
    } catch (const Error &error) {
        fail(error.status(), "faces[%zu]: its surface %s", face, error.what());
    }
}

bool has_weights(const Spline &spline) {
    if (!spline.rational()) {
        return false;
    }
    const Spline::WeightRange range = spline.all_weights();
    return range.smallest != range.largest;
}

std::vector<double> weights_of(const Spline &spline) {
    std::vector<double> weights(static_cast<size_t>(spline.point_count()));
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        weights[static_cast<size_t>(i)] = spline.weight(i);
    }
    return weights;
}

bool closed(const Spline &spline, int k) {
    const KnotVector &axis = spline.axis(k);
    if (!axis.clamped_start() || !axis.clamped_end()) {
        return reduce::wraps(spline, k);
    }
    const int64_t inner = spline.axes() == 2 && k == 0 ? spline.count(1) : 1;
    const int64_t outer = spline.axes() == 2 && k == 1 ? spline.count(0) : 1;
    const int64_t last = (axis.count() - 1) * inner;
    for (int64_t o = 0; o < outer; ++o) {
        for (int64_t i = 0; i < inner; ++i) {
            const int64_t first = o * axis.count() * inner + i;
            for (int c = 0; c < spline.dim(); ++c) {
                if (spline.coordinate(first, c) != spline.coordinate(first + last, c)) {
                    return false;
                }
            }
        }
    }
    return true;
}

std::string_view stated_name(std::string_view name, std::string_view usual) {
    name = iges::trim(name);
    return name == usual ? std::string_view() : name;
}

} // namespace nrb::io
