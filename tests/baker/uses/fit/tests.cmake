# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/fit LINKS coppermoon::fit
  HEAVY magnitudes measured_light nuisances posterior refracted_at scene sky_and_glow
  SLOW fitted_light)
