! SPDX-License-Identifier: MIT
! How long a call lets its callback wait, and how soon it returns when it is cancelled: see cancel.hpp.
module cancel
    use, intrinsic :: iso_c_binding
    use nurbs
    implicit none
    private
    public :: measure, read_all

    abstract interface
        subroutine long_call(watching, code)
            import :: nurbs_call, c_int32_t
            type(nurbs_call), intent(in) :: watching
            integer(c_int32_t), intent(out) :: code
        end subroutine long_call
    end interface

    real(c_double) :: start, last, gap, stop_at, stopped

contains

    real(c_double) function now()
        integer(c_int64_t) :: count, rate
        call system_clock(count, rate)
        now = 1d3 * real(count, c_double) / real(rate, c_double)
    end function now

    logical function tell(done, user) result(stop)
        real(c_double), intent(in) :: done
        class(*), intent(inout), optional :: user
        real(c_double) :: time
        time = now()
        gap = max(gap, time - last)
        last = time
        if (time - start >= stop_at .and. stopped == 0 .and. done >= 0) stopped = time
        stop = stopped > 0 .or. present(user)
    end function tell

    subroutine measure(name, body)
        character(len=*), intent(in) :: name
        procedure(long_call) :: body
        type(nurbs_call) :: watching
        integer(c_int32_t) :: code
        real(c_double) :: whole, back, end
        integer :: i
        watching%progress => tell
        back = 0
        gap = 0
        whole = 0
        do i = 0, 5
            stop_at = merge(huge(0d0), whole * mod(0.6180339887498949d0 * i, 1d0) * 0.95d0, i == 0)
            stopped = 0
            start = now()
            last = start
            call body(watching, code)
            end = now()
            if (i == 0) whole = end - start
            gap = max(gap, end - last)
            if (stopped > 0) then
                back = max(back, end - stopped)
                if (code /= NURBS_ERROR_CANCELLED) print '(2a)', name, ' is not cancelled'
            end if
        end do
        print '(a, 3(1x, f0.1))', name, whole, gap, back
    end subroutine measure

    subroutine read_all(path, text)
        character(len=*), intent(in) :: path
        character(len=:), allocatable, intent(out) :: text
        integer :: unit, size
        open (newunit=unit, file=path, access='stream', status='old')
        inquire (unit=unit, size=size)
        allocate (character(len=size) :: text)
        read (unit) text
        close (unit)
    end subroutine read_all

end module cancel
