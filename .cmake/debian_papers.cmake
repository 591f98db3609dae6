# SPDX-License-Identifier: MIT
# Of each package, before it is packed: its copyright and changelog as Debian has them, manual pages compressed.
cmake_policy(VERSION 3.25)
get_filename_component(source ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
file(READ ${source}/LICENSE license)
string(REGEX MATCH "Copyright[^\n]*" copyright "${license}")
string(REGEX REPLACE "^MIT License\n\n[^\n]*\n\n" "" license "${license}")
string(REPLACE "\n\n" "\n.\n" license "${license}")
string(REGEX REPLACE "\n([^\n])" "\n \\1" license " ${license}")
string(REGEX REPLACE "^Copyright \\(c\\) " "" holder "${copyright}")
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)

foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} COMPONENT)
  set(name ${CPACK_DEBIAN_${COMPONENT}_PACKAGE_NAME})
  set(root ${CPACK_TEMPORARY_DIRECTORY}/${component})
  if(NOT IS_DIRECTORY ${root})
    continue()
  endif()
  set(papers ${root}/usr/share/doc/${name})
  file(REMOVE ${root}/usr/share/doc/coppermoon/LICENSE)
  file(WRITE ${papers}/copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: coppermoon

Files: *
Copyright: ${holder}
License: Expat

Files: colour/data/camera_spectra.csv
Copyright: Academy Software Foundation and contributors to rawtoaces-data
License: Apache-2.0

License: Expat
${license}

License: Apache-2.0
 On Debian systems the text of this licence is in /usr/share/common-licenses/Apache-2.0.
")
  file(WRITE ${papers}/changelog "${name} (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium

  * See CHANGELOG.md of the package coppermoon.

 -- ${CPACK_PACKAGE_CONTACT}  ${now}
")
  file(GLOB_RECURSE pages ${root}/usr/share/man/*.1)
  execute_process(COMMAND gzip -9nf ${papers}/changelog ${pages} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
