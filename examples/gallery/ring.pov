// SPDX-License-Identifier: MIT
// On the western limb of the Moon, 27 July 2018, 20:05 UTC: the Earth stands before the Sun, and all its sunrises and
// sunsets light the ground. Luminances are in cd/m2; lengths in metres; y is up, z towards the Earth. The Earth is five
// times as large as it was, its ring of air thirty times as thick again, and the ring has a 150 000th of the ground's
// exposure; its light on the ground is what it was. The pale light about it is the Sun's corona.
//
// gallery.sh makes ring.exr, the ring as a strip, and ring.inc, how it stands on the sky.
#version 3.7;
#include "functions.inc"
#include "ring.inc"

global_settings {
  assumed_gamma 1.0
  max_trace_level 4
  radiosity { count 80 nearest_count 8 error_bound 0.7 recursion_limit 2 pretrace_start 0.08 pretrace_end 0.02 }
}
#default { finish { ambient 0 diffuse 1 } }

#declare Enlarged = 5;
#declare Thickened = 30;
#declare Exposure = 1e4/150000;
#declare Pale = 0.004*<0.96, 1, 1.1>;  // of the corona at the Earth's limb
#declare Warm = 0.02*<1, 0.27, 0.06>;  // of the glow that the ring has in a lens

#declare Eye = <0, 1.6, 0>;
camera {
  location Eye
  direction z
  right x*image_width/image_height
  up y
  angle 36
  look_at Eye + vrotate(z, <-Earth_Altitude + 4.5, 0, 0>)
}

#declare Strip = pigment { image_map { exr "ring.exr" map_type 0 interpolate 2 } }

// From position angles on the sky, anticlockwise from north, to directions: the zenith is up.
#macro On_Sky(Position_Angle, Radius)
  #local Turn = radians(Position_Angle - Zenith_Angle);
  vrotate(<-tan(radians(Radius))*sin(Turn), tan(radians(Radius))*cos(Turn), 1>, <-Earth_Altitude, 0, 0>)
#end

// The ring: a mesh of sectors, each with its column of the strip.
#declare Far = 1e6;
#declare Inner = Enlarged*Inner_Angle;
#declare Outer = Inner + Enlarged*Thickened*(Outer_Angle - Inner_Angle);
#declare Sectors = 360;
mesh {
  #for (I, 0, Sectors - 1)
    #local A = 360*I/Sectors;
    #local B = 360*(I + 1)/Sectors;
    triangle {
      Far*On_Sky(A, Inner), Far*On_Sky(B, Inner), Far*On_Sky(B, Outer)
      uv_vectors <A/360, 0.001>, <B/360, 0.001>, <B/360, 0.999>
    }
    triangle {
      Far*On_Sky(A, Inner), Far*On_Sky(A, Outer), Far*On_Sky(B, Outer)
      uv_vectors <A/360, 0.001>, <A/360, 0.999>, <B/360, 0.999>
    }
  #end
  texture {
    uv_mapping
    pigment { average pigment_map { [1 Strip] [1 rgb (Pale + Warm)/Exposure] } }
    finish { diffuse 0 emission 2*Exposure }  // the average is half of the sum
  }
  no_shadow
  no_radiosity
  translate Eye
}

// Its light: that of each of 24 parts comes from there. A texel of 1 cd/m2 gives its solid angle in lux; the strip
// has a ten-thousandth of them.
#declare Parts = 24;
#declare Heights = 64;
#declare Texel = 1e4*2*pi/Parts/3*radians(Outer_Angle - Inner_Angle)/Heights*sin(radians(Inner_Angle));
#declare Illuminance = array[Parts];
#declare All = <0, 0, 0>;
#for (I, 0, Parts - 1)
  #declare Illuminance[I] = <0, 0, 0>;
  #for (J, 0, Heights - 1)
    #for (K, 0, 2)
      #local C = eval_pigment(Strip, <(I + (K + 0.5)/3)/Parts, (J + 0.5)/Heights, 0>);
      #declare Illuminance[I] = Illuminance[I] + Texel*<C.red, C.green, C.blue>;
    #end
  #end
  #declare All = All + Illuminance[I];
  light_source {
    1e5*On_Sky(360*(I + 0.5)/Parts, Inner)
    rgb Illuminance[I]/pi
    parallel
    point_at 0
  }
