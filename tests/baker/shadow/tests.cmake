# SPDX-License-Identifier: MIT
coppermoon_tests(baker/shadow LINKS coppermoon::shadow coppermoon::colour PkgConfig::Highway TBB::tbb
  QUICK by_quadrature disc_arcs irradiance landed_light limb_landings limb_ring lookup photon_rows photon_sums
        scattered_row sectors twilight umbra weighted_rows
  HEAVY agreement by_photons landing_statistics ring_middles
  SLOW convergence)
coppermoon_computing_tests(baker/shadow by_quadrature twilight)
