# SPDX-License-Identifier: MIT
coppermoon_tests(baker/atmosphere LINKS coppermoon::atmosphere
  QUICK aerosol air_mass astronomical_refraction atmosphere density figure observer_air ozone presets rayleigh
        refractivity sky_luminance)
