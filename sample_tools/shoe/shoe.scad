// Feed shoe of the slit experiments: inside 32 x 50 x 37 mm (Bierwisch 2009, section 4.1.1).
include <../tooling.scad>
inside_x = 32;
inside_y = 50;
height = 37; // 46 for shoe_tall.stl, which holds the 41 mm fill that the thesis also reports
shoe(inside_x, inside_y, height);
