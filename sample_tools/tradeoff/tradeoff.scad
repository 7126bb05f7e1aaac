// Tools of the small scenes for charts of cost against error: prisms along y that reach beyond every periodic slice.
part = "block";   // block, floor, side_wall or slider
length_y = 40;
thickness = 2;

module prism(x_from, x_to, z_from, z_to) {
  translate([x_from, -length_y / 2, z_from]) cube([x_to - x_from, length_y, z_to - z_from]);
}

// Floor and piston of the pressed bed.
if (part == "block") prism(-20, 20, -thickness, 0);
// Angle of repose (Bierwisch 2009, section 4.1.3), half the size: a reservoir 0 < x < 20 whose bottom and left wall are the
// slider, over a floor 24 mm below it; the right wall goes down to the floor. z = 0 is the slider's upper face.
if (part == "floor") prism(-50, 22, -26, -24);
if (part == "side_wall") prism(20, 22, -24, 70);
if (part == "slider") {
  prism(-thickness, 20, -thickness, 0);
  prism(-thickness, 0, 0, 70);
}
