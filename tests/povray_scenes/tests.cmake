# SPDX-License-Identifier: MIT
coppermoon_test(povray_scenes/camera LINKS povray_scenes)
coppermoon_test(povray_scenes/sight LINKS povray_scenes)
coppermoon_test(povray_scenes/scene LINKS povray_scenes)
coppermoon_test(povray_scenes/render LINKS povray_scenes LABELS render)
target_link_libraries(povray_scenes_render_test PRIVATE PkgConfig::OpenImageIO)
target_compile_definitions(povray_scenes_render_test PRIVATE
                           COPPERMOON_INC_FOLDER="${PROJECT_SOURCE_DIR}/povray_scenes")
coppermoon_test(povray_scenes/sequence LINKS povray_scenes LABELS render)
target_link_libraries(povray_scenes_sequence_test PRIVATE PkgConfig::OpenImageIO)
