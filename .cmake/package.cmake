# SPDX-License-Identifier: MIT
include(CMakePackageConfigHelpers)
set(where ${CMAKE_INSTALL_LIBDIR}/cmake/coppermoon)
install(EXPORT coppermoon NAMESPACE coppermoon:: DESTINATION ${where} FILE coppermoonTargets.cmake)
configure_package_config_file(.cmake/coppermoonConfig.cmake.in coppermoonConfig.cmake INSTALL_DESTINATION ${where})
write_basic_package_version_file(coppermoonConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/coppermoonConfig.cmake ${PROJECT_BINARY_DIR}/coppermoonConfigVersion.cmake
              .cmake/dependencies.cmake DESTINATION ${where})
