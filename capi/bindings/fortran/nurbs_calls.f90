! SPDX-License-Identifier: MIT
!> Calls that can be watched, limited and ended: the last argument of the procedures that can take long.
module nurbs_calls
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c
    implicit none
    private
    public :: nurbs_progress, watched
    public :: closest_points_watched, farthest_points_watched, closest_local_watched
    public :: curve_signed_distances_watched, constrain_watched

    abstract interface
        !> Told how much of a call is done, an estimate from 0 to 1. Whether the call is to stop, which then fails with
        !> NURBS_ERROR_CANCELLED and changes nothing. It is called at most every 10 ms, and may call anything. `user` is
        !> that of the nurbs_call, if it has one; `select type` tells what it is.
        logical function nurbs_progress(done, user) result(stop)
            import :: c_double
            real(c_double), intent(in) :: done
            class(*), intent(inout), optional :: user
        end function nurbs_progress
    end interface

    !> What a caller wants of a long call. At the limit searches answer with what is proven so far; other calls fail with
    !> NURBS_ERROR_WORK.
    type, public :: nurbs_call
        integer(c_int64_t) :: work = 0 ! most multiply-adds; 0 sets no limit
        procedure(nurbs_progress), pointer, nopass :: progress => null()
        class(*), pointer :: user => null() ! for progress; set by call%user => data, as gfortran 12 cannot construct it
    end type nurbs_call

