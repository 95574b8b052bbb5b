# Installs the headers and a package for find_package(jauscat): the target jauscat::jauscat, and jauscat::net where what it
# needs is there (find_package(jauscat COMPONENTS net) insists on it).
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/jauscat)

install(DIRECTORY include/jauscat schemas/jauscat DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
install(FILES schemas/JausConfig.xsd DESTINATION ${CMAKE_INSTALL_DATADIR}/jauscat)
install(TARGETS jauscat EXPORT jauscat-targets)
install(EXPORT jauscat-targets NAMESPACE jauscat:: DESTINATION ${package_dir})
if(TARGET jauscat_net)
    install(TARGETS jauscat_net EXPORT jauscat-net-targets)
    install(EXPORT jauscat-net-targets NAMESPACE jauscat:: DESTINATION ${package_dir})
endif()

write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/jauscat-config-version.cmake
    COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES cmake/jauscat-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/jauscat-config-version.cmake
        DESTINATION ${package_dir})
