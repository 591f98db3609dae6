// SPDX-License-Identifier: MIT
// A lake under an eclipsed Moon, from nothing: docs/povray.md goes through it line by line.
//
//   coppermoon scene 2018-07-27 U4-40min --at 52.9,-3.9 --texture-width 360 -o eclipse
//   cp examples/gallery/lake.pov eclipse; cd eclipse
//   povray lake.pov +W960 +H540 +FE +A0.0 +AM2 +R2 -J
//   coppermoon develop lake.exr --time 2 --f-number 4 --iso 1600 --view Filmic -o lake.png
//
// Lengths in metres; y is up, z north, x east. lake_film.pov beside it makes a film of it.
#version 3.7;
#include "functions.inc"
#include "moon.inc"
#include "eclipse_stars.inc"

global_settings {
  assumed_gamma 1.0
  radiosity { count 60 nearest_count 6 error_bound 0.7 recursion_limit 1 pretrace_start 0.08 pretrace_end 0.02 }
}
#default { finish { ambient 0 diffuse 1 } }

// The camera stands three metres over the water. Whoever includes this file may point it elsewhere.
#ifndef (Looking) #declare Looking = Moon_Azimuth; #end  // azimuth of the picture's middle [degrees]
#ifndef (Tilt) #declare Tilt = 3; #end                   // and its altitude
#ifndef (Field) #declare Field = 38; #end                // across the picture
#declare Eye = <0, 3, 0>;
camera {
  location Eye
  direction z
  right x*image_width/image_height
  up y
  angle Field
  look_at Eye + Coppermoon_Direction(Tilt, Looking)
}

// The night sky as it was; the Moon, three times as large as it was; its light; and stars of two pixels.
Eclipsed_Sky(1)
object { Eclipsed_Moon(3, 1e5) translate Eye }
Eclipsed_Moonlight(1)
Eclipsed_Stars(Eye, 2*Field/image_width, 2e5)

// The sky's light low over the far shore: the colour of what haze and mist put before the hills.
#declare Sky = function { pigment { Coppermoon_Sky_Pigment } };
#declare Low = Coppermoon_Direction(2, Looking);
#declare Seen = Sky(Low.x, Low.y, Low.z);
#declare Air = <Seen.red, Seen.green, Seen.blue>;

// A ridge across the view. Haze is the share of its light that the air takes and replaces by its own.
#macro Ridge(Distance, Aside, Width, Height, Haze, Lot)
  #local Ground = function(x, y) {
    sin(pi*x)*min(1, 5*y)*min(1, 5*(1 - y))
    *(0.3 + 0.5*f_noise3d(4*x, 4*y, Lot) + 0.3*f_ridged_mf(6*x, 6*y, Lot, 0.9, 2.1, 8, 0.9, 2, 2))
  }
  height_field {
    function 500, 500 { Ground(x, y) }
    smooth
    translate <-0.5, -0.02, 0>
    scale <Width, Height, 0.5*Width>
    translate <Aside, 0, Distance>
    rotate y*Looking
    texture {
      pigment { rgb (1 - Haze)*<0.09, 0.10, 0.06> }
      finish { diffuse 1 emission Haze/(1 - Haze)*Air/<0.09, 0.10, 0.06> }
    }
  }
#end
Ridge(11000, 1500, 26000, 620, 0.6, 3.3)
Ridge(6500, -5800, 9000, 800, 0.3, 1.7)
Ridge(5000, 4200, 7000, 600, 0.15, 8.2)

// Mist on the water.
fog { fog_type 2 distance 16000 fog_offset 0 fog_alt 15 rgb Air up y }

// Water that mirrors all of it, with a breath of wind. In a film the waves go on by the clock.
plane {
  y, 0
  pigment { rgb 0 }
  normal {
    average
    normal_map {
      [1.0 bumps 0.035 scale <2.6, 1, 1.1> translate <3, 0, 9>*clock]
      [1.0 bumps 0.05 scale <0.7, 1, 0.35> translate <-2, 7, 5>*clock]
      [0.6 wrinkles 0.03 scale <14, 1, 9>]
    }
    rotate y*Looking
  }
  finish { diffuse 0 reflection { 0, 1 fresnel on } conserve_energy }
  interior { ior 1.33 }
}
