#include "reference/patch_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reference {

namespace {

constexpr size_t record = 4; // w x, w y, w z, w
constexpr double wide = 1 + Patch::margin;
// Cells are not divided in the middle: what is symmetrical would meet the sides of cells.
constexpr double division = 0.51373;

// De Casteljau in place on count = degree + 1 records, `stride` records apart: the part [0, t], or [t, 1].
void keep_start(double *first, int count, size_t stride, double t) {
    for (int r = 1; r < count; ++r) {
        for (int i = count - 1; i >= r; --i) {
            for (size_t c = 0; c < record; ++c) {
                double &value = first[(static_cast<size_t>(i) * stride) * record + c];
                value = (1 - t) * first[(static_cast<size_t>(i - 1) * stride) * record + c] + t * value;
            }
        }
    }
}
void keep_end(double *first, int count, size_t stride, double t) {
    for (int r = 1; r < count; ++r) {
        for (int i = 0; i < count - r; ++i) {
            for (size_t c = 0; c < record; ++c) {
                double &value = first[(static_cast<size_t>(i) * stride) * record + c];
                value = (1 - t) * value + t * first[(static_cast<size_t>(i + 1) * stride) * record + c];
            }
        }
    }
}

// The coefficients of the span [knots[k], knots[k + 1]] of a curve of `degree`, from its active control points: values of the
// blossom (Ramshaw 1987), whose arguments are the ends of the span.
std::vector<double> span_coefficients(const std::vector<double> &knots, size_t k, int degree,
                                      const std::vector<double> &active) {
    std::vector<double> net;
    const auto p = static_cast<size_t>(degree);
    for (size_t upper = 0; upper <= p; ++upper) {
        std::vector<double> d = active;
        for (size_t r = 1; r <= p; ++r) {
            const double t = r <= upper ? knots[k + 1] : knots[k];
            for (size_t j = p; j >= r; --j) {
                const double from = knots[k + j - p], to = knots[k + 1 + j - r], s = (t - from) / (to - from);
                for (size_t c = 0; c < record; ++c) {
                    d[j * record + c] = (1 - s) * d[(j - 1) * record + c] + s * d[j * record + c];
                }
            }
        }
        net.insert(net.end(), d.end() - record, d.end());
    }
    return net;
}

// The spans of an axis in its domain: indices of their first knots.
std::vector<size_t> spans_of(const support::SplineData &data, size_t axis) {
    std::vector<size_t> spans;
    const auto p = static_cast<size_t>(data.degrees[axis]), n = static_cast<size_t>(data.counts[axis]);
    for (size_t k = p; k < n; ++k) {
        if (data.knots[axis][k] < data.knots[axis][k + 1]) {
            spans.push_back(k);
        }
    }
    return spans;
}

} // namespace

PatchTree::PatchTree(const support::SplineData &data, const Vector &origin)
    : degrees_{data.degrees[0], data.degrees[1]} {
    std::vector<double> points;
    double most = 0, most_weight = 0, least_weight = HUGE_VAL;
    for (int64_t i = 0; i < data.point_count(); ++i) {
        const double w = data.weight(i);
        for (int c = 0; c < 3; ++c) {
            const double x = data.coordinate(i, c) - origin[static_cast<size_t>(c)];
            most = std::max(most, std::abs(x) + std::abs(origin[static_cast<size_t>(c)]));
            points.push_back(w * x);
        }
        points.push_back(w);
        most_weight = std::max(most_weight, w);
        least_weight = std::min(least_weight, w);
    }
    const int degree = std::max(degrees_[0], degrees_[1]);
    const double steps = 4.0 * degree * (most_depth + 2) * std::pow(1 + Patch::margin, 2 * degree);
    noise_ = 2 * 1.5 * steps * std::numeric_limits<double>::epsilon() * most * most_weight / least_weight;
    add_pieces(points, data);
    find_closed_axes();
}

