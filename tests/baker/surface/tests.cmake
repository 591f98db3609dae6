# SPDX-License-Identifier: MIT
foreach(noun albedo_map built_in_moon features photometry reflectance)
  coppermoon_test(baker/surface/${noun} LINKS surface LABELS surface)
endforeach()
coppermoon_test(baker/surface/noise LINKS surface LABELS surface)
