# SPDX-License-Identifier: MIT
# Other programs, given what coppermoon makes: tests/hand_off.sh installs and runs them.
coppermoon_test_program(hand_off hand_off "blender;blender_add_on;job;mitsuba;moon_and_stars;raw;shader;side_by_side;stellarium;three_films;tools" "coppermoon::verbs;PkgConfig::OpenImageIO")
target_compile_definitions(${program} PRIVATE COPPERMOON_ADD_ON="${PROJECT_BINARY_DIR}/coppermoon_blender.zip"
                           COPPERMOON_HAND_OFF_PYTHON="${PROJECT_BINARY_DIR}/hand_off/python"
                           COPPERMOON_HAND_OFF_BLENDER="${PROJECT_BINARY_DIR}/hand_off/blender_newest"
                           COPPERMOON_READERS="$<TARGET_FILE_DIR:coppermoon_imageio>"
                           COPPERMOON_HAND_OFF_READERS="${PROJECT_BINARY_DIR}/hand_off/gltf")
add_dependencies(${program} coppermoon_blender coppermoon_imageio)
foreach(noun blender blender_add_on job mitsuba moon_and_stars raw shader side_by_side stellarium three_films tools)
  add_test(NAME hand_off/${noun} COMMAND ${program} ${noun})
  set_tests_properties(hand_off/${noun} PROPERTIES LABELS hand_off TIMEOUT 900)
endforeach()

# PyPI's programs, which pip puts into the build folder; and older versions of Blender, each by itself.
set(python ${PROJECT_BINARY_DIR}/hand_off/python)
set(pinned ${PROJECT_SOURCE_DIR}/packages.hand_off.pypi)
add_test(NAME hand_off/python_is_installed
         COMMAND sh -c "python3 -m venv ${python} && ${python}/bin/pip install --quiet --no-deps --requirement ${pinned}")
