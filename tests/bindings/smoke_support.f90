! SPDX-License-Identifier: MIT
! How the smoke test of Fortran prints what calls return: see smoke_reference.cpp.
module smoke_support
    use, intrinsic :: iso_c_binding
    use nurbs
    implicit none
    private
    public :: begin, by_hand, show, flat, written

    interface show
        module procedure show_double, show_doubles, show_singles, show_int, show_ints, show_long, show_longs
        module procedure show_logical, show_logicals, show_text, show_spline, show_list, show_statistics, show_face, &
            show_model, show_meet, show_mesh
    end interface show

    interface flat
        module procedure flat_doubles_2, flat_doubles_3, flat_singles_2, flat_ints_2, flat_logicals_2, flat_longs_2
    end interface flat

    character(len=:), allocatable :: call_name

contains

    subroutine begin(name)
        character(len=*), intent(in) :: name
        call_name = name
        print '(a)', name//'|done|'
    end subroutine begin

    subroutine by_hand(name)
        character(len=*), intent(in) :: name
        print '(a)', name//'|by hand|'
    end subroutine by_hand

    function written(path, text) result(name)
        character(len=*), intent(in) :: path, text
        character(len=:), allocatable :: name
        integer :: unit
        name = path
        open (newunit=unit, file=path, access='stream', status='replace')
        write (unit) text
        close (unit)
    end function written

    function head(name)
        character(len=*), intent(in) :: name
        character(len=:), allocatable :: head
        head = call_name//'|'//name//'|'
    end function head

    ! Numbers.

    subroutine show_doubles(name, values)
        character(len=*), intent(in) :: name
        real(c_double), intent(in) :: values(:)
        print '(a, *(z16.16, 1x))', head(name), transfer(values, [0_c_int64_t], size(values))
    end subroutine show_doubles

    subroutine show_double(name, value)
        character(len=*), intent(in) :: name
        real(c_double), intent(in) :: value
        call show_doubles(name, [value])
    end subroutine show_double

    subroutine show_singles(name, values)
        character(len=*), intent(in) :: name
        real(c_float), intent(in) :: values(:)
        print '(a, *(z8.8, 1x))', head(name), transfer(values, [0_c_int32_t], size(values))
    end subroutine show_singles

    subroutine show_longs(name, values)
        character(len=*), intent(in) :: name
        integer(c_int64_t), intent(in) :: values(:)
        print '(a, *(i0, 1x))', head(name), values
    end subroutine show_longs

    subroutine show_long(name, value)
        character(len=*), intent(in) :: name
        integer(c_int64_t), intent(in) :: value
        call show_longs(name, [value])
    end subroutine show_long

    subroutine show_ints(name, values)
        character(len=*), intent(in) :: name
        integer(c_int32_t), intent(in) :: values(:)
        call show_longs(name, int(values, c_int64_t))
    end subroutine show_ints

    subroutine show_int(name, value)
        character(len=*), intent(in) :: name
        integer(c_int32_t), intent(in) :: value
        call show_ints(name, [value])
    end subroutine show_int

    subroutine show_logicals(name, values)
        character(len=*), intent(in) :: name
        logical, intent(in) :: values(:)
        call show_ints(name, merge(1_c_int32_t, 0_c_int32_t, values))
    end subroutine show_logicals

    subroutine show_logical(name, value)
        character(len=*), intent(in) :: name
        logical, intent(in) :: value
        call show_logicals(name, [value])
    end subroutine show_logical

    subroutine show_text(name, text)
        character(len=*), intent(in) :: name, text
        print '(a)', head(name)//text
    end subroutine show_text

    ! Handles.

    subroutine show_statistics(name, statistics)
        character(len=*), intent(in) :: name
        class(nurbs_statistics), intent(in) :: statistics
        character(kind=c_char, len=:), allocatable :: bytes
        integer :: i
        call statistics%to_bytes(bytes)
        call show(name//'.bytes', [(int(ichar(bytes(i:i)), c_int32_t), i=1, len(bytes))])
    end subroutine show_statistics

    subroutine show_face(name, face)
        character(len=*), intent(in) :: name
        class(nurbs_face), intent(in) :: face
        type(nurbs_spline) :: curve
        integer(c_int64_t), allocatable :: sizes(:)
        integer :: k, i
        call face%loops(sizes)
        call show(name//'.sizes', sizes)
        do k = 1, size(sizes)
            do i = 1, int(sizes(k))
                call face%curve(k, i, curve)
                call show(name//'.curves', curve)
            end do
        end do
    end subroutine show_face

    subroutine show_model(name, model)
        character(len=*), intent(in) :: name
        class(nurbs_model), intent(in) :: model
        type(nurbs_face) :: face
        type(nurbs_spline) :: edge
        integer(c_int64_t) :: n(5)
        integer :: i
        call model%counts(n(1), n(2), n(3), n(4), n(5))
        call show(name//'.counts', n)
        do i = 1, int(n(3))
            call model%face(i, face)
            call show(name//'.faces', face)
        end do
        do i = 1, int(n(4))
            call model%edge(i, edge)
            call show(name//'.edges', edge)
        end do
    end subroutine show_model

    subroutine show_meet(name, meet)
        character(len=*), intent(in) :: name
        class(nurbs_meet), intent(in) :: meet
        type(nurbs_spline) :: space, on_surface
        integer(c_int64_t), allocatable :: levels(:)
        integer(c_int32_t), allocatable :: kinds(:)
        real(c_double), allocatable :: params(:, :), ranges(:, :)
        integer(c_int64_t) :: branches
        integer :: i
        call meet%counts(branches)
        call meet%nodes(levels, kinds, params, ranges)
        call show(name//'.nodes', kinds)
        do i = 1, int(branches)
            call meet%branch(i, space, on_surface)
            call show(name//'.branches', space)
            call show(name//'.branches', on_surface)
        end do
    end subroutine show_meet

    subroutine show_mesh(name, mesh)
        character(len=*), intent(in) :: name
        class(nurbs_mesh), intent(in) :: mesh
        integer(c_int64_t), allocatable :: corners(:, :)
        real(c_double), allocatable :: points(:, :)
        call mesh%points(points)
        call mesh%triangles(corners)
        call show(name//'.points', flat(transpose(points)))
        call show(name//'.corners', flat(transpose(corners)) - 1)
    end subroutine show_mesh

    subroutine show_spline(name, g)
        character(len=*), intent(in) :: name
        class(nurbs_spline), intent(in) :: g
        real(c_double), allocatable :: knots(:), own(:), points(:, :)
        integer(c_int32_t) :: axis
        call show(name//'.degrees', [(g%degree(axis), axis=1, g%axes())])
        allocate (knots(0))
        do axis = 1, g%axes()
            call g%knots(axis, own)
            knots = [knots, own]
        end do
        call show(name//'.knots', knots)
        call g%homogeneous_points(points)
        call show(name//'.points', flat(transpose(points)))
    end subroutine show_spline

    subroutine show_list(name, list)
        character(len=*), intent(in) :: name
        class(nurbs_list), intent(in) :: list
        type(nurbs_spline) :: g
        character(len=12) :: place
        integer(c_int32_t) :: i
        call show(name//'.count', list%count())
        do i = 1, int(list%count(), c_int32_t)
            call list%get(i, g)
            write (place, '(a, i0, a)') '[', i - 1, ']'
            call show(name//trim(place), g)
        end do
    end subroutine show_list

    ! Arrays in the order in which they are stored.

    function flat_doubles_2(values) result(all)
        real(c_double), intent(in) :: values(:, :)
        real(c_double) :: all(size(values))
        all = reshape(values, [size(values)])
    end function flat_doubles_2

    function flat_doubles_3(values) result(all)
        real(c_double), intent(in) :: values(:, :, :)
        real(c_double) :: all(size(values))
        all = reshape(values, [size(values)])
    end function flat_doubles_3

    function flat_singles_2(values) result(all)
        real(c_float), intent(in) :: values(:, :)
        real(c_float) :: all(size(values))
        all = reshape(values, [size(values)])
    end function flat_singles_2

    function flat_ints_2(values) result(all)
        integer(c_int32_t), intent(in) :: values(:, :)
        integer(c_int32_t) :: all(size(values))
        all = reshape(values, [size(values)])
    end function flat_ints_2

    function flat_longs_2(values) result(all)
        integer(c_int64_t), intent(in) :: values(:, :)
        integer(c_int64_t) :: all(size(values))
        all = reshape(values, [size(values)])
    end function flat_longs_2

    function flat_logicals_2(values) result(all)
        logical, intent(in) :: values(:, :)
        logical :: all(size(values))
        all = reshape(values, [size(values)])
    end function flat_logicals_2

end module smoke_support
