// SPDX-License-Identifier: MIT
// A lake in the hills of Wales, 27 July 2018, 21:08 UTC: the Moon has risen eclipsed, and in five minutes the
// Sun will be back at its left limb. Luminances are in cd/m2, as of a clear night with the Sun 10 degrees under the
// horizon; lengths in metres; y is up, z north, x east. The Moon is three times as large as it was, nothing else is.
//
// gallery.sh makes moon_landscape.exr, its texture, and landscape.inc, how the Moon stands.
#version 3.7;
#include "functions.inc"
#include "coppermoon.inc"
#include "landscape.inc"

global_settings { assumed_gamma 1.0 max_trace_level 8 }
#default { finish { ambient 0 diffuse 1 } }

#declare Looking = Moon[5] + 3.5;  // azimuth [degrees]
#declare Eye = <0, 3, 0>;
camera {
  location Eye
  direction z
  right x*image_width/image_height
  up y
  angle 30
  look_at Eye + vrotate(z, <-0.7, Looking, 0>)
}

object {
  Coppermoon_Moon("moon_landscape.exr", 1)
  Coppermoon_In_Sky(Moon[0], Moon[1], Moon[2], Moon[3], Moon[4], Moon[5], 3*0.51, 1e6)
  translate Eye
}

// The last of the dusk: darker upwards, as blue as the ozone makes it.
#declare Dusk = rgb <0.0040, 0.0075, 0.0155>;
#declare Gradient = function {
  pigment {
    gradient y
    color_map {
      [0.00 rgb <0.0135, 0.0125, 0.0150>]
      [0.06 rgb <0.0085, 0.0108, 0.0165>]
      [0.16 Dusk]
      [0.60 0.4*Dusk]
    }
  }
}
// A grain of a pixel, since 8 bits would show the gradient in steps.
#declare Grain = function { 0.97 + 0.06*f_noise3d(1800*x, 1800*y, 1800*z) }
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

// What dusk sends down, mostly from behind us, where the Sun is.
#macro Skylight(Azimuth, Altitude, Light)
  light_source { 1e5*Coppermoon_Direction(Altitude, Azimuth) Light parallel point_at 0 shadowless }
#end
Skylight(320, 25, 0.012*<0.75, 0.95, 1.3>)
Skylight(250, 35, 0.005*<0.55, 0.85, 1.5>)
Skylight(40, 60, 0.004*<0.5, 0.8, 1.5>)

// Stars at random: for each magnitude fainter three times as many. A magnitude of 0 gives 2.5e-6 lx; each is drawn as a
// disc of 0.02 degrees before the sky, dimmed by the air.
#declare Lot = seed(27);
#declare Star_Radius = radians(0.021);
#for (I, 1, 90)
  #local Magnitude = 4.6 + log(rand(Lot))/log(10)*2.1;
  #local Altitude = degrees(asin(0.03 + 0.27*rand(Lot)));
  #local Azimuth = Looking + 44*(rand(Lot) - 0.5);
  #local Illuminance = 2.54e-6*pow(10, -0.4*(Magnitude + 0.25/sin(radians(Altitude + 1))));
  #local Warmth = rand(Lot);
  sphere {
    1.2e6*Coppermoon_Direction(Altitude, Azimuth), 1.2e6*Star_Radius
    pigment { rgb Dusk + Illuminance/(pi*pow(Star_Radius, 2))*<0.8 + 0.4*Warmth, 1, 1.3 - 0.5*Warmth> }
    finish { diffuse 0 emission 1 }
    no_reflection
  }
#end

// Hills: a ridge at a distance, across the view, with air before it. Haze is the share of light that the air takes and
// replaces by its own.
#declare Air = <0.0085, 0.0108, 0.0165>;
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
