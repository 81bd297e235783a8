// SPDX-License-Identifier: MIT
#include "spline/kind.h"

#include <cstdio>

namespace nrb::inline spline {

namespace {

struct SplineName {
    SplineName(const char *name, int64_t index) noexcept {
        if (index < 0) {
            std::snprintf(text, sizeof text, "%s", name);
        } else {
            std::snprintf(text, sizeof text, "%s[%lld]", name, static_cast<long long>(index));
        }
    }
    char text[64];
};

} // namespace

void check_kind(const Spline &spline, int axes, const char *name, int64_t index) {
    if (spline.axes() != axes) {
        fail(Status::axes, "%s has %d axes, expected a %s", SplineName(name, index).text, spline.axes(),
             axes == 1   ? "curve"
             : axes == 2 ? "surface"
                         : "volume");
    }
}

void check_dimension(const Spline &spline, int least, int most, const char *name, int64_t index) {
    if (spline.dim() >= least && spline.dim() <= most) {
        return;
    }
    const SplineName of(name, index);
    if (least == most) {
        fail(Status::dimension, "%s has dimension %d, expected %d", of.text, spline.dim(), least);
    }
    fail(Status::dimension, "%s has dimension %d, expected %d %s %d", of.text, spline.dim(), least,
         most == least + 1 ? "or" : "to", most);
}

void check_same_dimension(const Spline &a, const Spline &b) {
    if (a.dim() != b.dim()) {
        fail(Status::incompatible, "b has dimension %d, expected %d as a has", b.dim(), a.dim());
    }
}

} // namespace nrb::inline spline
