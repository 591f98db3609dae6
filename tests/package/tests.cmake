# SPDX-License-Identifier: MIT
# Installs what was built, then builds and runs projects outside that find it as anyone would.
set(package ${PROJECT_BINARY_DIR}/package)
set(prefix ${package}/prefix)
get_property(stages GLOBAL PROPERTY COPPERMOON_STAGES)
list(TRANSFORM stages PREPEND coppermoon_)
add_dependencies(heavy_tests ${stages} coppermoon_program coppermoon_imageio coppermoon_blender coppermoon_manual_pages)  # all that
                 # is installed

# package_test(NAME [NEEDS steps …] COMMAND …): package/NAME, a step that others may need.
function(package_test name)
  cmake_parse_arguments(PARSE_ARGV 1 STEP "" "" "NEEDS;COMMAND")
  add_test(NAME package/${name} COMMAND ${STEP_COMMAND})
  list(TRANSFORM STEP_NEEDS PREPEND package/)
  set_tests_properties(package/${name} PROPERTIES LABELS package TIMEOUT 300
                       FIXTURES_SETUP package/${name} FIXTURES_REQUIRED "${STEP_NEEDS}")
endfunction()

# outside_project(NAME [FOLDER folder] [ENVIRONMENT A=B …] [NOT_BUILT]): the project NAME in tests/package, or in another
# folder, is configured against what was installed, and built.
function(outside_project name)
  cmake_parse_arguments(PARSE_ARGV 1 OUTSIDE "NOT_BUILT" "FOLDER" "ENVIRONMENT")
  if(NOT OUTSIDE_FOLDER)
    set(OUTSIDE_FOLDER ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/${name})
  endif()
  package_test(${name}_is_configured NEEDS installs COMMAND ${CMAKE_COMMAND} -S ${OUTSIDE_FOLDER} -B ${package}/${name}
    --fresh -G ${CMAKE_GENERATOR} -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}
    -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
    "-DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}")
  set_tests_properties(package/${name}_is_configured PROPERTIES ENVIRONMENT "${OUTSIDE_ENVIRONMENT}")
  if(NOT OUTSIDE_NOT_BUILT)
    package_test(${name}_is_built NEEDS ${name}_is_configured COMMAND ${CMAKE_COMMAND} --build ${package}/${name})
  endif()
endfunction()

# outside_program(PROJECT NAME PRINTS regular expression): a program of that project, and what it is held to.
function(outside_program project name prints expected)
  package_test(${name}_runs NEEDS ${project}_is_built COMMAND ${package}/${project}/${name})
  set_tests_properties(package/${name}_runs PROPERTIES PASS_REGULAR_EXPRESSION "${expected}"
                       WORKING_DIRECTORY ${package}/${project})
endfunction()

package_test(prefix_is_empty COMMAND ${CMAKE_COMMAND} -E rm -rf ${prefix})
package_test(installs NEEDS prefix_is_empty COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${prefix})
package_test(files_are_installed NEEDS installs COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR}
  -DSHARE=${prefix}/${CMAKE_INSTALL_DATADIR}/coppermoon -DDOC=${prefix}/${CMAKE_INSTALL_DOCDIR}
  -DMANUALS=${prefix}/${CMAKE_INSTALL_MANDIR} -DDATA=${prefix}/${CMAKE_INSTALL_DATADIR}
  -DINCLUDE=${prefix}/${CMAKE_INSTALL_INCLUDEDIR} -DVERSION=${PROJECT_VERSION} -P ${CMAKE_CURRENT_LIST_DIR}/installed_files.cmake)
package_test(program_runs NEEDS installs COMMAND ${prefix}/${CMAKE_INSTALL_BINDIR}/coppermoon --version)
set_tests_properties(package/program_runs PROPERTIES PASS_REGULAR_EXPRESSION "coppermoon ${PROJECT_VERSION}")
# with the module that has OpenImageIO, from where it was installed
package_test(program_bakes NEEDS installs COMMAND ${prefix}/${CMAKE_INSTALL_BINDIR}/coppermoon bake 2008-02-21T03:26:05Z
  --texture-width 64 --albedo-map built-in --bands 4 --rays 60 -o ${package}/moon.exr)
set_tests_properties(package/program_bakes PROPERTIES PASS_REGULAR_EXPRESSION "moon.exr: made in .* s, within")

