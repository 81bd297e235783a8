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
    call unwrapped()
    call bytes_and_back()
    call lists()
    call finish()

contains

    subroutine make_square(square)
        type(nurbs_spline), intent(inout) :: square
        real(c_double) :: points(4, 2)
        points(:, 1) = [1d0, -1d0, -1d0, 1d0]
        points(:, 2) = [1d0, 1d0, -1d0, -1d0]
        call square%create_periodic([2], [4], [2d0, 3d0, 4d0, 5d0, 6d0], points, flags=NURBS_PERIODIC)
    end subroutine make_square

    !> Each control point once, and what is read back.
    subroutine unwrapped()
        type(nurbs_spline) :: square
        real(c_double), allocatable :: values(:), points(:, :), weights(:)
        call make_square(square)
        call expect(square%count(1) == 6, 'all points')
        call expect(square%unwrapped_count(1) == 4, 'points that differ')
        call square%unwrapped_knots(1, values)
        call expect(size(values) == 5 .and. all(values == [2d0, 3d0, 4d0, 5d0, 6d0]), 'knots of a period')
        call square%short_knots(1, values)
        call expect(size(values) == 7 .and. all(values == [1d0, 2d0, 3d0, 4d0, 5d0, 6d0, 7d0]), 'short knots')
        call square%unwrapped_points(points, weights)
        call expect(all(shape(points) == [4, 2]) .and. all(points(:, 2) == [1d0, 1d0, -1d0, -1d0]), 'points once')
        call expect(size(weights) == 4 .and. all(weights == 1), 'weights once')
    end subroutine unwrapped

    subroutine bytes_and_back()
        type(nurbs_spline) :: square, again
        type(nurbs_list) :: list
        character(kind=c_char, len=:), allocatable :: bytes, same
        integer(c_int32_t) :: kind, major, minor, code
        call make_square(square)
        call square%to_bytes(bytes)
        call bytes_kind(bytes, kind, major, minor)
        call expect(kind == NURBS_BYTES_SPLINE .and. major == 1 .and. minor == 0, 'the kind of bytes')
        call again%from_bytes(bytes)
        call again%to_bytes(same)
        call expect(same == bytes, 'bytes of a spline')
        call list%from_bytes(bytes, code)
        call expect(code == NURBS_ERROR_FORMAT, 'bytes of another kind')
        bytes(100:100) = char(77)
        call again%from_bytes(bytes, code)
        call expect(code == NURBS_ERROR_CHECKSUM, 'bytes that changed')
    end subroutine bytes_and_back

    subroutine lists()
        type(nurbs_spline) :: splines(2)
        type(nurbs_list) :: list, again
        character(kind=c_char, len=:), allocatable :: bytes, same, text
        integer(c_int32_t) :: code
        call make_square(splines(1))
        splines(2) = splines(1)
        call list%create(splines, ['a     ', 'square'], 0.001d0)
        call list%name(2, text)
        call expect(list%count() == 2 .and. text == 'square', 'names that are given')
        call list%to_bytes(bytes)
        call again%from_bytes(bytes)
        call again%to_bytes(same)
        call again%name(1, text)
        call expect(same == bytes .and. text == 'a' .and. len(text) == 1, 'bytes of a list')
        call expect(near([again%unit()], [0.001d0]), 'the unit of a list')
        call list%create(splines)
        call list%name(2, text)
        call expect(text == '1', 'names that are not given')
        call list%create(splines, ['a'], status=code)
        call expect(code == NURBS_ERROR_SIZE, 'too few names')
        call list%create(splines, metres=-1d0, status=code)
        call expect(code == NURBS_ERROR_FACTOR, 'a unit below 0')
    end subroutine lists

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
