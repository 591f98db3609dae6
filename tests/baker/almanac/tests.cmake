# SPDX-License-Identifier: MIT
foreach(noun ephemeris instant observer sky)
  coppermoon_test(baker/almanac/${noun} LINKS almanac)
endforeach()
