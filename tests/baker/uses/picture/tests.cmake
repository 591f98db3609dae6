# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/picture LINKS coppermoon::picture PkgConfig::ERFA
  HEAVY development disc_outline helpers moon photo_file place_text raw_file sky_lights view)
