# SPDX-License-Identifier: Apache-2.0
# Installs the package, moves it, and checks that nothing in it points back to the source or build folder.
include("${CMAKE_CURRENT_LIST_DIR}/commands.cmake")

file(REMOVE_RECURSE "${WORK}")
run(${CMAKE_COMMAND} --install "${BUILD}" --prefix "${WORK}/first_place")
file(RENAME "${WORK}/first_place" "${PREFIX}")

file(GLOB_RECURSE package_files "${PREFIX}/*.cmake")
if(NOT package_files)
  message(FATAL_ERROR "The installed package has no CMake files.")
endif()
foreach(package_file IN LISTS package_files)
  file(READ "${package_file}" text)
  foreach(folder IN ITEMS "${SOURCE}" "${BUILD}")
    string(FIND "${text}" "${folder}" place)
    if(NOT place EQUAL -1)
      message(FATAL_ERROR "${package_file} names ${folder}, which is not there where the package is used.")
    endif()
  endforeach()
endforeach()

if(NOT EXISTS "${PREFIX}/bin/tegotae")
  message(FATAL_ERROR "The program tegotae is not installed.")
endif()
run("${PREFIX}/bin/tegotae" --version)

# Every header of the library is installed.
file(GLOB_RECURSE in_source RELATIVE "${SOURCE}" "${SOURCE}/tegotae/*.hpp")
file(GLOB_RECURSE installed RELATIVE "${PREFIX}/include" "${PREFIX}/include/*.hpp")
if(NOT in_source STREQUAL installed)
  message(FATAL_ERROR "Headers in the source: ${in_source}; installed: ${installed}")
endif()
