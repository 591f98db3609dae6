# SPDX-License-Identifier: MIT
coppermoon_tests(baker/verbs LINKS coppermoon::verbs
  QUICK disc_brightness film_sheet film_times fit_posterior frame_range observer_options one_line
        photometric_bands photon_options photon_sums plan_options recipe spectral_bands
  HEAVY film_light fit_light light_file planning)
