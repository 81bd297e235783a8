// SPDX-License-Identifier: MIT
#include "mesh/border/under_segments.h"

#include "eval/evaluate.h"
#include "mesh/proof/distance.h"

#include <algorithm>

namespace nrb::mesh {

namespace {

// The number of segments whose samples are evaluated at once.
constexpr size_t most_segments = 256;
// Where a segment is sampled: at both ends, and in between.
constexpr std::array<double, 5> shares{0, 0.25, 0.5, 0.75, 1};

// The places of all samples in the plane that covers the domain: those on the curve, then those on the
// segments between the same ends.
std::vector<face::Point2> places(const Spline &curve, std::span<const double> params) {
    const size_t count = params.size() - 1, n = shares.size();
    std::vector<double> at;
    for (size_t i = 0; i < count; ++i) {
        for (const double share : shares) {
            at.push_back(params[i] * (1 - share) + params[i + 1] * share);
        }
    }
    std::vector<face::Point2> result(2 * count * n);
    const auto size = static_cast<int64_t>(at.size());
    eval::evaluate_points(curve, {}, 0, {at.data(), size, 1, 1, 1}, {result.front().data(), size, 2, 2, 1});
    for (size_t i = 0; i < count; ++i) {
        const face::Point2 &from = result[i * n], &to = result[i * n + n - 1];
        for (size_t k = 0; k < n; ++k) {
            const double share = shares[k];
            result[(count + i) * n + k] = {from[0] * (1 - share) + to[0] * share,
                                           from[1] * (1 - share) + to[1] * share};
        }
    }
    return result;
}

std::vector<Vector3> in_space(const face::Face &face, std::vector<face::Point2> places) {
    for (face::Point2 &x : places) {
        x = face.covering().in_domain(x);
    }
    const int dim = face.surface()->dim();
    const auto size = static_cast<int64_t>(places.size());
    std::vector<Vector3> result(places.size());
    eval::evaluate_points(*face.surface(), {}, 0, {places.front().data(), size, 2, 2, 1},
                          {&result.front().x, size, dim, 3, 1});
    return result;
}

void add_distances(const face::Face &face, const Spline &curve, std::span<const double> params,
                   std::vector<double> &out) {
    const size_t count = params.size() - 1, n = shares.size();
    const std::vector<Vector3> points = in_space(face, places(curve, params));
    for (size_t i = 0; i < count; ++i) {
        const auto on_curve = std::span(points).subspan(i * n, n),
                   on_chord = std::span(points).subspan((count + i) * n, n);
        double off_chord = 0, off_curve = 0;
        for (size_t k = 1; k + 1 < n; ++k) {
            off_chord = std::max(off_chord, distance_from_segment(on_chord[k], on_curve[0], on_curve[n - 1]));
            off_curve = std::max(off_curve, length(on_curve[k] - on_chord[k]));
        }
        out.push_back(off_chord + off_curve);
    }
}

} // namespace

std::vector<double> distances_under(const face::Face &face, const Spline &curve,
                                    std::span<const double> params) {
    std::vector<double> result;
    for (size_t first = 0; first + 1 < params.size(); first += most_segments) {
        add_distances(face, curve, params.subspan(first, std::min(most_segments + 1, params.size() - first)),
                      result);
    }
    return result;
}

} // namespace nrb::mesh
