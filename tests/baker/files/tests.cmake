# SPDX-License-Identifier: MIT
coppermoon_tests(baker/files LINKS coppermoon::files
  QUICK fingerprint whole_file)
