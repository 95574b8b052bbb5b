# Installs the headers, a package for find_package(jauscat) and files for pkg-config: the targets jauscat::jauscat and
# jauscat::text, and jauscat::esi, jauscat::net and jauscat::compiled where what they need is there
# (find_package(jauscat COMPONENTS net) insists on it). All of it is in the component "development"; the tools, if they are
# built, are in the component "tools", the Wireshark dissector in "wireshark". With JAUSCAT_INSTALL_COMPILED the component
# "compiled" has the libraries that users compile otherwise; find_package takes them where they are.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_DATADIR}/cmake/jauscat) # the same for every machine, so not beside libraries
set(pc_dir ${CMAKE_INSTALL_DATADIR}/pkgconfig)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)

install(DIRECTORY include/jauscat schemas/jauscat DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.hpp" PATTERN "*.ipp")
install(FILES schemas/JausConfig.xsd DESTINATION ${CMAKE_INSTALL_DATADIR}/jauscat)
install(TARGETS jauscat jauscat_text EXPORT jauscat-targets)
install(EXPORT jauscat-targets NAMESPACE jauscat:: DESTINATION ${package_dir})
# jauscat::catalogue, jauscat::catalogue_sae and jauscat::compiled are compiled by their users: what is installed is the same
# for every machine.
install(DIRECTORY src DESTINATION ${CMAKE_INSTALL_DATADIR}/jauscat)
install(FILES cmake/catalogue.cmake cmake/jsidl.cmake DESTINATION ${package_dir})
# jauscat::live, too.
if(TARGET jauscat_live)
    install(FILES cmake/live.cmake cmake/live_page.cmake DESTINATION ${package_dir})
    install(DIRECTORY tools/web/ DESTINATION ${CMAKE_INSTALL_DATADIR}/jauscat/web
            FILES_MATCHING PATTERN "*.html" PATTERN "*.css" PATTERN "*.js")
endif()
if(TARGET jauscat_esi_files)
    install(TARGETS jauscat_esi_files EXPORT jauscat-esi-targets)
    install(EXPORT jauscat-esi-targets NAMESPACE jauscat:: DESTINATION ${package_dir})
endif()
if(TARGET jauscat_net)
    install(TARGETS jauscat_net EXPORT jauscat-net-targets)
    install(EXPORT jauscat-net-targets NAMESPACE jauscat:: DESTINATION ${package_dir})
    install(FILES cmake/compiled.cmake DESTINATION ${package_dir})
endif()

set(compiled_pc_files)
if(JAUSCAT_INSTALL_COMPILED)
    foreach(library catalogue catalogue_sae compiled)
        if(TARGET jauscat_${library})
            string(REPLACE "_" "-" file jauscat-${library})
            set_target_properties(jauscat_${library} PROPERTIES EXPORT_NAME ${library} EXCLUDE_FROM_ALL OFF)
            install(TARGETS jauscat_${library} EXPORT ${file}-library COMPONENT compiled)
            install(EXPORT ${file}-library NAMESPACE jauscat:: DESTINATION ${package_dir} COMPONENT compiled)
            list(APPEND compiled_pc_files ${file}.pc)
        endif()
    endforeach()
endif()

write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/jauscat-config-version.cmake
    COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES cmake/jauscat-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/jauscat-config-version.cmake
        DESTINATION ${package_dir})

file(RELATIVE_PATH prefix_from_pc ${CMAKE_INSTALL_PREFIX}/${pc_dir} ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" prefix_from_pc ${prefix_from_pc})
set(pc_files jauscat.pc)
if(TARGET jauscat_esi_files)
    list(APPEND pc_files jauscat-esi.pc)
endif()
if(TARGET jauscat_net)
    list(APPEND pc_files jauscat-net.pc)
endif()
foreach(file IN LISTS pc_files)
    configure_file(cmake/${file}.in ${CMAKE_CURRENT_BINARY_DIR}/${file} @ONLY)
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${file} DESTINATION ${pc_dir})
endforeach()
foreach(file IN LISTS compiled_pc_files)
    configure_file(cmake/${file}.in ${CMAKE_CURRENT_BINARY_DIR}/${file} @ONLY)
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${file} DESTINATION ${pc_dir} COMPONENT compiled)
endforeach()
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# With a prefix of ~/.local this is where Wireshark looks for the scripts of a user.
install(FILES tools/wireshark/jauscat.lua DESTINATION ${CMAKE_INSTALL_LIBDIR}/wireshark/plugins COMPONENT wireshark)

foreach(tool communicator jausdump jauscat_ecat jauscat_esi jauscat_jsidl)
    if(TARGET ${tool})
        install(TARGETS ${tool} RUNTIME COMPONENT tools)
    endif()
endforeach()

# The component "python": the folder is that of Debian's Python.
if(TARGET jauscat_python)
    set(JAUSCAT_PYTHON_FOLDER lib/python3/dist-packages CACHE STRING "Folder below the prefix for Python packages")
    install(TARGETS jauscat_python LIBRARY DESTINATION ${JAUSCAT_PYTHON_FOLDER}/jauscat COMPONENT python)
    install(FILES python/jauscat/__init__.py python/jauscat/__init__.pyi python/jauscat/py.typed
            DESTINATION ${JAUSCAT_PYTHON_FOLDER}/jauscat COMPONENT python)
endif()
