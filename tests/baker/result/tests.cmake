# SPDX-License-Identifier: MIT
coppermoon_tests(baker/result LINKS coppermoon::result QUICK as_json fields)
