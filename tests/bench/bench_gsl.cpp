// GSL: its basis functions, and the sum over the control points written here, in homogeneous space.
#include "bench/harness.h"
#include "bench/quotient.h"
#include "bench/rational.h"

#include <array>
#include <gsl/gsl_bspline.h>
#include <memory>

namespace {

using namespace bench;
using Record = std::array<double, 4>;

void add(Record &sum, double factor, const double *record) {
    for (size_t c = 0; c < 4; ++c) {
        sum[c] += factor * record[c];
    }
}

// The functions that do not vanish at a parameter: value(j, k) is derivative k of function first + j.
class Basis {
public:
    Basis(const support::SplineData &data, size_t axis, int order)
        : size_(static_cast<size_t>(data.degrees[axis]) + 1), order_(static_cast<size_t>(order)),
          values_(gsl_vector_alloc(size_)), derivatives_(gsl_matrix_alloc(size_, order_ + 1)) {
        const auto breaks = static_cast<size_t>(data.counts[axis] - data.degrees[axis]) + 1;
        const auto knots = gsl_vector_const_view_array(data.knots[axis].data() + data.degrees[axis], breaks);
        space_ = gsl_bspline_alloc(size_, breaks);
        gsl_bspline_knots(&knots.vector, space_);
    }
    Basis(const Basis &) = delete;
    Basis &operator=(const Basis &) = delete;
    ~Basis() {
        gsl_bspline_free(space_);
        gsl_matrix_free(derivatives_);
        gsl_vector_free(values_);
    }

    void evaluate(double t) {
        size_t last = 0;
        if (order_ == 0) {
            gsl_bspline_eval_nonzero(t, values_, &first_, &last, space_);
        } else {
            gsl_bspline_deriv_eval_nonzero(t, order_, derivatives_, &first_, &last, space_);
        }
    }
    [[nodiscard]] size_t first() const { return first_; }
    [[nodiscard]] size_t size() const { return size_; }
    [[nodiscard]] double value(size_t j, size_t k) const {
        return order_ == 0 ? values_->data[j] : derivatives_->data[j * derivatives_->tda + k];
    }

private:
    size_t size_;
    size_t order_;
    size_t first_ = 0;
    gsl_vector *values_;
    gsl_matrix *derivatives_;
    gsl_bspline_workspace *space_ = nullptr;
};

// Control points and one basis for each axis.
struct Net {
    Net(const support::SplineData &data, int order) : points(homogeneous(data)) {
        for (size_t axis = 0; axis < data.degrees.size(); ++axis) {
            counts.push_back(static_cast<size_t>(data.counts[axis]));
            bases.push_back(std::make_unique<Basis>(data, axis, order));
        }
    }
    [[nodiscard]] const double *point(size_t i) const { return &points[4 * i]; }

