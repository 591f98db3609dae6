# SPDX-License-Identifier: MIT
# Portable archive: `cmake --workflow --preset portable` makes build/portable/coppermoon-VERSION-linux-x86_64.tar.xz, the
# program with the libraries that it needs, for any Linux of the C library that it was built with, or a later one. The
# preset windows makes build/windows/coppermoon-VERSION-windows-x86_64.zip; there the libraries are in the program.
set(CPACK_GENERATOR TXZ)
set(CPACK_STRIP_FILES ON)
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program)
set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
set(CPACK_PACKAGE_FILE_NAME coppermoon-${PROJECT_VERSION}-linux-${CMAKE_SYSTEM_PROCESSOR})
if(WIN32)
  set(CPACK_GENERATOR ZIP)
  set(CPACK_PACKAGE_FILE_NAME coppermoon-${PROJECT_VERSION}-windows-x86_64)
endif()
set(CPACK_ARCHIVE_PROGRAM_FILE_NAME ${CPACK_PACKAGE_FILE_NAME})
if(WIN32)  # which has no links: each name of a time zone is a file
  install(DIRECTORY ${CMAKE_FIND_ROOT_PATH}/licences DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program PATTERN .made EXCLUDE)
  install(CODE "set(zones \$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR})
execute_process(COMMAND cp -RL /usr/share/zoneinfo \${zones} COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE \${zones}/zoneinfo/right \${zones}/zoneinfo/posix \${zones}/zoneinfo/localtime)" COMPONENT program)
  include(CPack)
  return()
endif()
# DT_RPATH, for libraries of libraries are looked for in it too; in DT_RUNPATH they are not
set_target_properties(coppermoon_program PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
target_link_options(coppermoon_program PRIVATE LINKER:--disable-new-dtags)
install(DIRECTORY /usr/share/zoneinfo DESTINATION ${CMAKE_INSTALL_DATADIR} COMPONENT program
        PATTERN right EXCLUDE PATTERN posix EXCLUDE)
install(CODE "set(portable_program \"$<TARGET_FILE:coppermoon_program>\")
set(portable_images \"$<TARGET_FILE:coppermoon_images>\")
set(compiler \"${CMAKE_CXX_COMPILER}\")
set(work \"${PROJECT_BINARY_DIR}/left_out\")
set(libraries \"${CMAKE_INSTALL_LIBDIR}\")
set(licences \"${CMAKE_INSTALL_DOCDIR}/licences\")" COMPONENT program)
install(SCRIPT .cmake/portable_libraries.cmake COMPONENT program)
include(CPack)
