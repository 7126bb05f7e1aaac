// Platen 2 mm thick with a slit across the shoe's motion (Bierwisch 2009, section 4.1.1), for periodic slices in y.
// It goes with shoe/shoe_tall.stl.
include <../tooling.scad>
slit = 6;          // mm along x: 6 or 10
slit_length = 33;  // mm along y
thickness = 2;
margin = 34;       // room to reach 0.8 m/s at 10 m/s^2
shoe_x = 32;
shoe_y = 50;
widest = 10 / 2;

translate([0, 0, -thickness]) linear_extrude(thickness) difference() {
  square([2 * plate_half_x(widest, margin, shoe_x), 2 * plate_half_y(shoe_y)], center = true);
  square([slit, slit_length], center = true);
}
