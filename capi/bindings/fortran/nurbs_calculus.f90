! SPDX-License-Identifier: MIT
! Generated from include/nurbs/nurbs.h and capi/bindings/table by: python3 cmake/interface/generate.py . - do not edit.
!> Derivatives, integrals, sums, products and compositions of splines, and changes of their weights. Conventions: see
!> the module nurbs.
module nurbs_calculus
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_blossom, nurbs_derivative, nurbs_eval_knot_derivative, nurbs_antiderivative, &
        nurbs_product, nurbs_compose, nurbs_sum, nurbs_normalize_weights, nurbs_reparametrize_moebius, &
        nurbs_equalize_end_weights, nurbs_product_with, nurbs_compose_with
    use nurbs_support
    use nurbs_calls
    use nurbs_splines
    implicit none
    private
    public :: spline_blossom, spline_derivative, spline_knot_derivative, spline_antiderivative, spline_product
    public :: spline_compose, spline_sum, normalize_weights, reparametrize_moebius, equalize_end_weights

contains

    !> The polar form of the piece at params(axes) at arguments args(sum of the degrees), in values(dim), or values(dim
    !> + 1) if g is rational.
    subroutine spline_blossom(g, params, args, values, flags, status)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in) :: params(:), args(:)
        real(c_double), intent(inout) :: values(:)
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        code = held(g%handle)
        if (code == NURBS_OK) code = fitting([fits(params, axes_of(g%handle)), &
            fits(values, dim_of(g%handle) + rational_of(g%handle))])
        if (code == NURBS_OK) code = nurbs_blossom(g%handle, params, size(args, kind=c_int64_t), args, values, &
            given(flags, 0))
        call settle(code, status)
    end subroutine spline_blossom

    !> The partial derivative along an axis.
    subroutine spline_derivative(g, axis, order, out, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: axis, order
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_derivative(g%handle, axis - 1, order, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine spline_derivative

    !> The derivative with respect to a knot of the full vector of an axis, as a spline.
    subroutine spline_knot_derivative(g, axis, knot, out, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: axis, knot
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_eval_knot_derivative(g%handle, axis - 1, int(knot, c_int64_t), made)
        call out%replace(made)
        call settle(code, status)
    end subroutine spline_knot_derivative

    !> The integral along an axis from the start of its domain.
    subroutine spline_antiderivative(g, axis, out, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: axis
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_antiderivative(g%handle, axis - 1, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine spline_antiderivative

    !> a(t) b(t); flags 0, NURBS_PRODUCT_DOT or NURBS_PRODUCT_CROSS.
    subroutine spline_product(a, b, out, flags, status, call)
        class(nurbs_spline), intent(in) :: a, b
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(in), optional :: flags
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_product_with(a%handle, b%handle, given(flags, 0), watched(call), made)
        else
            code = nurbs_product(a%handle, b%handle, given(flags, 0), made)
        end if
        call out%replace(made)
        call settle(code, status)
    end subroutine spline_product

    !> g(f(t)) for a curve f in the parameter space of g.
    subroutine spline_compose(g, f, out, status, call)
        class(nurbs_spline), intent(in) :: g, f
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        if (present(call)) then
            code = nurbs_compose_with(g%handle, f%handle, watched(call), made)
        else
            code = nurbs_compose(g%handle, f%handle, made)
        end if
        call out%replace(made)
        call settle(code, status)
    end subroutine spline_compose

    !> alpha a(t) + beta b(t).
    subroutine spline_sum(a, alpha, b, beta, out, status)
        class(nurbs_spline), intent(in) :: a, b
        real(c_double), intent(in) :: alpha, beta
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_sum(a%handle, alpha, b%handle, beta, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine spline_sum

    !> The largest weight 1; equal weights dropped.
    subroutine normalize_weights(g, out, status)
        class(nurbs_spline), intent(in) :: g
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_normalize_weights(g%handle, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine normalize_weights

    !> The same shape with the ratio of the end weights multiplied.
    subroutine reparametrize_moebius(g, axis, ratio, out, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: axis
        real(c_double), intent(in) :: ratio
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_reparametrize_moebius(g%handle, axis - 1, ratio, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine reparametrize_moebius

    !> The same shape with equal weights at the ends of an axis.
    subroutine equalize_end_weights(g, axis, out, status)
        class(nurbs_spline), intent(in) :: g
        integer(c_int32_t), intent(in) :: axis
        type(nurbs_spline), intent(inout) :: out
        integer(c_int32_t), intent(out), optional :: status
        integer(c_int32_t) :: code
        type(c_ptr) :: made
        code = nurbs_equalize_end_weights(g%handle, axis - 1, made)
        call out%replace(made)
        call settle(code, status)
    end subroutine equalize_end_weights
end module nurbs_calculus
