// Narrow ring cavity: inner diameter 16 mm, width 1.83 mm + 1.4 d (Bierwisch 2009, section 6.1).
include <../tooling.scad>
part = "die";       // die, core_rod, punch, shoe
d = 1.88;           // mm, model grain size the width is adjusted to
free_width = 1.83;  // mm
inner_radius = 8;
depth = 20;
block = 25;         // height of die and core
margin = 4;         // between cavity and shoe at both ends of the travel
shoe_x = 32;
shoe_y = 29;        // widest ring + 4 mm
shoe_height = 46;
edge = 1.5;         // height of the chamfer on the shoe's inner lower edge
widest = inner_radius + adjusted_width(free_width, 1.88);

outer_radius = inner_radius + adjusted_width(free_width, d);
if (part == "die")
  bored_block(plate_half_x(widest, margin, shoe_x), plate_half_y(shoe_y), block, outer_radius);
if (part == "core_rod") core_rod(inner_radius, block);
if (part == "punch") ring_punch(inner_radius, outer_radius, depth, block);
if (part == "shoe") shoe(shoe_x, shoe_y, shoe_height, edge);
