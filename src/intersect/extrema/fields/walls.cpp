// SPDX-License-Identifier: MIT
#include "intersect/extrema/fields/walls.h"

#include "base/watch.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace nrb::intersect {

namespace {

constexpr int64_t work_of_two_pieces = 16000;

RoundedPolynomial times_power_of_two(RoundedPolynomial f, int exponent) {
    for (size_t i = 0; i < f.values.size(); ++i) {
        f.values[i] = std::ldexp(f.values[i], exponent);
        f.errors[i] = std::ldexp(f.errors[i], exponent);
    }
    return f;
}

} // namespace

Walls::Walls(const Spline &spline, const GradientField &field)
    : field_(field), maker_(spline, whole_domain(spline), std::vector<double>{0}) {}

// f = A / w 2^e on both sides: of the sign of A w' 2^e - A' w 2^e'.
int Walls::sign(const Stratum &stratum, const PieceIndex &index, int k) const {
    count_work(work_of_two_pieces);
    const Stratum other = stratum.from_other_side(k);
    const auto piece = maker_.piece(field_.number(index)),
               beyond = maker_.piece(field_.number(across(field_, stratum, index, k)));
    if (!piece.positive || !beyond.positive) {
        return 0;
    }
    const auto product = [&](const RoundedPolynomial &points, const RoundedPolynomial &weight, bool here) {
        const RoundedPolynomial f =
            on_stratum(points, here ? piece : beyond, here ? stratum : other, field_.axes());
        const RoundedPolynomial w =
            on_stratum(weight, here ? beyond : piece, here ? other : stratum, field_.axes());
        return f * w;
    };
    const int least = std::min(0, piece.exponent - beyond.exponent),
              other_least = std::min(0, beyond.exponent - piece.exponent);
    RoundedPolynomial difference =
        times_power_of_two(product(piece.points, beyond.weight, true), least) -
        times_power_of_two(product(beyond.points, piece.weight, false), other_least);
    for (double &error : difference.errors) {
        error += underflow;
    }
    const int found = certain_sign(difference);
    return stratum.upper_end(k) ? -found : found;
}

bool Walls::is_jump(const Stratum &stratum, int k) const noexcept {
    return stratum.is_fixed(k) &&
           field_.joint(k, stratum.axes[static_cast<size_t>(k)].joint) == JointKind::jump;
}

bool Walls::regular(const Stratum &stratum, const PieceIndex &index) const {
    bool any = false;
    for (int along = 0; along < field_.axes(); ++along) {
        if (is_jump(stratum, along)) {
            any = true;
            if (common_sign(stratum, index, along, 0) != 0) {
                return true;
            }
        }
    }
    return !any;
}

// Of the wall along one axis at all limits along axis k and those after it; 0: there is none.
int Walls::common_sign(const Stratum &stratum, const PieceIndex &index, int along, int k) const {
    if (k == field_.axes()) {
        return sign(stratum, index, along);
    }
    const int found = common_sign(stratum, index, along, k + 1);
    if (found == 0 || k == along || !is_jump(stratum, k)) {
        return found;
    }
    const int beyond =
        common_sign(stratum.from_other_side(k), across(field_, stratum, index, k), along, k + 1);
    return found == beyond ? found : 0;
}

} // namespace nrb::intersect
