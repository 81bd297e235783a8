#include "closest/pair/pair_descent.h"

#include "numeric/binomial.h"
#include "numeric/norm.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nrb::closest {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr int most_steps = 40, most_dampings = 30;
constexpr int most_parameters = 2 * max_axes;

using Matrix = std::array<std::array<double, most_parameters>, most_parameters>;
using Vector = std::array<double, most_parameters>;

// Bernstein polynomials and two derivatives at t: rows of degree + 1.
void bernstein_rows(int degree, double t, double *out) {
    const int n = degree + 1;
    double lower[3][max_degree + 1]; // of degree, degree - 1, degree - 2
    for (int drop = 0; drop < 3; ++drop) {
        const int p = degree - drop;
        double *row = lower[drop];
        if (p < 0) {
            continue;
        }
        row[0] = 1;
        for (int d = 1; d <= p; ++d) { // each from the one below
            row[d] = t * row[d - 1];
            for (int i = d - 1; i > 0; --i) {
                row[i] = t * row[i - 1] + (1 - t) * row[i];
            }
            row[0] *= 1 - t;
        }
    }
    for (int i = 0; i < n; ++i) {
        const auto at = [&](int drop, int k) { return k >= 0 && k <= degree - drop ? lower[drop][k] : 0.0; };
        out[i] = lower[0][i];
        out[n + i] = degree > 0 ? degree * (at(1, i - 1) - at(1, i)) : 0;
        out[2 * n + i] =
            degree > 1 ? degree * (degree - 1) * (at(2, i - 2) - 2 * at(2, i - 1) + at(2, i)) : 0;
    }
}

// Solves (H + damping) x = -g for the free parameters; false if the matrix is not positive definite.
bool solve(const Matrix &h, const Matrix &metric, double damping, const Vector &g,
           const std::array<bool, most_parameters> &free, int n, Vector &x) noexcept {
    Matrix l{};
    for (int i = 0; i < n; ++i) {
        const auto r = static_cast<size_t>(i);
        x[r] = 0;
        if (!free[r]) {
            continue;
        }
        for (int j = 0; j <= i; ++j) {
            const auto c = static_cast<size_t>(j);
            if (!free[c]) {
                continue;
            }
            double sum = h[r][c] + (i == j ? damping * metric[r][r] : 0);
            for (size_t k = 0; k < c; ++k) {
                sum -= l[r][k] * l[c][k];
            }
            if (i == j) {
                if (!(sum > 16 * eps * (std::abs(h[r][r]) + damping * metric[r][r]))) {
                    return false;
                }
                l[r][r] = std::sqrt(sum);
            } else {
                l[r][c] = sum / l[c][c];
            }
        }
    }
    for (size_t r = 0; r < static_cast<size_t>(n); ++r) {
        double sum = -g[r];
        for (size_t k = 0; k < r; ++k) {
            sum -= l[r][k] * x[k];
        }
        x[r] = free[r] ? sum / l[r][r] : 0;
    }
    for (auto r = static_cast<size_t>(n); r-- > 0;) {
        double sum = x[r];
        for (size_t k = r + 1; k < static_cast<size_t>(n); ++k) {
            sum -= l[k][r] * x[k];
        }
        x[r] = free[r] ? sum / l[r][r] : 0;
    }
    return true;
}

} // namespace

const double *PieceJet::second(int k, int l) const noexcept {
    const int place = k == 0 ? l : k == 1 ? axes_ + l - 1 : 5; // (00, 01, 02, 11, 12, 22)
    return values_.data() + (1 + axes_ + place) * dim_;
}

// The homogeneous derivatives by contracting with rows of all axes, then the quotient rule.
void PieceJet::evaluate(const pieces::BezierPiece &piece, const pieces::Place &place, bool derivatives) {
    axes_ = piece.axes();
    dim_ = piece.dim();
    const int width = dim_ + 1, slots = derivatives ? 1 + axes_ + axes_ * (axes_ + 1) / 2 : 1;
    constexpr int row_size = 3 * (max_degree + 1);
    rows_.resize(static_cast<size_t>(max_axes * row_size));
    values_.resize(static_cast<size_t>(slots * dim_));
    records_.assign(static_cast<size_t>(slots * width), 0.0);
    for (int k = 0; k < axes_; ++k) {
        bernstein_rows(piece.degree(k), place[static_cast<size_t>(k)], rows_.data() + k * row_size);
    }
    const auto factor = [&](int k, int i, int order) {
        return k < axes_ ? rows_[static_cast<size_t>(k * row_size + order * (piece.degree(k) + 1) + i)] : 1.0;
    };
    std::array<int, max_axes> at{};
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        const double *record = piece.record(i);
        int slot = 0;
        const auto add = [&](int first, int second) {
            double product = 1;
            for (int k = 0; k < axes_; ++k) {
                product *= factor(k, at[static_cast<size_t>(k)], (first == k) + (second == k));
            }
            double *out = records_.data() + slot++ * width;
            for (int c = 0; c < width; ++c) {
                out[c] += product * record[c];
            }
        };
        add(-1, -1);
        for (int k = 0; k < axes_ && derivatives; ++k) {
            add(k, -1);
        }
        for (int k = 0; k < axes_ && derivatives; ++k) {
            for (int l = k; l < axes_; ++l) {
                add(k, l);
            }
        }
        for (int k = axes_; k-- > 0 && ++at[static_cast<size_t>(k)] > piece.degree(k);) {
            at[static_cast<size_t>(k)] = 0;
        }
    }
    const auto record = [&](int slot) { return records_.data() + slot * width; };
    const double w = record(0)[dim_];
    for (int c = 0; c < dim_; ++c) {
        double *x = values_.data() + c;
        x[0] = record(0)[c] / w;
        for (int k = 0; k < axes_ && derivatives; ++k) {
            x[(1 + k) * dim_] = (record(1 + k)[c] - x[0] * record(1 + k)[dim_]) / w;
        }
        int slot = 1 + axes_;
        for (int k = 0; k < axes_ && derivatives; ++k) {
            for (int l = k; l < axes_; ++l, ++slot) {
                x[slot * dim_] = (record(slot)[c] - x[(1 + k) * dim_] * record(1 + l)[dim_] -
                                  x[(1 + l) * dim_] * record(1 + k)[dim_] - x[0] * record(slot)[dim_]) /
                                 w;
            }
        }
    }
}

