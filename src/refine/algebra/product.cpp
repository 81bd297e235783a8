// SPDX-License-Identifier: MIT
#include "refine/algebra/product.h"

#include "base/checked.h"
#include "base/representable.h"
#include "base/watch.h"
#include "numeric/sum.h"
#include "spline/contract.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace nrb::refine {

namespace {

constexpr int64_t work_of_a_choice = 40; // beyond contractions: a choice of arguments, compensated sums

// One choice of arguments of two polar forms: the stored layers and coefficients of both values.
struct Term {
    double weight;
    int64_t first_a;
    int64_t first_b;
    int size_a;
    int size_b;
    size_t offset; // coefficients of the first value, then those of the second
};

// The terms of layers of an axis.
class Terms {
public:
    void clear() noexcept {
        terms_.clear();
        coefficients_.clear();
        ends_.clear();
    }
    void add_layer(const CommonKnots &axis, int64_t layer, int p, double scale) {
        const CommonKnots::Window window = axis.window(layer);
        for_each_choice(window, p, [&](const int *chosen, double times) {
            int rest[max_basis];
            for (int i = 0; i < window.size; ++i) {
                rest[i] = window.copies[static_cast<size_t>(i)] - chosen[i];
            }
            BlossomRow a, b;
            axis.blossom_row(0, window, chosen, a);
            axis.blossom_row(1, window, rest, b);
            terms_.push_back({times * scale, axis.stored_layer(0, a.first), axis.stored_layer(1, b.first),
                              a.size, b.size, coefficients_.size()});
            coefficients_.insert(coefficients_.end(), a.coefficients, a.coefficients + a.size);
            coefficients_.insert(coefficients_.end(), b.coefficients, b.coefficients + b.size);
        });
        ends_.push_back(terms_.size());
    }
    [[nodiscard]] std::span<const Term> layer(int64_t i) const noexcept {
        const auto at = static_cast<size_t>(i);
        const size_t begin = at == 0 ? 0 : ends_[at - 1];
        return std::span(terms_).subspan(begin, ends_[at] - begin);
    }
    [[nodiscard]] const double *coefficients(const Term &term) const noexcept {
        return coefficients_.data() + term.offset;
    }

private:
    std::vector<Term> terms_;
    std::vector<double> coefficients_;
    std::vector<size_t> ends_;
};

// What remains of a factor at each axis: the length of a layer there.
std::vector<int64_t> layer_lengths(const Spline::Axes &axes, int64_t width) {
    std::vector<int64_t> lengths(axes.size());
    for (size_t k = axes.size(); k-- > 0; width *= axes[k]->count()) {
        lengths[k] = width;
    }
    return lengths;
}

class Multiplier {
public:
    Multiplier(const Factor &a, const Factor &b, const std::vector<CommonKnots> &axes, int width,
               const Bilinear &form)
        : axes_(axes), form_(form), product_(static_cast<size_t>(width)),
          lengths_a_(layer_lengths(a.axes, a.width)), lengths_b_(layer_lengths(b.axes, b.width)),
          lengths_(layer_lengths(axes_of(axes), width)), terms_(axes.size()) {
        for (size_t k = 0; k < axes.size(); ++k) {
            const int p = a.axes[k]->degree(), r = axes[k].axis()->degree();
            degrees_.push_back(p);
            // Powers of two bring the sums of the weights near 1.
            scales_.push_back(std::ldexp(1.0, -std::ilogb(binomial(r, p))));
            total_ *= binomial(r, p) * scales_.back();
            parts_a_.emplace_back(static_cast<size_t>(lengths_a_[k]));
            parts_b_.emplace_back(static_cast<size_t>(lengths_b_[k]));
            for (int64_t layer = 0; k > 0 && layer < axes[k].axis()->count(); ++layer) {
                terms_[k].add_layer(axes[k], layer, p, scales_.back());
            }
        }
        const int64_t size = checked_product(axes[0].axis()->count(), lengths_[0], "points");
        grow_watched(sums_, static_cast<size_t>(size));
    }

