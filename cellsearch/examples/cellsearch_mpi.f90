! SPDX-License-Identifier: BSD-3-Clause
!> The search over ranks for Fortran, over MPI; see cellsearch/distributed/cellsearch_mpi.h. Compile this file with your own,
!> after cellsearch.f90; it needs no module of MPI: communicators are integers, as in module mpi, or comm%mpi_val of
!> module mpi_f08.
module cellsearch_mpi
  use, intrinsic :: iso_c_binding
  implicit none
  private
  public :: cellsearch_ranks_create, cellsearch_ranks_destroy, cellsearch_ranks_find, cellsearch_ranks_held
  public :: cellsearch_ranks_set_ids, cellsearch_ranks_update

  !> What a rank holds after a search. Pointers into the memory of the library, until the next search.
  type, public :: cellsearch_held
    integer(c_int64_t) :: own_nodes = 0, ghost_nodes = 0
    integer(c_int64_t), pointer :: segment_id(:) => null() !< ascending
    integer(c_int32_t), pointer :: owner(:) => null() !< rank from 0
    integer(c_int32_t), pointer :: corner(:, :) => null() !< (4, segments); own nodes, then ghosts from own_nodes + 1 on
    integer(c_int64_t), pointer :: ghost_node_id(:) => null()
    real(c_double), pointer :: xyz(:, :) => null() !< (3, own and ghost nodes)
  end type

  type, bind(C) :: held_parts
    integer(c_int64_t) :: segments, own_nodes, ghost_nodes
    type(c_ptr) :: segment_id, owner, corner, ghost_node_id, xyz
  end type

  interface
    !> Collective. communicator: MPI_COMM_WORLD, say. c_null_ptr if MPI is not initialised.
    function cellsearch_ranks_create(communicator) result(ranks) bind(C)
      import :: c_ptr, c_int32_t
      integer(c_int32_t), value :: communicator
      type(c_ptr) :: ranks
    end function

    !> Collective; before MPI_Finalize.
    subroutine cellsearch_ranks_destroy(ranks) bind(C)
      import :: c_ptr
      type(c_ptr), value :: ranks
    end subroutine

    !> Collective. Positions of own nodes again from the array set in the handle, of ghosts from their owners.
    function cellsearch_ranks_update(ranks, handle) result(status) bind(C)
      import :: c_ptr, c_int32_t
      type(c_ptr), value :: ranks, handle
      integer(c_int32_t) :: status
    end function

    !> Global numbers of all nodes and segments; viewed after the return: they need the attribute target.
    function cellsearch_ranks_set_ids(ranks, handle, node_id, segment_id) result(status) bind(C)
      import :: c_ptr, c_int32_t, c_int64_t
      type(c_ptr), value :: ranks, handle
      integer(c_int64_t), intent(in), target :: node_id(*), segment_id(*)
      integer(c_int32_t) :: status
    end function

    function c_ranks_find(ranks, handle, first, segment, pairs) result(status) bind(C, name="cellsearch_ranks_find")
      import :: c_ptr, c_int32_t, c_int64_t
      type(c_ptr), value :: ranks, handle
      type(c_ptr), intent(out) :: first, segment
      integer(c_int64_t), intent(out) :: pairs
      integer(c_int32_t) :: status
    end function

    function c_ranks_held(ranks, handle, held) result(status) bind(C, name="cellsearch_ranks_held")
      import :: c_ptr, c_int32_t, held_parts
      type(c_ptr), value :: ranks, handle
      type(held_parts), intent(out) :: held
      integer(c_int32_t) :: status
    end function
  end interface

contains

  !> Collective. Held segments of the node at place p of those that take part, `participants` in all: segment(first(p) :
  !> first(p + 1) - 1), with index base 1.
  function cellsearch_ranks_find(ranks, handle, participants, first, segment) result(status)
    type(c_ptr), intent(in) :: ranks, handle
    integer(c_int64_t), intent(in) :: participants
    integer(c_int64_t), pointer, intent(out) :: first(:)
    integer(c_int32_t), pointer, intent(out) :: segment(:)
    integer(c_int32_t) :: status
    integer(c_int64_t) :: pairs
    type(c_ptr) :: c_first, c_segment
    nullify (first, segment)
    status = c_ranks_find(ranks, handle, c_first, c_segment, pairs)
    if (status /= 0) return
    call c_f_pointer(c_first, first, [participants + 1])
    call c_f_pointer(c_segment, segment, [pairs])
  end function

  !> What this rank holds since the last search.
  function cellsearch_ranks_held(ranks, handle, held) result(status)
    type(c_ptr), intent(in) :: ranks, handle
    type(cellsearch_held), intent(out) :: held
    integer(c_int32_t) :: status
    type(held_parts) :: parts
    status = c_ranks_held(ranks, handle, parts)
    if (status /= 0) return
    held%own_nodes = parts%own_nodes
    held%ghost_nodes = parts%ghost_nodes
    call c_f_pointer(parts%segment_id, held%segment_id, [parts%segments])
    call c_f_pointer(parts%owner, held%owner, [parts%segments])
    call c_f_pointer(parts%corner, held%corner, [4_c_int64_t, parts%segments])
    call c_f_pointer(parts%ghost_node_id, held%ghost_node_id, [parts%ghost_nodes])
    call c_f_pointer(parts%xyz, held%xyz, [3_c_int64_t, parts%own_nodes + parts%ghost_nodes])
  end function
end module
