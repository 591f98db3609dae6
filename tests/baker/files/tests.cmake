# SPDX-License-Identifier: MIT
coppermoon_tests(baker/files LINKS coppermoon::files
  QUICK fingerprint own_file whole_file)
