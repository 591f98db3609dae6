# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/study LINKS coppermoon::study
  QUICK refracted_at
  HEAVY fit_magnitudes fit_nuisances fit_posterior fit_scene fit_sky
  SLOW fit_light)
