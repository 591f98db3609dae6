# SPDX-License-Identifier: MIT
coppermoon_tests(baker/files LINKS coppermoon::files
  QUICK cache_folder endings file_end fingerprint memory name_to_share own_file temporary_folder whole_file)