    std::vector<double> points;
    std::vector<size_t> counts;
    std::vector<std::unique_ptr<Basis>> bases;
};

template <int Order>
void curve_point(Net &net, const double *param, double *out) {
    Basis &basis = *net.bases[0];
    basis.evaluate(*param);
    std::array<Record, Order + 1> sums{};
    for (size_t j = 0; j < basis.size(); ++j) {
        for (size_t k = 0; k <= Order; ++k) {
            add(sums[k], basis.value(j, k), net.point(basis.first() + j));
        }
    }
    divide<1, Order>(sums[0].data(), out);
}

constexpr size_t slot_of(size_t a, size_t b) {
    return (a + b) * (a + b + 1) / 2 + b;
}

// Along axis 1 first, then along axis 0; both bases are at their parameters.
template <int Order, class Row>
void sum_surface(const Basis &u, const Row &row_sum, double *out) {
    std::array<Record, (Order + 1) * (Order + 2) / 2> sums{};
    for (size_t i = 0; i < u.size(); ++i) {
        const std::array<Record, Order + 1> row = row_sum(u.first() + i);
        for (size_t b = 0; b <= Order; ++b) {
            for (size_t a = 0; a + b <= Order; ++a) {
                add(sums[slot_of(a, b)], u.value(i, a), row[b].data());
            }
        }
    }
    divide<2, Order>(sums[0].data(), out);
}

// Row i of the net at the parameter of axis 1.
template <int Order>
std::array<Record, Order + 1> sum_row(const Net &net, size_t i) {
    const Basis &v = *net.bases[1];
    std::array<Record, Order + 1> row{};
    for (size_t j = 0; j < v.size(); ++j) {
        for (size_t k = 0; k <= Order; ++k) {
            add(row[k], v.value(j, k), net.point(i * net.counts[1] + v.first() + j));
        }
    }
    return row;
}

template <int Order>
void surface_point(Net &net, const double *param, double *out) {
    net.bases[0]->evaluate(param[0]);
    net.bases[1]->evaluate(param[1]);
    sum_surface<Order>(
        *net.bases[0], [&](size_t i) { return sum_row<Order>(net, i); }, out);
}

template <int Order>
void frame(Net &net, const double *param, double *out) {
    surface_point<Order>(net, param, out);
    unit_normal(out + 3, out + 6, out + 9);
}

void volume_point(Net &net, const double *param, double *out) {
    for (size_t axis = 0; axis < 3; ++axis) {
        net.bases[axis]->evaluate(param[axis]);
    }
    const Basis &u = *net.bases[0], &v = *net.bases[1], &w = *net.bases[2];
    Record sum{};
    for (size_t i = 0; i < u.size(); ++i) {
        for (size_t j = 0; j < v.size(); ++j) {
            const size_t row = ((u.first() + i) * net.counts[1] + v.first() + j) * net.counts[2] + w.first();
            Record line{};
            for (size_t k = 0; k < w.size(); ++k) {
                add(line, w.value(k, 0), net.point(row + k));
            }
            add(sum, u.value(i, 0) * v.value(j, 0), line.data());
        }
    }
    divide<3, 0>(sum.data(), out);
}

// All rows of the net at each parameter of axis 1 once; then each grid point is a sum over axis 0 alone.
template <int Order, bool Normal>
void evaluate_grid(Net &net, const Case &data, double *out) {
    using Row = std::array<Record, Order + 1>;
    const size_t rows = net.counts[0];
    const auto m = static_cast<size_t>(data.grid[0]), n = static_cast<size_t>(data.grid[1]);
    std::vector<Row> table(n * rows);
    for (size_t j = 0; j < n; ++j) {
        net.bases[1]->evaluate(data.params[m + j]);
        for (size_t i = 0; i < rows; ++i) {
            table[j * rows + i] = sum_row<Order>(net, i);
        }
    }
    for (size_t i = 0; i < m; ++i) {
        net.bases[0]->evaluate(data.params[i]);
        for (size_t j = 0; j < n; ++j) {
            sum_surface<Order>(
                *net.bases[0], [&](size_t row) { return table[j * rows + row]; }, out);
            if constexpr (Normal) {
                unit_normal(out + 3, out + 6, out + 9);
            }
            out += Normal ? 12 : 3;
        }
    }
}

using Point = void (*)(Net &, const double *, double *);

Point evaluator(const Job &job) {
    static constexpr Point curves[] = {curve_point<0>, curve_point<1>, curve_point<2>};
    static constexpr Point surfaces[] = {surface_point<0>, surface_point<1>, surface_point<2>};
    if (job.axes == 3) {
        return volume_point;
    }
    if (job.normal) {
        return frame<1>;
    }
    return (job.axes == 1 ? curves : surfaces)[job.order];
}

bool offers(const Job &job) {
    return job.group == Group::main;
}

Work prepare(const Job &job, const Case &data, Output &output) {
    const auto net = std::make_shared<Net>(data.spline, job.order);
    if (job.params == Params::grid) {
        const auto evaluate = job.normal ? evaluate_grid<1, true> : evaluate_grid<0, false>;
        return [=, &data, &output] { evaluate(*net, data, output.values.data()); };
    }
    return [net, job, evaluate = evaluator(job), &data, &output] {
        double *out = output.values.data();
        const auto axes = static_cast<size_t>(job.axes);
        for (size_t i = 0; i < data.params.size(); i += axes, out += 3 * job.vectors()) {
            evaluate(*net, &data.params[i], out);
        }
    };
}

} // namespace

int main(int argc, char **argv) {
    return run(argc, argv, {{"basis", offers, prepare}}, peer_tolerance);
}
