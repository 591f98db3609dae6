# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/study LINKS coppermoon::study
  HEAVY comparison fit_magnitudes fit_nuisances fit_posterior fit_scene fit_sky measured_light refracted_at tradeoff_runs
  SLOW fit_light)
