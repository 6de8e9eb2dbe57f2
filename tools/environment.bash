# shellcheck shell=bash
# SPDX-License-Identifier: Apache-2.0
#
# Sourced by the scripts that build: Debian's own tools and libraries only, whatever compilers, Pythons or package
# prefixes stand first in the caller's environment.
export PATH=/usr/bin:/bin:/usr/sbin:/sbin
unset CC CXX CFLAGS CXXFLAGS CPPFLAGS LDFLAGS CPATH C_INCLUDE_PATH CPLUS_INCLUDE_PATH LIBRARY_PATH LD_LIBRARY_PATH \
  LD_RUN_PATH PKG_CONFIG_PATH CMAKE_PREFIX_PATH CMAKE_GENERATOR CMAKE_TOOLCHAIN_FILE CMAKE_BUILD_TYPE DESTDIR \
  CDPATH NINJA_STATUS

# How many compilers run at once: one a core, and no more than one a 1.5 GB of free memory (Eigen is heavy).
build_jobs() {
  local cores free_kilobytes jobs
  if [[ ${CMAKE_BUILD_PARALLEL_LEVEL:-} =~ ^[1-9][0-9]*$ ]]; then
    printf '%s\n' "$CMAKE_BUILD_PARALLEL_LEVEL"
    return
  fi
  cores=$(nproc)
  free_kilobytes=$(awk '$1 == "MemAvailable:" { print $2 }' /proc/meminfo)
  jobs=$((free_kilobytes / 1500000))
  ((jobs < cores)) || jobs=$cores
  ((jobs > 0)) || jobs=1
  printf '%s\n' "$jobs"
}
