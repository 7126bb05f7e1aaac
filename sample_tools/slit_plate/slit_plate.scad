// Platen 2 mm thick with a slit across the shoe's motion (Bierwisch 2009, section 4.1.1), and the two walls of the shoe that lie
// across it, both as prisms along y: what a slice periodic in y needs. The experiment's slit is 33 mm long.
include <../tooling.scad>
part = "platen";   // platen or shoe
slit = 6;          // mm along x: 6 or 10; 8.63 and 12.63 for grains of 2.35 mm
length_y = 40;
thickness = 2;
margin = 34;       // room to reach 0.8 m/s at 10 m/s^2
shoe_x = 32;
shoe_height = 46;
widest = 10 / 2;

module prism(x_from, x_to, z_from, z_to) {
  translate([x_from, -length_y / 2, z_from]) cube([x_to - x_from, length_y, z_to - z_from]);
}

if (part == "platen") {
  half = plate_half_x(widest, margin, shoe_x);
  prism(-half, -slit / 2, -thickness, 0);
  prism(slit / 2, half, -thickness, 0);
} else {
  prism(-shoe_x / 2 - wall, -shoe_x / 2, 0, shoe_height);
  prism(shoe_x / 2, shoe_x / 2 + wall, 0, shoe_height);
}
