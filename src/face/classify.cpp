// SPDX-License-Identifier: MIT
#include "base/watch.h"
#include "eval/evaluate.h"
#include "face/face.h"
#include "face/trims/near.h"

#include <algorithm>
#include <cmath>

namespace nrb::face {

namespace {

constexpr int64_t block = 64;
constexpr int64_t work_of_a_place = 100; // multiply-adds, about

// Finds places near the boundary, in the metric of the surface at each of them.
class Nearness {
public:
    Nearness(const Face &face, double tolerance)
        : face_(face), tolerance_(tolerance), dim_(face.surface()->dim()),
          jets_(static_cast<size_t>(block * 3 * dim_)) {}

    // Sets the sides of places to 0 that count as being on the boundary. places: of the plane that covers the
    // domain; the metric at a place beyond an open axis is that at the nearest place of the domain.
    void mark(const std::vector<Point2> &places, const std::vector<int64_t> &numbers, int32_t *sides) {
        const auto count = std::ssize(places);
        inside_.clear();
        for (const Point2 &x : places) {
            inside_.push_back(face_.covering().in_domain(x));
        }
        const int width = 3 * dim_;
        eval::evaluate_points(*face_.surface(), {}, 1, {inside_.front().data(), count, 2, 2, 1},
                              {jets_.data(), count, width, width, 1});
        for (size_t i = 0; i < places.size(); ++i) {
            const double *jet = jets_.data() + i * static_cast<size_t>(width);
            const Metric metric = Metric::of(jet + dim_, jet + 2 * dim_, dim_, tolerance_);
            if (near(places[i], metric)) {
                sides[numbers[i]] = 0;
            }
        }
    }

private:
    // Also finds pieces that are near across the seam of a closed axis.
    [[nodiscard]] bool near(const Point2 &x, const Metric &metric) const {
        const Point2 reach = metric.reach();
        const Point2 lower{x[0] - reach[0], x[1] - reach[1]}, upper{x[0] + reach[0], x[1] + reach[1]};
        const TrimMap &trims = face_.trims();
        return face_.covering().any_move(lower, upper, [&](const Point2 &move) {
            const Point2 at = moved(x, move);
            return trims.any_in(moved(lower, move), moved(upper, move), [&](const TrimPiece &piece) {
                return is_near(trims.pieces(), piece, at, metric);
            });
        });
    }

    const Face &face_;
    double tolerance_;
    int dim_;
    std::vector<Point2> inside_;
    std::vector<double> jets_;
};

} // namespace

void classify(const Face &face, const ConstRecords &params, double tolerance, int32_t *sides) {
    Nearness nearness(face, tolerance);
    std::vector<Point2> places;
    std::vector<int64_t> numbers;
    Steps steps(params.count / block + 1);
    for (int64_t first = 0; first < params.count; first += block) {
        places.clear();
        numbers.clear();
        for (int64_t i = first; i < std::min(first + block, params.count); ++i) {
            const Point2 x{params(i, 0), params(i, 1)};
            sides[i] = face.trims().side(x);
            if (tolerance > 0 && sides[i] != 0) {
                places.push_back(face.covering().canonical(x));
                numbers.push_back(i);
            }
        }
        if (!places.empty()) {
            nearness.mark(places, numbers, sides);
        }
        steps.next(block * work_of_a_place);
    }
}

} // namespace nrb::face
