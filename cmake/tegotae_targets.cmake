# SPDX-License-Identifier: Apache-2.0

# Warnings, definitions and sanitizers that every target of this project is built with.
function(tegotae_compile_settings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    -Wnon-virtual-dtor -Woverloaded-virtual -Werror)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # g++ 12 reports false positives inside Eigen and the standard library at -O3.
    target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized -Wno-array-bounds -Wno-stringop-overflow)
    if(TEGOTAE_SANITIZE MATCHES "thread")
      # Boost.Asio's fences, which ThreadSanitizer does not know; what they order is locked as well.
      target_compile_options(${target} PRIVATE -Wno-tsan)
    endif()
  endif()
  if(TEGOTAE_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${TEGOTAE_SANITIZE} -fno-omit-frame-pointer
      -fno-sanitize-recover=all)
    target_link_options(${target} PRIVATE -fsanitize=${TEGOTAE_SANITIZE})
  endif()
endfunction()

# tegotae_library(NAME LAYER...): a library tegotae_NAME (tegotae::NAME) of all sources in tegotae/LAYER/.
function(tegotae_library name)
  set(sources)
  foreach(layer IN LISTS ARGN)
    file(GLOB layer_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tegotae/${layer}/*.cpp")
    list(APPEND sources ${layer_sources})
  endforeach()
  add_library(tegotae_${name} ${sources})
  add_library(tegotae::${name} ALIAS tegotae_${name})
  set_target_properties(tegotae_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(tegotae_${name} PUBLIC cxx_std_20)
  target_include_directories(tegotae_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  tegotae_compile_settings(tegotae_${name})
  if(NOT TEGOTAE_SANITIZE)
    # One by one, whatever the scripts ask for: so each source, and the header that stands first in it, is shown to
    # include what it needs. The test of the installed headers relies on it.
    set_target_properties(tegotae_${name} PROPERTIES UNITY_BUILD OFF)
  endif()
endfunction()
