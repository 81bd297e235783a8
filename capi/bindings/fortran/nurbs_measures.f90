! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Lengths, areas and moments. range is a part of the domain; tolerances are relative, 0 if absent, and error receives
!> an estimate of the absolute error. Conventions: see the module nurbs.
module nurbs_measures
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_curve_length, nurbs_curve_lengths, nurbs_curve_params_at_lengths, nurbs_curve_divide, &
        nurbs_surface_area, nurbs_moments, nurbs_enclosed_area, nurbs_enclosed_volume, nurbs_quadrature, &
        nurbs_curve_length_with, nurbs_curve_lengths_with, nurbs_curve_params_at_lengths_with, &
        nurbs_curve_divide_with, nurbs_surface_area_with, nurbs_moments_with, nurbs_enclosed_area_with, &
        nurbs_enclosed_volume_with
    use nurbs_support
    use nurbs_calls
    use nurbs_handles
    use nurbs_splines
    implicit none
    private
    public :: curve_length, curve_lengths, params_at_lengths, divide_curve, surface_area, spline_moments, enclosed_area
    public :: enclosed_volume, quadrature

contains

    !> Length of a curve over a range [2] of its domain, or all of it.
    subroutine curve_length(g, length, error, range, tolerance, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(inout) :: length
        real(c_double), intent(inout), optional :: error
        real(c_double), intent(in), optional :: range(2), tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        if (present(call)) then
            code = nurbs_curve_length_with(g%handle, range, given(tolerance, 0d0), length, error, watched(call))
        else
            code = nurbs_curve_length(g%handle, range, given(tolerance, 0d0), length, error)
        end if
        call settle(code, status)
    end subroutine curve_length

    !> lengths(n) from the start of the domain to params(n).
    subroutine curve_lengths(g, params, lengths, tolerance, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: params(:)
        real(c_double), intent(inout) :: lengths(:)
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(params, kind=c_int64_t)
        code = fitting([fits(lengths, n)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_curve_lengths_with(g%handle, n, params, 0_c_int64_t, given(tolerance, 0d0), lengths, &
                    0_c_int64_t, watched(call))
            else
                code = nurbs_curve_lengths(g%handle, n, params, 0_c_int64_t, given(tolerance, 0d0), lengths, &
                    0_c_int64_t)
            end if
        end if
        call settle(code, status)
    end subroutine curve_lengths

    !> params(n) at lengths(n) from the start of the domain; flags: 0 or NURBS_CLAMP.
    subroutine params_at_lengths(g, lengths, params, tolerance, flags, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: lengths(:)
        real(c_double), intent(inout) :: params(:)
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        n = size(lengths, kind=c_int64_t)
        code = fitting([fits(params, n)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_curve_params_at_lengths_with(g%handle, n, lengths, 0_c_int64_t, given(tolerance, 0d0), &
                    params, 0_c_int64_t, given(flags, 0), watched(call))
            else
                code = nurbs_curve_params_at_lengths(g%handle, n, lengths, 0_c_int64_t, given(tolerance, 0d0), params, &
                    0_c_int64_t, given(flags, 0))
            end if
        end if
        call settle(code, status)
    end subroutine params_at_lengths

    !> params(parts + 1) of parts of equal length, or with NURBS_EQUAL_CHORDS of points at equal distances; size: length
    !> or chord of a part.
    subroutine divide_curve(g, parts, params, size, range, tolerance, flags, status, call)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: parts
        real(c_double), allocatable, intent(inout) :: params(:)
        real(c_double), intent(inout), optional :: size
        real(c_double), intent(in), optional :: range(2), tolerance
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        if (allocated(params)) deallocate (params)
        allocate (params(max(int(parts, c_int64_t), 0_c_int64_t) + 1))
        if (present(call)) then
            code = nurbs_curve_divide_with(g%handle, range, int(parts, c_int64_t), given(tolerance, 0d0), &
                given(flags, 0), params, size, watched(call))
        else
            code = nurbs_curve_divide(g%handle, range, int(parts, c_int64_t), given(tolerance, 0d0), given(flags, 0), &
                params, size)
        end if
        call settle(code, status)
    end subroutine divide_curve

    !> range(:, k) is a part of domain(k).
    subroutine surface_area(g, area, error, range, tolerance, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(inout) :: area
        real(c_double), intent(inout), optional :: error
        real(c_double), intent(in), optional :: range(2, 2), tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        if (present(call)) then
            code = nurbs_surface_area_with(g%handle, range, given(tolerance, 0d0), area, error, watched(call))
        else
            code = nurbs_surface_area(g%handle, range, given(tolerance, 0d0), area, error)
        end if
        call settle(code, status)
    end subroutine surface_area

    !> Length, area or volume, centroid(dim) and inertia(dim, dim) about it, of a spline itself.
    subroutine spline_moments(g, content, centroid, inertia, error, tolerance, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(inout) :: content
        real(c_double), intent(inout), optional :: centroid(:), inertia(:, :), error
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: dim
        dim = dim_of(g%handle)
        code = fitting([fits(centroid, dim), fits(inertia, dim, dim)])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_moments_with(g%handle, given(tolerance, 0d0), content, centroid, inertia, error, &
                    watched(call))
            else
                code = nurbs_moments(g%handle, given(tolerance, 0d0), content, centroid, inertia, error)
            end if
        end if
        call settle(code, status)
    end subroutine spline_moments

    !> Of the region of the plane that closed chains of curves enclose; counterclockwise counts positive. gap: the
    !> largest one allowed.
    subroutine enclosed_area(curves, area, centroid, inertia, error, gap, tolerance, status, call)
        type(nurbs_spline), intent(in) :: curves(:)
        real(c_double), intent(inout) :: area
        real(c_double), intent(inout), optional :: centroid(2), inertia(2, 2), error
        real(c_double), intent(in), optional :: gap, tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: count
        count = size(curves, kind=c_int64_t)
        if (present(call)) then
            code = nurbs_enclosed_area_with(count, handles_of(curves), given(gap, 0d0), given(tolerance, 0d0), area, &
                centroid, inertia, error, watched(call))
        else
            code = nurbs_enclosed_area(count, handles_of(curves), given(gap, 0d0), given(tolerance, 0d0), area, &
                centroid, inertia, error)
        end if
        call settle(code, status)
    end subroutine enclosed_area

    !> Of the body that surfaces enclose whose normals point outwards; openness: the length of the vector area, 0 of a
    !> closed shell.
    subroutine enclosed_volume(surfaces, volume, centroid, inertia, openness, error, tolerance, status, call)
        type(nurbs_spline), intent(in) :: surfaces(:)
        real(c_double), intent(inout) :: volume
        real(c_double), intent(inout), optional :: centroid(3), inertia(3, 3), openness, error
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        integer(c_int64_t) :: count
        count = size(surfaces, kind=c_int64_t)
        if (present(call)) then
            code = nurbs_enclosed_volume_with(count, handles_of(surfaces), given(tolerance, 0d0), volume, centroid, &
                inertia, openness, error, watched(call))
        else
            code = nurbs_enclosed_volume(count, handles_of(surfaces), given(tolerance, 0d0), volume, centroid, &
                inertia, openness, error)
        end if
        call settle(code, status)
    end subroutine enclosed_volume

    !> params(n, axes), weights(n) of the parameters and measures(n) of the shape, span by span, for integrals of any
    !> function; nodes along each axis of a span, 0 for one more than the degree.
    subroutine quadrature(g, params, weights, measures, nodes, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), allocatable, intent(inout) :: params(:, :), weights(:), measures(:)
        integer(c_int32_t), intent(in), optional :: nodes
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        integer(c_int64_t) :: n
        real(c_double), allocatable :: params_c(:, :)
        n = 0
        code = nurbs_quadrature(g%handle, given(nodes, 0), 0_c_int64_t, count=n)
        if (allocated(weights)) deallocate (weights)
        if (allocated(measures)) deallocate (measures)
        allocate (params_c(axes_of(g%handle), n), weights(n), measures(n))
        if (code == NURBS_OK) code = nurbs_quadrature(g%handle, given(nodes, 0), n, params_c, weights, measures)
        params = transpose(params_c)
        call settle(code, status)
    end subroutine quadrature
end module nurbs_measures