set_tests_properties(hand_off/python_is_installed PROPERTIES FIXTURES_SETUP python LABELS hand_off TIMEOUT 600)
set_tests_properties(hand_off/job hand_off/mitsuba PROPERTIES FIXTURES_REQUIRED python)
file(STRINGS ${pinned} newest REGEX "^bpy==")
string(REPLACE "bpy==" "" newest ${newest})
set(tried BlenderAddOn.*:-*WorksInAWindow:*CyclesRendersARecipe)  # no window, nor Debian's OpenImageIO
foreach(version 4.2.23 4.5.15 ${newest})
  set(venv ${PROJECT_BINARY_DIR}/hand_off/blender_${version})
  set(script ${venv}/programs/blender)
  add_test(NAME hand_off/blender_${version}_is_installed
           COMMAND sh -c "python3 -m venv ${venv} &&
             sed -n \"/^# Blender's/,/^# Mitsuba's/p\" ${pinned} >${venv}/pinned && echo bpy==${version} >>${venv}/pinned &&
             ${venv}/bin/pip install --quiet --no-deps --requirement ${venv}/pinned && mkdir -p ${venv}/programs &&
             printf '#!/bin/sh\\nexec ${venv}/bin/python ${CMAKE_CURRENT_LIST_DIR}/blender_of_bpy.py \"$@\"\\n' >${script} &&
             chmod +x ${script} && ln -sfn blender_${newest} ${PROJECT_BINARY_DIR}/hand_off/blender_newest")
  add_test(NAME hand_off/add_on_in_blender_${version}
           COMMAND ${CMAKE_COMMAND} -E env "PATH=${venv}/programs:$ENV{PATH}" $<TARGET_FILE:${program}> --gtest_filter=${tried})
  set_tests_properties(hand_off/blender_${version}_is_installed PROPERTIES FIXTURES_SETUP blender_${version})
  set_tests_properties(hand_off/add_on_in_blender_${version} PROPERTIES FIXTURES_REQUIRED blender_${version})
  set_tests_properties(hand_off/blender_${version}_is_installed hand_off/add_on_in_blender_${version}
                       PROPERTIES LABELS hand_off TIMEOUT 900)
endforeach()

# A film's stage, read by OpenUSD.
set(staged ${PROJECT_BINARY_DIR}/hand_off/stage)
add_test(NAME hand_off/stage/is_made
         COMMAND coppermoon_program animate 2018-07-27 --at Nairobi --tolerance 0.3% --frames 13 --make textures --texture-width 512
                 --replace -o ${staged} --stage ${staged}/film.usda)
set_tests_properties(hand_off/stage/is_made PROPERTIES FIXTURES_SETUP stage LABELS hand_off TIMEOUT 300)
add_test(NAME hand_off/stage/is_read COMMAND ${python}/bin/python ${CMAKE_CURRENT_LIST_DIR}/check_stage.py ${staged}/film.usda $<TARGET_FILE:coppermoon_program>)
add_test(NAME hand_off/stage/validators_find_nothing
         COMMAND ${python}/bin/python ${CMAKE_CURRENT_LIST_DIR}/validate.py ${staged}/film.usda)
set_tests_properties(hand_off/stage/is_read hand_off/stage/validators_find_nothing
                     PROPERTIES FIXTURES_REQUIRED "python;stage" LABELS hand_off TIMEOUT 300 ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)

# Blender 5 renders a stage: by twilight, with the Moon low, and by night.
foreach(moment 18:40 20:40)
  string(REPLACE ":" "" folder ${moment})
  add_test(NAME hand_off/stage/blender_renders_${folder}
           COMMAND ${python}/bin/python ${CMAKE_CURRENT_LIST_DIR}/render_stage.py $<TARGET_FILE:coppermoon_program>
                   ${PROJECT_BINARY_DIR}/hand_off/stage_${folder} Budapest 2018-07-27T${moment}Z)
  set_tests_properties(hand_off/stage/blender_renders_${folder} PROPERTIES FIXTURES_REQUIRED python LABELS hand_off TIMEOUT 300)
endforeach()

# OpenUSD's and MaterialX's own validators.
set(validated ${PROJECT_BINARY_DIR}/hand_off/validated)
file(MAKE_DIRECTORY ${validated})
add_test(NAME hand_off/validators/files_are_made
         COMMAND coppermoon_program bake 2018-07-27T19:20:00Z --albedo-map built-in --texture-width 256 -o moon_acescg.exr -o moon.usda
                 -o moon.usdz)
add_test(NAME hand_off/validators/a_shader_is_made COMMAND coppermoon_program shader 2018-07-27 --bands 20 -o eclipse)
set_tests_properties(hand_off/validators/files_are_made hand_off/validators/a_shader_is_made PROPERTIES FIXTURES_SETUP validated LABELS hand_off TIMEOUT 300
                     WORKING_DIRECTORY ${validated})
add_test(NAME hand_off/validators/find_nothing
         COMMAND ${python}/bin/python ${CMAKE_CURRENT_LIST_DIR}/validate.py moon.usda moon.usdz
                 eclipse/eclipse.mtlx)
set_tests_properties(hand_off/validators/find_nothing PROPERTIES FIXTURES_REQUIRED "python;validated" LABELS hand_off TIMEOUT 300
                     WORKING_DIRECTORY ${validated} ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)

# glTF, USD and MaterialX as others read them: Khronos' validator, three.js, tinyusdz, MaterialX's shader generator. npm puts them into the build folder.
set(readers ${PROJECT_BINARY_DIR}/hand_off/gltf)
foreach(file package.json package-lock.json places.mjs check_glb.mjs check_usda.mjs generate_mtlx.mjs)
  configure_file(hand_off/gltf/${file} ${readers}/${file} COPYONLY)
endforeach()
add_executable(hand_off_gltf_write_models hand_off/gltf/write_models.cpp)
target_link_libraries(hand_off_gltf_write_models PRIVATE coppermoon::texture)
coppermoon_warnings(hand_off_gltf_write_models)
set(a_bake bake 2018-07-27T19:20:00Z --albedo-map built-in --texture-width 512)
add_test(NAME hand_off/gltf/readers_are_installed COMMAND npm ci --no-audit --no-fund)
add_test(NAME hand_off/gltf/models_are_written COMMAND hand_off_gltf_write_models ${readers})
add_test(NAME hand_off/gltf/a_bake_is_written
         COMMAND coppermoon_program ${a_bake} -o bake.glb -o bake_lin_rec709.glb -o moon_lin_rec709.exr -o bake.usda)
set_tests_properties(hand_off/gltf/readers_are_installed hand_off/gltf/models_are_written hand_off/gltf/a_bake_is_written
                     PROPERTIES FIXTURES_SETUP gltf)
add_test(NAME hand_off/gltf/glb_is_read COMMAND node check_glb.mjs moon.glb)
add_test(NAME hand_off/gltf/usda_is_read COMMAND node check_usda.mjs moon.usda)
add_test(NAME hand_off/gltf/glb_of_a_bake_is_read COMMAND node check_glb.mjs bake.glb)
add_test(NAME hand_off/gltf/glb_in_cd_m2_is_read COMMAND node check_glb.mjs bake_lin_rec709.glb)
add_test(NAME hand_off/gltf/usda_of_a_bake_is_read COMMAND node check_usda.mjs bake.usda)
set_tests_properties(hand_off/shader PROPERTIES FIXTURES_REQUIRED "blender_${newest};gltf")
set(checks glb_is_read usda_is_read glb_of_a_bake_is_read glb_in_cd_m2_is_read usda_of_a_bake_is_read)
foreach(check ${checks})
  set_tests_properties(hand_off/gltf/${check} PROPERTIES FIXTURES_REQUIRED gltf)
endforeach()
foreach(step readers_are_installed models_are_written a_bake_is_written ${checks})
  set_tests_properties(hand_off/gltf/${step} PROPERTIES LABELS hand_off TIMEOUT 300 WORKING_DIRECTORY ${readers})
endforeach()

# Colour spaces as OpenImageIO 3.2, Blender 5, OpenUSD, MaterialX and OpenColorIO 2.6 find them: PyPI's, the same environment.
set(made ${PROJECT_BINARY_DIR}/hand_off/colour)
set(config ${PROJECT_BINARY_DIR}/colour/config_aces2.ocio)
add_test(NAME hand_off/colour/files_are_made
         COMMAND sh ${CMAKE_CURRENT_LIST_DIR}/colour/make_files.sh $<TARGET_FILE:coppermoon_program> ${made})
set_tests_properties(hand_off/colour/files_are_made PROPERTIES FIXTURES_SETUP colour)
foreach(tool openimageio blender usd materialx)
  add_test(NAME hand_off/colour/${tool}_finds_spaces
           COMMAND ${python}/bin/python ${CMAKE_CURRENT_LIST_DIR}/colour/check_files.py ${tool} ${made})
  list(APPEND colour_checks ${tool}_finds_spaces)
endforeach()
add_test(NAME hand_off/colour/opencolorio_shows_the_same
         COMMAND ${python}/bin/python ${CMAKE_CURRENT_LIST_DIR}/colour/check_views.py ${config})
add_test(NAME hand_off/colour/passes_ociocheck COMMAND ${python}/bin/ociocheck --iconfig ${config})
set_tests_properties(hand_off/colour/passes_ociocheck PROPERTIES FAIL_REGULAR_EXPRESSION "Warning;ERROR;failed")
list(APPEND colour_checks opencolorio_shows_the_same passes_ociocheck)
foreach(check ${colour_checks})
  set_tests_properties(hand_off/colour/${check} PROPERTIES FIXTURES_REQUIRED "colour;python")
endforeach()
foreach(step files_are_made ${colour_checks})
  set_tests_properties(hand_off/colour/${step} PROPERTIES LABELS hand_off TIMEOUT 600 ENVIRONMENT PYTHONDONTWRITEBYTECODE=1)
endforeach()

# Light scattered into the shadow, as sasktran2 has it.
add_executable(hand_off_write_twilight hand_off/scattered_light/write_twilight.cpp)
target_link_libraries(hand_off_write_twilight PRIVATE coppermoon::shadow nlohmann_json::nlohmann_json)
coppermoon_warnings(hand_off_write_twilight)
add_test(NAME hand_off/scattered_light
         COMMAND ${python}/bin/python ${CMAKE_CURRENT_LIST_DIR}/scattered_light/check_twilight.py $<TARGET_FILE:hand_off_write_twilight>)
set_tests_properties(hand_off/scattered_light PROPERTIES FIXTURES_REQUIRED python LABELS hand_off TIMEOUT 600)

# The Python package under NumPy 2: Debian's is NumPy 1, with which the package's own tests run.
if(TARGET coppermoon_python)
  set(venv ${PROJECT_BINARY_DIR}/hand_off/numpy2)
  file(STRINGS ${pinned} numpy2 REGEX "^(#numpy|OpenImageIO)==")  # Debian's OpenImageIO knows NumPy 1 alone
  list(TRANSFORM numpy2 REPLACE "#" "")
  list(JOIN numpy2 " " numpy2)
  add_test(NAME hand_off/numpy2/is_installed
           COMMAND sh -c "${COPPERMOON_PYTHON} -m venv ${venv} && ${venv}/bin/pip install --quiet ${numpy2}")
  set_tests_properties(hand_off/numpy2/is_installed PROPERTIES FIXTURES_SETUP numpy2 LABELS hand_off TIMEOUT 300)
  foreach(noun behaviour numbers)
    add_test(NAME hand_off/numpy2/${noun}
             COMMAND ${venv}/bin/python ${PROJECT_SOURCE_DIR}/tests/baker/wrappers/python/${noun}_test.py)
    set_tests_properties(hand_off/numpy2/${noun} PROPERTIES FIXTURES_REQUIRED numpy2 LABELS hand_off TIMEOUT 600
                         ENVIRONMENT
                         "PYTHONPATH=${PROJECT_BINARY_DIR}/python;PYTHONDONTWRITEBYTECODE=1;COPPERMOON_TEST_DATA=${PROJECT_SOURCE_DIR}/tests;COPPERMOON_PROGRAM=$<TARGET_FILE:coppermoon_program>")
  endforeach()
endif()
