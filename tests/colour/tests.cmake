# SPDX-License-Identifier: MIT
coppermoon_tests(colour LINKS coppermoon::colour coppermoon::surface PkgConfig::OpenImageIO
  QUICK bracket cie_observer difference display exposure limb photograph point_spread similarity working_space
  HEAVY limb_in_jpeg registration)

set(config ${PROJECT_SOURCE_DIR}/colour/config.ocio)
set(prefix ${PROJECT_BINARY_DIR}/colour_config_installed)
find_program(OCIOCHECK ociocheck)
if(OCIOCHECK)
  add_test(NAME colour/config/passes_ociocheck COMMAND ${OCIOCHECK} --iconfig ${config})
  set_tests_properties(colour/config/passes_ociocheck PROPERTIES FAIL_REGULAR_EXPRESSION "ERROR;failed")
endif()
add_test(NAME colour/config/installs COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR}
         --prefix ${prefix} --component colour_config)
add_test(NAME colour/config/is_installed_as_it_is COMMAND ${CMAKE_COMMAND} -E compare_files
         ${config} ${prefix}/${CMAKE_INSTALL_DATADIR}/coppermoon/config.ocio)
set_tests_properties(colour/config/installs PROPERTIES FIXTURES_SETUP colour_config)
set_tests_properties(colour/config/is_installed_as_it_is PROPERTIES FIXTURES_REQUIRED colour_config)
