// SPDX-License-Identifier: MIT
#include "fit/offset/offset_net.h"

#include "fit/offset/offset_jet.h"

#include <algorithm>

namespace nrb::fit {

namespace {

// Builds the net row by row, so that the jets of all rows need not be stored at a time.
class NetRows {
public:
    NetRows(const Spline &surface, double distance, const PatchAxes &axes)
        : surface_(surface), distance_(distance),
          axes_(axes), sites_{sites_of(axes[0]), sites_of(axes[1])}, layers_{layers_of(axes[0]),
                                                                             layers_of(axes[1])} {}

    OffsetCandidate run() {
        points_.reserve(layers_[0].size() * layers_[1].size() * space_dim);
        auto layer = layers_[0].begin();
        for (size_t row = 0; row < sites_[0].size(); ++row) {
            read_row(sites_[0][row]);
            for (; layer != layers_[0].end() && layer->site == row; ++layer) {
                add_points(*layer);
            }
        }
        return {make_result({knots_of(axes_[0]), knots_of(axes_[1])}, space_dim, Form::polynomial,
                            std::move(points_)),
                jump_};
    }

private:
    void read_row(const Site &site) {
        const std::vector<TaylorVector> before = std::move(row_);
        row_.assign(sites_[1].size(), {});
        for (const bool left : {false, true}) {
            read_side(axes_[0].breaks[site.at], site.left, left);
        }
        for (size_t i = 1; i < row_.size(); ++i) {
            if (sites_[1][i - 1].at == sites_[1][i].at) {
                tell_jump(row_[i - 1], row_[i]);
            }
        }
        for (size_t i = 0; i < before.size() && site.at == last_; ++i) {
            tell_jump(before[i], row_[i]);
        }
        last_ = site.at;
    }
    // Reads the jets at those sites that are on one side of their breaks.
    void read_side(double u, bool left_u, bool left_v) {
        std::array<std::vector<double>, 2> params{{{u}, {}}};
        std::vector<size_t> places;
        for (size_t i = 0; i < sites_[1].size(); ++i) {
            if (sites_[1][i].left == left_v) {
                params[1].push_back(axes_[1].breaks[sites_[1][i].at]);
                places.push_back(i);
            }
        }
        const std::vector<TaylorVector> found = offset_jets(surface_, distance_, params, {left_u, left_v});
        for (size_t i = 0; i < places.size(); ++i) {
            row_[places[i]] = found[i];
        }
    }
    void tell_jump(const TaylorVector &a, const TaylorVector &b) noexcept {
        jump_ = std::max(jump_, length(a.at(0, 0) - b.at(0, 0)));
    }
    void add_points(const Layer &u) {
        for (const Layer &v : layers_[1]) {
            Vector3 sum;
            for (size_t i = 0; i < Taylor::count; ++i) {
                for (size_t j = 0; j < Taylor::count; ++j) {
                    sum = sum + u.factors[i] * v.factors[j] * row_[v.site].at(i, j);
                }
            }
            points_.insert(points_.end(), {sum.x, sum.y, sum.z});
        }
    }

    const Spline &surface_;
    double distance_;
    const PatchAxes &axes_;
    std::array<std::vector<Site>, 2> sites_;
    std::array<std::vector<Layer>, 2> layers_;
    std::vector<TaylorVector> row_; // at the sites of the other axis
    size_t last_ = static_cast<size_t>(-1);
    std::vector<double> points_;
    double jump_ = 0;
};

} // namespace

OffsetCandidate offset_candidate(const Spline &surface, double distance, const PatchAxes &axes) {
    return NetRows(surface, distance, axes).run();
}

} // namespace nrb::fit
