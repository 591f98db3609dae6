# SPDX-License-Identifier: MIT
foreach(noun bending photon solar_disc trace)
  coppermoon_test(baker/photons/${noun} LINKS photons)
endforeach()