# the Python package, with the module beside it, which says what is wrong with a map
if(TARGET coppermoon_python)
  add_dependencies(heavy_tests coppermoon_python)
  package_test(python_imports NEEDS installs COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${prefix}/${COPPERMOON_PYTHON_DIR}
    ${COPPERMOON_PYTHON} -c "import coppermoon; print(coppermoon.__file__)
try: coppermoon.bake('2018-07-27T20:21:45Z', albedo_map='/dev/null')
except coppermoon.Error as error: print(error)")
  set_tests_properties(package/python_imports PROPERTIES
                       PASS_REGULAR_EXPRESSION "${prefix}/${COPPERMOON_PYTHON_DIR}/coppermoon/__init__.py\n/dev/null: ")
endif()

# the reader that OpenImageIO loads, with the program that was installed
file(WRITE ${package}/moon.eclipse "instant = \"2018-07-27T20:00:00Z\"\nunshadowed = true\nalbedo-map = \"built-in\"\ntexture-width = 64\n")
package_test(reader_reads NEEDS installs COMMAND ${CMAKE_COMMAND} -E env XDG_CACHE_HOME=${package}/cache
  OIIO_LIBRARY_PATH=${prefix}/${CMAKE_INSTALL_LIBDIR}/OpenImageIO oiiotool --info ${package}/moon.eclipse)
set_tests_properties(package/reader_reads PROPERTIES PASS_REGULAR_EXPRESSION "64 x   32, 3 channel, half eclipse")

outside_project(consumer)
outside_program(consumer consumer PRINTS
  "its own texture/image.h\ngreatest 2008-02-21T03:2[56]:..Z\ndeveloped 0.537[01]\ntexel 0.25\npixel 32.00 32.00\n\
channels 1, albedo 0.0\n")
outside_project(each_alone)
# twenty programs, of which tests/thorough.sh alone builds each
set_tests_properties(package/each_alone_is_configured package/each_alone_is_built PROPERTIES LABELS slow_package)

# A machine without OpenImageIO and OpenColorIO, as far as pkg-config sees.
pkg_get_variable(erfa_folder erfa pcfiledir)
configure_file(${erfa_folder}/erfa.pc ${package}/erfa_alone/erfa.pc COPYONLY)
set(erfa_alone PKG_CONFIG_LIBDIR=${package}/erfa_alone PKG_CONFIG_PATH=)
outside_project(contacts ENVIRONMENT ${erfa_alone})
outside_program(contacts contacts PRINTS
  "T17:14:..Z\n.*T18:24:..Z\n.*T19:30:..Z\n.*T21:13:..Z\n.*T22:19:..Z\n.*T23:28:..Z\n")  # the published minutes
package_test(contacts_loads_little NEEDS contacts_is_built COMMAND ${CMAKE_COMMAND} -DPROGRAM=${package}/contacts/contacts
  "-DNONE_OF=lib(OpenImageIO|OpenColorIO|opencv|OpenEXR|tbb)[^ ]*" -P ${CMAKE_CURRENT_LIST_DIR}/loads.cmake)
outside_project(components ENVIRONMENT ${erfa_alone} NOT_BUILT)

# The examples of the library, each held to what it prints; the umbra to what the command prints too.
outside_project(library FOLDER ${PROJECT_SOURCE_DIR}/examples/library)
outside_program(library eclipse_contacts PRINTS "P1 +2018-07-27T17:14.*greatest 2018-07-27T20:21.*P4 +2018-07-27T23:28")
outside_program(library umbra_profile PRINTS "550 and 650 nm\n0,[^\n]*\n2000,[^\n]*\n4000,[^\n]*\n5000,[^\n]*\n$")
outside_program(library moon_texture PRINTS "moon_acescg.exr, error [0-9.e-]+\n$")
outside_program(library moon_picture PRINTS "moon.png, exposed for [0-9.]+ s\n$")
outside_program(library fitted_air PRINTS "dust [23]\\.[0-9]e-06 1/m, cloud cover 0\\.[345][0-9]*, .*; explained\n$")
package_test(umbra_profile_is_the_commands NEEDS library_is_built COMMAND ${CMAKE_COMMAND}
  -DPROGRAM=${package}/library/umbra_profile -DCOPPERMOON=${prefix}/${CMAKE_INSTALL_BINDIR}/coppermoon
  -P ${CMAKE_CURRENT_LIST_DIR}/same_numbers.cmake)
package_test(eclipse_contacts_loads_little NEEDS library_is_built COMMAND ${CMAKE_COMMAND}
  -DPROGRAM=${package}/library/eclipse_contacts "-DNONE_OF=lib(OpenImageIO|OpenColorIO|opencv|OpenEXR|tbb)[^ ]*"
  -P ${CMAKE_CURRENT_LIST_DIR}/loads.cmake)
