// SPDX-License-Identifier: MIT
#include "closest/curve/curve_best.h"

#include "bernstein/de_casteljau.h"

#include <algorithm>
#include <cmath>

namespace nrb::closest {

namespace {

std::vector<double> point_of(const CurveTree &tree, const CurvePlace &place) {
    const int lanes = tree.lanes();
    const double *records = tree.records(place.leaf);
    std::vector<double> b(records, records + (tree.degree() + 1) * lanes);
    evaluate(tree.degree(), lanes, place.s, b.data());
    const double w = b[static_cast<size_t>(lanes) - 1];
    b.resize(static_cast<size_t>(tree.dim()));
    std::for_each(b.begin(), b.end(), [w](double &x) { x /= w; });
    return b;
}

double square_between(const std::vector<double> &a, const std::vector<double> &b) noexcept {
    double sum = 0;
    for (size_t c = 0; c < a.size(); ++c) {
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    }
    return sum;
}

} // namespace

void BestPlaces::note(const CurvePlace &place) noexcept {
    const double key = sign_ * std::sqrt(place.square);
    if (!found() || sign_ * place.square < sign_ * best_.square) {
        if (found()) {
            add_rival(best_);
        }
        best_ = place;
        key_ = key;
        const double distance = sign_ * (key - margin_);
        goal_ = distance > 0 ? distance * distance : 0;
    } else if (key <= key_ + margin_) {
        add_rival(place);
    }
}

// Around the best point, points at a distance of about sqrt(2 * margin * distance) from it are as good to the
// margin. Only rivals that are well outside of this neighbourhood count as different points.
bool BestPlaces::unique() const {
    const int count = std::min(rival_count_, most_rivals);
    return std::none_of(rivals_.begin(), rivals_.begin() + count, [this](const CurvePlace &rival) {
        return sign_ * std::sqrt(rival.square) <= key_ + margin_ &&
               square_between(point_of(tree_, best_), point_of(tree_, rival)) >
                   64 * margin_ * (std::abs(key_) + margin_);
    });
}

} // namespace nrb::closest