void PatchTree::add_pieces(const std::vector<double> &points, const support::SplineData &data) {
    const std::array<std::vector<size_t>, 2> spans{spans_of(data, 0), spans_of(data, 1)};
    for (size_t axis = 0; axis < 2; ++axis) {
        for (const size_t k : spans[axis]) {
            breaks_[axis].push_back(data.knots[axis][k]);
        }
        breaks_[axis].push_back(data.knots[axis][spans[axis].back() + 1]);
    }
    const auto p = static_cast<size_t>(degrees_[0]), q = static_cast<size_t>(degrees_[1]),
               row = static_cast<size_t>(data.counts[1]);
    for (size_t i = 0; i < spans[0].size(); ++i) {
        for (size_t j = 0; j < spans[1].size(); ++j) {
            std::vector<double> rows, net((p + 1) * (q + 1) * record);
            for (size_t a = 0; a <= p; ++a) {
                const double *first =
                    points.data() + ((spans[0][i] - p + a) * row + spans[1][j] - q) * record;
                const std::vector<double> along = span_coefficients(data.knots[1], spans[1][j], degrees_[1],
                                                                    {first, first + (q + 1) * record});
                rows.insert(rows.end(), along.begin(), along.end());
            }
            for (size_t b = 0; b <= q; ++b) {
                std::vector<double> column;
                for (size_t a = 0; a <= p; ++a) {
                    const double *at = rows.data() + (a * (q + 1) + b) * record;
                    column.insert(column.end(), at, at + record);
                }
                const std::vector<double> along =
                    span_coefficients(data.knots[0], spans[0][i], degrees_[0], column);
                for (size_t a = 0; a <= p; ++a) {
                    std::copy_n(along.data() + a * record, record, net.data() + (a * (q + 1) + b) * record);
                }
            }
            Patch patch;
            patch.lower = {static_cast<double>(i), static_cast<double>(j)};
            patch.upper = {patch.lower[0] + 1, patch.lower[1] + 1};
            patch.net = part(part(net, 0, -Patch::margin / 2, 1 + Patch::margin / 2), 1, -Patch::margin / 2,
                             1 + Patch::margin / 2);
            set_bounds(patch);
            roots_.push_back(static_cast<int32_t>(patches_.size()));
            patches_.push_back(std::move(patch));
        }
    }
}

// The first and the last layer of pieces, compared at as many places as tell polynomials apart.
void PatchTree::find_closed_axes() {
    const std::array<int, 2> count{static_cast<int>(pieces(0)), static_cast<int>(pieces(1))};
    for (size_t axis = 0; axis < 2; ++axis) {
        const int across = count[1 - axis], samples = 2 * degrees_[1 - axis] + 1;
        bool same = true;
        for (int i = 0; i < across && same; ++i) {
            const auto root = [&](int along) {
                return roots_[static_cast<size_t>(axis == 0 ? along * count[1] + i : i * count[1] + along)];
            };
            for (int k = 0; k <= samples; ++k) {
                std::array<double, 2> start{}, end{};
                start[axis] = -1;
                end[axis] = 1;
                start[1 - axis] = end[1 - axis] = 2.0 * k / samples - 1;
                const Vector x = point(root(0), start), y = point(root(count[axis] - 1), end);
                same = same && std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]) <= 4 * noise_;
            }
        }
        closes_[axis] = same;
    }
}

std::vector<double> PatchTree::part(const std::vector<double> &net, int axis, double from, double to) const {
    std::vector<double> result = net;
    const int count = degrees_[static_cast<size_t>(axis)] + 1,
              lines = degrees_[static_cast<size_t>(1 - axis)] + 1;
    const auto row = static_cast<size_t>(degrees_[1] + 1);
    const size_t stride = axis == 0 ? row : 1, next = axis == 0 ? 1 : row;
    for (int i = 0; i < lines; ++i) {
        double *first = result.data() + static_cast<size_t>(i) * next * record;
        keep_start(first, count, stride, to);
        keep_end(first, count, stride, from / to);
    }
    return result;
}

int32_t PatchTree::child(int32_t patch, int which) {
    const int32_t known = patches_[static_cast<size_t>(patch)].children[static_cast<size_t>(which)];
    if (known >= 0) {
        return known;
    }
    const Patch &parent = patches_[static_cast<size_t>(patch)];
    Patch made;
    made.depth = parent.depth + 1;
    made.net = parent.net;
    for (size_t axis = 0; axis < 2; ++axis) {
        const bool up = (which >> axis & 1) != 0;
        const double middle = parent.lower[axis] + division * (parent.upper[axis] - parent.lower[axis]);
        made.lower[axis] = up ? middle : parent.lower[axis];
        made.upper[axis] = up ? parent.upper[axis] : middle;
        const double from = up ? division : 0, to = up ? 1 : division, over = (to - from) * Patch::margin / 2;
        const auto in_margin = [](double t) { return (t + Patch::margin / 2) / wide; };
        made.net = part(made.net, static_cast<int>(axis), in_margin(from - over), in_margin(to + over));
    }
    set_bounds(made);
    const auto index = static_cast<int32_t>(patches_.size());
    patches_.push_back(std::move(made));
    patches_[static_cast<size_t>(patch)].children[static_cast<size_t>(which)] = index;
    return index;
}

