#include "geometry/cad/opencascade/step_and_iges.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_BasicEditor.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace diefill::geometry {

namespace {

constexpr double kMillimetre = 1e-3;     // OpenCASCADE turns every file's coordinates into millimetres
constexpr double kWidestSeam = 0.01;     // mm, between faces of one part
constexpr double kLargestTurn = 0.35;    // rad between neighbouring facets of a small radius
constexpr double kLargestPart = 1e4;     // mm; the unit of a larger one is wrong
constexpr double kChordOverSize = 1e-4;  // of such a part: finer ones take minutes and gigabytes

/// A part with its shape in millimetres.
struct Solid {
  std::string name;
  TopoDS_Shape shape;
  std::vector<std::string> assemblies;  ///< as CadPart has them
};

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return "";
  std::string text(static_cast<std::size_t>(name->Get().LengthOfCString()) + 1, '\0');
  Standard_PCharacter bytes = text.data();
  name->Get().ToUTF8CString(bytes);
  return text.c_str();
}

bool has(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  return TopExp_Explorer(shape, kind).More();
}

/// Walks down the assembly; a product without components is a part, named after the product rather than its
/// place in the assembly, which exporters number.
class Collector {
 public:
  void add(const TDF_Label& label, const TopLoc_Location& above, const std::string& name,
           std::vector<std::string> assemblies) {
    TDF_Label product = label;
    TopLoc_Location place = above;
    if (XCAFDoc_ShapeTool::IsReference(label)) {
      XCAFDoc_ShapeTool::GetReferredShape(label, product);
      place = above * XCAFDoc_ShapeTool::GetLocation(label);
    }
    const std::string own = name_of(product);
    const std::string called = own.empty() ? (name.empty() ? name_of(label) : name) : own;
    if (XCAFDoc_ShapeTool::IsAssembly(product)) {
      assemblies.push_back(called + "#" + std::to_string(++places_));
      TDF_LabelSequence components;
      XCAFDoc_ShapeTool::GetComponents(product, components);
      for (const TDF_Label& component : components) add(component, place, name_of(component), assemblies);
      return;
    }
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(product);
    if (!shape.IsNull() && has(shape, TopAbs_FACE))
      solids_.push_back({called, shape.Moved(place), std::move(assemblies)});
  }

  std::vector<Solid> take() { return std::move(solids_); }

 private:
  std::vector<Solid> solids_;
  std::size_t places_ = 0;
};

std::vector<Solid> solids_of(const Handle(TDocStd_Document) & document) {
  Collector collector;
  TDF_LabelSequence roots;
  XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetFreeShapes(roots);
  for (const TDF_Label& root : roots) collector.add(root, {}, "", {});
  return collector.take();
}

/// Faces sewn along their edges; wider where closer leaves edges open, as files of loose surfaces are no
/// better than that.
TopoDS_Shape sewn(const std::vector<TopoDS_Shape>& shapes, double tolerance) {
  for (const double width : {tolerance, std::max(tolerance, kWidestSeam)}) {
    BRepBuilderAPI_Sewing sewing(width);
    for (const TopoDS_Shape& shape : shapes) sewing.Add(shape);
    sewing.Perform();
    if (sewing.NbFreeEdges() == 0 || width >= kWidestSeam) return sewing.SewedShape();
  }
  return {};
}

/// Faces that belong to no solid: those of a product are sewn together. IGES files name each face by itself,
/// so that all of them are one part there.
void sew_loose_faces(std::vector<Solid>& solids, double tolerance, bool all_are_one) {
  std::vector<TopoDS_Shape> loose;
  std::string name;
  for (Solid& solid : solids) {
    if (has(solid.shape, TopAbs_SOLID)) continue;
    if (!all_are_one) {
      solid.shape = sewn({solid.shape}, tolerance);
      continue;
    }
    if (loose.empty()) name = solid.name;
    loose.push_back(solid.shape);
  }
  if (loose.empty()) return;
  std::erase_if(solids, [](const Solid& solid) { return !has(solid.shape, TopAbs_SOLID); });
  solids.push_back({name, sewn(loose, tolerance), {}});
}

/// Triangles in place of faces, which AP242 files may hold, are none of what OpenCASCADE 7.6 reads.
void refuse_tessellation(const std::string& bytes) {
  for (const char* const word : {"TESSELLATED_SOLID", "TESSELLATED_SHELL", "TRIANGULATED_FACE",
                                 "COMPLEX_TRIANGULATED_FACE", "TRIANGULATED_SURFACE_SET"})
    if (bytes.find(word) != std::string::npos)
      throw std::runtime_error(
          "it contains only triangles (tessellated shapes of AP242), which OpenCASCADE 7.6 cannot read: "
          "export STEP with solids (AP203, AP214 or AP242 with exact geometry), or STL");
}

void add_face(const TopoDS_Face& face, Mesh& mesh) {
  TopLoc_Location place;
  const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, place);
  if (triangulation.IsNull()) throw std::runtime_error("one of its faces cannot be triangulated");
  const gp_Trsf& pose = place.Transformation();
  const int offset = static_cast<int>(mesh.vertices.size()) - 1;
  for (int i = 1; i <= triangulation->NbNodes(); ++i) {
    const gp_Pnt node = triangulation->Node(i).Transformed(pose);
    mesh.vertices.emplace_back(node.X(), node.Y(), node.Z());
  }
  const bool turned = (face.Orientation() == TopAbs_REVERSED) != pose.IsNegative();
  for (int i = 1; i <= triangulation->NbTriangles(); ++i) {
    int a = 0;
    int b = 0;
    int c = 0;
    triangulation->Triangle(i).Get(a, b, c);
    mesh.triangles.emplace_back(offset + a, offset + (turned ? c : b), offset + (turned ? b : c));
  }
}

