// Press part of two levels: half of the cavity is 12 mm deep, the other 6 mm, each on a lower punch of its own.
include <../tooling.scad>
part = "die"; // die, punch_low, punch_high, shoe
cavity = [16, 10]; // along and across the motion
deep = 12;
shallow = 6;
block = 16;
margin = 4;
edge = 1.5;
shoe = [24, 14];
shoe_height = 28;

if (part == "die") translate([0, 0, -block]) linear_extrude(block) difference() {
  square([2 * plate_half_x(cavity.x / 2, margin, shoe.x), 2 * plate_half_y(shoe.y)], center = true);
  square(cavity, center = true);
}
if (part == "punch_low") punch(-1, deep);
if (part == "punch_high") punch(1, shallow);
if (part == "shoe") shoe(shoe.x, shoe.y, shoe_height, edge);

// The half at side * x > 0, smaller by the clearance on all sides.
module punch(side, depth) {
  translate([side * cavity.x / 4, 0, -block]) linear_extrude(block - depth)
    square([cavity.x / 2 - 2 * clearance, cavity.y - 2 * clearance], center = true);
}
