// SPDX-License-Identifier: MIT
#include "model/near/model_locator.h"

#include "base/watch.h"
#include "eval/evaluate.h"
#include "model/rays/face_place.h"

#include <algorithm>
#include <cmath>

namespace nrb::model {

namespace {

constexpr int64_t work_of_a_visit = 30;

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
        const face::FacePtr &face = model_.faces[static_cast<size_t>(scene_.face(placed).face)].face;
        own = std::make_unique<Moved>(
            std::make_shared<const face::Face>(face, placement.in_whole(face->surface()),
                                               placement.growth_to_whole() * face->tolerance()),
            placement.rounding(face_box(*face).magnitude()));
    }
    return *own;
}

closest::BoundedFoot ModelLocator::foot(int32_t number, const Vector3 &x, double tolerance, double far) {
    const PlacedFace &placed = scene_.face(number);
    if (scene_.placement(placed).keeps_ratios()) {
        return foot_in_part(placed, x, tolerance, far);
    }
    const double at[] = {x.x, x.y, x.z};
    Moved &own = moved(number);
    closest::BoundedFoot found = own.locator.nearest(at, tolerance, far + own.rounding);
    found.foot.noise += own.rounding;
    found.at_least -= own.rounding;
    return found;
}

closest::BoundedFoot ModelLocator::foot_in_part(const PlacedFace &placed, const Vector3 &x, double tolerance,
                                                double far) {
    auto &own = locators_[static_cast<size_t>(placed.face)];
    if (own == nullptr) {
        own = std::make_unique<face::FaceLocator>(face(placed.face));
    }
    const Placement &placement = scene_.placement(placed);
    const Vector3 local = placement.moved(x);
    const double at[] = {local.x, local.y, local.z}, error = placement.error(x),
                 scale = placement.growth_to_whole(), condition = scale * placement.growth_to_part();
    closest::BoundedFoot found =
        own->nearest(at, tolerance / scale, condition * placement.growth_to_part() * far + error);
    closest::Foot &foot = found.foot;
    foot.distance *= scale;
    foot.noise = scale * (foot.noise + error) + (condition - 1) * foot.distance;
    found.at_least = (found.at_least - error) / placement.growth_to_part();
    return found;
}

// The nearest foot so far, and a lower bound of the distances of all faces, which certifies it. The feet on
// other faces need not be certified to be the nearest ones there.
class ModelLocator::Nearest {
public:
    [[nodiscard]] double limit() const noexcept { return best_.foot.distance; }
    void add(const closest::BoundedFoot &found, const PlacedFace &placed) noexcept {
        at_least_ = std::min(at_least_, found.at_least);
        if (best_.face < 0 || found.foot.distance < best_.foot.distance) {
            best_ = {found.foot, {}, placed.face, placed.instance};
        }
    }
    void leave_out() noexcept { at_least_ = 0; }
    [[nodiscard]] bool any() const noexcept { return best_.face >= 0; }
    // Without any face the infinite distance is certified.
    [[nodiscard]] ModelFoot found(double tolerance) const noexcept {
        ModelFoot result = best_;
        const double least = best_.foot.distance - tolerance - 2 * best_.foot.noise;
        const bool sure = !any() || (at_least_ >= least && std::isfinite(least));
        result.foot.status &= ~closest::closest_certified;
        result.foot.status |= sure ? closest::closest_certified : 0;
        return result;
    }

private:
    static closest::Foot nowhere() noexcept {
        closest::Foot foot;
        foot.params.fill(nan_value);
        foot.distance = infinity;
        return foot;
    }
    ModelFoot best_{nowhere(), {nan_value, nan_value, nan_value}};
    double at_least_ = infinity;
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
    ModelFoot found = nearest.found(tolerance);
    if (found.face >= 0) {
        settle(found, x, tolerance);
    }
    return found;
}

// Sets the point in the whole and its distance, and withdraws the certificate if that is more than was
// proven.
void ModelLocator::settle(ModelFoot &found, const Vector3 &x, double tolerance) const {
    const Placement &placement = scene_.placement({found.face, found.instance, 0});
    closest::Foot &foot = found.foot;
    const Vector3 local = point_of(*face(found.face).surface(), foot);
    found.point = placement.in_whole(local);
    const double distance = length(found.point - x),
                 allowed = foot.distance + tolerance + foot.noise + placement.rounding(length(local));
    closest::settle(foot, distance, distance <= allowed && std::isfinite(allowed));
}

} // namespace nrb::model
