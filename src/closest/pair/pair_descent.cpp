// SPDX-License-Identifier: MIT
#include "closest/pair/pair_descent.h"

#include "base/watch.h"
#include "bernstein/de_casteljau.h"
#include "numeric/norm.h"

#include <algorithm>
#include <functional>

namespace nrb::closest {

namespace {

constexpr int most_steps = 60;
constexpr int64_t work_of_a_factor = 4; // per coefficient
constexpr int row_length = max_degree + 1, row_size = 3 * row_length;

// Calls visit(slot, first, second) for the value, the first derivatives and the second derivatives; first and
// second are the axes of differentiation, -1 for none.
template <class Visit>
void for_slots(int axes, bool derivatives, Visit &&visit) {
    int slot = 0;
    visit(slot++, -1, -1);
    for (int k = 0; k < axes && derivatives; ++k) {
        visit(slot++, k, -1);
    }
    for (int k = 0; k < axes && derivatives; ++k) {
        for (int l = k; l < axes; ++l) {
            visit(slot++, k, l);
        }
    }
}

double &parameter(PairPlace &at, bool of_a, size_t k) noexcept {
    return of_a ? at.a[k] : at.b[k];
}

} // namespace

const double *PieceJet::second(int k, int l) const noexcept {
    const int place = k == 0 ? l : k == 1 ? axes_ + l - 1 : 5; // in the order 00, 01, 02, 11, 12, 22
    return values_.data() + (1 + axes_ + place) * dim_;
}

void PieceJet::set_rows(const pieces::BezierPiece &piece, const pieces::LocalParam &place) {
    rows_.resize(static_cast<size_t>(max_axes * row_size));
    for (int k = 0; k < axes_; ++k) {
        bernstein_functions(piece.degree(k), place[static_cast<size_t>(k)], 2, row_length,
                            rows_.data() + k * row_size);
    }
}

double PieceJet::factor(const std::array<int, max_axes> &at, int first, int second) const noexcept {
    double product = 1;
    for (int k = 0; k < axes_; ++k) {
        const int order = (first == k ? 1 : 0) + (second == k ? 1 : 0), i = at[static_cast<size_t>(k)];
        product *= rows_[static_cast<size_t>(k * row_size + order * row_length + i)];
    }
    return product;
}

void PieceJet::contract(const pieces::BezierPiece &piece, bool derivatives) {
    const int width = dim_ + 1;
    count_work(2 * piece.coefficients() * (std::ssize(records_) + work_of_a_factor * axes_));
    std::array<int, max_axes> at{};
    for (int64_t i = 0; i < piece.coefficients(); ++i) {
        const double *record = piece.record(i);
        for_slots(axes_, derivatives, [&](int slot, int first, int second) {
            const double product = factor(at, first, second);
            double *out = records_.data() + slot * width;
            for (int c = 0; c < width; ++c) {
                out[c] += product * record[c];
            }
        });
        for (int k = axes_; k-- > 0 && ++at[static_cast<size_t>(k)] > piece.degree(k);) {
            at[static_cast<size_t>(k)] = 0;
        }
    }
}

// The quotient rule.
void PieceJet::divide(bool derivatives) {
    const auto record = [&](int slot) { return records_.data() + slot * (dim_ + 1); };
    const double w = record(0)[dim_];
    for_slots(axes_, derivatives, [&](int slot, int k, int l) {
        const double *from = record(slot);
        for (int c = 0; c < dim_; ++c) {
            double *x = values_.data() + c;
            double sum = from[c];
            if (l >= 0) {
                sum = sum - x[(1 + k) * dim_] * record(1 + l)[dim_] - x[(1 + l) * dim_] * record(1 + k)[dim_];
            }
            x[slot * dim_] = (k < 0 ? sum : sum - x[0] * from[dim_]) / w;
        }
    });
}

void PieceJet::evaluate(const pieces::BezierPiece &piece, const pieces::LocalParam &place, bool derivatives) {
    axes_ = piece.axes();
    dim_ = piece.dim();
    const int slots = derivatives ? 1 + axes_ + axes_ * (axes_ + 1) / 2 : 1;
    values_.resize(static_cast<size_t>(slots * dim_));
    records_.assign(static_cast<size_t>(slots * (dim_ + 1)), 0.0);
    set_rows(piece, place);
    contract(piece, derivatives);
    divide(derivatives);
}

void PairDescent::set_axes(const pieces::BezierPiece &a, const pieces::BezierPiece &b) {
    axes_.clear();
    for (const bool of_a : {true, false}) {
        const pieces::BezierPiece &piece = of_a ? a : b;
        for (int k = 0; k < piece.axes(); ++k) {
            if (piece.degree(k) > 0) {
                axes_.push_back({of_a, static_cast<size_t>(k)});
            }
        }
    }
}

const double *PairDescent::first(const Axis &axis) const noexcept {
    return (axis.of_a ? a_ : b_).first(static_cast<int>(axis.k));
}

double PairDescent::bend(const double *difference, const Axis &i, const Axis &j) const noexcept {
    if (i.of_a != j.of_a) {
        return 0;
    }
    const PieceJet &jet = i.of_a ? a_ : b_;
    const double product = dot(difference, jet.second(static_cast<int>(i.k), static_cast<int>(j.k)),
                               static_cast<int>(difference_.size()));
    return i.of_a ? product : -product;
}

PairDescent::Jet PairDescent::jet(const pieces::BezierPiece &a, const pieces::BezierPiece &b,
                                  const PairPlace &at) {
    a_.evaluate(a, at.a, true);
    b_.evaluate(b, at.b, true);
    const int dim = a.dim();
    difference_.resize(static_cast<size_t>(dim));
    std::transform(a_.value(), a_.value() + dim, b_.value(), difference_.begin(), std::minus<>());
    const double *d = difference_.data();
    Jet jet;
    jet.square = dot(d, d, dim);
    for (size_t i = 0; i < axes_.size(); ++i) {
        const double *di = first(axes_[i]);
        jet.gradient[i] = (axes_[i].of_a ? 1 : -1) * dot(d, di, dim);
        for (size_t j = i; j < axes_.size(); ++j) {
            const int sign = axes_[i].of_a == axes_[j].of_a ? 1 : -1;
            jet.metric[i][j] = jet.metric[j][i] = sign * dot(di, first(axes_[j]), dim);
            jet.curvature[i][j] = jet.curvature[j][i] = bend(d, axes_[i], axes_[j]);
        }
    }
    return jet;
}

void PairDescent::run(const pieces::BezierPiece &a, const pieces::BezierPiece &b, PairPlace &at) {
    set_axes(a, b);
    std::array<double, 2 * max_axes> places{};
    for (size_t i = 0; i < axes_.size(); ++i) {
        places[i] = parameter(at, axes_[i].of_a, axes_[i].k);
    }
    const auto jet_at = [&](const std::array<double, 2 * max_axes> &all) {
        for (size_t i = 0; i < axes_.size(); ++i) {
            parameter(at, axes_[i].of_a, axes_[i].k) = all[i];
        }
        return jet(a, b, at);
    };
    const pieces::ParameterBox<2 * max_axes> box;
    pieces::DampedDescent<2 * max_axes, decltype(jet_at)>(static_cast<int>(axes_.size()), box, 1, 0, jet_at)
        .run(places, most_steps);
    jet_at(places);
    at.from.assign(a_.value(), a_.value() + a.dim());
    at.to.assign(b_.value(), b_.value() + b.dim());
    at.distance = distance(at.from.data(), at.to.data(), a.dim());
}

} // namespace nrb::closest
