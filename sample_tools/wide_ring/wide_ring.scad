// Wide ring: inner diameter 16 mm, 8 mm wide, 20 mm deep (Bierwisch 2009, section 6.4; sizes assumed).
include <../tooling.scad>
part = "die"; // die, core_rod, punch, shoe
inner_radius = 8;
width = 8;
depth = 20;
block = 25;
margin = 4;
shoe_x = 32;
shoe_y = 36; // outer diameter + 4 mm
shoe_height = 46;

outer_radius = inner_radius + width;
if (part == "die") bored_block(plate_half_x(outer_radius, margin, shoe_x), plate_half_y(shoe_y), block, outer_radius);
if (part == "core_rod") core_rod(inner_radius, block);
if (part == "punch") ring_punch(inner_radius, outer_radius, depth, block);
if (part == "shoe") shoe(shoe_x, shoe_y, shoe_height);
