// SPDX-License-Identifier: MIT
#include "refine/algebra/product.h"

#include "base/representable.h"
#include "base/watch.h"

#include <algorithm>

namespace nrb::refine {

namespace {

void check_domains(const Interval &a, const Interval &b, size_t k) {
    if (a.lower != b.lower || a.upper != b.upper) {
        fail(Status::incompatible, "b: domain [%s, %s] of axis %zu, expected [%s, %s] as in a",
             Number(b.lower).text, Number(b.upper).text, k, Number(a.lower).text, Number(a.upper).text);
    }
}

} // namespace

void check_same_domains(const Spline::Axes &a, const Spline::Axes &b) {
    if (a.size() != b.size()) {
        fail(Status::incompatible, "b: %zu axes, expected %zu as in a", b.size(), a.size());
    }
    for (size_t k = 0; k < a.size(); ++k) {
        check_domains(a[k]->domain(), b[k]->domain(), k);
    }
}

std::vector<CommonKnots> product_axes(const Spline::Axes &a, const Spline::Axes &b,
                                      const std::array<int, 3> &extra) {
    check_same_domains(a, b);
    std::vector<CommonKnots> joint;
    for (size_t k = 0; k < a.size(); ++k) {
        const int degree = a[k]->degree() + b[k]->degree();
        if (degree > max_degree) {
            fail(Status::degree, "degrees %d and %d of axis %zu give %d, which exceeds the limit of %d",
                 a[k]->degree(), b[k]->degree(), k, degree, max_degree);
        }
        joint.emplace_back(degree, std::vector<const KnotVector *>{a[k].get(), b[k].get()}, extra[k]);
    }
    return joint;
}

Spline::Axes axes_of(const std::vector<CommonKnots> &joint) {
    Spline::Axes axes;
    axes.reserve(joint.size());
    for (const CommonKnots &axis : joint) {
        axes.push_back(axis.axis());
    }
    return axes;
}

namespace {

int product_dim(int a, int b, ProductKind kind) {
    const bool fits = kind == ProductKind::components ? a == b || a == 1 || b == 1
                      : kind == ProductKind::dot      ? a == b
                                                      : a == 3 && b == 3;
    if (!fits) {
        fail(Status::dimension, "dimensions %d of a and %d of b, expected %s", a, b,
             kind == ProductKind::components ? "equal ones or 1"
             : kind == ProductKind::dot      ? "equal ones"
                                             : "3 and 3");
    }
    return kind == ProductKind::components ? std::max(a, b) : kind == ProductKind::dot ? 1 : 3;
}

// The bilinear form of a product on Cartesian coordinates.
Bilinear coordinates_form(int dim_a, int dim_b, ProductKind kind) {
    Bilinear form;
    if (kind == ProductKind::cross) {
        for (int c = 0; c < 3; ++c) {
            const int next = (c + 1) % 3, last = (c + 2) % 3;
            form.push_back({c, next, last});
            form.push_back({c, last, next, -1});
        }
        return form;
    }
    if (kind == ProductKind::dot) {
        return {{0, 0, 0, 1, dim_a}};
    }
    for (int c = 0; c < std::max(dim_a, dim_b); ++c) {
        form.push_back({c, dim_a == 1 ? 0 : c, dim_b == 1 ? 0 : c});
    }
    return form;
}

bool has_infinite_points(const std::vector<double> &records, size_t width) noexcept {
    for (size_t i = 0; i < records.size(); i += width) {
        const auto from = records.begin() + static_cast<std::ptrdiff_t>(i);
        const auto last = from + static_cast<std::ptrdiff_t>(width - 1);
        if (*last == 0 && std::any_of(from, last, [](double x) { return x != 0; })) {
            return true;
        }
    }
    return false;
}

} // namespace

SplinePtr from_records(Spline::Axes axes, int dim, Form form, std::vector<double> records) {
    if (form == Form::rational && has_infinite_points(records, static_cast<size_t>(dim) + 1)) {
        form = Form::homogeneous;
    }
    if (form != Form::rational) {
        return make_result(std::move(axes), dim, form, std::move(records));
    }
    const auto width = static_cast<size_t>(dim) + 1;
    std::vector<double> points, weights;
    count_work(std::ssize(records));
    points.reserve(records.size() / width * static_cast<size_t>(dim));
    weights.reserve(records.size() / width);
    for (size_t i = 0; i < records.size(); i += width) {
        const double w = records[i + width - 1];
        for (size_t c = 0; c + 1 < width; ++c) {
            points.push_back(w == 0 ? 0 : records[i + c] / w);
        }
        weights.push_back(w);
    }
    require_representable(points, "control points of the product");
    return make_result(std::move(axes), dim, form, std::move(points), std::move(weights));
}

SplinePtr product(const Spline &a, const Spline &b, ProductKind kind) {
    const std::vector<CommonKnots> joint = product_axes(a.knot_vectors(), b.knot_vectors());
    const int dim = product_dim(a.dim(), b.dim(), kind);
    const Form form = std::max(a.form(), b.form());
    Bilinear bilinear = coordinates_form(a.dim(), b.dim(), kind);
    const bool rational = form != Form::polynomial;
    if (rational) { // component dim of a polynomial factor stands for the constant 1
        bilinear.push_back({dim, a.dim(), b.dim()});
    }
    return from_records(axes_of(joint), dim, form,
                        product_records({a.knot_vectors(), a.records(), a.width()},
                                        {b.knot_vectors(), b.records(), b.width()}, joint,
                                        dim + (rational ? 1 : 0), bilinear));
}

} // namespace nrb::refine
