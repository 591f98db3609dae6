# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/fit LINKS coppermoon::fit
  HEAVY air_fit binned_photograph clock_scan fit_scene light_in_bins limb_weather magnitudes measured_light misfit moon_in_photograph nuisance_table nuisances posterior sky_and_glow unknowns
  SLOW fitted_light)
