# SPDX-License-Identifier: BSD-3-Clause
# cmake -C cmake/build_once.cmake: for builds of everything that are not built again after each change. Most of a build goes
# into headers, so the fewer times they are read, the sooner it ends: by half for the tests.
set(CMAKE_UNITY_BUILD_BATCH_SIZE 32 CACHE STRING "Files compiled as one")
set(CRUMPLE_UNITY_CORE ON CACHE BOOL "Compile the files of the core many at a time")
