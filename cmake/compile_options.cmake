# SPDX-License-Identifier: BSD-3-Clause
# One place for the language standard, the floating-point rules and the warnings of every target.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_FLAGS_RELEASE "-O3")

# Bit rules (docs/determinism.md): no contraction behind our back, errno and traps never looked at.
add_compile_options(-ffp-contract=off -fno-math-errno -fno-trapping-math)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  add_compile_options(-march=x86-64-v2)
  set(CRUMPLE_X86 TRUE)
endif()

# A compiler that we do not know may warn of what ours do not: errors in continuous integration alone.
option(CRUMPLE_WERROR "Warnings are errors" $ENV{CI})
set(CRUMPLE_WARNINGS -Wall -Wextra -Wpedantic $<$<BOOL:${CRUMPLE_WERROR}>:-Werror> -Wshadow -Wconversion -Wno-sign-conversion
  -Wdouble-promotion -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align -Wunused -Wold-style-cast
  -Wimplicit-fallthrough -Wextra-semi -Wno-psabi)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  list(APPEND CRUMPLE_WARNINGS -Wduplicated-cond -Wlogical-op -Wuseless-cast)
endif()

set(CRUMPLE_SANITIZE "" CACHE STRING "address,undefined or thread")
if(CRUMPLE_SANITIZE)
  add_compile_options(-fsanitize=${CRUMPLE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${CRUMPLE_SANITIZE})
endif()

# For packages: addresses of functions are read-only once the program has started (full RELRO), and what reads text from
# outside, which is all around the core, checks its stack and its calls of the C library. The core does not: its loops would
# pay for it, and all that they read has been checked.
option(CRUMPLE_HARDENED "Harden the program against faulty input files: for packages" OFF)
if(CRUMPLE_HARDENED)
  add_link_options(LINKER:-z,relro LINKER:-z,now)
  set(CRUMPLE_HARDENING -fstack-protector-strong -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
endif()