void PatchTree::set_bounds(Patch &patch) const {
    const size_t rows = static_cast<size_t>(degrees_[0] + 1), columns = static_cast<size_t>(degrees_[1] + 1);
    const std::vector<double> &net = patch.net;
    double least_weight = HUGE_VAL, most_weight = -HUGE_VAL;
    for (size_t i = 0; i < rows * columns; ++i) {
        least_weight = std::min(least_weight, net[i * record + 3]);
        most_weight = std::max(most_weight, net[i * record + 3]);
    }
    patch.bounded = least_weight > 0;
    if (!patch.bounded) {
        return;
    }
    std::vector<double> middle = net;
    for (size_t i = 0; i < rows; ++i) {
        keep_start(middle.data() + i * columns * record, static_cast<int>(columns), 1, 0.5);
    }
    double *last = middle.data() + (columns - 1) * record;
    keep_start(last, static_cast<int>(rows), columns, 0.5);
    const double *centre = last + (rows - 1) * columns * record;
    for (size_t c = 0; c < 3; ++c) {
        patch.middle[c] = centre[c] / centre[3];
        patch.least[c] = HUGE_VAL;
        patch.most[c] = -HUGE_VAL;
        for (size_t i = 0; i < rows * columns; ++i) {
            const double x = net[i * record + c] / net[i * record + 3];
            patch.least[c] = std::min(patch.least[c], x - noise_);
            patch.most[c] = std::max(patch.most[c], x + noise_);
        }
    }
    // S' = ((X - m W)' - (S - m) W') / W with m = S(0), so that what is not known of S is small.
    for (size_t axis = 0; axis < 2; ++axis) {
        const size_t step = axis == 0 ? columns : 1;
        const double factor = degrees_[axis] / (2 * wide);
        for (size_t c = 0; c < 3; ++c) {
            const double reach = std::max(patch.most[c] - patch.middle[c], patch.middle[c] - patch.least[c]);
            double lower = HUGE_VAL, upper = -HUGE_VAL;
            for (size_t i = 0; i < rows * columns; ++i) {
                if ((axis == 0 ? i / columns + 1 == rows : i % columns + 1 == columns)) {
                    continue;
                }
                const double *from = net.data() + i * record, *to = from + step * record;
                const double weight = factor * (to[3] - from[3]);
                const double value = factor * (to[c] - from[c]) - patch.middle[c] * weight;
                lower = std::min(lower, value);
                upper = std::max(upper, value);
                // Both hulls are those of polynomials of one degree: reach times the largest |W'| is added below.
                patch.slope_radius[axis][c] = std::max(patch.slope_radius[axis][c], reach * std::abs(weight));
            }
            lower -= patch.slope_radius[axis][c];
            upper += patch.slope_radius[axis][c];
            lower /= lower < 0 ? least_weight : most_weight;
            upper /= upper > 0 ? least_weight : most_weight;
            patch.slope[axis][c] = (lower + upper) / 2;
            patch.slope_radius[axis][c] = (upper - lower) / 2 + 4 * factor * noise_;
        }
    }
}

Vector PatchTree::point(int32_t patch, const std::array<double, 2> &x) const {
    const size_t rows = static_cast<size_t>(degrees_[0] + 1), columns = static_cast<size_t>(degrees_[1] + 1);
    std::array<double, record *(most_degree + 1) * (most_degree + 1)> net;
    std::ranges::copy(patches_[static_cast<size_t>(patch)].net, net.begin());
    const double u = (x[0] + wide) / (2 * wide), v = (x[1] + wide) / (2 * wide);
    for (size_t i = 0; i < rows; ++i) {
        keep_end(net.data() + i * columns * record, static_cast<int>(columns), 1, v);
    }
    keep_end(net.data(), static_cast<int>(rows), columns, u);
    return {net[0] / net[3], net[1] / net[3], net[2] / net[3]};
}

double PatchTree::param(int axis, double place) const {
    const std::vector<double> &breaks = breaks_[static_cast<size_t>(axis)];
    const size_t piece = std::min(static_cast<size_t>(std::max(place, 0.0)), breaks.size() - 2);
    const double t = place - static_cast<double>(piece);
    return (1 - t) * breaks[piece] + t * breaks[piece + 1];
}

} // namespace reference
