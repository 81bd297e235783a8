/* SPDX-License-Identifier: MIT */
// Evaluation of few points: numbers that fill no vector of any processor, in every dimension to 9, packed, in
// the rows of a table, and as columns.
#include "guarded/batches.h"

#include "shapes.h"

#include <array>
#include <cmath>

namespace {

constexpr int64_t row = 48; // more than any record here has
constexpr int64_t sizes[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 15, 16, 17};

// Coordinates, parameters in (0, 1), and whatever else is a number.
std::vector<double> numbers() {
    std::vector<double> all(4096);
    for (size_t i = 0; i < all.size(); ++i) {
        const double x = 0.618033988749895 * static_cast<double>(i + 1);
        all[i] = x - std::floor(x);
    }
    return all;
}

const std::vector<double> inputs = numbers();

// Of several spans, over [0, 1] on every axis.
nurbs *make_spline(std::span<const int32_t> degrees, int32_t dim, bool rational) {
    const auto axes = static_cast<int32_t>(degrees.size());
    int64_t counts[3];
    std::vector<double> knots;
    for (size_t k = 0; k < degrees.size(); ++k) {
        counts[k] = degrees[k] + 3;
        const size_t before = knots.size();
        knots.resize(before + static_cast<size_t>(counts[k] + degrees[k] + 1));
        CHECK_OK(nurbs_knots_open_uniform(degrees[k], counts[k], 0, 1, counts[k] + degrees[k] + 1,
                                          knots.data() + before));
    }
    nurbs *g = nullptr;
    CHECK_OK(nurbs_create(axes, degrees.data(), counts, knots.data(), static_cast<int64_t>(knots.size()), dim,
                          inputs.data(), 0, 0, rational ? inputs.data() : nullptr, 0, 0, &g));
    return g;
}

struct Layout {
    int64_t stride, component_stride;
};

// Outputs are not looked at: all go to the same place.
class Batch {
public:
    Batch(const nurbs *g, int64_t n, Layout layout)
        : g_(g), n_(n), s_(layout.stride), c_(layout.component_stride) {
        CHECK_OK(nurbs_axes(g, &axes_));
        CHECK_OK(nurbs_dimension(g, &dim_));
    }

    void any() {
        CHECK_OK(nurbs_eval(g_, n_, in_, s_, c_, out_, s_, c_, 0));
        CHECK_OK(nurbs_eval_derivs(g_, 2, n_, in_, s_, c_, out_, s_, c_, 0));
        CHECK_OK(nurbs_eval_f32(g_, n_, in_, s_, c_, singles_, s_, c_, 0));
        CHECK_OK(nurbs_rational_basis(g_, n_, in_, s_, c_, integers_, out_, s_, c_, 0));
        CHECK_OK(nurbs_hull_size(g_, n_, in_, s_, c_, out_, s_, 0));
        CHECK_OK(
            nurbs_eval_adjoint(g_, 1, n_, in_, s_, c_, in_, s_, c_, out_, 0, 0, out_, 0, out_, s_, c_, 0));
        CHECK_OK(nurbs_most_influential(g_, n_, in_, s_, c_, integers_, out_));
    }

    // Grids of as many parameters on every axis.
    void grids() {
        const int64_t counts[] = {n_, n_, n_}, points = axes_ == 1 ? n_ : axes_ == 2 ? n_ * n_ : n_ * n_ * n_;
        const int64_t c = s_ == 1 ? points : c_;
        CHECK_OK(nurbs_eval_grid(g_, counts, in_, out_, s_, c, 0));
        CHECK_OK(nurbs_eval_grid_derivs(g_, 1, counts, in_, out_, s_, c, 0));
        CHECK_OK(nurbs_eval_grid_f32(g_, counts, in_, singles_, s_, c, 0));
        if (axes_ == 2 && dim_ == 3) {
            CHECK_OK(nurbs_surface_eval_grid_frames(g_, counts, in_, out_, s_, c, out_, s_, c, out_, s_, c,
                                                    out_, s_, c, states_, 0));
        }
    }

