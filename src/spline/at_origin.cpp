// SPDX-License-Identifier: MIT
#include "spline/at_origin.h"

#include "base/numbers.h"

#include <algorithm>
#include <cmath>

namespace nrb::inline spline {

namespace {

constexpr double far_in_sizes = 8;

class Box {
public:
    explicit Box(int dim) : lower_(static_cast<size_t>(dim), infinity), upper_(lower_.size(), -infinity) {}

    void add(const Spline &spline, int64_t point) noexcept {
        for (size_t c = 0; c < lower_.size(); ++c) {
            const double x = spline.coordinate(point, static_cast<int>(c));
            lower_[c] = std::min(lower_[c], x);
            upper_[c] = std::max(upper_[c], x);
        }
    }

    // If a box is not far from the origin, it stays so when further points are added.
    [[nodiscard]] bool far() const noexcept {
        double distance = 0;
        double size = 0;
        for (size_t c = 0; c < lower_.size(); ++c) {
            distance = std::max(distance, std::fabs(nearest(c)));
            size = std::max(size, upper_[c] - lower_[c]);
        }
        return distance > far_in_sizes * size;
    }

    // The point that becomes the origin. The difference of two numbers of the same sign is exact if neither
    // is more than twice the other (Sterbenz), which is why other coordinates are left as they are.
    [[nodiscard]] std::vector<double> corner() const {
        std::vector<double> corner(lower_.size());
        for (size_t c = 0; c < corner.size(); ++c) {
            const double x = nearest(c);
            corner[c] = std::fabs(x) >= upper_[c] - lower_[c] ? x : 0;
        }
        return corner;
    }

private:
    [[nodiscard]] double nearest(size_t c) const noexcept {
        return lower_[c] > 0 ? lower_[c] : std::min(upper_[c], 0.0);
    }

    std::vector<double> lower_;
    std::vector<double> upper_;
};

// The corner that is to become the origin; empty if the spline stays where it is.
std::vector<double> far_corner(const Spline &spline) {
    Box box(spline.dim());
    bool far = false;
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        if (spline.weight(i) == 0) { // at infinity
            continue;
        }
        box.add(spline, i);
        far = box.far();
        if (!far) {
            break;
        }
    }
    return far ? box.corner() : std::vector<double>();
}

SplinePtr moved(const Spline &spline, const std::vector<double> &corner) {
    std::vector<double> points(spline.points().begin(), spline.points().end());
    const auto width = static_cast<size_t>(spline.stored_width());
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        double *record = points.data() + static_cast<size_t>(i) * width;
        const double weight = spline.form() == Form::homogeneous ? spline.weight(i) : 1;
        for (size_t c = 0; c < corner.size(); ++c) {
            record[c] = std::fma(-corner[c], weight, record[c]);
        }
    }
    return std::make_shared<const Spline>(
        spline.knot_vectors(), spline.dim(), spline.form(), std::move(points),
        std::vector<double>(spline.weights().begin(), spline.weights().end()));
}

} // namespace

const Spline::AnyCache &make_at_origin(const Spline &spline) {
    return spline.slot(Spline::Cache::at_origin).get([&spline] {
        const Spline &effective = spline.effective();
        const std::vector<double> corner = far_corner(effective);
        return corner.empty() ? Spline::AnyCache() : Spline::AnyCache(moved(effective, corner));
    });
}

} // namespace nrb::inline spline