/// mm, diagonal of the shape's box.
double size_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  return box.IsVoid() || box.IsOpen() ? 0 : std::sqrt(box.SquareExtent());
}

Mesh triangulated(const TopoDS_Shape& shape, double chord_tolerance) {
  const double size = size_of(shape);
  if (size > kLargestPart) chord_tolerance = std::max(chord_tolerance, kChordOverSize * size);
  BRepMesh_IncrementalMesh(shape, chord_tolerance, Standard_False, kLargestTurn, Standard_False);
  Mesh mesh;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
    add_face(TopoDS::Face(face.Current()), mesh);
  return mesh;
}

/// As STEP files spell them; millimetres, which OpenCASCADE has turned all coordinates into, for a name that
/// is not listed.
double metres_of(const std::string& unit) {
  static const std::map<std::string, double> units = {
      {"metre", 1},         {"meter", 1},         {"millimetre", 1e-3}, {"millimeter", 1e-3}, {"mm", 1e-3},
      {"micrometre", 1e-6}, {"centimetre", 1e-2}, {"centimeter", 1e-2}, {"inch", 0.0254},     {"in", 0.0254},
      {"foot", 0.3048},     {"ft", 0.3048},       {"kilometre", 1e3}};
  TCollection_AsciiString lower(unit.c_str());
  lower.LowerCase();
  lower.ChangeAll('\'', ' ');
  lower.LeftAdjust();
  lower.RightAdjust();
  const auto known = units.find(lower.ToCString());
  return known == units.end() ? kMillimetre : known->second;
}

/// Metres per unit; nothing where the file states none: its coordinates then are as if in millimetres.
std::optional<double> read_step(const std::string& file, const std::string& bytes,
                                Handle(TDocStd_Document) & document) {
  STEPCAFControl_Reader reader;
  reader.SetNameMode(Standard_True);
  reader.SetColorMode(Standard_False);
  reader.SetLayerMode(Standard_False);
  std::istringstream stream(bytes);
  if (reader.ChangeReader().ReadStream(file.c_str(), stream) != IFSelect_RetDone)
    throw std::runtime_error("it is not a STEP file or is truncated");
  TColStd_SequenceOfAsciiString lengths;
  TColStd_SequenceOfAsciiString angles;
  TColStd_SequenceOfAsciiString solid_angles;
  reader.ChangeReader().FileUnits(lengths, angles, solid_angles);
  if (!reader.Transfer(document)) {
    refuse_tessellation(bytes);
    throw std::runtime_error("none of its parts can be translated");
  }
  if (lengths.IsEmpty() || lengths.First().IsEmpty()) return std::nullopt;
  return metres_of(lengths.First().ToCString());
}

double read_iges(const std::string& file, Handle(TDocStd_Document) & document) {
  IGESCAFControl_Reader reader;
  reader.SetNameMode(Standard_True);
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone)
    throw std::runtime_error("it is not an IGES file or is truncated");
  const auto model = Handle(IGESData_IGESModel)::DownCast(reader.Model());
  const int flag = model.IsNull() ? 0 : model->GlobalSection().UnitFlag();
  const double millimetres = IGESData_BasicEditor::UnitFlagValue(flag);
  // OpenCASCADE does not say what it scales the coordinates by where it knows no unit.
  if (!(millimetres > 0))
    throw std::runtime_error("its unit of length (unit flag " + std::to_string(flag) +
                             ") is not supported: export the file in another unit, such as millimetres");
  if (!reader.Transfer(document)) throw std::runtime_error("none of its parts can be translated");
  return millimetres * kMillimetre;
}

CadParts read(const std::filesystem::path& file, const std::string& step, const CadFormat& format,
              double chord_tolerance) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  Handle(TDocStd_Document) document = new TDocStd_Document("parts");
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  const bool is_iges = format.ending == "iges" || format.ending == "igs";
  CadParts contents;
  if (is_iges)
    contents.metres_per_unit = read_iges(file.string(), document);
  else
    contents.metres_per_unit = read_step(file.string(), step, document);
  std::vector<Solid> solids = solids_of(document);
  const double chord = chord_tolerance / kMillimetre;
  if (solids.empty() && !is_iges) refuse_tessellation(step);
  sew_loose_faces(solids, chord, is_iges);
  const double file_units_per_millimetre = kMillimetre / contents.metres_per_unit.value_or(kMillimetre);
  for (const Solid& solid : solids) {
    contents.parts.push_back({solid.name, triangulated(solid.shape, chord), {}, solid.assemblies});
    for (auto& vertex : contents.parts.back().mesh.vertices) vertex *= file_units_per_millimetre;
  }
  return contents;
}

}  // namespace

}  // namespace diefill::geometry

void diefill_read_step_or_iges(const std::filesystem::path& file, const std::string& step,
                               const diefill::geometry::CadFormat& format, double chord_tolerance,
                               diefill::geometry::CadParts& contents) {
  try {
    contents = diefill::geometry::read(file, step, format, chord_tolerance);
  } catch (const Standard_Failure& failure) {
    const std::string words = failure.GetMessageString();
    throw std::runtime_error(words.empty() ? failure.DynamicType()->Name() : words);
  }
}
