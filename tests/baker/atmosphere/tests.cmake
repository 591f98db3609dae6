# SPDX-License-Identifier: MIT
foreach(noun atmosphere density ozone rayleigh refractivity)
  coppermoon_test(baker/atmosphere/${noun} LINKS atmosphere)
endforeach()
