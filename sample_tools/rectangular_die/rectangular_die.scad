// Rectangular cavity, 30 mm along the shoe's motion, 12 mm across, 15 mm deep (all sizes chosen for this sample).
include <../tooling.scad>
part = "die"; // die, punch, shoe
cavity_x = 30;
cavity_y = 12;
depth = 15;
block = 20;
margin = 4;
shoe_x = 32;
shoe_y = 16; // cavity + 4 mm
shoe_height = 46;

if (part == "die") {
  translate([0, 0, -block]) linear_extrude(block) difference() {
    square([2 * plate_half_x(cavity_x / 2, margin, shoe_x), 2 * plate_half_y(shoe_y)], center = true);
    square([cavity_x, cavity_y], center = true);
  }
}
if (part == "punch") {
  translate([0, 0, -block]) linear_extrude(block - depth)
    square([cavity_x - 2 * clearance, cavity_y - 2 * clearance], center = true);
}
if (part == "shoe") shoe(shoe_x, shoe_y, shoe_height);
