# Headers keep their folders, so that their relative includes hold in the installed tree too. Those
# that need Boost are for geom's sources alone.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS crossloft EXPORT crossloft-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
if(CROSSLOFT_BUILD_CLI)
  install(TARGETS crossloft_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
foreach(room IN LISTS CROSSLOFT_ROOMS)
  install(DIRECTORY ${room} DESTINATION include/crossloft FILES_MATCHING PATTERN "*.h" PATTERN homogeneous.h EXCLUDE
          PATTERN lattice_reduction.h EXCLUDE PATTERN strategies EXCLUDE)
endforeach()

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/crossloft)
install(EXPORT crossloft-targets NAMESPACE crossloft:: DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/crossloft-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES cmake/crossloft-config.cmake ${PROJECT_BINARY_DIR}/crossloft-config-version.cmake
        DESTINATION ${package_folder})
