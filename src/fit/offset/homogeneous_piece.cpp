// SPDX-License-Identifier: MIT
#include "fit/offset/homogeneous_piece.h"

#include "numeric/vector3.h"

namespace nrb::fit {

HomogeneousPieces::HomogeneousPieces(const Spline &spline, const pieces::BernsteinNet::Breaks &breaks,
                                     const std::vector<double> &centre)
    : net_(spline,
           pieces::centred_records(spline, centre, spline.rational(), pieces::weight_exponent(spline)),
           breaks, pieces::degrees_of(spline)) {}

HomogeneousPiece HomogeneousPieces::piece(int64_t i) const {
    BernsteinShape shape = net_.shape();
    shape.width = 1;
    const auto count = static_cast<size_t>(shape.coefficients());
    std::vector<double> weights(count, 1.0);
    HomogeneousPiece made{{shape, std::vector<double>(space_dim * count), {}}, {shape, {}, {}}};
    made.points.shape.width = space_dim;
    net_.copy(i, made.points.values.data(), weights.data());
    for (const double w : weights) {
        made.weight.errors.push_back(net_.weighted() ? net_.error() * w : 0);
        made.points.errors.insert(made.points.errors.end(), space_dim, net_.error() * net_.size(i) * w);
    }
    made.weight.values = std::move(weights);
    return made;
}

} // namespace nrb::fit
