# SPDX-License-Identifier: MIT
coppermoon_tests(colour LINKS coppermoon::colour coppermoon::surface PkgConfig::OpenImageIO
  QUICK bracket camera_spectra cie_observer circles difference disc_features display exposure glow moon_limb photograph picture_part point_spread similarity tone_curve
        working_space
  HEAVY limb_in_jpeg registration)
coppermoon_computing_tests(colour moon_limb limb_in_jpeg registration)
target_compile_definitions(colour_quick_tests PRIVATE COPPERMOON_BUILT="${PROJECT_BINARY_DIR}")

find_program(OCIOCHECK ociocheck)
if(OCIOCHECK)
  add_test(NAME colour/config/passes_ociocheck COMMAND ${OCIOCHECK} --iconfig
           ${PROJECT_SOURCE_DIR}/colour/config.ocio)
  set_tests_properties(colour/config/passes_ociocheck PROPERTIES FAIL_REGULAR_EXPRESSION "ERROR;failed")
endif()
