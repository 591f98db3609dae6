# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/dome LINKS coppermoon::dome HEAVY dome)
