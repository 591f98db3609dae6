# SPDX-License-Identifier: MIT
coppermoon_tests(baker/eclipse LINKS coppermoon::eclipse coppermoon::result QUICK contacts feature moment seen_sky shadow_axis shadow_cone)
