# SPDX-License-Identifier: MIT
# coppermoon_stage(NAME [IN FOLDER] [COMPILED_QUICKLY] HEADERS … SOURCES … APART … ALONE … TABLES … BYTES … NEEDS earlier stages … USES libraries … PRIVATELY libraries …)
# makes folder NAME a static library with the alias coppermoon::NAME, and a component of the package, which installs
# HEADERS: they are included as NAME/…, or as FOLDER/NAME/… with IN FOLDER. TABLES are CSV (or other text) files under
# data/, or made in the build, and compiled in: NAME/tables.h declares `std::string_view <file name without ending>()`.
# BYTES are files of any kind there, taken in by the assembler as they are.
# ALONE are sources that are never compiled together with others (CMAKE_UNITY_BUILD): Highway compiles each once for every
# kind of vector. APART are compiled together, but not with SOURCES: a program that calls none of them has none of them.
# COMPILED_QUICKLY compiles SOURCES at -O1 (-O0 in Debug), for what is long there is the work of other stages; APART
# always are. Without SOURCES the stage is a name for all that it needs.
set(coppermoon_compiled_quickly $<$<CONFIG:Release>:-O1> $<$<CONFIG:Debug>:-O0>)
function(coppermoon_stage name)
  cmake_parse_arguments(STAGE "COMPILED_QUICKLY" "ROOT;IN" "HEADERS;SOURCES;APART;ALONE;TABLES;BYTES;NEEDS;USES;PRIVATELY" ${ARGN})
  if(NOT STAGE_ROOT)
    set(STAGE_ROOT ${CMAKE_CURRENT_SOURCE_DIR})
  endif()
  cmake_path(GET STAGE_ROOT PARENT_PATH base)
  if(STAGE_IN)
    cmake_path(GET base PARENT_PATH base)
  endif()
  set(generated)
  if(STAGE_TABLES OR STAGE_BYTES)
    coppermoon_tables(${name} ${STAGE_ROOT} generated "${STAGE_TABLES}" "${STAGE_BYTES}")
  endif()
  list(TRANSFORM STAGE_HEADERS PREPEND ${STAGE_ROOT}/)
  list(TRANSFORM STAGE_SOURCES PREPEND ${STAGE_ROOT}/)
  list(TRANSFORM STAGE_APART PREPEND ${STAGE_ROOT}/)
  list(TRANSFORM STAGE_ALONE PREPEND ${STAGE_ROOT}/)
  set_source_files_properties(${STAGE_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  list(TRANSFORM STAGE_NEEDS PREPEND coppermoon::)
  if(NOT STAGE_SOURCES)
    add_library(coppermoon_${name} INTERFACE)
    add_library(coppermoon::${name} ALIAS coppermoon_${name})
    target_link_libraries(coppermoon_${name} INTERFACE ${STAGE_NEEDS})
    target_include_directories(coppermoon_${name} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    set_target_properties(coppermoon_${name} PROPERTIES EXPORT_NAME ${name})
    set_property(GLOBAL APPEND PROPERTY COPPERMOON_STAGES ${name})
    return()
  endif()
  add_library(coppermoon_${name} STATIC ${STAGE_SOURCES} ${STAGE_ALONE} ${generated})
  add_library(coppermoon::${name} ALIAS coppermoon_${name})
  target_include_directories(coppermoon_${name}
    PUBLIC $<BUILD_INTERFACE:${base}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_BINARY_DIR}/generated)
  target_link_libraries(coppermoon_${name} PUBLIC ${STAGE_NEEDS} ${STAGE_USES} PRIVATE ${STAGE_PRIVATELY})
  target_compile_features(coppermoon_${name} PUBLIC cxx_std_20)
  set_target_properties(coppermoon_${name} PROPERTIES EXPORT_NAME ${name})
  if(STAGE_APART)  # a target of their own: options of a source take it out of CMake's unity build
    add_library(coppermoon_${name}_apart OBJECT ${STAGE_APART})
    target_include_directories(coppermoon_${name}_apart PRIVATE ${base} ${PROJECT_BINARY_DIR}/generated)
    target_link_libraries(coppermoon_${name}_apart PRIVATE ${STAGE_NEEDS} ${STAGE_USES} ${STAGE_PRIVATELY})
    target_compile_features(coppermoon_${name}_apart PRIVATE cxx_std_20)
    target_compile_options(coppermoon_${name}_apart PRIVATE ${coppermoon_compiled_quickly})
    coppermoon_warnings(coppermoon_${name}_apart)
    target_sources(coppermoon_${name} PRIVATE $<TARGET_OBJECTS:coppermoon_${name}_apart>)
  endif()
  if(STAGE_COMPILED_QUICKLY)
    target_compile_options(coppermoon_${name} PRIVATE ${coppermoon_compiled_quickly})
  endif()
  coppermoon_warnings(coppermoon_${name})
  set_property(GLOBAL APPEND PROPERTY COPPERMOON_STAGES ${name})
  # Public headers are a target of their own, for they are installed otherwise than CMake would install a FILE_SET
  # (.cmake/headers.cmake). all_verify_interface_header_sets compiles each by itself.
  add_library(coppermoon_${name}_headers INTERFACE)
  target_sources(coppermoon_${name}_headers INTERFACE FILE_SET HEADERS BASE_DIRS ${base} FILES ${STAGE_HEADERS})
  target_link_libraries(coppermoon_${name}_headers INTERFACE coppermoon_${name})
  set_target_properties(coppermoon_${name}_headers PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON)
endfunction()

function(coppermoon_tables name root out texts bytes)
  set(dir ${PROJECT_BINARY_DIR}/generated/${name})
  set(declarations "// Generated from ${name}/data.\n#pragma once\n#include <string_view>\nnamespace coppermoon::${name}::tables {\n")
  set(sources)
  foreach(table ${texts})
    get_filename_component(stem ${table} NAME_WE)
    cmake_path(ABSOLUTE_PATH table BASE_DIRECTORY ${root}/data NORMALIZE OUTPUT_VARIABLE file)  # or beside data, as ../NAME
    string(APPEND declarations "std::string_view ${stem}();\n")
    set(source ${dir}/${stem}.cpp)
    add_custom_command(OUTPUT ${source}
      COMMAND ${CMAKE_COMMAND} -DIN=${file} -DOUT=${source} -DSPACE=coppermoon::${name}::tables
              -DSTEM=${stem} -P ${PROJECT_SOURCE_DIR}/.cmake/embed.cmake
      DEPENDS ${file} ${PROJECT_SOURCE_DIR}/.cmake/embed.cmake VERBATIM)
    list(APPEND sources ${source})
  endforeach()
  foreach(table ${bytes})
    get_filename_component(stem ${table} NAME_WE)
    string(APPEND declarations "std::string_view ${stem}();\n")
    set(file ${root}/data/${table})
    set(symbol coppermoon_${stem})
    set(space coppermoon::${name}::tables)
    configure_file(${PROJECT_SOURCE_DIR}/.cmake/embed_bytes.cpp.in ${dir}/${stem}.cpp @ONLY)
    set_source_files_properties(${dir}/${stem}.cpp PROPERTIES OBJECT_DEPENDS ${file} SKIP_UNITY_BUILD_INCLUSION ON)
    list(APPEND sources ${dir}/${stem}.cpp)
  endforeach()
  file(CONFIGURE OUTPUT ${dir}/tables.h CONTENT "${declarations}}\n" @ONLY)
  set(${out} ${sources} PARENT_SCOPE)
endfunction()

function(coppermoon_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
  if(COPPERMOON_STRICT)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
