// Writes the sample tools as STEP files (and one as IGES) with curved surfaces where the STL files have
// facets: one file a press, its parts named as in the scenes. Needs OpenCASCADE; make.sh compiles and runs
// it. Millimetres, z up, fill plane z = 0.
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESControl_Controller.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr double kWall = 3;  // as in tooling.scad
constexpr double kOverhang = 1;
constexpr double kClearance = 0.02;
constexpr double kMargin = 4;

using Parts = std::vector<std::pair<std::string, TopoDS_Shape>>;

TopoDS_Shape block(double half_x, double half_y, double bottom, double top) {
  return BRepPrimAPI_MakeBox(gp_Pnt(-half_x, -half_y, bottom), gp_Pnt(half_x, half_y, top)).Shape();
}

TopoDS_Shape rod(double radius, double bottom, double top, double x = 0, double y = 0) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, bottom), gp_Dir(0, 0, 1)), radius, top - bottom)
      .Shape();
}

TopoDS_Shape cut(const TopoDS_Shape& from, const TopoDS_Shape& what) {
  return BRepAlgoAPI_Cut(from, what).Shape();
}

TopoDS_Shape shoe(double inside_x, double inside_y, double height, double edge = 0) {
  const TopoDS_Shape outside = block(inside_x / 2 + kWall, inside_y / 2 + kWall, 0, height);
  TopoDS_Shape frame = cut(outside, block(inside_x / 2, inside_y / 2, -1, height + 1));
  if (edge <= 0) return frame;
  BRepOffsetAPI_ThruSections bevel(true, true);
  for (const auto& [grown, z] : {std::pair{edge, 0.0}, {0.0, edge}}) {
    BRepBuilderAPI_MakeWire wire;
    const double x = inside_x / 2 + grown, y = inside_y / 2 + grown;
    const gp_Pnt corner[4] = {{x, y, z}, {-x, y, z}, {-x, -y, z}, {x, -y, z}};
    for (int k = 0; k < 4; ++k) wire.Add(BRepBuilderAPI_MakeEdge(corner[k], corner[(k + 1) % 4]).Edge());
    bevel.AddWire(wire.Wire());
  }
  return cut(frame, bevel.Shape());
}

double plate_half_x(double reach, double shoe_x) {
  return reach + kMargin + shoe_x + 2 * kWall + kOverhang;
}

double plate_half_y(double shoe_y) {
  return shoe_y / 2 + kWall + kOverhang;
}

Parts narrow_ring(double width) {
  const double inner = 8, outer = 8 + width, depth = 20, height = 25, shoe_x = 32, shoe_y = 29;
  const TopoDS_Shape plate = block(plate_half_x(outer, shoe_x), plate_half_y(shoe_y), -height, 0);
  return {
      {"die", cut(plate, rod(outer, -height - 1, 1))},
      {"core rod", rod(inner, -height, 0)},
      {"lower punch", cut(rod(outer - kClearance, -height, -depth), rod(inner + kClearance, -height - 1, 0))},
      {"shoe", shoe(shoe_x, shoe_y, 24, 1.5)}};
}

Parts stepped_ring() {
  const double inner = 8, lower = 11.15, upper = 16, step = 10, depth = 20, height = 25, shoe_x = 32,
               shoe_y = 36;
  const TopoDS_Shape plate = block(plate_half_x(upper, shoe_x), plate_half_y(shoe_y), -height, 0);
  return {
      {"die", cut(cut(plate, rod(lower, -height - 1, 1)), rod(upper, -step, 1))},
      {"core rod", rod(inner, -height, 0)},
      {"lower punch", cut(rod(lower - kClearance, -height, -depth), rod(inner + kClearance, -height - 1, 0))},
      {"shoe", shoe(shoe_x, shoe_y, 46)}};
}

// Gear of gear.scad: teeth of involute flanks. An involute moved inwards by `play` is the same one turned by
// play over the radius of its base circle.
constexpr int kTeeth = 20;
constexpr double kModule = 2, kPressureAngle = 20 * std::numbers::pi / 180;
constexpr double kPitch = kModule * kTeeth / 2, kTip = kPitch + kModule, kRoot = kPitch - 1.25 * kModule;
constexpr int kFlankPoints = 12;

