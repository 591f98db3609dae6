# SPDX-License-Identifier: MIT
foreach(noun interpolation quadrature quantity random table)
  coppermoon_test(baker/algebra/${noun} LINKS algebra)
endforeach()
