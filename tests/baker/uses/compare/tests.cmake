# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/compare LINKS coppermoon::compare HEAVY comparison)
