# SPDX-License-Identifier: MIT
# The whole program, as a user runs it.
coppermoon_tests(end_to_end LINKS coppermoon::verbs PkgConfig::OpenImageIO PkgConfig::Exiv2
  HEAVY animate bad_input brightness cache camera compare craters describe dome eclipses explore exposure film_files film_job film_folder film_pictures film_scene film_stage frame_passes fit high_range hue image_reader json
        lost_files low_moon merge night orientation outputs paper_figures personal_settings plans recipes refusals ring scene_folder shader sky_exposure start terms texture_files
        tradeoff
  SLOW film nights planned_regions planned_runs recovery stills)
# where the installed program looks for its module
target_compile_definitions(end_to_end_heavy_tests PRIVATE
                           $<TARGET_PROPERTY:coppermoon_loaded_images,COMPILE_DEFINITIONS>)
# the reader that OpenImageIO loads
add_dependencies(end_to_end_heavy_tests coppermoon_imageio)
target_compile_definitions(end_to_end_heavy_tests PRIVATE COPPERMOON_READERS="$<TARGET_FILE_DIR:coppermoon_imageio>")
