! SPDX-License-Identifier: MIT
!> The functions of nurbs.h as they stand, argument by argument; that header is the manual. Here the indices of axes,
!> spans and list entries count from 0, flags are 32-bit patterns, and the optional arguments are those that may be
!> NULL. An output array is intent(inout) because a failing call leaves it as it was.
module nurbs_c
    use, intrinsic :: iso_c_binding
    implicit none
    public

    type, bind(c) :: nurbs_read_options
        integer(c_int64_t) :: struct_size
        real(c_double) :: unit
        integer(c_int64_t) :: max_bytes
    end type nurbs_read_options

    interface
        function nurbs_version() bind(c) result(r)
            import
            integer(c_int32_t) :: r
        end function nurbs_version
        function nurbs_status_name(status) bind(c) result(r)
            import
            integer(c_int32_t), value :: status
            type(c_ptr) :: r
        end function nurbs_status_name
        function nurbs_last_error(buf, cap) bind(c) result(r)
            import
            character(kind=c_char), intent(inout), optional :: buf(*)
            integer(c_int64_t), value :: cap
            integer(c_int64_t) :: r
        end function nurbs_last_error
        function nurbs_create(axes, degrees, counts, knots, knot_count, dim, points, point_stride, &
            point_component_stride, weights, weight_stride, flags, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: axes, dim, flags
            integer(c_int32_t), intent(in) :: degrees(*)
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: knots(*), points(*)
            integer(c_int64_t), value :: knot_count, point_stride, point_component_stride, weight_stride
            real(c_double), intent(in), optional :: weights(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_create
        function nurbs_create_homogeneous(axes, degrees, counts, knots, knot_count, dim, points, &
            point_stride, point_component_stride, flags, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: axes, dim, flags
            integer(c_int32_t), intent(in) :: degrees(*)
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: knots(*), points(*)
            integer(c_int64_t), value :: knot_count, point_stride, point_component_stride
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_create_homogeneous
        function nurbs_create_short(axes, degrees, counts, knots, knot_count, dim, points, point_stride, &
            point_component_stride, weights, weight_stride, flags, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: axes, dim, flags
            integer(c_int32_t), intent(in) :: degrees(*)
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: knots(*), points(*)
            integer(c_int64_t), value :: knot_count, point_stride, point_component_stride, weight_stride
            real(c_double), intent(in), optional :: weights(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_create_short
        function nurbs_create_multiplicities(axes, degrees, counts, distinct_counts, distinct_knots, &
            multiplicities, dim, points, point_stride, point_component_stride, weights, weight_stride, &
            flags, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: axes, dim, flags
            integer(c_int32_t), intent(in) :: degrees(*), multiplicities(*)
            integer(c_int64_t), intent(in) :: counts(*), distinct_counts(*)
            real(c_double), intent(in) :: distinct_knots(*), points(*)
            integer(c_int64_t), value :: point_stride, point_component_stride, weight_stride
            real(c_double), intent(in), optional :: weights(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_create_multiplicities
        function nurbs_create_bezier(axes, degrees, dim, points, point_stride, point_component_stride, &
            weights, weight_stride, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: axes, dim
            integer(c_int32_t), intent(in) :: degrees(*)
            real(c_double), intent(in) :: points(*)
            integer(c_int64_t), value :: point_stride, point_component_stride, weight_stride
            real(c_double), intent(in), optional :: weights(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_create_bezier
        function nurbs_with_points(g, points, point_stride, point_component_stride, weights, &
            weight_stride, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: points(*)
            integer(c_int64_t), value :: point_stride, point_component_stride, weight_stride
            real(c_double), intent(in), optional :: weights(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_with_points
        function nurbs_clone(g, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_clone
        subroutine nurbs_destroy(g) bind(c)
            import
            type(c_ptr), value :: g
        end subroutine nurbs_destroy
        function nurbs_knots_uniform(degree, count, a, b, knot_count, knots) bind(c) result(r)
            import
            integer(c_int32_t), value :: degree
            integer(c_int64_t), value :: count, knot_count
            real(c_double), value :: a, b
            real(c_double), intent(inout) :: knots(*)
            integer(c_int32_t) :: r
        end function nurbs_knots_uniform
        function nurbs_knots_open_uniform(degree, count, a, b, knot_count, knots) bind(c) result(r)
            import
            integer(c_int32_t), value :: degree
            integer(c_int64_t), value :: count, knot_count
            real(c_double), value :: a, b
            real(c_double), intent(inout) :: knots(*)
            integer(c_int32_t) :: r
        end function nurbs_knots_open_uniform
        function nurbs_knots_bezier(degree, pieces, breaks, knot_count, knots) bind(c) result(r)
            import
            integer(c_int32_t), value :: degree
            integer(c_int64_t), value :: pieces, knot_count
            real(c_double), intent(in), optional :: breaks(*)
            real(c_double), intent(inout) :: knots(*)
            integer(c_int32_t) :: r
        end function nurbs_knots_bezier
        function nurbs_knots_averaged(degree, count, params, knot_count, knots) bind(c) result(r)
            import
            integer(c_int32_t), value :: degree
            integer(c_int64_t), value :: count, knot_count
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout) :: knots(*)
            integer(c_int32_t) :: r
        end function nurbs_knots_averaged
        function nurbs_knots_periodic(degree, n, breaks, multiplicities, knot_count, knots) bind(c) result(r)
            import
            integer(c_int32_t), value :: degree
            integer(c_int64_t), value :: n, knot_count
            real(c_double), intent(in) :: breaks(*)
            integer(c_int32_t), intent(in), optional :: multiplicities(*)
            real(c_double), intent(inout) :: knots(*)
            integer(c_int32_t) :: r
        end function nurbs_knots_periodic
        function nurbs_axes(g, axes) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), intent(out) :: axes
            integer(c_int32_t) :: r
        end function nurbs_axes
        function nurbs_dimension(g, dim) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), intent(out) :: dim
            integer(c_int32_t) :: r
        end function nurbs_dimension
        function nurbs_degree(g, axis, degree) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int32_t), intent(out) :: degree
            integer(c_int32_t) :: r
        end function nurbs_degree
        function nurbs_count(g, axis, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), intent(out) :: count
            integer(c_int32_t) :: r
        end function nurbs_count
        function nurbs_point_count(g, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), intent(out) :: count
            integer(c_int32_t) :: r
        end function nurbs_point_count
        function nurbs_is_rational(g, rational) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), intent(out) :: rational
            integer(c_int32_t) :: r
        end function nurbs_is_rational
        function nurbs_knots(g, axis, knot_count, knots) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), value :: knot_count
            real(c_double), intent(inout) :: knots(*)
            integer(c_int32_t) :: r
        end function nurbs_knots
        function nurbs_distinct_knots(g, axis, cap, knots, multiplicities, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: knots(*)
            integer(c_int32_t), intent(inout), optional :: multiplicities(*)
            integer(c_int64_t), intent(out) :: count
            integer(c_int32_t) :: r
        end function nurbs_distinct_knots
        function nurbs_knot_form(g, axis, form) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int32_t), intent(out) :: form
            integer(c_int32_t) :: r
        end function nurbs_knot_form
        function nurbs_domain(g, axis, domain) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), intent(inout) :: domain(*)
            integer(c_int32_t) :: r
        end function nurbs_domain
        function nurbs_greville(g, axis, count, abscissae) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), value :: count
            real(c_double), intent(inout) :: abscissae(*)
            integer(c_int32_t) :: r
        end function nurbs_greville
        function nurbs_points(g, count, points, point_stride, point_component_stride) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: count, point_stride, point_component_stride
            real(c_double), intent(inout) :: points(*)
            integer(c_int32_t) :: r
        end function nurbs_points
        function nurbs_weights(g, count, weights, weight_stride) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: count, weight_stride
            real(c_double), intent(inout) :: weights(*)
            integer(c_int32_t) :: r
        end function nurbs_weights
        function nurbs_homogeneous_points(g, count, points, point_stride, point_component_stride &
            ) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: count, point_stride, point_component_stride
            real(c_double), intent(inout) :: points(*)
            integer(c_int32_t) :: r
        end function nurbs_homogeneous_points
        function nurbs_hull_size(g, n, params, param_stride, param_component_stride, sizes, size_stride, &
            flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, param_stride, param_component_stride, size_stride
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout) :: sizes(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_hull_size
        function nurbs_find_spans(degree, count, knots, knot_count, n, params, param_stride, spans, flags &
            ) bind(c) result(r)
            import
            integer(c_int32_t), value :: degree, flags
            integer(c_int64_t), value :: count, knot_count, n, param_stride
            real(c_double), intent(in) :: knots(*), params(*)
            integer(c_int64_t), intent(inout) :: spans(*)
            integer(c_int32_t) :: r
        end function nurbs_find_spans
        function nurbs_bernstein(degree, order, n, params, param_stride, values, value_stride, &
            value_component_stride) bind(c) result(r)
            import
            integer(c_int32_t), value :: degree, order
            integer(c_int64_t), value :: n, param_stride, value_stride, value_component_stride
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout) :: values(*)
            integer(c_int32_t) :: r
        end function nurbs_bernstein
        function nurbs_basis(degree, count, knots, knot_count, order, n, params, param_stride, spans, &
            values, value_stride, value_component_stride, flags) bind(c) result(r)
            import
            integer(c_int32_t), value :: degree, order, flags
            integer(c_int64_t), value :: count, knot_count, n, param_stride, value_stride, &
                value_component_stride
            real(c_double), intent(in) :: knots(*), params(*)
            integer(c_int64_t), intent(inout), optional :: spans(*)
            real(c_double), intent(inout) :: values(*)
            integer(c_int32_t) :: r
        end function nurbs_basis
        function nurbs_rational_basis(g, n, params, param_stride, param_component_stride, spans, values, &
            value_stride, value_component_stride, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, param_stride, param_component_stride, value_stride, &
                value_component_stride
            real(c_double), intent(in) :: params(*)
            integer(c_int64_t), intent(inout), optional :: spans(*)
            real(c_double), intent(inout) :: values(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_rational_basis
        function nurbs_eval(g, n, params, param_stride, param_component_stride, points, point_stride, &
            point_component_stride, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, param_stride, param_component_stride, point_stride, &
                point_component_stride
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout) :: points(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_eval
        function nurbs_derivative_slots(axes, order, slots) bind(c) result(r)
            import
            integer(c_int32_t), value :: axes, order
            integer(c_int64_t), intent(out) :: slots
            integer(c_int32_t) :: r
        end function nurbs_derivative_slots
        function nurbs_eval_derivs(g, order, n, params, param_stride, param_component_stride, derivs, &
            deriv_stride, deriv_component_stride, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: order, flags
            integer(c_int64_t), value :: n, param_stride, param_component_stride, deriv_stride, &
                deriv_component_stride
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout) :: derivs(*)
            integer(c_int32_t) :: r
        end function nurbs_eval_derivs
        function nurbs_eval_grid(g, counts, params, points, point_stride, point_component_stride, flags &
            ) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout) :: points(*)
            integer(c_int64_t), value :: point_stride, point_component_stride
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_eval_grid
        function nurbs_eval_grid_derivs(g, order, counts, params, derivs, deriv_stride, &
            deriv_component_stride, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: order, flags
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout) :: derivs(*)
            integer(c_int64_t), value :: deriv_stride, deriv_component_stride
            integer(c_int32_t) :: r
        end function nurbs_eval_grid_derivs
        function nurbs_eval_f32(g, n, params, param_stride, param_component_stride, points, point_stride, &
            point_component_stride, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, param_stride, param_component_stride, point_stride, &
                point_component_stride
            real(c_double), intent(in) :: params(*)
            real(c_float), intent(inout) :: points(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_eval_f32
        function nurbs_eval_grid_f32(g, counts, params, points, point_stride, point_component_stride, flags &
            ) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: params(*)
            real(c_float), intent(inout) :: points(*)
            integer(c_int64_t), value :: point_stride, point_component_stride
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_eval_grid_f32
        function nurbs_iso(g, axis, param, flags, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, flags
            real(c_double), value :: param
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_iso
        function nurbs_surface_eval_frames(g, n, params, param_stride, param_component_stride, points, &
            point_stride, point_component_stride, du, du_stride, du_component_stride, dv, dv_stride, &
            dv_component_stride, normals, normal_stride, normal_component_stride, status, flags) bind(c) &
            result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, param_stride, param_component_stride, point_stride, &
                point_component_stride, du_stride, du_component_stride, dv_stride, dv_component_stride, &
                normal_stride, normal_component_stride
            integer(c_int32_t), value :: flags
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout), optional :: points(*), du(*), dv(*), normals(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t) :: r
        end function nurbs_surface_eval_frames
        function nurbs_surface_eval_grid_frames(g, counts, params, points, point_stride, &
            point_component_stride, du, du_stride, du_component_stride, dv, dv_stride, dv_component_stride, &
            normals, normal_stride, normal_component_stride, status, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: point_stride, point_component_stride, du_stride, &
                du_component_stride, dv_stride, dv_component_stride, normal_stride, normal_component_stride
            integer(c_int32_t), value :: flags
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout), optional :: points(*), du(*), dv(*), normals(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t) :: r
        end function nurbs_surface_eval_grid_frames
        function nurbs_surface_eval_curvatures(g, n, params, param_stride, param_component_stride, &
            principal, principal_stride, principal_component_stride, directions, direction_stride, &
            direction_component_stride, mean, mean_stride, gaussian, gaussian_stride, status, flags) &
            bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, param_stride, param_component_stride, principal_stride, &
                principal_component_stride, direction_stride, direction_component_stride, mean_stride, &
                gaussian_stride
            integer(c_int32_t), value :: flags
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout), optional :: principal(*), directions(*), mean(*), gaussian(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t) :: r
        end function nurbs_surface_eval_curvatures
        function nurbs_curve_eval_frames(g, n, params, param_stride, points, point_stride, &
            point_component_stride, tangents, tangent_stride, tangent_component_stride, normals, &
            normal_stride, normal_component_stride, binormals, binormal_stride, binormal_component_stride, &
            curvatures, curvature_stride, torsions, torsion_stride, status, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, param_stride, point_stride, point_component_stride, &
                tangent_stride, tangent_component_stride, normal_stride, normal_component_stride, &
                binormal_stride, binormal_component_stride, curvature_stride, torsion_stride
            integer(c_int32_t), value :: flags
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout), optional :: points(*), tangents(*), normals(*), binormals(*), &
                curvatures(*), torsions(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t) :: r
        end function nurbs_curve_eval_frames
        function nurbs_curve_rotation_minimizing_frames(g, n, params, param_stride, first_normal, points, &
            point_stride, point_component_stride, tangents, tangent_stride, tangent_component_stride, &
            normals, normal_stride, normal_component_stride, binormals, binormal_stride, &
            binormal_component_stride, status, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, param_stride, point_stride, point_component_stride, &
                tangent_stride, tangent_component_stride, normal_stride, normal_component_stride, &
                binormal_stride, binormal_component_stride
            integer(c_int32_t), value :: flags
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(in), optional :: first_normal(*)
            real(c_double), intent(inout), optional :: points(*), tangents(*), normals(*), binormals(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t) :: r
        end function nurbs_curve_rotation_minimizing_frames
        function nurbs_insert_knot(g, axis, knot, times, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, times
            real(c_double), value :: knot
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_insert_knot
        function nurbs_elevate(g, axis, times, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, times
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_elevate
        function nurbs_reverse(g, axis, flags, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, flags
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_reverse
        function nurbs_transpose(g, permutation, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), intent(in) :: permutation(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_transpose
        function nurbs_reparametrize(g, axis, lower, upper, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), value :: lower, upper
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_reparametrize
        function nurbs_make_rational(g, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_make_rational
        function nurbs_to_homogeneous(g, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_to_homogeneous
        function nurbs_from_homogeneous(g, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_from_homogeneous
        function nurbs_normalize_weights(g, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_normalize_weights
        function nurbs_reparametrize_moebius(g, axis, ratio, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), value :: ratio
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_reparametrize_moebius
        function nurbs_equalize_end_weights(g, axis, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_equalize_end_weights
        function nurbs_blossom(g, params, count, args, values, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: params(*), args(*)
            integer(c_int64_t), value :: count
            real(c_double), intent(inout) :: values(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_blossom
        function nurbs_derivative(g, axis, order, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, order
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_derivative
        function nurbs_antiderivative(g, axis, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_antiderivative
        function nurbs_product(a, b, flags, out) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            integer(c_int32_t), value :: flags
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_product
        function nurbs_compose(g, f, out) bind(c) result(r)
            import
            type(c_ptr), value :: g, f
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_compose
        function nurbs_sum(a, alpha, b, beta, out) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: alpha, beta
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_sum
        function nurbs_transform(g, out_dim, matrix, translation, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: out_dim
            real(c_double), intent(in) :: matrix(*)
            real(c_double), intent(in), optional :: translation(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_transform
        function nurbs_transform_projective(g, out_dim, matrix, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: out_dim
            real(c_double), intent(in) :: matrix(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_transform_projective
        function nurbs_refine(g, axis, count, knots, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), value :: count
            real(c_double), intent(in) :: knots(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_refine
        function nurbs_refine_uniform(g, axis, parts, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), value :: parts
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_refine_uniform
        function nurbs_refinement_matrix(g, axis, count, knots, cap, values, columns, row_pointers, entries) &
            bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), value :: count, cap
            real(c_double), intent(in) :: knots(*)
            real(c_double), intent(inout), optional :: values(*)
            integer(c_int64_t), intent(inout), optional :: columns(*), row_pointers(*)
            integer(c_int64_t), intent(inout), optional :: entries
            integer(c_int32_t) :: r
        end function nurbs_refinement_matrix
        function nurbs_split(g, axis, param, lower, upper) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), value :: param
            type(c_ptr), intent(out) :: lower, upper
            integer(c_int32_t) :: r
        end function nurbs_split
        function nurbs_extract(g, lower, upper, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: lower(*), upper(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_extract
        function nurbs_decompose(g, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_decompose
        function nurbs_split_at_knots(g, axis, order, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, order
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_split_at_knots
        function nurbs_clamp_ends(g, axis, flags, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, flags
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_clamp_ends
        function nurbs_move_seam(g, axis, param, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), value :: param
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_move_seam
        function nurbs_join(count, parts, axis, tolerance, flags, gap, out) bind(c) result(r)
            import
            integer(c_int64_t), value :: count
            type(c_ptr), intent(in) :: parts(*)
            integer(c_int32_t), value :: axis, flags
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: gap
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_join
        function nurbs_snap_knots(g, axis, tolerance, deviation, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: deviation
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_snap_knots
        function nurbs_make_compatible(count, splines, tolerance, flags, deviation, out) bind(c) result(r)
            import
            integer(c_int64_t), value :: count
            type(c_ptr), intent(in) :: splines(*)
            real(c_double), value :: tolerance
            integer(c_int32_t), value :: flags
            real(c_double), intent(inout), optional :: deviation
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_make_compatible
        function nurbs_create_hermite(n, params, dim, points, point_stride, point_component_stride, tangents, &
            tangent_stride, tangent_component_stride, out) bind(c) result(r)
            import
            integer(c_int64_t), value :: n, point_stride, point_component_stride, tangent_stride
            integer(c_int64_t), value :: tangent_component_stride
            real(c_double), intent(in) :: params(*), points(*), tangents(*)
            integer(c_int32_t), value :: dim
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_create_hermite
        function nurbs_to_hermite(g, cap, params, points, tangents, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), points(*), tangents(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_to_hermite
        function nurbs_to_power(g, cap, coefficients, breaks, piece_counts, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: coefficients(*), breaks(*)
            integer(c_int64_t), intent(inout), optional :: piece_counts(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_to_power
        function nurbs_create_power(axes, degrees, piece_counts, breaks, break_count, dim, coefficients, &
            coefficient_stride, coefficient_component_stride, flags, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: axes, dim, flags
            integer(c_int32_t), intent(in) :: degrees(*)
            integer(c_int64_t), intent(in) :: piece_counts(*)
            real(c_double), intent(in) :: breaks(*), coefficients(*)
            integer(c_int64_t), value :: break_count, coefficient_stride, coefficient_component_stride
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_create_power
        function nurbs_basis_matrix(from, to, degree, size, matrix) bind(c) result(r)
            import
            integer(c_int32_t), value :: from, to, degree
            integer(c_int64_t), value :: size
            real(c_double), intent(inout) :: matrix(*)
            integer(c_int32_t) :: r
        end function nurbs_basis_matrix
        function nurbs_mirror(g, point, normal, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: point(*), normal(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_mirror
        function nurbs_project_to_plane(g, point, normal, direction, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: point(*), normal(*)
            real(c_double), intent(in), optional :: direction(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_project_to_plane
        function nurbs_project_from(g, eye, point, normal, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: eye(*), point(*), normal(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_project_from
        function nurbs_extend(g, axis, end, amount, order, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, end, order
            real(c_double), value :: amount
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_extend
        function nurbs_unclamp(g, axis, flags, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, flags
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_unclamp
        function nurbs_make_periodic(g, axis, tolerance, deviation, order, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: deviation
            integer(c_int32_t), intent(inout), optional :: order
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_make_periodic
        function nurbs_detect_periodic(g, axis, periodic) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int32_t), intent(out) :: periodic
            integer(c_int32_t) :: r
        end function nurbs_detect_periodic
        function nurbs_continuity(g, axis, position_tolerance, derivative_tolerance, angle_tolerance, cap, knots, &
            knot_orders, orders, geometric_orders, position_gaps, angles, curvature_gaps, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), value :: position_tolerance, derivative_tolerance, angle_tolerance
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: knots(*), position_gaps(*), angles(*), curvature_gaps(*)
            integer(c_int32_t), intent(inout), optional :: knot_orders(*), orders(*), geometric_orders(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_continuity
        function nurbs_continuity_between(a, end_a, b, end_b, position_tolerance, derivative_tolerance, &
            angle_tolerance, order, geometric, position_gap, angle, curvature_gap) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            integer(c_int32_t), value :: end_a, end_b
            real(c_double), value :: position_tolerance, derivative_tolerance, angle_tolerance
            integer(c_int32_t), intent(inout), optional :: order, geometric
            real(c_double), intent(inout), optional :: position_gap, angle, curvature_gap
            integer(c_int32_t) :: r
        end function nurbs_continuity_between
        function nurbs_deviation(f, g, at_least, at_most) bind(c) result(r)
            import
            type(c_ptr), value :: f, g
            real(c_double), intent(inout), optional :: at_least, at_most
            integer(c_int32_t) :: r
        end function nurbs_deviation
        function nurbs_remove_knot(g, axis, knot, times, tolerance, removed, bound, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, times
            real(c_double), value :: knot, tolerance
            integer(c_int32_t), intent(inout), optional :: removed
            real(c_double), intent(inout), optional :: bound
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_remove_knot
        function nurbs_reduce_knots(g, axis, tolerance, bound, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: bound
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_reduce_knots
        function nurbs_reduce_degree(g, axis, times, bound, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, times
            real(c_double), intent(inout), optional :: bound
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_reduce_degree
        function nurbs_simplify(g, tolerance, bound, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: bound
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_simplify
        function nurbs_curve_line(dim, a, b, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in) :: a(*), b(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_line
        function nurbs_curve_polyline(n, dim, points, point_stride, point_component_stride, params, &
            param_stride, out) bind(c) result(r)
            import
            integer(c_int64_t), value :: n, point_stride, point_component_stride, param_stride
            integer(c_int32_t), value :: dim
            real(c_double), intent(in) :: points(*)
            real(c_double), intent(in), optional :: params(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_polyline
        function nurbs_curve_polygon(dim, center, axis, x, radius, sides, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius
            integer(c_int64_t), value :: sides
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_polygon
        function nurbs_curve_rounded_rectangle(dim, center, axis, x, width, height, corner_radius, &
            out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: width, height, corner_radius
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_rounded_rectangle
        function nurbs_curve_circle(dim, center, axis, x, radius, form, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim, form
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_circle
        function nurbs_curve_arc(dim, center, axis, x, radius, start, sweep, form, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim, form
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius, start, sweep
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_arc
        function nurbs_curve_arc_through(dim, a, b, c, form, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim, form
            real(c_double), intent(in) :: a(*), b(*), c(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_arc_through
        function nurbs_curve_arc_tangent(dim, a, tangent, b, form, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim, form
            real(c_double), intent(in) :: a(*), tangent(*), b(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_arc_tangent
        function nurbs_curve_ellipse(dim, center, axis, x, radius_x, radius_y, start, sweep, form, &
            out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim, form
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius_x, radius_y, start, sweep
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_ellipse
        function nurbs_curve_parabola(dim, vertex, axis, x, focal_length, start, end, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in), optional :: vertex(*), axis(*), x(*)
            real(c_double), value :: focal_length, start, end
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_parabola
        function nurbs_curve_hyperbola(dim, center, axis, x, radius_x, radius_y, start, end, &
            out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius_x, radius_y, start, end
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_hyperbola
        function nurbs_curve_conic_triangle(dim, p0, p1, p2, shape_factor, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in) :: p0(*), p1(*), p2(*)
            real(c_double), value :: shape_factor
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_conic_triangle
        function nurbs_curve_conic_shoulder(dim, a, tangent_a, b, tangent_b, rho, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in) :: a(*), tangent_a(*), b(*), tangent_b(*)
            real(c_double), value :: rho
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_conic_shoulder
        function nurbs_curve_conic_point(dim, a, tangent_a, b, tangent_b, point, form, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim, form
            real(c_double), intent(in) :: a(*), tangent_a(*), b(*), tangent_b(*), point(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_conic_point
        function nurbs_curve_conic_through(dim, points, point_stride, point_component_stride, form, &
            out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim, form
            real(c_double), intent(in) :: points(*)
            integer(c_int64_t), value :: point_stride, point_component_stride
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_conic_through
        function nurbs_conic_axes(coefficients, type, origin, x, sizes) bind(c) result(r)
            import
            real(c_double), intent(in) :: coefficients(*)
            integer(c_int32_t), intent(inout) :: type
            real(c_double), intent(inout) :: origin(*), x(*), sizes(*)
            integer(c_int32_t) :: r
        end function nurbs_conic_axes
        function nurbs_curve_conic_implicit(coefficients, start, end, form, out) bind(c) result(r)
            import
            real(c_double), intent(in) :: coefficients(*)
            real(c_double), value :: start, end
            integer(c_int32_t), value :: form
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_conic_implicit
        function nurbs_curve_conic_focus(dim, focus, axis, foot, eccentricity, start, sweep, form, &
            out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim, form
            real(c_double), intent(in) :: focus(*), foot(*)
            real(c_double), intent(in), optional :: axis(*)
            real(c_double), value :: eccentricity, start, sweep
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_conic_focus
        function nurbs_curve_shape_factor(g, factor, type) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(inout) :: factor
            integer(c_int32_t), intent(inout) :: type
            integer(c_int32_t) :: r
        end function nurbs_curve_shape_factor
        function nurbs_curve_helix(dim, origin, axis, x, radius, growth, pitch, start, turns, tolerance, &
            error, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in), optional :: origin(*), axis(*), x(*)
            real(c_double), value :: radius, growth, pitch, start, turns, tolerance
            real(c_double), intent(inout), optional :: error
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_helix
        function nurbs_extrude(g, vector, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: vector(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_extrude
        function nurbs_revolve(g, point, axis, sweep, form, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: point(*), axis(*)
            real(c_double), value :: sweep
            integer(c_int32_t), value :: form
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_revolve
        function nurbs_ruled(a, b, flags, out) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            integer(c_int32_t), value :: flags
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_ruled
        function nurbs_tensor_sum(a, alpha, b, beta, out) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: alpha, beta
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_tensor_sum
        function nurbs_tensor_product(a, b, out) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_tensor_product
        function nurbs_surface_swung(trajectory, profile, scale, out) bind(c) result(r)
            import
            type(c_ptr), value :: trajectory, profile
            real(c_double), value :: scale
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_swung
        function nurbs_surface_plane(dim, origin, u, v, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in), optional :: origin(*)
            real(c_double), intent(in) :: u(*), v(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_plane
        function nurbs_surface_bilinear(dim, corners, corner_stride, corner_component_stride, &
            out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in) :: corners(*)
            integer(c_int64_t), value :: corner_stride, corner_component_stride
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_bilinear
        function nurbs_volume_trilinear(dim, corners, corner_stride, corner_component_stride, &
            out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in) :: corners(*)
            integer(c_int64_t), value :: corner_stride, corner_component_stride
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_volume_trilinear
        function nurbs_surface_sphere(center, axis, x, radius, form, out) bind(c) result(r)
            import
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius
            integer(c_int32_t), value :: form
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_sphere
        function nurbs_surface_spherical_patch(center, axis, x, radius, start, sweep, south, north, form, &
            out) bind(c) result(r)
            import
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius, start, sweep, south, north
            integer(c_int32_t), value :: form
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_spherical_patch
        function nurbs_surface_sphere_patches(center, axis, x, radius, flags, out) bind(c) result(r)
            import
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius
            integer(c_int32_t), value :: flags
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_sphere_patches
        function nurbs_surface_ellipsoid(center, axis, x, radius_x, radius_y, radius_z, form, &
            out) bind(c) result(r)
            import
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius_x, radius_y, radius_z
            integer(c_int32_t), value :: form
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_ellipsoid
        function nurbs_surface_cylinder(origin, axis, x, radius, height, start, sweep, form, &
            out) bind(c) result(r)
            import
            real(c_double), intent(in), optional :: origin(*), axis(*), x(*)
            real(c_double), value :: radius, height, start, sweep
            integer(c_int32_t), value :: form
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_cylinder
        function nurbs_surface_cone(origin, axis, x, base_radius, top_radius, height, start, sweep, form, &
            out) bind(c) result(r)
            import
            real(c_double), intent(in), optional :: origin(*), axis(*), x(*)
            real(c_double), value :: base_radius, top_radius, height, start, sweep
            integer(c_int32_t), value :: form
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_cone
        function nurbs_surface_torus(center, axis, x, major_radius, minor_radius, start, sweep, &
            tube_start, tube_sweep, form, out) bind(c) result(r)
            import
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: major_radius, minor_radius, start, sweep, tube_start, tube_sweep
            integer(c_int32_t), value :: form
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_torus
        function nurbs_surface_paraboloid(vertex, axis, x, radius_x, radius_y, height, start, sweep, &
            form, out) bind(c) result(r)
            import
            real(c_double), intent(in), optional :: vertex(*), axis(*), x(*)
            real(c_double), value :: radius_x, radius_y, height, start, sweep
            integer(c_int32_t), value :: form
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_paraboloid
        function nurbs_surface_saddle(center, axis, x, radius_x, radius_y, height, out) bind(c) result(r)
            import
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius_x, radius_y, height
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_saddle
        function nurbs_surface_hyperboloid(center, axis, x, radius_x, radius_y, radius_z, bottom, top, &
            start, sweep, form, flags, out) bind(c) result(r)
            import
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius_x, radius_y, radius_z, bottom, top, start, sweep
            integer(c_int32_t), value :: form, flags
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_hyperboloid
        function nurbs_boundaries(g, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_boundaries
        function nurbs_surface_coons(boundaries, tolerance, out) bind(c) result(r)
            import
            type(c_ptr), intent(in) :: boundaries(*)
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_coons
        function nurbs_surface_coons_hermite(boundaries, cross, twist, twists, tolerance, bound, &
            out) bind(c) result(r)
            import
            type(c_ptr), intent(in) :: boundaries(*)
            type(c_ptr), intent(in), optional :: cross(*)
            integer(c_int32_t), value :: twist
            real(c_double), intent(in), optional :: twists(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: bound
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_coons_hermite
        function nurbs_coons_gaps(boundaries, cross, positions, tangents, twists) bind(c) result(r)
            import
            type(c_ptr), intent(in) :: boundaries(*)
            type(c_ptr), intent(in), optional :: cross(*)
            real(c_double), intent(inout) :: positions(*)
            real(c_double), intent(inout), optional :: tangents(*), twists(*)
            integer(c_int32_t) :: r
        end function nurbs_coons_gaps
        function nurbs_volume_coons(faces, tolerance, out) bind(c) result(r)
            import
            type(c_ptr), intent(in) :: faces(*)
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_volume_coons
        function nurbs_recognize(g, tolerance, shape, placement, sizes, deviation) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: tolerance
            integer(c_int32_t), intent(inout) :: shape
            real(c_double), intent(inout), optional :: placement(*), sizes(*), deviation
            integer(c_int32_t) :: r
        end function nurbs_recognize
        function nurbs_closest_points(g, n, points, point_stride, point_component_stride, range, &
            tolerance, budget, params, param_stride, param_component_stride, feet, foot_stride, &
            foot_component_stride, distances, distance_stride, status, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, point_stride, point_component_stride, budget, &
                param_stride, param_component_stride, foot_stride, foot_component_stride, distance_stride
            real(c_double), intent(in) :: points(*)
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: params(*), feet(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_closest_points
        function nurbs_farthest_points(g, n, points, point_stride, point_component_stride, range, &
            tolerance, budget, params, param_stride, param_component_stride, feet, foot_stride, &
            foot_component_stride, distances, distance_stride, status, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, point_stride, point_component_stride, budget, &
                param_stride, param_component_stride, foot_stride, foot_component_stride, distance_stride
            real(c_double), intent(in) :: points(*)
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: params(*), feet(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_farthest_points
        function nurbs_closest_local(g, n, points, point_stride, point_component_stride, guesses, &
            guess_stride, guess_component_stride, params, param_stride, param_component_stride, feet, &
            foot_stride, foot_component_stride, distances, distance_stride, status, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, point_stride, point_component_stride, guess_stride, &
                guess_component_stride, param_stride, param_component_stride, foot_stride, &
                foot_component_stride, distance_stride
            real(c_double), intent(in) :: points(*), guesses(*)
            real(c_double), intent(inout), optional :: params(*), feet(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_closest_local
        function nurbs_closest_all(g, point, range, tolerance, budget, cap, params, distances, count, &
            status) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: point(*)
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: budget, cap
            real(c_double), intent(inout), optional :: params(*), distances(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t), intent(inout), optional :: status
            integer(c_int32_t) :: r
        end function nurbs_closest_all
        function nurbs_critical_points(g, point, range, tolerance, budget, cap, params, distances, &
            kinds, count, status) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: point(*)
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: budget, cap
            real(c_double), intent(inout), optional :: params(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: kinds(*), status
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_critical_points
        function nurbs_curve_signed_distances(g, n, points, point_stride, point_component_stride, &
            tolerance, budget, distances, distance_stride, params, param_stride, status, flags) bind(c) &
            result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, point_stride, point_component_stride, budget, &
                distance_stride, param_stride
            real(c_double), intent(in) :: points(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout) :: distances(*)
            real(c_double), intent(inout), optional :: params(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_curve_signed_distances
        function nurbs_distance(a, b, tolerance, budget, at_least, at_most, params_a, params_b, status) &
            bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: budget
            real(c_double), intent(inout), optional :: at_least, at_most, params_a(*), params_b(*)
            integer(c_int32_t), intent(inout), optional :: status
            integer(c_int32_t) :: r
        end function nurbs_distance
        function nurbs_hausdorff_distance(a, b, tolerance, budget, at_least, at_most, params_a, &
            params_b, status) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: budget
            real(c_double), intent(inout) :: at_least(*), at_most(*)
            real(c_double), intent(inout), optional :: params_a(*), params_b(*)
            integer(c_int32_t), intent(inout), optional :: status
            integer(c_int32_t) :: r
        end function nurbs_hausdorff_distance
        function nurbs_curve_length(g, range, relative_tolerance, length, error) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: length
            real(c_double), intent(inout), optional :: error
            integer(c_int32_t) :: r
        end function nurbs_curve_length
        function nurbs_curve_lengths(g, n, params, param_stride, relative_tolerance, lengths, &
            length_stride) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, param_stride, length_stride
            real(c_double), intent(in) :: params(*)
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: lengths(*)
            integer(c_int32_t) :: r
        end function nurbs_curve_lengths
        function nurbs_curve_params_at_lengths(g, n, lengths, length_stride, relative_tolerance, params, &
            param_stride, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, length_stride, param_stride
            real(c_double), intent(in) :: lengths(*)
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: params(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_curve_params_at_lengths
        function nurbs_curve_divide(g, range, parts, relative_tolerance, flags, params, size) bind(c) &
            result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: range(*)
            integer(c_int64_t), value :: parts
            real(c_double), value :: relative_tolerance
            integer(c_int32_t), value :: flags
            real(c_double), intent(inout) :: params(*)
            real(c_double), intent(inout), optional :: size
            integer(c_int32_t) :: r
        end function nurbs_curve_divide
        function nurbs_surface_area(g, range, relative_tolerance, area, error) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: area
            real(c_double), intent(inout), optional :: error
            integer(c_int32_t) :: r
        end function nurbs_surface_area
        function nurbs_moments(g, relative_tolerance, content, centroid, inertia, error) bind(c) &
            result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: content
            real(c_double), intent(inout), optional :: centroid(*), inertia(*), error
            integer(c_int32_t) :: r
        end function nurbs_moments
        function nurbs_enclosed_area(count, curves, tolerance, relative_tolerance, area, centroid, &
            inertia, error) bind(c) result(r)
            import
            integer(c_int64_t), value :: count
            type(c_ptr), intent(in) :: curves(*)
            real(c_double), value :: tolerance, relative_tolerance
            real(c_double), intent(inout) :: area
            real(c_double), intent(inout), optional :: centroid(*), inertia(*), error
            integer(c_int32_t) :: r
        end function nurbs_enclosed_area
        function nurbs_enclosed_volume(count, surfaces, relative_tolerance, volume, centroid, inertia, &
            openness, error) bind(c) result(r)
            import
            integer(c_int64_t), value :: count
            type(c_ptr), intent(in) :: surfaces(*)
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: volume
            real(c_double), intent(inout), optional :: centroid(*), inertia(*), openness, error
            integer(c_int32_t) :: r
        end function nurbs_enclosed_volume
        function nurbs_box(g, range, tolerance, lower, upper, gap) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout) :: lower(*), upper(*)
            real(c_double), intent(inout), optional :: gap
            integer(c_int32_t) :: r
        end function nurbs_box
        function nurbs_oriented_box(g, tolerance, center, axes, half) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: tolerance
            real(c_double), intent(inout) :: center(*), axes(*), half(*)
            integer(c_int32_t) :: r
        end function nurbs_oriented_box
        function nurbs_tangent_cone(g, axis, range, tolerance, direction, angle) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout) :: direction(*), angle
            integer(c_int32_t) :: r
        end function nurbs_tangent_cone
        function nurbs_normal_cone(g, range, tolerance, direction, angle) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout) :: direction(*), angle
            integer(c_int32_t) :: r
        end function nurbs_normal_cone
        function nurbs_extreme_point(g, direction, range, tolerance, params, value, bound) bind(c) &
            result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: direction(*)
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: params(*), value, bound
            integer(c_int32_t) :: r
        end function nurbs_extreme_point
        function nurbs_curve_features(g, kinds, cap, params, found, values, count, complete) bind(c) &
            result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: kinds
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), values(*)
            integer(c_int32_t), intent(inout), optional :: found(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_curve_features
        function nurbs_curve_monotone_pieces(g, direction, cap, starts, signs, count, complete) bind(c) &
            result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: direction(*)
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: starts(*)
            integer(c_int32_t), intent(inout), optional :: signs(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_curve_monotone_pieces
        function nurbs_curve_convexity(g, convexity) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), intent(inout) :: convexity
            integer(c_int32_t) :: r
        end function nurbs_curve_convexity
        function nurbs_straightness(g, origin, direction, bound) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(inout), optional :: origin(*), direction(*)
            real(c_double), intent(inout) :: bound
            integer(c_int32_t) :: r
        end function nurbs_straightness
        function nurbs_planarity(g, origin, normal, bound) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(inout), optional :: origin(*), normal(*)
            real(c_double), intent(inout) :: bound
            integer(c_int32_t) :: r
        end function nurbs_planarity
        function nurbs_boundary_contacts(g, tolerance, closed, gaps, collapsed, sizes) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: tolerance
            integer(c_int32_t), intent(inout), optional :: closed(*), collapsed(*)
            real(c_double), intent(inout), optional :: gaps(*), sizes(*)
            integer(c_int32_t) :: r
        end function nurbs_boundary_contacts
        function nurbs_singular_points(g, tolerance, cap, params, boxes, count, complete) bind(c) &
            result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), boxes(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t), intent(inout), optional :: complete
            integer(c_int32_t) :: r
        end function nurbs_singular_points
        function nurbs_fold_test(g, reference, result, positive, negative) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: reference(*)
            integer(c_int32_t), intent(inout) :: result
            real(c_double), intent(inout), optional :: positive(*), negative(*)
            integer(c_int32_t) :: r
        end function nurbs_fold_test
        function nurbs_pull_weight(g, index, params, distance, weight, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: index
            real(c_double), intent(in) :: params(*)
            real(c_double), value :: distance
            real(c_double), intent(inout), optional :: weight
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_pull_weight
        function nurbs_pull_weights(g, count, indices, params, distance, factor, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: count
            integer(c_int64_t), intent(in) :: indices(*)
            real(c_double), intent(in) :: params(*)
            real(c_double), value :: distance
            real(c_double), intent(inout), optional :: factor
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_pull_weights
        function nurbs_set_weights(g, count, indices, weights, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: count
            integer(c_int64_t), intent(in) :: indices(*)
            real(c_double), intent(in) :: weights(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_set_weights
        function nurbs_weight_points(g, index, params, at_zero, at_one, at_weight) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: index
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout), optional :: at_zero(*), at_one(*), at_weight(*)
            integer(c_int32_t) :: r
        end function nurbs_weight_points
        function nurbs_weight_cross_ratio(dim, control_point, at_zero, at_one, at_weight, weight) &
            bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in) :: control_point(*), at_zero(*), at_one(*), at_weight(*)
            real(c_double), intent(inout) :: weight
            integer(c_int32_t) :: r
        end function nurbs_weight_cross_ratio
        function nurbs_weight_through(g, index, params, target, tolerance, weight, out) bind(c) &
            result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: index
            real(c_double), intent(in) :: params(*), target(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: weight
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_weight_through
        function nurbs_pull_point(g, index, params, direction, distance, moved, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: index
            real(c_double), intent(in) :: params(*), direction(*)
            real(c_double), value :: distance
            real(c_double), intent(inout), optional :: moved
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_pull_point
        function nurbs_most_influential(g, n, params, param_stride, param_component_stride, indices, &
            influences) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, param_stride, param_component_stride
            real(c_double), intent(in) :: params(*)
            integer(c_int64_t), intent(inout), optional :: indices(*)
            real(c_double), intent(inout), optional :: influences(*)
            integer(c_int32_t) :: r
        end function nurbs_most_influential
        function nurbs_insert_on_leg(g, axis, index, ratio, knot, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), value :: index
            real(c_double), value :: ratio
            real(c_double), intent(inout), optional :: knot
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_insert_on_leg
        function nurbs_insert_at_point(g, axis, point, tolerance, index, ratio, knot, out) bind(c) &
            result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), intent(in) :: point(*)
            real(c_double), value :: tolerance
            integer(c_int64_t), intent(inout), optional :: index
            real(c_double), intent(inout), optional :: ratio, knot
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_insert_at_point
        function nurbs_constrain(g, count, kinds, orders, params, targets, keep, costs, weight_costs, &
            tolerance, residuals, rank, moved, optimality, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: count
            integer(c_int32_t), intent(in), optional :: kinds(*), orders(*), keep(*)
            real(c_double), intent(in) :: params(*), targets(*)
            real(c_double), intent(in), optional :: costs(*), weight_costs(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: residuals(*), moved, optimality
            integer(c_int64_t), intent(inout), optional :: rank
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_constrain
        function nurbs_warp(g, range, direction, distance, order, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: range(*)
            real(c_double), intent(in) :: direction(*)
            real(c_double), value :: distance
            integer(c_int32_t), value :: order
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_warp
        function nurbs_flatten(g, range, point, normal, direction, moved, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: range(*), direction(*)
            real(c_double), intent(in) :: point(*), normal(*)
            real(c_double), intent(inout), optional :: moved
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_flatten
        function nurbs_bend(g, origin, along, across, curvature, lower, upper, tolerance, deviation, &
            proven, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: origin(*), along(*), across(*)
            real(c_double), value :: curvature, lower, upper, tolerance
            real(c_double), intent(inout), optional :: deviation
            integer(c_int32_t), intent(inout), optional :: proven
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_bend
        function nurbs_free_form_deform(g, volume, lower, upper, tolerance, deviation, proven, out) &
            bind(c) result(r)
            import
            type(c_ptr), value :: g, volume
            real(c_double), intent(in) :: lower(*), upper(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: deviation
            integer(c_int32_t), intent(inout), optional :: proven
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_free_form_deform
        function nurbs_fair(g, order, keep, tolerance, energies, bound, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: order
            integer(c_int32_t), intent(in), optional :: keep(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: energies(*), bound
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_fair
        function nurbs_snap_boundary(g, axis, end, other, other_axis, other_end, order, flags, bound, &
            out) bind(c) result(r)
            import
            type(c_ptr), value :: g, other
            integer(c_int32_t), value :: axis, end, other_axis, other_end, order, flags
            real(c_double), intent(inout), optional :: bound
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_snap_boundary
        function nurbs_collocation(axes, degrees, counts, knots, knot_count, orders, n, params, param_stride, &
            param_component_stride, cap, values, columns, row_pointers, entries, flags) bind(c) result(r)
            import
            integer(c_int32_t), value :: axes, flags
            integer(c_int32_t), intent(in) :: degrees(*)
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: knots(*), params(*)
            integer(c_int32_t), intent(in), optional :: orders(*)
            integer(c_int64_t), value :: knot_count, n, param_stride, param_component_stride, cap
            real(c_double), intent(inout), optional :: values(*)
            integer(c_int64_t), intent(inout), optional :: columns(*), row_pointers(*)
            integer(c_int64_t), intent(inout), optional :: entries
            integer(c_int32_t) :: r
        end function nurbs_collocation
        function nurbs_rational_collocation(g, orders, n, params, param_stride, param_component_stride, cap, &
            values, columns, row_pointers, entries, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), intent(in), optional :: orders(*)
            integer(c_int64_t), value :: n, param_stride, param_component_stride, cap
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout), optional :: values(*)
            integer(c_int64_t), intent(inout), optional :: columns(*), row_pointers(*)
            integer(c_int64_t), intent(inout), optional :: entries
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_rational_collocation
        function nurbs_bezier_extraction(g, axis, cap, operators, firsts, domains, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: operators(*), domains(*)
            integer(c_int64_t), intent(inout), optional :: firsts(*)
            integer(c_int64_t), intent(out) :: count
            integer(c_int32_t) :: r
        end function nurbs_bezier_extraction
        function nurbs_eval_adjoint(g, order, n, params, param_stride, param_component_stride, cotangents, &
            cotangent_stride, cotangent_component_stride, grad_points, grad_point_stride, &
            grad_point_component_stride, grad_weights, grad_weight_stride, grad_params, grad_param_stride, &
            grad_param_component_stride, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: order, flags
            integer(c_int64_t), value :: n, param_stride, param_component_stride, cotangent_stride, &
                cotangent_component_stride, grad_point_stride, grad_point_component_stride, &
                grad_weight_stride, grad_param_stride, grad_param_component_stride
            real(c_double), intent(in) :: params(*), cotangents(*)
            real(c_double), intent(inout), optional :: grad_points(*), grad_weights(*), grad_params(*)
            integer(c_int32_t) :: r
        end function nurbs_eval_adjoint
        function nurbs_read_options_init(options, struct_size) bind(c) result(r)
            import
            type(nurbs_read_options), intent(out) :: options
            integer(c_int64_t), value :: struct_size
            integer(c_int32_t) :: r
        end function nurbs_read_options_init
        function nurbs_read(bytes, size, options, out) bind(c) result(r)
            import
            type(c_ptr), value :: bytes
            integer(c_int64_t), value :: size
            type(nurbs_read_options), intent(in), optional :: options
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_read
        function nurbs_read_file(path, options, out) bind(c) result(r)
            import
            character(kind=c_char), intent(in) :: path(*)
            type(nurbs_read_options), intent(in), optional :: options
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_read_file
        function nurbs_list_count(list, count) bind(c) result(r)
            import
            type(c_ptr), value :: list
            integer(c_int64_t), intent(out) :: count
            integer(c_int32_t) :: r
        end function nurbs_list_count
        function nurbs_list_get(list, index, out) bind(c) result(r)
            import
            type(c_ptr), value :: list
            integer(c_int64_t), value :: index
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_list_get
        function nurbs_list_name(list, index, buf, cap, length) bind(c) result(r)
            import
            type(c_ptr), value :: list
            integer(c_int64_t), value :: index, cap
            character(kind=c_char), intent(inout), optional :: buf(*)
            integer(c_int64_t), intent(inout), optional :: length
            integer(c_int32_t) :: r
        end function nurbs_list_name
        function nurbs_list_note_count(list, count) bind(c) result(r)
            import
            type(c_ptr), value :: list
            integer(c_int64_t), intent(out) :: count
            integer(c_int32_t) :: r
        end function nurbs_list_note_count
        function nurbs_list_note(list, index, entity_type, line, reason, buf, cap, length) bind(c) result(r)
            import
            type(c_ptr), value :: list
            integer(c_int64_t), value :: index, cap
            integer(c_int32_t), intent(inout), optional :: entity_type, reason
            integer(c_int64_t), intent(inout), optional :: line, length
            character(kind=c_char), intent(inout), optional :: buf(*)
            integer(c_int32_t) :: r
        end function nurbs_list_note
        function nurbs_list_unit(list, metres) bind(c) result(r)
            import
            type(c_ptr), value :: list
            real(c_double), intent(out) :: metres
            integer(c_int32_t) :: r
        end function nurbs_list_unit
        subroutine nurbs_list_destroy(list) bind(c)
            import
            type(c_ptr), value :: list
        end subroutine nurbs_list_destroy
    end interface
end module nurbs_c