// Half the square of the distance; with derivatives also its gradient, the matrix of second derivatives and
// the part of it that holds for a distance of 0.
double PairDescent::evaluate(const pieces::BezierPiece &a, const pieces::BezierPiece &b, const PairPlace &at,
                             bool derivatives) {
    a_.evaluate(a, at.a, derivatives);
    b_.evaluate(b, at.b, derivatives);
    const int dim = a.dim(), p = a.axes(), n = p + b.axes();
    difference_.resize(static_cast<size_t>(dim));
    for (int c = 0; c < dim; ++c) {
        difference_[static_cast<size_t>(c)] = a_.value()[c] - b_.value()[c];
    }
    const double *d = difference_.data();
    for (int i = 0; i < n && derivatives; ++i) {
        const auto r = static_cast<size_t>(i);
        const double *di = i < p ? a_.first(i) : b_.first(i - p);
        gradient_[r] = (i < p ? 1 : -1) * dot(d, di, dim);
        for (int j = i; j < n; ++j) {
            const auto c = static_cast<size_t>(j);
            const double *dj = j < p ? a_.first(j) : b_.first(j - p);
            const double product = ((i < p) == (j < p) ? 1 : -1) * dot(di, dj, dim);
            double bend = 0;
            if (j < p) {
                bend = dot(d, a_.second(i, j), dim);
            } else if (i >= p) {
                bend = -dot(d, b_.second(i - p, j - p), dim);
            }
            metric_[r][c] = metric_[c][r] = product;
            curvature_[r][c] = curvature_[c][r] = product + bend;
        }
    }
    return dot(d, d, dim) / 2;
}

bool PairDescent::step(const pieces::BezierPiece &a, const pieces::BezierPiece &b, PairPlace &at,
                       double &square) {
    const int p = a.axes(), n = p + b.axes();
    const auto place = [p](PairPlace &of, int i) -> double & {
        return i < p ? of.a[static_cast<size_t>(i)] : of.b[static_cast<size_t>(i - p)];
    };
    std::array<bool, most_parameters> free{};
    bool any = false;
    for (int i = 0; i < n; ++i) {
        const auto r = static_cast<size_t>(i);
        const double t = place(at, i);
        free[r] = metric_[r][r] > 0 && !(t <= 0 && gradient_[r] > 0) && !(t >= 1 && gradient_[r] < 0);
        any = any || free[r];
    }
    for (int tried = 0; any && tried < most_dampings; ++tried) {
        const double damping = tried == 0 ? 0 : std::ldexp(1e-4, 3 * (tried - 1));
        Vector x;
        if (!solve(curvature_, metric_, damping, gradient_, free, n, x)) {
            continue;
        }
        PairPlace next{at.a, at.b, 0, {}, {}};
        double moved = 0;
        for (int i = 0; i < n; ++i) {
            double &t = place(next, i);
            const double before = t;
            t = std::clamp(t + x[static_cast<size_t>(i)], 0.0, 1.0);
            moved = std::max(moved, std::abs(t - before));
        }
        if (moved == 0) {
            return false;
        }
        const double found = evaluate(a, b, next, false);
        if (found < square) {
            const bool more = found < square * (1 - 4 * eps);
            square = found;
            at.a = next.a;
            at.b = next.b;
            return more;
        }
    }
    return false;
}

void PairDescent::run(const pieces::BezierPiece &a, const pieces::BezierPiece &b, PairPlace &at) {
    double square = evaluate(a, b, at, true);
    for (int i = 0; i < most_steps && square > 0 && step(a, b, at, square); ++i) {
        evaluate(a, b, at, true);
    }
    evaluate(a, b, at, false);
    at.from.assign(a_.value(), a_.value() + a.dim());
    at.to.assign(b_.value(), b_.value() + b.dim());
    at.distance = distance(at.from.data(), at.to.data(), a.dim());
}

} // namespace nrb::closest
