# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.25)
# Fails when a file that goes with the program is not installed as it stands in the source, or a header is that nobody
# should see.
#   cmake -DROOT=<source folder> -DSHARE=<its data> -DDOC=<its documents> -DINCLUDE=<its headers>
#         -DMANUALS=<its manual pages> -DDATA=<folder of all data> -DVERSION=<of the project> -P installed_files.cmake
function(check_same file installed)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${ROOT}/${file} ${installed} RESULT_VARIABLE differs)
  if(differs)
    message(FATAL_ERROR "${installed}: is not ${file}")
  endif()
endfunction()

foreach(name LICENSE README.md CHANGELOG.md)
  check_same(${name} ${DOC}/${name})
endforeach()
check_same(docs/index.md ${DOC}/docs/index.md)
check_same(povray_scenes/coppermoon.inc ${SHARE}/coppermoon.inc)
check_same(colour/config.ocio ${SHARE}/config.ocio)

# Blender's add-on is one folder of Python, which says one version.
set(unpacked ${SHARE}/../../add_on)
file(REMOVE_RECURSE ${unpacked})
file(ARCHIVE_EXTRACT INPUT ${SHARE}/coppermoon_blender.zip DESTINATION ${unpacked})
file(GLOB_RECURSE parts RELATIVE ${unpacked} ${unpacked}/*)
list(REMOVE_ITEM parts coppermoon/parameters.json)  # the program's words, made in the build
list(LENGTH parts count)
foreach(part ${parts})
  string(REGEX REPLACE "^coppermoon/" "baker/wrappers/blender/" source ${part})
  check_same(${source} ${unpacked}/${part})
endforeach()
file(GLOB sources ${ROOT}/baker/wrappers/blender/*.py ${ROOT}/baker/wrappers/blender/*.toml)
list(LENGTH sources expected)
file(STRINGS ${ROOT}/baker/wrappers/blender/blender_manifest.toml manifest REGEX "^version = \"${VERSION}\"$")
string(REPLACE "." ", " tuple ${VERSION})
file(STRINGS ${ROOT}/baker/wrappers/blender/__init__.py said REGEX "\"version\": \\(${tuple}\\)")
if(NOT count EQUAL expected OR NOT manifest OR NOT said)
  message(FATAL_ERROR "coppermoon_blender.zip: holds ${count} files of ${expected}, or says another version than ${VERSION}")
endif()
foreach(recipe first_eclipse telescope volcanic_south)
  check_same(examples/${recipe}.toml ${SHARE}/recipes/${recipe}.toml)
endforeach()

foreach(file ${MANUALS}/man1/coppermoon.1 ${MANUALS}/man1/coppermoon-still.1
             ${DATA}/bash-completion/completions/coppermoon ${DATA}/zsh/site-functions/_coppermoon
             ${DATA}/fish/vendor_completions.d/coppermoon.fish)
  if(NOT EXISTS ${file})
    message(FATAL_ERROR "${file}: is not installed")
  endif()
endforeach()

file(GLOB_RECURSE headers ${INCLUDE}/*)
list(LENGTH headers count)
if(count LESS 50 OR NOT EXISTS ${INCLUDE}/coppermoon/eclipse/contacts.h OR EXISTS ${INCLUDE}/coppermoon/eclipse/lunation.h)
  message(FATAL_ERROR "${INCLUDE}: ${count} headers; contacts.h is public, lunation.h is not")
endif()
foreach(header ${headers})
  if(NOT header MATCHES "^${INCLUDE}/coppermoon/(uses/)?[^/]+/[^/]+\\.h$")
    message(FATAL_ERROR "${header}: stands outside the folders of components")
  endif()
  file(STRINGS ${header} wrong REGEX "include[ \t]*\"" )
  list(FILTER wrong EXCLUDE REGEX "\"coppermoon/")
  if(wrong)
    message(FATAL_ERROR "${header}: ${wrong}")
  endif()
endforeach()
message(STATUS "${count} headers")
