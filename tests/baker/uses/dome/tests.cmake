# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/dome LINKS coppermoon::dome HEAVY dome scattered_colour twilight_colour)
