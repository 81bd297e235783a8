! SPDX-License-Identifier: MIT
!> Meshes of one shape for several distances. Conventions: see the module nurbs.
module nurbs_levels
    use, intrinsic :: iso_c_binding
    use nurbs_constants
    use nurbs_c, only: nurbs_mesh_face_levels, nurbs_mesh_face_levels_with, nurbs_mesh_model_levels, &
        nurbs_mesh_model_levels_with, nurbs_mesh_options, nurbs_mesh_surface_levels, nurbs_mesh_surface_levels_with
    use nurbs_support
    use nurbs_calls
    use nurbs_faces, only: nurbs_face
    use nurbs_meshes, only: nurbs_mesh
    use nurbs_models, only: nurbs_model
    use nurbs_splines, only: nurbs_spline
    implicit none
    private
    public :: mesh_levels

    !> mesh_levels(shape, chords, meshes, options, status, call): of a surface, a face or a model one mesh for each of the
    !> distances, in their order: each as of_surface(), of_face() or of_model() makes it with that chord, and no
    !> relative_chord.
    interface mesh_levels
        module procedure levels_of_surface, levels_of_face, levels_of_model
    end interface mesh_levels

contains

    subroutine levels_of_surface(g, chords, meshes, options, status, call)
        class(nurbs_spline), intent(in) :: g
        real(c_double), intent(in), contiguous :: chords(:)
        type(nurbs_mesh), allocatable, intent(out) :: meshes(:)
        type(nurbs_mesh_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made(size(chords))
        if (present(call)) then
            code = nurbs_mesh_surface_levels_with(g%handle, size(chords, kind=c_int64_t), chords, options, &
                watched(call), made)
        else
            code = nurbs_mesh_surface_levels(g%handle, size(chords, kind=c_int64_t), chords, options, made)
        end if
        call take(code, made, meshes, status)
    end subroutine levels_of_surface

    subroutine levels_of_face(face, chords, meshes, options, status, call)
        class(nurbs_face), intent(in) :: face
        real(c_double), intent(in), contiguous :: chords(:)
        type(nurbs_mesh), allocatable, intent(out) :: meshes(:)
        type(nurbs_mesh_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made(size(chords))
        if (present(call)) then
            code = nurbs_mesh_face_levels_with(face%handle, size(chords, kind=c_int64_t), chords, options, &
                watched(call), made)
        else
            code = nurbs_mesh_face_levels(face%handle, size(chords, kind=c_int64_t), chords, options, made)
        end if
        call take(code, made, meshes, status)
    end subroutine levels_of_face

    subroutine levels_of_model(model, chords, meshes, options, status, call)
        class(nurbs_model), intent(in) :: model
        real(c_double), intent(in), contiguous :: chords(:)
        type(nurbs_mesh), allocatable, intent(out) :: meshes(:)
        type(nurbs_mesh_options), intent(in), optional :: options
        integer(c_int32_t), intent(out), optional :: status
        type(nurbs_call), intent(in), optional, target :: call
        integer(c_int32_t) :: code
        type(c_ptr) :: made(size(chords))
        if (present(call)) then
            code = nurbs_mesh_model_levels_with(model%handle, size(chords, kind=c_int64_t), chords, options, &
                watched(call), made)
        else
            code = nurbs_mesh_model_levels(model%handle, size(chords, kind=c_int64_t), chords, options, made)
        end if
        call take(code, made, meshes, status)
    end subroutine levels_of_model

    !> None of them after a failure.
    subroutine take(code, made, meshes, status)
        integer(c_int32_t), intent(in) :: code
        type(c_ptr), intent(in) :: made(:)
        type(nurbs_mesh), allocatable, intent(out) :: meshes(:)
        integer(c_int32_t), intent(out), optional :: status
        integer :: i
        if (code == NURBS_OK) then
            allocate (meshes(size(made)))
            do i = 1, size(made)
                call meshes(i)%replace(made(i))
            end do
        end if
        call settle(code, status)
    end subroutine take
end module nurbs_levels
