# cmake --install: headers, library, package files for find_package(tank_datum) and pkg-config.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/tank_datum)

install(TARGETS tank_datum_library EXPORT tank_datum-targets COMPONENT library)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/tank_datum ${PROJECT_BINARY_DIR}/include/tank_datum
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp")
install(EXPORT tank_datum-targets NAMESPACE tank_datum:: DESTINATION ${package_dir} COMPONENT library)

string(REGEX MATCH "^([0-9]+)[.]([0-9]+)" TANK_DATUM_PCL_SERIES ${TANK_DATUM_PCL_VERSION})
math(EXPR next_minor "${CMAKE_MATCH_2} + 1")
set(TANK_DATUM_PCL_NEXT_SERIES ${CMAKE_MATCH_1}.${next_minor})
set(tank_datum_QA_DIR ${CMAKE_INSTALL_DATADIR}/tank_datum/python)
set(tank_datum_BIN_DIR ${CMAKE_INSTALL_BINDIR})
configure_package_config_file(cmake/tank_datum-config.cmake.in tank_datum-config.cmake
                              INSTALL_DESTINATION ${package_dir} PATH_VARS tank_datum_QA_DIR tank_datum_BIN_DIR)
write_basic_package_version_file(tank_datum-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/tank_datum-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/tank_datum-config-version.cmake cmake/tank_datum-pcl.cmake
              cmake/tank_datum-qa.cmake
        DESTINATION ${package_dir} COMPONENT library)

file(RELATIVE_PATH TANK_DATUM_PREFIX_FROM_PC /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
if(NOT BUILD_SHARED_LIBS)
  set(TANK_DATUM_PC_STATIC_LIBS " -llzf -lxxhash -lsleef -llz4 -lcrypto ${OpenMP_CXX_FLAGS}")
endif()
configure_file(cmake/tank_datum.pc.in tank_datum.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/tank_datum.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT library)

# tank_datum_qa, which needs Python alone
file(RELATIVE_PATH TANK_DATUM_QA_FROM_BIN /${CMAKE_INSTALL_BINDIR} /${tank_datum_QA_DIR})
configure_file(cmake/tank_datum_qa.in tank_datum_qa @ONLY)
install(PROGRAMS ${CMAKE_CURRENT_BINARY_DIR}/tank_datum_qa DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT commands)
install(DIRECTORY python/tank_datum_qa DESTINATION ${tank_datum_QA_DIR} COMPONENT commands FILES_MATCHING PATTERN "*.py")
