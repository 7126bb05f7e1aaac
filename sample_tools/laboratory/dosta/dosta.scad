// Tools of the bulk processes of Dosta et al. 2024 (dimensions measured from their files), millimetres, z up.
part = "silo";   // silo, gate, box, ball or drum
orifice = 30;    // radius of the silo's opening: 30 (large) or 20 (small)
wall = 2;
$fn = 128;

// Cylinder of 100 mm inner radius and 300 mm height on a cone of 45 degrees; z = 0 where the two meet.
silo_radius = 100;
silo_height = 300;
silo_wall = 8;   // outside nothing is met: thick, so that few wall spheres cover it
cone = silo_radius - orifice;
if (part == "silo") rotate_extrude() polygon([
  [orifice, -cone], [orifice + silo_wall, -cone], [silo_radius + silo_wall, 0], [silo_radius + silo_wall, silo_height],
  [silo_radius, silo_height], [silo_radius, 0]]);
// Closes the opening until the powder rests; z = 0 at its upper face.
if (part == "gate") translate([-40, -40, -wall]) cube([80, 80, wall]);

// Inside 98 x 60 mm, floor at z = -90.2431 mm.
floor_at = -90.2431;
if (part == "box") difference() {
  translate([-51, -32, floor_at - wall]) cube([102, 64, 200]);
  translate([-49, -30, floor_at]) cube([98, 60, 300]);
}
if (part == "ball") sphere(r = 10, $fn = 64);

// Axis along y; 60 mm long inside, closed at both ends.
if (part == "drum") rotate([90, 0, 0]) difference() {
  cylinder(r = 102, h = 64, center = true);
  cylinder(r = 100, h = 60, center = true);
}
