#include "reference/definition.h"

#include "reference/exact_basis.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace reference {

using support::SplineData;

Rational defined_basis(const std::vector<double> &knots, int64_t span, int64_t i, int degree,
                       const Rational &t) {
    if (degree == 0) {
        return i == span ? 1 : 0;
    }
    const auto at = [&](int64_t k) { return exact(knots[static_cast<size_t>(k)]); };
    Rational sum = 0;
    if (at(i) < at(i + degree)) {
        sum += (t - at(i)) / (at(i + degree) - at(i)) * defined_basis(knots, span, i, degree - 1, t);
    }
    if (at(i + 1) < at(i + degree + 1)) {
        sum += (at(i + degree + 1) - t) / (at(i + degree + 1) - at(i + 1)) *
               defined_basis(knots, span, i + 1, degree - 1, t);
    }
    return sum;
}

Rational defined_basis_derivative(const std::vector<double> &knots, int64_t span, int64_t i, int degree,
                                  const Rational &t, int k) {
    if (k == 0) {
        return defined_basis(knots, span, i, degree, t);
    }
    if (degree == 0) {
        return 0;
    }
    const auto at = [&](int64_t j) { return exact(knots[static_cast<size_t>(j)]); };
    Rational sum = 0;
    if (at(i) < at(i + degree)) {
        sum += defined_basis_derivative(knots, span, i, degree - 1, t, k - 1) / (at(i + degree) - at(i));
    }
    if (at(i + 1) < at(i + degree + 1)) {
        sum -= defined_basis_derivative(knots, span, i + 1, degree - 1, t, k - 1) /
               (at(i + degree + 1) - at(i + 1));
    }
    return degree * sum;
}

std::vector<Rational> defined_point(const SplineData &data, const double *param, Sides left) {
    std::vector<Rational> sum(static_cast<size_t>(data.dim) + 1);
    for (int64_t i = 0; i < data.point_count(); ++i) {
        Rational product = exact(data.weight(i));
        int64_t rest = i;
        for (int k = data.axes() - 1; k >= 0; --k) {
            const auto axis = static_cast<size_t>(k);
            const auto &knots = data.knots[axis];
            const int64_t span = exact_span(knots, data.degrees[axis], param[k], left[axis]);
            product *=
                defined_basis(knots, span, rest % data.counts[axis], data.degrees[axis], exact(param[k]));
            rest /= data.counts[axis];
        }
        for (int c = 0; c < data.dim; ++c) {
            sum[static_cast<size_t>(c)] += product * exact(data.coordinate(i, c));
        }
        sum.back() += product;
    }
    for (int c = 0; c < data.dim; ++c) {
        sum[static_cast<size_t>(c)] /= sum.back();
    }
    sum.pop_back();
    return sum;
}

using Point = std::vector<Rational>;

Point blossom_at(const std::vector<double> &knots, int degree, int64_t s, std::vector<Point> points,
                 const std::vector<Rational> &arguments) {
    for (int r = 1; r <= degree; ++r) {
        const Rational &t = arguments[static_cast<size_t>(r - 1)];
        for (int j = degree; j >= r; --j) {
            const Rational low = exact(knots[static_cast<size_t>(s - degree + j)]);
            const Rational high = exact(knots[static_cast<size_t>(s + j - r + 1)]);
            const Rational alpha = (t - low) / (high - low);
            const auto upper = static_cast<size_t>(j);
            for (size_t c = 0; c < points[upper].size(); ++c) {
                points[upper][c] = points[upper - 1][c] + alpha * (points[upper][c] - points[upper - 1][c]);
            }
        }
    }
    return points.back();
}

Point defined_blossom(const std::vector<double> &knots, int degree, int64_t s, std::vector<Point> points,
                      const std::vector<double> &arguments) {
    std::vector<Rational> exact_arguments;
    std::transform(arguments.begin(), arguments.end(), std::back_inserter(exact_arguments), exact);
    return blossom_at(knots, degree, s, std::move(points), exact_arguments);
}

namespace {

Point homogeneous(const SplineData &data, int64_t i) {
    Point point;
    for (int c = 0; c < data.dim; ++c) {
        point.push_back(exact(data.weight(i)) * exact(data.coordinate(i, c)));
    }
    point.push_back(exact(data.weight(i)));
    return point;
}

// Numbers of points that differ in the layers of `axis` only: place = (outer * count + layer) * inner +
// inside.
struct AxisView {
    int64_t outer = 1;
    int64_t inner = 1;
};

AxisView view_of(const SplineData &data, int axis) {
    AxisView view;
    for (int k = 0; k < data.axes(); ++k) {
        (k < axis ? view.outer : view.inner) *= k == axis ? 1 : data.counts[static_cast<size_t>(k)];
    }
    return view;
}

// The records of the degree + 1 layers that are active on a span, at one place of the other axes.
std::vector<Point> active(const SplineData &data, int axis, int64_t span, int64_t outer, int64_t inside) {
    const auto k = static_cast<size_t>(axis);
    std::vector<Point> records;
    for (int64_t layer = span - data.degrees[k]; layer <= span; ++layer) {
        records.push_back(
            homogeneous(data, (outer * data.counts[k] + layer) * view_of(data, axis).inner + inside));
    }
    return records;
}

// The piece of the old spline that a refined control point belongs to: any non-empty span of the domain that
// meets its support (of degree `raised`), or the nearest one for a point whose support lies outside the
// domain.
int64_t piece_of(const std::vector<double> &knots, int degree, const std::vector<double> &refined, int raised,
                 int64_t j) {
    const auto count = static_cast<int64_t>(knots.size()) - degree - 1;
    if (refined[static_cast<size_t>(j)] >= knots[static_cast<size_t>(count)]) {
        return exact_span(knots, degree, knots[static_cast<size_t>(count)]);
    }
    for (int64_t s = degree; s < count; ++s) {
        const double low = knots[static_cast<size_t>(s)];
        const double high = knots[static_cast<size_t>(s + 1)];
        if (low < high && low < refined[static_cast<size_t>(j + raised + 1)] &&
            refined[static_cast<size_t>(j)] < high) {
            return s;
        }
    }
    return exact_span(knots, degree, knots[static_cast<size_t>(degree)]);
}

} // namespace

