# SPDX-License-Identifier: MIT
foreach(noun aerosol air_mass atmosphere density figure ozone rayleigh refractivity)
  coppermoon_test(baker/atmosphere/${noun} LINKS atmosphere)
endforeach()
