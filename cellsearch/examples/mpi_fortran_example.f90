! SPDX-License-Identifier: BSD-3-Clause
! A stack of square plates 0.1 apart, one on each rank: which plates are near the first node of each?
program mpi_fortran_example
  use, intrinsic :: iso_c_binding
  use mpi
  use cellsearch
  use cellsearch_mpi
  implicit none
  real(c_double), target :: xyz(3, 4)
  integer(c_int32_t), target :: segments(4, 1)
  integer(c_int64_t), target :: node_id(4), segment_id(1)
  integer(c_int64_t), pointer :: first(:)
  integer(c_int32_t), pointer :: segment(:)
  type(cellsearch_held) :: held
  type(c_ptr) :: search, ranks
  integer(c_int32_t) :: status
  integer :: rank, error

  call MPI_Init(error)
  call MPI_Comm_rank(MPI_COMM_WORLD, rank, error)
  xyz = reshape([0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 1d0, 1d0, 0d0, 0d0, 1d0, 0d0], [3, 4])
  xyz(3, :) = 0.1d0*rank
  segments(:, 1) = [1, 2, 3, 4] ! in the numbers of this rank
  node_id = 4*rank + [1, 2, 3, 4] ! in those of the whole model
  segment_id = rank + 1

  search = cellsearch_create()
  status = cellsearch_set_index_base(search, 1)
  status = cellsearch_set_positions(search, 4_c_int64_t, xyz, 3_c_int64_t)
  status = cellsearch_set_segments(search, 1_c_int64_t, segments)
  status = cellsearch_set_expansion(search, 0.15d0)
  ranks = cellsearch_ranks_create(int(MPI_COMM_WORLD, c_int32_t)) ! keep it from search to search
  status = cellsearch_ranks_set_ids(ranks, search, node_id, segment_id)
  if (cellsearch_ranks_find(ranks, search, 4_c_int64_t, first, segment) /= cellsearch_ok) then
    print '(a)', cellsearch_message(search)
    call MPI_Abort(MPI_COMM_WORLD, 1, error)
  end if
  status = cellsearch_ranks_held(ranks, search, held)

  xyz(3, :) = xyz(3, :) + 1d0 ! all plates rise by 1; ghosts follow their owners
  status = cellsearch_ranks_update(ranks, search)
  print '(a, i0, a, i0, a, f3.1, a, *(1x, i0))', 'rank ', rank, ' holds ', size(held%owner), &
    ' plates, the lowest now at ', held%xyz(3, held%corner(1, 1)), '; first node: plates', &
    held%segment_id(segment(first(1):first(2) - 1))
  call cellsearch_ranks_destroy(ranks)
  call cellsearch_destroy(search)
  call MPI_Finalize(error)
end program
