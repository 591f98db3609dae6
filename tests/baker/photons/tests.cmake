# SPDX-License-Identifier: MIT
foreach(noun bending limb limb_darkening limb_table photon solar_disc trace)
  coppermoon_test(baker/photons/${noun} LINKS photons)
endforeach()
