// SPDX-License-Identifier: MIT
#include "build/coons/blend_sum.h"

#include "base/representable.h"
#include "bounds/deviation.h"
#include "build/coons/blend_axis.h"
#include "build/coons/corner.h"
#include "build/coons/volume_edge.h"
#include "reduce/compatible.h"
#include "refine/algebra/polynomial.h"
#include "refine/algebra/product.h"
#include "refine/forms/homogeneous.h"
#include "refine/parts/iso.h"

#include <algorithm>

namespace nrb::build {

namespace {

SplinePtr checked_terms(Spline::Axes axes, int dim, std::vector<double> points) {
    require_representable(points, "terms of the volume");
    return refine::polynomial_spline(std::move(axes), dim, std::move(points));
}

std::vector<SplinePtr> made_compatible(const SplinePtr &a, const SplinePtr &b) {
    const SplinePtr both[] = {a, b};
    return reduce::make_compatible(both, 0, false).splines;
}

SplinePtr plus(const SplinePtr &a, const SplinePtr &b) {
    if (a == nullptr) {
        return b;
    }
    const std::vector<SplinePtr> both = made_compatible(a, b);
    std::vector<double> points(both[0]->points().begin(), both[0]->points().end());
    std::ranges::transform(points, both[1]->points(), points.begin(), std::plus());
    return checked_terms(both[0]->knot_vectors(), a->dim(), std::move(points));
}

// A face, an edge or a corner, as numerators over weights.
struct HomogeneousNet {
    Spline::Axes axes;
    std::vector<double> numerators;
    std::vector<double> weights; // empty: 1
};

HomogeneousNet homogeneous_net(const Spline &spline) {
    const double first = spline.weight(0);
    if (first == 0) {
        fail(Status::weights_vanish, "faces: a corner lies at infinity");
    }
    HomogeneousNet part{spline.knot_vectors(), refine::homogeneous_points(spline), {}};
    std::vector<double> numerators;
    for (size_t i = 0; i < part.numerators.size(); ++i) {
        const bool weight = (i + 1) % (static_cast<size_t>(spline.dim()) + 1) == 0;
        (weight ? part.weights : numerators).push_back(part.numerators[i] / first);
    }
    part.numerators = std::move(numerators);
    if (std::ranges::all_of(part.weights, [](double w) { return w == 1; })) {
        part.weights.clear();
    }
    return part;
}

// What an axis of the volume is in a term: free, or fixed at its start or end.
enum class Stand { free, start, end };
using Stands = std::array<Stand, 3>;

// The records of a face, edge or corner, times a factor, among the layers of a volume. Along a fixed axis the
// volume has two layers, of which the one at the other end becomes 0, or a single one.
std::vector<double> spread(const std::vector<double> &records, int width,
                           const std::array<int64_t, 3> &counts, const Stands &stands, double factor) {
    std::vector<double> result;
    std::array<int64_t, 3> at{};
    for (at[0] = 0; at[0] < counts[0]; ++at[0]) {
        for (at[1] = 0; at[1] < counts[1]; ++at[1]) {
            for (at[2] = 0; at[2] < counts[2]; ++at[2]) {
                int64_t record = 0;
                bool here = true;
                for (size_t k = 0; k < 3; ++k) {
                    record = stands[k] == Stand::free ? record * counts[k] + at[k] : record;
                    here = here && (stands[k] == Stand::free || counts[k] == 1 ||
                                    (at[k] == 1) == (stands[k] == Stand::end));
                }
                for (int c = 0; c < width; ++c) {
                    result.push_back(here ? factor * records[static_cast<size_t>(record * width + c)] : 0);
                }
            }
        }
    }
    return result;
}

class BlendSum {
public:
    BlendSum(int dim, const std::array<Interval, 3> &domains) : dim_(dim), domains_(domains) {}

    // Adds factor times a face, edge or corner, times the linear blending functions of the fixed axes.
    void add(const HomogeneousNet &part, const Stands &stands, double factor) {
        const SplinePtr term = over_volume(part, part.numerators, dim_, stands, 1, factor);
        const SplinePtr denominator =
            part.weights.empty() ? nullptr : over_volume(part, part.weights, 1, stands, 0, 1);
        const auto found = std::ranges::find_if(groups_, [&](const Group &group) {
            return group.denominator == nullptr || denominator == nullptr
                       ? group.denominator == denominator
                       : same_function(group.denominator, denominator);
        });
        if (found == groups_.end()) {
            groups_.push_back({denominator, term});
        } else {
            found->sum = plus(found->sum, term);
        }
    }

