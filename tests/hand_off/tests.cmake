# SPDX-License-Identifier: MIT
# Other programs, given what coppermoon makes: tests/hand_off.sh installs and runs them.
coppermoon_test_program(hand_off hand_off "blender;blender_add_on;mitsuba;moon_and_stars;raw;shader;side_by_side;stellarium;tools" "coppermoon::verbs;PkgConfig::OpenImageIO")
target_compile_definitions(${program} PRIVATE COPPERMOON_ADD_ON="${PROJECT_BINARY_DIR}/coppermoon_blender.zip"
                           COPPERMOON_HAND_OFF_PYTHON="${PROJECT_BINARY_DIR}/hand_off/python"
                           COPPERMOON_READERS="$<TARGET_FILE_DIR:coppermoon_imageio>"
                           COPPERMOON_HAND_OFF_READERS="${PROJECT_BINARY_DIR}/hand_off/gltf")
add_dependencies(${program} coppermoon_blender coppermoon_imageio)
foreach(noun blender blender_add_on mitsuba moon_and_stars raw shader side_by_side stellarium tools)
  add_test(NAME hand_off/${noun} COMMAND ${program} ${noun})
  set_tests_properties(hand_off/${noun} PROPERTIES LABELS hand_off TIMEOUT 900)
endforeach()

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
         COMMAND coppermoon_program ${a_bake} -o bake.glb -o moon_lin_rec709.exr -o bake.usda)
set_tests_properties(hand_off/gltf/readers_are_installed hand_off/gltf/models_are_written hand_off/gltf/a_bake_is_written
                     PROPERTIES FIXTURES_SETUP gltf)
add_test(NAME hand_off/gltf/glb_is_read COMMAND node check_glb.mjs moon.glb)
add_test(NAME hand_off/gltf/usda_is_read COMMAND node check_usda.mjs moon.usda)
add_test(NAME hand_off/gltf/glb_of_a_bake_is_read COMMAND node check_glb.mjs bake.glb)
add_test(NAME hand_off/gltf/usda_of_a_bake_is_read COMMAND node check_usda.mjs bake.usda)
set_tests_properties(hand_off/shader PROPERTIES FIXTURES_REQUIRED gltf)
set(checks glb_is_read usda_is_read glb_of_a_bake_is_read usda_of_a_bake_is_read)
foreach(check ${checks})
  set_tests_properties(hand_off/gltf/${check} PROPERTIES FIXTURES_REQUIRED gltf)
endforeach()
foreach(step readers_are_installed models_are_written a_bake_is_written ${checks})
  set_tests_properties(hand_off/gltf/${step} PROPERTIES LABELS hand_off TIMEOUT 300 WORKING_DIRECTORY ${readers})
endforeach()
