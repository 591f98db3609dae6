# SPDX-License-Identifier: MIT
foreach(noun error grid interpolation low_discrepancy quadrature quantity random table)
  coppermoon_test(baker/algebra/${noun} LINKS algebra)
endforeach()
