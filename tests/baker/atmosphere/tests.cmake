# SPDX-License-Identifier: MIT
coppermoon_tests(baker/atmosphere LINKS coppermoon::atmosphere
  QUICK aerosol air_mass astronomical_refraction atmosphere cloud density eye_contrast figure gases observer_air ozone presets
        rayleigh refractivity seasonal_air sky_luminance stratosphere tropopause twilight_sky)
