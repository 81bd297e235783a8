// SPDX-License-Identifier: MIT
// A face as a region of its surface, for searches over pieces of the surface.
#pragma once

#include "closest/pair/region.h"
#include "face/near/face_locator.h"

namespace nrb::face {

class FaceRegion final : public closest::Region {
public:
    // The face must outlive this.
    explicit FaceRegion(const Face &face) : face_(face), locator_(face) {}

    [[nodiscard]] int side(const pieces::LocalParam &params) const override {
        return face_.trims().side({params[0], params[1]});
    }
    [[nodiscard]] int side(const pieces::LocalParam &lower, const pieces::LocalParam &upper) const override {
        const Point2 low{lower[0], lower[1]}, high{upper[0], upper[1]};
        return face_.trims().cuts(low, high)
                   ? 0
                   : face_.trims().side({low[0] / 2 + high[0] / 2, low[1] / 2 + high[1] / 2});
    }
    [[nodiscard]] closest::BoundedFoot nearest(const double *point, double tolerance) override {
        return locator_.nearest(point, tolerance);
    }

private:
    const Face &face_;
    FaceLocator locator_;
};

} // namespace nrb::face
