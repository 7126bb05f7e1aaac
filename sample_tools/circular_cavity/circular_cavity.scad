// Ring cavity 16/20 mm, 15 mm deep (Bierwisch 2009, section 4.1.7), widened by 1.4 (d - 0.47) mm for coarser grains.
include <../tooling.scad>
part = "die"; // die, core_rod, punch, shoe
d = 0.47;     // mm, model grain size the width is adjusted to
free_width = 2 - 1.4 * 0.47;
inner_radius = 8;
depth = 15;
block = 20;
margin = 14;  // room to reach 0.5 m/s at 10 m/s^2
shoe_x = 32;
shoe_y = 28;  // widest ring + 4 mm
shoe_height = 46;
widest = inner_radius + adjusted_width(free_width, 1.88);

outer_radius = inner_radius + adjusted_width(free_width, d);
if (part == "die")
  bored_block(plate_half_x(widest, margin, shoe_x), plate_half_y(shoe_y), block, outer_radius);
if (part == "core_rod") core_rod(inner_radius, block);
if (part == "punch") ring_punch(inner_radius, outer_radius, depth, block);
if (part == "shoe") shoe(shoe_x, shoe_y, shoe_height);
