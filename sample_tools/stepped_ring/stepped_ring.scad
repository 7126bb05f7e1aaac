// Stepped ring: a narrow lower ring and a wide upper ring round one core (Bierwisch 2009, section 6.2; sizes assumed).
include <../tooling.scad>
part = "die"; // die, core_rod, punch, shoe
inner_radius = 8;
lower_width = 3.15;
upper_width = 8;
upper_depth = 10;
depth = 20;
block = 25;
margin = 4;
shoe_x = 32;
shoe_y = 36;  // outer diameter + 4 mm
shoe_height = 46;

lower_radius = inner_radius + lower_width;
upper_radius = inner_radius + upper_width;
if (part == "die") {
  difference() {
    bored_block(plate_half_x(upper_radius, margin, shoe_x), plate_half_y(shoe_y), block, lower_radius);
    translate([0, 0, -upper_depth]) cylinder(r = upper_radius, h = upper_depth + 1);
  }
}
if (part == "core_rod") core_rod(inner_radius, block);
if (part == "punch") ring_punch(inner_radius, lower_radius, depth, block);
if (part == "shoe") shoe(shoe_x, shoe_y, shoe_height);
