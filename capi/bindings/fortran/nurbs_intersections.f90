! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Where shapes meet; every answer says whether it is complete. Conventions: see the module nurbs.
module nurbs_intersections
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_roots, nurbs_curve_level, nurbs_roots_with, nurbs_curve_level_with
    use nurbs_support
    use nurbs_calls
    use nurbs_splines
    implicit none
    private
    public :: roots, curve_level

contains

    !> params(n) in rising order where a scalar curve has a value, kinds(n) one NURBS_HIT_ constant each, and ranges(2,
    !> n) outside of which there is no root.
    subroutine roots(g, params, kinds, ranges, complete, value, tolerance, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), allocatable, intent(inout) :: params(:), ranges(:, :)
        integer(c_int32_t), allocatable, intent(inout) :: kinds(:)
        logical, intent(inout), optional :: complete
        real(c_double), intent(in), optional :: value, tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code, answer
        integer(c_int64_t) :: n
        real(c_double), allocatable :: ranges_c(:, :)
        n = 0
        answer = 0
        if (present(call)) then
            code = nurbs_roots_with(g%handle, given(value, 0d0), given(tolerance, 0d0), 0_c_int64_t, count=n, &
                call=watched(call))
        else
            code = nurbs_roots(g%handle, given(value, 0d0), given(tolerance, 0d0), 0_c_int64_t, count=n)
        end if
        if (allocated(params)) deallocate (params)
        if (allocated(kinds)) deallocate (kinds)
        allocate (params(n), kinds(n), ranges_c(2, n))
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_roots_with(g%handle, given(value, 0d0), given(tolerance, 0d0), n, params, kinds, &
                    ranges_c, complete=answer, call=watched(call))
            else
                code = nurbs_roots(g%handle, given(value, 0d0), given(tolerance, 0d0), n, params, kinds, ranges_c, &
                    complete=answer)
            end if
        end if
        ranges = transpose(ranges_c)
        if (present(complete)) complete = answer /= 0
        call settle(code, status)
    end subroutine roots

    !> Where a curve meets a line, a plane, a conic, a quadric or another set on which a polynomial of a degree is 0;
    !> its coefficients are those of products x_i x_j ... with i <= j <= ..., in lexicographic order, where x_dim stands
    !> for 1.
    subroutine curve_level(g, degree, coefficients, params, kinds, ranges, complete, tolerance, status, call)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: degree
        real(c_double), intent(in) :: coefficients(:)
        real(c_double), allocatable, intent(inout) :: params(:), ranges(:, :)
        integer(c_int32_t), allocatable, intent(inout) :: kinds(:)
        logical, intent(inout), optional :: complete
        real(c_double), intent(in), optional :: tolerance
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code, answer
        integer(c_int64_t) :: n
        real(c_double), allocatable :: ranges_c(:, :)
        n = 0
        answer = 0
        code = fitting([fits(coefficients, monomials(dim_of(g%handle), degree))])
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_curve_level_with(g%handle, degree, coefficients, given(tolerance, 0d0), 0_c_int64_t, &
                    count=n, call=watched(call))
            else
                code = nurbs_curve_level(g%handle, degree, coefficients, given(tolerance, 0d0), 0_c_int64_t, count=n)
            end if
        end if
        if (allocated(params)) deallocate (params)
        if (allocated(kinds)) deallocate (kinds)
        allocate (params(n), kinds(n), ranges_c(2, n))
        if (code == NURBS_OK) then
            if (present(call)) then
                code = nurbs_curve_level_with(g%handle, degree, coefficients, given(tolerance, 0d0), n, params, kinds, &
                    ranges_c, complete=answer, call=watched(call))
            else
                code = nurbs_curve_level(g%handle, degree, coefficients, given(tolerance, 0d0), n, params, kinds, &
                    ranges_c, complete=answer)
            end if
        end if
        ranges = transpose(ranges_c)
        if (present(complete)) complete = answer /= 0
        call settle(code, status)
    end subroutine curve_level
end module nurbs_intersections
