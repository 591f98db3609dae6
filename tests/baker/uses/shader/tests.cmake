# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/shader LINKS coppermoon::shader HEAVY light_strip)