    void frames() {
        if (axes_ == 2 && dim_ == 3) {
            CHECK_OK(nurbs_surface_eval_frames(g_, n_, in_, s_, c_, out_, s_, c_, out_, s_, c_, out_, s_, c_,
                                               out_, s_, c_, states_, 0));
            CHECK_OK(nurbs_surface_eval_curvatures(g_, n_, in_, s_, c_, out_, s_, c_, out_, s_, c_, out_, s_,
                                                   out_, s_, states_, 0));
        }
        if (axes_ == 1 && dim_ == 2) {
            CHECK_OK(nurbs_curve_eval_frames(g_, n_, in_, s_, out_, s_, c_, out_, s_, c_, out_, s_, c_,
                                             nullptr, 0, 0, out_, s_, nullptr, 0, states_, 0));
        }
        if (axes_ == 1 && dim_ == 3) {
            CHECK_OK(nurbs_curve_eval_frames(g_, n_, in_, s_, out_, s_, c_, out_, s_, c_, out_, s_, c_, out_,
                                             s_, c_, out_, s_, out_, s_, states_, 0));
            CHECK_OK(nurbs_curve_rotation_minimizing_frames(g_, n_, in_, s_, nullptr, out_, s_, c_, out_, s_,
                                                            c_, out_, s_, c_, out_, s_, c_, states_, 0));
        }
    }

    // Slower ones.
    void queries() {
        CHECK_OK(nurbs_closest_points(g_, n_, in_, s_, c_, nullptr, 1e-3, 0, out_, s_, c_, out_, s_, c_, out_,
                                      s_, states_, 0));
        CHECK_OK(nurbs_farthest_points(g_, n_, in_, s_, c_, nullptr, 1e-3, 0, out_, s_, c_, out_, s_, c_,
                                       out_, s_, states_, 0));
        CHECK_OK(nurbs_closest_local(g_, n_, in_, s_, c_, in_, s_, c_, out_, s_, c_, out_, s_, c_, out_, s_,
                                     states_, 0));
        if (axes_ == 1) {
            CHECK_OK(nurbs_curve_lengths(g_, n_, in_, s_, 1e-6, out_, s_));
            CHECK_OK(nurbs_curve_params_at_lengths(g_, n_, in_, s_, 1e-6, out_, s_, NURBS_CLAMP));
        }
        if (axes_ == 1 && dim_ == 2) {
            CHECK_OK(
                nurbs_curve_signed_distances(g_, n_, in_, s_, c_, 1e-3, 0, out_, s_, out_, s_, states_, 0));
        }
    }

private:
    const nurbs *g_;
    int64_t n_, s_, c_;
    int32_t axes_ = 0, dim_ = 0;
    const double *in_ = inputs.data();
    std::vector<double> values_ = std::vector<double>(static_cast<size_t>(17 * 17 * row));
    std::vector<float> floats_ = std::vector<float>(values_.size());
    double *out_ = values_.data();
    float *singles_ = floats_.data();
    int64_t integers_[64] = {};
    int32_t states_[17 * 17] = {};
};

void evaluate(std::span<const int32_t> degrees, int32_t dim, bool rational, bool queries) {
    nurbs *g = make_spline(degrees, dim, rational);
    for (const int64_t n : sizes) {
        for (const Layout layout : {Layout{0, 0}, Layout{row, 1}, Layout{1, n}}) {
            Batch batch(g, n, layout);
            batch.any();
            batch.frames();
            if (degrees.size() < 3 || n <= 5) {
                batch.grids();
            }
            if (queries) {
                batch.queries();
            }
        }
    }
    nurbs_destroy(g);
}

void basis_functions() {
    const double knots[] = {0, 0, 0, 0, 0.3, 0.6, 1, 1, 1, 1}, *in = inputs.data();
    const int32_t degree = 3, order = 1;
    const int64_t count = 6;
    int64_t spans[17], columns[17 * 4], rows[18], entries = 0;
    std::vector<double> out(17 * row);
    for (const int64_t n : sizes) {
        CHECK_OK(nurbs_find_spans(3, 6, knots, 10, n, in, 0, spans, 0));
        CHECK_OK(nurbs_collocation(1, &degree, &count, knots, 10, &order, n, in, 0, 0, 4 * n, out.data(),
                                   columns, rows, &entries, 0));
        for (const Layout layout : {Layout{0, 0}, Layout{row, 1}, Layout{1, n}}) {
            const int64_t s = layout.stride, c = layout.component_stride;
            CHECK_OK(nurbs_bernstein(5, 2, n, in, s, out.data(), s, c));
            CHECK_OK(nurbs_basis(3, 6, knots, 10, 2, n, in, s, spans, out.data(), s, c, 0));
        }
    }
}

} // namespace