contains

    !> The same as the library takes it.
    type(nurbs_call_options) function watched(call) result(options)
        type(nurbs_call), intent(in), target :: call
        integer(c_int32_t) :: code
        code = nurbs_call_options_init(options, int(c_sizeof(options), c_int64_t))
        if (code == NURBS_OK) options%work = call%work
        if (associated(call%progress)) options%progress = c_funloc(tell)
        options%user = c_loc(call)
    end function watched

    recursive integer(c_int32_t) function tell(done, user) bind(c, name='')
        real(c_double), intent(in), value :: done
        type(c_ptr), intent(in), value :: user
        type(nurbs_call), pointer :: watching
        call c_f_pointer(user, watching)
        if (associated(watching%user)) then
            tell = merge(1, 0, watching%progress(done, watching%user))
        else
            tell = merge(1, 0, watching%progress(done))
        end if
    end function tell

    ! The long calls that take structs, with the arguments of their plain forms.

    integer(c_int32_t) function closest_points_watched(g, n, points, point_stride, point_component_stride, range, &
            tolerance, budget, params, param_stride, param_component_stride, feet, foot_stride, foot_component_stride, &
            distances, distance_stride, status, flags, call) result(code)
        type(c_ptr), intent(in), value :: g
        integer(c_int64_t), intent(in), value :: n, point_stride, point_component_stride, budget
        integer(c_int64_t), intent(in), value :: param_stride, param_component_stride, foot_stride
        integer(c_int64_t), intent(in), value :: foot_component_stride, distance_stride
        real(c_double), intent(in), target :: points(*)
        real(c_double), intent(in), optional, target :: range(*)
        real(c_double), intent(in), value :: tolerance
        real(c_double), intent(inout), optional, target :: params(*), feet(*), distances(*)
        integer(c_int32_t), intent(inout), optional, target :: status(*)
        integer(c_int32_t), intent(in), value :: flags
        type(nurbs_call_options), intent(in) :: call
        type(nurbs_closest_query) :: query
        query = closest_query(n, points, point_stride, point_component_stride, flags)
        query%range = place(range)
        query%tolerance = tolerance
        query%budget = budget
        code = nurbs_closest_points_with(g, query, closest_answer(params, param_stride, param_component_stride, feet, &
            foot_stride, foot_component_stride, distances, distance_stride, status), call)
    end function closest_points_watched

    integer(c_int32_t) function farthest_points_watched(g, n, points, point_stride, point_component_stride, range, &
            tolerance, budget, params, param_stride, param_component_stride, feet, foot_stride, foot_component_stride, &
            distances, distance_stride, status, flags, call) result(code)
        type(c_ptr), intent(in), value :: g
        integer(c_int64_t), intent(in), value :: n, point_stride, point_component_stride, budget
        integer(c_int64_t), intent(in), value :: param_stride, param_component_stride, foot_stride
        integer(c_int64_t), intent(in), value :: foot_component_stride, distance_stride
        real(c_double), intent(in), target :: points(*)
        real(c_double), intent(in), optional, target :: range(*)
        real(c_double), intent(in), value :: tolerance
        real(c_double), intent(inout), optional, target :: params(*), feet(*), distances(*)
        integer(c_int32_t), intent(inout), optional, target :: status(*)
        integer(c_int32_t), intent(in), value :: flags
        type(nurbs_call_options), intent(in) :: call
        type(nurbs_closest_query) :: query
        query = closest_query(n, points, point_stride, point_component_stride, flags)
        query%range = place(range)
        query%tolerance = tolerance
        query%budget = budget
        code = nurbs_farthest_points_with(g, query, closest_answer(params, param_stride, param_component_stride, feet, &
            foot_stride, foot_component_stride, distances, distance_stride, status), call)
    end function farthest_points_watched

    integer(c_int32_t) function closest_local_watched(g, n, points, point_stride, point_component_stride, guesses, &
            guess_stride, guess_component_stride, params, param_stride, param_component_stride, feet, foot_stride, &
            foot_component_stride, distances, distance_stride, status, flags, call) result(code)
        type(c_ptr), intent(in), value :: g
        integer(c_int64_t), intent(in), value :: n, point_stride, point_component_stride, guess_stride
        integer(c_int64_t), intent(in), value :: guess_component_stride, param_stride, param_component_stride
        integer(c_int64_t), intent(in), value :: foot_stride, foot_component_stride, distance_stride
        real(c_double), intent(in), target :: points(*), guesses(*)
        real(c_double), intent(inout), optional, target :: params(*), feet(*), distances(*)
        integer(c_int32_t), intent(inout), optional, target :: status(*)
        integer(c_int32_t), intent(in), value :: flags
        type(nurbs_call_options), intent(in) :: call
        type(nurbs_closest_query) :: query
        query = closest_query(n, points, point_stride, point_component_stride, flags)
        query%guesses = place(guesses)
        query%guess_stride = guess_stride
        query%guess_component_stride = guess_component_stride
        code = nurbs_closest_local_with(g, query, closest_answer(params, param_stride, param_component_stride, feet, &
            foot_stride, foot_component_stride, distances, distance_stride, status), call)
    end function closest_local_watched

    integer(c_int32_t) function curve_signed_distances_watched(g, n, points, point_stride, point_component_stride, &
            tolerance, budget, distances, distance_stride, params, param_stride, status, flags, call) result(code)
        type(c_ptr), intent(in), value :: g
        integer(c_int64_t), intent(in), value :: n, point_stride, point_component_stride, budget
        integer(c_int64_t), intent(in), value :: distance_stride, param_stride
        real(c_double), intent(in), target :: points(*)
        real(c_double), intent(in), value :: tolerance
        real(c_double), intent(inout), target :: distances(*)
        real(c_double), intent(inout), optional, target :: params(*)
        integer(c_int32_t), intent(inout), optional, target :: status(*)
        integer(c_int32_t), intent(in), value :: flags
        type(nurbs_call_options), intent(in) :: call
        type(nurbs_closest_query) :: query
        query = closest_query(n, points, point_stride, point_component_stride, flags)
        query%tolerance = tolerance
        query%budget = budget
        code = nurbs_curve_signed_distances_with(g, query, closest_answer(params, param_stride, 0_c_int64_t, &
            distances=distances, distance_stride=distance_stride, status=status), call)
    end function curve_signed_distances_watched

    integer(c_int32_t) function constrain_watched(g, count, kinds, orders, params, targets, keep, costs, weight_costs, &
            tolerance, residuals, rank, moved, optimality, call, out) result(code)
        type(c_ptr), intent(in), value :: g
        integer(c_int64_t), intent(in), value :: count
        integer(c_int32_t), intent(in), optional, target :: kinds(*), orders(*), keep(*)
        real(c_double), intent(in), target :: params(*), targets(*)
        real(c_double), intent(in), optional, target :: costs(*), weight_costs(*)
        real(c_double), intent(in), value :: tolerance
        real(c_double), intent(inout), optional, target :: residuals(*)
        integer(c_int64_t), intent(inout), optional :: rank
        real(c_double), intent(inout), optional :: moved, optimality
        type(nurbs_call_options), intent(in) :: call
        type(c_ptr), intent(out) :: out
        type(nurbs_constraints) :: constraints
        type(nurbs_constraint_report) :: report
        constraints = nurbs_constraints(c_sizeof(constraints), count, place(kinds), place(orders), place(params), &
            place(targets), place(keep), place(costs), place(weight_costs), tolerance)
        report = nurbs_constraint_report(c_sizeof(report), place(residuals), 0, 0d0, 0d0)
        code = nurbs_constrain_with(g, constraints, report, call, out)
        if (code /= NURBS_OK) return
        if (present(rank)) rank = report%rank
        if (present(moved)) moved = report%moved
        if (present(optimality)) optimality = report%optimality
    end function constrain_watched

    ! The structs

    type(nurbs_closest_query) function closest_query(n, points, stride, component_stride, flags) result(query)
        integer(c_int64_t), intent(in) :: n, stride, component_stride
        real(c_double), intent(in), target :: points(*)
        integer(c_int32_t), intent(in) :: flags
        integer(c_int64_t), parameter :: none = 0
        query = nurbs_closest_query(c_sizeof(query), n, place(points), stride, component_stride, c_null_ptr, none, none, &
            c_null_ptr, 0d0, none, flags, 0)
    end function closest_query

    type(nurbs_closest_answer) function closest_answer(params, param_stride, param_component_stride, feet, &
            foot_stride, foot_component_stride, distances, distance_stride, status) result(answer)
        real(c_double), intent(inout), optional, target :: params(*), feet(*), distances(*)
        integer(c_int64_t), intent(in) :: param_stride, param_component_stride
        integer(c_int64_t), intent(in), optional :: foot_stride, foot_component_stride
        integer(c_int64_t), intent(in) :: distance_stride
        integer(c_int32_t), intent(inout), optional, target :: status(*)
        answer%struct_size = c_sizeof(answer)
        answer%params = place(params)
        answer%param_stride = param_stride
        answer%param_component_stride = param_component_stride
        answer%feet = place(feet)
        answer%foot_stride = 0
        if (present(foot_stride)) answer%foot_stride = foot_stride
        answer%foot_component_stride = 0
        if (present(foot_component_stride)) answer%foot_component_stride = foot_component_stride
        answer%distances = place(distances)
        answer%distance_stride = distance_stride
        answer%status = place(status)
    end function closest_answer

    !> Where an array is, or null.
    type(c_ptr) function place(array)
        type(*), optional, target :: array(*)
        place = c_null_ptr
        if (present(array)) place = c_loc(array)
    end function place
end module nurbs_calls
