! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Splines closest to data, and statistics of data. Conventions: see the module nurbs.
module nurbs_fittings
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_statistics_create, nurbs_statistics_add, nurbs_statistics_merge, nurbs_statistics_size, &
        nurbs_statistics_from_bytes, nurbs_fit, nurbs_fit_points, nurbs_fit_errors, nurbs_fit_criteria, &
        nurbs_fit_tolerance, nurbs_cloud_start, nurbs_fit_cloud, nurbs_statistics_add_with, nurbs_fit_with, &
        nurbs_fit_points_with, nurbs_fit_errors_with, nurbs_fit_criteria_with, nurbs_fit_tolerance_with, &
        nurbs_fit_cloud_with, nurbs_data, nurbs_fit_options, nurbs_fit_report, nurbs_cloud_options, nurbs_cloud_report
    use nurbs_support
    use nurbs_calls
    use nurbs_handles
    use nurbs_splines
    implicit none
    private
    public :: fit_points, fit_tolerance, cloud_start, fit_cloud

    !> What fits need to know of data; an assignment makes another handle on the same sums.
    type, extends(nurbs_statistics_handle), public :: nurbs_statistics
    contains
        procedure :: create, add, merge, get_size, from_bytes, fit, fit_errors, fit_criteria
    end type nurbs_statistics

