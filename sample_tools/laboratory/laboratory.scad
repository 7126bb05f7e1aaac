// Tools of the laboratory's scenes, millimetres, z up. Prisms along y reach beyond every periodic slice.
part = "half_platen";   // half_platen, floor, side_wall, slider, funnel, cup, cup_floor, gate or tray
length_y = 40;
thickness = 2;
$fn = 128;

module prism(x_from, x_to, z_from, z_to) {
  translate([x_from, -length_y / 2, z_from]) cube([x_to - x_from, length_y, z_to - z_from]);
}

// Half of a platen (Bierwisch 2009, section 4.1.1): its edge is at x = 0; two of them, one mirrored, leave a slit.
if (part == "half_platen") prism(0, 100, -thickness, 0);

// Angle of repose (Bierwisch 2009, section 4.1.3): a reservoir 0 < x < 30 whose bottom and left wall are the slider,
// over a floor 42 mm below it; the right wall goes down to the floor. z = 0 is the slider's upper face.
if (part == "floor") prism(-80, 32, -44, -42);
if (part == "side_wall") prism(30, 32, -42, 110);
if (part == "slider") {
  prism(-thickness, 30, -thickness, 0);
  prism(-thickness, 0, 0, 110);
}
