#include "tests/step_files/step_file.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <map>
#include <numbers>
#include <stdexcept>

namespace diefill::step_files {

namespace {

gp_Pnt corner(const std::array<double, 3>& place) {
  return {place[0], place[1], place[2]};
}

TopoDS_Shape shape_of(const Block& block) {
  return BRepPrimAPI_MakeBox(corner(block.lower), corner(block.upper)).Shape();
}

TopoDS_Shape shape_of(const StepPart& part) {
  TopoDS_Shape shape = shape_of(part.block);
  for (const Block& block : part.cut) shape = BRepAlgoAPI_Cut(shape, shape_of(block)).Shape();
  return shape;
}

TopLoc_Location location_of(const StepPlace& place) {
  gp_Trsf turn, move;
  turn.SetRotation(gp::OZ(), place.quarter_turns * std::numbers::pi / 2);
  move.SetTranslation(gp_Vec(place.move[0], place.move[1], place.move[2]));
  return {move * turn};
}

void name(const TDF_Label& label, const std::string& text) {
  TDataStd_Name::Set(label, TCollection_ExtendedString(text.c_str()));
}

}  // namespace

void write_step(const std::filesystem::path& file, const std::vector<StepPart>& parts,
                const std::vector<StepAssembly>& assemblies) {
  const Handle(TDocStd_Document) document = new TDocStd_Document("parts");
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  std::map<std::string, TDF_Label> products;
  for (const StepPart& part : parts) {
    products[part.name] = shapes->AddShape(shape_of(part), false);
    name(products[part.name], part.name);
  }
  for (const StepAssembly& assembly : assemblies) {
    const TDF_Label label = shapes->NewShape();
    name(label, assembly.name);
    for (const StepUse& use : assembly.uses)
      name(shapes->AddComponent(label, products.at(use.product), location_of(use.place)), use.product);
    products[assembly.name] = label;
  }
  shapes->UpdateAssemblies();
  Message::DefaultMessenger()->ChangePrinters().Clear();  // the writer would tell each step
  STEPCAFControl_Writer writer;
  if (!writer.Transfer(document) || writer.Write(file.c_str()) != IFSelect_RetDone)
    throw std::runtime_error("no STEP file could be written");
}

}  // namespace diefill::step_files
