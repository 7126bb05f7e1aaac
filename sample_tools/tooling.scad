// Modules shared by all sample tools. Millimetres; z up; the die's top plane (fill plane) is z = 0.
// Circles are polygons with their corners on the circle: for 256 corners and a radius of 16 mm the facets are
// 0.39 mm long and lie at most 0.0012 mm inside it.
$fn = 256;

wall = 3;        // thickness of the shoe's walls
overhang = 1;    // of the die plate beyond the shoe, all around, at both ends of its travel
clearance = 0.02; // of the lower punch to die and core, each side: runs freely, holds the finest powder back

// Frame without bottom or lid, standing on the fill plane, centred on the origin. `edge`: the inner lower edge is
// cut off at 45 degrees so high, so that it pushes grains into the die where a sharp one would shear them off.
module shoe(inside_x, inside_y, height, edge = 0) {
  difference() {
    linear_extrude(height) square([inside_x + 2 * wall, inside_y + 2 * wall], center = true);
    translate([0, 0, -1]) linear_extrude(height + 2) square([inside_x, inside_y], center = true);
    if (edge > 0)
      linear_extrude(edge, scale = [inside_x / (inside_x + 2 * edge), inside_y / (inside_y + 2 * edge)])
        square([inside_x + 2 * edge, inside_y + 2 * edge], center = true);
  }
}

// Half the size along x of a plate on which a shoe starts and ends `margin` clear of a cavity reaching to `reach`.
function plate_half_x(reach, margin, shoe_x) = reach + margin + shoe_x + 2 * wall + overhang;
function plate_half_y(shoe_y) = shoe_y / 2 + wall + overhang;

// Block with a round bore right through.
module bored_block(half_x, half_y, height, radius) {
  translate([0, 0, -height]) linear_extrude(height) difference() {
    square([2 * half_x, 2 * half_y], center = true);
    circle(radius);
  }
}

// Solid rod, top flush with the fill plane.
module core_rod(radius, height) {
  translate([0, 0, -height]) linear_extrude(height) circle(radius);
}

// Lower punch of a ring: its top is the floor of the cavity.
module ring_punch(inner_radius, outer_radius, depth, height) {
  translate([0, 0, -height]) linear_extrude(height - depth) difference() {
    circle(outer_radius - clearance);
    circle(inner_radius + clearance);
  }
}

// Width of a ring that lets grains of size d pass as the real powder passes a ring 1.83 mm + 1.4 * 0.1 mm wide:
// width - 1.4 d is what counts (Bierwisch 2009, section 3.2.2).
function adjusted_width(free_width, d) = free_width + 1.4 * d;
