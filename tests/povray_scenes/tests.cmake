# SPDX-License-Identifier: MIT
coppermoon_tests(povray_scenes LINKS coppermoon::povray_scenes PkgConfig::OpenImageIO
  QUICK mitsuba moon_scene scene_camera sight
  HEAVY moon_include render sequence)
target_compile_definitions(povray_scenes_heavy_tests PRIVATE COPPERMOON_INC_FOLDER="${PROJECT_SOURCE_DIR}/povray_scenes")
