/* SPDX-License-Identifier: MIT */
/// \file data.hpp
/// \brief Data for fits: values at parameters, with weights.
#ifndef NURBS_CPP_DATA_HPP
#define NURBS_CPP_DATA_HPP

#include <nurbs/cpp/arrays.hpp>
#include <nurbs/cpp/calls.hpp>

#include <cstdint>

namespace libnurbs {
inline namespace NURBS_CPP_POLICY {

/// Values [n][dim] at parameters [n][axes], with weights [n] or none. It refers to the arrays of the caller, who keeps them.
/// Its fields are those of nurbs_data; `flags` are evaluation flags.
struct Data : nurbs_data {
    [[gnu::always_inline]] Data() : nurbs_data{} {
        detail::call(nurbs_data_init, this, static_cast<std::int64_t>(sizeof(nurbs_data)));
    }
    [[gnu::always_inline]] Data(std::int32_t parameters, std::int32_t dimension, Input at, Input what,
                                Input weighed = {}, std::uint32_t evaluation_flags = 0)
        : Data() {
        axes = parameters;
        dim = dimension;
        n = detail::records(at, axes, "params");
        at.require(n, axes, "params");
        what.require(n, dim, "values");
        detail::require_wanted(weighed, n, 1, "weights");
        params = at.data();
        param_stride = at.stride();
        param_component_stride = at.component_stride();
        values = what.data();
        value_stride = what.stride();
        value_component_stride = what.component_stride();
        weights = weighed.empty() ? nullptr : weighed.data();
        weight_stride = weighed.step();
        flags = evaluation_flags;
    }
};

} // namespace NURBS_CPP_POLICY
} // namespace libnurbs

#endif // NURBS_CPP_DATA_HPP
