# SPDX-License-Identifier: MIT
coppermoon_tests(baker/files LINKS coppermoon::files
  QUICK cache_folder fingerprint own_file whole_file)
