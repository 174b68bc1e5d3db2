# SPDX-License-Identifier: BSD-3-Clause
# CRUMPLE_PORTABLE: programs that need nothing but the C library at run time, for tar files. OpenMP's runtime, the C++
# library, fmt and zlib are linked from archives; the code is the same, only the linking differs.

# Looked at by CMake's own modules when they look for OpenMP and zlib.
macro(crumple_prefer_archives)
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libgomp.a
    OUTPUT_VARIABLE gomp_archive OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  if(NOT IS_ABSOLUTE "${gomp_archive}")
    message(FATAL_ERROR "CRUMPLE_PORTABLE needs g++ with libgomp.a")
  endif()
  set(OpenMP_gomp_LIBRARY ${gomp_archive} CACHE FILEPATH "OpenMP's runtime, as an archive")
  set(ZLIB_USE_STATIC_LIBS ON)
  # What nobody calls of the C++ library asks for a newer C library than the rest (arc4random).
  add_link_options(-static-libstdc++ -static-libgcc LINKER:--gc-sections)
endmacro()

# The target crumple_fmt, used in the place of fmt::fmt. Headers and definitions are those of fmt::fmt.
function(crumple_add_fmt_archive)
  find_package(fmt REQUIRED)
  add_library(crumple_fmt STATIC ${PROJECT_SOURCE_DIR}/cmake/package/fmt.cpp)
  target_include_directories(crumple_fmt PUBLIC $<TARGET_PROPERTY:fmt::fmt,INTERFACE_INCLUDE_DIRECTORIES>)
  target_compile_definitions(crumple_fmt PUBLIC $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
endfunction()
