// SPDX-License-Identifier: MIT
#include "build/coons/coons_patch.h"

#include "build/coons/blended_net.h"

#include <algorithm>

namespace nrb::build {

namespace {

// A corner matrix as an axis sees it: entry (i, j) belongs to end j of function i.
using Entry = const double *(*)(const CornerMatrix &, int, int);

const double *by_row(const CornerMatrix &m, int i, int j) {
    return m.at(i, j);
}
const double *by_column(const CornerMatrix &m, int i, int j) {
    return m.at(j, i);
}

// What function i lacks to have the data of m at its ends: the differences times the blending functions.
std::vector<double> correction(const BlendAxis &along, const CornerMatrix &own, const CornerMatrix &m, int i,
                               Entry entry) {
    const auto dim = static_cast<size_t>(m.dim());
    std::vector<double> total(along.functions[0].size()), change(dim);
    for (size_t j = 0; j < along.blends.size(); ++j) {
        const double *wanted = entry(m, i, static_cast<int>(j));
        std::transform(wanted, wanted + dim, entry(own, i, static_cast<int>(j)), change.begin(),
                       std::minus());
        if (std::ranges::any_of(change, [](double x) { return x != 0; })) {
            add_product(along.blends[j], change, total);
        }
    }
    return total;
}

// Makes the functions along an axis agree with m at the ends. The values there are copies of those of m, bit
// for bit.
void correct(BlendAxis &along, const CornerMatrix &own, const CornerMatrix &m, Entry entry) {
    const auto dim = static_cast<size_t>(m.dim());
    for (size_t i = 0; i < along.functions.size(); ++i) {
        std::vector<double> &function = along.functions[i];
        const auto row = static_cast<int>(i);
        std::ranges::transform(function, correction(along, own, m, row, entry), function.begin(),
                               std::plus());
        std::copy_n(entry(m, row, 0), dim, function.begin());
        std::copy_n(entry(m, row, 1), dim, function.end() - static_cast<std::ptrdiff_t>(dim));
    }
}

// B_j minus the blend of its data at its ends: 0 in the margins.
std::vector<std::vector<double>> rests(const BlendAxis &u, const CornerMatrix &m) {
    const auto dim = static_cast<size_t>(m.dim());
    std::vector<std::vector<double>> rests = u.functions;
    for (size_t j = 0; j < rests.size(); ++j) {
        for (size_t i = 0; i < u.blends.size(); ++i) {
            const double *corner = m.at(static_cast<int>(i), static_cast<int>(j));
            std::vector<double> less(corner, corner + dim);
            std::ranges::transform(less, less.begin(), std::negate());
            add_product(u.blends[i], less, rests[j]);
        }
        clear_margins(u, dim, rests[j]);
    }
    return rests;
}

// Sets the layers in the margins of v but not of u, which depend only on the functions of u.
void set_margins(const BlendAxis &u, const BlendAxis &v, size_t dim, std::vector<double> &net) {
    const auto nu = static_cast<size_t>(u.count()), nv = static_cast<size_t>(v.count());
    for (size_t k = u.margin(); k + u.margin() < nu; ++k) {
        for (size_t l = 0; l < nv; ++l) {
            if (v.in_margin(l)) {
                double *point = net.data() + (k * nv + l) * dim;
                std::fill_n(point, dim, 0);
                for (size_t j = 0; j < v.blends.size(); ++j) {
                    add_scaled(v.blends[j][l], u.functions[j].data() + k * dim, dim, point);
                }
            }
        }
    }
}

} // namespace

SplinePtr coons_patch(BlendAxis u, BlendAxis v, const CornerPair &own, const CornerMatrix &m, Form form) {
    correct(u, own.along0, m, by_column);
    correct(v, own.along1, m, by_row);
    const auto dim = static_cast<size_t>(m.dim());
    const std::vector<std::vector<double>> rest = rests(u, m);
    std::vector<double> net = net_of_zeros({&u, &v}, m.dim());
    const size_t row = static_cast<size_t>(v.count()) * dim;
    for (size_t k = 0; k < static_cast<size_t>(u.count()); ++k) {
        double *layer = net.data() + k * row;
        for (size_t i = 0; i < u.blends.size(); i += 2) {
            add_scaled_pair(u.blends[i][k], v.functions[i].data(), u.blends[i + 1][k],
                            v.functions[i + 1].data(), row, layer);
        }
        for (size_t j = 0; j < v.blends.size() && !u.in_margin(k); j += 2) {
            add_product_pair(v.blends[j], rest[j].data() + k * dim, v.blends[j + 1],
                             rest[j + 1].data() + k * dim, dim, layer);
        }
    }
    set_margins(u, v, dim, net);
    return blended_spline({&u, &v}, m.dim(), form, std::move(net));
}

} // namespace nrb::build
