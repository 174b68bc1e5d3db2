! SPDX-License-Identifier: BSD-3-Clause
!> Fortran 2003 interface of cellsearch, over its C interface. Compile this file with your own: modules of one
!> compiler cannot be read by another one. What every function does, with shapes, units and errors, is described
!> in cellsearch/cellsearch.h; with index base 1 all numbers of nodes, segments and groups count from 1.
module cellsearch
  use, intrinsic :: iso_c_binding
  implicit none
  private
  public :: cellsearch_create, cellsearch_destroy, cellsearch_error_index, cellsearch_message, cellsearch_version
  public :: cellsearch_set_index_base, cellsearch_set_method, cellsearch_set_threads, cellsearch_set_cell_factor
  public :: cellsearch_set_cell_edge, cellsearch_set_instruction_set
  public :: cellsearch_set_cells_per_node, cellsearch_set_domain, cellsearch_set_positions
  public :: cellsearch_set_segments, cellsearch_set_expansion, cellsearch_set_segment_expansion
  public :: cellsearch_set_nodes, cellsearch_set_node_radius, cellsearch_set_active
  public :: cellsearch_set_exclude_neighbours, cellsearch_set_groups
  public :: cellsearch_build, cellsearch_find, cellsearch_visit, cellsearch_statistics, cellsearch_verify
  public :: cellsearch_segment_pairs, cellsearch_edges, cellsearch_edge_pairs, cellsearch_nearest
  public :: cellsearch_motion_start, cellsearch_motion_update, cellsearch_motion_steps, cellsearch_interval

  integer(c_int32_t), parameter, public :: cellsearch_ok = 0, cellsearch_bad_layout = 1, &
    cellsearch_empty_input = 2, cellsearch_non_finite_coordinate = 3, cellsearch_bad_connectivity = 4, &
    cellsearch_bad_expansion = 5, cellsearch_bad_node_list = 6, cellsearch_bad_domain = 7, &
    cellsearch_bad_setting = 8, cellsearch_bad_radius = 9, cellsearch_bad_node_group = 10, &
    cellsearch_bad_segment_group = 11, cellsearch_unsuited_method = 12, cellsearch_bad_argument = 20, &
    cellsearch_not_built = 21, cellsearch_out_of_memory = 22, cellsearch_internal_error = 23, &
    cellsearch_bad_node_id = 13, cellsearch_bad_segment_id = 14, cellsearch_transport_fault = 24

  !> What the last build and the queries since did.
  type, bind(C), public :: cellsearch_counts
    integer(c_int64_t) :: segments, participants, nodes_in_domain, cells, bytes, cell_visits, raw_visits, candidates
  end type

  type, bind(C) :: cellsearch_neighbours
    type(c_ptr) :: first, node, distance
    integer(c_int64_t) :: count
  end type

  interface
    !> A new handle; c_null_ptr if memory ran out. Its index base is 0: call cellsearch_set_index_base(handle, 1).
    function cellsearch_create() result(handle) bind(C)
      import :: c_ptr
      type(c_ptr) :: handle
    end function

    subroutine cellsearch_destroy(handle) bind(C)
      import :: c_ptr
      type(c_ptr), value :: handle
    end subroutine

    function cellsearch_error_index(handle) result(found) bind(C)
      import :: c_ptr, c_int64_t
      type(c_ptr), value :: handle
      integer(c_int64_t) :: found
    end function

    function cellsearch_set_index_base(handle, base) result(status) bind(C)
      import :: c_ptr, c_int32_t
      type(c_ptr), value :: handle
      integer(c_int32_t), value :: base
      integer(c_int32_t) :: status
    end function

    function cellsearch_set_threads(handle, threads) result(status) bind(C)
      import :: c_ptr, c_int32_t
      type(c_ptr), value :: handle
      integer(c_int32_t), value :: threads
      integer(c_int32_t) :: status
    end function

    function cellsearch_set_cell_edge(handle, edge) result(status) bind(C)
      import :: c_ptr, c_int32_t, c_double
      type(c_ptr), value :: handle
      real(c_double), value :: edge
      integer(c_int32_t) :: status
    end function

    function cellsearch_set_cell_factor(handle, factor) result(status) bind(C)
      import :: c_ptr, c_int32_t, c_double
      type(c_ptr), value :: handle
      real(c_double), value :: factor
      integer(c_int32_t) :: status
    end function

    function cellsearch_set_cells_per_node(handle, cells) result(status) bind(C)
      import :: c_ptr, c_int32_t, c_double
      type(c_ptr), value :: handle
      real(c_double), value :: cells
      integer(c_int32_t) :: status
    end function

    !> Leave all three out for automatic cells.
    function cellsearch_set_domain(handle, minimum, maximum, cells) result(status) bind(C)
      import :: c_ptr, c_int32_t, c_double
      type(c_ptr), value :: handle
      real(c_double), intent(in), optional :: minimum(3), maximum(3)
      integer(c_int32_t), intent(in), optional :: cells(3)
      integer(c_int32_t) :: status
    end function

    !> xyz(stride, nodes). This and the other arrays are viewed after the return: they need the attribute target, and
    !> must be contiguous.
    function cellsearch_set_positions(handle, nodes, xyz, stride) result(status) bind(C)
      import :: c_ptr, c_int32_t, c_int64_t, c_double
      type(c_ptr), value :: handle
      integer(c_int64_t), value :: nodes, stride
      real(c_double), intent(in), target :: xyz(*)
      integer(c_int32_t) :: status
    end function

    !> nodes(4, segments)
    function cellsearch_set_segments(handle, segments, nodes) result(status) bind(C)
      import :: c_ptr, c_int32_t, c_int64_t
      type(c_ptr), value :: handle
      integer(c_int64_t), value :: segments
      integer(c_int32_t), intent(in), target :: nodes(*)
      integer(c_int32_t) :: status
    end function

    function cellsearch_set_expansion(handle, expansion) result(status) bind(C)
      import :: c_ptr, c_int32_t, c_double
      type(c_ptr), value :: handle
      real(c_double), value :: expansion
      integer(c_int32_t) :: status
    end function

    !> Leave the array out for none.
    function cellsearch_set_segment_expansion(handle, expansion) result(status) bind(C)
      import :: c_ptr, c_int32_t, c_double
      type(c_ptr), value :: handle
      real(c_double), intent(in), target, optional :: expansion(*)
      integer(c_int32_t) :: status
    end function

    !> Leave the array out for all nodes.
    function cellsearch_set_nodes(handle, count, nodes) result(status) bind(C)
      import :: c_ptr, c_int32_t, c_int64_t
      type(c_ptr), value :: handle
      integer(c_int64_t), value :: count
      integer(c_int32_t), intent(in), target, optional :: nodes(*)
      integer(c_int32_t) :: status
    end function

    !> Leave the array out for none.
    function cellsearch_set_node_radius(handle, radius) result(status) bind(C)
      import :: c_ptr, c_int32_t, c_double
      type(c_ptr), value :: handle
      real(c_double), intent(in), target, optional :: radius(*)
      integer(c_int32_t) :: status
    end function

    !> Leave the array out if all are active.
    function cellsearch_set_active(handle, active) result(status) bind(C)
      import :: c_ptr, c_int32_t, c_int8_t
      type(c_ptr), value :: handle
      integer(c_int8_t), intent(in), target, optional :: active(*)
      integer(c_int32_t) :: status
    end function

    function cellsearch_set_exclude_neighbours(handle, exclude) result(status) bind(C)
      import :: c_ptr, c_int32_t
      type(c_ptr), value :: handle
      integer(c_int32_t), value :: exclude
      integer(c_int32_t) :: status
    end function

    !> allow(group of the node, group of the segment). Leave the arrays out with groups = 0.
    function cellsearch_set_groups(handle, groups, node_group, segment_group, allow) result(status) bind(C)
      import :: c_ptr, c_int32_t, c_int8_t
      type(c_ptr), value :: handle
      integer(c_int32_t), value :: groups
      integer(c_int32_t), intent(in), target, optional :: node_group(*), segment_group(*)
      integer(c_int8_t), intent(in), target, optional :: allow(*)
      integer(c_int32_t) :: status
    end function

    function cellsearch_build(handle) result(status) bind(C)
      import :: c_ptr, c_int32_t
      type(c_ptr), value :: handle
      integer(c_int32_t) :: status
    end function

    !> visitor: c_funloc of a function of segment, node (both integer(c_int32_t), value) and data (type(c_ptr),
    !> value) with bind(C) that returns integer(c_int32_t), 0 to go on.
    function cellsearch_visit(handle, visitor, data) result(status) bind(C)
      import :: c_ptr, c_funptr, c_int32_t
      type(c_ptr), value :: handle, data
      type(c_funptr), value :: visitor
      integer(c_int32_t) :: status
    end function

    function cellsearch_statistics(handle, counts) result(status) bind(C)
      import :: c_ptr, c_int32_t, cellsearch_counts
      type(c_ptr), value :: handle
      type(cellsearch_counts), intent(out) :: counts
      integer(c_int32_t) :: status
    end function

    function cellsearch_verify(handle, segment, node) result(status) bind(C)
      import :: c_ptr, c_int32_t, c_int64_t
      type(c_ptr), value :: handle
      integer(c_int64_t), intent(out) :: segment, node
      integer(c_int32_t) :: status
    end function

    function cellsearch_motion_start(handle, expansion, contact_distance) result(status) bind(C)
      import :: c_ptr, c_int32_t, c_double
      type(c_ptr), value :: handle
      real(c_double), value :: expansion, contact_distance
      integer(c_int32_t) :: status
    end function

    function cellsearch_motion_update(handle, used, left, due) result(status) bind(C)
      import :: c_ptr, c_int32_t, c_double
      type(c_ptr), value :: handle
      real(c_double), intent(out) :: used, left
      integer(c_int32_t), intent(out) :: due
      integer(c_int32_t) :: status
    end function

    function cellsearch_motion_steps(handle, velocities, stride, largest_step, cap, steps) result(status) bind(C)
      import :: c_ptr, c_int32_t, c_int64_t, c_double
      type(c_ptr), value :: handle
      real(c_double), intent(in) :: velocities(*)
      integer(c_int64_t), value :: stride
      real(c_double), value :: largest_step
      integer(c_int32_t), value :: cap
      integer(c_int32_t), intent(out) :: steps
      integer(c_int32_t) :: status
    end function

    function cellsearch_interval(expansion, contact_distance, largest_speed, largest_step, cap) result(steps) bind(C)
      import :: c_int32_t, c_double
      real(c_double), value :: expansion, contact_distance, largest_speed, largest_step
      integer(c_int32_t), value :: cap
      integer(c_int32_t) :: steps
    end function
  end interface

  ! What needs strings or pointers of Fortran is called through the functions below.
  interface
    function c_set_method(handle, name) result(status) bind(C, name="cellsearch_set_method")
      import :: c_ptr, c_int32_t, c_char
      type(c_ptr), value :: handle
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int32_t) :: status
    end function

    function c_set_instruction_set(handle, name) result(status) bind(C, name="cellsearch_set_instruction_set")
      import :: c_ptr, c_int32_t, c_char
      type(c_ptr), value :: handle
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int32_t) :: status
    end function

    function c_find(handle, first, node, pairs) result(status) bind(C, name="cellsearch_find")
      import :: c_ptr, c_int32_t, c_int64_t
      type(c_ptr), value :: handle
      type(c_ptr), intent(out) :: first, node
      integer(c_int64_t), intent(out) :: pairs
      integer(c_int32_t) :: status
    end function

    function c_segment_pairs(handle, exclude_shared_nodes, first, second, pairs) result(status) &
      bind(C, name="cellsearch_segment_pairs")
      import :: c_ptr, c_int32_t, c_int64_t
      type(c_ptr), value :: handle
      integer(c_int32_t), value :: exclude_shared_nodes
      type(c_ptr), intent(out) :: first, second
      integer(c_int64_t), intent(out) :: pairs
      integer(c_int32_t) :: status
    end function

    function c_edges(handle, nodes, edges) result(status) bind(C, name="cellsearch_edges")
      import :: c_ptr, c_int32_t, c_int64_t
      type(c_ptr), value :: handle
      type(c_ptr), intent(out) :: nodes
      integer(c_int64_t), intent(out) :: edges
      integer(c_int32_t) :: status
    end function

    function c_edge_pairs(handle, expansion, exclude_shared_nodes, first, second, pairs) result(status) &
      bind(C, name="cellsearch_edge_pairs")
      import :: c_ptr, c_int32_t, c_int64_t, c_double
      type(c_ptr), value :: handle
      real(c_double), value :: expansion
      integer(c_int32_t), value :: exclude_shared_nodes
      type(c_ptr), intent(out) :: first, second
      integer(c_int64_t), intent(out) :: pairs
      integer(c_int32_t) :: status
    end function

    function c_nearest(handle, neighbours, largest_distance, exclude_connected, found) result(status) &
      bind(C, name="cellsearch_nearest")
      import :: c_ptr, c_int32_t, c_double, cellsearch_neighbours
      type(c_ptr), value :: handle
      integer(c_int32_t), value :: neighbours, exclude_connected
      real(c_double), value :: largest_distance
      type(cellsearch_neighbours), intent(out) :: found
      integer(c_int32_t) :: status
    end function

    function c_error_message(handle) result(text) bind(C, name="cellsearch_error_message")
      import :: c_ptr
      type(c_ptr), value :: handle
      type(c_ptr) :: text
    end function

    function c_version() result(text) bind(C, name="cellsearch_version")
      import :: c_ptr
      type(c_ptr) :: text
    end function
  end interface

