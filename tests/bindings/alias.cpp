// SPDX-License-Identifier: MIT
// Other names for the namespace of the C++ wrapper.
#define NURBS_CPP_ALIAS nb
#include "expect.hpp"

namespace app {

namespace nurbs = libnurbs;

static nurbs::Spline circle() {
    return nurbs::circle({}, 1);
}

} // namespace app

static double in_a_function() {
    namespace nurbs = libnurbs;
    const ::nurbs *handle = nullptr; // the C type is still there
    return handle == nullptr ? nurbs::length(app::circle()).value : 0;
}

int main() {
    EXPECT(near({nb::length(nb::circle({}, 1)).value}, {2 * pi}));
    EXPECT(near({in_a_function()}, {2 * pi}));
    return failures == 0 ? 0 : 1;
}