InsertedLayers defined_insertion(const SplineData &data, int axis, double knot, int times) {
    const auto k = static_cast<size_t>(axis);
    const int degree = data.degrees[k];
    InsertedLayers out;
    out.knots = data.knots[k];
    const auto place = std::upper_bound(out.knots.begin(), out.knots.end(), knot);
    const auto above = place - out.knots.begin(); // knots[above - 1] <= knot < knots[above]
    out.knots.insert(place, static_cast<size_t>(times), knot);
    const auto multiplicity = std::count(data.knots[k].begin(), data.knots[k].end(), knot);
    // Point j changes only if its p inner knots t_j+1 .. t_j+p meet a new copy, which stand last among the
    // equal ones.
    out.first = std::max<int64_t>(above - degree, 0);
    out.last = std::min<int64_t>(above - multiplicity + times - 2, data.counts[k] + times - 1);
    const AxisView view = view_of(data, axis);
    for (int64_t o = 0; o < view.outer; ++o) {
        for (int64_t j = out.first; j <= out.last; ++j) {
            const int64_t s = piece_of(data.knots[k], degree, out.knots, degree, j);
            const auto from = out.knots.begin() + j + 1;
            for (int64_t i = 0; i < view.inner; ++i) {
                const std::vector<Point> local = active(data, axis, s, o, i);
                out.records.push_back(
                    defined_blossom(data.knots[k], degree, s, local, {from, from + degree}));
            }
        }
    }
    return out;
}

namespace {

// Sums the polar form over all choices of the arguments still missing out of knots[next], ..., behind those
// already chosen; equal choices are counted and not computed again.
class Mean {
public:
    Mean(const std::vector<double> &knots, int degree, int64_t span, const std::vector<Point> &points)
        : knots_(knots), degree_(degree), span_(span), points_(points) {}

    Point operator()(const std::vector<double> &window) {
        std::map<std::vector<double>, int> choices;
        std::vector<double> chosen;
        choose(window, 0, chosen, choices);
        Point sum(points_.front().size());
        int total = 0;
        for (const auto &[arguments, times] : choices) {
            const Point value = defined_blossom(knots_, degree_, span_, points_, arguments);
            for (size_t c = 0; c < sum.size(); ++c) {
                sum[c] += times * value[c];
            }
            total += times;
        }
        for (Rational &component : sum) {
            component /= total;
        }
        return sum;
    }

private:
    void choose(const std::vector<double> &window, size_t next, std::vector<double> &chosen,
                std::map<std::vector<double>, int> &choices) const {
        if (chosen.size() == static_cast<size_t>(degree_)) {
            ++choices[chosen];
            return;
        }
        if (next == window.size()) {
            return;
        }
        chosen.push_back(window[next]);
        choose(window, next + 1, chosen, choices);
        chosen.pop_back();
        choose(window, next + 1, chosen, choices);
    }

    const std::vector<double> &knots_;
    int degree_;
    int64_t span_;
    const std::vector<Point> &points_;
};

} // namespace

std::vector<std::vector<Rational>> defined_elevation(const SplineData &data, int axis, int times,
                                                     const std::vector<double> &knots) {
    const auto k = static_cast<size_t>(axis);
    const int degree = data.degrees[k];
    const int raised = degree + times;
    const auto count = static_cast<int64_t>(knots.size()) - raised - 1;
    const AxisView view = view_of(data, axis);
    std::vector<Point> records;
    for (int64_t o = 0; o < view.outer; ++o) {
        for (int64_t j = 0; j < count; ++j) {
            const int64_t s = piece_of(data.knots[k], degree, knots, raised, j);
            for (int64_t i = 0; i < view.inner; ++i) {
                const std::vector<Point> local = active(data, axis, s, o, i);
                const auto from = knots.begin() + j + 1;
                records.push_back(Mean(data.knots[k], degree, s, local)({from, from + raised}));
            }
        }
    }
    return records;
}

std::vector<Point> defined_refinement(const SplineData &data, int axis, const std::vector<double> &knots) {
    const auto k = static_cast<size_t>(axis);
    const int degree = data.degrees[k];
    const AxisView view = view_of(data, axis);
    const auto count = static_cast<int64_t>(knots.size()) - degree - 1;
    std::vector<Point> records;
    for (int64_t o = 0; o < view.outer; ++o) {
        for (int64_t j = 0; j < count; ++j) {
            const auto from = knots.begin() + j + 1;
            const bool seen = *(from - 1) < data.upper(axis) && *(from + degree) > data.lower(axis);
            const int64_t s = piece_of(data.knots[k], degree, knots, degree, j);
            for (int64_t i = 0; i < view.inner; ++i) {
                const std::vector<Point> local = active(data, axis, s, o, i);
                records.push_back(
                    seen ? defined_blossom(data.knots[k], degree, s, local, {from, from + degree}) : Point());
            }
        }
    }
    return records;
}

} // namespace reference
