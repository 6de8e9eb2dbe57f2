# SPDX-License-Identifier: Apache-2.0
# What the install tests share. Variables from the caller: SOURCE, BUILD, WORK, C_COMPILER, CXX_COMPILER, LAUNCHER,
# SANITIZE.
set(PREFIX "${WORK}/moved")

# Runs a command and stops with its output where it fails.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message("${output}")
    message(FATAL_ERROR "failed (${result}): ${command}")
  endif()
endfunction()

# Configures and builds a project in folder that finds the installed package, and no other.
function(build_against_package project folder)
  set(sanitizer_flags)
  if(SANITIZE)
    set(sanitizer_flags "-fsanitize=${SANITIZE} -fno-sanitize-recover=all")
  endif()
  file(REMOVE_RECURSE "${folder}")
  run(${CMAKE_COMMAND} -S "${project}" -B "${folder}" -G Ninja "-DCMAKE_PREFIX_PATH=${PREFIX}"
    "-DCMAKE_C_COMPILER=${C_COMPILER}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}" "-DCMAKE_CXX_FLAGS=${sanitizer_flags}")
  file(STRINGS "${folder}/CMakeCache.txt" found REGEX "^tegotae_DIR:")
  string(FIND "${found}" "=${PREFIX}/" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "find_package took another tegotae: ${found}")
  endif()
  run(${CMAKE_COMMAND} --build "${folder}" --parallel 2)
endfunction()
