include(CMakePackageConfigHelpers)

install(DIRECTORY include/jauscat schemas/jauscat DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
install(TARGETS jauscat jauscat_net EXPORT jauscat-targets)
install(EXPORT jauscat-targets NAMESPACE jauscat:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/jauscat)

write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/jauscat-config-version.cmake
    COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES cmake/jauscat-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/jauscat-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/jauscat)
