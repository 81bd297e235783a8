// SPDX-License-Identifier: MIT
#include "mesh/domain/domain_mesher.h"

#include "base/watch.h"

#include <algorithm>
#include <cmath>

namespace nrb::mesh {

namespace {

// Rounds in which triangles that are better shaped, and therefore lie elsewhere, are proven and divided.
constexpr int most_proofs = 12;
// Further rounds where triangles are left: flips may then no longer replace near sides by far ones.
constexpr int near_proofs = 8;
// Least angles, in radians, above about this one leave no freedom for such rounds.
constexpr double most_kept_near = 0.4;

} // namespace

AngleRefinement DomainMesher::refinement() {
    const auto is_allowed = [this](int32_t from, int32_t to) {
        const bool turned = angle_ > 0 && length(sites_.normal(from) - sites_.normal(to)) > most_apart_;
        const double size = length(sites_.position(from) - sites_.position(to));
        return !turned && !(longest_ > 0 && size > longest_);
    };
    // By the height of the arc that has these normals at its ends. Without normals nothing is known, and the
    // side is allowed.
    const auto is_near = [this](int32_t from, int32_t to) {
        const Vector3 along = sites_.position(to) - sites_.position(from);
        return !(std::abs(dot(along, sites_.normal(to) - sites_.normal(from))) / 8 > chord_);
    };
    AngleRefinement result(cells_, sites_, {rule_.least_angle, grid_.scaled(1), least_, is_allowed, is_near});
    for (size_t i = 0; i < triangles_.size(); ++i) {
        if (triangles_.has(i)) {
            NetTriangle triangle{triangles_[i].sites};
            triangle.source = static_cast<int32_t>(i);
            for (size_t k = 0; k < 3; ++k) {
                triangle.sides[k].border = triangles_[i].border[k];
            }
            result.add(triangle);
        }
    }
    result.join();
    return result;
}

// Replaces triangles that are gone by the new ones. A cell that loses a triangle no longer counts as one.
void DomainMesher::take(AngleRefinement &refinement) {
    for (const int32_t source : refinement.net().dropped()) {
        const auto at = static_cast<size_t>(source);
        if (const int32_t cell = triangles_[at].cell; cell >= 0) {
            states_[static_cast<size_t>(cell)].places = 0;
        }
        triangles_.remove({static_cast<int32_t>(at), 1});
    }
    refinement.clear_dropped();
    const SiteNet &net = refinement.net();
    for (int32_t t = 0; t < net.size(); ++t) {
        if (net[t].source < 0) {
            SiteTriangle triangle{net[t].sites};
            for (size_t k = 0; k < 3; ++k) {
                triangle.border[k] = net[t].sides[k].border;
                triangle.fixed[k] = net[t].sides[k].stays;
            }
            refinement.set_source(t, static_cast<int32_t>(triangles_.size()));
            triangles_.add(triangle, mesh_triangle(triangle));
        }
    }
}

// Divides triangles that are over the limits. Returns whether anything is new.
bool DomainMesher::divide_far(AngleRefinement &refinement) {
    bool any = false;
    const int32_t count = refinement.net().size();
    for (int32_t t = 0; t < count; ++t) {
        const int32_t source = refinement.net()[t].source;
        const auto i = static_cast<size_t>(source);
        if (source < 0 || !is_to_divide(i)) {
            continue;
        }
        const AngleRefinement::Divided divided = refinement.divide(t, least_split(i));
        any = any || divided.done;
        if (divided.border >= 0) {
            add_weak(divided.border, parts_for(i));
        }
    }
    return any;
}

// Distances come first: if refinement ends with larger ones than allowed, the result is the mesh before it.
// If the border may change, half of the work is left for a mesh with another border. Returns whether
// refinement came to an end before the work did.
bool DomainMesher::keep_least_angle() {
    if (!(rule_.least_angle > 0)) {
        return true;
    }
    std::optional<PartOfWork> half;
    if (domain_.change_border) {
        half.emplace();
    }
    DomainMesh before, now;
    finish(judge(before), before);
    refine_angles();
    const double allowed = std::max({chord_, before.from_shape, before.from_mesh});
    if (!judge(now) && std::max(now.from_shape, now.from_mesh) > allowed) {
        before_angles_ = std::move(before);
        before_angles_->reached = false;
    }
    return !work_ended();
}

// New triangles are proven like all others. Where new vertices made distances too large, more of them are
// added, and then angles are refined again.
void DomainMesher::refine_angles() {
    AngleRefinement refinement = this->refinement();
    const int rounds = most_proofs + (rule_.least_angle <= most_kept_near ? near_proofs : 0);
    for (int round = 0;; ++round) {
        if (round == most_proofs) {
            refinement.keep_near();
        }
        refinement.run();
        take(refinement);
        sites_.evaluate();
        prove();
        if (round == rounds || work_ended() || !divide_far(refinement)) {
            break;
        }
    }
    for (int32_t t = 0; t < refinement.net().size(); ++t) {
        has_small_angles_ = has_small_angles_ || refinement.fails(t);
    }
}

} // namespace nrb::mesh
