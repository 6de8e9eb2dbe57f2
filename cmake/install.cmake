# SPDX-License-Identifier: Apache-2.0
include(CMakePackageConfigHelpers)

install(TARGETS tegotae_core tegotae_mujoco tegotae_stream tegotae_lab tegotae EXPORT tegotae-targets)
install(DIRECTORY tegotae DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h")
install(DIRECTORY scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/tegotae)
install(FILES tools/split/split.js tools/split/package.json DESTINATION ${CMAKE_INSTALL_DATADIR}/tegotae/split)
install(EXPORT tegotae-targets NAMESPACE tegotae:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/tegotae)
configure_package_config_file(cmake/tegotae-config.cmake.in tegotae-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/tegotae PATH_VARS CMAKE_INSTALL_DATADIR)
write_basic_package_version_file(tegotae-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/tegotae-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/tegotae-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/tegotae)