    [[nodiscard]] SplinePtr result(Form form) const {
        SplinePtr numerators;
        for (const Group &group : groups_) {
            numerators = plus(numerators, refine::times(group.sum, product_without(&group)));
        }
        const SplinePtr denominator = product_without(nullptr); // null if no term has a denominator
        std::vector<SplinePtr> both{numerators};
        if (denominator != nullptr) {
            both = made_compatible(numerators, denominator);
        }
        std::vector<double> records;
        const auto dim = static_cast<size_t>(dim_);
        for (size_t i = 0; i < both[0]->points().size() / dim; ++i) {
            const double *point = both[0]->points().data() + i * dim;
            records.insert(records.end(), point, point + dim);
            records.push_back(denominator != nullptr ? both[1]->points()[i] : 1);
        }
        return refine::from_records(both[0]->knot_vectors(), dim_, form, std::move(records));
    }

private:
    struct Group {
        SplinePtr denominator; // null: 1
        SplinePtr sum;
    };

    // A function of the free axes as a function of all axes, of the given degree along the fixed ones.
    [[nodiscard]] SplinePtr over_volume(const HomogeneousNet &part, const std::vector<double> &records,
                                        int width, const Stands &stands, int degree, double factor) const {
        Spline::Axes axes;
        std::array<int64_t, 3> counts{};
        size_t next = 0;
        for (size_t k = 0; k < 3; ++k) {
            if (stands[k] == Stand::free) {
                axes.push_back(part.axes[next++]);
            } else {
                std::vector<double> knots(static_cast<size_t>(degree) + 1, domains_[k].lower);
                knots.insert(knots.end(), static_cast<size_t>(degree) + 1, domains_[k].upper);
                axes.push_back(make_knot_vector(degree, std::move(knots)));
            }
            counts[k] = axes.back()->count();
        }
        return checked_terms(std::move(axes), width, spread(records, width, counts, stands, factor));
    }
    // The product of all denominators, or of all except that of a group.
    [[nodiscard]] SplinePtr product_without(const Group *left_out) const {
        SplinePtr result;
        for (const Group &group : groups_) {
            result = &group == left_out ? result : refine::times(result, group.denominator);
        }
        return result;
    }

    int dim_;
    std::array<Interval, 3> domains_;
    std::vector<Group> groups_;
};

// The curve of a clamped face at an end of one of its axes.
SplinePtr edge_curve(const Spline &face, int place, bool upper) {
    const Interval domain = face.axis(place).domain();
    return refine::iso(face, place, upper ? domain.upper : domain.lower, {});
}

// A proven bound of the distance between two curves at equal parameters; 0 if they are the same, bit for bit,
// once each is divided by its first weight.
double gap(const SplinePtr &a, const SplinePtr &b) {
    const HomogeneousNet one = homogeneous_net(*a), other = homogeneous_net(*b);
    const bool same = std::ranges::equal(a->axis(0).knots(), b->axis(0).knots()) &&
                      one.numerators == other.numerators && one.weights == other.weights;
    return same ? 0 : bounds::deviation(*a, *b).upper;
}

Stand stand(bool upper) noexcept {
    return upper ? Stand::end : Stand::start;
}

void add_faces(const std::vector<SplinePtr> &faces, BlendSum &sum) {
    for (size_t i = 0; i < face_count; ++i) {
        Stands stands{};
        stands[i / 2] = stand(i % 2 == 1);
        sum.add(homogeneous_net(*faces[i]), stands, 1);
    }
}

// Subtracts the edges, and adds the corners as the ends of those along the last axis.
void add_edges(const std::vector<SplinePtr> &faces, double tolerance, BlendSum &sum) {
    for (int k = 0; k < 3; ++k) {
        for (size_t i = 0; i < edges_of_axis; ++i) {
            const VolumeEdge edge(k, i);
            const SplinePtr own =
                edge_curve(*faces[edge.face()], FaceAxes(edge.face()).place(edge.second), edge.second_upper);
            const SplinePtr other = edge_curve(
                *faces[edge.other_face()], FaceAxes(edge.other_face()).place(edge.first), edge.first_upper);
            edge.check(gap(own, other), tolerance);
            Stands stands{};
            stands[static_cast<size_t>(edge.first)] = stand(edge.first_upper);
            stands[static_cast<size_t>(edge.second)] = stand(edge.second_upper);
            sum.add(homogeneous_net(*own), stands, -1);
            for (const bool upper : {false, true}) {
                stands[static_cast<size_t>(k)] = stand(upper);
                if (k == 2) {
                    sum.add({{}, end_jet(*own, upper).value, {}}, stands, 1);
                }
            }
        }
    }
}

} // namespace

SplinePtr sum_of_blends(const std::vector<SplinePtr> &faces, double tolerance) {
    const std::array<Interval, 3> domains = volume_domains(faces);
    std::vector<SplinePtr> clamped;
    for (size_t i = 0; i < face_count; ++i) {
        const FaceAxes axes(i);
        const SplinePtr half = clamped_over(faces[i], 0, domains[static_cast<size_t>(axes.first)]);
        clamped.push_back(clamped_over(half, 1, domains[static_cast<size_t>(axes.second)]));
    }
    BlendSum sum(faces[0]->dim(), domains);
    add_faces(clamped, sum);
    add_edges(clamped, tolerance, sum);
    return sum.result(refine::common_form(faces));
}

} // namespace nrb::build