#end
#debug concat("illuminance [lx]: ", vstr(3, All, ", ", 0, 4), "\n")
// The stars' own, from everywhere.
#declare Starlight = 8e-6*<0.9, 0.95, 1.1>;

// The corona, behind the stars, and the glow of the ring in a lens. The corona is dust in sunlight, which grows fainter with the power
// 3.2 of the angle from the Sun and reaches further along the ecliptic; it has a 1500th of its luminance here.
#declare Sunward = radians(Sun_Angle - Zenith_Angle);
#declare Ecliptic = radians(-Zenith_Angle);
#declare Along = function(x, y) { cos(Ecliptic)*x + sin(Ecliptic)*y }
#declare Corona = function(x, y) { pow(max(1, pow(Along(x, y), 2)/1.5 + pow(Along(y, -x), 2)), -1.6) }
#declare Glow = function(r) { 0.8*exp(-abs(r - 1)/0.035) + 0.17*exp(-abs(r - 1)/0.15) + 0.03*exp(-abs(r - 1)/0.8) }
disc {
  0, z, 12
  pigment {
    average
    pigment_map {
      [1
        function { select(sqrt(x*x + y*y) - 1, 0, 1)*Corona(x + 0.12*sin(Sunward), y - 0.12*cos(Sunward)) }
        color_map { [0 rgb 0] [1 rgb Pale] }
      ]
      [1 function { Glow(sqrt(x*x + y*y)) } color_map { [0 rgb 0] [1 rgb Warm] }]
    }
  }
  finish { diffuse 0 emission 2 }  // the average is half of the sum
  scale 1.3*Far*tan(radians(Inner))
  translate 1.3*Far*z
  rotate -Earth_Altitude*x
  translate Eye
  no_shadow
  no_radiosity
}

// Stars at random, but for where the Earth stands: for each magnitude fainter three times as many. A magnitude of 0 gives
// 2.5e-6 lx; each is drawn as a disc of 0.02 degrees.
#declare Lot = seed(72);
#declare Star_Radius = radians(0.022);
#for (I, 1, 260)
  #local Magnitude = 5 + log(rand(Lot))/log(10)*2.1;
  #local Direction = vrotate(z, <-Earth_Altitude + 3 + 20*(rand(Lot) - 0.5), 34*(rand(Lot) - 0.5), 0>);
  #local Warmth = rand(Lot);
  #if (vdot(Direction, vnormalize(On_Sky(0, 0))) < cos(radians(Outer + 0.1)))
    sphere {
      1.2*Far*Direction, 1.2*Far*Star_Radius
      pigment { rgb 2.54e-6*pow(10, -0.4*Magnitude)/(pi*pow(Star_Radius, 2))*<0.8 + 0.4*Warmth, 1, 1.3 - 0.5*Warmth> }
      finish { diffuse 0 emission 1 }
      no_shadow
      no_radiosity
    }
  #end
#end

// The ground: craters of all sizes, rolling between, on a near and a far field.
#declare Crater = function(d, r) { r*(0.10*exp(-pow((d/r - 1)/0.3, 2)) - 0.22*exp(-pow(d/r, 4)/0.5)) }
#macro Craters(Count, Nearest, Furthest, Least)
  #for (I, 1, Count)
    #local Away = Nearest + (Furthest - Nearest)*pow(rand(Lot), 1.3);
    #local Aside = Away*0.8*(rand(Lot) - 0.5);
    #local Size = Least/pow(rand(Lot) + 0.02, 0.6);
    + Crater(sqrt(pow(x - Aside, 2) + pow(z - Away, 2)), Size)
  #end
