# SPDX-License-Identifier: MIT
coppermoon_tests(baker/photons LINKS coppermoon::photons PkgConfig::Highway
  QUICK bending earth_limb limb_darkening limb_table photon solar_disc trace)
