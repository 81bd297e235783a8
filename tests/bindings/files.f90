! SPDX-License-Identifier: MIT
! Files in Fortran: parts.igs, the path of which is the argument, read by name and from memory.
program files
    use, intrinsic :: iso_c_binding
    use nurbs
    use expectations
    implicit none
    character(len=:), allocatable :: path
    integer :: length

    call get_command_argument(1, length=length)
    allocate (character(len=length) :: path)
    call get_command_argument(1, path)
    call expect(nurbs_version() / 10000 == NURBS_VERSION_MAJOR, 'the version')
    call read_by_name()
    call read_from_memory()
    call errors()
    call finish()

contains

    subroutine read_by_name()
        type(nurbs_list) :: list
        call list%read_file(path)
        call holds_the_edge(list, 1d0)
    end subroutine read_by_name

    subroutine read_from_memory()
        type(nurbs_list) :: list
        type(nurbs_read_options) :: metres
        character(len=:), allocatable :: contents
        integer :: unit, bytes
        open (newunit=unit, file=path, access='stream', form='unformatted', action='read', status='old')
        inquire (unit, size=bytes)
        allocate (character(len=bytes) :: contents)
        read (unit) contents
        close (unit)
        call default_read_options(metres)
        metres%unit = 1
        call list%read(contents, metres)
        call holds_the_edge(list, 0.001d0)
    end subroutine read_from_memory

    subroutine holds_the_edge(list, scale)
        type(nurbs_list), intent(in) :: list
        real(c_double), intent(in) :: scale
        type(nurbs_spline) :: edge
        character(len=:), allocatable :: text
        integer(c_int32_t) :: entity_type, reason, code
        integer(c_int64_t) :: line
        call expect(list%count() == 1, 'one spline')
        call expect(near([list%unit()], [0.001d0 / scale]), 'its unit')
        call list%name(1, text)
        call expect(text == 'EDGE(7)', 'its name')
        call list%get(1, edge)
        call expect(on(edge, 1d0, [1d0, 2d0, 3d0] * scale), 'its end')
        call expect(list%note_count() == 1, 'one note')
        call list%note(1, entity_type, line, reason, text)
        call expect(entity_type == 116 .and. line == 3 .and. reason == NURBS_ERROR_UNSUPPORTED, 'on a point')
        call expect(len(text) > 0, 'in words')
        call list%get(2, edge, status=code)
        call expect(code == NURBS_ERROR_INDEX, 'no second spline')
    end subroutine holds_the_edge

    subroutine errors()
        type(nurbs_list) :: list
        integer(c_int32_t) :: code
        call list%read_file('/no/such/file', status=code)
        call expect(code == NURBS_ERROR_FILE, 'a file that is not there')
        call list%read('no file of a known format', status=code)
        call expect(code == NURBS_ERROR_FORMAT, 'not a known format')
    end subroutine errors
end program files
