# SPDX-License-Identifier: BSD-3-Clause
# The Python packages crumple and cellsearch (python/, docs/python.md), on request; they need pybind11 and Python's headers.
# A module of Python is a shared library, so all that goes into it must be position-independent. With hidden symbols the
# compiler makes the same code of that as for a program of Debian, which is position-independent as well.
set(python_possible OFF)
if(NOT CRUMPLE_CORE_ONLY AND NOT CRUMPLE_SANITIZE AND NOT CRUMPLE_PORTABLE AND NOT CRUMPLE_FUZZ)
  # Debian's own, which has Debian's NumPy, before others in the path.
  if(NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "Python that the packages crumple and cellsearch are for")
  endif()
  find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module)
  find_package(pybind11 2.10 QUIET CONFIG)
  if(Python_FOUND AND pybind11_FOUND)
    set(python_possible ON)
  endif()
endif()
option(CRUMPLE_PYTHON "Build the Python packages crumple and cellsearch" OFF)
if(CRUMPLE_PYTHON)
  if(NOT python_possible)
    message(FATAL_ERROR "CRUMPLE_PYTHON needs pybind11 and Python's headers (tools/setup python), and a build with the "
      "deck reader, shared libraries and no sanitizer.")
  endif()
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
  set(CMAKE_CXX_VISIBILITY_PRESET hidden)
  set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
endif()
