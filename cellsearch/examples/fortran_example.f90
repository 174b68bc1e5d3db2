! SPDX-License-Identifier: BSD-3-Clause
! Two parallel plates of one segment each, 0.1 apart: which nodes are near which segment?
program fortran_example
  use, intrinsic :: iso_c_binding
  use cellsearch
  implicit none
  real(c_double), target :: xyz(3, 8)
  integer(c_int32_t), target :: segments(4, 2)
  integer(c_int64_t), pointer :: first(:)
  integer(c_int32_t), pointer :: node(:)
  type(c_ptr) :: search
  integer(c_int32_t) :: status
  integer :: s

  xyz(:, 1:4) = reshape([0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 1d0, 1d0, 0d0, 0d0, 1d0, 0d0], [3, 4]) ! lower plate
  xyz(:, 5:8) = xyz(:, 1:4) ! upper plate
  xyz(3, 5:8) = 0.1d0
  segments = reshape([1, 2, 3, 4, 5, 6, 7, 8], [4, 2])

  search = cellsearch_create() ! keep it: it re-uses its memory from search to search
  status = cellsearch_set_index_base(search, 1) ! Fortran counts from 1
  status = cellsearch_set_positions(search, 8_c_int64_t, xyz, 3_c_int64_t) ! views: nothing is copied
  status = cellsearch_set_segments(search, 2_c_int64_t, segments)
  status = cellsearch_set_expansion(search, 0.2d0) ! c: how far a node may be from the box of a segment
  if (cellsearch_find(search, 2_c_int64_t, first, node) /= cellsearch_ok) then
    print '(a)', cellsearch_message(search)
    error stop 1
  end if
  do s = 1, 2
    print '(a, i0, a, *(1x, i0))', 'segment ', s, ':', node(first(s):first(s + 1) - 1)
  end do
  call cellsearch_destroy(search)
end program
