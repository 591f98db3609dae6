# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/tradeoff LINKS coppermoon::tradeoff HEAVY runs)
