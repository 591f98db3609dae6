// SPDX-License-Identifier: MIT
// A lake in the hills of Wales, 27 July 2018, 21:24 UTC: the Moon has risen eclipsed, and for ten minutes the
// Sun has been back at its left limb. Luminances are in cd/m2; sky and stars are those of that night, with the Sun 8
// degrees under the horizon, and light the hills. Lengths in metres; y is up, z north, x east. The Moon is three times as
// large as it was, nothing else is.
//
// gallery.sh has `coppermoon scene` make moon.inc, eclipse_sky.exr and eclipse_stars.inc of that moment.
#version 3.7;
#include "functions.inc"
#include "moon.inc"
#include "eclipse_stars.inc"

global_settings {
  assumed_gamma 1.0
  max_trace_level 8
  radiosity { count 120 nearest_count 8 error_bound 0.6 recursion_limit 1 pretrace_start 0.08 pretrace_end 0.02 }
}
#default { finish { ambient 0 diffuse 1 } }

#declare Looking = Moon_Azimuth + 3.5;  // azimuth [degrees]
#declare Eye = <0, 3, 0>;
camera {
  location Eye
  direction z
  right x*image_width/image_height
  up y
  angle 30
  look_at Eye + vrotate(z, <-0.7, Looking, 0>)
}

Eclipsed_Sky(1)
object { Eclipsed_Moon(3, 1e5) translate Eye }
Eclipsed_Moonlight(1)
Eclipsed_Stars(Eye, 0.06, 2e5)

#declare Lot = seed(27);

// Hills: a ridge at a distance, across the view, with air before it. Haze is the share of light that the air takes and
// replaces by its own.
#declare Sky = function { pigment { Coppermoon_Sky_Pigment } };
#declare Low = Coppermoon_Direction(1, Looking);
#declare Seen = Sky(Low.x, Low.y, Low.z);
#declare Air = <Seen.red, Seen.green, Seen.blue>;
#macro Hills(Distance, Left, Right, Height, Roughness, Haze, Shape)
  #local Ground = function {
    pow(max(0, Shape(x, y, z)), 1.2)
    *(0.55 + Roughness*(f_ridged_mf(9*x, 9*y, 3.1*Distance/1000, 0.9, 2.1, 8, 0.9, 2, 2) - 0.4))
  }
  height_field {
    function 700, 700 { Ground(x, y, z) }
    smooth
    translate <-0.5, 0, -0.5>
    scale <Right - Left, Height, 0.6*(Right - Left)>
    translate <(Left + Right)/2, -0.02*Height, Distance + 0.3*(Right - Left)>
    rotate y*Looking
    texture {
      pigment { rgb (1 - Haze)*<0.07, 0.08, 0.06> }
      finish { diffuse 1 emission Haze/(1 - Haze)*Air/<0.07, 0.08, 0.06> }
    }
  }
#end
#declare Hump = function(x, Middle, Width) { exp(-pow((x - Middle)/Width, 2)) }
#declare Front = function(z) { min(1, 6*z)*min(1, 4*(1 - z)) }
#declare Shape_Far = function(x, y, z) { (0.45*Hump(x, 0.25, 0.2) + 0.5*Hump(x, 0.68, 0.25) + 0.25)*Front(1 - y) }
#declare Shape_Left = function(x, y, z) { (Hump(x, 0.28, 0.2) + 0.45*Hump(x, 0.6, 0.15))*Front(1 - y) }
#declare Shape_Right = function(x, y, z) { (Hump(x, 0.72, 0.2) + 0.5*Hump(x, 0.45, 0.14))*Front(1 - y) }
Hills(9000, -7000, 7000, 700, 0.5, 0.75, Shape_Far)
Hills(5200, -4200, 1200, 560, 0.6, 0.5, Shape_Left)
Hills(3600, -400, 3600, 480, 0.6, 0.32, Shape_Right)

// Mist on the water.
fog { fog_type 2 distance 7000 fog_offset 0 fog_alt 18 rgb 1.15*Air up y }

// A headland with firs: trunks, and branches that hang the lower the longer they are.
#declare Needles = texture { pigment { rgb <0.016, 0.020, 0.014> } }
#macro Fir(Branches)
  union {
    cone { 0, 0.022, y, 0.002 }
    #for (I, 1, Branches)
      #local Level = 0.06 + 0.93*pow(I/Branches, 0.85);
      #local Reach = (0.02 + 0.2*pow(1 - Level, 0.8))*(0.55 + 0.6*rand(Lot));
      #local Out = vrotate(x, y*360*rand(Lot));
      #local Tip = Level*y + Reach*(Out - (0.15 + 0.35*rand(Lot))*y);
      cone { Level*y, 0.012, Tip, 0.003 }
      #for (J, 1, 5)
        #local From = Level*y + (0.25 + 0.7*rand(Lot))*(Tip - Level*y);
        cone { From, 0.007, From + 0.3*Reach*(vrotate(Out, y*110*(rand(Lot) - 0.5)) - 0.9*rand(Lot)*y), 0.002 }
      #end
    #end
    texture { Needles }
  }
#end
#declare Firs = array[3];
#for (I, 0, 2)
  #declare Firs[I] = Fir(130 + 20*I)
#end
#macro Headland(X, Z, Length, Depth, Top, Trees)
  union {
    sphere { 0, 1 scale <Length, Top, Depth> texture { Needles } }
    #for (I, 1, Trees)
      #local U = 1.9*rand(Lot) - 0.95;
      #local W = 1.2*rand(Lot) - 0.6;
      #local Size = (9 + 9*rand(Lot))*(1 - 0.45*U*U);
      object {
        Firs[floor(2.99*rand(Lot))]
        rotate y*360*rand(Lot)
        scale <1.15*Size, Size, 1.15*Size>
        translate <U*Length, Top*sqrt(max(0, 1 - U*U - W*W)) - 0.3, W*Depth>
      }
    #end
    translate <X, 0, Z>
    rotate y*Looking
  }
#end
Headland(-135, 330, 85, 40, 5, 70)
Headland(190, 620, 70, 40, 5, 60)

// The lake, with a breath of wind.
plane {
  y, 0
  pigment { rgb 0 }
  normal {
    average
    normal_map {
      [1.0 bumps 0.035 scale <2.6, 1, 1.1>]
      [1.0 bumps 0.05 scale <0.7, 1, 0.35> translate 7]
      [0.6 wrinkles 0.03 scale <14, 1, 9>]
    }
    rotate y*Looking
  }
  finish { diffuse 0 reflection { 0, 1 fresnel on } conserve_energy }
  interior { ior 1.33 }
}