double involute(double angle) {
  return std::tan(angle) - angle;
}

gp_Pnt polar(double radius, double angle, double z) {
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

// Half the angle of a tooth at `radius`, seen from the axis.
double half_tooth(double radius, double play) {
  const double base = kPitch * std::cos(kPressureAngle);
  const double at = radius > base ? std::acos(base / radius) : 0;
  return std::numbers::pi / (2 * kTeeth) + involute(kPressureAngle) - involute(at) - play / base;
}

TopoDS_Edge arc(double radius, double from, double to, double z) {
  return BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(polar(radius, from, z), polar(radius, (from + to) / 2, z),
                                                    polar(radius, to, z))
                                     .Value())
      .Edge();
}

TopoDS_Edge flank(double side, double middle, double tip, double play, double z) {
  const double base = kPitch * std::cos(kPressureAngle);
  Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, kFlankPoints);
  for (int i = 0; i < kFlankPoints; ++i) {
    const double part = double(i) / (kFlankPoints - 1);
    const double radius = side < 0 ? base + part * (tip - base) : tip + part * (base - tip);
    points->SetValue(i + 1, polar(radius, middle + side * half_tooth(radius, play), z));
  }
  GeomAPI_Interpolate curve(points, false, 1e-9);
  curve.Perform();
  return BRepBuilderAPI_MakeEdge(curve.Curve()).Edge();
}

TopoDS_Wire gear_outline(double play, double z) {
  const double base = kPitch * std::cos(kPressureAngle), tip = kTip - play, root = kRoot - play;
  const double pitch_angle = 2 * std::numbers::pi / kTeeth, foot = half_tooth(base, play),
               head = half_tooth(tip, play);
  BRepBuilderAPI_MakeWire wire;
  for (int k = 0; k < kTeeth; ++k) {
    const double middle = k * pitch_angle;
    wire.Add(BRepBuilderAPI_MakeEdge(polar(root, middle - foot, z), polar(base, middle - foot, z)).Edge());
    wire.Add(flank(-1, middle, tip, play, z));
    wire.Add(arc(tip, middle - head, middle + head, z));
    wire.Add(flank(1, middle, tip, play, z));
    wire.Add(BRepBuilderAPI_MakeEdge(polar(base, middle + foot, z), polar(root, middle + foot, z)).Edge());
    wire.Add(arc(root, middle + foot, middle + pitch_angle - foot, z));
  }
  return wire.Wire();
}

TopoDS_Shape gear(double play, double bottom, double top) {
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(gear_outline(play, bottom), true).Face(),
                               gp_Vec(0, 0, top - bottom))
      .Shape();
}

// The mouth widens over the last 0.5 mm, as linear_extrude with a scale does.
TopoDS_Shape chamfer(double size) {
  gp_Trsf grow;
  grow.SetScale(gp_Pnt(0, 0, 0), (kTip + size) / kTip);
  const TopoDS_Shape wide = BRepBuilderAPI_Transform(gear_outline(0, 0), grow, true).Shape();
  BRepOffsetAPI_ThruSections mouth(true, true);
  mouth.AddWire(gear_outline(0, -size));
  mouth.AddWire(TopoDS::Wire(wide));
  mouth.CheckCompatibility(false);
  return mouth.Shape();
}

Parts gear_press() {
  const double core = 8, pin = 2, pins_at = 12.75, depth = 15, height = 20, shoe_x = 52, shoe_y = 48;
  TopoDS_Shape die =
      cut(block(plate_half_x(kTip, shoe_x), plate_half_y(shoe_y), -height, 0), gear(0, -height - 1, 1));
  die = cut(die, chamfer(0.5));
  TopoDS_Shape punch = cut(gear(kClearance, -height, -depth), rod(core + kClearance, -height - 1, 0));
  TopoDS_Compound rods;
  BRep_Builder builder;
  builder.MakeCompound(rods);
  builder.Add(rods, rod(core, -height, 0));
  for (int k = 0; k < 4; ++k) {
    const double angle = (k + 0.5) * std::numbers::pi / 2, x = pins_at * std::cos(angle),
                 y = pins_at * std::sin(angle);
    punch = cut(punch, rod(pin + kClearance, -height - 1, 0, x, y));
    builder.Add(rods, rod(pin, -height, 0, x, y));
  }
  return {{"die", die}, {"core rods", rods}, {"lower punch", punch}, {"shoe", shoe(shoe_x, shoe_y, 40)}};
}

