# `cmake --install`: three components, which are also the three Debian packages.
#   program: the binary, its manual page and completions      library: libvelarium.so      development: headers and such
find_program(GZIP gzip REQUIRED)
set(man_page ${PROJECT_BINARY_DIR}/velarium.1.gz)
set(changelog ${PROJECT_BINARY_DIR}/changelog.gz)
set(debian_changelog ${PROJECT_BINARY_DIR}/changelog.Debian.gz)
set(package_release 1)  # of the Debian packages, where the same version is packaged again
set(completions "")
add_custom_command(OUTPUT ${man_page} DEPENDS velarium_app VERBATIM
  COMMAND velarium_app options --man > ${PROJECT_BINARY_DIR}/velarium.1
  COMMAND ${GZIP} -9nkf ${PROJECT_BINARY_DIR}/velarium.1)
add_custom_command(OUTPUT ${changelog} COMMAND ${GZIP} -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md > ${changelog}
  DEPENDS ${PROJECT_SOURCE_DIR}/CHANGELOG.md VERBATIM)
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)  # of SOURCE_DATE_EPOCH, where that is set
configure_file(cmake/changelog.debian.in ${PROJECT_BINARY_DIR}/changelog.Debian @ONLY)
add_custom_command(OUTPUT ${debian_changelog} COMMAND ${GZIP} -9nkf ${PROJECT_BINARY_DIR}/changelog.Debian
  DEPENDS ${PROJECT_BINARY_DIR}/changelog.Debian VERBATIM)
foreach(shell bash zsh fish)
  set(script ${PROJECT_BINARY_DIR}/completion.${shell})
  add_custom_command(OUTPUT ${script} COMMAND velarium_app completion ${shell} > ${script} DEPENDS velarium_app VERBATIM)
  list(APPEND completions ${script})
endforeach()
add_custom_target(shell_pages ALL DEPENDS ${man_page} ${changelog} ${debian_changelog} ${completions})

install(TARGETS velarium_app RUNTIME COMPONENT program)
install(FILES ${man_page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/completion.bash RENAME velarium COMPONENT program
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${PROJECT_BINARY_DIR}/completion.zsh RENAME _velarium COMPONENT program
        DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${PROJECT_BINARY_DIR}/completion.fish RENAME velarium.fish COMPONENT program
        DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

install(TARGETS velarium_shared EXPORT velarium
        LIBRARY COMPONENT library NAMELINK_COMPONENT development)
install(DIRECTORY include/velarium DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)

# No dependency shows in the headers, so the exported target is the whole configuration.
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/velarium)
install(EXPORT velarium FILE velariumConfig.cmake NAMESPACE velarium:: DESTINATION ${config_folder}
        COMPONENT development)
include(CMakePackageConfigHelpers)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/velariumConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/velariumConfigVersion.cmake DESTINATION ${config_folder} COMPONENT development)

# Relative to the file itself, so that an installed tree may be moved.
file(RELATIVE_PATH prefix_from_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/velarium.pc.in ${PROJECT_BINARY_DIR}/velarium.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/velarium.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

foreach(owner "program:velarium" "library:libvelarium${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}"
        "development:libvelarium-dev")
  string(REPLACE ":" ";" owner ${owner})
  list(GET owner 0 component)
  list(GET owner 1 package)
  set(doc_folder ${CMAKE_INSTALL_DATADIR}/doc/${package})
  install(FILES LICENSE RENAME copyright DESTINATION ${doc_folder} COMPONENT ${component})
  install(FILES ${changelog} ${debian_changelog} DESTINATION ${doc_folder} COMPONENT ${component})
endforeach()
