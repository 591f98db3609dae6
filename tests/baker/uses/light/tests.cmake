# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/light LINKS coppermoon::light
  HEAVY air disc_brightness light_file moonlight photometric_bands light_parameters photon_file planning reached shadow_profile spectral_bands)