// Blade of laboratory.scad across its radius: the leading face rises backwards at `angle` from y = 0.
TopoDS_Wire blade_section(double radius, double height) {
  const double angle = 32 * std::numbers::pi / 180, thickness = 2, clearance = 1;
  const double back = -height / std::tan(angle), under = back - thickness * std::sin(angle),
               rise = height - thickness * std::cos(angle), foot = under + rise / std::tan(angle);
  const std::pair<double, double> corners[4] = {{0, 0}, {back, height}, {under, rise}, {foot, 0}};
  BRepBuilderAPI_MakeWire wire;
  for (int k = 0; k < 4; ++k) {
    const auto &from = corners[k], &to = corners[(k + 1) % 4];
    wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(radius, from.first, clearance + from.second),
                                     gp_Pnt(radius, to.first, clearance + to.second))
                 .Edge());
  }
  return wire.Wire();
}

// Vertical mixer of laboratory.scad.
Parts mixer() {
  const double inside = 42, wall = 2, height = 100, hub = 8, hub_top = 13, reach = 41;
  BRepOffsetAPI_ThruSections blade(true, true);
  blade.AddWire(blade_section(hub / 2, 8));
  blade.AddWire(blade_section(reach + 0.1, 5));
  const TopoDS_Shape trimmed = BRepAlgoAPI_Common(blade.Shape(), rod(reach, 0, hub_top)).Shape();
  TopoDS_Shape impeller = rod(hub, 1, hub_top);
  for (int k = 0; k < 3; ++k) {
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 2 * std::numbers::pi / 3 * k);
    impeller = BRepAlgoAPI_Fuse(impeller, BRepBuilderAPI_Transform(trimmed, turn, true).Shape()).Shape();
  }
  return {{"vessel", cut(rod(inside + wall, -wall, height), rod(inside, 0, height + 1))},
          {"impeller", impeller}};
}

Handle(TDocStd_Document) document_of(const Parts& parts) {
  Handle(TDocStd_Document) document = new TDocStd_Document("parts");
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  for (const auto& [name, shape] : parts)
    TDataStd_Name::Set(shapes->AddShape(shape, false), TCollection_ExtendedString(name.c_str()));
  return document;
}

bool write_iges(const std::string& file, const Parts& parts) {
  IGESControl_Controller::Init();
  Interface_Static::SetIVal("write.iges.brep.mode", 1);
  IGESCAFControl_Writer writer;
  return writer.Transfer(document_of(parts)) && writer.Write(file.c_str());
}

bool write(const std::string& file, const Parts& parts) {
  STEPCAFControl_Writer writer;
  Interface_Static::SetCVal("write.step.product.name", "diefill sample");
  Interface_Static::SetIVal("write.surfacecurve.mode", 0);
  return writer.Transfer(document_of(parts)) && writer.Write(file.c_str()) == IFSelect_RetDone;
}

}  // namespace

int main() {
  const std::map<std::string, Parts> presses = {
      {"narrow_ring/narrow_ring_d1.88.step", narrow_ring(1.83 + 1.4 * 1.88)},
      {"stepped_ring/stepped_ring.step", stepped_ring()},
      {"shoe/shoe.step", {{"shoe", shoe(32, 50, 37)}}},
      {"gear/gear.step", gear_press()},
      {"laboratory/mixer.step", mixer()}};
  for (const auto& [file, parts] : presses)
    if (!write(file, parts)) {
      std::cerr << file << " was not written\n";
      return 1;
    }
  return write_iges("shoe/shoe.igs", {{"shoe", shoe(32, 50, 37)}}) ? 0 : 1;
}
