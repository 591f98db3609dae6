# SPDX-License-Identifier: MIT
# Libraries of the portable archive: those that the program and its module need, but for the C library. What only reads DICOM,
# HEIF, movies, OpenVDB and webcams is left out, with two hundred libraries behind it, and what CFITSIO fetches addresses
# with: OpenImageIO and CFITSIO get empty libraries of these names, whose functions throw an error that says so.
cmake_policy(VERSION 3.25)
set(into $ENV{DESTDIR}${CMAKE_INSTALL_PREFIX})
set(left_out "^lib(opencv_|dcm|oflog|ofstd|av|sw|openvdb|heif|curl)")
set(readers)

file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${portable_program} MODULES ${portable_images} RESOLVED_DEPENDENCIES_VAR found
     UNRESOLVED_DEPENDENCIES_VAR unknown
     PRE_EXCLUDE_REGEXES "^ld-linux" "^lib(c|m|dl|pthread|rt|resolv)\\.so" ${left_out})
if(unknown)
  message(FATAL_ERROR "libraries not found: ${unknown}")
endif()

# Adds to `lines` what a command prints.
function(lines_of lines)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^\n]+" all "${printed}")
  set(${lines} ${all} PARENT_SCOPE)
endfunction()

foreach(library ${found})
  file(INSTALL ${library} DESTINATION ${into}/${libraries} FOLLOW_SYMLINK_CHAIN)
  file(REAL_PATH ${library} real)
  get_filename_component(file ${real} NAME)  # dpkg may know it in /lib where it now stands in /usr/lib
  execute_process(COMMAND dpkg -S */${file} OUTPUT_VARIABLE owner COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCH "^[^:]+" package "${owner}")
  file(COPY_FILE /usr/share/doc/${package}/copyright ${work}_copyright)
  file(INSTALL ${work}_copyright DESTINATION ${into}/${licences} RENAME ${package})
  if(library MATCHES "/lib(OpenImageIO|cfitsio)\\.so")
    list(APPEND readers ${library})
  endif()
endforeach()

# Empty libraries in place of those that these two name and the archive leaves out.
lines_of(needed objdump -p ${readers})
list(FILTER needed INCLUDE REGEX NEEDED)
list(TRANSFORM needed REPLACE "^ *NEEDED *" "")
list(REMOVE_DUPLICATES needed)
list(FILTER needed INCLUDE REGEX ${left_out})
lines_of(called nm -D --undefined-only --with-symbol-versions ${readers})
list(TRANSFORM called REPLACE "^ *[A-Za-z] " "")
foreach(name ${needed})
  execute_process(COMMAND ${compiler} -print-file-name=${name} OUTPUT_VARIABLE whole OUTPUT_STRIP_TRAILING_WHITESPACE)
  lines_of(defined nm -D --defined-only --with-symbol-versions ${whole})
  list(TRANSFORM defined REPLACE "^[0-9a-f]* *[A-Za-z] " "")
  list(TRANSFORM defined REPLACE "@@" "@")
  set(assembly)
  set(versions)
  foreach(symbol ${called})
    if(NOT symbol IN_LIST defined)
      continue()
    endif()
    string(REGEX REPLACE "@.*" "" plain ${symbol})
    set(does refuse)
    if(plain MATCHES "DiRegister")  # a static object of DCMTK's headers, made and destroyed whatever is read
      set(does nothing)
    endif()
    string(APPEND assembly ".globl ${plain}\n.type ${plain}, @function\n.set ${plain}, coppermoon_${does}\n")
    string(REGEX MATCH "[^@]+$" version ${symbol})
    if(symbol MATCHES "@")
      string(APPEND in_${version} " ${plain};")
      list(APPEND versions ${version})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES versions)
  set(map)
  foreach(version ${versions})
    string(APPEND map "${version} {${in_${version}} };\n")
    unset(in_${version})
  endforeach()
  set(source ${work}/${name})
  file(WRITE ${source}.cpp "#include <stdexcept>
#define OURS extern \"C\" [[gnu::used, gnu::visibility(\"hidden\")]]
OURS void coppermoon_nothing() {}
OURS void coppermoon_refuse() {
  throw std::runtime_error(\"DICOM, HEIF, movies, OpenVDB and addresses are not read by the portable archive of coppermoon\");
}
asm(R\"(${assembly})\");
")
  file(WRITE ${source}.map "${map}")
  set(script)
  if(versions)
    set(script -Wl,--version-script=${source}.map)
  endif()
  execute_process(COMMAND ${compiler} -shared -fPIC -O1 -s -Wl,-soname,${name} ${script} ${source}.cpp -o ${source}
                  COMMAND_ERROR_IS_FATAL ANY)
  file(INSTALL ${source} DESTINATION ${into}/${libraries})
endforeach()
