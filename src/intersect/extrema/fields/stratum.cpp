// SPDX-License-Identifier: MIT
#include "intersect/extrema/fields/stratum.h"

#include <utility>

namespace nrb::intersect {

namespace {

// What a stratum may be along one axis.
std::vector<StratumAxis> choices(const GradientField &field, int k) {
    std::vector<StratumAxis> list{{}};
    const bool periodic = field.axis(k).periodic();
    const int64_t last = periodic ? field.count(k) - 1 : field.count(k);
    for (int64_t i = 0; i <= last; ++i) {
        switch (field.joint(k, i)) {
        case JointKind::smooth:
            break;
        case JointKind::end:
            list.push_back({true, i, i == 0});
            break;
        case JointKind::jump:
            list.push_back({true, i, false});
            [[fallthrough]];
        case JointKind::kink:
            list.push_back({true, i, true});
            break;
        }
    }
    return list;
}

} // namespace

Strata::Strata(const GradientField &field) {
    for (int k = 0; k < max_axes; ++k) {
        choices_[static_cast<size_t>(k)] = k < field.axes() ? choices(field, k) : std::vector<StratumAxis>(1);
    }
}

int64_t Strata::count() const noexcept {
    return std::ssize(choices_[0]) * std::ssize(choices_[1]) * std::ssize(choices_[2]);
}

Stratum Strata::operator[](int64_t i) const noexcept {
    Stratum stratum;
    for (size_t k = 0; k < max_axes; ++k) {
        stratum.axes[k] = choices_[k][static_cast<size_t>(i % std::ssize(choices_[k]))];
        i /= std::ssize(choices_[k]);
    }
    return stratum;
}

std::vector<PieceIndex> pieces_of(const GradientField &field, const Stratum &stratum) {
    PieceIndex from{}, to{1, 1, 1};
    for (int k = 0; k < field.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        const StratumAxis &axis = stratum.axes[at];
        from[at] = axis.fixed ? field.beside(k, axis.joint, axis.from_above) : 0;
        to[at] = axis.fixed ? from[at] + 1 : field.count(k);
    }
    std::vector<PieceIndex> list;
    for (int64_t i = from[0]; i < to[0]; ++i) {
        for (int64_t j = from[1]; j < to[1]; ++j) {
            for (int64_t l = from[2]; l < to[2]; ++l) {
                list.push_back({i, j, l});
            }
        }
    }
    return list;
}

RoundedPolynomial on_stratum(RoundedPolynomial f, const pieces::HomogeneousPiece &piece,
                             const Stratum &stratum, int axes) {
    for (int k = 0; k < axes; ++k) {
        if (stratum.is_fixed(k)) {
            f = end_value(f, piece.axis(k), stratum.upper_end(k));
        }
    }
    return f;
}

PieceIndex across(const GradientField &field, const Stratum &stratum, PieceIndex index, int k) {
    const StratumAxis &axis = stratum.axes[static_cast<size_t>(k)];
    index[static_cast<size_t>(k)] = field.beside(k, axis.joint, !axis.from_above);
    return index;
}

Part range_of(const GradientField &field, const Stratum &stratum, const PieceIndex &home, const Part &box) {
    Part range{};
    for (int k = 0; k < field.axes(); ++k) {
        const auto at = static_cast<size_t>(k);
        if (stratum.is_fixed(k)) {
            range[at].lower = range[at].upper = field.parameter(k, stratum.axes[at].joint);
        } else {
            range[at] = field.parameters(k, home[at], box[at]);
        }
    }
    return range;
}

} // namespace nrb::intersect
