# SPDX-License-Identifier: MIT
coppermoon_tests(baker/uses/shader LINKS coppermoon::shader HEAVY formula light_strip shadow_motion)
