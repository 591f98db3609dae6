# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/picture LINKS coppermoon::picture PkgConfig::ERFA PkgConfig::Exiv2
  HEAVY as_shot_balance avif_file brightness camera_colours caption development disc_outline frame_sky local_time moment_text moon photo_file place_text raw_file scattered_colour plots sky_lights view)
