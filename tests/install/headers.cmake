# SPDX-License-Identifier: Apache-2.0
# Compiles the installed headers: each needs nothing before it, guards itself, and goes with all the others in one file.
# That it needs nothing before it, the library's build has shown of each header that stands first in a source of the
# library; the others are compiled alone. All in one file, twice over, shows the rest, and that the package brings along
# what its headers include.
include("${CMAKE_CURRENT_LIST_DIR}/commands.cmake")

set(project "${WORK}/headers")
file(REMOVE_RECURSE "${project}")
file(GLOB_RECURSE headers RELATIVE "${PREFIX}/include" "${PREFIX}/include/tegotae/*.hpp"
  "${PREFIX}/include/tegotae/*.h")
if(NOT headers)
  message(FATAL_ERROR "The installed package has no headers.")
endif()
set(alone ${headers})
file(GLOB_RECURSE library_sources "${SOURCE}/tegotae/*.cpp")
foreach(source IN LISTS library_sources)
  file(STRINGS "${source}" first_directive REGEX "^#" LIMIT_COUNT 1)
  if(first_directive MATCHES "^#include <([^>]+)>$")
    list(REMOVE_ITEM alone "${CMAKE_MATCH_1}")
  endif()
endforeach()
foreach(header IN LISTS alone)
  string(REPLACE "/" "_" name "${header}")
  file(WRITE "${project}/${name}.cpp" "#include <${header}>\n")
endforeach()
list(TRANSFORM headers REPLACE "(.+)" "#include <\\1>\n" OUTPUT_VARIABLE all)
list(JOIN all "" all)
file(WRITE "${project}/all.cpp" "${all}${all}")
file(WRITE "${project}/CMakeLists.txt" [[
cmake_minimum_required(VERSION 3.25)
project(tegotae_headers LANGUAGES C CXX)
find_package(tegotae REQUIRED)
file(GLOB sources "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
add_library(headers OBJECT ${sources})
target_compile_options(headers PRIVATE -fsyntax-only)
target_link_libraries(headers PRIVATE tegotae::lab)
]])
build_against_package("${project}" "${WORK}/headers_build")
