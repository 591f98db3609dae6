# SPDX-License-Identifier: MIT
coppermoon_tests(baker/eclipse LINKS coppermoon::eclipse QUICK contacts feature shadow_axis shadow_cone)
