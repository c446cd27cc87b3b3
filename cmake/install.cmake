# What `cmake --install` leaves for other projects: find_package(isomatch) and pkg-config.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/isomatch)
install(TARGETS isomatch EXPORT isomatch_targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY include/isomatch ${PROJECT_BINARY_DIR}/include/isomatch
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
        FILES_MATCHING PATTERN "*.h")
install(EXPORT isomatch_targets NAMESPACE isomatch:: FILE isomatch-targets.cmake
        DESTINATION ${package_folder} COMPONENT development)
configure_package_config_file(cmake/isomatch-config.cmake.in isomatch-config.cmake
                              INSTALL_DESTINATION ${package_folder})
# Before 1.0 a minor version may break what the one before it promised.
write_basic_package_version_file(isomatch-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/isomatch-config.cmake
              ${PROJECT_BINARY_DIR}/isomatch-config-version.cmake
        DESTINATION ${package_folder} COMPONENT development)

# From where isomatch.pc lies, so that an installed tree may be moved.
file(RELATIVE_PATH pkg_config_prefix
     ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/isomatch.pc.in isomatch.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/isomatch.pc
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

if(ISOMATCH_BUILD_TOOLS)
  install(TARGETS isomatch_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  install(FILES README.md CHANGELOG.md LICENSE
          DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/isomatch COMPONENT program)
  install(FILES cluster/array.sbatch
          DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/isomatch COMPONENT program)
endif()
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/libisomatch-dev
        COMPONENT development)
