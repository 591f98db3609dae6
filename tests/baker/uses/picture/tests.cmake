# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/picture LINKS coppermoon::picture
  HEAVY development disc_outline moon raw_file view)