#end
#declare Height = function(x, z) {
  1.6*(f_noise3d(x/40, 3, z/40) - 0.5) + 0.35*(f_noise3d(x/7, 5, z/7) - 0.5) + 0.12*(f_noise3d(x/1.7, 0, z/1.7) - 0.5)
  + 0.03*(f_noise3d(3*x, 0, 3*z) - 0.5)
  Craters(24, 17, 120, 0.7)
}
#declare Far_Height = function(x, z) {
  5*(f_noise3d(x/140, 3, z/140) - 0.5) + 1.5*(f_noise3d(x/30, 5, z/30) - 0.5) + 0.5*(f_noise3d(x/8, 0, z/8) - 0.5)
  Craters(40, 150, 1500, 5)
}
#declare Regolith = texture {
  pigment { granite scale 3 color_map { [0 rgb <0.100, 0.092, 0.085>] [1 rgb <0.150, 0.138, 0.126>] } }
  normal { average normal_map { [1 bumps 0.25 scale 0.25] [1 granite 0.25 scale 1.5] } }
  finish { diffuse 1 brilliance 0.7 emission Starlight/0.12 }
}
height_field {
  function 900, 900 { 0.5 + min(1, y/0.2)*Height(110*(x - 0.5), 130 - 118*y)/12 }
  smooth
  translate <-0.5, -0.5, 0>
  scale <110, 12, 118>
  translate 12*z
  texture { Regolith }
}
height_field {
  function 700, 700 { 0.5 + min(1, (1 - y)/0.04)*Far_Height(1600*(x - 0.5), 1630 - 1510*y)/60 }
  smooth
  translate <-0.5, -0.5, 0>
  scale <1600, 60, 1510>
  translate <0, -0.1, 120>
  texture { Regolith scale 8 }
}

// Hills before the horizon, which the Moon's roundness hides.
#macro Hills(Distance, Left, Right, Tall, Seed)
  height_field {
    function 240, 240 {
      min(1, 5*(1 - y))*min(1, 5*y)*(0.35 + 0.65*f_ridged_mf(4*x + Seed, 0.4, 3*y + Seed, 0.9, 2.1, 6, 0.85, 2, 2))
      *(0.25 + pow(sin(pi*min(1, max(0, x))), 2))
    }
    smooth
    translate <-0.5, 0, 0>
    scale <Right - Left, Tall, 0.5*(Right - Left)>
    translate <(Left + Right)/2, -0.1*Tall - Distance/200, Distance>
    texture { Regolith }
  }
#end
Hills(1500, -1300, 300, 75, 3)
Hills(2600, -300, 2300, 150, 8)
Hills(5200, -3800, 2600, 190, 21)
plane { y, -4 texture { Regolith scale 20 } }

// Boulders.
#macro Boulder(X, Z, Size)
  #local From = 100*rand(Lot);
  isosurface {
    function {
      sqrt(x*x + 1.5*y*y + z*z) - 0.75 - 0.5*(f_noise3d(1.1*x + From, 1.1*y, 1.1*z) - 0.5)
      - 0.28*(f_noise3d(2.6*x + From, 2.6*y, 2.6*z) - 0.5)
    }
    contained_by { sphere { 0, 1.35 } }
    max_gradient 2.6
    rotate y*360*rand(Lot)
    scale Size
    translate <X, Height(X, Z) + 0.25*Size, Z>
    texture { Regolith }
  }
#end
Boulder(-6.5, 24, 1.3)
Boulder(-9.5, 33, 0.7)
Boulder(6.8, 27, 0.6)
Boulder(10.5, 37, 1.9)
Boulder(2.2, 20, 0.28)
#for (I, 1, 16)
  #local Away = 19 + 50*rand(Lot);
  Boulder(Away*0.66*(rand(Lot) - 0.5), Away, 0.12 + 0.05/(rand(Lot) + 0.1))
#end