    std::vector<double> run(const double *a, const double *b) {
        Steps steps(axes_[0].axis()->count());
        for (int64_t layer = 0; layer < axes_[0].axis()->count(); ++layer, steps.next()) {
            terms_[0].clear();
            terms_[0].add_layer(axes_[0], layer, degrees_[0], scales_[0]);
            add_layer(0, terms_[0].layer(0), a, b, 1, sums_.data() + layer * lengths_[0]);
        }
        std::vector<double> result;
        grow_watched(result, sums_.size());
        for (size_t i = 0; i < sums_.size(); ++i) {
            result[i] = sums_[i].value() / total_;
        }
        require_representable(result, "products of control points");
        return result;
    }

private:
    // Adds to one layer of axis k of the result.
    void add_layer(size_t k, std::span<const Term> terms, const double *a, const double *b, double weight,
                   CompensatedSum *out) {
        count_work(std::ssize(terms) *
                   (work_of_a_choice + (degrees_[k] + 1) * (lengths_a_[k] + lengths_b_[k])));
        for (const Term &term : terms) {
            const double *coefficients = terms_[k].coefficients(term);
            double *part_a = parts_a_[k].data(), *part_b = parts_b_[k].data();
            const int64_t length_a = lengths_a_[k], length_b = lengths_b_[k];
            contract(coefficients, term.size_a, a + term.first_a * length_a, length_a, length_a, part_a);
            contract(coefficients + term.size_a, term.size_b, b + term.first_b * length_b, length_b, length_b,
                     part_b);
            add(k + 1, part_a, part_b, weight * term.weight, out);
        }
    }
    void add(size_t k, const double *a, const double *b, double weight, CompensatedSum *out) {
        if (k == axes_.size()) {
            form_(a, b, product_.data());
            for (const double value : product_) {
                out++->add(weight * value);
            }
            return;
        }
        for (int64_t layer = 0; layer < axes_[k].axis()->count(); ++layer) {
            add_layer(k, terms_[k].layer(layer), a, b, weight, out + layer * lengths_[k]);
        }
    }

    const std::vector<CommonKnots> &axes_;
    const Bilinear &form_;
    std::vector<double> product_;
    std::vector<int64_t> lengths_a_, lengths_b_, lengths_;
    std::vector<Terms> terms_;
    std::vector<int> degrees_;
    std::vector<double> scales_;
    double total_ = 1;
    std::vector<std::vector<double>> parts_a_, parts_b_;
    std::vector<CompensatedSum> sums_;
};

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

std::vector<double> product_records(const Factor &a, const Factor &b, const std::vector<CommonKnots> &axes,
                                    int width, const Bilinear &form) {
    return Multiplier(a, b, axes, width, form).run(a.records.data(), b.records.data());
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

// The form on Cartesian coordinates.
Bilinear coordinates_form(int dim_a, int dim_b, ProductKind kind) {
    switch (kind) {
    case ProductKind::dot:
        return [dim_a](const double *a, const double *b, double *out) {
            *out = std::inner_product(a, a + dim_a, b, 0.0);
        };
    case ProductKind::cross:
        return [](const double *a, const double *b, double *out) {
            for (int c = 0; c < 3; ++c) {
                const int next = (c + 1) % 3, last = (c + 2) % 3;
                out[c] = a[next] * b[last] - a[last] * b[next];
            }
        };
    case ProductKind::components:
        break;
    }
    return [dim_a, dim_b](const double *a, const double *b, double *out) {
        for (int c = 0; c < std::max(dim_a, dim_b); ++c) {
            out[c] = a[dim_a == 1 ? 0 : c] * b[dim_b == 1 ? 0 : c];
        }
    };
}

} // namespace

namespace {

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
    const int weight_a = a.rational() ? a.dim() : -1, weight_b = b.rational() ? b.dim() : -1;
    const Bilinear coordinates = coordinates_form(a.dim(), b.dim(), kind);
    const Bilinear whole = [&](const double *x, const double *y, double *out) {
        coordinates(x, y, out);
        out[dim] = (weight_a < 0 ? 1 : x[weight_a]) * (weight_b < 0 ? 1 : y[weight_b]);
    };
    const bool rational = form != Form::polynomial;
    return from_records(axes_of(joint), dim, form,
                        product_records({a.knot_vectors(), a.records(), a.width()},
                                        {b.knot_vectors(), b.records(), b.width()}, joint,
                                        dim + (rational ? 1 : 0), rational ? whole : coordinates));
}

} // namespace nrb::refine