contains

  !> The method by its name; trailing blanks do not count.
  function cellsearch_set_method(handle, name) result(status)
    type(c_ptr), intent(in) :: handle
    character(len=*), intent(in) :: name
    integer(c_int32_t) :: status
    status = c_set_method(handle, trim(name)//c_null_char)
  end function

  !> The instruction set by its name; trailing blanks do not count; empty: the best.
  function cellsearch_set_instruction_set(handle, name) result(status)
    type(c_ptr), intent(in) :: handle
    character(len=*), intent(in) :: name
    integer(c_int32_t) :: status
    status = c_set_instruction_set(handle, trim(name)//c_null_char)
  end function

  !> Searches. Segment s = 1 ... (index base 1) has the candidates node(first(s):first(s + 1) - 1). Both arrays belong
  !> to the handle and hold until its next search; after an error they are null.
  function cellsearch_find(handle, segments, first, node) result(status)
    type(c_ptr), intent(in) :: handle
    integer(c_int64_t), intent(in) :: segments !< as many as were set
    integer(c_int64_t), pointer, intent(out) :: first(:)
    integer(c_int32_t), pointer, intent(out) :: node(:)
    integer(c_int32_t) :: status
    type(c_ptr) :: first_of, node_of
    integer(c_int64_t) :: pairs
    nullify (first, node)
    status = c_find(handle, first_of, node_of, pairs)
    if (status /= cellsearch_ok) return
    call c_f_pointer(first_of, first, [segments + 1])
    call c_f_pointer(node_of, node, [pairs])
  end function

  !> Pairs i < j of segments: those of i are second(first(i):first(i + 1) - 1). The arrays of this and of the functions
  !> below belong to the handle and hold until the next call of the same function; after an error they are null.
  function cellsearch_segment_pairs(handle, segments, exclude_shared_nodes, first, second) result(status)
    type(c_ptr), intent(in) :: handle
    integer(c_int64_t), intent(in) :: segments !< as many as were set
    logical, intent(in) :: exclude_shared_nodes
    integer(c_int64_t), pointer, intent(out) :: first(:)
    integer(c_int32_t), pointer, intent(out) :: second(:)
    integer(c_int32_t) :: status
    type(c_ptr) :: first_of, second_of
    integer(c_int64_t) :: pairs
    nullify (first, second)
    status = c_segment_pairs(handle, merge(1_c_int32_t, 0_c_int32_t, exclude_shared_nodes), first_of, second_of, pairs)
    if (status /= cellsearch_ok) return
    call c_f_pointer(first_of, first, [segments + 1])
    call c_f_pointer(second_of, second, [pairs])
  end function

  !> The different edges of the active segments: nodes(1, e) < nodes(2, e).
  function cellsearch_edges(handle, nodes) result(status)
    type(c_ptr), intent(in) :: handle
    integer(c_int32_t), pointer, intent(out) :: nodes(:, :)
    integer(c_int32_t) :: status
    type(c_ptr) :: nodes_of
    integer(c_int64_t) :: edges
    nullify (nodes)
    status = c_edges(handle, nodes_of, edges)
    if (status == cellsearch_ok) call c_f_pointer(nodes_of, nodes, [2_c_int64_t, edges])
  end function

  !> Pairs e < f of these edges, rows as for segments. `edges`: their number, size(nodes, 2).
  function cellsearch_edge_pairs(handle, edges, expansion, exclude_shared_nodes, first, second) result(status)
    type(c_ptr), intent(in) :: handle
    integer(c_int64_t), intent(in) :: edges
    real(c_double), intent(in) :: expansion !< [length]
    logical, intent(in) :: exclude_shared_nodes
    integer(c_int64_t), pointer, intent(out) :: first(:)
    integer(c_int32_t), pointer, intent(out) :: second(:)
    integer(c_int32_t) :: status
    type(c_ptr) :: first_of, second_of
    integer(c_int64_t) :: pairs
    nullify (first, second)
    status = c_edge_pairs(handle, expansion, merge(1_c_int32_t, 0_c_int32_t, exclude_shared_nodes), first_of, &
                          second_of, pairs)
    if (status /= cellsearch_ok) return
    call c_f_pointer(first_of, first, [edges + 1])
    call c_f_pointer(second_of, second, [pairs])
  end function

  !> The nearest nodes of node p: node(first(p):first(p + 1) - 1), at the distances [length] in the same places.
  function cellsearch_nearest(handle, nodes, neighbours, largest_distance, exclude_connected, first, node, distance) &
    result(status)
    type(c_ptr), intent(in) :: handle
    integer(c_int64_t), intent(in) :: nodes !< as many as were set
    integer(c_int32_t), intent(in) :: neighbours
    real(c_double), intent(in) :: largest_distance !< [length]
    logical, intent(in) :: exclude_connected
    integer(c_int64_t), pointer, intent(out) :: first(:)
    integer(c_int32_t), pointer, intent(out) :: node(:)
    real(c_double), pointer, intent(out) :: distance(:)
    integer(c_int32_t) :: status
    type(cellsearch_neighbours) :: found
    nullify (first, node, distance)
    status = c_nearest(handle, neighbours, largest_distance, merge(1_c_int32_t, 0_c_int32_t, exclude_connected), found)
    if (status /= cellsearch_ok) return
    call c_f_pointer(found%first, first, [nodes + 1])
    call c_f_pointer(found%node, node, [found%count])
    call c_f_pointer(found%distance, distance, [found%count])
  end function

  !> One sentence about the last error of the handle; empty after success.
  function cellsearch_message(handle) result(message)
    type(c_ptr), intent(in) :: handle
    character(len=:), allocatable :: message
    message = text_of(c_error_message(handle))
  end function

  !> The version of the library, as "0.1.0".
  function cellsearch_version() result(version)
    character(len=:), allocatable :: version
    version = text_of(c_version())
  end function

  function text_of(address) result(text)
    type(c_ptr), intent(in) :: address
    character(len=:), allocatable :: text
    character(kind=c_char), pointer :: letters(:)
    integer :: length
    call c_f_pointer(address, letters, [512])
    length = 0
    do while (letters(length + 1) /= c_null_char)
      length = length + 1
    end do
    allocate (character(len=length) :: text)
    text = transfer(letters(1:length), text)
  end function
end module
