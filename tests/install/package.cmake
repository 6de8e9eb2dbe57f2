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

# From wherever it lies, the program reads the scenes beside it: these differ from the source's.
file(COPY "${PREFIX}/bin" "${PREFIX}/share" "${PREFIX}/lib" DESTINATION "${WORK}/elsewhere")
set(scene "${WORK}/elsewhere/share/tegotae/scenes/paper-cube.xml")
file(READ "${scene}" text)
string(REPLACE "tegotae_stiffness\" data=\"9000\"" "tegotae_stiffness\" data=\"4321\"" text "${text}")
file(WRITE "${scene}" "${text}")
run("${WORK}/elsewhere/bin/tegotae" experiment paper-cube --out "${WORK}/elsewhere/out")
file(STRINGS "${WORK}/elsewhere/out/samples.csv" stiffness REGEX "^# stiffness: 4321 N/m")
if(NOT stiffness)
  message(FATAL_ERROR "The installed program did not read the scene beside it, ${scene}.")
endif()

# Every header of the library is installed.
file(GLOB_RECURSE in_source RELATIVE "${SOURCE}" "${SOURCE}/tegotae/*.hpp" "${SOURCE}/tegotae/*.h")
file(GLOB_RECURSE installed RELATIVE "${PREFIX}/include" "${PREFIX}/include/*.hpp" "${PREFIX}/include/*.h")
if(NOT in_source STREQUAL installed)
  message(FATAL_ERROR "Headers in the source: ${in_source}; installed: ${installed}")
endif()
