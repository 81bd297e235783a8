#include "spline/at_origin.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double far_in_sizes = 8;

// Layers of an axis whose functions do not vanish on the whole domain.
struct Layers {
    int64_t first = 0;
    int64_t last = 0;
};

Layers active_layers(const KnotVector &axis) noexcept {
    const Interval domain = axis.domain();
    return {axis.find_span(domain.lower, false) - axis.degree(), axis.find_span(domain.upper, true)};
}

// Calls visit(i) for the control points with influence while it returns true.
template <class Visit>
void visit_influential(const Spline &spline, Visit &&visit) {
    std::array<Layers, max_axes> layers{};
    std::array<int64_t, max_axes> counts{1, 1, 1};
    for (int k = 0; k < spline.axes(); ++k) {
        layers[static_cast<size_t>(k)] = active_layers(spline.axis(k));
        counts[static_cast<size_t>(k)] = spline.count(k);
    }
    const auto [u, v, w] = layers;
    for (int64_t i = u.first; i <= u.last; ++i) {
        for (int64_t j = v.first; j <= v.last; ++j) {
            const int64_t row = (i * counts[1] + j) * counts[2];
            for (int64_t k = w.first; k <= w.last; ++k) {
                if (spline.weight(row + k) != 0 && !visit(row + k)) {
                    return;
                }
            }
        }
    }
}

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

    // A box that is not far from the origin does not become so by further points.
    [[nodiscard]] bool far() const noexcept {
        double distance = 0;
        double size = 0;
        for (size_t c = 0; c < lower_.size(); ++c) {
            distance = std::max(distance, std::fabs(nearest(c)));
            size = std::max(size, upper_[c] - lower_[c]);
        }
        return distance > far_in_sizes * size;
    }

    // The difference of two numbers of one sign, of which none is more than twice the other, is exact
    // (Sterbenz).
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

// The corner to which a spline is moved; nothing if it stays.
std::vector<double> far_corner(const Spline &spline) {
    Box box(spline.dim());
    bool far = false;
    visit_influential(spline, [&](int64_t point) {
        box.add(spline, point);
        return far = box.far();
    });
    return far ? box.corner() : std::vector<double>();
}

// A point without influence may be so far away that it has to stay.
SplinePtr moved(const Spline &spline, const std::vector<double> &corner) {
    std::vector<double> points(spline.points().begin(), spline.points().end());
    const auto width = static_cast<size_t>(spline.stored_width());
    for (int64_t i = 0; i < spline.point_count(); ++i) {
        double *record = points.data() + static_cast<size_t>(i) * width;
        const double weight = spline.form() == Form::homogeneous ? spline.weight(i) : 1;
        for (size_t c = 0; c < corner.size(); ++c) {
            const double x = std::fma(-corner[c], weight, record[c]);
            record[c] = std::isfinite(x) ? x : record[c];
        }
    }
    return std::make_shared<const Spline>(
        spline.knot_vectors(), spline.dim(), spline.form(), std::move(points),
        std::vector<double>(spline.weights().begin(), spline.weights().end()));
}

} // namespace

const Spline::AnyTable &make_at_origin(const Spline &spline) {
    return spline.slot(Spline::Table::at_origin).get([&spline] {
        const std::vector<double> corner = far_corner(spline);
        return corner.empty() ? Spline::AnyTable() : Spline::AnyTable(moved(spline, corner));
    });
}

} // namespace nrb
