# SPDX-License-Identifier: Apache-2.0
# Builds the numbered examples against the installed package, away from the source tree, and runs them.
include("${CMAKE_CURRENT_LIST_DIR}/commands.cmake")

file(REMOVE_RECURSE "${WORK}/examples")
file(COPY "${SOURCE}/examples" DESTINATION "${WORK}")
file(GLOB examples "${WORK}/examples/[0-9]*.cpp")
if(NOT examples)
  message(FATAL_ERROR "There is no example in ${SOURCE}/examples.")
endif()
foreach(example IN LISTS examples)
  file(READ "${example}" text)
  string(REGEX MATCHALL "\n" line_ends "${text}")
  list(LENGTH line_ends line_count)
  if(line_count GREATER_EQUAL 40)
    message(FATAL_ERROR "${example} has ${line_count} lines; an example has fewer than 40.")
  endif()
endforeach()

build_against_package("${WORK}/examples" "${WORK}/examples_build")
run(${CMAKE_CTEST_COMMAND} --test-dir "${WORK}/examples_build" --no-tests=error --output-on-failure)
