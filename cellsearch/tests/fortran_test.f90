! SPDX-License-Identifier: BSD-3-Clause
! Calls every function of the Fortran module once with a known answer: an interface that does not fit the C function
! would be noticed by no compiler.
module fortran_test_visitor
  use, intrinsic :: iso_c_binding
  implicit none
contains
  !> Sums 100 segment + node up to the fifth pair.
  function add_pair(segment, node, data) result(stop_now) bind(C)
    integer(c_int32_t), value :: segment, node
    type(c_ptr), value :: data
    integer(c_int32_t) :: stop_now
    integer(c_int32_t), pointer :: sums(:)
    call c_f_pointer(data, sums, [2])
    sums(1) = sums(1) + 100*segment + node
    sums(2) = sums(2) + 1
    stop_now = merge(1, 0, sums(2) == 5)
  end function
end module

program fortran_test
  use, intrinsic :: iso_c_binding
  use cellsearch
  use fortran_test_visitor
  implicit none
  real(c_double), target :: xyz(4, 8), expansion(2), radius(8), velocities(3, 8)
  integer(c_int32_t), target :: segments(4, 2), listed(2), node_group(8), segment_group(2), sums(2)
  integer(c_int8_t), target :: active(2), allow(2, 2)
  integer(c_int64_t), pointer :: first(:)
  integer(c_int32_t), pointer :: node(:), edges(:, :)
  real(c_double), pointer :: distance(:)
  type(c_ptr) :: search
  type(cellsearch_counts) :: counts
  integer(c_int64_t) :: segment, other
  integer(c_int32_t) :: due, steps
  real(c_double) :: used, left
  integer :: failures = 0

  xyz = 0
  xyz(1:2, 2) = [1, 0]
  xyz(1:2, 3) = [1, 1]
  xyz(1:2, 4) = [0, 1]
  xyz(:, 5:8) = xyz(:, 1:4)
  xyz(3, 5:8) = 0.25d0
  segments = reshape([1, 2, 3, 4, 5, 6, 7, 8], [4, 2])

  search = cellsearch_create()
  call check('create', c_associated(search))
  call check('version', len(cellsearch_version()) >= 5)
  call check('base', cellsearch_set_index_base(search, 1) == cellsearch_ok)
  call check('no method', cellsearch_set_method(search, 'guess') == cellsearch_bad_setting)
  call check('message', index(cellsearch_message(search), 'brute-force') > 0)
  call check('method', cellsearch_set_method(search, 'linked-cell   ') == cellsearch_ok)
  call check('no message', len(cellsearch_message(search)) == 0)
  call check('threads', cellsearch_set_threads(search, 2) == cellsearch_ok)
  call check('cell edge', cellsearch_set_cell_edge(search, 0.5d0) == cellsearch_ok)
  call check('chosen cells', cellsearch_set_cell_edge(search, 0d0) == cellsearch_ok)
  call check('instructions', cellsearch_set_instruction_set(search, 'portable') == cellsearch_ok)
  call check('the best', cellsearch_set_instruction_set(search, ' ') == cellsearch_ok)
  call check('cell factor', cellsearch_set_cell_factor(search, 1.5d0) == cellsearch_ok)
  call check('cells per node', cellsearch_set_cells_per_node(search, 2d0) == cellsearch_ok)
  call check('bad domain', cellsearch_set_domain(search, [0d0, 1d0, 0d0], [1d0, 0d0, 1d0], [1, 2, 1]) &
             == cellsearch_bad_domain)
  call check('axis', cellsearch_error_index(search) == 1)
  call check('positions', cellsearch_set_positions(search, 8_c_int64_t, xyz, 4_c_int64_t) == cellsearch_ok)
  call check('segments', cellsearch_set_segments(search, 2_c_int64_t, segments) == cellsearch_ok)
  call check('expansion', cellsearch_set_expansion(search, 0.25d0) == cellsearch_ok)
  call expect('all', [4, 4])

  call check('domain', cellsearch_set_domain(search, [0d0, 0d0, 0d0], [0.5d0, 1d0, 1d0], [2, 2, 2]) == cellsearch_ok)
  call expect('half of space', [2, 2])
  call check('no domain', cellsearch_set_domain(search) == cellsearch_ok)

  expansion = [0d0, 1d0]
  call check('no c', cellsearch_set_expansion(search, 0d0) == cellsearch_ok)
  call check('expansions', cellsearch_set_segment_expansion(search, expansion) == cellsearch_ok)
  call expect('by segment', [0, 4])
  call check('no expansions', cellsearch_set_segment_expansion(search) == cellsearch_ok)
  radius = [0d0, 0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 0d0]
  call check('radius', cellsearch_set_node_radius(search, radius) == cellsearch_ok)
  call expect('by radius', [1, 0])
  call check('no radius', cellsearch_set_node_radius(search) == cellsearch_ok)
  call check('c', cellsearch_set_expansion(search, 0.25d0) == cellsearch_ok)

  listed = [2, 7]
  call check('nodes', cellsearch_set_nodes(search, 2_c_int64_t, listed) == cellsearch_ok)
  call expect('listed', [1, 1])
  call check('all nodes', cellsearch_set_nodes(search, 0_c_int64_t) == cellsearch_ok)
  active = [0_c_int8_t, 1_c_int8_t]
  call check('active', cellsearch_set_active(search, active) == cellsearch_ok)
  call expect('one eroded', [0, 4])
  call check('all active', cellsearch_set_active(search) == cellsearch_ok)

  node_group = [1, 1, 1, 1, 2, 2, 2, 2]
  segment_group = [1, 2]
  allow = 0
  allow(1, 2) = 1 ! nodes of group 1 on segments of group 2
  call check('groups', cellsearch_set_groups(search, 2, node_group, segment_group, allow) == cellsearch_ok)
  call expect('by groups', [0, 4])
  call check('no groups', cellsearch_set_groups(search, 0) == cellsearch_ok)
  segments(3, 1) = 5 ! the lower segment shares a node with the upper one
  call check('neighbours', cellsearch_set_exclude_neighbours(search, 1) == cellsearch_ok)
  call expect('no neighbours', [1, 1]) ! node 3, which belongs to no segment now
  segments(3, 1) = 3
  call check('with neighbours', cellsearch_set_exclude_neighbours(search, 0) == cellsearch_ok)

  call check('build', cellsearch_build(search) == cellsearch_ok)
  sums = 0
  call check('visit', cellsearch_visit(search, c_funloc(add_pair), c_loc(sums)) == cellsearch_ok)
  call check('visited', sums(1) == 4*100 + 5 + 6 + 7 + 8 + 200 + 1 .and. sums(2) == 5)
  call check('verify', cellsearch_verify(search, segment, other) == cellsearch_ok)
  call check('verified', segment == 0 .and. other == 0)
  call check('statistics', cellsearch_statistics(search, counts) == cellsearch_ok)
  call check('counts', counts%segments == 2 .and. counts%participants == 8 .and. counts%candidates >= 8)

  call check('pairs', cellsearch_segment_pairs(search, 2_c_int64_t, .true., first, node) == cellsearch_ok)
  call check('one pair', all(first == [1, 2, 2]) .and. all(node == [2]))
  call check('edges', cellsearch_edges(search, edges) == cellsearch_ok)
  call check('8 edges', size(edges, 2) == 8 .and. all(edges(:, 2) == [1, 4]) .and. all(edges(:, 8) == [7, 8]))
  call check('edge pairs', cellsearch_edge_pairs(search, 8_c_int64_t, 0.125d0, .true., first, node) == cellsearch_ok)
  ! Each lower edge meets the upper one over it and the two beside that, the opposite lower one does not count: too far.
  call check('12 edge pairs', size(node) == 12 .and. first(9) == 13 .and. all(node(:first(2) - 1) == [5, 6, 7]))
  call check('nearest', cellsearch_nearest(search, 8_c_int64_t, 1, 1d0, .true., first, node, distance) == cellsearch_ok)
  call check('the plate above', all(node == [5, 6, 7, 8, 1, 2, 3, 4]) .and. maxval(abs(distance - 0.25d0)) < 1d-15)

  call check('motion', cellsearch_motion_start(search, 0.25d0, 0.125d0) == cellsearch_ok)
  velocities = 0
  velocities(3, 8) = 0.25d0
  call check('steps', cellsearch_motion_steps(search, velocities, 3_c_int64_t, 0.0625d0, 50, steps) == cellsearch_ok)
  call check('8 steps', steps == 8)
  call check('interval', cellsearch_interval(0.25d0, 0.125d0, 0.25d0, 0.0625d0, 50) == 8)
  xyz(3, 8) = xyz(3, 8) - 0.0625d0
  call check('update', cellsearch_motion_update(search, used, left, due) == cellsearch_ok)
  call check('moved', max(abs(used - 0.0625d0), abs(left - 0.0625d0)) < 1d-15 .and. due == 0)

  segments(4, 2) = 9
  call check('error', cellsearch_find(search, 2_c_int64_t, first, node) == cellsearch_bad_connectivity)
  call check('segment 2', cellsearch_error_index(search) == 2)
  call check('its message', index(cellsearch_message(search), 'Segment 2 ') == 1)
  call check('no rows', .not. associated(first) .and. .not. associated(node))
  call cellsearch_destroy(search)
  if (failures > 0) error stop 1
  print '(a)', 'all as expected'

contains

  subroutine check(what, fulfilled)
    character(len=*), intent(in) :: what
    logical, intent(in) :: fulfilled
    if (fulfilled) return
    failures = failures + 1
    print '(2a)', 'not as expected: ', what
  end subroutine

  !> The number of candidates of each segment.
  subroutine expect(what, counted)
    character(len=*), intent(in) :: what
    integer, intent(in) :: counted(2)
    call check(what, cellsearch_find(search, 2_c_int64_t, first, node) == cellsearch_ok)
    if (.not. associated(first)) return
    call check(what, all(first(2:3) - first(1:2) == counted) .and. size(node) == sum(counted))
  end subroutine
end program
