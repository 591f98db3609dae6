# SPDX-License-Identifier: MIT
foreach(noun bending limb limb_darkening limb_table march march_air photon solar_disc trace)
  coppermoon_test(baker/photons/${noun} LINKS photons)
endforeach()
target_link_libraries(baker_photons_march_test PRIVATE PkgConfig::Highway)
