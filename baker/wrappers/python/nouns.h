// SPDX-License-Identifier: MIT
// Functions that fill the Python module. Each of them adds the classes and functions for one subject.
#pragma once

#include <pybind11/pybind11.h>

namespace coppermoon::python {

void add_eclipses(pybind11::module_& package);
void add_sky(pybind11::module_& package);
void add_requests(pybind11::module_& package);
void add_shadow(pybind11::module_& package);
void add_moonlight(pybind11::module_& package);
void add_bake(pybind11::module_& package);
void add_brightness(pybind11::module_& package);
void add_dome(pybind11::module_& package);
void add_fit(pybind11::module_& package);

}  // namespace coppermoon::python
