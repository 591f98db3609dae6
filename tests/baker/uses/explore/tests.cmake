# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/explore LINKS coppermoon::explore ZLIB::ZLIB
  HEAVY limb_rays motion page page_arrays)
