# SPDX-License-Identifier: MIT
# Debian packages: `cmake --workflow --preset debian` makes them in build/debian. Each component of the installation is one.
set(CPACK_GENERATOR DEB)
if(NOT CPACK_PACKAGE_CONTACT)  # whoever publishes the packages gives an address
  set(CPACK_PACKAGE_CONTACT "the coppermoon authors <coppermoon@localhost>")
endif()
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "bakes eclipsed Moons: textures and pictures in real units of light")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/.cmake/debian_papers.cmake)
set(CPACK_COMPONENTS_ALL)

# coppermoon_package(COMPONENT NAME SECTION section [DEPENDS packages] [RECOMMENDS packages] TEXT lines)
function(coppermoon_package component name)
  cmake_parse_arguments(DEB "" "DEPENDS;RECOMMENDS;SECTION;TEXT" "" ${ARGN})
  string(TOUPPER ${component} COMPONENT)
  foreach(variable DEPENDS RECOMMENDS SECTION)
    if(DEB_${variable})
      set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_${variable} "${DEB_${variable}}" PARENT_SCOPE)
    endif()
  endforeach()
  set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${COMPONENT}_DESCRIPTION "${DEB_TEXT}" PARENT_SCOPE)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
endfunction()

set(same "(= ${PROJECT_VERSION})")
set(about "coppermoon simulates sunlight that the Earth's air bends, reddens and\ndims, lights a map of the Moon with it, and writes that as a texture.")
coppermoon_package(program coppermoon SECTION graphics
  DEPENDS "tzdata" RECOMMENDS "povray, povray-includes, gnuplot-nox, fonts-dejavu-core, ffmpeg, libavif-bin"
  TEXT "${about}")
file(STRINGS packages.debian libraries REGEX "^(lib|zlib|nlohmann).*-dev$")
list(JOIN libraries ", " libraries)
coppermoon_package(development libcoppermoon-dev SECTION libdevel DEPENDS "${libraries}"
  TEXT "${about}\nThis package has the library for C++.")
coppermoon_package(openimageio coppermoon-openimageio SECTION graphics DEPENDS "coppermoon ${same}"
  TEXT "${about}\nThis package lets programs that read images through OpenImageIO read\nan eclipse.")
if(TARGET coppermoon_python)
  get_target_property(minor coppermoon_python PYTHON_MINOR)
  math(EXPR next "${minor} + 1")
  coppermoon_package(python python3-coppermoon SECTION python
    DEPENDS "python3 (>= 3.${minor}), python3 (<< 3.${next}), python3-numpy"
    TEXT "${about}\nThis package has it for Python 3, as NumPy arrays.")
  # modules are compiled when the package is installed, and what was compiled goes with it, as with all of Debian's
  foreach(script postinst prerm)
    set(does py3compile)
    if(script STREQUAL "prerm")
      set(does py3clean)
    endif()
    file(CONFIGURE OUTPUT debian/${script} CONTENT "#!/bin/sh\nset -e\nif command -v ${does} >/dev/null 2>&1; then\n  ${does} -p python3-coppermoon\nfi\n"
         @ONLY)
    file(CHMOD ${PROJECT_BINARY_DIR}/debian/${script} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
    list(APPEND CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/debian/${script})
  endforeach()
endif()
include(CPack)
