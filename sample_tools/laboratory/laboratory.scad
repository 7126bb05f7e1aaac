// Tools of the laboratory's scenes, millimetres, z up. Prisms along y reach beyond every periodic slice.
// half_platen, floor, side_wall, slider, funnel, cup, gate, wide_floor, heap_plate, lid, mixer_vessel, mixer_impeller,
// shear_cell, shear_head or disc
part = "half_platen";
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

// Funnel and cup of apparent density and Hall flow (ISO 3923-1, ISO 4490): cone of 60 degrees, stem of 3.2 mm, cup of
// 28 mm inside diameter and 25 cm3, 25 mm between them. scale_of = 0.5: half of these lengths, for coarse grains. Model
// grains larger than the powder take a wider orifice. z = 0 is the cup's rim; funnel and gate have z = 0 at the orifice.
orifice = 5;
scale_of = 1;
stem = 3.2;
funnel_radius = 28 * scale_of;
cup_radius = 14 * scale_of;
cup_depth = 25000 / (PI * 14 * 14) * scale_of;
cone_height = (funnel_radius - orifice / 2) / tan(30);
if (part == "funnel") difference() {
  cylinder(r = funnel_radius + 2, h = stem + cone_height);
  translate([0, 0, -1]) cylinder(r = orifice / 2, h = stem + 2);
  translate([0, 0, stem]) cylinder(r1 = orifice / 2, r2 = funnel_radius, h = cone_height);
  translate([0, 0, stem + cone_height]) cylinder(r = funnel_radius, h = 1);
}
if (part == "cup") translate([0, 0, -cup_depth - 2]) difference() {
  cylinder(r = cup_radius + 2, h = cup_depth + 2);
  translate([0, 0, 2]) cylinder(r = cup_radius, h = cup_depth + 1);
}
if (part == "gate") translate([-10, -10, -2]) cube([20, 20, 2]);

// Floor of wide periodic beds; plate of a heap (Hu 2024, section 5.3).
if (part == "wide_floor") translate([-150, -150, -thickness]) cube([300, 300, thickness]);
if (part == "heap_plate") translate([-28, -28, -thickness]) cube([56, 56, thickness]);

// Lid with a blade across the slice, 1 mm thick, over all of a period (Bierwisch 2009, section 4.2.4): lid_3.5mm.stl,
// lid_4.5mm.stl. The blade is to end about a grain above the plate under 5 mm of powder.
blade = 3.5;
if (part == "lid") {
  prism(-20, 20, 0, thickness);
  prism(-0.5, 0.5, -blade, thickness);
}

// Vertical mixer (Hu 2024, section 4.3): a vessel of 84 mm inside diameter, z = 0 at its floor, and an impeller of three
// flat blades that turns counter-clockwise. Height, hub and blades are not published: assumptions.
vessel_radius = 42;
vessel_height = 100;
hub_radius = 8;
hub_height = 12;
blades = 3;
blade_radius = 41;
blade_thickness = 2;
blade_at_hub = 8;      // height
blade_at_tip = 5;
blade_angle = 32;      // of the leading face to the horizontal
clearance = 1;         // below the blades
mixer_sides = 64;      // of circles: few triangles, as walls are meshes
if (part == "mixer_vessel") translate([0, 0, -thickness]) difference() {
  cylinder(r = vessel_radius + thickness, h = vessel_height + thickness, $fn = mixer_sides);
  translate([0, 0, thickness]) cylinder(r = vessel_radius, h = vessel_height + 1, $fn = mixer_sides);
}
// Cross-section of a blade across its radius: the leading face rises backwards from the origin.
module blade_section(height) {
  back = -height / tan(blade_angle);
  under = [back - blade_thickness * sin(blade_angle), height - blade_thickness * cos(blade_angle)];
  polygon([[0, 0], [back, height], under, [under[0] + under[1] / tan(blade_angle), 0]]);
}
module slice_at(radius, height) {
  translate([radius, 0, 0]) rotate([90, 0, 90]) linear_extrude(0.1) blade_section(height);
}
if (part == "mixer_impeller") translate([0, 0, clearance]) {
  cylinder(r = hub_radius, h = hub_height, $fn = mixer_sides);
  intersection() {
    for (k = [0:blades - 1]) rotate(360 / blades * k) hull() {
      slice_at(hub_radius / 2, blade_at_hub);
      slice_at(blade_radius, blade_at_tip);
    }
    cylinder(r = blade_radius, h = hub_height, $fn = mixer_sides);
  }
}
// Powder tester (Kottlan 2018, section 2.7.4): a cell with vanes on its floor, a head with vanes pointing down, a smooth
// disc. Lengths in grain diameters; scenes give the diameter as length_unit. z = 0 is the cell's floor, and the lower
// face of disc and head.
bore = 10;             // of the cell
cell_height = 40;
vanes = 8;
vane_depth = 3 * bore / 16;  // 3 in the cell of 16, which the others are scaled from
vane_thickness = 0.4;
floor_vane = 1;        // height of those on the floor
gap = 0.15;            // between head and cell
module vane_star(from, to, z_from, z_to) {
  for (k = [0 : vanes - 1]) rotate(360 * k / vanes)
    translate([from, -vane_thickness / 2, z_from]) cube([to - from, vane_thickness, z_to - z_from]);
}
if (part == "shear_cell") {
  difference() {
    translate([-bore / 2 - 1.6, -bore / 2 - 1.6, -2]) cube([bore + 3.2, bore + 3.2, cell_height + 2]);
    cylinder(d = bore, h = cell_height + 1, $fn = 64);
  }
  vane_star(bore / 10, bore / 2 + 0.5, -0.5, floor_vane);
}
if (part == "shear_head") {
  cylinder(r = bore / 2 - gap, h = 2, $fn = 64);
  vane_star(bore / 10, bore / 2 - 2 * gap, -vane_depth, 0.5);
}
if (part == "disc") cylinder(r = bore / 2 - gap, h = 2, $fn = 64);
