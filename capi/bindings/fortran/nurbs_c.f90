! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h by: python3 cmake/interface/generate.py . - do not edit.
!> The functions of nurbs.h as they stand, argument by argument; that header is the manual. Here the indices of axes,
!> spans and list entries count from 0, flags are 32-bit patterns, and the optional arguments are those that may be
!> NULL. Outputs other than handles are intent(inout) because a failing call leaves them as they were.
module nurbs_c
    use, intrinsic :: iso_c_binding
    implicit none
    public

    !> Limit of work and progress callback of a long call; fill with nurbs_call_options_init() first. Fields
    !> are only ever appended, and struct_size is at most 4096.
    type, bind(c) :: nurbs_call_options
        integer(c_int64_t) :: struct_size  ! size of this struct as the caller knows it
        integer(c_int64_t) :: work  ! largest number of multiply-adds; 0: no limit of the caller
        type(c_funptr) :: progress  ! or NULL: called now and then
        type(c_ptr) :: user  ! or NULL: passed to progress
    end type nurbs_call_options

    !> Data: values at parameters, with weights. nurbs_data_init() sets all fields to 0 or NULL. Fields are
    !> only ever appended. \since 1.1
    type, bind(c) :: nurbs_data
        integer(c_int64_t) :: struct_size  ! size of this struct as the caller knows it
        integer(c_int64_t) :: n  ! number of data, >= 0
        integer(c_int32_t) :: axes  ! number of parameters, 1 to 3
        integer(c_int32_t) :: dim  ! dimension of the values
        type(c_ptr) :: params  ! [n][axes] the parameters
        integer(c_int64_t) :: param_stride  ! distance between parameters, 0 = packed
        integer(c_int64_t) :: param_component_stride  ! distance between components, 0 = 1
        type(c_ptr) :: values  ! [n][dim] the values
        integer(c_int64_t) :: value_stride  ! distance between values, 0 = packed
        integer(c_int64_t) :: value_component_stride  ! distance between components, 0 = 1
        type(c_ptr) :: weights  ! [n] or NULL for 1: weights >= 0; 0 leaves the value out
        integer(c_int64_t) :: weight_stride  ! distance between weights, 0 = 1
        ! evaluation flags for params, without NURBS_EXTRAPOLATE; with NURBS_NAN a parameter that is outside
        ! or not finite leaves its value out
        integer(c_int32_t) :: flags
        integer(c_int32_t) :: reserved  ! 0
    end type nurbs_data

    !> Settings of a fit: smoothing, conditions, robustness and shape. nurbs_fit_options_init() fills in the
    !> defaults, which NULL stands for as well. Fields are only ever appended. \since 1.1
    type, bind(c) :: nurbs_fit_options
        integer(c_int64_t) :: struct_size  ! size of this struct as the caller knows it
        integer(c_int32_t) :: smoothing  ! a NURBS_SMOOTHING_ constant; default NURBS_SMOOTHING_NONE
        ! m, the order of the derivative that is penalised, >= 1; default 2
        integer(c_int32_t) :: penalty_order
        real(c_double) :: lambda  ! the factor of the penalty, for NURBS_SMOOTHING_LAMBDA, >= 0; default 0
        ! for NURBS_SMOOTHING_DISCREPANCY: largest sum_i w_i |y_i - s(t_i)|^2, >= 0; default 0
        real(c_double) :: target
        ! 1: of several solutions take that of the smallest penalty; 0: refuse them
        integer(c_int32_t) :: regularize
        integer(c_int32_t) :: reserved  ! 0
        integer(c_int64_t) :: conditions  ! number of equations that the fit has to fulfil, >= 0; default 0
        type(c_ptr) :: condition_params  ! [conditions][axes] or NULL: parameters, packed
        type(c_ptr) :: condition_orders  ! [conditions][axes] or NULL for 0: orders of derivatives
        type(c_ptr) :: condition_targets  ! [conditions][dim] or NULL: points and derivatives, packed
        ! a NURBS_ROBUST_ constant; others than NURBS_ROBUST_NONE, the default, are for fits of points over
        ! given knots
        integer(c_int32_t) :: robust
        integer(c_int32_t) :: reserved2  ! 0
        ! where outliers begin, in standard deviations, >= 0; 0: the usual width
        real(c_double) :: robust_width
        type(c_ptr) :: shapes  ! [axes][dim] or NULL: sums of NURBS_TREND_ constants, or 0
        type(c_ptr) :: lower  ! [dim] or NULL: lower bounds of coordinates; -INFINITY for none
        type(c_ptr) :: upper  ! [dim] or NULL: upper bounds of coordinates; INFINITY for none
    end type nurbs_fit_options

    !> What is known of a fit. Set struct_size to sizeof(nurbs_fit_report); all other fields are results.
    !> Fields are only ever appended. \since 1.1
    type, bind(c) :: nurbs_fit_report
        integer(c_int64_t) :: struct_size  ! size of this struct as the caller knows it
        integer(c_int64_t) :: data_count  ! receives the number of data that count
        real(c_double) :: weight  ! receives the sum of their weights
        real(c_double) :: squares  ! receives sum_i w_i |y_i - s(t_i)|^2
        real(c_double) :: rms  ! receives the square root of squares / weight
        real(c_double) :: lambda  ! receives the factor of the penalty that was taken
        ! receives the trace of the influence matrix: effective number of parameters
        real(c_double) :: freedom
        ! receives the standard deviation of a coordinate of weight 1, from residuals; of robust fits from
        ! their median
        real(c_double) :: sigma
        real(c_double) :: residual  ! receives |G x + lambda P x - r| / |r| of the normal equations
        real(c_double) :: largest  ! receives the largest |y_i - s(t_i)|; NaN from nurbs_fit()
        integer(c_int64_t) :: largest_index  ! receives the index of that datum; -1 from nurbs_fit()
        integer(c_int32_t) :: bits  ! receives a sum of NURBS_FIT_ bits
        integer(c_int32_t) :: rounds  ! receives the number of fits that a robust fit took, else 1
        integer(c_int64_t) :: outliers  ! receives the number of data with x > 1 of a robust fit, else 0
    end type nurbs_fit_report

    !> Settings of nurbs_fit_cloud(). nurbs_cloud_options_init() fills in the defaults, which NULL stands for
    !> as well. Fields are only ever appended. \since 1.1
    type, bind(c) :: nurbs_cloud_options
        integer(c_int64_t) :: struct_size  ! size of this struct as the caller knows it
        ! m, the order of the derivative that is penalised, >= 1; default 2
        integer(c_int32_t) :: penalty_order
        integer(c_int32_t) :: rounds  ! most searches for the nearest points of all points, >= 1; default 100
        real(c_double) :: lambda  ! the factor of the penalty; below 0: found; default -1
        ! the factor at the start, which falls to lambda; below 0: found; default -1
        real(c_double) :: first_lambda
        ! the smallest relative decrease of the sum worth a step, >= 0; default 1e-3
        real(c_double) :: tolerance
    end type nurbs_cloud_options

    !> What is known of a fit by nurbs_fit_cloud(). Set struct_size to sizeof(nurbs_cloud_report); all other
    !> fields are results. Fields are only ever appended. \since 1.1
    type, bind(c) :: nurbs_cloud_report
        integer(c_int64_t) :: struct_size  ! size of this struct as the caller knows it
        ! receives the number of points that count: those of a weight above 0
        integer(c_int64_t) :: data_count
        real(c_double) :: weight  ! receives the sum of their weights
        real(c_double) :: squares  ! receives sum_i w_i d_i^2, d_i the distance of point i from the result
        real(c_double) :: rms  ! receives the square root of squares / weight
        real(c_double) :: largest  ! receives the largest d_i
        integer(c_int64_t) :: largest_index  ! receives the index of that point
        real(c_double) :: lambda  ! receives the last factor of the penalty
        real(c_double) :: noise  ! receives a bound of the error of a d_i, if its nearest point is certified
        ! receives the number of points whose nearest point is on an end or an edge
        integer(c_int64_t) :: boundary
        integer(c_int64_t) :: uncertified  ! receives the number of points whose nearest point is not proven
        integer(c_int32_t) :: rounds  ! receives the number of searches for the nearest points of all points
        integer(c_int32_t) :: bits  ! receives a sum of NURBS_CLOUD_ bits
    end type nurbs_cloud_report

    !> Inputs of the batch functions for closest points in their form as long calls. Set struct_size to
    !> sizeof(nurbs_closest_query), and what is not wanted to 0: fields that are 0 or NULL have their
    !> defaults. Fields that a function does not use must be 0 or NULL (NURBS_ERROR_OPTIONS). Fields are only
    !> ever appended, and struct_size is at most 4096.
    type, bind(c) :: nurbs_closest_query
        integer(c_int64_t) :: struct_size  ! size of this struct as the caller knows it
        integer(c_int64_t) :: n  ! number of points
        type(c_ptr) :: points  ! [n][dim] the points
        integer(c_int64_t) :: point_stride  ! distance between points, 0 = packed
        integer(c_int64_t) :: point_component_stride  ! distance between components, 0 = 1
        type(c_ptr) :: guesses  ! [n][axes] or NULL: where nurbs_closest_local_with() begins
        integer(c_int64_t) :: guess_stride  ! distance between guesses, 0 = packed
        integer(c_int64_t) :: guess_component_stride  ! distance between components, 0 = 1
        type(c_ptr) :: range  ! [axes][2] or NULL for all of it: the part of the domain
        real(c_double) :: tolerance  ! >= 0
        integer(c_int64_t) :: budget  ! most pieces examined for each point, 0 as for nurbs_closest_points()
        integer(c_int32_t) :: flags  ! NURBS_NAN_POINTS or 0
        integer(c_int32_t) :: reserved  ! 0
    end type nurbs_closest_query

    !> Outputs of the batch functions for closest points in their form as long calls: arrays of the caller,
    !> NULL for what is not wanted. Set struct_size to sizeof(nurbs_closest_answer). Arrays that a function
    !> does not fill must be NULL (NURBS_ERROR_OPTIONS). Fields are only ever appended, and struct_size is at
    !> most 4096.
    type, bind(c) :: nurbs_closest_answer
        integer(c_int64_t) :: struct_size  ! size of this struct as the caller knows it
        type(c_ptr) :: params  ! [n][axes] or NULL: the parameters
        integer(c_int64_t) :: param_stride  ! distance between parameters, 0 = packed
        integer(c_int64_t) :: param_component_stride  ! distance between components, 0 = 1
        type(c_ptr) :: feet  ! [n][dim] or NULL: the points of the spline
        integer(c_int64_t) :: foot_stride  ! distance between feet, 0 = packed
        integer(c_int64_t) :: foot_component_stride  ! distance between components, 0 = 1
        type(c_ptr) :: distances  ! [n] or NULL: the distances, of nurbs_curve_signed_distances_with() signed
        integer(c_int64_t) :: distance_stride  ! distance between distances, 0 = 1
        type(c_ptr) :: status  ! [n] or NULL: sums of NURBS_CLOSEST_ bits
    end type nurbs_closest_answer

    !> The constraints of nurbs_constrain() as one argument. Set struct_size to sizeof(nurbs_constraints), and
    !> what is not wanted to 0. Fields are only ever appended, and struct_size is at most 4096.
    type, bind(c) :: nurbs_constraints
        integer(c_int64_t) :: struct_size  ! size of this struct as the caller knows it
        integer(c_int64_t) :: count  ! number of constraints, > 0
        type(c_ptr) :: kinds  ! [count] or NULL: as for nurbs_constrain(), like all fields that follow
        type(c_ptr) :: orders  ! [count][axes] or NULL: orders of derivatives
        type(c_ptr) :: params  ! [count][axes] parameters
        type(c_ptr) :: targets  ! [count][dim] targets
        type(c_ptr) :: keep  ! [axes][2] or NULL: derivatives that stay at the ends
        type(c_ptr) :: costs  ! [N] or NULL: of moving control points
        type(c_ptr) :: weight_costs  ! [N] or NULL: of changing weights
        real(c_double) :: tolerance  ! largest residual, >= 0
    end type nurbs_constraints

    !> What nurbs_constrain() tells about its solution. Set struct_size to sizeof(nurbs_constraint_report),
    !> and residuals. Fields are only ever appended, and struct_size is at most 4096.
    type, bind(c) :: nurbs_constraint_report
        integer(c_int64_t) :: struct_size  ! size of this struct as the caller knows it
        type(c_ptr) :: residuals  ! [count] or NULL: an array of the caller, which receives the residuals
        integer(c_int64_t) :: rank  ! receives the number of independent equations
        real(c_double) :: moved  ! receives the largest distance by which a control point moved
        real(c_double) :: optimality  ! receives the relative length of the gradient
    end type nurbs_constraint_report

    !> Settings for nurbs_read(); fill with nurbs_read_options_init() first. Fields are only ever appended,
    !> and struct_size is at most 4096. A file whose own unit is not known cannot be converted to another:
    !> NURBS_ERROR_OPTIONS.
    type, bind(c) :: nurbs_read_options
        integer(c_int64_t) :: struct_size  ! size of this struct as the caller knows it
        real(c_double) :: unit  ! wanted unit in metres (0.001: millimetres); 0 keeps the file's own
        integer(c_int64_t) :: max_bytes  ! largest file accepted; 0 means the default, 2^30
        ! the distance, in the unit of the result, that counts as zero: the tolerance of faces, and how near
        ! to what the file states is what has to be made; 0 for the uncertainty or resolution that the file
        ! states. \since 1.1
        real(c_double) :: tolerance
        ! sum of NURBS_READ_ constants, 0 for all of them; others are left out without a note. \since 1.1
        integer(c_int32_t) :: kinds
        integer(c_int32_t) :: reserved  ! 0
    end type nurbs_read_options

    !> How near a mesh has to be to its shape; fill with nurbs_mesh_options_init() first. NULL stands for the
    !> defaults as well. Fields are only ever appended, and struct_size is at most 4096. All limits that are
    !> given hold. The extent is the longest side of the box of all control points of all surfaces. \since 1.1
    type, bind(c) :: nurbs_mesh_options
        integer(c_int64_t) :: struct_size  ! size of this struct as the caller knows it
        real(c_double) :: chord  ! largest distance between shape and mesh, both ways, > 0; default INFINITY
        real(c_double) :: relative_chord  ! the same as a share of the extent, >= 0; 0: no limit; default 1e-3
        real(c_double) :: longest  ! largest length of sides of triangles, >= 0; 0: no limit; default 0
        real(c_double) :: angle  ! of triangles' corner normals, radians, 0 to pi; 0, pi: no limit; default 0
        ! smallest of triangles inside, radians, 0 to pi / 6; 0: no limit; default 0
        real(c_double) :: minimum_angle
    end type nurbs_mesh_options

    !> Settings for nurbs_model_write() and similar functions; fill with nurbs_write_options_init() first.
    !> Fields are only ever appended, and struct_size is at most 4096. Without a tolerance each part of a STEP
    !> file gets the least one of its faces that is not 0, since readers enlarge it where edges need that, but
    !> no less than 10^-4 of the largest one, and 1e-7 metres if it has none. IGES has one for the whole file,
    !> the least of all faces, but no less than 10^-4 of those that are above 1 % of the size of their
    !> surfaces: readers find the others.
    type, bind(c) :: nurbs_write_options
        integer(c_int64_t) :: struct_size  ! size of this struct as the caller knows it
        real(c_double) :: unit  ! unit of the file in metres; 0: that of the model, millimetres if it has none
        ! distance that counts as none, in units of the file; 0: that of the faces
        real(c_double) :: tolerance
    end type nurbs_write_options

    interface
        ! --- Version and errors
        !> Version of the library that is running, encoded like NURBS_VERSION.
        function nurbs_version() bind(c) result(r)
            import
            integer(c_int32_t) :: r
        end function nurbs_version
        !> Name of a status, such as "NURBS_ERROR_NULL".
        function nurbs_status_name(status) bind(c) result(r)
            import
            integer(c_int32_t), value :: status
            type(c_ptr) :: r
        end function nurbs_status_name
        !> Copies the message of the last failed call in the calling thread, such as "params[17] = 1.2 outside
        !> [0, 1]".
        function nurbs_last_error(buf, cap) bind(c) result(r)
            import
            character(kind=c_char), intent(inout), optional :: buf(*)
            integer(c_int64_t), value :: cap
            integer(c_int64_t) :: r
        end function nurbs_last_error
        ! --- Long calls
        !> Fills an options struct with the defaults: no limit, no callback.
        function nurbs_call_options_init(options, struct_size) bind(c) result(r)
            import
            type(nurbs_call_options), intent(inout) :: options
            integer(c_int64_t), value :: struct_size
            integer(c_int32_t) :: r
        end function nurbs_call_options_init
        ! --- Construction
        !> A spline from full knot vectors, Cartesian points and optional weights.
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
        !> A rational spline from homogeneous points (w x, w y, ..., w).
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
        !> A spline from knot vectors without their first and last knot, as openNURBS, Rhino and Maya write
        !> them.
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
        !> A spline from distinct knots with multiplicities, as STEP and Open CASCADE write them.
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
        !> A spline whose periodic axes are given without what they repeat: each control point once, and the
        !> knots of one period.
        function nurbs_create_periodic(axes, degrees, counts, knots, knot_count, dim, points, point_stride, &
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
        end function nurbs_create_periodic
        !> A Bezier curve, patch or volume over [0, 1] on every axis: degrees[k] + 1 points along axis k, N in
        !> all, no knots.
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
        !> The same degrees, knots, dimension and periodicity with other points; knots and their tables are
        !> shared, not copied.
        function nurbs_with_points(g, points, point_stride, point_component_stride, weights, weight_stride, &
                out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: points(*)
            integer(c_int64_t), value :: point_stride, point_component_stride, weight_stride
            real(c_double), intent(in), optional :: weights(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_with_points
        !> Another handle on the same spline, in constant time.
        function nurbs_clone(g, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_clone
        !> Frees a handle.
        subroutine nurbs_destroy(g) bind(c)
            import
            type(c_ptr), value :: g
        end subroutine nurbs_destroy
        ! --- Knot vectors
        !> Uniform unclamped knots: t_i = a + (i - p) h with h = (b - a) / (count - p); domain [a, b].
        function nurbs_knots_uniform(degree, count, a, b, knot_count, knots) bind(c) result(r)
            import
            integer(c_int32_t), value :: degree
            integer(c_int64_t), value :: count, knot_count
            real(c_double), value :: a, b
            real(c_double), intent(inout) :: knots(*)
            integer(c_int32_t) :: r
        end function nurbs_knots_uniform
        !> Open uniform (quasi-uniform, clamped) knots: a and b degree + 1 times, the others evenly between.
        function nurbs_knots_open_uniform(degree, count, a, b, knot_count, knots) bind(c) result(r)
            import
            integer(c_int32_t), value :: degree
            integer(c_int64_t), value :: count, knot_count
            real(c_double), value :: a, b
            real(c_double), intent(inout) :: knots(*)
            integer(c_int32_t) :: r
        end function nurbs_knots_open_uniform
        !> Piecewise Bezier knots: the ends degree + 1 times, each inner break degree times (degree 0: once).
        function nurbs_knots_bezier(degree, pieces, breaks, knot_count, knots) bind(c) result(r)
            import
            integer(c_int32_t), value :: degree
            integer(c_int64_t), value :: pieces, knot_count
            real(c_double), intent(in), optional :: breaks(*)
            real(c_double), intent(inout) :: knots(*)
            integer(c_int32_t) :: r
        end function nurbs_knots_bezier
        !> Clamped knots averaged from parameters, for interpolation: t_(j+p) = (s_j + ... + s_(j+p-1)) / p, j
        !> = 1, ..., count - p - 1; the ends are s_0 and s_(count-1).
        function nurbs_knots_averaged(degree, count, params, knot_count, knots) bind(c) result(r)
            import
            integer(c_int32_t), value :: degree
            integer(c_int64_t), value :: count, knot_count
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout) :: knots(*)
            integer(c_int32_t) :: r
        end function nurbs_knots_averaged
        !> Periodic knots from the breaks of one period: the given knots with their multiplicities, continued
        !> with the period on both sides.
        function nurbs_knots_periodic(degree, n, breaks, multiplicities, knot_count, knots) bind(c) result(r)
            import
            integer(c_int32_t), value :: degree
            integer(c_int64_t), value :: n, knot_count
            real(c_double), intent(in) :: breaks(*)
            integer(c_int32_t), intent(in), optional :: multiplicities(*)
            real(c_double), intent(inout) :: knots(*)
            integer(c_int32_t) :: r
        end function nurbs_knots_periodic
        ! --- Inspection
        !> Number of parametric axes: 1 curve, 2 surface, 3 volume.
        function nurbs_axes(g, axes) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), intent(inout) :: axes
            integer(c_int32_t) :: r
        end function nurbs_axes
        !> Dimension of the (Cartesian) points.
        function nurbs_dimension(g, dim) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), intent(inout) :: dim
            integer(c_int32_t) :: r
        end function nurbs_dimension
        !> Degree along an axis.
        function nurbs_degree(g, axis, degree) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int32_t), intent(inout) :: degree
            integer(c_int32_t) :: r
        end function nurbs_degree
        !> Number of control points along an axis.
        function nurbs_count(g, axis, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), intent(inout) :: count
            integer(c_int32_t) :: r
        end function nurbs_count
        !> Number N of control points of all axes together: the product of the counts.
        function nurbs_point_count(g, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), intent(inout) :: count
            integer(c_int32_t) :: r
        end function nurbs_point_count
        !> Whether the spline carries weights, equal ones included.
        function nurbs_is_rational(g, rational) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), intent(inout) :: rational
            integer(c_int32_t) :: r
        end function nurbs_is_rational
        !> Whether the stored values are homogeneous points: those of nurbs_create_homogeneous(), and of
        !> operations on such a spline that keep its weights.
        function nurbs_is_homogeneous(g, homogeneous) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), intent(inout) :: homogeneous
            integer(c_int32_t) :: r
        end function nurbs_is_homogeneous
        !> The full knot vector of an axis.
        function nurbs_knots(g, axis, knot_count, knots) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), value :: knot_count
            real(c_double), intent(inout) :: knots(*)
            integer(c_int32_t) :: r
        end function nurbs_knots
        !> The knots of an axis without the first and the last one, as nurbs_create_short() takes them and
        !> openNURBS, Rhino and Maya keep them.
        function nurbs_short_knots(g, axis, cap, knots, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: knots(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_short_knots
        !> The distinct knots of an axis and how often each occurs; those outside the domain are included.
        function nurbs_distinct_knots(g, axis, cap, knots, multiplicities, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: knots(*)
            integer(c_int32_t), intent(inout), optional :: multiplicities(*)
            integer(c_int64_t), intent(inout) :: count
            integer(c_int32_t) :: r
        end function nurbs_distinct_knots
        !> Form of the knot vector of an axis: clamped at the start, at the end, declared periodic; 0 is
        !> plainly unclamped.
        function nurbs_knot_form(g, axis, form) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int32_t), intent(inout) :: form
            integer(c_int32_t) :: r
        end function nurbs_knot_form
        !> Domain of an axis: [knots[degree], knots[count]].
        function nurbs_domain(g, axis, domain) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), intent(inout) :: domain(*)
            integer(c_int32_t) :: r
        end function nurbs_domain
        !> Greville abscissae of an axis: x_i = (t_(i+1) + ... + t_(i+p)) / p; for degree 0 (t_i + t_(i+1)) /
        !> 2.
        function nurbs_greville(g, axis, count, abscissae) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), value :: count
            real(c_double), intent(inout) :: abscissae(*)
            integer(c_int32_t) :: r
        end function nurbs_greville
        !> The Cartesian control points.
        function nurbs_points(g, count, points, point_stride, point_component_stride) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: count, point_stride, point_component_stride
            real(c_double), intent(inout) :: points(*)
            integer(c_int32_t) :: r
        end function nurbs_points
        !> The weights; all 1 for a polynomial spline.
        function nurbs_weights(g, count, weights, weight_stride) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: count, weight_stride
            real(c_double), intent(inout) :: weights(*)
            integer(c_int32_t) :: r
        end function nurbs_weights
        !> The homogeneous control points (w x, w y, ..., w); w = 1 for a polynomial spline.
        function nurbs_homogeneous_points(g, count, points, point_stride, point_component_stride) bind(c) &
                result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: count, point_stride, point_component_stride
            real(c_double), intent(inout) :: points(*)
            integer(c_int32_t) :: r
        end function nurbs_homogeneous_points
        !> Number of control points along an axis, each counted once: count - degree on a periodic axis, count
        !> on any other.
        function nurbs_unwrapped_count(g, axis, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), intent(inout) :: count
            integer(c_int32_t) :: r
        end function nurbs_unwrapped_count
        !> The knots of an axis as nurbs_create_periodic() takes them: those from the start to the end of the
        !> domain of a periodic axis, knots[degree] to knots[count], and all knots of any other.
        function nurbs_unwrapped_knots(g, axis, cap, knots, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: knots(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_unwrapped_knots
        !> Control points and weights, each once, as nurbs_create_periodic() takes them: along periodic axes
        !> without the last `degree` ones, which repeat others.
        function nurbs_unwrapped_points(g, cap, points, weights, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: points(*), weights(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_unwrapped_points
        !> Local hull size: the largest |coordinate| among the active control points of positive weight at
        !> each parameter, the `hull` of the accuracy contract.
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
        ! --- Bases
        !> Span of each parameter: the index s with knots[s] <= t < knots[s+1] (the last span is closed),
        !> degree <= s < count, never an empty span.
        function nurbs_find_spans(degree, count, knots, knot_count, n, params, param_stride, spans, flags) &
                bind(c) result(r)
            import
            integer(c_int32_t), value :: degree, flags
            integer(c_int64_t), value :: count, knot_count, n, param_stride
            real(c_double), intent(in) :: knots(*), params(*)
            integer(c_int64_t), intent(inout) :: spans(*)
            integer(c_int32_t) :: r
        end function nurbs_find_spans
        !> Bernstein polynomials B_(j,p)(t) = binomial(p, j) t^j (1 - t)^(p - j), j = 0, ..., p, and their
        !> derivatives.
        function nurbs_bernstein(degree, order, n, params, param_stride, values, value_stride, &
                value_component_stride) bind(c) result(r)
            import
            integer(c_int32_t), value :: degree, order
            integer(c_int64_t), value :: n, param_stride, value_stride, value_component_stride
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout) :: values(*)
            integer(c_int32_t) :: r
        end function nurbs_bernstein
        !> B-spline basis functions that do not vanish at each parameter, and their derivatives (Cox-de Boor
        !> recurrence).
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
        !> Rational basis functions R_i(t) = w_i N_i(t) / w(t) of the active control points; N_i for a
        !> polynomial spline.
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
        !> Gradients in space of the rational basis functions of nurbs_rational_basis(): of R_i as a function
        !> of the point, J (J^T J)^-1 dR_i/dt with J [dim][axes] the derivatives of the spline.
        function nurbs_basis_gradients(g, n, params, param_stride, param_component_stride, spans, gradients, &
                gradient_stride, gradient_component_stride, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, param_stride, param_component_stride, gradient_stride, &
                gradient_component_stride
            real(c_double), intent(in) :: params(*)
            integer(c_int64_t), intent(inout), optional :: spans(*)
            real(c_double), intent(inout) :: gradients(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_basis_gradients
        ! --- Evaluation
        !> Points at parameters.
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
        !> Number of derivative slots S = binomial(order + axes, axes), the partial derivatives of orders 0 to
        !> `order`.
        function nurbs_derivative_slots(axes, order, slots) bind(c) result(r)
            import
            integer(c_int32_t), value :: axes, order
            integer(c_int64_t), intent(inout) :: slots
            integer(c_int32_t) :: r
        end function nurbs_derivative_slots
        !> Points and all partial derivatives up to an order, by the quotient rule when rational (Piegl &
        !> Tiller A4.2, A4.4).
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
        !> Points on the grid of all combinations of one parameter from each axis.
        function nurbs_eval_grid(g, counts, params, points, point_stride, point_component_stride, flags) &
                bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout) :: points(*)
            integer(c_int64_t), value :: point_stride, point_component_stride
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_eval_grid
        !> Points and partial derivatives on a grid.
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
        !> Points at parameters in single precision: the results of nurbs_eval(), each rounded once to the
        !> nearest float.
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
        !> Points on a grid in single precision: the results of nurbs_eval_grid(), each rounded once to the
        !> nearest float.
        function nurbs_eval_grid_f32(g, counts, params, points, point_stride, point_component_stride, flags) &
                bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: params(*)
            real(c_float), intent(inout) :: points(*)
            integer(c_int64_t), value :: point_stride, point_component_stride
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_eval_grid_f32
        !> The iso-curve of a surface, or iso-surface of a volume, on which the parameter of one axis is
        !> fixed.
        function nurbs_iso(g, axis, param, flags, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, flags
            real(c_double), value :: param
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_iso
        ! --- Frames and curvature
        !> Points, first derivatives and unit normals of a surface in space.
        function nurbs_surface_eval_frames(g, n, params, param_stride, param_component_stride, points, &
                point_stride, point_component_stride, du, du_stride, du_component_stride, dv, dv_stride, &
                dv_component_stride, normals, normal_stride, normal_component_stride, status, flags) bind(c) &
                result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, param_stride, param_component_stride, point_stride, &
                point_component_stride, du_stride, du_component_stride, dv_stride, dv_component_stride, &
                normal_stride, normal_component_stride
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout), optional :: points(*), du(*), dv(*), normals(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_surface_eval_frames
        !> The same on the grid of all combinations of a parameter of each axis.
        function nurbs_surface_eval_grid_frames(g, counts, params, points, point_stride, &
                point_component_stride, du, du_stride, du_component_stride, dv, dv_stride, &
                dv_component_stride, normals, normal_stride, normal_component_stride, status, flags) bind(c) &
                result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout), optional :: points(*), du(*), dv(*), normals(*)
            integer(c_int64_t), value :: point_stride, point_component_stride, du_stride, &
                du_component_stride, dv_stride, dv_component_stride, normal_stride, normal_component_stride
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_surface_eval_grid_frames
        !> Principal curvatures and directions of a surface in space, mean and Gaussian curvature.
        function nurbs_surface_eval_curvatures(g, n, params, param_stride, param_component_stride, &
                principal, principal_stride, principal_component_stride, directions, direction_stride, &
                direction_component_stride, mean, mean_stride, gaussian, gaussian_stride, status, flags) &
                bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, param_stride, param_component_stride, principal_stride, &
                principal_component_stride, direction_stride, direction_component_stride, mean_stride, &
                gaussian_stride
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout), optional :: principal(*), directions(*), mean(*), gaussian(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_surface_eval_curvatures
        !> Frenet frames of a curve in the plane or in space.
        function nurbs_curve_eval_frames(g, n, params, param_stride, points, point_stride, &
                point_component_stride, tangents, tangent_stride, tangent_component_stride, normals, &
                normal_stride, normal_component_stride, binormals, binormal_stride, &
                binormal_component_stride, curvatures, curvature_stride, torsions, torsion_stride, status, &
                flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, param_stride, point_stride, point_component_stride, &
                tangent_stride, tangent_component_stride, normal_stride, normal_component_stride, &
                binormal_stride, binormal_component_stride, curvature_stride, torsion_stride
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout), optional :: points(*), tangents(*), normals(*), binormals(*), &
                curvatures(*), torsions(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_curve_eval_frames
        !> Rotation-minimizing frames along a sequence of points of a curve in space, by double reflection
        !> (Wang, Juttler, Zheng & Liu 2008): frames that turn about the tangent as little as possible.
        function nurbs_curve_rotation_minimizing_frames(g, n, params, param_stride, first_normal, points, &
                point_stride, point_component_stride, tangents, tangent_stride, tangent_component_stride, &
                normals, normal_stride, normal_component_stride, binormals, binormal_stride, &
                binormal_component_stride, status, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, param_stride, point_stride, point_component_stride, &
                tangent_stride, tangent_component_stride, normal_stride, normal_component_stride, &
                binormal_stride, binormal_component_stride
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(in), optional :: first_normal(*)
            real(c_double), intent(inout), optional :: points(*), tangents(*), normals(*), binormals(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_curve_rotation_minimizing_frames
        ! --- Refinement
        !> Inserts a knot without changing the shape (Boehm 1980).
        function nurbs_insert_knot(g, axis, knot, times, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, times
            real(c_double), value :: knot
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_insert_knot
        !> Inserts a list of knots at once without changing the shape.
        function nurbs_refine(g, axis, count, knots, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), value :: count
            real(c_double), intent(in) :: knots(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_refine
        !> Divides every non-empty span of the domain into equal parts by knots: a + (b - a) i / parts, 0 < i
        !> < parts, in the span [a, b].
        function nurbs_refine_uniform(g, axis, parts, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), value :: parts
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_refine_uniform
        !> The matrix A of nurbs_refine() along one axis, as compressed sparse rows (CSR): new layer i is
        !> sum_j A[i][j] * old layer j, with homogeneous points when rational.
        function nurbs_refinement_matrix(g, axis, count, knots, cap, values, columns, row_pointers, entries) &
                bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), value :: count, cap
            real(c_double), intent(in) :: knots(*)
            real(c_double), intent(inout), optional :: values(*)
            integer(c_int64_t), intent(inout), optional :: columns(*), row_pointers(*), entries
            integer(c_int32_t) :: r
        end function nurbs_refinement_matrix
        !> Splits a spline at a parameter of an axis, for a single Bezier piece by de Casteljau's subdivision.
        function nurbs_split(g, axis, param, lower, upper) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), value :: param
            type(c_ptr), intent(out) :: lower, upper
            integer(c_int32_t) :: r
        end function nurbs_split
        !> The part of a curve, surface or volume over a box in the domain.
        function nurbs_extract(g, lower, upper, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: lower(*), upper(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_extract
        !> Decomposes a spline into its polynomial (rational) pieces, as Bezier splines over their own
        !> domains: each has degree + 1 layers along each axis.
        function nurbs_decompose(g, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_decompose
        !> The pieces of nurbs_decompose() as arrays, in one call: the same control points and weights, bit
        !> for bit, in the same order, without a handle for each.
        function nurbs_bezier_pieces(g, cap, points, weights, domains, piece_counts, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: points(*), weights(*), domains(*)
            integer(c_int64_t), intent(inout), optional :: piece_counts(*)
            integer(c_int64_t), intent(inout) :: count
            integer(c_int32_t) :: r
        end function nurbs_bezier_pieces
        !> Splits a spline at all knots inside the domain of an axis where its order of continuity, degree -
        !> multiplicity, is less than a given one: 0 at jumps, 1 also at kinks (where it is only continuous),
        !> `degree` at every knot.
        function nurbs_split_at_knots(g, axis, order, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, order
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_split_at_knots
        !> Clamps ends of an axis: knots are inserted until the end of the domain occurs degree + 1 times, and
        !> what lies outside the domain is dropped.
        function nurbs_clamp_ends(g, axis, flags, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, flags
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_clamp_ends
        !> Moves the seam of a periodic axis: the same shape, periodic again, over [param, param + period].
        function nurbs_move_seam(g, axis, param, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), value :: param
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_move_seam
        !> Joins splines end to end along an axis.
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
        !> Makes near-equal knots of an axis equal; control points stay.
        function nurbs_snap_knots(g, axis, tolerance, deviation, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: deviation
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_snap_knots
        !> Brings splines to one degree and one knot vector on every axis, without changing their shapes
        !> unless a tolerance allows it, and all to weights if one of them is rational (and to homogeneous
        !> points if one was built so).
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
        !> Extends a spline beyond an end of an axis by a length of the parameter.
        function nurbs_extend(g, axis, end, amount, order, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, end, order
            real(c_double), value :: amount
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_extend
        !> Unclamps ends of an axis: the end of the domain becomes a single knot, and the knots beyond it
        !> repeat those of the domain with its length as the period, so that even spans go on evenly.
        function nurbs_unclamp(g, axis, flags, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, flags
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_unclamp
        !> Makes a closed spline periodic along an axis, over the same domain.
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
        !> Whether an axis is periodic in fact: its knots repeat as NURBS_PERIODIC asks, and so do its points
        !> and weights, bit for bit.
        function nurbs_detect_periodic(g, axis, periodic) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int32_t), intent(inout) :: periodic
            integer(c_int32_t) :: r
        end function nurbs_detect_periodic
        ! --- Degree and form
        !> Raises the degree along an axis without changing the shape (Prautzsch 1984).
        function nurbs_elevate(g, axis, times, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, times
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_elevate
        !> Turns an axis round: the result at -t is g at t, exactly.
        function nurbs_reverse(g, axis, flags, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, flags
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_reverse
        !> Puts the axes in another order: axis k of the result is axis permutation[k] of g.
        function nurbs_transpose(g, permutation, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), intent(in) :: permutation(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_transpose
        !> Moves the domain [a, b] of an axis to [lower, upper] by the affine map t -> lower + (t - a) (upper
        !> - lower) / (b - a).
        function nurbs_reparametrize(g, axis, lower, upper, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), value :: lower, upper
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_reparametrize
        !> The same spline with weights: a polynomial one gets weights of 1; any other is returned as it is.
        function nurbs_make_rational(g, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_make_rational
        !> The homogeneous points (w x, w y, ..., w) of a spline as the points of a polynomial spline of
        !> dimension dim + 1; the weights of a polynomial g are 1.
        function nurbs_to_homogeneous(g, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_to_homogeneous
        !> The rational spline of dimension dim - 1 whose homogeneous points are the points of a polynomial
        !> spline, as of nurbs_create_homogeneous(): the last coordinate becomes the weight.
        function nurbs_from_homogeneous(g, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_from_homogeneous
        !> Divides all weights by the one of largest magnitude, which becomes 1; if all are equal they are
        !> dropped, and the result is polynomial.
        function nurbs_normalize_weights(g, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_normalize_weights
        !> Changes the parameter of an axis by a rational linear map of its domain [a, b] to itself, which
        !> keeps the shape and changes the weights (Lee & Lucian 1991; Piegl & Tiller 6.4).
        function nurbs_reparametrize_moebius(g, axis, ratio, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), value :: ratio
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_reparametrize_moebius
        !> nurbs_reparametrize_moebius() with the ratio w(a) / w(b), so that the weights at both ends of the
        !> domain of an axis are the same to (4 p + 8) eps.
        function nurbs_equalize_end_weights(g, axis, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_equalize_end_weights
        ! --- Calculus
        !> Values of the polar form (blossom) of a polynomial piece (Ramshaw 1989): the symmetric function of
        !> p arguments, affine in each of them, that at p equal arguments is the spline.
        function nurbs_blossom(g, params, count, args, values, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: params(*), args(*)
            integer(c_int64_t), value :: count
            real(c_double), intent(inout) :: values(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_blossom
        !> The partial derivative of a spline along an axis, as a spline (hodograph).
        function nurbs_derivative(g, axis, order, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, order
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_derivative
        !> The derivative of a spline with respect to a knot, as a spline of the same parameters: C changes by
        !> h times the result, to first order, if knot t_k of an axis is moved by h and everything else stays.
        function nurbs_eval_knot_derivative(g, axis, knot, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), value :: knot
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_eval_knot_derivative
        !> The integral of a polynomial spline along an axis from the lower end a of its domain.
        function nurbs_antiderivative(g, axis, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_antiderivative
        !> The pointwise product of two splines over the same domain on every axis: component by component,
        !> where one of them may have dimension 1 and multiplies all components of the other; or the dot or
        !> cross product.
        function nurbs_product(a, b, flags, out) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            integer(c_int32_t), value :: flags
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_product
        !> nurbs_product() with progress reports, cancellation and a limit of work.
        function nurbs_product_with(a, b, flags, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            integer(c_int32_t), value :: flags
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_product_with
        !> The curve g(f(t)): a curve g over another parameter, or the curve in space that a curve f in the
        !> parameter space of a surface or volume g traces on it.
        function nurbs_compose(g, f, out) bind(c) result(r)
            import
            type(c_ptr), value :: g, f
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_compose
        !> nurbs_compose() with progress reports, cancellation and a limit of work.
        function nurbs_compose_with(g, f, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g, f
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_compose_with
        !> The linear combination alpha a(t) + beta b(t) of two splines over the same domain on every axis.
        function nurbs_sum(a, alpha, b, beta, out) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: alpha, beta
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_sum
        !> The C^1 piecewise cubic curve through points with given derivatives, as a spline with double knots:
        !> its control points are the Bezier points P_i - h_(i-1) T_i / 3 and P_i + h_i T_i / 3 next to each
        !> point, and the two ends, each within 2 eps of the sum of its terms.
        function nurbs_create_hermite(n, params, dim, points, point_stride, point_component_stride, &
                tangents, tangent_stride, tangent_component_stride, out) bind(c) result(r)
            import
            integer(c_int64_t), value :: n, point_stride, point_component_stride, tangent_stride, &
                tangent_component_stride
            real(c_double), intent(in) :: params(*), points(*), tangents(*)
            integer(c_int32_t), value :: dim
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_create_hermite
        !> The points and derivatives of a C^1 piecewise cubic at the ends of its non-empty spans, from which
        !> nurbs_create_hermite() makes the same curve: clamped, with double knots.
        function nurbs_to_hermite(g, cap, params, points, tangents, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), points(*), tangents(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_to_hermite
        !> The power basis of every polynomial piece of a spline: on the piece over the span [a, b] of each
        !> axis.
        function nurbs_to_power(g, cap, coefficients, breaks, piece_counts, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: coefficients(*), breaks(*)
            integer(c_int64_t), intent(inout), optional :: piece_counts(*), count
            integer(c_int32_t) :: r
        end function nurbs_to_power
        !> A spline from the power basis of its pieces, as nurbs_to_power() gives it.
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
        !> The matrix that takes the coefficients of a polynomial over [0, 1] in one basis to those in
        !> another: coefficient i of `to` is sum_j M_ij * coefficient j of `from`.
        function nurbs_basis_matrix(from, to, degree, size, matrix) bind(c) result(r)
            import
            integer(c_int32_t), value :: from, to, degree
            integer(c_int64_t), value :: size
            real(c_double), intent(inout) :: matrix(*)
            integer(c_int32_t) :: r
        end function nurbs_basis_matrix
        ! --- Interpolation
        !> Parameters of points from the distances between them.
        function nurbs_parametrize(axes, counts, dim, points, point_stride, point_component_stride, rule, &
                exponent, flags, params) bind(c) result(r)
            import
            integer(c_int32_t), value :: axes, dim, rule, flags
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: points(*)
            integer(c_int64_t), value :: point_stride, point_component_stride
            real(c_double), value :: exponent
            real(c_double), intent(inout) :: params(*)
            integer(c_int32_t) :: r
        end function nurbs_parametrize
        !> Parameters that do not depend on the points: where the basis functions are largest.
        function nurbs_params_universal(degree, count, params) bind(c) result(r)
            import
            integer(c_int32_t), value :: degree
            integer(c_int64_t), value :: count
            real(c_double), intent(inout) :: params(*)
            integer(c_int32_t) :: r
        end function nurbs_params_universal
        !> The spline of given degrees through points on a grid of parameters.
        function nurbs_interpolate(axes, degrees, counts, params, dim, points, point_stride, &
                point_component_stride, ends, flags, residual, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: axes, dim, flags
            integer(c_int32_t), intent(in) :: degrees(*)
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: params(*), points(*)
            integer(c_int64_t), value :: point_stride, point_component_stride
            integer(c_int32_t), intent(in), optional :: ends(*)
            real(c_double), intent(inout), optional :: residual
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_interpolate
        !> The spline over given knots through points on a grid of parameters.
        function nurbs_interpolate_over_knots(axes, degrees, counts, params, knots, knot_count, dim, points, &
                point_stride, point_component_stride, flags, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: axes, dim, flags
            integer(c_int32_t), intent(in) :: degrees(*)
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: params(*), knots(*), points(*)
            integer(c_int64_t), value :: knot_count, point_stride, point_component_stride
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_interpolate_over_knots
        !> The spline through points on a grid with given derivatives at the ends of axes.
        function nurbs_interpolate_derivatives(axes, degrees, counts, params, orders, dim, values, &
                value_stride, value_component_stride, ends, flags, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: axes, dim, flags
            integer(c_int32_t), intent(in) :: degrees(*)
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: params(*), values(*)
            integer(c_int32_t), intent(in), optional :: orders(*), ends(*)
            integer(c_int64_t), value :: value_stride, value_component_stride
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_interpolate_derivatives
        !> The curve with given points and derivatives, of any orders at any parameters.
        function nurbs_curve_interpolate(degree, n, params, orders, dim, targets, target_stride, &
                target_component_stride, knots, knot_count, flags, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: degree, dim, flags
            integer(c_int64_t), value :: n, target_stride, target_component_stride, knot_count
            real(c_double), intent(in) :: params(*), targets(*)
            integer(c_int32_t), intent(in), optional :: orders(*)
            real(c_double), intent(in), optional :: knots(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_interpolate
        !> The lengths of the tangents of which nurbs_curve_interpolate() is given only the directions.
        function nurbs_tangent_lengths(degree, n, params, orders, dim, targets, target_stride, &
                target_component_stride, knots, knot_count, flags, lengths) bind(c) result(r)
            import
            integer(c_int32_t), value :: degree, dim, flags
            integer(c_int64_t), value :: n, target_stride, target_component_stride, knot_count
            real(c_double), intent(in) :: params(*), targets(*)
            integer(c_int32_t), intent(in), optional :: orders(*)
            real(c_double), intent(in), optional :: knots(*)
            real(c_double), intent(inout) :: lengths(*)
            integer(c_int32_t) :: r
        end function nurbs_tangent_lengths
        !> Derivatives at the points of a curve, each from a few points near it.
        function nurbs_tangents(rule, n, params, dim, points, point_stride, point_component_stride, flags, &
                tangents, tangent_stride, tangent_component_stride) bind(c) result(r)
            import
            integer(c_int32_t), value :: rule, dim, flags
            integer(c_int64_t), value :: n, point_stride, point_component_stride, tangent_stride, &
                tangent_component_stride
            real(c_double), intent(in) :: params(*), points(*)
            real(c_double), intent(inout) :: tangents(*)
            integer(c_int32_t) :: r
        end function nurbs_tangents
        ! --- Fitting
        !> Fills a struct with zeros and its size.
        function nurbs_data_init(data, struct_size) bind(c) result(r)
            import
            type(nurbs_data), intent(inout) :: data
            integer(c_int64_t), value :: struct_size
            integer(c_int32_t) :: r
        end function nurbs_data_init
        !> Statistics of no data, for given degrees, breaks, dimension and scales.
        function nurbs_statistics_create(axes, degrees, break_counts, breaks, break_total, dim, value_scale, &
                weight_scale, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: axes, dim
            integer(c_int32_t), intent(in) :: degrees(*)
            integer(c_int64_t), intent(in) :: break_counts(*)
            real(c_double), intent(in) :: breaks(*)
            integer(c_int64_t), value :: break_total
            real(c_double), value :: value_scale, weight_scale
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_statistics_create
        !> Statistics with more data: the sum of given statistics and those of the data.
        function nurbs_statistics_add(statistics, data, out) bind(c) result(r)
            import
            type(c_ptr), value :: statistics
            type(nurbs_data), intent(in) :: data
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_statistics_add
        !> nurbs_statistics_add() with progress reports, cancellation and a limit of work.
        function nurbs_statistics_add_with(statistics, data, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: statistics
            type(nurbs_data), intent(in) :: data
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_statistics_add_with
        !> The sum of statistics, some of which may be subtracted.
        function nurbs_statistics_merge(count, parts, signs, out) bind(c) result(r)
            import
            integer(c_int64_t), value :: count
            type(c_ptr), intent(in) :: parts(*)
            integer(c_int32_t), intent(in), optional :: signs(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_statistics_merge
        !> Another handle on the same statistics, in constant time.
        function nurbs_statistics_clone(statistics, out) bind(c) result(r)
            import
            type(c_ptr), value :: statistics
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_statistics_clone
        !> Frees a handle on statistics.
        subroutine nurbs_statistics_destroy(statistics) bind(c)
            import
            type(c_ptr), value :: statistics
        end subroutine nurbs_statistics_destroy
        !> How much data statistics hold.
        function nurbs_statistics_size(statistics, axes, dim, count, cells, weight) bind(c) result(r)
            import
            type(c_ptr), value :: statistics
            integer(c_int32_t), intent(inout), optional :: axes, dim
            integer(c_int64_t), intent(inout), optional :: count, cells
            real(c_double), intent(inout), optional :: weight
            integer(c_int32_t) :: r
        end function nurbs_statistics_size
        !> Statistics as bytes, to be kept or sent.
        function nurbs_statistics_to_bytes(statistics, cap, bytes, length) bind(c) result(r)
            import
            type(c_ptr), value :: statistics, bytes
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: length
            integer(c_int32_t) :: r
        end function nurbs_statistics_to_bytes
        !> Statistics from the bytes of nurbs_statistics_to_bytes().
        function nurbs_statistics_from_bytes(bytes, size, out) bind(c) result(r)
            import
            type(c_ptr), value :: bytes
            integer(c_int64_t), value :: size
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_statistics_from_bytes
        !> Fills an options struct with the defaults.
        function nurbs_fit_options_init(options, struct_size) bind(c) result(r)
            import
            type(nurbs_fit_options), intent(inout) :: options
            integer(c_int64_t), value :: struct_size
            integer(c_int32_t) :: r
        end function nurbs_fit_options_init
        !> The spline over given knots that is closest to the data of statistics.
        function nurbs_fit(statistics, degrees, counts, knots, knot_count, flags, options, report, out) &
                bind(c) result(r)
            import
            type(c_ptr), value :: statistics
            integer(c_int32_t), intent(in) :: degrees(*)
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: knots(*)
            integer(c_int64_t), value :: knot_count
            integer(c_int32_t), value :: flags
            type(nurbs_fit_options), intent(in), optional :: options
            type(nurbs_fit_report), intent(inout), optional :: report
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_fit
        !> nurbs_fit() with progress reports, cancellation and a limit of work.
        function nurbs_fit_with(statistics, degrees, counts, knots, knot_count, flags, options, report, &
                call, out) bind(c) result(r)
            import
            type(c_ptr), value :: statistics
            integer(c_int32_t), intent(in) :: degrees(*)
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: knots(*)
            integer(c_int64_t), value :: knot_count
            integer(c_int32_t), value :: flags
            type(nurbs_fit_options), intent(in), optional :: options
            type(nurbs_fit_report), intent(inout), optional :: report
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_fit_with
        !> The spline over given knots that is closest to data.
        function nurbs_fit_points(data, degrees, counts, knots, knot_count, flags, options, report, out) &
                bind(c) result(r)
            import
            type(nurbs_data), intent(in) :: data
            integer(c_int32_t), intent(in) :: degrees(*)
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: knots(*)
            integer(c_int64_t), value :: knot_count
            integer(c_int32_t), value :: flags
            type(nurbs_fit_options), intent(in), optional :: options
            type(nurbs_fit_report), intent(inout), optional :: report
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_fit_points
        !> nurbs_fit_points() with progress reports, cancellation and a limit of work.
        function nurbs_fit_points_with(data, degrees, counts, knots, knot_count, flags, options, report, &
                call, out) bind(c) result(r)
            import
            type(nurbs_data), intent(in) :: data
            integer(c_int32_t), intent(in) :: degrees(*)
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: knots(*)
            integer(c_int64_t), value :: knot_count
            integer(c_int32_t), value :: flags
            type(nurbs_fit_options), intent(in), optional :: options
            type(nurbs_fit_report), intent(inout), optional :: report
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_fit_points_with
        !> Pointwise standard errors of a fit.
        function nurbs_fit_errors(statistics, g, penalty_order, lambda, sigma, n, params, param_stride, &
                param_component_stride, flags, errors) bind(c) result(r)
            import
            type(c_ptr), value :: statistics, g
            integer(c_int32_t), value :: penalty_order, flags
            real(c_double), value :: lambda, sigma
            integer(c_int64_t), value :: n, param_stride, param_component_stride
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout) :: errors(*)
            integer(c_int32_t) :: r
        end function nurbs_fit_errors
        !> nurbs_fit_errors() with progress reports, cancellation and a limit of work.
        function nurbs_fit_errors_with(statistics, g, penalty_order, lambda, sigma, n, params, param_stride, &
                param_component_stride, flags, errors, call) bind(c) result(r)
            import
            type(c_ptr), value :: statistics, g
            integer(c_int32_t), value :: penalty_order, flags
            real(c_double), value :: lambda, sigma
            integer(c_int64_t), value :: n, param_stride, param_component_stride
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout) :: errors(*)
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_fit_errors_with
        !> What NURBS_SMOOTHING_GCV and NURBS_SMOOTHING_REML compare, for each of some factors of the penalty.
        function nurbs_fit_criteria(statistics, g, penalty_order, n, lambdas, values) bind(c) result(r)
            import
            type(c_ptr), value :: statistics, g
            integer(c_int32_t), value :: penalty_order
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: lambdas(*)
            real(c_double), intent(inout) :: values(*)
            integer(c_int32_t) :: r
        end function nurbs_fit_criteria
        !> nurbs_fit_criteria() with progress reports, cancellation and a limit of work.
        function nurbs_fit_criteria_with(statistics, g, penalty_order, n, lambdas, values, call) bind(c) &
                result(r)
            import
            type(c_ptr), value :: statistics, g
            integer(c_int32_t), value :: penalty_order
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: lambdas(*)
            real(c_double), intent(inout) :: values(*)
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_fit_criteria_with
        !> A spline with few control points from which no datum is farther than a tolerance.
        function nurbs_fit_tolerance(data, degrees, domain, tolerance, max_count, flags, options, report, &
                out) bind(c) result(r)
            import
            type(nurbs_data), intent(in) :: data
            integer(c_int32_t), intent(in) :: degrees(*)
            real(c_double), intent(in), optional :: domain(*)
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: max_count
            integer(c_int32_t), value :: flags
            type(nurbs_fit_options), intent(in), optional :: options
            type(nurbs_fit_report), intent(inout), optional :: report
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_fit_tolerance
        !> nurbs_fit_tolerance() with progress reports, cancellation and a limit of work.
        function nurbs_fit_tolerance_with(data, degrees, domain, tolerance, max_count, flags, options, &
                report, call, out) bind(c) result(r)
            import
            type(nurbs_data), intent(in) :: data
            integer(c_int32_t), intent(in) :: degrees(*)
            real(c_double), intent(in), optional :: domain(*)
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: max_count
            integer(c_int32_t), value :: flags
            type(nurbs_fit_options), intent(in), optional :: options
            type(nurbs_fit_report), intent(inout), optional :: report
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_fit_tolerance_with
        !> A polynomial spline with few control points, proven to be within a tolerance of another spline.
        function nurbs_approximate(g, degrees, tolerance, max_count, bound, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), intent(in), optional :: degrees(*)
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: max_count
            real(c_double), intent(inout), optional :: bound
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_approximate
        !> nurbs_approximate() with progress reports, cancellation and a limit of work.
        function nurbs_approximate_with(g, degrees, tolerance, max_count, bound, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), intent(in), optional :: degrees(*)
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: max_count
            real(c_double), intent(inout), optional :: bound
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_approximate_with
        !> A spline from which nurbs_fit_cloud() can begin, found from points without parameters.
        function nurbs_cloud_start(axes, degrees, counts, knots, knot_count, n, dim, points, point_stride, &
                point_component_stride, flags, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: axes, dim, flags
            integer(c_int32_t), intent(in) :: degrees(*)
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: knots(*), points(*)
            integer(c_int64_t), value :: knot_count, n, point_stride, point_component_stride
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_cloud_start
        !> Fills an options struct with the defaults.
        function nurbs_cloud_options_init(options, struct_size) bind(c) result(r)
            import
            type(nurbs_cloud_options), intent(inout) :: options
            integer(c_int64_t), value :: struct_size
            integer(c_int32_t) :: r
        end function nurbs_cloud_options_init
        !> The spline, over the knots of a start, that is closest to points without parameters.
        function nurbs_fit_cloud(g, n, points, point_stride, point_component_stride, weights, weight_stride, &
                options, report, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, point_stride, point_component_stride, weight_stride
            real(c_double), intent(in) :: points(*)
            real(c_double), intent(in), optional :: weights(*)
            type(nurbs_cloud_options), intent(in), optional :: options
            type(nurbs_cloud_report), intent(inout), optional :: report
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_fit_cloud
        !> nurbs_fit_cloud() with progress reports, cancellation and a limit of work.
        function nurbs_fit_cloud_with(g, n, points, point_stride, point_component_stride, weights, &
                weight_stride, options, report, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, point_stride, point_component_stride, weight_stride
            real(c_double), intent(in) :: points(*)
            real(c_double), intent(in), optional :: weights(*)
            type(nurbs_cloud_options), intent(in), optional :: options
            type(nurbs_cloud_report), intent(inout), optional :: report
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_fit_cloud_with
        ! --- Continuity
        !> Continuity at the knots of an axis: one row for each distinct knot inside the domain, and one more,
        !> named by the upper end of the domain, for the seam of an axis that is periodic or whose ends meet
        !> within position_tolerance.
        function nurbs_continuity(g, axis, position_tolerance, derivative_tolerance, angle_tolerance, cap, &
                knots, knot_orders, orders, geometric_orders, position_gaps, angles, curvature_gaps, count) &
                bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), value :: position_tolerance, derivative_tolerance, angle_tolerance
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: knots(*), position_gaps(*), angles(*), &
                curvature_gaps(*)
            integer(c_int32_t), intent(inout), optional :: knot_orders(*), orders(*), geometric_orders(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_continuity
        !> Continuity of two curves at one end of each, on the way along a to its end and from the end of b
        !> along b: a parameter that runs the other way changes its sign.
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
        ! --- Reduction
        !> Encloses the largest distance sup |f(t) - g(t)| of two splines over their domain, both limits at
        !> jumps included.
        function nurbs_deviation(f, g, at_least, at_most) bind(c) result(r)
            import
            type(c_ptr), value :: f, g
            real(c_double), intent(inout), optional :: at_least, at_most
            integer(c_int32_t) :: r
        end function nurbs_deviation
        !> Removes copies of a knot as long as the shape moves by at most a tolerance (Tiller 1992).
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
        !> Removes as many knots inside the domain as a tolerance allows (Lyche & Morken 1988; Piegl & Tiller
        !> A9.8): always the one whose removal moves the shape least, with the moves added up span by span.
        function nurbs_reduce_knots(g, axis, tolerance, bound, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: bound
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_reduce_knots
        !> nurbs_reduce_knots() with progress reports, cancellation and a limit of work.
        function nurbs_reduce_knots_with(g, axis, tolerance, bound, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: bound
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_reduce_knots_with
        !> Lowers the degree along an axis.
        function nurbs_reduce_degree(g, axis, times, bound, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, times
            real(c_double), intent(inout), optional :: bound
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_reduce_degree
        !> nurbs_reduce_degree() with progress reports, cancellation and a limit of work.
        function nurbs_reduce_degree_with(g, axis, times, bound, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, times
            real(c_double), intent(inout), optional :: bound
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_reduce_degree_with
        !> The simplest spline within a tolerance: weights are dropped if they may be, the degree of each axis
        !> is lowered by nurbs_reduce_degree() as long as that stays within and leaves no more control points
        !> (but not below 1, where steps would begin), and knots are removed by nurbs_reduce_knots().
        function nurbs_simplify(g, tolerance, bound, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: bound
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_simplify
        !> nurbs_simplify() with progress reports, cancellation and a limit of work.
        function nurbs_simplify_with(g, tolerance, bound, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: bound
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_simplify_with
        ! --- Transformations
        !> Applies the affine map x -> A x + b to the control points, and with them to the shape.
        function nurbs_transform(g, out_dim, matrix, translation, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: out_dim
            real(c_double), intent(in) :: matrix(*)
            real(c_double), intent(in), optional :: translation(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_transform
        !> Applies a projective map to the homogeneous control points h = (w x, w y, ..., w).
        function nurbs_transform_projective(g, out_dim, matrix, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: out_dim
            real(c_double), intent(in) :: matrix(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_transform_projective
        !> The mirror image in the plane (in 2D the line, in general the hyperplane) through a point: x -> x -
        !> 2 n (n . (x - point)) / (n . n).
        function nurbs_mirror(g, point, normal, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: point(*), normal(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_mirror
        !> Projects a spline to the plane (line, hyperplane) through a point, along a direction: x -> x - d (n
        !> . (x - point)) / (n . d).
        function nurbs_project_to_plane(g, point, normal, direction, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: point(*), normal(*)
            real(c_double), intent(in), optional :: direction(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_project_to_plane
        !> Projects a spline from an eye to the plane (line, hyperplane) through a point, in perspective: x ->
        !> eye + (x - eye) (n . (point - eye)) / (n . (x - eye)).
        function nurbs_project_from(g, eye, point, normal, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: eye(*), point(*), normal(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_project_from
        ! --- Lines, conics and helices
        !> The segment (1 - t) a + t b, of degree 1.
        function nurbs_curve_line(dim, a, b, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in) :: a(*), b(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_line
        !> The polyline through n points, of degree 1, with one knot for each point.
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
        !> A closed regular polygon, of degree 1, counterclockwise about the axis.
        function nurbs_curve_polygon(dim, center, axis, x, radius, sides, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius
            integer(c_int64_t), value :: sides
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_polygon
        !> A closed rectangle with sides along X and Y whose corners are rounded by quarter circles, of degree
        !> 2, counterclockwise about the axis, beginning at the start of its lower side.
        function nurbs_curve_rounded_rectangle(dim, center, axis, x, width, height, corner_radius, out) &
                bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: width, height, corner_radius
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_rounded_rectangle
        !> The full circle, from the direction X counterclockwise about the axis: nurbs_curve_arc() over a
        !> full turn.
        function nurbs_curve_circle(dim, center, axis, x, radius, form, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim, form
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_circle
        !> A circular arc: center + radius (X cos a + Y sin a), a from start to start + sweep.
        function nurbs_curve_arc(dim, center, axis, x, radius, start, sweep, form, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim, form
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius, start, sweep
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_arc
        !> The circular arc from a through b to c.
        function nurbs_curve_arc_through(dim, a, b, c, form, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim, form
            real(c_double), intent(in) :: a(*), b(*), c(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_arc_through
        !> The circular arc that leaves a in the direction of a tangent and ends at b.
        function nurbs_curve_arc_tangent(dim, a, tangent, b, form, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim, form
            real(c_double), intent(in) :: a(*), tangent(*), b(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_arc_tangent
        !> An elliptic arc: center + radius_x X cos a + radius_y Y sin a, a from start to start + sweep; a is
        !> the eccentric angle, not that of the point seen from the centre.
        function nurbs_curve_ellipse(dim, center, axis, x, radius_x, radius_y, start, sweep, form, out) &
                bind(c) result(r)
            import
            integer(c_int32_t), value :: dim, form
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius_x, radius_y, start, sweep
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_ellipse
        !> A parabolic arc, polynomial of degree 2 over [start, end]: vertex + t^2 / (4 focal_length) X + t Y,
        !> so that the parameter is the coordinate along Y.
        function nurbs_curve_parabola(dim, vertex, axis, x, focal_length, start, end, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in), optional :: vertex(*), axis(*), x(*)
            real(c_double), value :: focal_length, start, end
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_parabola
        !> An arc of the branch of a hyperbola that opens to X: center + radius_x X cosh u + radius_y Y sinh
        !> u, u from start to end.
        function nurbs_curve_hyperbola(dim, center, axis, x, radius_x, radius_y, start, end, out) bind(c) &
                result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius_x, radius_y, start, end
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_hyperbola
        !> The conic with a control triangle and a shape factor C_sf = w1^2 / (w0 w2): degree 2, the weights
        !> 1, sqrt(C_sf), 1.
        function nurbs_curve_conic_triangle(dim, p0, p1, p2, shape_factor, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in) :: p0(*), p1(*), p2(*)
            real(c_double), value :: shape_factor
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_conic_triangle
        !> The conic arc that leaves a in one direction and arrives at b in another one, and whose shoulder
        !> point is at the part rho of the way from the middle of the chord to the point where the tangents
        !> meet: an ellipse where rho < 1/2, a parabola where rho = 1/2, a hyperbola where rho > 1/2.
        function nurbs_curve_conic_shoulder(dim, a, tangent_a, b, tangent_b, rho, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in) :: a(*), tangent_a(*), b(*), tangent_b(*)
            real(c_double), value :: rho
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_conic_shoulder
        !> The conic arc from a to b with given tangent lines at both ends that passes through a third point;
        !> degree 2, in pieces of which none turns by more than the form allows in the affine picture in which
        !> it is a circle.
        function nurbs_curve_conic_point(dim, a, tangent_a, b, tangent_b, point, form, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim, form
            real(c_double), intent(in) :: a(*), tangent_a(*), b(*), tangent_b(*), point(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_conic_point
        !> The conic arc through five points, from the first to the last in this order; tangents at its ends
        !> by Pascal's theorem, pieces as for nurbs_curve_conic_point().
        function nurbs_curve_conic_through(dim, points, point_stride, point_component_stride, form, out) &
                bind(c) result(r)
            import
            integer(c_int32_t), value :: dim, form
            real(c_double), intent(in) :: points(*)
            integer(c_int64_t), value :: point_stride, point_component_stride
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_conic_through
        !> Kind and axes of the conic A x^2 + B x y + C y^2 + D x + E y + F = 0, from its principal axes.
        function nurbs_conic_axes(coefficients, type, origin, x, sizes) bind(c) result(r)
            import
            real(c_double), intent(in) :: coefficients(*)
            integer(c_int32_t), intent(inout) :: type
            real(c_double), intent(inout) :: origin(*), x(*), sizes(*)
            integer(c_int32_t) :: r
        end function nurbs_conic_axes
        !> An arc of the conic with an implicit equation, as described by nurbs_conic_axes(): of an ellipse as
        !> nurbs_curve_ellipse() with start and sweep = end - start, of a parabola and a hyperbola (the branch
        !> towards x) as nurbs_curve_parabola() and nurbs_curve_hyperbola() from start to end.
        function nurbs_curve_conic_implicit(coefficients, start, end, form, out) bind(c) result(r)
            import
            real(c_double), intent(in) :: coefficients(*)
            real(c_double), value :: start, end
            integer(c_int32_t), value :: form
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_conic_implicit
        !> An arc of the conic with a focus, a directrix and an eccentricity e: the points whose distance from
        !> the focus is e times that from the directrix, at angles about the focus from start to start +
        !> sweep, counted from the foot of the perpendicular to the directrix; r(a) = e d / (1 + e cos a)
        !> where d = |foot - focus|.
        function nurbs_curve_conic_focus(dim, focus, axis, foot, eccentricity, start, sweep, form, out) &
                bind(c) result(r)
            import
            integer(c_int32_t), value :: dim, form
            real(c_double), intent(in) :: focus(*), foot(*)
            real(c_double), intent(in), optional :: axis(*)
            real(c_double), value :: eccentricity, start, sweep
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_curve_conic_focus
        !> Shape factor C_sf = w1^2 / (w0 w2) and kind of a conic segment: a curve of degree 2 with one
        !> polynomial piece.
        function nurbs_curve_shape_factor(g, factor, type) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(inout) :: factor
            integer(c_int32_t), intent(inout) :: type
            integer(c_int32_t) :: r
        end function nurbs_curve_shape_factor
        !> A circular helix or Archimedean spiral to a tolerance.
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
        ! --- Surfaces and volumes from curves
        !> Moves a curve or surface along a vector: (u, v) -> g(u) + v vector, the new axis last, of degree 1
        !> over [0, 1].
        function nurbs_extrude(g, vector, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: vector(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_extrude
        !> Turns a curve or surface in space about an axis, the angle as a new axis 0 over [0, 1].
        function nurbs_revolve(g, point, axis, sweep, form, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: point(*), axis(*)
            real(c_double), value :: sweep
            integer(c_int32_t), value :: form
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_revolve
        !> The surface of straight lines between curves, or the volume between surfaces, with a new last axis
        !> v over [0, 1].
        function nurbs_ruled(a, b, flags, out) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            integer(c_int32_t), value :: flags
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_ruled
        !> The translational sweep alpha a(u) + beta b(v), the axes of b after those of a.
        function nurbs_tensor_sum(a, alpha, b, beta, out) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: alpha, beta
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_tensor_sum
        !> The product a(u) b(v), component by component, the axes of b after those of a; one of them may have
        !> dimension 1 and multiplies all components of the other.
        function nurbs_tensor_product(a, b, out) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_tensor_product
        !> A swung surface: (u, v) -> (scale r(v) x(u), scale r(v) y(u), z(v)) for the trajectory (x, y) and
        !> the profile (r, z).
        function nurbs_surface_swung(trajectory, profile, scale, out) bind(c) result(r)
            import
            type(c_ptr), value :: trajectory, profile
            real(c_double), value :: scale
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_swung
        !> The parallelogram origin + s u + t v, of degree 1 on both axes.
        function nurbs_surface_plane(dim, origin, u, v, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in), optional :: origin(*)
            real(c_double), intent(in) :: u(*), v(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_plane
        !> The bilinear patch over four corners, of degree 1 on both axes.
        function nurbs_surface_bilinear(dim, corners, corner_stride, corner_component_stride, out) bind(c) &
                result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in) :: corners(*)
            integer(c_int64_t), value :: corner_stride, corner_component_stride
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_bilinear
        !> The trilinear volume over eight corners, of degree 1 on all axes.
        function nurbs_volume_trilinear(dim, corners, corner_stride, corner_component_stride, out) bind(c) &
                result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in) :: corners(*)
            integer(c_int64_t), value :: corner_stride, corner_component_stride
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_volume_trilinear
        !> The whole sphere by longitude (axis 0) and latitude (axis 1, from the pole -Z to the pole Z); its
        !> poles are collapsed edges, its seam closes bit for bit.
        function nurbs_surface_sphere(center, axis, x, radius, form, out) bind(c) result(r)
            import
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius
            integer(c_int32_t), value :: form
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_sphere
        !> A patch of a sphere between two meridians and two circles of latitude.
        function nurbs_surface_spherical_patch(center, axis, x, radius, start, sweep, south, north, form, &
                out) bind(c) result(r)
            import
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius, start, sweep, south, north
            integer(c_int32_t), value :: form
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_spherical_patch
        !> The sphere without poles: six patches of degree 4 x 4 over the faces of a cube, each bounded by
        !> arcs of great circles, without a singular point (after Cobb 1988).
        function nurbs_surface_sphere_patches(center, axis, x, radius, flags, out) bind(c) result(r)
            import
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius
            integer(c_int32_t), value :: flags
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_sphere_patches
        !> The whole ellipsoid with semi-axes along X, Y and Z, parametrized as nurbs_surface_sphere().
        function nurbs_surface_ellipsoid(center, axis, x, radius_x, radius_y, radius_z, form, out) bind(c) &
                result(r)
            import
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius_x, radius_y, radius_z
            integer(c_int32_t), value :: form
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_ellipsoid
        !> A circular cylinder: origin + radius (X cos a + Y sin a) + v height Z.
        function nurbs_surface_cylinder(origin, axis, x, radius, height, start, sweep, form, out) bind(c) &
                result(r)
            import
            real(c_double), intent(in), optional :: origin(*), axis(*), x(*)
            real(c_double), value :: radius, height, start, sweep
            integer(c_int32_t), value :: form
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_cylinder
        !> A circular cone or its frustum, parametrized as nurbs_surface_cylinder(), with a radius that
        !> changes from base_radius at the origin to top_radius at origin + height Z.
        function nurbs_surface_cone(origin, axis, x, base_radius, top_radius, height, start, sweep, form, &
                out) bind(c) result(r)
            import
            real(c_double), intent(in), optional :: origin(*), axis(*), x(*)
            real(c_double), value :: base_radius, top_radius, height, start, sweep
            integer(c_int32_t), value :: form
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_cone
        !> A torus: (R + r cos b) (X cos a + Y sin a) + r sin b Z about the centre.
        function nurbs_surface_torus(center, axis, x, major_radius, minor_radius, start, sweep, tube_start, &
                tube_sweep, form, out) bind(c) result(r)
            import
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: major_radius, minor_radius, start, sweep, tube_start, tube_sweep
            integer(c_int32_t), value :: form
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_torus
        !> A bowl of the elliptic paraboloid Z = height ((X / radius_x)^2 + (Y / radius_y)^2), from the
        !> vertex, a collapsed edge, at v = 0 to the rim at v = 1, Z = height v^2.
        function nurbs_surface_paraboloid(vertex, axis, x, radius_x, radius_y, height, start, sweep, form, &
                out) bind(c) result(r)
            import
            real(c_double), intent(in), optional :: vertex(*), axis(*), x(*)
            real(c_double), value :: radius_x, radius_y, height, start, sweep
            integer(c_int32_t), value :: form
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_paraboloid
        !> A saddle of the hyperbolic paraboloid Z = height ((X / radius_x)^2 - (Y / radius_y)^2) over the
        !> rectangle |X| <= radius_x, |Y| <= radius_y: polynomial, of degree 2 on both axes, X along axis 0
        !> and Y along axis 1.
        function nurbs_surface_saddle(center, axis, x, radius_x, radius_y, height, out) bind(c) result(r)
            import
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius_x, radius_y, height
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_saddle
        !> A band of the hyperboloid (X / radius_x)^2 + (Y / radius_y)^2 - (Z / radius_z)^2 = 1 between two
        !> planes Z = bottom and Z = top; or with NURBS_TWO_SHEETS of the sheets (Z / radius_z)^2 - (X /
        !> radius_x)^2 - (Y / radius_y)^2 = 1, both planes being on one sheet: radius_z <= bottom or top <=
        !> -radius_z.
        function nurbs_surface_hyperboloid(center, axis, x, radius_x, radius_y, radius_z, bottom, top, &
                start, sweep, form, flags, out) bind(c) result(r)
            import
            real(c_double), intent(in), optional :: center(*), axis(*), x(*)
            real(c_double), value :: radius_x, radius_y, radius_z, bottom, top, start, sweep
            integer(c_int32_t), value :: form, flags
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_hyperboloid
        ! --- Surfaces and volumes from their boundaries
        !> The boundaries of a surface or volume, in the order above, each bit for bit what nurbs_iso() gives;
        !> named "0-", "0+", "1-", "1+", and so on.
        function nurbs_boundaries(g, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_boundaries
        !> The bilinearly blended Coons surface of four curves (Coons 1967): with u and v mapped to [0, 1].
        function nurbs_surface_coons(boundaries, tolerance, out) bind(c) result(r)
            import
            type(c_ptr), intent(in) :: boundaries(*)
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_coons
        !> The bicubically blended Coons surface of four curves and the derivatives across them.
        function nurbs_surface_coons_hermite(boundaries, cross, twist, twists, tolerance, bound, out) &
                bind(c) result(r)
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
        !> What does not meet at the corners of a surface to be: corners in the order (u0, v0), (u0, v1), (u1,
        !> v0), (u1, v1).
        function nurbs_coons_gaps(boundaries, cross, positions, tangents, twists) bind(c) result(r)
            import
            type(c_ptr), intent(in) :: boundaries(*)
            type(c_ptr), intent(in), optional :: cross(*)
            real(c_double), intent(inout) :: positions(*)
            real(c_double), intent(inout), optional :: tangents(*), twists(*)
            integer(c_int32_t) :: r
        end function nurbs_coons_gaps
        !> The volume that blends six faces linearly (Gordon & Hall 1973): the sum of the blends of opposite
        !> faces, less those of the twelve edges, plus that of the eight corners.
        function nurbs_volume_coons(faces, tolerance, out) bind(c) result(r)
            import
            type(c_ptr), intent(in) :: faces(*)
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_volume_coons
        ! --- Recognition
        !> Whether a curve is a line or a conic, or a surface a plane, sphere, cylinder, cone or torus.
        function nurbs_recognize(g, tolerance, shape, placement, sizes, deviation) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: tolerance
            integer(c_int32_t), intent(inout) :: shape
            real(c_double), intent(inout), optional :: placement(*), sizes(*), deviation
            integer(c_int32_t) :: r
        end function nurbs_recognize
        !> nurbs_recognize() with progress reports, cancellation and a limit of work.
        function nurbs_recognize_with(g, tolerance, shape, placement, sizes, deviation, call) bind(c) &
                result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: tolerance
            integer(c_int32_t), intent(inout) :: shape
            real(c_double), intent(inout), optional :: placement(*), sizes(*), deviation
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_recognize_with
        ! --- Distances and closest points
        !> The points of a spline that are nearest to given points.
        function nurbs_closest_points(g, n, points, point_stride, point_component_stride, range, tolerance, &
                budget, params, param_stride, param_component_stride, feet, foot_stride, &
                foot_component_stride, distances, distance_stride, status, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, point_stride, point_component_stride, budget, param_stride, &
                param_component_stride, foot_stride, foot_component_stride, distance_stride
            real(c_double), intent(in) :: points(*)
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: params(*), feet(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_closest_points
        !> nurbs_closest_points() with progress reports, cancellation and a limit of work.
        function nurbs_closest_points_with(g, query, answer, call) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(nurbs_closest_query), intent(in) :: query
            type(nurbs_closest_answer), intent(in) :: answer
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_closest_points_with
        !> The points of a spline that are farthest from given points.
        function nurbs_farthest_points(g, n, points, point_stride, point_component_stride, range, tolerance, &
                budget, params, param_stride, param_component_stride, feet, foot_stride, &
                foot_component_stride, distances, distance_stride, status, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, point_stride, point_component_stride, budget, param_stride, &
                param_component_stride, foot_stride, foot_component_stride, distance_stride
            real(c_double), intent(in) :: points(*)
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: params(*), feet(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_farthest_points
        !> nurbs_farthest_points() with progress reports, cancellation and a limit of work.
        function nurbs_farthest_points_with(g, query, answer, call) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(nurbs_closest_query), intent(in) :: query
            type(nurbs_closest_answer), intent(in) :: answer
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_farthest_points_with
        !> Local minima of the distance from given points, each reached by a descent from a guess.
        function nurbs_closest_local(g, n, points, point_stride, point_component_stride, guesses, &
                guess_stride, guess_component_stride, params, param_stride, param_component_stride, feet, &
                foot_stride, foot_component_stride, distances, distance_stride, status, flags) bind(c) &
                result(r)
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
        !> nurbs_closest_local() with progress reports, cancellation and a limit of work.
        function nurbs_closest_local_with(g, query, answer, call) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(nurbs_closest_query), intent(in) :: query
            type(nurbs_closest_answer), intent(in) :: answer
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_closest_local_with
        !> All local minima of the distance from a point that are within a tolerance of the smallest.
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
        !> nurbs_closest_all() with progress reports, cancellation and a limit of work.
        function nurbs_closest_all_with(g, point, range, tolerance, budget, cap, params, distances, count, &
                status, call) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: point(*)
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: budget, cap
            real(c_double), intent(inout), optional :: params(*), distances(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t), intent(inout), optional :: status
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_closest_all_with
        !> All critical points of the distance from a point.
        function nurbs_critical_points(g, point, range, tolerance, budget, cap, params, distances, kinds, &
                count, status) bind(c) result(r)
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
        !> nurbs_critical_points() with progress reports, cancellation and a limit of work.
        function nurbs_critical_points_with(g, point, range, tolerance, budget, cap, params, distances, &
                kinds, count, status, call) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: point(*)
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: budget, cap
            real(c_double), intent(inout), optional :: params(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: kinds(*), status
            integer(c_int64_t), intent(inout), optional :: count
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_critical_points_with
        !> Signed distances of points in the plane from a curve: positive to the left of its direction.
        function nurbs_curve_signed_distances(g, n, points, point_stride, point_component_stride, tolerance, &
                budget, distances, distance_stride, params, param_stride, status, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, point_stride, point_component_stride, budget, distance_stride, &
                param_stride
            real(c_double), intent(in) :: points(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout) :: distances(*)
            real(c_double), intent(inout), optional :: params(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_curve_signed_distances
        !> nurbs_curve_signed_distances() with progress reports, cancellation and a limit of work.
        function nurbs_curve_signed_distances_with(g, query, answer, call) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(nurbs_closest_query), intent(in) :: query
            type(nurbs_closest_answer), intent(in) :: answer
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_curve_signed_distances_with
        !> Proven bounds of the smallest distance between two splines, of any number of axes each.
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
        !> nurbs_distance() with progress reports, cancellation and a limit of work.
        function nurbs_distance_with(a, b, tolerance, budget, at_least, at_most, params_a, params_b, status, &
                call) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: budget
            real(c_double), intent(inout), optional :: at_least, at_most, params_a(*), params_b(*)
            integer(c_int32_t), intent(inout), optional :: status
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_distance_with
        !> Proven bounds of the Hausdorff distances of two splines as sets of points.
        function nurbs_hausdorff_distance(a, b, tolerance, budget, at_least, at_most, params_a, params_b, &
                status) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: budget
            real(c_double), intent(inout), optional :: at_least(*), at_most(*), params_a(*), params_b(*)
            integer(c_int32_t), intent(inout), optional :: status
            integer(c_int32_t) :: r
        end function nurbs_hausdorff_distance
        !> nurbs_hausdorff_distance() with progress reports, cancellation and a limit of work.
        function nurbs_hausdorff_distance_with(a, b, tolerance, budget, at_least, at_most, params_a, &
                params_b, status, call) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: budget
            real(c_double), intent(inout), optional :: at_least(*), at_most(*), params_a(*), params_b(*)
            integer(c_int32_t), intent(inout), optional :: status
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_hausdorff_distance_with
        ! --- Lengths, areas and moments
        !> The length of a curve or of a part of it.
        function nurbs_curve_length(g, range, relative_tolerance, length, error) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: length
            real(c_double), intent(inout), optional :: error
            integer(c_int32_t) :: r
        end function nurbs_curve_length
        !> nurbs_curve_length() with progress reports, cancellation and a limit of work.
        function nurbs_curve_length_with(g, range, relative_tolerance, length, error, call) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: length
            real(c_double), intent(inout), optional :: error
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_curve_length_with
        !> Lengths from the start of the domain to given parameters.
        function nurbs_curve_lengths(g, n, params, param_stride, relative_tolerance, lengths, length_stride) &
                bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, param_stride, length_stride
            real(c_double), intent(in) :: params(*)
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: lengths(*)
            integer(c_int32_t) :: r
        end function nurbs_curve_lengths
        !> nurbs_curve_lengths() with progress reports, cancellation and a limit of work.
        function nurbs_curve_lengths_with(g, n, params, param_stride, relative_tolerance, lengths, &
                length_stride, call) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, param_stride, length_stride
            real(c_double), intent(in) :: params(*)
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: lengths(*)
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_curve_lengths_with
        !> Parameters at given lengths from the start of the domain.
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
        !> nurbs_curve_params_at_lengths() with progress reports, cancellation and a limit of work.
        function nurbs_curve_params_at_lengths_with(g, n, lengths, length_stride, relative_tolerance, &
                params, param_stride, flags, call) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, length_stride, param_stride
            real(c_double), intent(in) :: lengths(*)
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: params(*)
            integer(c_int32_t), value :: flags
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_curve_params_at_lengths_with
        !> Divides a curve into parts of equal length, or so that consecutive points have equal distances.
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
        !> nurbs_curve_divide() with progress reports, cancellation and a limit of work.
        function nurbs_curve_divide_with(g, range, parts, relative_tolerance, flags, params, size, call) &
                bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: range(*)
            integer(c_int64_t), value :: parts
            real(c_double), value :: relative_tolerance
            integer(c_int32_t), value :: flags
            real(c_double), intent(inout) :: params(*)
            real(c_double), intent(inout), optional :: size
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_curve_divide_with
        !> The area of a surface or of a part of it, in any dimension.
        function nurbs_surface_area(g, range, relative_tolerance, area, error) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: area
            real(c_double), intent(inout), optional :: error
            integer(c_int32_t) :: r
        end function nurbs_surface_area
        !> nurbs_surface_area() with progress reports, cancellation and a limit of work.
        function nurbs_surface_area_with(g, range, relative_tolerance, area, error, call) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: area
            real(c_double), intent(inout), optional :: error
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_surface_area_with
        !> Content, centroid and inertia of a curve as a wire, a surface as a sheet, or a volume as a body.
        function nurbs_moments(g, relative_tolerance, content, centroid, inertia, error) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: content
            real(c_double), intent(inout), optional :: centroid(*), inertia(*), error
            integer(c_int32_t) :: r
        end function nurbs_moments
        !> nurbs_moments() with progress reports, cancellation and a limit of work.
        function nurbs_moments_with(g, relative_tolerance, content, centroid, inertia, error, call) bind(c) &
                result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: content
            real(c_double), intent(inout), optional :: centroid(*), inertia(*), error
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_moments_with
        !> Area, centroid and inertia of the region of the plane that closed chains of curves enclose.
        function nurbs_enclosed_area(count, curves, tolerance, relative_tolerance, area, centroid, inertia, &
                error) bind(c) result(r)
            import
            integer(c_int64_t), value :: count
            type(c_ptr), intent(in) :: curves(*)
            real(c_double), value :: tolerance, relative_tolerance
            real(c_double), intent(inout) :: area
            real(c_double), intent(inout), optional :: centroid(*), inertia(*), error
            integer(c_int32_t) :: r
        end function nurbs_enclosed_area
        !> nurbs_enclosed_area() with progress reports, cancellation and a limit of work.
        function nurbs_enclosed_area_with(count, curves, tolerance, relative_tolerance, area, centroid, &
                inertia, error, call) bind(c) result(r)
            import
            integer(c_int64_t), value :: count
            type(c_ptr), intent(in) :: curves(*)
            real(c_double), value :: tolerance, relative_tolerance
            real(c_double), intent(inout) :: area
            real(c_double), intent(inout), optional :: centroid(*), inertia(*), error
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_enclosed_area_with
        !> Volume, centroid and inertia of the body that surfaces enclose.
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
        !> nurbs_enclosed_volume() with progress reports, cancellation and a limit of work.
        function nurbs_enclosed_volume_with(count, surfaces, relative_tolerance, volume, centroid, inertia, &
                openness, error, call) bind(c) result(r)
            import
            integer(c_int64_t), value :: count
            type(c_ptr), intent(in) :: surfaces(*)
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: volume
            real(c_double), intent(inout), optional :: centroid(*), inertia(*), openness, error
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_enclosed_volume_with
        !> Points and weights for integrals of any function over a spline.
        function nurbs_quadrature(g, nodes, cap, params, weights, measures, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: nodes
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), weights(*), measures(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_quadrature
        ! --- Boxes and cones
        !> An axis-aligned box that contains a spline, and all points that evaluation gives of it.
        function nurbs_box(g, range, tolerance, lower, upper, gap) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout) :: lower(*), upper(*)
            real(c_double), intent(inout), optional :: gap
            integer(c_int32_t) :: r
        end function nurbs_box
        !> A box with axes of its own that contains a spline.
        function nurbs_oriented_box(g, tolerance, center, axes, half) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: tolerance
            real(c_double), intent(inout) :: center(*), axes(*), half(*)
            integer(c_int32_t) :: r
        end function nurbs_oriented_box
        !> A cone that contains the directions of all derivatives along an axis.
        function nurbs_tangent_cone(g, axis, range, tolerance, direction, angle) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout) :: direction(*), angle
            integer(c_int32_t) :: r
        end function nurbs_tangent_cone
        !> A cone that contains the directions of all normals S_u x S_v of a surface in space.
        function nurbs_normal_cone(g, range, tolerance, direction, angle) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout) :: direction(*), angle
            integer(c_int32_t) :: r
        end function nurbs_normal_cone
        !> The point of a spline that is farthest in a direction: the largest value of direction . C(t).
        function nurbs_extreme_point(g, direction, range, tolerance, params, value, bound) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: direction(*)
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: params(*), value, bound
            integer(c_int32_t) :: r
        end function nurbs_extreme_point
        ! --- Features of a shape
        !> Inflections, extrema of curvature, cusps, kinks, jumps and changes of torsion along a curve.
        function nurbs_curve_features(g, kinds, cap, params, found, values, count, complete) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: kinds
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), values(*)
            integer(c_int32_t), intent(inout), optional :: found(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_curve_features
        !> nurbs_curve_features() with progress reports, cancellation and a limit of work.
        function nurbs_curve_features_with(g, kinds, cap, params, found, values, count, complete, call) &
                bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: kinds
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), values(*)
            integer(c_int32_t), intent(inout), optional :: found(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_curve_features_with
        !> Local extrema and saddles of a scalar spline f of 1 to 3 axes.
        function nurbs_extrema(g, kinds, cap, params, values, found, boxes, count, complete) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: kinds
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), values(*), boxes(*)
            integer(c_int32_t), intent(inout), optional :: found(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_extrema
        !> nurbs_extrema() with progress reports, cancellation and a limit of work.
        function nurbs_extrema_with(g, kinds, cap, params, values, found, boxes, count, complete, call) &
                bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: kinds
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), values(*), boxes(*)
            integer(c_int32_t), intent(inout), optional :: found(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_extrema_with
        !> The pieces of a curve on which it runs one way along a direction.
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
        !> Whether a curve in the plane is convex: whether it turns one way only, and by at most a full turn.
        function nurbs_curve_convexity(g, convexity) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), intent(inout) :: convexity
            integer(c_int32_t) :: r
        end function nurbs_curve_convexity
        !> How far a spline is from a straight line: a line near the best one, and a proven bound.
        function nurbs_straightness(g, origin, direction, bound) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(inout), optional :: origin(*), direction(*)
            real(c_double), intent(inout) :: bound
            integer(c_int32_t) :: r
        end function nurbs_straightness
        !> How far a spline in space is from a plane: a plane near the best one, and a proven bound.
        function nurbs_planarity(g, origin, normal, bound) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(inout), optional :: origin(*), normal(*)
            real(c_double), intent(inout) :: bound
            integer(c_int32_t) :: r
        end function nurbs_planarity
        !> Which axes of a spline close and which of its boundaries collapse, with proven bounds.
        function nurbs_boundary_contacts(g, tolerance, closed, gaps, collapsed, sizes) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: tolerance
            integer(c_int32_t), intent(inout), optional :: closed(*), collapsed(*)
            real(c_double), intent(inout), optional :: gaps(*), sizes(*)
            integer(c_int32_t) :: r
        end function nurbs_boundary_contacts
        !> Places where a curve or surface is singular: C' = 0, or S_u x S_v = 0.
        function nurbs_singular_points(g, tolerance, cap, params, boxes, count, complete) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), boxes(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t), intent(inout), optional :: complete
            integer(c_int32_t) :: r
        end function nurbs_singular_points
        !> Whether a surface or volume folds over: whether the sign of J changes.
        function nurbs_fold_test(g, reference, result, positive, negative) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: reference(*)
            integer(c_int32_t), intent(inout) :: result
            real(c_double), intent(inout), optional :: positive(*), negative(*)
            integer(c_int32_t) :: r
        end function nurbs_fold_test
        !> nurbs_fold_test() with progress reports, cancellation and a limit of work.
        function nurbs_fold_test_with(g, reference, result, positive, negative, call) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: reference(*)
            integer(c_int32_t), intent(inout) :: result
            real(c_double), intent(inout), optional :: positive(*), negative(*)
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_fold_test_with
        !> nurbs_fold_test() of each polynomial piece by itself.
        function nurbs_fold_pieces(g, reference, cap, folds, signs, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: reference(*)
            integer(c_int64_t), value :: cap
            integer(c_int32_t), intent(inout), optional :: folds(*), signs(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_fold_pieces
        !> nurbs_fold_pieces() with progress reports, cancellation and a limit of work.
        function nurbs_fold_pieces_with(g, reference, cap, folds, signs, count, call) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: reference(*)
            integer(c_int64_t), value :: cap
            integer(c_int32_t), intent(inout), optional :: folds(*), signs(*)
            integer(c_int64_t), intent(inout), optional :: count
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_fold_pieces_with
        ! --- Where shapes meet
        !> Roots of a scalar curve: where f(t) = value.
        function nurbs_roots(g, value, tolerance, cap, params, kinds, ranges, count, complete) bind(c) &
                result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: value, tolerance
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), ranges(*)
            integer(c_int32_t), intent(inout), optional :: kinds(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_roots
        !> nurbs_roots() with progress reports, cancellation and a limit of work.
        function nurbs_roots_with(g, value, tolerance, cap, params, kinds, ranges, count, complete, call) &
                bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: value, tolerance
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), ranges(*)
            integer(c_int32_t), intent(inout), optional :: kinds(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_roots_with
        !> Where a curve meets a line, plane, conic, sphere, quadric or other set f(x) = 0 of a polynomial f.
        function nurbs_curve_level(g, degree, coefficients, tolerance, cap, params, kinds, ranges, count, &
                complete) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: degree
            real(c_double), intent(in) :: coefficients(*)
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), ranges(*)
            integer(c_int32_t), intent(inout), optional :: kinds(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_curve_level
        !> nurbs_curve_level() with progress reports, cancellation and a limit of work.
        function nurbs_curve_level_with(g, degree, coefficients, tolerance, cap, params, kinds, ranges, &
                count, complete, call) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: degree
            real(c_double), intent(in) :: coefficients(*)
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), ranges(*)
            integer(c_int32_t), intent(inout), optional :: kinds(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_curve_level_with
        !> Where two curves meet: all places at which they come as near as the tolerance.
        function nurbs_curve_intersections(a, b, tolerance, cap, params_a, params_b, kinds, ranges_a, &
                ranges_b, count, complete) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params_a(*), params_b(*), ranges_a(*), ranges_b(*)
            integer(c_int32_t), intent(inout), optional :: kinds(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_curve_intersections
        !> nurbs_curve_intersections() with progress reports, cancellation and a limit of work.
        function nurbs_curve_intersections_with(a, b, tolerance, cap, params_a, params_b, kinds, ranges_a, &
                ranges_b, count, complete, call) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params_a(*), params_b(*), ranges_a(*), ranges_b(*)
            integer(c_int32_t), intent(inout), optional :: kinds(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_curve_intersections_with
        !> Where a curve meets itself, at pairs of parameters a < b.
        function nurbs_curve_self_intersections(g, tolerance, cap, params_a, params_b, kinds, ranges_a, &
                ranges_b, count, complete) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params_a(*), params_b(*), ranges_a(*), ranges_b(*)
            integer(c_int32_t), intent(inout), optional :: kinds(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_curve_self_intersections
        !> nurbs_curve_self_intersections() with progress reports, cancellation and a limit of work.
        function nurbs_curve_self_intersections_with(g, tolerance, cap, params_a, params_b, kinds, ranges_a, &
                ranges_b, count, complete, call) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params_a(*), params_b(*), ranges_a(*), ranges_b(*)
            integer(c_int32_t), intent(inout), optional :: kinds(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_curve_self_intersections_with
        !> Where a curve meets a surface: all places at which they come as near as the tolerance.
        function nurbs_curve_surface_intersections(curve, surface, tolerance, cap, params_curve, &
                params_surface, kinds, ranges_curve, ranges_surface, count, complete) bind(c) result(r)
            import
            type(c_ptr), value :: curve, surface
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params_curve(*), params_surface(*), ranges_curve(*), &
                ranges_surface(*)
            integer(c_int32_t), intent(inout), optional :: kinds(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_curve_surface_intersections
        !> nurbs_curve_surface_intersections() with progress reports, cancellation and a limit of work.
        function nurbs_curve_surface_intersections_with(curve, surface, tolerance, cap, params_curve, &
                params_surface, kinds, ranges_curve, ranges_surface, count, complete, call) bind(c) result(r)
            import
            type(c_ptr), value :: curve, surface
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params_curve(*), params_surface(*), ranges_curve(*), &
                ranges_surface(*)
            integer(c_int32_t), intent(inout), optional :: kinds(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_curve_surface_intersections_with
        !> The points that three surfaces have in common: all of them, proven to be all.
        function nurbs_surfaces_common_points(a, b, c, tolerance, cap, params, points, kinds, ranges, count, &
                complete) bind(c) result(r)
            import
            type(c_ptr), value :: a, b, c
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), points(*), ranges(*)
            integer(c_int32_t), intent(inout), optional :: kinds(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_surfaces_common_points
        !> nurbs_surfaces_common_points() with progress reports, cancellation and a limit of work.
        function nurbs_surfaces_common_points_with(a, b, c, tolerance, cap, params, points, kinds, ranges, &
                count, complete, call) bind(c) result(r)
            import
            type(c_ptr), value :: a, b, c
            real(c_double), value :: tolerance
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), points(*), ranges(*)
            integer(c_int32_t), intent(inout), optional :: kinds(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_surfaces_common_points_with
        !> The first hits of rays x = origin + t direction, t >= 0, with a surface.
        function nurbs_surface_rays(g, n, origins, origin_stride, origin_component_stride, directions, &
                direction_stride, direction_component_stride, params, distances, status) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, origin_stride, origin_component_stride, direction_stride, &
                direction_component_stride
            real(c_double), intent(in) :: origins(*), directions(*)
            real(c_double), intent(inout), optional :: params(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t) :: r
        end function nurbs_surface_rays
        !> nurbs_surface_rays() with progress reports, cancellation and a limit of work.
        function nurbs_surface_rays_with(g, n, origins, origin_stride, origin_component_stride, directions, &
                direction_stride, direction_component_stride, params, distances, status, call) bind(c) &
                result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n, origin_stride, origin_component_stride, direction_stride, &
                direction_component_stride
            real(c_double), intent(in) :: origins(*), directions(*)
            real(c_double), intent(inout), optional :: params(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_surface_rays_with
        !> All places where a ray meets a surface, in the order of rising t.
        function nurbs_surface_ray_hits(g, origin, direction, range, cap, params, distances, kinds, count, &
                complete) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: origin(*), direction(*)
            real(c_double), intent(in), optional :: range(*)
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: kinds(*), complete
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_surface_ray_hits
        !> Where planes normal . x = offset cut a surface: all curves, proven to be all.
        function nurbs_surface_sections(g, normal, n, offsets, tolerance, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: normal(*), offsets(*)
            integer(c_int64_t), value :: n
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_sections
        !> nurbs_surface_sections() with progress reports, cancellation and a limit of work.
        function nurbs_surface_sections_with(g, normal, n, offsets, tolerance, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: normal(*), offsets(*)
            integer(c_int64_t), value :: n
            real(c_double), value :: tolerance
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_sections_with
        !> Silhouettes, isophotes and parabolic curves of a surface: all of them, proven to be all.
        function nurbs_surface_contours(g, kind, d, n, cosines, tolerance, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: kind
            real(c_double), intent(in), optional :: d(*), cosines(*)
            integer(c_int64_t), value :: n
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_contours
        !> nurbs_surface_contours() with progress reports, cancellation and a limit of work.
        function nurbs_surface_contours_with(g, kind, d, n, cosines, tolerance, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: kind
            real(c_double), intent(in), optional :: d(*), cosines(*)
            integer(c_int64_t), value :: n
            real(c_double), value :: tolerance
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_contours_with
        !> Reflection lines and highlight lines of a surface, which show how fair it is.
        function nurbs_surface_reflections(g, kind, eye, direction, n, points, point_stride, &
                point_component_stride, tolerance, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: kind
            real(c_double), intent(in), optional :: eye(*)
            real(c_double), intent(in) :: direction(*), points(*)
            integer(c_int64_t), value :: n, point_stride, point_component_stride
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_reflections
        !> nurbs_surface_reflections() with progress reports, cancellation and a limit of work.
        function nurbs_surface_reflections_with(g, kind, eye, direction, n, points, point_stride, &
                point_component_stride, tolerance, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: kind
            real(c_double), intent(in), optional :: eye(*)
            real(c_double), intent(in) :: direction(*), points(*)
            integer(c_int64_t), value :: n, point_stride, point_component_stride
            real(c_double), value :: tolerance
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_reflections_with
        !> Where an implicit polynomial f of space vanishes on a surface.
        function nurbs_surface_level(g, degree, coefficients, tolerance, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: degree
            real(c_double), intent(in) :: coefficients(*)
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_level
        !> nurbs_surface_level() with progress reports, cancellation and a limit of work.
        function nurbs_surface_level_with(g, degree, coefficients, tolerance, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: degree
            real(c_double), intent(in) :: coefficients(*)
            real(c_double), value :: tolerance
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_level_with
        !> Level curves of a scalar spline over a surface, such as a temperature, a pressure or a thickness.
        function nurbs_surface_level_curves(g, scalar, n, values, tolerance, out) bind(c) result(r)
            import
            type(c_ptr), value :: g, scalar
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: values(*)
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_level_curves
        !> nurbs_surface_level_curves() with progress reports, cancellation and a limit of work.
        function nurbs_surface_level_curves_with(g, scalar, n, values, tolerance, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g, scalar
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: values(*)
            real(c_double), value :: tolerance
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_level_curves_with
        !> Where two surfaces meet in curves: all of them, proven to be all.
        function nurbs_surface_intersections(a, b, tolerance, out) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_intersections
        !> nurbs_surface_intersections() with progress reports, cancellation and a limit of work.
        function nurbs_surface_intersections_with(a, b, tolerance, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: tolerance
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_intersections_with
        !> Where a surface meets itself: all curves of double points, or the proof that there are none.
        function nurbs_surface_self_intersections(g, tolerance, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_self_intersections
        !> nurbs_surface_self_intersections() with progress reports, cancellation and a limit of work.
        function nurbs_surface_self_intersections_with(g, tolerance, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: tolerance
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_self_intersections_with
        !> Where two faces meet: in curves, in regions, and in the edges that they share.
        function nurbs_face_intersections(a, b, tolerance, out) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_face_intersections
        !> nurbs_face_intersections() with progress reports, cancellation and a limit of work.
        function nurbs_face_intersections_with(a, b, tolerance, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: tolerance
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_face_intersections_with
        !> A curve projected onto a surface, along a direction d or along the normals of the surface.
        function nurbs_surface_project_curve(g, curve, direction, tolerance, out) bind(c) result(r)
            import
            type(c_ptr), value :: g, curve
            real(c_double), intent(in), optional :: direction(*)
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_project_curve
        !> nurbs_surface_project_curve() with progress reports, cancellation and a limit of work.
        function nurbs_surface_project_curve_with(g, curve, direction, tolerance, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g, curve
            real(c_double), intent(in), optional :: direction(*)
            real(c_double), value :: tolerance
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_surface_project_curve_with
        !> A curve projected onto a face, along a direction or along the normals of its surface.
        function nurbs_face_project_curve(face, curve, direction, tolerance, out) bind(c) result(r)
            import
            type(c_ptr), value :: face, curve
            real(c_double), intent(in), optional :: direction(*)
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_face_project_curve
        !> nurbs_face_project_curve() with progress reports, cancellation and a limit of work.
        function nurbs_face_project_curve_with(face, curve, direction, tolerance, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: face, curve
            real(c_double), intent(in), optional :: direction(*)
            real(c_double), value :: tolerance
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_face_project_curve_with
        !> Another handle on the same meet, in constant time.
        function nurbs_meet_clone(meet, out) bind(c) result(r)
            import
            type(c_ptr), value :: meet
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_meet_clone
        !> Frees a handle on a meet.
        subroutine nurbs_meet_destroy(meet) bind(c)
            import
            type(c_ptr), value :: meet
        end subroutine nurbs_meet_destroy
        !> The numbers of branches and nodes of a meet, and whether it is complete.
        function nurbs_meet_counts(meet, branches, nodes, complete) bind(c) result(r)
            import
            type(c_ptr), value :: meet
            integer(c_int64_t), intent(inout), optional :: branches, nodes
            integer(c_int32_t), intent(inout), optional :: complete
            integer(c_int32_t) :: r
        end function nurbs_meet_counts
        !> What the branches of a meet belong to, and where they end.
        function nurbs_meet_branches(meet, cap, levels, end_nodes, loops, deviations, count) bind(c) result(r)
            import
            type(c_ptr), value :: meet
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: levels(*), end_nodes(*), loops(*), count
            real(c_double), intent(inout), optional :: deviations(*)
            integer(c_int32_t) :: r
        end function nurbs_meet_branches
        !> What kind each branch of a meet is.
        function nurbs_meet_kinds(meet, cap, kinds, count) bind(c) result(r)
            import
            type(c_ptr), value :: meet
            integer(c_int64_t), value :: cap
            integer(c_int32_t), intent(inout), optional :: kinds(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_meet_kinds
        !> A branch of a meet, as curves in space and in the parameter domain.
        function nurbs_meet_branch(meet, index, space, on_surface) bind(c) result(r)
            import
            type(c_ptr), value :: meet
            integer(c_int64_t), value :: index
            type(c_ptr), intent(out) :: space, on_surface
            integer(c_int32_t) :: r
        end function nurbs_meet_branch
        !> The curve of a branch on the second of two surfaces; in a projection, the curve of (t, h).
        function nurbs_meet_branch_second(meet, index, on_second) bind(c) result(r)
            import
            type(c_ptr), value :: meet
            integer(c_int64_t), value :: index
            type(c_ptr), intent(out) :: on_second
            integer(c_int32_t) :: r
        end function nurbs_meet_branch_second
        !> The nodes of a meet: where branches end, and where something is not resolved.
        function nurbs_meet_nodes(meet, cap, levels, kinds, params, ranges, count) bind(c) result(r)
            import
            type(c_ptr), value :: meet
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: levels(*), count
            integer(c_int32_t), intent(inout), optional :: kinds(*)
            real(c_double), intent(inout), optional :: params(*), ranges(*)
            integer(c_int32_t) :: r
        end function nurbs_meet_nodes
        !> Where the nodes of a meet are on the second of two surfaces; in a projection, their (t, h).
        function nurbs_meet_nodes_second(meet, cap, params, ranges, count) bind(c) result(r)
            import
            type(c_ptr), value :: meet
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), ranges(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_meet_nodes_second
        !> The ways of a meet: chains of branches, each of which continues the one before.
        function nurbs_meet_ways(meet, cap, levels, firsts, sizes, closes, gaps, count) bind(c) result(r)
            import
            type(c_ptr), value :: meet
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: levels(*), firsts(*), sizes(*), count
            integer(c_int32_t), intent(inout), optional :: closes(*)
            real(c_double), intent(inout), optional :: gaps(*)
            integer(c_int32_t) :: r
        end function nurbs_meet_ways
        !> The faces on which the branches of a meet of a model lie; -1 in other meets.
        function nurbs_meet_faces(meet, cap, own_faces, own_instances, count) bind(c) result(r)
            import
            type(c_ptr), value :: meet
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: own_faces(*), own_instances(*), count
            integer(c_int32_t) :: r
        end function nurbs_meet_faces
        !> The faces of the second model of nurbs_model_intersections() on which branches lie; else -1.
        function nurbs_meet_faces_second(meet, cap, own_faces, own_instances, count) bind(c) result(r)
            import
            type(c_ptr), value :: meet
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: own_faces(*), own_instances(*), count
            integer(c_int32_t) :: r
        end function nurbs_meet_faces_second
        !> How branches continue at the nodes of a meet, and on which faces of a model these nodes are.
        function nurbs_meet_joints(meet, cap, next_nodes, gaps, own_faces, own_instances, count) bind(c) &
                result(r)
            import
            type(c_ptr), value :: meet
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: next_nodes(*), own_faces(*), own_instances(*), &
                count
            real(c_double), intent(inout), optional :: gaps(*)
            integer(c_int32_t) :: r
        end function nurbs_meet_joints
        !> The faces of the second model of nurbs_model_intersections() on which nodes are; else -1.
        function nurbs_meet_joints_second(meet, cap, own_faces, own_instances, count) bind(c) result(r)
            import
            type(c_ptr), value :: meet
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: own_faces(*), own_instances(*), count
            integer(c_int32_t) :: r
        end function nurbs_meet_joints_second
        !> The part of a meet that lies in a face.
        function nurbs_meet_trim(meet, face, out) bind(c) result(r)
            import
            type(c_ptr), value :: meet, face
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_meet_trim
        !> nurbs_meet_trim() with progress reports, cancellation and a limit of work.
        function nurbs_meet_trim_with(meet, face, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: meet, face
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_meet_trim_with
        !> The part of a meet of two surfaces that lies in a face of the second one.
        function nurbs_meet_trim_second(meet, face, out) bind(c) result(r)
            import
            type(c_ptr), value :: meet, face
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_meet_trim_second
        !> nurbs_meet_trim_second() with progress reports, cancellation and a limit of work.
        function nurbs_meet_trim_second_with(meet, face, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: meet, face
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_meet_trim_second_with
        ! --- Weights and control points
        !> Changes a weight so that the point at a parameter moves by a distance towards the control point, or
        !> away from it if the distance is negative.
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
        !> Multiplies several weights by one factor so that the point at a parameter moves by a distance
        !> towards (or away from) their common centre Q = sum R_i P_i / sum R_i: the formula of
        !> nurbs_pull_weight() with Q and sum R_i.
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
        !> Sets weights; control points stay, and a polynomial spline becomes rational unless count is 0.
        function nurbs_set_weights(g, count, indices, weights, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: count
            integer(c_int64_t), intent(in) :: indices(*)
            real(c_double), intent(in) :: weights(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_set_weights
        !> The points at a parameter for the weights 0, 1 and the present one of a control point.
        function nurbs_weight_points(g, index, params, at_zero, at_one, at_weight) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: index
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout), optional :: at_zero(*), at_one(*), at_weight(*)
            integer(c_int32_t) :: r
        end function nurbs_weight_points
        !> The weight as the cross ratio of four points on a line: w = (P n / n m) / (P p / p m), signed
        !> lengths, where m, n, p are the points of nurbs_weight_points().
        function nurbs_weight_cross_ratio(dim, control_point, at_zero, at_one, at_weight, weight) bind(c) &
                result(r)
            import
            integer(c_int32_t), value :: dim
            real(c_double), intent(in) :: control_point(*), at_zero(*), at_one(*), at_weight(*)
            real(c_double), intent(inout) :: weight
            integer(c_int32_t) :: r
        end function nurbs_weight_cross_ratio
        !> Sets the weight of a control point so that the point at a parameter becomes a given one, on the
        !> line through P_i and the point at weight 0, by the cross ratio.
        function nurbs_weight_through(g, index, params, target, tolerance, weight, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: index
            real(c_double), intent(in) :: params(*), target(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: weight
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_weight_through
        !> Moves a control point so that the point at a parameter moves by a distance along a direction.
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
        !> The control point with the largest |R_i(t)|, the first of several.
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
        !> Inverse knot insertion: inserts the knot that makes a point of a leg of the control polygon a
        !> control point.
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
        !> Inverse knot insertion at a point of the control polygon: the leg along the axis that is nearest to
        !> the point is taken, and the knot inserted as by nurbs_insert_on_leg().
        function nurbs_insert_at_point(g, axis, point, tolerance, index, ratio, knot, out) bind(c) result(r)
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
        ! --- Constraints
        !> The smallest change of control points, and if wanted of weights, that makes a shape meet
        !> constraints.
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
        !> nurbs_constrain() with progress reports, cancellation and a limit of work.
        function nurbs_constrain_with(g, constraints, report, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(nurbs_constraints), intent(in) :: constraints
            type(nurbs_constraint_report), intent(inout), optional :: report
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_constrain_with
        ! --- Deformations
        !> Raises a region along a direction: adds distance * b(t) * direction / |direction|, where b is 1 in
        !> the middle of the range, 0 at its ends with the first `order` derivatives, and rises and falls once
        !> along each axis: a product of B-splines of degree order + 1 over even knots, added exactly.
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
        !> Flattens a region to a plane (in the plane: to a line): control points of the region are projected
        !> onto it along a direction; those inside it only, so that the shape joins what is outside as
        !> smoothly as the degree allows.
        function nurbs_flatten(g, range, point, normal, direction, moved, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: range(*), direction(*)
            real(c_double), intent(in) :: point(*), normal(*)
            real(c_double), intent(inout), optional :: moved
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_flatten
        !> Bends a shape about an axis (Barr 1984).
        function nurbs_bend(g, origin, along, across, curvature, lower, upper, tolerance, deviation, proven, &
                out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: origin(*), along(*), across(*)
            real(c_double), value :: curvature, lower, upper, tolerance
            real(c_double), intent(inout), optional :: deviation
            integer(c_int32_t), intent(inout), optional :: proven
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_bend
        !> nurbs_bend() with progress reports, cancellation and a limit of work.
        function nurbs_bend_with(g, origin, along, across, curvature, lower, upper, tolerance, deviation, &
                proven, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in) :: origin(*), along(*), across(*)
            real(c_double), value :: curvature, lower, upper, tolerance
            real(c_double), intent(inout), optional :: deviation
            integer(c_int32_t), intent(inout), optional :: proven
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_bend_with
        !> Free-form deformation (Sederberg & Parry 1986): maps a shape by a volume, C -> V(A C), where A maps
        !> the box from lower to upper to the domain of V.
        function nurbs_free_form_deform(g, volume, lower, upper, tolerance, deviation, proven, out) bind(c) &
                result(r)
            import
            type(c_ptr), value :: g, volume
            real(c_double), intent(in) :: lower(*), upper(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: deviation
            integer(c_int32_t), intent(inout), optional :: proven
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_free_form_deform
        !> nurbs_free_form_deform() with progress reports, cancellation and a limit of work.
        function nurbs_free_form_deform_with(g, volume, lower, upper, tolerance, deviation, proven, call, &
                out) bind(c) result(r)
            import
            type(c_ptr), value :: g, volume
            real(c_double), intent(in) :: lower(*), upper(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: deviation
            integer(c_int32_t), intent(inout), optional :: proven
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_free_form_deform_with
        !> Fairs a shape: among the splines with the same knots and weights that are at most a tolerance away,
        !> and of them those that move control points least for their energy, the one with the least energy,
        !> the integral of the squared derivatives of an order, summed over the axes (of homogeneous
        !> coordinates about the centre when rational).
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
        !> nurbs_fair() with progress reports, cancellation and a limit of work.
        function nurbs_fair_with(g, order, keep, tolerance, energies, bound, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: order
            integer(c_int32_t), intent(in), optional :: keep(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: energies(*), bound
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_fair_with
        !> Moves a boundary of a spline onto one of another: a curve's end onto an end, a surface's edge onto
        !> an edge.
        function nurbs_snap_boundary(g, axis, end, other, other_axis, other_end, order, flags, bound, out) &
                bind(c) result(r)
            import
            type(c_ptr), value :: g, other
            integer(c_int32_t), value :: axis, end, other_axis, other_end, order, flags
            real(c_double), intent(inout), optional :: bound
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_snap_boundary
        ! --- Derivatives with respect to data
        !> Collocation matrix of B-spline basis functions, or of one of their partial derivatives, as
        !> compressed sparse rows (CSR), the arrays that SciPy and Eigen take.
        function nurbs_collocation(axes, degrees, counts, knots, knot_count, orders, n, params, &
                param_stride, param_component_stride, cap, values, columns, row_pointers, entries, flags) &
                bind(c) result(r)
            import
            integer(c_int32_t), value :: axes, flags
            integer(c_int32_t), intent(in) :: degrees(*)
            integer(c_int64_t), intent(in) :: counts(*)
            real(c_double), intent(in) :: knots(*), params(*)
            integer(c_int64_t), value :: knot_count, n, param_stride, param_component_stride, cap
            integer(c_int32_t), intent(in), optional :: orders(*)
            real(c_double), intent(inout), optional :: values(*)
            integer(c_int64_t), intent(inout), optional :: columns(*), row_pointers(*), entries
            integer(c_int32_t) :: r
        end function nurbs_collocation
        !> Collocation matrix of the rational basis functions R_j = w_j N_j / w(t) of a spline, or of one of
        !> their partial derivatives; of N_j for a polynomial spline.
        function nurbs_rational_collocation(g, orders, n, params, param_stride, param_component_stride, cap, &
                values, columns, row_pointers, entries, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), intent(in), optional :: orders(*)
            integer(c_int64_t), value :: n, param_stride, param_component_stride, cap
            real(c_double), intent(in) :: params(*)
            real(c_double), intent(inout), optional :: values(*)
            integer(c_int64_t), intent(inout), optional :: columns(*), row_pointers(*), entries
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_rational_collocation
        !> Bezier extraction operators of the non-empty spans of an axis (Borden, Scott, Evans & Hughes 2011).
        function nurbs_bezier_extraction(g, axis, cap, operators, firsts, domains, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: operators(*), domains(*)
            integer(c_int64_t), intent(inout), optional :: firsts(*)
            integer(c_int64_t), intent(inout) :: count
            integer(c_int32_t) :: r
        end function nurbs_bezier_extraction
        !> Gradients of a function L of points and derivatives with respect to the control points, the weights
        !> and the parameters: the transpose of nurbs_eval_derivs(), or of nurbs_eval() with order 0.
        function nurbs_eval_adjoint(g, order, n, params, param_stride, param_component_stride, cotangents, &
                cotangent_stride, cotangent_component_stride, grad_points, grad_point_stride, &
                grad_point_component_stride, grad_weights, grad_weight_stride, grad_params, &
                grad_param_stride, grad_param_component_stride, flags) bind(c) result(r)
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
        !> Gradients of a function L of points and derivatives with respect to the knots of an axis.
        function nurbs_eval_adjoint_knots(g, axis, order, n, params, param_stride, param_component_stride, &
                cotangents, cotangent_stride, cotangent_component_stride, grad_knots, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int32_t), value :: axis, order, flags
            integer(c_int64_t), value :: n, param_stride, param_component_stride, cotangent_stride, &
                cotangent_component_stride
            real(c_double), intent(in) :: params(*), cotangents(*)
            real(c_double), intent(inout) :: grad_knots(*)
            integer(c_int32_t) :: r
        end function nurbs_eval_adjoint_knots
        !> Gradients of a function L of closest points, or of any places where the distance to a point is
        !> critical, with respect to control points, weights and the query points, by the implicit function
        !> theorem.
        function nurbs_closest_adjoint(g, n, points, params, param_cotangents, foot_cotangents, &
                distance_cotangents, grad_points, grad_weights, grad_queries, status, flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: points(*), params(*)
            real(c_double), intent(in), optional :: param_cotangents(*), foot_cotangents(*), &
                distance_cotangents(*)
            real(c_double), intent(inout), optional :: grad_points(*), grad_weights(*), grad_queries(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_closest_adjoint
        !> Gradients of the length of a curve, or of a part of it, with respect to control points and weights:
        !> with the unit tangent T and the rational functions R_i.
        function nurbs_length_adjoint(g, range, relative_tolerance, cotangent, grad_points, &
                grad_point_stride, grad_point_component_stride, grad_weights, grad_weight_stride, error, &
                flags) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), intent(in), optional :: range(*)
            real(c_double), value :: relative_tolerance, cotangent
            real(c_double), intent(inout), optional :: grad_points(*), grad_weights(*), error
            integer(c_int64_t), value :: grad_point_stride, grad_point_component_stride, grad_weight_stride
            integer(c_int32_t), value :: flags
            integer(c_int32_t) :: r
        end function nurbs_length_adjoint
        ! --- Trimmed faces
        !> A face made of a surface and loops of curves.
        function nurbs_face_create(surface, loops, sizes, curves, edges, keys, tolerance, flags, gaps, out) &
                bind(c) result(r)
            import
            type(c_ptr), value :: surface
            integer(c_int64_t), value :: loops
            integer(c_int64_t), intent(in), optional :: sizes(*), keys(*)
            type(c_ptr), intent(in), optional :: curves(*), edges(*)
            real(c_double), value :: tolerance
            integer(c_int32_t), value :: flags
            real(c_double), intent(inout), optional :: gaps(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_face_create
        !> nurbs_face_create() with progress reports, cancellation and a limit of work.
        function nurbs_face_create_with(surface, loops, sizes, curves, edges, keys, tolerance, flags, gaps, &
                call, out) bind(c) result(r)
            import
            type(c_ptr), value :: surface
            integer(c_int64_t), value :: loops
            integer(c_int64_t), intent(in), optional :: sizes(*), keys(*)
            type(c_ptr), intent(in), optional :: curves(*), edges(*)
            real(c_double), value :: tolerance
            integer(c_int32_t), value :: flags
            real(c_double), intent(inout), optional :: gaps(*)
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_face_create_with
        !> Another handle on the same face, in constant time.
        function nurbs_face_clone(face, out) bind(c) result(r)
            import
            type(c_ptr), value :: face
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_face_clone
        !> Frees a handle on a face.
        subroutine nurbs_face_destroy(face) bind(c)
            import
            type(c_ptr), value :: face
        end subroutine nurbs_face_destroy
        !> The surface of a face.
        function nurbs_face_surface(face, out) bind(c) result(r)
            import
            type(c_ptr), value :: face
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_face_surface
        !> The number of curves of each loop.
        function nurbs_face_loops(face, cap, sizes, count) bind(c) result(r)
            import
            type(c_ptr), value :: face
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: sizes(*), count
            integer(c_int32_t) :: r
        end function nurbs_face_loops
        !> A curve of a loop in the domain of the surface, running with the inside to its left.
        function nurbs_face_curve(face, loop, index, out) bind(c) result(r)
            import
            type(c_ptr), value :: face
            integer(c_int64_t), value :: loop, index
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_face_curve
        !> The edge in space that belongs to a curve of a loop.
        function nurbs_face_edge(face, loop, index, key, out) bind(c) result(r)
            import
            type(c_ptr), value :: face
            integer(c_int64_t), value :: loop, index
            integer(c_int64_t), intent(inout), optional :: key
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_face_edge
        !> How far a curve of a loop, mapped by the surface, and its edge are apart.
        function nurbs_face_deviation(face, loop, index, distance, proven) bind(c) result(r)
            import
            type(c_ptr), value :: face
            integer(c_int64_t), value :: loop, index
            real(c_double), intent(inout) :: distance
            integer(c_int32_t), intent(inout), optional :: proven
            integer(c_int32_t) :: r
        end function nurbs_face_deviation
        !> The tolerance that a face was created with.
        function nurbs_face_tolerance(face, tolerance) bind(c) result(r)
            import
            type(c_ptr), value :: face
            real(c_double), intent(inout) :: tolerance
            integer(c_int32_t) :: r
        end function nurbs_face_tolerance
        !> On which side of the boundary of a face places of the domain lie.
        function nurbs_face_classify(face, n, params, param_stride, param_component_stride, tolerance, &
                sides) bind(c) result(r)
            import
            type(c_ptr), value :: face
            integer(c_int64_t), value :: n, param_stride, param_component_stride
            real(c_double), intent(in) :: params(*)
            real(c_double), value :: tolerance
            integer(c_int32_t), intent(inout) :: sides(*)
            integer(c_int32_t) :: r
        end function nurbs_face_classify
        !> nurbs_face_classify() with progress reports, cancellation and a limit of work.
        function nurbs_face_classify_with(face, n, params, param_stride, param_component_stride, tolerance, &
                sides, call) bind(c) result(r)
            import
            type(c_ptr), value :: face
            integer(c_int64_t), value :: n, param_stride, param_component_stride
            real(c_double), intent(in) :: params(*)
            real(c_double), value :: tolerance
            integer(c_int32_t), intent(inout) :: sides(*)
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_face_classify_with
        !> The first hits of rays x = origin + t direction, t >= 0, with a face.
        function nurbs_face_rays(face, n, origins, origin_stride, origin_component_stride, directions, &
                direction_stride, direction_component_stride, params, distances, status) bind(c) result(r)
            import
            type(c_ptr), value :: face
            integer(c_int64_t), value :: n, origin_stride, origin_component_stride, direction_stride, &
                direction_component_stride
            real(c_double), intent(in) :: origins(*), directions(*)
            real(c_double), intent(inout), optional :: params(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t) :: r
        end function nurbs_face_rays
        !> nurbs_face_rays() with progress reports, cancellation and a limit of work.
        function nurbs_face_rays_with(face, n, origins, origin_stride, origin_component_stride, directions, &
                direction_stride, direction_component_stride, params, distances, status, call) bind(c) &
                result(r)
            import
            type(c_ptr), value :: face
            integer(c_int64_t), value :: n, origin_stride, origin_component_stride, direction_stride, &
                direction_component_stride
            real(c_double), intent(in) :: origins(*), directions(*)
            real(c_double), intent(inout), optional :: params(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_face_rays_with
        !> The points of a face that are nearest to given points.
        function nurbs_face_closest_points(face, n, points, point_stride, point_component_stride, tolerance, &
                params, feet, distances, status) bind(c) result(r)
            import
            type(c_ptr), value :: face
            integer(c_int64_t), value :: n, point_stride, point_component_stride
            real(c_double), intent(in) :: points(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: params(*), feet(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int32_t) :: r
        end function nurbs_face_closest_points
        !> nurbs_face_closest_points() with progress reports, cancellation and a limit of work.
        function nurbs_face_closest_points_with(face, n, points, point_stride, point_component_stride, &
                tolerance, params, feet, distances, status, call) bind(c) result(r)
            import
            type(c_ptr), value :: face
            integer(c_int64_t), value :: n, point_stride, point_component_stride
            real(c_double), intent(in) :: points(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: params(*), feet(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_face_closest_points_with
        !> Proven bounds of the smallest distance between two faces.
        function nurbs_face_distance(a, b, tolerance, at_least, at_most, params_a, params_b, status) bind(c) &
                result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: at_least, at_most, params_a(*), params_b(*)
            integer(c_int32_t), intent(inout), optional :: status
            integer(c_int32_t) :: r
        end function nurbs_face_distance
        !> nurbs_face_distance() with progress reports, cancellation and a limit of work.
        function nurbs_face_distance_with(a, b, tolerance, at_least, at_most, params_a, params_b, status, &
                call) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: at_least, at_most, params_a(*), params_b(*)
            integer(c_int32_t), intent(inout), optional :: status
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_face_distance_with
        !> Proven bounds of the Hausdorff distances of two faces.
        function nurbs_face_hausdorff_distance(a, b, tolerance, at_least, at_most, params_a, params_b, &
                status) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: at_least(*), at_most(*), params_a(*), params_b(*)
            integer(c_int32_t), intent(inout), optional :: status
            integer(c_int32_t) :: r
        end function nurbs_face_hausdorff_distance
        !> nurbs_face_hausdorff_distance() with progress reports, cancellation and a limit of work.
        function nurbs_face_hausdorff_distance_with(a, b, tolerance, at_least, at_most, params_a, params_b, &
                status, call) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: at_least(*), at_most(*), params_a(*), params_b(*)
            integer(c_int32_t), intent(inout), optional :: status
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_face_hausdorff_distance_with
        !> The area of a face.
        function nurbs_face_area(face, relative_tolerance, area, error) bind(c) result(r)
            import
            type(c_ptr), value :: face
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: area
            real(c_double), intent(inout), optional :: error
            integer(c_int32_t) :: r
        end function nurbs_face_area
        !> nurbs_face_area() with progress reports, cancellation and a limit of work.
        function nurbs_face_area_with(face, relative_tolerance, area, error, call) bind(c) result(r)
            import
            type(c_ptr), value :: face
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: area
            real(c_double), intent(inout), optional :: error
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_face_area_with
        !> Area, centroid and inertia of a face, as nurbs_moments() computes them for a whole surface.
        function nurbs_face_moments(face, relative_tolerance, content, centroid, inertia, error) bind(c) &
                result(r)
            import
            type(c_ptr), value :: face
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: content
            real(c_double), intent(inout), optional :: centroid(*), inertia(*), error
            integer(c_int32_t) :: r
        end function nurbs_face_moments
        !> nurbs_face_moments() with progress reports, cancellation and a limit of work.
        function nurbs_face_moments_with(face, relative_tolerance, content, centroid, inertia, error, call) &
                bind(c) result(r)
            import
            type(c_ptr), value :: face
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: content
            real(c_double), intent(inout), optional :: centroid(*), inertia(*), error
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_face_moments_with
        !> Points and weights for integrals of any function over a face.
        function nurbs_face_quadrature(face, nodes, cap, params, weights, measures, count) bind(c) result(r)
            import
            type(c_ptr), value :: face
            integer(c_int32_t), value :: nodes
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), weights(*), measures(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_face_quadrature
        !> nurbs_face_quadrature() with progress reports, cancellation and a limit of work.
        function nurbs_face_quadrature_with(face, nodes, cap, params, weights, measures, count, call) &
                bind(c) result(r)
            import
            type(c_ptr), value :: face
            integer(c_int32_t), value :: nodes
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), weights(*), measures(*)
            integer(c_int64_t), intent(inout), optional :: count
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_face_quadrature_with
        !> An axis-aligned box that contains a face.
        function nurbs_face_box(face, tolerance, lower, upper, gap) bind(c) result(r)
            import
            type(c_ptr), value :: face
            real(c_double), value :: tolerance
            real(c_double), intent(inout) :: lower(*), upper(*)
            real(c_double), intent(inout), optional :: gap
            integer(c_int32_t) :: r
        end function nurbs_face_box
        !> nurbs_face_box() with progress reports, cancellation and a limit of work.
        function nurbs_face_box_with(face, tolerance, lower, upper, gap, call) bind(c) result(r)
            import
            type(c_ptr), value :: face
            real(c_double), value :: tolerance
            real(c_double), intent(inout) :: lower(*), upper(*)
            real(c_double), intent(inout), optional :: gap
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_face_box_with
        ! --- Reading files
        !> Fills an options struct with the defaults.
        function nurbs_read_options_init(options, struct_size) bind(c) result(r)
            import
            type(nurbs_read_options), intent(inout) :: options
            integer(c_int64_t), value :: struct_size
            integer(c_int32_t) :: r
        end function nurbs_read_options_init
        !> Reads the curves and surfaces of an IGES or a STEP file.
        function nurbs_read(bytes, size, options, out) bind(c) result(r)
            import
            type(c_ptr), value :: bytes
            integer(c_int64_t), value :: size
            type(nurbs_read_options), intent(in), optional :: options
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_read
        !> nurbs_read() with progress reports, cancellation and a limit of work.
        function nurbs_read_with(bytes, size, options, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: bytes
            integer(c_int64_t), value :: size
            type(nurbs_read_options), intent(in), optional :: options
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_read_with
        !> Reads a file by its path; see nurbs_read().
        function nurbs_read_file(path, options, out) bind(c) result(r)
            import
            character(kind=c_char), intent(in) :: path(*)
            type(nurbs_read_options), intent(in), optional :: options
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_read_file
        !> nurbs_read_file() with progress reports, cancellation and a limit of work.
        function nurbs_read_file_with(path, options, call, out) bind(c) result(r)
            import
            character(kind=c_char), intent(in) :: path(*)
            type(nurbs_read_options), intent(in), optional :: options
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_read_file_with
        !> A list of given splines.
        function nurbs_list_create(count, splines, names, metres, out) bind(c) result(r)
            import
            integer(c_int64_t), value :: count
            type(c_ptr), intent(in) :: splines(*)
            type(c_ptr), intent(in), optional :: names(*)
            real(c_double), value :: metres
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_list_create
        !> Number of splines in a list.
        function nurbs_list_count(list, count) bind(c) result(r)
            import
            type(c_ptr), value :: list
            integer(c_int64_t), intent(inout) :: count
            integer(c_int32_t) :: r
        end function nurbs_list_count
        !> A new handle on spline `index`, which outlives the list.
        function nurbs_list_get(list, index, out) bind(c) result(r)
            import
            type(c_ptr), value :: list
            integer(c_int64_t), value :: index
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_list_get
        !> The name of spline `index`.
        function nurbs_list_name(list, index, buf, cap, length) bind(c) result(r)
            import
            type(c_ptr), value :: list
            integer(c_int64_t), value :: index, cap
            character(kind=c_char), intent(inout), optional :: buf(*)
            integer(c_int64_t), intent(inout), optional :: length
            integer(c_int32_t) :: r
        end function nurbs_list_name
        !> Number of notes: entities of the file that did not become a spline, or only approximately.
        function nurbs_list_note_count(list, count) bind(c) result(r)
            import
            type(c_ptr), value :: list
            integer(c_int64_t), intent(inout) :: count
            integer(c_int32_t) :: r
        end function nurbs_list_note_count
        !> A note: which entity, where, and why it did not become a spline.
        function nurbs_list_note(list, index, entity_type, line, reason, buf, cap, length) bind(c) result(r)
            import
            type(c_ptr), value :: list
            integer(c_int64_t), value :: index, cap
            integer(c_int32_t), intent(inout), optional :: entity_type, reason
            integer(c_int64_t), intent(inout), optional :: line, length
            character(kind=c_char), intent(inout), optional :: buf(*)
            integer(c_int32_t) :: r
        end function nurbs_list_note
        !> The unit of length of the splines in a list.
        function nurbs_list_unit(list, metres) bind(c) result(r)
            import
            type(c_ptr), value :: list
            real(c_double), intent(inout) :: metres
            integer(c_int32_t) :: r
        end function nurbs_list_unit
        !> Frees a list.
        subroutine nurbs_list_destroy(list) bind(c)
            import
            type(c_ptr), value :: list
        end subroutine nurbs_list_destroy
        ! --- Handles as bytes
        !> A spline as bytes.
        function nurbs_to_bytes(g, cap, bytes, length) bind(c) result(r)
            import
            type(c_ptr), value :: g, bytes
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: length
            integer(c_int32_t) :: r
        end function nurbs_to_bytes
        !> The spline of the bytes of nurbs_to_bytes().
        function nurbs_from_bytes(bytes, size, out) bind(c) result(r)
            import
            type(c_ptr), value :: bytes
            integer(c_int64_t), value :: size
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_from_bytes
        !> A list as bytes, with names, notes and unit.
        function nurbs_list_to_bytes(list, cap, bytes, length) bind(c) result(r)
            import
            type(c_ptr), value :: list, bytes
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: length
            integer(c_int32_t) :: r
        end function nurbs_list_to_bytes
        !> The list of the bytes of nurbs_list_to_bytes().
        function nurbs_list_from_bytes(bytes, size, out) bind(c) result(r)
            import
            type(c_ptr), value :: bytes
            integer(c_int64_t), value :: size
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_list_from_bytes
        !> A face as bytes.
        function nurbs_face_to_bytes(face, cap, bytes, length) bind(c) result(r)
            import
            type(c_ptr), value :: face, bytes
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: length
            integer(c_int32_t) :: r
        end function nurbs_face_to_bytes
        !> The face of the bytes of nurbs_face_to_bytes().
        function nurbs_face_from_bytes(bytes, size, out) bind(c) result(r)
            import
            type(c_ptr), value :: bytes
            integer(c_int64_t), value :: size
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_face_from_bytes
        !> A model as bytes, with everything that it holds.
        function nurbs_model_to_bytes(model, cap, bytes, length) bind(c) result(r)
            import
            type(c_ptr), value :: model, bytes
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: length
            integer(c_int32_t) :: r
        end function nurbs_model_to_bytes
        !> The model of the bytes of nurbs_model_to_bytes().
        function nurbs_model_from_bytes(bytes, size, out) bind(c) result(r)
            import
            type(c_ptr), value :: bytes
            integer(c_int64_t), value :: size
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_model_from_bytes
        !> The kind of handle that bytes hold, and the version of their form.
        function nurbs_bytes_kind(bytes, size, kind, major, minor) bind(c) result(r)
            import
            type(c_ptr), value :: bytes
            integer(c_int64_t), value :: size
            integer(c_int32_t), intent(inout), optional :: kind, major, minor
            integer(c_int32_t) :: r
        end function nurbs_bytes_kind
        ! --- Models
        !> Reads the faces, edges and vertices of a STEP or an IGES file.
        function nurbs_read_model(bytes, size, options, out) bind(c) result(r)
            import
            type(c_ptr), value :: bytes
            integer(c_int64_t), value :: size
            type(nurbs_read_options), intent(in), optional :: options
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_read_model
        !> nurbs_read_model() with progress reports, cancellation and a limit of work.
        function nurbs_read_model_with(bytes, size, options, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: bytes
            integer(c_int64_t), value :: size
            type(nurbs_read_options), intent(in), optional :: options
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_read_model_with
        !> Reads a model from a file by its path; see nurbs_read_model().
        function nurbs_read_model_file(path, options, out) bind(c) result(r)
            import
            character(kind=c_char), intent(in) :: path(*)
            type(nurbs_read_options), intent(in), optional :: options
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_read_model_file
        !> nurbs_read_model_file() with progress reports, cancellation and a limit of work.
        function nurbs_read_model_file_with(path, options, call, out) bind(c) result(r)
            import
            character(kind=c_char), intent(in) :: path(*)
            type(nurbs_read_options), intent(in), optional :: options
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_read_model_file_with
        !> A model made of faces, with one part and one use of it.
        function nurbs_model_create(count, faces, metres, out) bind(c) result(r)
            import
            integer(c_int64_t), value :: count
            type(c_ptr), intent(in) :: faces(*)
            real(c_double), value :: metres
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_model_create
        !> A model sewn from patches without topology: boundaries that coincide become common edges.
        function nurbs_model_sew(count, faces, tolerance, metres, out) bind(c) result(r)
            import
            integer(c_int64_t), value :: count
            type(c_ptr), intent(in) :: faces(*)
            real(c_double), value :: tolerance, metres
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_model_sew
        !> nurbs_model_sew() with progress reports, cancellation and a limit of work.
        function nurbs_model_sew_with(count, faces, tolerance, metres, call, out) bind(c) result(r)
            import
            integer(c_int64_t), value :: count
            type(c_ptr), intent(in) :: faces(*)
            real(c_double), value :: tolerance, metres
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_model_sew_with
        !> Another handle on the same model, in constant time.
        function nurbs_model_clone(model, out) bind(c) result(r)
            import
            type(c_ptr), value :: model
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_model_clone
        !> Frees a handle on a model.
        subroutine nurbs_model_destroy(model) bind(c)
            import
            type(c_ptr), value :: model
        end subroutine nurbs_model_destroy
        !> The numbers of parts, uses, faces, edges and vertices of a model.
        function nurbs_model_counts(model, parts, uses, faces, edges, vertices) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), intent(inout), optional :: parts, uses, faces, edges, vertices
            integer(c_int32_t) :: r
        end function nurbs_model_counts
        !> A face of a model, with its part, kind, orientation and colour.
        function nurbs_model_face(model, index, part, shape, against, colour, out) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: index
            integer(c_int64_t), intent(inout), optional :: part
            integer(c_int32_t), intent(inout), optional :: shape, against
            real(c_double), intent(inout), optional :: colour(*)
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_model_face
        !> The name of a face.
        function nurbs_model_face_name(model, index, buf, cap, length) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: index, cap
            character(kind=c_char), intent(inout), optional :: buf(*)
            integer(c_int64_t), intent(inout), optional :: length
            integer(c_int32_t) :: r
        end function nurbs_model_face_name
        !> The solid that a face bounds.
        function nurbs_model_face_solid(model, index, solid, in_void) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: index
            integer(c_int64_t), intent(inout), optional :: solid
            integer(c_int32_t), intent(inout), optional :: in_void
            integer(c_int32_t) :: r
        end function nurbs_model_face_solid
        !> The layers that a face is in.
        function nurbs_model_face_layers(model, index, cap, layers, count) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: index, cap
            integer(c_int64_t), intent(inout), optional :: layers(*), count
            integer(c_int32_t) :: r
        end function nurbs_model_face_layers
        !> An edge of a model, with its part, end vertices and kind.
        function nurbs_model_edge(model, index, part, end_vertices, shape, out) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: index
            integer(c_int64_t), intent(inout), optional :: part, end_vertices(*)
            integer(c_int32_t), intent(inout), optional :: shape
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_model_edge
        !> Where faces use an edge: once at a free boundary, twice inside a shell.
        function nurbs_model_edge_uses(model, index, cap, places, count) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: index, cap
            integer(c_int64_t), intent(inout), optional :: places(*), count
            integer(c_int32_t) :: r
        end function nurbs_model_edge_uses
        !> How well faces meet at the edges of a model: the number of uses and the largest gap of each edge.
        function nurbs_model_edge_gaps(model, cap, uses, gaps, bounded, count) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: uses(*), count
            real(c_double), intent(inout), optional :: gaps(*)
            integer(c_int32_t), intent(inout), optional :: bounded(*)
            integer(c_int32_t) :: r
        end function nurbs_model_edge_gaps
        !> The point of a vertex, in the coordinates of its part.
        function nurbs_model_vertex(model, index, point) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: index
            real(c_double), intent(inout) :: point(*)
            integer(c_int32_t) :: r
        end function nurbs_model_vertex
        !> The name of a part.
        function nurbs_model_part(model, index, buf, cap, length) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: index, cap
            character(kind=c_char), intent(inout), optional :: buf(*)
            integer(c_int64_t), intent(inout), optional :: length
            integer(c_int32_t) :: r
        end function nurbs_model_part
        !> A use of a part: where it is placed.
        function nurbs_model_use(model, index, parent, part, placement) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: index
            integer(c_int64_t), intent(inout), optional :: parent, part
            real(c_double), intent(inout), optional :: placement(*)
            integer(c_int32_t) :: r
        end function nurbs_model_use
        !> Where the parts of a model stand in the whole: each chain of uses from the whole to a part.
        function nurbs_model_instances(model, cap, parents, last_uses, own_parts, placements, count) bind(c) &
                result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: parents(*), last_uses(*), own_parts(*), count
            real(c_double), intent(inout), optional :: placements(*)
            integer(c_int32_t) :: r
        end function nurbs_model_instances
        !> The first hits of rays x = origin + t direction, t >= 0, with the faces of a model.
        function nurbs_model_rays(model, n, origins, directions, params, distances, status, places) bind(c) &
                result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: origins(*), directions(*)
            real(c_double), intent(inout), optional :: params(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int64_t), intent(inout), optional :: places(*)
            integer(c_int32_t) :: r
        end function nurbs_model_rays
        !> nurbs_model_rays() with progress reports, cancellation and a limit of work.
        function nurbs_model_rays_with(model, n, origins, directions, params, distances, status, places, &
                call) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: origins(*), directions(*)
            real(c_double), intent(inout), optional :: params(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int64_t), intent(inout), optional :: places(*)
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_model_rays_with
        !> All places where a ray meets the faces of a model, in the order of rising t.
        function nurbs_model_ray_hits(model, origin, direction, range, cap, params, distances, kinds, &
                places, count, complete) bind(c) result(r)
            import
            type(c_ptr), value :: model
            real(c_double), intent(in) :: origin(*), direction(*)
            real(c_double), intent(in), optional :: range(*)
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: kinds(*), complete
            integer(c_int64_t), intent(inout), optional :: places(*), count
            integer(c_int32_t) :: r
        end function nurbs_model_ray_hits
        !> nurbs_model_ray_hits() with progress reports, cancellation and a limit of work.
        function nurbs_model_ray_hits_with(model, origin, direction, range, cap, params, distances, kinds, &
                places, count, complete, call) bind(c) result(r)
            import
            type(c_ptr), value :: model
            real(c_double), intent(in) :: origin(*), direction(*)
            real(c_double), intent(in), optional :: range(*)
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: kinds(*), complete
            integer(c_int64_t), intent(inout), optional :: places(*), count
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_model_ray_hits_with
        !> Whether points are inside the solids of a closed model.
        function nurbs_model_classify(model, n, points, point_stride, point_component_stride, tolerance, &
                sides) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: n, point_stride, point_component_stride
            real(c_double), intent(in) :: points(*)
            real(c_double), value :: tolerance
            integer(c_int32_t), intent(inout) :: sides(*)
            integer(c_int32_t) :: r
        end function nurbs_model_classify
        !> nurbs_model_classify() with progress reports, cancellation and a limit of work.
        function nurbs_model_classify_with(model, n, points, point_stride, point_component_stride, &
                tolerance, sides, call) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: n, point_stride, point_component_stride
            real(c_double), intent(in) :: points(*)
            real(c_double), value :: tolerance
            integer(c_int32_t), intent(inout) :: sides(*)
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_model_classify_with
        !> The points of a model that are nearest to given points.
        function nurbs_model_closest_points(model, n, points, point_stride, point_component_stride, &
                tolerance, params, feet, distances, status, places) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: n, point_stride, point_component_stride
            real(c_double), intent(in) :: points(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: params(*), feet(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int64_t), intent(inout), optional :: places(*)
            integer(c_int32_t) :: r
        end function nurbs_model_closest_points
        !> nurbs_model_closest_points() with progress reports, cancellation and a limit of work.
        function nurbs_model_closest_points_with(model, n, points, point_stride, point_component_stride, &
                tolerance, params, feet, distances, status, places, call) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: n, point_stride, point_component_stride
            real(c_double), intent(in) :: points(*)
            real(c_double), value :: tolerance
            real(c_double), intent(inout), optional :: params(*), feet(*), distances(*)
            integer(c_int32_t), intent(inout), optional :: status(*)
            integer(c_int64_t), intent(inout), optional :: places(*)
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_model_closest_points_with
        !> Where planes cut the faces of a model, with the curves joined to ways over shared edges.
        function nurbs_model_sections(model, n, normals, offsets, tolerance, out) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: normals(*), offsets(*)
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_model_sections
        !> nurbs_model_sections() with progress reports, cancellation and a limit of work.
        function nurbs_model_sections_with(model, n, normals, offsets, tolerance, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: normals(*), offsets(*)
            real(c_double), value :: tolerance
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_model_sections_with
        !> Where the faces of two models meet, with the curves joined to ways over shared edges.
        function nurbs_model_intersections(a, b, tolerance, out) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_model_intersections
        !> nurbs_model_intersections() with progress reports, cancellation and a limit of work.
        function nurbs_model_intersections_with(a, b, tolerance, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: a, b
            real(c_double), value :: tolerance
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_model_intersections_with
        !> The area of all faces of a model where they stand in the whole (nurbs_model_instances()).
        function nurbs_model_area(model, relative_tolerance, area, error) bind(c) result(r)
            import
            type(c_ptr), value :: model
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: area
            real(c_double), intent(inout), optional :: error
            integer(c_int32_t) :: r
        end function nurbs_model_area
        !> nurbs_model_area() with progress reports, cancellation and a limit of work.
        function nurbs_model_area_with(model, relative_tolerance, area, error, call) bind(c) result(r)
            import
            type(c_ptr), value :: model
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: area
            real(c_double), intent(inout), optional :: error
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_model_area_with
        !> Volume, centroid and inertia of the solids of a closed model.
        function nurbs_model_volume(model, relative_tolerance, volume, centroid, inertia, openness, error) &
                bind(c) result(r)
            import
            type(c_ptr), value :: model
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: volume
            real(c_double), intent(inout), optional :: centroid(*), inertia(*), openness, error
            integer(c_int32_t) :: r
        end function nurbs_model_volume
        !> nurbs_model_volume() with progress reports, cancellation and a limit of work.
        function nurbs_model_volume_with(model, relative_tolerance, volume, centroid, inertia, openness, &
                error, call) bind(c) result(r)
            import
            type(c_ptr), value :: model
            real(c_double), value :: relative_tolerance
            real(c_double), intent(inout) :: volume
            real(c_double), intent(inout), optional :: centroid(*), inertia(*), openness, error
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_model_volume_with
        !> The curves and surfaces of a file that are part of no face or edge, as a list.
        function nurbs_model_splines(model, out) bind(c) result(r)
            import
            type(c_ptr), value :: model
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_model_splines
        !> The layers that one of the splines of nurbs_model_splines() is in.
        function nurbs_model_spline_layers(model, index, cap, layers, count) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: index, cap
            integer(c_int64_t), intent(inout), optional :: layers(*), count
            integer(c_int32_t) :: r
        end function nurbs_model_spline_layers
        !> The number of layers that faces and splines of a model are in.
        function nurbs_model_layer_count(model, count) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), intent(inout) :: count
            integer(c_int32_t) :: r
        end function nurbs_model_layer_count
        !> The name of a layer.
        function nurbs_model_layer(model, index, buf, cap, length) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: index, cap
            character(kind=c_char), intent(inout), optional :: buf(*)
            integer(c_int64_t), intent(inout), optional :: length
            integer(c_int32_t) :: r
        end function nurbs_model_layer
        ! --- Regions, and parts of faces
        !> The region of the plane that closed curves enclose, however they cross, touch or lie in each other.
        function nurbs_region_create(count, curves, rule, tolerance, out) bind(c) result(r)
            import
            integer(c_int64_t), value :: count
            type(c_ptr), intent(in) :: curves(*)
            integer(c_int32_t), value :: rule
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_region_create
        !> nurbs_region_create() with progress reports, cancellation and a limit of work.
        function nurbs_region_create_with(count, curves, rule, tolerance, call, out) bind(c) result(r)
            import
            integer(c_int64_t), value :: count
            type(c_ptr), intent(in) :: curves(*)
            integer(c_int32_t), value :: rule
            real(c_double), value :: tolerance
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_region_create_with
        !> The union, intersection, difference or symmetric difference of two regions.
        function nurbs_region_combine(rule, count_a, a, count_b, b, tolerance, out) bind(c) result(r)
            import
            integer(c_int32_t), value :: rule
            integer(c_int64_t), value :: count_a, count_b
            type(c_ptr), intent(in) :: a(*), b(*)
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_region_combine
        !> nurbs_region_combine() with progress reports, cancellation and a limit of work.
        function nurbs_region_combine_with(rule, count_a, a, count_b, b, tolerance, call, out) bind(c) &
                result(r)
            import
            integer(c_int32_t), value :: rule
            integer(c_int64_t), value :: count_a, count_b
            type(c_ptr), intent(in) :: a(*), b(*)
            real(c_double), value :: tolerance
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_region_combine_with
        !> The parts into which curves in the domain of its surface divide a face.
        function nurbs_face_split(face, count, curves, tolerance, out) bind(c) result(r)
            import
            type(c_ptr), value :: face
            integer(c_int64_t), value :: count
            type(c_ptr), intent(in) :: curves(*)
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_face_split
        !> nurbs_face_split() with progress reports, cancellation and a limit of work.
        function nurbs_face_split_with(face, count, curves, tolerance, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: face
            integer(c_int64_t), value :: count
            type(c_ptr), intent(in) :: curves(*)
            real(c_double), value :: tolerance
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_face_split_with
        !> The parts of a face that lie on one side of a surface.
        function nurbs_face_trim(face, surface, side, tolerance, out) bind(c) result(r)
            import
            type(c_ptr), value :: face, surface
            integer(c_int32_t), value :: side
            real(c_double), value :: tolerance
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_face_trim
        !> nurbs_face_trim() with progress reports, cancellation and a limit of work.
        function nurbs_face_trim_with(face, surface, side, tolerance, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: face, surface
            integer(c_int32_t), value :: side
            real(c_double), value :: tolerance
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_face_trim_with
        ! --- Meshes
        !> A polyline that approximates a curve within a proven distance.
        function nurbs_mesh_curve(g, chord, angle, longest, cap, params, points, bound, reached, count) &
                bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: chord, angle, longest
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), points(*), bound
            integer(c_int32_t), intent(inout), optional :: reached
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_mesh_curve
        !> nurbs_mesh_curve() with progress reports, cancellation and a limit of work.
        function nurbs_mesh_curve_with(g, chord, angle, longest, cap, params, points, bound, reached, count, &
                call) bind(c) result(r)
            import
            type(c_ptr), value :: g
            real(c_double), value :: chord, angle, longest
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: params(*), points(*), bound
            integer(c_int32_t), intent(inout), optional :: reached
            integer(c_int64_t), intent(inout), optional :: count
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_mesh_curve_with
        !> Fills an options struct with the defaults.
        function nurbs_mesh_options_init(options, struct_size) bind(c) result(r)
            import
            type(nurbs_mesh_options), intent(inout) :: options
            integer(c_int64_t), value :: struct_size
            integer(c_int32_t) :: r
        end function nurbs_mesh_options_init
        !> A triangle mesh of a whole surface, within proven distances.
        function nurbs_mesh_surface(g, options, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(nurbs_mesh_options), intent(in), optional :: options
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_mesh_surface
        !> nurbs_mesh_surface() with progress reports, cancellation and a limit of work.
        function nurbs_mesh_surface_with(g, options, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(nurbs_mesh_options), intent(in), optional :: options
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_mesh_surface_with
        !> A triangle mesh of a trimmed face, within proven distances.
        function nurbs_mesh_face(face, options, out) bind(c) result(r)
            import
            type(c_ptr), value :: face
            type(nurbs_mesh_options), intent(in), optional :: options
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_mesh_face
        !> nurbs_mesh_face() with progress reports, cancellation and a limit of work.
        function nurbs_mesh_face_with(face, options, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: face
            type(nurbs_mesh_options), intent(in), optional :: options
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_mesh_face_with
        !> A triangle mesh of all faces of a model, within proven distances.
        function nurbs_mesh_model(model, options, out) bind(c) result(r)
            import
            type(c_ptr), value :: model
            type(nurbs_mesh_options), intent(in), optional :: options
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_mesh_model
        !> nurbs_mesh_model() with progress reports, cancellation and a limit of work.
        function nurbs_mesh_model_with(model, options, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: model
            type(nurbs_mesh_options), intent(in), optional :: options
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_mesh_model_with
        !> Meshes of a whole surface for several distances, as levels of detail for drawing.
        function nurbs_mesh_surface_levels(g, count, chords, options, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: count
            real(c_double), intent(in) :: chords(*)
            type(nurbs_mesh_options), intent(in), optional :: options
            type(c_ptr), intent(out) :: out(*)
            integer(c_int32_t) :: r
        end function nurbs_mesh_surface_levels
        !> nurbs_mesh_surface_levels() with progress reports, cancellation and a limit of work.
        function nurbs_mesh_surface_levels_with(g, count, chords, options, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: count
            real(c_double), intent(in) :: chords(*)
            type(nurbs_mesh_options), intent(in), optional :: options
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out(*)
            integer(c_int32_t) :: r
        end function nurbs_mesh_surface_levels_with
        !> Meshes of a trimmed face for several distances, as nurbs_mesh_surface_levels().
        function nurbs_mesh_face_levels(face, count, chords, options, out) bind(c) result(r)
            import
            type(c_ptr), value :: face
            integer(c_int64_t), value :: count
            real(c_double), intent(in) :: chords(*)
            type(nurbs_mesh_options), intent(in), optional :: options
            type(c_ptr), intent(out) :: out(*)
            integer(c_int32_t) :: r
        end function nurbs_mesh_face_levels
        !> nurbs_mesh_face_levels() with progress reports, cancellation and a limit of work.
        function nurbs_mesh_face_levels_with(face, count, chords, options, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: face
            integer(c_int64_t), value :: count
            real(c_double), intent(in) :: chords(*)
            type(nurbs_mesh_options), intent(in), optional :: options
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out(*)
            integer(c_int32_t) :: r
        end function nurbs_mesh_face_levels_with
        !> Meshes of all faces of a model for several distances, as nurbs_mesh_surface_levels().
        function nurbs_mesh_model_levels(model, count, chords, options, out) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: count
            real(c_double), intent(in) :: chords(*)
            type(nurbs_mesh_options), intent(in), optional :: options
            type(c_ptr), intent(out) :: out(*)
            integer(c_int32_t) :: r
        end function nurbs_mesh_model_levels
        !> nurbs_mesh_model_levels() with progress reports, cancellation and a limit of work.
        function nurbs_mesh_model_levels_with(model, count, chords, options, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: model
            integer(c_int64_t), value :: count
            real(c_double), intent(in) :: chords(*)
            type(nurbs_mesh_options), intent(in), optional :: options
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out(*)
            integer(c_int32_t) :: r
        end function nurbs_mesh_model_levels_with
        !> A mesh of hexahedra of a volume in space, on a grid of lines along its axes.
        function nurbs_mesh_volume(g, options, limit, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(nurbs_mesh_options), intent(in), optional :: options
            integer(c_int64_t), value :: limit
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_mesh_volume
        !> nurbs_mesh_volume() with progress reports, cancellation and a limit of work.
        function nurbs_mesh_volume_with(g, options, limit, call, out) bind(c) result(r)
            import
            type(c_ptr), value :: g
            type(nurbs_mesh_options), intent(in), optional :: options
            integer(c_int64_t), value :: limit
            type(nurbs_call_options), intent(in), optional :: call
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_mesh_volume_with
        !> Another handle on the same mesh, in constant time.
        function nurbs_mesh_clone(mesh, out) bind(c) result(r)
            import
            type(c_ptr), value :: mesh
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: r
        end function nurbs_mesh_clone
        !> Frees a handle on a mesh.
        subroutine nurbs_mesh_destroy(mesh) bind(c)
            import
            type(c_ptr), value :: mesh
        end subroutine nurbs_mesh_destroy
        !> The numbers of points, vertices, triangles, faces and edges of a mesh.
        function nurbs_mesh_counts(mesh, points, vertices, triangles, faces, edges, edge_points) bind(c) &
                result(r)
            import
            type(c_ptr), value :: mesh
            integer(c_int64_t), intent(inout), optional :: points, vertices, triangles, faces, edges, &
                edge_points
            integer(c_int32_t) :: r
        end function nurbs_mesh_counts
        !> How far a mesh and its shape are from each other: the largest distances of all faces.
        function nurbs_mesh_bound(mesh, from_shape, from_mesh, reached) bind(c) result(r)
            import
            type(c_ptr), value :: mesh
            real(c_double), intent(inout), optional :: from_shape, from_mesh
            integer(c_int32_t), intent(inout), optional :: reached
            integer(c_int32_t) :: r
        end function nurbs_mesh_bound
        !> The points of a mesh.
        function nurbs_mesh_points(mesh, cap, points, count) bind(c) result(r)
            import
            type(c_ptr), value :: mesh
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: points(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_mesh_points
        !> nurbs_mesh_points() in single precision.
        function nurbs_mesh_points_f32(mesh, cap, points, count) bind(c) result(r)
            import
            type(c_ptr), value :: mesh
            integer(c_int64_t), value :: cap
            real(c_float), intent(inout), optional :: points(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_mesh_points_f32
        !> The vertices of a mesh, face by face.
        function nurbs_mesh_vertices(mesh, cap, own_points, params, normals, count) bind(c) result(r)
            import
            type(c_ptr), value :: mesh
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: own_points(*), count
            real(c_double), intent(inout), optional :: params(*), normals(*)
            integer(c_int32_t) :: r
        end function nurbs_mesh_vertices
        !> The vertices of a mesh in single precision, with their points instead of indices, as for drawing.
        function nurbs_mesh_vertices_f32(mesh, cap, points, params, normals, count) bind(c) result(r)
            import
            type(c_ptr), value :: mesh
            integer(c_int64_t), value :: cap
            real(c_float), intent(inout), optional :: points(*), params(*), normals(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_mesh_vertices_f32
        !> The triangles of a mesh, face by face.
        function nurbs_mesh_triangles(mesh, flags, cap, corners, count) bind(c) result(r)
            import
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: flags
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: corners(*), count
            integer(c_int32_t) :: r
        end function nurbs_mesh_triangles
        !> nurbs_mesh_triangles() with indices of 32 bits.
        function nurbs_mesh_triangles_i32(mesh, flags, cap, corners, count) bind(c) result(r)
            import
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: flags
            integer(c_int64_t), value :: cap
            integer(c_int32_t), intent(inout), optional :: corners(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_mesh_triangles_i32
        !> The quads of a mesh: cells of the domain that are divided into exactly two triangles.
        function nurbs_mesh_quads(mesh, flags, cap, corners, own_triangles, count) bind(c) result(r)
            import
            type(c_ptr), value :: mesh
            integer(c_int32_t), value :: flags
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: corners(*), own_triangles(*), count
            integer(c_int32_t) :: r
        end function nurbs_mesh_quads
        !> Which vertices and triangles of a mesh belong to which face, and how near these are.
        function nurbs_mesh_faces(mesh, cap, first_vertices, vertex_counts, first_triangles, &
                triangle_counts, from_shape, from_mesh, reaches, count) bind(c) result(r)
            import
            type(c_ptr), value :: mesh
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: first_vertices(*), vertex_counts(*), &
                first_triangles(*), triangle_counts(*), count
            real(c_double), intent(inout), optional :: from_shape(*), from_mesh(*)
            integer(c_int32_t), intent(inout), optional :: reaches(*)
            integer(c_int32_t) :: r
        end function nurbs_mesh_faces
        !> The polylines that stand for edges in a mesh.
        function nurbs_mesh_edges(mesh, cap, own_edges, firsts, sizes, bounds, reaches, count) bind(c) &
                result(r)
            import
            type(c_ptr), value :: mesh
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: own_edges(*), firsts(*), sizes(*), count
            real(c_double), intent(inout), optional :: bounds(*)
            integer(c_int32_t), intent(inout), optional :: reaches(*)
            integer(c_int32_t) :: r
        end function nurbs_mesh_edges
        !> The vertices of the polylines for edges in a mesh, each from the start of its edge to the end.
        function nurbs_mesh_edge_points(mesh, cap, own_points, count) bind(c) result(r)
            import
            type(c_ptr), value :: mesh
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: own_points(*), count
            integer(c_int32_t) :: r
        end function nurbs_mesh_edge_points
        !> The hexahedra of a mesh of nurbs_mesh_volume(), last axis fastest.
        function nurbs_mesh_hexahedra(mesh, cap, corners, domains, folds, signs, count) bind(c) result(r)
            import
            type(c_ptr), value :: mesh
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: corners(*), count
            real(c_double), intent(inout), optional :: domains(*)
            integer(c_int32_t), intent(inout), optional :: folds(*), signs(*)
            integer(c_int32_t) :: r
        end function nurbs_mesh_hexahedra
        !> A spline as Bezier cells, exactly: its polynomial (rational) pieces, which share control points.
        function nurbs_bezier_cells(g, cap, own_points, kind, points, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: own_points(*), points, count
            integer(c_int32_t), intent(inout), optional :: kind
            integer(c_int32_t) :: r
        end function nurbs_bezier_cells
        !> The control points of nurbs_bezier_cells(), last axis fastest.
        function nurbs_bezier_cell_points(g, cap, points, weights, count) bind(c) result(r)
            import
            type(c_ptr), value :: g
            integer(c_int64_t), value :: cap
            real(c_double), intent(inout), optional :: points(*), weights(*)
            integer(c_int64_t), intent(inout), optional :: count
            integer(c_int32_t) :: r
        end function nurbs_bezier_cell_points
        ! --- Writing files
        !> Fills an options struct with the defaults.
        function nurbs_write_options_init(options, struct_size) bind(c) result(r)
            import
            type(nurbs_write_options), intent(inout) :: options
            integer(c_int64_t), value :: struct_size
            integer(c_int32_t) :: r
        end function nurbs_write_options_init
        !> The contents of a file that holds a model.
        function nurbs_model_write(model, format, options, cap, bytes, length) bind(c) result(r)
            import
            type(c_ptr), value :: model, bytes
            integer(c_int32_t), value :: format
            type(nurbs_write_options), intent(in), optional :: options
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: length
            integer(c_int32_t) :: r
        end function nurbs_model_write
        !> nurbs_model_write() with progress reports, cancellation and a limit of work.
        function nurbs_model_write_with(model, format, options, cap, bytes, length, call) bind(c) result(r)
            import
            type(c_ptr), value :: model, bytes
            integer(c_int32_t), value :: format
            type(nurbs_write_options), intent(in), optional :: options
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: length
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_model_write_with
        !> Writes a model to a file.
        function nurbs_model_write_file(model, path, format, options) bind(c) result(r)
            import
            type(c_ptr), value :: model
            character(kind=c_char), intent(in) :: path(*)
            integer(c_int32_t), value :: format
            type(nurbs_write_options), intent(in), optional :: options
            integer(c_int32_t) :: r
        end function nurbs_model_write_file
        !> nurbs_model_write_file() with progress reports, cancellation and a limit of work.
        function nurbs_model_write_file_with(model, path, format, options, call) bind(c) result(r)
            import
            type(c_ptr), value :: model
            character(kind=c_char), intent(in) :: path(*)
            integer(c_int32_t), value :: format
            type(nurbs_write_options), intent(in), optional :: options
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_model_write_file_with
        !> The contents of a file that holds the curves and surfaces of a list.
        function nurbs_list_write(list, format, options, cap, bytes, length) bind(c) result(r)
            import
            type(c_ptr), value :: list, bytes
            integer(c_int32_t), value :: format
            type(nurbs_write_options), intent(in), optional :: options
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: length
            integer(c_int32_t) :: r
        end function nurbs_list_write
        !> nurbs_list_write() with progress reports, cancellation and a limit of work.
        function nurbs_list_write_with(list, format, options, cap, bytes, length, call) bind(c) result(r)
            import
            type(c_ptr), value :: list, bytes
            integer(c_int32_t), value :: format
            type(nurbs_write_options), intent(in), optional :: options
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: length
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_list_write_with
        !> Writes the curves and surfaces of a list to a file, as nurbs_model_write_file() does.
        function nurbs_list_write_file(list, path, format, options) bind(c) result(r)
            import
            type(c_ptr), value :: list
            character(kind=c_char), intent(in) :: path(*)
            integer(c_int32_t), value :: format
            type(nurbs_write_options), intent(in), optional :: options
            integer(c_int32_t) :: r
        end function nurbs_list_write_file
        !> nurbs_list_write_file() with progress reports, cancellation and a limit of work.
        function nurbs_list_write_file_with(list, path, format, options, call) bind(c) result(r)
            import
            type(c_ptr), value :: list
            character(kind=c_char), intent(in) :: path(*)
            integer(c_int32_t), value :: format
            type(nurbs_write_options), intent(in), optional :: options
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_list_write_file_with
        !> The contents of a file that holds a mesh: its triangles, with what the model says about them.
        function nurbs_mesh_write(mesh, format, options, cap, bytes, length) bind(c) result(r)
            import
            type(c_ptr), value :: mesh, bytes
            integer(c_int32_t), value :: format
            type(nurbs_write_options), intent(in), optional :: options
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: length
            integer(c_int32_t) :: r
        end function nurbs_mesh_write
        !> nurbs_mesh_write() with progress reports, cancellation and a limit of work.
        function nurbs_mesh_write_with(mesh, format, options, cap, bytes, length, call) bind(c) result(r)
            import
            type(c_ptr), value :: mesh, bytes
            integer(c_int32_t), value :: format
            type(nurbs_write_options), intent(in), optional :: options
            integer(c_int64_t), value :: cap
            integer(c_int64_t), intent(inout), optional :: length
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_mesh_write_with
        !> Writes a mesh to a file, as nurbs_model_write_file() does.
        function nurbs_mesh_write_file(mesh, path, format, options) bind(c) result(r)
            import
            type(c_ptr), value :: mesh
            character(kind=c_char), intent(in) :: path(*)
            integer(c_int32_t), value :: format
            type(nurbs_write_options), intent(in), optional :: options
            integer(c_int32_t) :: r
        end function nurbs_mesh_write_file
        !> nurbs_mesh_write_file() with progress reports, cancellation and a limit of work.
        function nurbs_mesh_write_file_with(mesh, path, format, options, call) bind(c) result(r)
            import
            type(c_ptr), value :: mesh
            character(kind=c_char), intent(in) :: path(*)
            integer(c_int32_t), value :: format
            type(nurbs_write_options), intent(in), optional :: options
            type(nurbs_call_options), intent(in), optional :: call
            integer(c_int32_t) :: r
        end function nurbs_mesh_write_file_with
    end interface
end module nurbs_c
