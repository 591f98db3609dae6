// SPDX-License-Identifier: MIT
// An evening by the lake at Chicago, 15 May 2022: the Moon climbs from 20:36 to 23:00 into the shadow, photographed every
// twelve minutes onto one picture. Each Moon has its own time; the city has one second at f/4 and ISO 400. Luminances are
// in cd/m2 as that second sees them: a Moon photographed in 1/1000 s has a thousandth of its own. Lengths in metres; y is
// up, z north, x east. The Moon is four and a half times as large as it was; the city is a city, not that one.
//
// gallery.sh makes the textures moon_sequence_00.exr to _12.exr and sequence.inc, how each Moon stands.
#version 3.7;
#include "functions.inc"
#include "coppermoon.inc"
#include "sequence.inc"

global_settings { assumed_gamma 1.0 max_trace_level 6 }
#default { finish { ambient 0 diffuse 0 emission 1 } }

#declare Looking = 139;  // azimuth [degrees]
#declare Eye = <0, 12, 0>;
camera {
  location Eye
  direction z
  right x*image_width/image_height
  up y
  angle 54
  look_at Eye + vrotate(z, <-10.7, Looking, 0>)
}

// Seconds: the same while there is sunlight to see, then longer and longer.
#declare Time = array[13] { 1/600, 1/700, 1/800, 1/800, 1/800, 1/640, 1/500, 1/250, 1/100, 1/3, 2.5, 5, 8 }
#for (I, 0, 12)
  object {
    Coppermoon_Moon(concat("moon_sequence_", str(I, -2, 0), ".exr"), Time[I])
    Coppermoon_In_Sky(Moons[I][0], Moons[I][1], Moons[I][2], Moons[I][3], Moons[I][4], Moons[I][5],
                      4.5*0.54, 1e6)
    translate Eye
  }
#end

// Dusk behind us, the city's own light over the roofs; a grain, since 8 bits would show the gradient in steps.
#declare Gradient = function {
  pigment {
    gradient y
    color_map {
      [0.00 rgb <0.0260, 0.0150, 0.0100>]
      [0.05 rgb <0.0120, 0.0100, 0.0120>]
      [0.14 rgb <0.0038, 0.0058, 0.0125>]
      [0.45 rgb <0.0010, 0.0022, 0.0068>]
    }
  }
}
#declare Grain = function { 0.96 + 0.08*f_noise3d(1000*x, 1000*y, 1000*z) }
sky_sphere {
  pigment {
    average
    pigment_map {
      [1 function { Gradient(x, y, z).red*Grain(x, y, z) } color_map { [0 rgb 0] [1 red 3] }]
      [1 function { Gradient(x, y, z).green*Grain(x, y, z) } color_map { [0 rgb 0] [1 green 3] }]
      [1 function { Gradient(x, y, z).blue*Grain(x, y, z) } color_map { [0 rgb 0] [1 blue 3] }]
    }
  }
}

// Houses: windows at random, so many of a thousand lit; in `cells` each window has one random number.
#declare Lot = seed(1871);
#macro Facade(Lit, Stone)
  pigment {
    cells
    color_map {
      [1 - Lit Stone]
      [1 - Lit rgb 0.05*<1, 0.55, 0.22>]
      [1 - 0.5*Lit rgb 0.4*<1, 0.62, 0.30>]
      [1 - 0.15*Lit rgb 1.5*<1, 0.75, 0.45>]
      [1 rgb 3.0*<0.9, 0.95, 1>]
    }
    scale <4.6, 3.8, 4.6>
    translate 1000*<rand(Lot), rand(Lot), rand(Lot)>
  }
#end
#macro Block(Wide, Deep, Tall)
  box { <-Wide/2, 0, -Deep/2>, <Wide/2, Tall, Deep/2> }
#end
#macro House(X, Z, Tall)
  #local Wide = 22 + 26*rand(Lot);
  #local Deep = 22 + 20*rand(Lot);
  #local Stone = rgb (0.0025 + 0.0035*rand(Lot))*<0.95, 0.95, 1.15>;
  #local Kind = rand(Lot);
  union {
    #if (Tall > 130 & Kind < 0.55)
      union {
        Block(Wide, Deep, 0.62*Tall)
        Block(0.74*Wide, 0.74*Deep, 0.86*Tall)
        Block(0.46*Wide, 0.46*Deep, Tall)
        Facade(0.08 + 0.22*rand(Lot), Stone)
      }
    #else
      object { Block(Wide, Deep, Tall) Facade(0.05 + 0.25*rand(Lot), Stone) }
    #end
    #if (Tall > 190)
      cylinder { Tall*y, 1.15*Tall*y, 2 pigment { rgb 0.4*Stone } }
      sphere { 1.15*Tall*y, 3 pigment { rgb <14, 0.8, 0.4> } }
    #end
    translate <X, 2, Z>
  }
#end
union {
  #for (I, 1, 420)
    #local X = 3600*rand(Lot) - 1700;
    #local Z = 2700 + 1300*rand(Lot);
    #local Centre = exp(-pow((X - 500)/480, 2)) + 0.3*exp(-pow((X + 600)/350, 2));
    House(X, Z, 22 + 42*rand(Lot) + Centre*(30 + 260*pow(rand(Lot), 2.6)))
  #end
  // The shore and its lamps.
  box { <-4000, 0, 2600>, <4000, 2.2, 6000> pigment { rgb 0.003 } }
  #for (I, 0, 90)
    sphere {
      <-1900 + 42*I + 10*rand(Lot), 7, 2590>, 1.1
      pigment { rgb 16*<1, 0.66, 0.34> }
    }
  #end
  rotate y*Looking
}

// The lake.
plane {
  y, 0
  pigment { rgb 0 }
  normal {
    average
    normal_map {
      [1.0 bumps 0.05 scale <9, 1, 5>]
      [1.0 bumps 0.06 scale <2.4, 1, 1.4> translate 7]
    }
    rotate y*Looking
  }
  finish { emission 0 reflection { 0, 1 fresnel on } conserve_energy }
  interior { ior 1.33 }
}