contains

    !> Statistics of no data, about cells between breaks and splines of at most the given degrees.
    subroutine create(this, degrees, break_counts, breaks, dim, value_scale, weight_scale, status)
        class(nurbs_statistics), intent(inout) :: this
        integer(c_int32_t), intent(in) :: degrees(:), break_counts(:), dim
        real(c_double), intent(in) :: breaks(:), value_scale
        real(c_double), intent(in), optional :: weight_scale
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: axes
        type(c_ptr) :: made
        axes = size(degrees, kind=c_int64_t)
        made = c_null_ptr
        code = fitting([fits(break_counts, axes)])
        if (code == NURBS_OK) code = nurbs_statistics_create(int(axes), degrees, int(break_counts, c_int64_t), breaks, &
            size(breaks, kind=c_int64_t), dim, value_scale, given(weight_scale, 1d0), made)
        call this%replace(made)
        call settle(code, status)
    end subroutine create

    !> Statistics with more data; the sums are exact.
    subroutine add(this, data, out, status, call)
        class(nurbs_statistics), intent(in) :: this
        type(nurbs_data), intent(in) :: data
        type(nurbs_statistics), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_statistics_add_with(this%handle, data, watched(call), made)
        else
            code = nurbs_statistics_add(this%handle, data, made)
        end if
        call out%replace(made)
        call settle(code, status)
    end subroutine add

    !> The sum of statistics, of some of them with the sign -1: the same bits for any order and partition of the data.
    subroutine merge(this, parts, signs, status)
        class(nurbs_statistics), intent(inout) :: this
        type(nurbs_statistics), intent(in) :: parts(:)
        integer(c_int32_t), intent(in), optional :: signs(:)
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: count
        type(c_ptr) :: made
        count = size(parts, kind=c_int64_t)
        made = c_null_ptr
        code = fitting([fits(signs, count)])
        if (code == NURBS_OK) code = nurbs_statistics_merge(count, handles_of(parts), signs, made)
        call this%replace(made)
        call settle(code, status)
    end subroutine merge

    !> How much data they hold.
    subroutine get_size(this, axes, dim, count, cells, weight, status)
        class(nurbs_statistics), intent(in) :: this
        integer(c_int32_t), intent(inout), optional :: axes, dim
        integer(c_int64_t), intent(inout), optional :: count, cells
        real(c_double), intent(inout), optional :: weight
        integer(c_int32_t), intent(out), optional :: status
        call settle(nurbs_statistics_size(this%handle, axes, dim, count, cells, weight), status)
    end subroutine get_size

    !> Statistics from what to_bytes() made of them.
    subroutine from_bytes(this, contents, status)
        class(nurbs_statistics), intent(inout) :: this
        character(kind=c_char, len=*), intent(in), target :: contents
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_statistics_from_bytes(c_loc(contents), len(contents, c_int64_t), made)
        call this%replace(made)
        call settle(code, status)
    end subroutine from_bytes

    !> The spline over full knot vectors, all axes one after the other, that is closest to the data.
    subroutine fit(this, degrees, counts, knots, out, options, report, flags, status, call)
        class(nurbs_statistics), intent(in) :: this
        integer(c_int32_t), intent(in) :: degrees(:), counts(:)
        real(c_double), intent(in) :: knots(:)
        type(nurbs_spline), intent(inout) :: out
        type(nurbs_fit_options), intent(in), optional :: options
        type(nurbs_fit_report), intent(inout), optional :: report
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: knot_count_c, axes
        type(c_ptr) :: made
        knot_count_c = size(knots, kind=c_int64_t)
        axes = statistics_axes_of(this%handle)
        made = c_null_ptr
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(degrees, axes), fits(counts, axes)])
        if (present(report)) report%struct_size = c_sizeof(report)
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_fit_with(this%handle, degrees, int(counts, c_int64_t), knots, knot_count_c, &
                    given(flags, 0), options, report, watched(call), made)
            else
                code = nurbs_fit(this%handle, degrees, int(counts, c_int64_t), knots, knot_count_c, given(flags, 0), &
                    options, report, made)
            end if
        end if
        call out%replace(made)
        call settle(code, status)
    end subroutine fit

    !> The spline over full knot vectors, all axes one after the other, that is closest to data.
    subroutine fit_points(data, degrees, counts, knots, out, options, report, flags, status, call)
        type(nurbs_data), intent(in) :: data
        integer(c_int32_t), intent(in) :: degrees(:), counts(:)
        real(c_double), intent(in) :: knots(:)
        type(nurbs_spline), intent(inout) :: out
        type(nurbs_fit_options), intent(in), optional :: options
        type(nurbs_fit_report), intent(inout), optional :: report
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: knot_count_c, axes
        type(c_ptr) :: made
        knot_count_c = size(knots, kind=c_int64_t)
        axes = int(data%axes, c_int64_t)
        made = c_null_ptr
        code = fitting([fits(degrees, axes), fits(counts, axes)])
        if (present(report)) report%struct_size = c_sizeof(report)
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_fit_points_with(data, degrees, int(counts, c_int64_t), knots, knot_count_c, &
                    given(flags, 0), options, report, watched(call), made)
            else
                code = nurbs_fit_points(data, degrees, int(counts, c_int64_t), knots, knot_count_c, given(flags, 0), &
                    options, report, made)
            end if
        end if
        call out%replace(made)
        call settle(code, status)
    end subroutine fit_points

    !> Pointwise standard errors of a fit over the knots of g.
    subroutine fit_errors(this, g, penalty_order, lambda, sigma, params, errors, flags, status, call)
        class(nurbs_statistics), intent(in) :: this
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: penalty_order
        real(c_double), intent(in) :: lambda, sigma, params(:, :)
        real(c_double), intent(inout) :: errors(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(params, 1, c_int64_t)
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(params, n, statistics_axes_of(this%handle)), fits(errors, n)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_fit_errors_with(this%handle, g%handle, penalty_order, lambda, sigma, n, params, &
                    step(params), column(params), given(flags, 0), errors, watched(call))
            else
                code = nurbs_fit_errors(this%handle, g%handle, penalty_order, lambda, sigma, n, params, step(params), &
                    column(params), given(flags, 0), errors)
            end if
        end if
        call settle(code, status)
    end subroutine fit_errors

    !> Squares, freedom, GCV and REML, four numbers for each factor of the penalty.
    subroutine fit_criteria(this, g, penalty_order, lambdas, values, status, call)
        class(nurbs_statistics), intent(in) :: this
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: penalty_order
        real(c_double), intent(in) :: lambdas(:)
        real(c_double), intent(inout) :: values(:, :)
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        real(c_double), allocatable :: values_c(:, :)
        n = size(lambdas, kind=c_int64_t)
        allocate (values_c(4, n))
        code = held(this%handle)
        if (code == NURBS_OK) code = fitting([fits(values, n, 4_c_int64_t)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_fit_criteria_with(this%handle, g%handle, penalty_order, n, lambdas, values_c, &
                    watched(call))
            else
                code = nurbs_fit_criteria(this%handle, g%handle, penalty_order, n, lambdas, values_c)
            end if
        end if
        if (code == NURBS_OK) values = transpose(values_c)
        call settle(code, status)
    end subroutine fit_criteria

    !> A spline with few control points that no datum is farther from than the tolerance.
    subroutine fit_tolerance(data, degrees, tolerance, out, domain, max_count, options, report, flags, status, call)
        type(nurbs_data), intent(in) :: data
        integer(c_int32_t), intent(in) :: degrees(:)
        real(c_double), intent(in) :: tolerance
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in), optional :: domain(:, :)
        integer(c_int32_t), intent(in), optional :: max_count, flags
        type(nurbs_fit_options), intent(in), optional :: options
        type(nurbs_fit_report), intent(inout), optional :: report
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: axes
        real(c_double), allocatable :: domain_c(:, :)
        type(c_ptr) :: made
        axes = int(data%axes, c_int64_t)
        made = c_null_ptr
        code = fitting([fits(degrees, axes), fits(domain, axes, 2_c_int64_t)])
        if (present(domain)) domain_c = transpose(domain)
        if (present(report)) report%struct_size = c_sizeof(report)
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_fit_tolerance_with(data, degrees, domain_c, tolerance, &
                    int(given(max_count, 0), c_int64_t), given(flags, 0), options, report, watched(call), made)
            else
                code = nurbs_fit_tolerance(data, degrees, domain_c, tolerance, int(given(max_count, 0), c_int64_t), &
                    given(flags, 0), options, report, made)
            end if
        end if
        call out%replace(made)
        call settle(code, status)
    end subroutine fit_tolerance

    !> A spline over full knot vectors, all axes one after the other, along the principal directions of points.
    subroutine cloud_start(degrees, counts, knots, points, out, flags, status)
        integer(c_int32_t), intent(in) :: degrees(:), counts(:)
        real(c_double), intent(in) :: knots(:), points(:, :)
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: axes
        type(c_ptr) :: made
        axes = size(degrees, kind=c_int64_t)
        made = c_null_ptr
        code = fitting([fits(counts, axes)])
        if (code == NURBS_OK) code = nurbs_cloud_start(int(axes), degrees, int(counts, c_int64_t), knots, &
            size(knots, kind=c_int64_t), size(points, 1, c_int64_t), size(points, 2), points, step(points), &
            column(points), given(flags, 0), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine cloud_start

    !> The spline over the same knots that is closest to points without parameters, found from this one.
    subroutine fit_cloud(g, points, out, weights, options, report, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: points(:, :)
        type(nurbs_spline), intent(inout) :: out
        real(c_double), intent(in), optional :: weights(:)
        type(nurbs_cloud_options), intent(in), optional :: options
        type(nurbs_cloud_report), intent(inout), optional :: report
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        type(c_ptr) :: made
        n = size(points, 1, c_int64_t)
        made = c_null_ptr
        code = fitting([fits(points, n, dim_of(g%handle)), fits(weights, n)])
        if (present(report)) report%struct_size = c_sizeof(report)
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_fit_cloud_with(g%handle, n, points, step(points), column(points), weights, 0_c_int64_t, &
                    options, report, watched(call), made)
            else
                code = nurbs_fit_cloud(g%handle, n, points, step(points), column(points), weights, 0_c_int64_t, &
                    options, report, made)
            end if
        end if
        call out%replace(made)
        call settle(code, status)
    end subroutine fit_cloud
end module nurbs_fittings
