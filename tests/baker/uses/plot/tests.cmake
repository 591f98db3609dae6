# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/plot LINKS coppermoon::plot HEAVY plot)
