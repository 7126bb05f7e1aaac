// Small dies and shoes for many cheap runs: how far estimates are off, and errors over the grain size. All cavities
// are 10 mm deep; shoes are 24 mm high, their inner lower edge is chamfered as that of the narrow ring.
include <../tooling.scad>
part = "die"; // die, core_rod, punch, shoe
shape = "square"; // square, slot, ring, pair, gear
width = 8;      // of the square and the ring
slot = [6, 16]; // along and across the motion
depth = 10;
block = 14;
margin = 4;
edge = 1.5;
shoe_height = 24;
inner_radius = 5;   // of the ring
gear_teeth = 8;
gear_tip = 20;
gear_root = 13;
gear_core = 6;

shoe_x = shape == "gear" ? 44 : 24;
shoe_y = shape == "square" ? width + 4 : shape == "ring" ? 2 * (inner_radius + width) + 4 : shape == "pair" ? 16 : shape == "slot" ? slot.y + 4 : 44;
reach = shape == "ring" ? inner_radius + width : shape == "pair" ? 13 : shape == "gear" ? gear_tip : shape == "slot" ? slot.x / 2 : width / 2;

if (part == "die") translate([0, 0, -block]) linear_extrude(block) difference() {
  square([2 * plate_half_x(reach, margin, shoe_x), 2 * plate_half_y(shoe_y)], center = true);
  cavity(0);
}
if (part == "punch") translate([0, 0, -block]) linear_extrude(block - depth) difference() {
  cavity(clearance);
  if (shape == "ring") circle(inner_radius + clearance);
  if (shape == "gear") circle(gear_core + clearance);
}
if (part == "core_rod") core_rod(shape == "gear" ? gear_core : inner_radius, block);
if (part == "shoe") shoe(shoe_x, shoe_y, shoe_height, edge);

// Seen from above, smaller by `play` on all sides.
module cavity(play) {
  if (shape == "square") square(width - 2 * play, center = true);
  if (shape == "slot") square([slot.x - 2 * play, slot.y - 2 * play], center = true);
  if (shape == "ring") circle(inner_radius + width - play);
  if (shape == "gear") polygon(gear_outline(play));
  if (shape == "pair") {
    // The first is long along the motion, the second across it.
    translate([6, 0]) square([14 - 2 * play, 7 - 2 * play], center = true);
    translate([-9, 0]) square([8 - 2 * play, 12 - 2 * play], center = true);
  }
}

function polar(radius, angle) = [radius * cos(angle), radius * sin(angle)];
// Straight flanks: each tooth takes half of its share at the root and a quarter at the tip.
function gear_outline(play) = let (share = 360 / gear_teeth) [
  for (k = [0:gear_teeth - 1], corner = [[gear_root, -0.3], [gear_tip, -0.16], [gear_tip, 0.16], [gear_root, 0.3]])
    polar(corner[0] - play, (k + corner[1]) * share)];
