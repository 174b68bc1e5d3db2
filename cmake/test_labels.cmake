# SPDX-License-Identifier: BSD-3-Clause
# GoogleTest cases become ctest tests; a word in the suite's or the case's name gives the label:
#   Nightly  long property runs, only in `make nightly`
#   Golden   stored state hashes, which hold for the golden compiler (g++ 12) only
#   Slow     left out under the sanitizers
function(crumple_discover_tests program prefix)
  set(common TEST_PREFIX "${prefix}." DISCOVERY_TIMEOUT 60 DISCOVERY_MODE PRE_TEST NO_PRETTY_VALUES
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  gtest_discover_tests(${program} ${common} TEST_LIST ${program}_quick
    TEST_FILTER "*-*Nightly*:*Golden*:*Slow*")
  gtest_discover_tests(${program} ${common} TEST_LIST ${program}_nightly
    TEST_FILTER "*Nightly*" PROPERTIES LABELS nightly)
  gtest_discover_tests(${program} ${common} TEST_LIST ${program}_golden
    TEST_FILTER "*Golden*-*Nightly*" PROPERTIES LABELS golden)
  gtest_discover_tests(${program} ${common} TEST_LIST ${program}_slow
    TEST_FILTER "*Slow*-*Nightly*:*Golden*" PROPERTIES LABELS slow)
endfunction()
