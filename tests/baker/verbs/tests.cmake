# SPDX-License-Identifier: MIT
coppermoon_tests(baker/verbs LINKS coppermoon::verbs
  HEAVY disc_brightness film_light film_sheet film_times fit_magnitudes fit_posterior frame_range light_file light_options observer_options one_line
        photometric_bands photon_options photon_sums plan_options planning recipe spectral_bands
  SLOW fit_light)
