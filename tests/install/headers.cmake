# SPDX-License-Identifier: Apache-2.0
# Compiles each installed header alone, twice over: it needs nothing before it, and guards itself.
include("${CMAKE_CURRENT_LIST_DIR}/commands.cmake")

set(project "${WORK}/headers")
file(REMOVE_RECURSE "${project}")
file(GLOB_RECURSE headers RELATIVE "${PREFIX}/include" "${PREFIX}/include/tegotae/*.hpp")
if(NOT headers)
  message(FATAL_ERROR "The installed package has no headers.")
endif()
foreach(header IN LISTS headers)
  string(REPLACE "/" "_" name "${header}")
  file(WRITE "${project}/${name}.cpp" "#include <${header}>\n#include <${header}>\n")
endforeach()
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
