# SPDX-License-Identifier: MIT
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
foreach(noun disc_brightness film_light film_sheet film_times fit_light fit_posterior frame_range light_file observer_options one_line photometric_bands photon_options photon_sums plan_options planning recipe spectral_bands)
  coppermoon_test(baker/verbs/${noun} LINKS verbs)
endforeach()
