# SPDX-License-Identifier: MIT
coppermoon_tests(baker/surface LINKS coppermoon::surface
  QUICK albedo_map built_in_map ground photometry reflectance)
