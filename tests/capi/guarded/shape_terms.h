/* SPDX-License-Identifier: MIT */
// The terms in which the comments of nurbs.h tell the shapes of arrays, for what make_calls.py generates.
#ifndef NURBS_TESTS_CAPI_GUARDED_SHAPE_TERMS_H
#define NURBS_TESTS_CAPI_GUARDED_SHAPE_TERMS_H

#include <nurbs/nurbs.h>

#include <cstring>

namespace shape_terms {

inline int64_t text(const char *text) {
    return text == nullptr ? 0 : static_cast<int64_t>(std::strlen(text)) + 1;
}

// From the first element to the last, strides included.
inline int64_t extent(int64_t records, int64_t width, int64_t stride = 0, int64_t component_stride = 0) {
    const int64_t step = component_stride == 0 ? 1 : component_stride;
    const int64_t record = stride == 0 ? width * step : stride;
    return records <= 0 || width <= 0 ? 0 : (records - 1) * record + (width - 1) * step + 1;
}

template <class Answer, class Function, class... Arguments>
Answer ask(Function *function, Arguments... arguments) {
    Answer answer = 0;
    (void)function(arguments..., &answer);
    return answer;
}

inline int32_t axes_of(const nurbs *g) {
    return ask<int32_t>(nurbs_axes, g);
}

inline int32_t dim_of(const nurbs *g) {
    return ask<int32_t>(nurbs_dimension, g);
}

inline int32_t axes_of(const nurbs_statistics *statistics) {
    int32_t axes = 0;
    (void)nurbs_statistics_size(statistics, &axes, nullptr, nullptr, nullptr, nullptr);
    return axes;
}

inline int32_t dim_of(const nurbs_statistics *statistics) {
    int32_t dim = 0;
    (void)nurbs_statistics_size(statistics, nullptr, &dim, nullptr, nullptr, nullptr);
    return dim;
}

inline int32_t dim_of(const nurbs_face *face) {
    nurbs *surface = nullptr;
    (void)nurbs_face_surface(face, &surface);
    const int32_t dim = dim_of(surface);
    nurbs_destroy(surface);
    return dim;
}

inline int32_t axes_of(const nurbs_data *data) {
    return data == nullptr ? 0 : data->axes;
}

inline int32_t dim_of(const nurbs_data *data) {
    return data == nullptr ? 0 : data->dim;
}

inline int32_t rational_of(const nurbs *g) {
    return ask<int32_t>(nurbs_is_rational, g);
}

inline int64_t points_of(const nurbs *g) {
    return ask<int64_t>(nurbs_point_count, g);
}

inline int32_t degree_of(const nurbs *g, int32_t axis) {
    return ask<int32_t>(nurbs_degree, g, axis);
}

inline int64_t count_of(const nurbs *g, int32_t axis) {
    return ask<int64_t>(nurbs_count, g, axis);
}

inline int64_t spans_of(const nurbs *g, int32_t axis) {
    int64_t spans = 0;
    (void)nurbs_bezier_extraction(g, axis, 0, nullptr, nullptr, nullptr, &spans);
    return spans;
}

inline int64_t product(int32_t axes, const int64_t *counts) {
    int64_t all = 1;
    for (int32_t k = 0; k < axes; ++k) {
        all *= counts[k];
    }
    return all;
}

inline int64_t sum(int64_t axes, const int64_t *counts) {
    int64_t all = 0;
    for (int32_t k = 0; k < axes; ++k) {
        all += counts[k];
    }
    return all;
}

inline int64_t order_product(int32_t axes, const int32_t *degrees) {
    int64_t all = 1;
    for (int32_t k = 0; k < axes; ++k) {
        all *= degrees[k] + 1;
    }
    return all;
}

inline int64_t order_product(const nurbs *g) {
    int64_t all = 1;
    for (int32_t k = 0; k < axes_of(g); ++k) {
        all *= degree_of(g, k) + 1;
    }
    return all;
}

inline int64_t pieces_of(const nurbs *g) {
    int64_t all = 1;
    for (int32_t k = 0; k < axes_of(g); ++k) {
        all *= spans_of(g, k);
    }
    return all;
}

inline int64_t pieces_sum(const nurbs *g) {
    int64_t all = 0;
    for (int32_t k = 0; k < axes_of(g); ++k) {
        all += spans_of(g, k);
    }
    return all;
}

inline int64_t slots(int32_t axes, int32_t order) {
    return ask<int64_t>(nurbs_derivative_slots, axes, order);
}

// Coefficients of a polynomial; 0 where the library refuses the degree.
inline int64_t monomials(int32_t dim, int32_t degree) {
    int64_t count = degree >= 1 && degree <= 8 ? 1 : 0;
    for (int32_t i = 1; i <= degree && count > 0; ++i) {
        count = count <= INT64_MAX / (dim + i) ? count * (dim + i) / i : 0;
    }
    return count;
}

} // namespace shape_terms

#endif