void evaluate_batches() {
    basis_functions();
    for (const bool rational : {false, true}) {
        for (const int32_t degree : {0, 1, 2, 3, 5, 10}) {
            for (int32_t dim = 1; dim <= 9; ++dim) {
                evaluate(std::array{degree}, dim, rational, degree == 3 && dim <= 3);
            }
        }
        for (const int32_t dim : {1, 2, 3, 5}) {
            evaluate(std::array{2, 3}, dim, rational, dim == 3);
            evaluate(std::array{5, 1}, dim, rational, false);
        }
        evaluate(std::array{1, 2, 2}, 3, rational, false);
        evaluate(std::array{2, 1, 1}, 4, rational, false);
    }
}

void evaluate_nothing(const calls::Inputs &in) {
    const int64_t none[] = {0, 0, 0};
    const double *const knots = circle().knots;
    CHECK_OK(nurbs_find_spans(2, 9, knots, 12, 0, nullptr, 0, nullptr, 0));
    CHECK_OK(nurbs_bernstein(5, 2, 0, nullptr, 0, nullptr, 0, 0));
    CHECK_OK(nurbs_basis(2, 9, knots, 12, 2, 0, nullptr, 0, nullptr, nullptr, 0, 0, 0));
    for (const nurbs *g : {in.curve, in.twist, in.surface, in.volume}) {
        CHECK_OK(nurbs_eval(g, 0, nullptr, 0, 0, nullptr, 0, 0, 0));
        CHECK_OK(nurbs_eval_derivs(g, 2, 0, nullptr, 0, 0, nullptr, 0, 0, 0));
        CHECK_OK(nurbs_eval_f32(g, 0, nullptr, 0, 0, nullptr, 0, 0, 0));
        CHECK_OK(nurbs_rational_basis(g, 0, nullptr, 0, 0, nullptr, nullptr, 0, 0, 0));
        CHECK_OK(nurbs_hull_size(g, 0, nullptr, 0, 0, nullptr, 0, 0));
        CHECK_OK(nurbs_most_influential(g, 0, nullptr, 0, 0, nullptr, nullptr));
        CHECK_OK(nurbs_eval_grid(g, none, nullptr, nullptr, 0, 0, 0));
        CHECK_OK(nurbs_eval_grid_derivs(g, 1, none, nullptr, nullptr, 0, 0, 0));
        CHECK_OK(nurbs_eval_grid_f32(g, none, nullptr, nullptr, 0, 0, 0));
        CHECK_OK(nurbs_closest_points(g, 0, nullptr, 0, 0, nullptr, 0, 0, nullptr, 0, 0, nullptr, 0, 0,
                                      nullptr, 0, nullptr, 0));
        CHECK_OK(nurbs_farthest_points(g, 0, nullptr, 0, 0, nullptr, 0, 0, nullptr, 0, 0, nullptr, 0, 0,
                                       nullptr, 0, nullptr, 0));
        CHECK_OK(nurbs_closest_local(g, 0, nullptr, 0, 0, nullptr, 0, 0, nullptr, 0, 0, nullptr, 0, 0,
                                     nullptr, 0, nullptr, 0));
    }
    CHECK_OK(nurbs_curve_lengths(in.curve, 0, nullptr, 0, 1e-6, nullptr, 0));
    CHECK_OK(nurbs_curve_params_at_lengths(in.curve, 0, nullptr, 0, 1e-6, nullptr, 0, 0));
    CHECK_OK(
        nurbs_curve_signed_distances(in.curve, 0, nullptr, 0, 0, 0, 0, nullptr, 0, nullptr, 0, nullptr, 0));
}
