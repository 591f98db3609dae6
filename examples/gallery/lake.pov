// SPDX-License-Identifier: MIT
// A lake under an eclipsed Moon, from nothing: docs/povray.md goes through it line by line.
//
//   coppermoon scene 2018-07-27 U4-40min --at 52.9,-3.9 -o eclipse
//   cp examples/gallery/lake.pov eclipse; cd eclipse
//   povray lake.pov +W960 +H540 +FE +A0.0 +AM2 +R2 -J
//   coppermoon develop lake.exr --time 2 --f-number 4 --iso 1600 --view Filmic -o lake.png
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "moon.inc"

// The camera stands three metres over the water and looks towards the Moon.
#declare Eye = <0, 3, 0>;
camera {
  location Eye
  direction z
  right x*image_width/image_height
  up y
  angle 38
  look_at Eye + Coppermoon_Direction(0.5, Moon_Azimuth)
}

// The night sky as it was: moonlight in the air, and the night's own light.
Eclipsed_Sky(1)

// The Moon, three times as large as it was, and its light as it was.
object { Eclipsed_Moon(3, 1e6) translate Eye }
Eclipsed_Moonlight(1)

// Water that mirrors both.
plane {
  y, 0
  pigment { rgb <0.01, 0.015, 0.02> }
  normal { bumps 0.05 scale <3, 1, 1.2> }
  finish { ambient 0 diffuse 0.3 reflection { 0.02, 1 fresnel on } }
  interior { ior 1.33 }
}

// Hills at the far shore.
height_field {
  function 200, 200 { pigment { granite scale 0.6 color_map { [0 rgb 0] [1 rgb 1] } } }
  translate <-0.5, -0.35, 0>
  scale <9000, 420, 3000>
  translate <0, 0, 5000>
  rotate y*Moon_Azimuth
  pigment { rgb 0.1 }
  finish { ambient 0 diffuse 1 }
}
