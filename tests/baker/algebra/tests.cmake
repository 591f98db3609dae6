# SPDX-License-Identifier: MIT
coppermoon_tests(baker/algebra LINKS coppermoon::algebra
  QUICK chebyshev error grid interpolation low_discrepancy number quadrature quantity random table)
