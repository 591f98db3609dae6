# SPDX-License-Identifier: MIT
# Installs what was built, then builds and runs a project outside that finds it as anyone would.
set(prefix ${PROJECT_BINARY_DIR}/package/prefix)
set(consumer ${PROJECT_BINARY_DIR}/package/consumer)

add_test(NAME package/installs COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${prefix})
add_test(NAME package/consumer_is_configured COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer
         -B ${consumer} --fresh -G ${CMAKE_GENERATOR} -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}
         -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
         "-DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}")
add_test(NAME package/consumer_is_built COMMAND ${CMAKE_COMMAND} --build ${consumer})
add_test(NAME package/consumer_runs COMMAND ${consumer}/consumer)
set_tests_properties(package/consumer_runs PROPERTIES PASS_REGULAR_EXPRESSION
  "greatest 2008-02-21T03:2[56]:..Z\ndeveloped 0.537[01]\ntexel 0.25\npixel 32.00 32.00\nchannels 1, albedo 0.0\n")
add_test(NAME package/program_runs COMMAND ${prefix}/${CMAKE_INSTALL_BINDIR}/coppermoon --version)
set_tests_properties(package/program_runs PROPERTIES PASS_REGULAR_EXPRESSION "coppermoon ${PROJECT_VERSION}")

set_tests_properties(package/installs PROPERTIES FIXTURES_SETUP package_installed)
set_tests_properties(package/consumer_is_configured PROPERTIES
                     FIXTURES_REQUIRED package_installed FIXTURES_SETUP consumer_configured)
set_tests_properties(package/consumer_is_built PROPERTIES
                     FIXTURES_REQUIRED consumer_configured FIXTURES_SETUP consumer_built)
set_tests_properties(package/consumer_runs PROPERTIES FIXTURES_REQUIRED consumer_built)
set_tests_properties(package/program_runs PROPERTIES FIXTURES_REQUIRED package_installed)
foreach(step installs consumer_is_configured consumer_is_built consumer_runs program_runs)
  set_tests_properties(package/${step} PROPERTIES LABELS package TIMEOUT 300)
endforeach()
