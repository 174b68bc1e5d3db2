# SPDX-License-Identifier: BSD-3-Clause
# The allow-list: "folder: the folders it may include". It feeds the link lines below and tools/check_layers.
# Data flows one way: deck -> model -> domain -> timeloop(elements, contact, constraints, loads) -> output.
set(CRUMPLE_LAYERS
  "base:"
  "math: base"
  "model: base"
  "domain: model math base"
  "materials: domain model math base"
  "elements: materials domain model math base"
  "contact: materials domain model math base cellsearch"
  "constraints: domain model math base"
  "loads: domain model math base"
  "timeloop: elements materials contact constraints loads domain model math base"
  "files: base"
  "deck: files model base"
  "output: files domain model math base"
  "report: output files base"
  "live: report output files base"
  "compare: report output files base")
# app may include everything; it is built by crumple/app/CMakeLists.txt.

# Inside a folder: "room: the rooms of the same folder that it may include". What stands in the folder itself may include
# all of its rooms, and none of them may include that. Kernels may include every room.
set(CRUMPLE_ROOMS
  "contact/surface:"
  "contact/enforcement: contact/surface"
  "contact/search: contact/enforcement contact/surface"
  "contact/node_segment: contact/search contact/enforcement contact/surface"
  "contact/edge_edge: contact/search contact/enforcement contact/surface"
  "contact/pinball: contact/search contact/enforcement contact/surface"
  "contact/tied: contact/enforcement contact/surface"
  "deck/format:"
  "deck/keywords: deck/format"
  "deck/keywords/conditions: deck/keywords deck/format"
  "deck/keywords/contact: deck/keywords deck/format"
  "deck/keywords/control: deck/keywords deck/format"
  "deck/keywords/materials: deck/keywords deck/format"
  "deck/build: deck/keywords deck/format"
  "elements/common:"
  "elements/shell: elements/common"
  "elements/solid: elements/common"
  "elements/line: elements/common"
  "materials/common:"
  "materials/eos: materials/common"
  "materials/plasticity: materials/common"
  "materials/laws: materials/plasticity materials/eos materials/common"
  "output/files:"
  "output/results: output/files"
  "output/histories: output/results output/files"
  "output/lsdyna: output/results output/files"
  "output/paraview: output/results output/files"
  "output/d3plot: output/results output/files"
  "compare/curves:"
  "compare/readers: compare/curves"
  "compare/measures: compare/curves"
  "app/console:"
  "app/arguments: app/console"
  "app/preparation: app/arguments app/console"
  "app/session: app/preparation app/arguments app/console"
  "app/measurement: app/session app/console"
  "app/commands: app/measurement app/session app/preparation app/arguments app/console")

# Headers that stand in a folder itself and that its rooms may include all the same: constants that belong to the whole
# folder. They include nothing of it.
set(CRUMPLE_SHARED_HEADERS contact/tolerances.hpp)

set(CRUMPLE_NON_CORE files deck output report live compare)
set(CRUMPLE_LAYER_NAMES "")
foreach(line IN LISTS CRUMPLE_LAYERS)
  string(REGEX REPLACE ":.*" "" name "${line}")
  string(REGEX REPLACE "^[^:]*:" "" allowed "${line}")
  separate_arguments(allowed)
  set(CRUMPLE_LAYER_${name} ${allowed})
  if(NOT (CRUMPLE_CORE_ONLY AND name IN_LIST CRUMPLE_NON_CORE))
    list(APPEND CRUMPLE_LAYER_NAMES ${name})
  endif()
endforeach()

# The text of a kernel is compiled once per instruction set: crumple/<layer>/kernels/*.cpp, with
# CRUMPLE_ISA naming the variant. "scalar" is the reference that every other one is tested against.
# Sanitizers look at the text of the kernels, which is one: the plain variants are enough, and cheap.
set(CRUMPLE_ISAS scalar baseline)
if(CRUMPLE_KERNELS STREQUAL "scalar")
  set(CRUMPLE_ISAS scalar)
