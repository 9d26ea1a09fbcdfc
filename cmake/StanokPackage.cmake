# What `cmake --install` puts where, and the Debian package (`cpack --config build/release/CPackConfig.cmake`).
include(GNUInstallDirs)

# Five programs are installed; tests and benchmarks need not be built for it.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)

install(DIRECTORY ${CMAKE_SOURCE_DIR}/programs/cycles ${CMAKE_SOURCE_DIR}/programs/examples
                  ${CMAKE_SOURCE_DIR}/config/machines
        DESTINATION ${CMAKE_INSTALL_DATADIR}/stanok)
# Post-processors of CAM systems; one of them is a command.
install(DIRECTORY ${CMAKE_SOURCE_DIR}/posts DESTINATION ${CMAKE_INSTALL_DATADIR}/stanok USE_SOURCE_PERMISSIONS
        PATTERN __pycache__ EXCLUDE)
# The page of stanok-web, as it was built.
if(EXISTS ${CMAKE_SOURCE_DIR}/panel/dist)
  install(DIRECTORY ${CMAKE_SOURCE_DIR}/panel/dist/ DESTINATION ${CMAKE_INSTALL_DATADIR}/stanok/panel)
endif()
install(DIRECTORY ${CMAKE_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${CMAKE_SOURCE_DIR}/README.md ${CMAKE_SOURCE_DIR}/SECURITY.md
              ${CMAKE_SOURCE_DIR}/CHANGELOG.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES ${CMAKE_SOURCE_DIR}/packaging/stanokd@.service ${CMAKE_SOURCE_DIR}/packaging/stanok-web@.service
              ${CMAKE_SOURCE_DIR}/packaging/stanok-gateway.service ${CMAKE_SOURCE_DIR}/packaging/stanok-opcua.service
        DESTINATION lib/systemd/system)
install(FILES ${CMAKE_SOURCE_DIR}/packaging/stanok.sysusers
        DESTINATION lib/sysusers.d RENAME stanok.conf)

# Shell completion comes from the command table of the program itself.
install(CODE "
  set(folder \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}\")
  foreach(file bash:bash-completion/completions/stanok zsh:zsh/vendor-completions/_stanok
               fish:fish/vendor_completions.d/stanok.fish)
    string(REGEX MATCH \"^[a-z]+\" shell \"\${file}\")
    string(REGEX REPLACE \"^[a-z]+:\" \"\${folder}/\" path \"\${file}\")
    get_filename_component(parent \"\${path}\" DIRECTORY)
    file(MAKE_DIRECTORY \"\${parent}\")
    execute_process(COMMAND $<TARGET_FILE:stanok> completion \${shell} OUTPUT_FILE \"\${path}\"
                    COMMAND_ERROR_IS_FATAL ANY)
  endforeach()")

# So do its manual pages; those of the other four are written by hand, tests/manual_test.sh compares their options.
install(CODE "
  set(folder \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1\")
  execute_process(COMMAND $<TARGET_FILE:stanok> manual \"\${folder}\" COMMAND_ERROR_IS_FATAL ANY)")
set(manual_pages ${CMAKE_BINARY_DIR}/man)
foreach(page stanokd.8 stanok-web.8 stanok-gateway.8 stanok-opcua.8 stanok-drives.1)
  configure_file(${CMAKE_SOURCE_DIR}/packaging/man/${page}.in ${manual_pages}/${page} @ONLY)
endforeach()
install(FILES ${manual_pages}/stanokd.8 ${manual_pages}/stanok-web.8 ${manual_pages}/stanok-gateway.8
              ${manual_pages}/stanok-opcua.8
        DESTINATION ${CMAKE_INSTALL_MANDIR}/man8)
install(FILES ${manual_pages}/stanok-drives.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)

# The server of OPC UA runs as it is; its packages are fetched by npm (docs/integrator/opc-ua.md).
install(PROGRAMS ${CMAKE_SOURCE_DIR}/opcua/stanok-opcua.js DESTINATION lib/stanok/opcua)
install(FILES ${CMAKE_SOURCE_DIR}/opcua/package.json ${CMAKE_SOURCE_DIR}/opcua/package-lock.json
              ${CMAKE_SOURCE_DIR}/opcua/.npmrc
        DESTINATION lib/stanok/opcua)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/opcua/source DESTINATION lib/stanok/opcua)
install(CODE "
  set(folder \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_BINDIR}\")
  file(CREATE_LINK ../lib/stanok/opcua/stanok-opcua.js \"\${folder}/stanok-opcua\" SYMBOLIC)")

# The Python package goes into a package of its own, where it was built.
if(TARGET stanok_python_native)
  set(python_folder lib/python3/dist-packages/stanok)
  install(TARGETS stanok_python_native LIBRARY DESTINATION ${python_folder} COMPONENT python OPTIONAL)
  install(FILES ${python_sources} DESTINATION ${python_folder} COMPONENT python)
  install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-stanok
          RENAME copyright COMPONENT python)
  install(DIRECTORY ${CMAKE_SOURCE_DIR}/python/notebooks/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-stanok/notebooks
          COMPONENT python FILES_MATCHING PATTERN "*.ipynb")
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL Unspecified)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME stanok)
set(CPACK_COMPONENT_UNSPECIFIED_DESCRIPTION "Daemon, command line, page for the browser, simulated drives, examples, documents")
if(TARGET stanok_python_native)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-stanok)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION
      "Simulations, logs, kinematics and grinding cycles of the CNC runtime stanok as NumPy arrays")
  # The module is made for one version of Python.
  math(EXPR python_next "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${python_next}), python3-numpy, stanok (= ${PROJECT_VERSION})")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS python3-matplotlib)
  set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_SOURCE_DIR}/cmake/StanokPackageParts.cmake)
  set(CPACK_STANOK_PYTHON_FOLDER ${python_package})
  set(CPACK_STANOK_BUILD ${CMAKE_BINARY_DIR})
endif()
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "the stanok project")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_RECOMMENDS "gnuplot-nox, bash-completion, nodejs (>= 18)")
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_CONTROL_EXTRA ${CMAKE_SOURCE_DIR}/packaging/postinst)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
