# SPDX-License-Identifier: BSD-3-Clause
# What a program that is not linked by a C++ compiler must link beside the static library: the C++ standard library
# and the threads, of the compiler in use. Sets runtime_libraries (a list, for CMake) and the pkgconfig_ variables.

# The compiler names what it links into every C++ program; the C part of it comes with any compiler.
set(runtime_libraries ${CMAKE_CXX_IMPLICIT_LINK_LIBRARIES})
list(REMOVE_DUPLICATES runtime_libraries)
list(REMOVE_ITEM runtime_libraries gcc gcc_s c)
if(CELLSEARCH_OPENMP AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  list(APPEND runtime_libraries ${OpenMP_CXX_LIB_NAMES})  # every gcc finds its own
elseif(CELLSEARCH_OPENMP)
  list(APPEND runtime_libraries ${OpenMP_CXX_LIBRARIES})
endif()
if(NOT "pthread" IN_LIST runtime_libraries)
  list(APPEND runtime_libraries pthread)
endif()

set(pkgconfig_runtime "")
foreach(library IN LISTS runtime_libraries)
  if(IS_ABSOLUTE "${library}")
    string(APPEND pkgconfig_runtime " ${library}")
  else()
    string(APPEND pkgconfig_runtime " -l${library}")
  endif()
endforeach()
string(STRIP "${pkgconfig_runtime}" pkgconfig_runtime)

# The prefix as seen from the folder of the file, so that the installed tree can be moved.
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
  set(pkgconfig_prefix ${CMAKE_INSTALL_PREFIX})
else()
  file(RELATIVE_PATH pkgconfig_prefix /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
  string(REGEX REPLACE "/$" "" pkgconfig_prefix "\${pcfiledir}/${pkgconfig_prefix}")
endif()
foreach(folder LIBDIR INCLUDEDIR DATADIR)
  string(TOLOWER ${folder} name)
  if(IS_ABSOLUTE "${CMAKE_INSTALL_${folder}}")
    set(pkgconfig_${name} ${CMAKE_INSTALL_${folder}})
  else()
    set(pkgconfig_${name} "\${prefix}/${CMAKE_INSTALL_${folder}}")
  endif()
endforeach()
