// SPDX-License-Identifier: MIT
// The lake of lake.pov as Ohrid's, 7 September 2025: the camera stands still and looks to the south-east, where the Moon rises
// in the dusk, half in the shadow, and stands high in totality two hours later. ../lake_film.sh makes the film.
#version 3.7;
#declare Looking = 108;
#declare Tilt = 8.5;
#declare Field = 52;
#include "lake.pov"
