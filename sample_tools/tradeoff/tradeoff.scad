// Tools of the small scenes for charts of cost against error: prisms that reach beyond every periodic slice.
part = "block";   // block, floor, side_wall or slider
length_y = 40;
thickness = 2;

module prism(x_from, x_to, z_from, z_to) {
  translate([x_from, -length_y / 2, z_from]) cube([x_to - x_from, length_y, z_to - z_from]);
}

if (part == "block") prism(-20, 20, -thickness, 0);
// Angle of repose: a reservoir 0 < x < 20 whose floor and left wall are the slider; the right wall goes down to the floor.
if (part == "floor") prism(-60, 20 + thickness, -thickness, 0);
if (part == "side_wall") prism(20, 20 + thickness, -thickness, 90);
if (part == "slider") {
  prism(-thickness, 20, -thickness, 0);
  prism(-thickness, 0, -thickness, 66);
}
