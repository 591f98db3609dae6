# SPDX-License-Identifier: MIT
foreach(noun aerosol air_mass astronomical_refraction atmosphere density figure observer_air ozone presets rayleigh
             refractivity sky_luminance)
  coppermoon_test(baker/atmosphere/${noun} LINKS atmosphere)
endforeach()
