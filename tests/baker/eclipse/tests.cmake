# SPDX-License-Identifier: MIT
foreach(noun contacts feature shadow_axis shadow_cone)
  coppermoon_test(baker/eclipse/${noun} LINKS eclipse)
endforeach()
