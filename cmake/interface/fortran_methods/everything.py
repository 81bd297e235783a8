# SPDX-License-Identifier: MIT
"""The module that a program uses, nurbs, and its introduction."""

HEAD = """\
! SPDX-License-Identifier: MIT
! {notice}
!> libnurbs for Fortran 2018: splines, lists of splines, statistics of data, trimmed faces and models of
!> them, where shapes meet, and meshes, as types that clean up after themselves.
!>
!> - Arrays have Fortran's order, one column for each coordinate: points(n, dim), params(n, axes) and
!>   derivs(n, dim, slots). Contiguous ones are used in place; the compiler packs others into a temporary.
!> - Control points and grids run through the last axis fastest: point (i, j) of a surface of counts (m, n) is
!>   row (i - 1) * n + j.
!> - Axes, spans and list entries count from 1. Only messages and the module nurbs_c count from 0.
!> - Each procedure has an optional status. Without it a failure ends the program with the library's message.
!>   An array whose shape does not suit is NURBS_ERROR_SIZE.
!> - Results are arguments, not function values, which compilers of today do not always finalize. The result of
!>   an operation must be another variable than its operand.
!> - An assignment makes another handle on the same data, also of arrays, which have to be allocated before, of the
!>   same shape. What copies bit by bit in its place would have handles freed twice: allocate() with source=, and
!>   in gfortran 12 assignments of types with splines in them; give such a type an assignment of its own, which
!>   assigns these.
{watched}!>
!> A CMake project writes find_package(nurbs COMPONENTS Fortran) and links nurbs::fortran. By hand, nurbs_all.f90 is all
!> modules in one file:
!>
!>     gfortran -c nurbs_all.f90
module nurbs
    use nurbs_constants ! statuses, flags and limits
    use nurbs_c         ! the C functions as they stand, for what is not below: nurbs_version
    use nurbs_support, only: nurbs_message, nurbs_status_text, nurbs_on_axis, nurbs_on_all_axes
    use nurbs_handles, only: data_for_fits, default_cloud_options, default_fit_options, default_read_options, &
        default_mesh_options, default_write_options
"""
WATCHED = """\
!> - A procedure that can take long has an optional last argument, call: a nurbs_call with a limit of work, and with a
!>   function that is told how much is done and may end the call.
"""
WATCHED_USE = "    use nurbs_calls, only: nurbs_call, nurbs_progress\n"
TAIL = """\
    use nurbs_levels
    implicit none
    public
end module nurbs
"""
ALL = """\
! SPDX-License-Identifier: MIT
! {notice}
! All modules in the order in which a compiler needs them, for programs that are built without CMake.
"""
BY_HAND = ["constants", "c", "calls", "support", "handles"]
BY_HAND_BEHIND = ["levels"]


def module(modules, notice, watched):
    """modules: those that are made of the table, in order; watched: whether there are long calls."""
    uses = "".join(f"    use nurbs_{module.name}{only(module)}\n" for module in modules if shown(module))
    head = HEAD.format(notice=notice, watched=WATCHED * watched)
    return head + WATCHED_USE * watched + uses + TAIL


def shown(module):
    return module.public() or module.type is None or module.type.shown


def only(module):
    """Types that are steps on the way to others stay hidden."""
    if module.type is None:
        return ""
    return ", only: " + ", ".join([*module.public(), *[module.type.name] * module.type.shown])


def includes(modules, notice, watched):
    by_hand = [name for name in BY_HAND if watched or name != "calls"]
    names = [f"nurbs_{name}" for name in (*by_hand, *(module.name for module in modules), *BY_HAND_BEHIND)] + ["nurbs"]
    return ALL.format(notice=notice) + "".join(f"include '{name}.f90'\n" for name in names)
