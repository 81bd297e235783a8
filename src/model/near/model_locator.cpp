// SPDX-License-Identifier: MIT
#include "model/near/model_locator.h"

#include "base/watch.h"
#include "bounds/box.h"
#include "eval/evaluate.h"
#include "model/rays/face_place.h"

#include <cmath>

namespace nrb::model {

namespace {

constexpr int64_t work_of_a_visit = 30;

// With curves in the domain only, which are the same.
face::FacePtr face_in_whole(const face::Face &own, const Placement &placement) {
    face::FaceParts parts{placement.in_whole(own.surface()), own.loops(),
                          placement.growth_to_whole() * own.tolerance()};
    parts.keep_gaps = true;
    for (face::Loop &loop : parts.loops) {
        for (face::Coedge &coedge : loop) {
            coedge.edge = nullptr;
        }
    }
    return std::make_shared<const face::Face>(std::move(parts), nullptr);
}

Vector3 point_of(const Spline &surface, const closest::Foot &foot) {
    eval::AxisRules rules;
    for (size_t k = 0; k < 2; ++k) {
        rules[k].left = (foot.left >> k & 1U) != 0;
    }
    std::array<double, 3> x{};
    eval::evaluate_points(surface, rules, 0, {foot.params.data(), 1, 2, 2, 1}, {x.data(), 1, 3, 3, 1});
    return {x[0], x[1], x[2]};
}

} // namespace

ModelLocator::Moved &ModelLocator::moved(int32_t placed) {
    std::unique_ptr<Moved> &own = moved_[placed];
    if (own == nullptr) {
        const Placement &placement = scene_.placement(scene_.face(placed));
        const face::Face &face = this->face(scene_.face(placed).face);
        const double size = face_box(face).magnitude();
        own = std::make_unique<Moved>(face_in_whole(face, placement), placement.rounding(size));
    }
    return *own;
}

closest::Foot ModelLocator::foot(int32_t number, const Vector3 &x, double tolerance, double far) {
    const PlacedFace &placed = scene_.face(number);
    if (scene_.placement(placed).keeps_ratios()) {
        return foot_in_part(placed, x, tolerance, far);
    }
    const double at[] = {x.x, x.y, x.z};
    Moved &own = moved(number);
    closest::Foot foot = own.locator.nearest(at, tolerance, far + own.rounding);
    foot.noise += own.rounding;
    return foot;
}

closest::Foot ModelLocator::foot_in_part(const PlacedFace &placed, const Vector3 &x, double tolerance,
                                         double far) {
    auto &own = locators_[static_cast<size_t>(placed.face)];
    if (own == nullptr) {
        own = std::make_unique<face::FaceLocator>(face(placed.face));
    }
    const Placement &placement = scene_.placement(placed);
    const Vector3 local = placement.moved(x);
    const double at[] = {local.x, local.y, local.z}, error = placement.error(x),
                 scale = placement.growth_to_whole(), condition = scale * placement.growth_to_part();
    closest::Foot foot =
        own->nearest(at, tolerance / scale, condition * placement.growth_to_part() * far + error);
    foot.distance *= scale;
    foot.noise = scale * (foot.noise + error) + (condition - 1) * foot.distance;
    return foot;
}

// The nearest one so far.
class ModelLocator::Nearest {
public:
    [[nodiscard]] double limit() const noexcept { return best_.foot.distance; }
    void add(const closest::Foot &foot, const PlacedFace &placed) noexcept {
        sure_ = sure_ && (foot.status & closest::closest_certified) != 0;
        if (best_.face < 0 || foot.distance < best_.foot.distance) {
            best_ = {foot, {}, placed.face, placed.instance};
        }
    }
    void leave_out() noexcept { sure_ = false; }
    // If there is no face it is proven to be infinitely far away.
    [[nodiscard]] ModelFoot found() const noexcept {
        ModelFoot result = best_;
        result.foot.status &= ~closest::closest_certified;
        result.foot.status |= sure_ ? closest::closest_certified : 0;
        return result;
    }
    [[nodiscard]] bool any() const noexcept { return best_.face >= 0; }

private:
    static closest::Foot nowhere() noexcept {
        closest::Foot foot;
        foot.params.fill(nan_value);
        foot.distance = infinity;
        return foot;
    }
    ModelFoot best_{nowhere(), {nan_value, nan_value, nan_value}};
    bool sure_ = true;
};

ModelFoot ModelLocator::nearest(const Vector3 &x, double tolerance) {
    Nearest nearest;
    const int64_t visits = scene_.tree().walk_from(
        x, [&] { return nearest.limit(); },
        [&](int32_t i) {
            if (nearest.any() && work_ended()) {
                return nearest.leave_out();
            }
            nearest.add(foot(i, x, tolerance, nearest.limit()), scene_.face(i));
        });
    count_work(work_of_a_visit * visits);
    ModelFoot found = nearest.found();
    if (found.face >= 0) {
        settle(found, x, tolerance);
    }
    return found;
}

// The point, its distance, and whether what was proven of the foot holds for it.
void ModelLocator::settle(ModelFoot &found, const Vector3 &x, double tolerance) const {
    const Placement &placement = scene_.placement({found.face, found.instance, 0});
    closest::Foot &foot = found.foot;
    const Vector3 local = point_of(*face(found.face).surface(), foot);
    found.point = placement.in_whole(local);
    const double distance = length(found.point - x),
                 allowed = foot.distance + tolerance + foot.noise + placement.rounding(length(local));
    if ((foot.status & closest::closest_certified) != 0 &&
        !(distance <= allowed && std::isfinite(distance))) {
        foot.status ^= closest::closest_certified | closest::closest_coarse;
    }
    foot.distance = distance;
    foot.status |= static_cast<int32_t>(foot.left) * closest::closest_left;
}

} // namespace nrb::model
