# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/fit LINKS coppermoon::fit
  HEAVY air_fit binned_photograph clock_scan light_in_bins limb_weather magnitudes measured_light misfit nuisance_table nuisances photograph posterior scene sky_and_glow unknowns
  SLOW fitted_light)
