// Stepped ring: a narrow lower ring and a wide upper ring round one core (Bierwisch 2009, section 6.2; sizes assumed).
include <../tooling.scad>
part = "die"; // die, core_rod, punch, punch_long, shoe
inner_radius = 8;
lower_width = 3.15;
upper_width = 8;
upper_depth = 10;
depth = 20;
block = 25;
margin = 4;
shoe_x = 32;
shoe_y = 36;  // outer diameter + 4 mm
shoe_height = 46;

lower_radius = inner_radius + lower_width;
upper_radius = inner_radius + upper_width;
if (part == "die")
  counterbored_block(plate_half_x(upper_radius, margin, shoe_x), plate_half_y(shoe_y), block, lower_radius,
                     upper_radius, upper_depth);
if (part == "core_rod") core_rod(inner_radius, block);
if (part == "punch") ring_punch(inner_radius, lower_radius, depth, block);
// With its top at the rim it still closes the lower part, whose powder would run out beneath a shorter one.
if (part == "punch_long") ring_punch(inner_radius, lower_radius, depth, block + depth);
if (part == "shoe") shoe(shoe_x, shoe_y, shoe_height);

// Block with a bore that is wider down to `upper_depth`. Facet by facet, because OpenSCAD's Boolean operations write
// their facets in another order every time.
module counterbored_block(half_x, half_y, height, lower_radius, upper_radius, upper_depth) {
  n = $fn;
  circles = [[upper_radius, 0], [upper_radius, -upper_depth], [lower_radius, -upper_depth], [lower_radius, -height]];
  corners = [[half_x, half_y], [-half_x, half_y], [-half_x, -half_y], [half_x, -half_y]]; // one a quadrant
  points = concat(
    [for (c = circles, i = [0:n - 1]) [c[0] * cos(360 * i / n), c[0] * sin(360 * i / n), c[1]]],
    [for (z = [0, -height], c = corners) [c[0], c[1], z]]);
  function on_circle(circle, i) = circle * n + i % n;
  function corner(level, k) = len(circles) * n + level * 4 + k % 4;
  function quadrant(i) = floor(4 * i / n);
  bore = [for (c = [0:2], i = [0:n - 1])
    [on_circle(c, i), on_circle(c + 1, i), on_circle(c + 1, i + 1), on_circle(c, i + 1)]];
  top = concat([for (i = [0:n - 1]) [on_circle(0, i), on_circle(0, i + 1), corner(0, quadrant(i))]],
               [for (k = [0:3]) [on_circle(0, (k + 1) * n / 4), corner(0, k + 1), corner(0, k)]]);
  bottom = concat([for (i = [0:n - 1]) [on_circle(3, i + 1), on_circle(3, i), corner(1, quadrant(i))]],
                  [for (k = [0:3]) [on_circle(3, (k + 1) * n / 4), corner(1, k), corner(1, k + 1)]]);
  sides = [for (k = [0:3]) [corner(0, k), corner(0, k + 1), corner(1, k + 1), corner(1, k)]];
  polyhedron(points, concat(bore, top, bottom, sides));
}
