// Gear: 20 teeth of module 2 mm round a core rod and four thin ones; the die's mouth has a chamfer (sizes assumed).
include <../tooling.scad>
part = "die"; // die, core_rods, punch, shoe
teeth = 20;
module_size = 2;
pressure_angle = 20;
depth = 15;
block = 20;
margin = 4;
shoe_x = 52;
shoe_y = 48;
shoe_height = 40;
core = 8;       // radius of the core rod
pin = 2;        // radius of the thin rods
pins_at = 12.75;
mouth = 0.5;    // height of the chamfer; it widens by as much at the tips
flank_points = 12;

pitch = module_size * teeth / 2;
tip = pitch + module_size;
root = pitch - 1.25 * module_size;
base = pitch * cos(pressure_angle);
margin_x = plate_half_x(tip, margin, shoe_x);

if (part == "die") die();
if (part == "core_rods") core_rods(0, block);
if (part == "punch")
  translate([0, 0, -block]) linear_extrude(block - depth) difference() {
    polygon(outline(clearance));
    circle(core + clearance);
    for (k = [0:3]) rotate(45 + 90 * k) translate([pins_at, 0]) circle(pin + clearance);
  }
if (part == "shoe") shoe(shoe_x, shoe_y, shoe_height);

module die() {
  difference() {
    translate([0, 0, -block]) linear_extrude(block) square([2 * margin_x, 2 * plate_half_y(shoe_y)], center = true);
    translate([0, 0, -block - 1]) linear_extrude(block + 2) polygon(outline(0));
    // Through the top plane with the same slope, so that no two faces of the difference lie in one plane.
    translate([0, 0, -mouth]) linear_extrude(2 * mouth, scale = (tip + 2 * mouth) / tip) polygon(outline(0));
  }
}

module core_rods(play, height) {
  core_rod(core, height);
  for (k = [0:3]) rotate(45 + 90 * k) translate([pins_at, 0, 0]) core_rod(pin, height);
}

function degrees_of(radians) = radians * 180 / PI;
function involute(angle) = tan(angle) - angle * PI / 180; // rad, of an angle in degrees
// Half the angle of a tooth at a radius, in degrees. An involute moved inwards by `play` is the same one turned.
function half_tooth(radius, play) =
  90 / teeth + degrees_of(involute(pressure_angle) - involute(radius > base ? acos(base / radius) : 0) - play / base);
function polar(radius, angle) = [radius * cos(angle), radius * sin(angle)];
function arc(radius, from, to, n) = [for (i = [1:n - 1]) polar(radius, from + (to - from) * i / n)];
// One tooth from the middle of a gap to the middle of the next, counter-clockwise.
function tooth(middle, play) = let (
    t = tip - play, r = root - play, foot = half_tooth(base, play), head = half_tooth(t, play), step = (t - base) / (flank_points - 1))
  concat(
    [polar(r, middle - foot)],
    [for (i = [0:flank_points - 1]) polar(base + i * step, middle - half_tooth(base + i * step, play))],
    arc(t, middle - head, middle + head, 8),
    [for (i = [flank_points - 1:-1:0]) polar(base + i * step, middle + half_tooth(base + i * step, play))],
    [polar(r, middle + foot)],
    arc(r, middle + foot, middle + 360 / teeth - foot, 6));
function outline(play) = [for (k = [0:teeth - 1], p = tooth(360 / teeth * k, play)) p];
