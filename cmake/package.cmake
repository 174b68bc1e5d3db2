# SPDX-License-Identifier: BSD-3-Clause
# What `make package` packs (tools/package): crumple, the program with its pages, man pages, documents and examples;
# libcellsearch-dev, the search library with its headers. Here the Debian packages are described; tar files need no description.
set(documents share/doc/crumple)
install(FILES README.md CITATION.cff DESTINATION ${documents} COMPONENT crumple)
# Debian wants the licence's text indented, with dots in its empty lines.
file(READ LICENSE licence_text)
string(STRIP "${licence_text}" licence_text)
string(REGEX REPLACE "\n" "\n " licence_text " ${licence_text}")
string(REPLACE "\n \n" "\n .\n" licence_text "${licence_text}")
configure_file(cmake/package/copyright.in copyright @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/copyright DESTINATION ${documents} COMPONENT crumple)
install(DIRECTORY docs DESTINATION ${documents} COMPONENT crumple)
install(DIRECTORY examples DESTINATION ${documents} COMPONENT crumple USE_SOURCE_PERMISSIONS
  PATTERN __pycache__ EXCLUDE)
# Made from the program's help by tools/package.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/build/package/man/ DESTINATION share/man/man1 COMPONENT crumple
  OPTIONAL FILES_MATCHING PATTERN *.1.gz)
set(search_documents share/doc/libcellsearch-dev)
install(FILES ${PROJECT_BINARY_DIR}/copyright cellsearch/README.md DESTINATION ${search_documents} COMPONENT cellsearch)
install(DIRECTORY cellsearch/docs cellsearch/examples DESTINATION ${search_documents} COMPONENT cellsearch)

set(CRUMPLE_MAINTAINER "the crumple authors <maintainers@crumple.invalid>" CACHE STRING "maintainer of the packages")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME crumple)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGE_CONTACT "${CRUMPLE_MAINTAINER}")
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL crumple cellsearch)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_CRUMPLE_PACKAGE_NAME crumple)
set(CPACK_DEBIAN_CRUMPLE_PACKAGE_SECTION science)
set(CPACK_DEBIAN_CRUMPLE_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_CRUMPLE_PACKAGE_SUGGESTS "chromium, paraview, python3")
set(CPACK_DEBIAN_CRUMPLE_DESCRIPTION "explicit finite element solver for crash and contact-impact
Reads LS-DYNA keyword decks, finds contacts in linear time, gives bitwise the
same result for any number of threads, and shows it as one HTML file.")
set(CPACK_DEBIAN_CELLSEARCH_PACKAGE_NAME libcellsearch-dev)
set(CPACK_DEBIAN_CELLSEARCH_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_CELLSEARCH_PACKAGE_SUGGESTS "g++, cmake, gfortran")
set(CPACK_DEBIAN_CELLSEARCH_DESCRIPTION "contact search between nodes and segments of finite element meshes
A static library with headers for C++ and C, and a module for Fortran.")
if(CRUMPLE_PYTHON)
  install(FILES ${PROJECT_BINARY_DIR}/copyright DESTINATION share/doc/python3-crumple COMPONENT python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  # The modules are for one version of Python.
  math(EXPR following_minor "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-crumple)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), \
python3 (<< ${Python_VERSION_MAJOR}.${following_minor}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas")
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION "crumple and cellsearch for Python
Decks, runs with the bits of the program, results and studies of many runs; and
the contact search over arrays of NumPy.")
endif()
include(CPack)