elseif(CRUMPLE_X86 AND NOT CRUMPLE_SANITIZE AND NOT CRUMPLE_KERNELS STREQUAL "plain")
  list(APPEND CRUMPLE_ISAS avx2 avx512)
  if(CRUMPLE_KERNELS STREQUAL "native")
    execute_process(COMMAND ${PROJECT_SOURCE_DIR}/tools/isas OUTPUT_VARIABLE best OUTPUT_STRIP_TRAILING_WHITESPACE)
    string(REGEX REPLACE ".* " "" best "${best}")
    set(CRUMPLE_ISAS scalar ${best})
  endif()
endif()
# For the files that choose among them, and for these alone: they are all to compile when the choice changes.
list(TRANSFORM CRUMPLE_ISAS PREPEND CRUMPLE_HAS_ OUTPUT_VARIABLE CRUMPLE_ISA_DEFINITIONS)
set(CRUMPLE_ISA_FLAGS_avx2 -march=x86-64-v3)
set(CRUMPLE_ISA_FLAGS_avx512 -march=x86-64-v4 -mprefer-vector-width=512)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Its own header of AVX-512 intrinsics trips these (GCC bug 105593); the other variants keep the check.
  list(APPEND CRUMPLE_ISA_FLAGS_avx512 -Wno-uninitialized -Wno-maybe-uninitialized)
endif()

# GCC copies and clears objects of 33 bytes to 8 KiB by "rep movsq", which takes some 30 cycles to begin. The local search
# and the forces of contact handle many of 100 to 500 bytes: a tenth of their time.
if(CRUMPLE_X86 AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(CRUMPLE_LAYER_FLAGS_contact -mmemcpy-strategy=unrolled_loop:512:noalign,libcall:-1:noalign
    -mmemset-strategy=unrolled_loop:512:noalign,libcall:-1:noalign)
endif()

# What is inlined into the laws has thousands of temporaries, and GCC's analysis of what points where takes the square of
# their number: three quarters of the compile time of shell_laws.cpp. Packs live in registers; the code hardly changes.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(CRUMPLE_LAYER_FLAGS_materials -fno-tree-pta)
endif()

function(crumple_add_isa_variants layer)
  file(GLOB kernels CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/crumple/${layer}/kernels/*.cpp)
  if(NOT kernels)
    return()
  endif()
  foreach(isa IN LISTS CRUMPLE_ISAS)
    set(variant crumple_${layer}_${isa})
    add_library(${variant} OBJECT ${kernels})
    target_compile_options(${variant} PRIVATE ${CRUMPLE_WARNINGS} ${CRUMPLE_ISA_FLAGS_${isa}}
      ${CRUMPLE_LAYER_FLAGS_${layer}})
    target_compile_definitions(${variant} PRIVATE CRUMPLE_ISA=${isa} CRUMPLE_ISA_IS_${isa}=1)
    target_include_directories(${variant} PRIVATE ${PROJECT_SOURCE_DIR}/crumple)
    target_sources(crumple_${layer} PRIVATE $<TARGET_OBJECTS:${variant}>)
  endforeach()
endfunction()

# Most of the compiler's time goes into headers, so files are compiled many at a time (CMAKE_UNITY_BUILD_BATCH_SIZE): around
# the core, which is two thirds of the files, and in the folders of the core that change little; in the rest, kernels apart,
# where all is compiled once (CRUMPLE_UNITY_CORE) and under sanitizers. What is around the core is not optimised under
# sanitizers. Alone are files with local names of another file in their folder, and with definitions of their own: the
# second list has the ends of their names. tools/check_tidy reads both.
set(CRUMPLE_UNITY_LAYERS app compare constraints contact deck domain elements live loads materials model output report
  timeloop)
set(CRUMPLE_COMPILED_ALONE _reader http_server beam_kernels comparison d3plot_state edge_geometry edge_search
  element_constants forces global_search mass_damping multipliers numbers page quantity_names read_conditions read_control
  read_control_shell read_discretes read_mesh read_parts read_sets read_solids read_walls report_command
  rigid_motion run_record solid_benchmark solid_overlaps sprague_geers stable_steps stop_signals text_file)
function(crumple_compile_together target layer)
  if(NOT CRUMPLE_UNITY OR NOT layer IN_LIST CRUMPLE_UNITY_LAYERS)
    return()
  endif()
  # Fuzzing programs run for long; they have no tests beside them.
  set(sanitized_tests OFF)
  if(CRUMPLE_SANITIZE AND CRUMPLE_TESTS)
    set(sanitized_tests ON)
  endif()
  if(layer IN_LIST CRUMPLE_NON_CORE OR layer STREQUAL "app")
    if(sanitized_tests)
      target_compile_options(${target} PRIVATE -O0)
    endif()
  elseif(NOT sanitized_tests AND NOT CRUMPLE_UNITY_CORE AND NOT layer MATCHES "^(materials|model)$")
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON)
  target_compile_options(${target} PRIVATE -Wno-shadow)
  list(JOIN CRUMPLE_COMPILED_ALONE "|" alone)
  set(sources ${ARGN})
  list(FILTER sources INCLUDE REGEX "(${alone})\\.cpp$")
  set_source_files_properties(${sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# One static library per folder, with its rooms. A folder without sources yet is an interface target.
function(crumple_add_layer layer)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/crumple/${layer}/*.cpp)
  # Kernels are compiled by instruction set, below.
  list(FILTER sources EXCLUDE REGEX "/kernels/")
  set(target crumple_${layer})
  set(scope PUBLIC)
  if(sources)
    add_library(${target} STATIC ${sources})
    target_compile_options(${target} PRIVATE ${CRUMPLE_WARNINGS} ${CRUMPLE_LAYER_FLAGS_${layer}})
    crumple_compile_together(${target} ${layer} ${sources})
    foreach(source IN LISTS sources)
      file(STRINGS ${source} chooses REGEX "#include \"base/isa_variants\\.hpp\"")
      if(chooses OR source MATCHES "/base/isa\\.cpp$")
        set_property(SOURCE ${source} APPEND PROPERTY COMPILE_DEFINITIONS ${CRUMPLE_ISA_DEFINITIONS})
      endif()
    endforeach()
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(${target} ${scope} ${PROJECT_SOURCE_DIR}/crumple)
  foreach(allowed IN LISTS CRUMPLE_LAYER_${layer})
    if(allowed STREQUAL "cellsearch")
      target_link_libraries(${target} ${scope} cellsearch::cellsearch)
    else()
      target_link_libraries(${target} ${scope} crumple_${allowed})
    endif()
  endforeach()
  if(layer STREQUAL "base")
    target_link_libraries(${target} ${scope} OpenMP::OpenMP_CXX)
  endif()
  if(sources)
    crumple_add_isa_variants(${layer})
  endif()
  if(layer IN_LIST CRUMPLE_NON_CORE)
    target_compile_options(${target} PRIVATE ${CRUMPLE_HARDENING})
    find_package(fmt REQUIRED)
    target_link_libraries(${target} ${scope} $<IF:$<BOOL:${CRUMPLE_PORTABLE}>,crumple_fmt,fmt::fmt>)
  endif()
  if(layer STREQUAL "report")
    # Beside what the program looks through by itself.
    set_property(SOURCE ${PROJECT_SOURCE_DIR}/crumple/report/page.cpp PROPERTY COMPILE_DEFINITIONS
      CRUMPLE_BUILT_PAGES="${CRUMPLE_PAGES}")
  endif()
  if(layer STREQUAL "output")
    set_property(SOURCE ${PROJECT_SOURCE_DIR}/crumple/output/lsdyna/text_file.cpp PROPERTY COMPILE_DEFINITIONS
      CRUMPLE_VERSION="${PROJECT_VERSION}")
  endif()
  if(layer MATCHES "^(output|report|live|compare)$")
    find_package(ZLIB REQUIRED)
    find_package(nlohmann_json REQUIRED)
    target_link_libraries(${target} ${scope} ZLIB::ZLIB nlohmann_json::nlohmann_json)
  endif()
  if(layer STREQUAL "live")
    find_package(Threads REQUIRED)
    target_link_libraries(${target} PRIVATE Threads::Threads)
  endif()
endfunction()
