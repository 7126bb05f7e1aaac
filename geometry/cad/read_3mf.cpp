#include <Common/NMR_ErrorConst.h>
#include <Model/COM/NMR_DLLInterfaces.h>

#include <Eigen/Geometry>
#include <memory>
#include <stdexcept>

#include "geometry/cad/cad_readers.h"

namespace diefill::geometry {

namespace {

constexpr std::size_t kMaxParts = 100000, kMaxCorners = 100000000;
constexpr std::size_t kDeepestNesting =
    32;  // of components in components; a file that nests without end has a loop

struct Release {
  void operator()(void* object) const { NMR::lib3mf_release(static_cast<NMR::PLib3MFBase*>(object)); }
};
using Handle = std::unique_ptr<void, Release>;

/// Throws with the library's message when a call failed.
void check(HRESULT outcome, void* object) {
  if (outcome == LIB3MF_OK) return;
  DWORD code = 0;
  LPCSTR words = nullptr;
  NMR::lib3mf_getlasterror(static_cast<NMR::PLib3MFBase*>(object), &code, &words);
  throw std::runtime_error(words != nullptr && *words != '\0' ? std::string(words)
                                                              : "error " + std::to_string(code));
}

/// x_parent = rotation x + translation.
using Placement = Eigen::Affine3d;

Placement placement_of(const NMR::MODELTRANSFORM& transform) {
  Placement placement = Placement::Identity();
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row)
      placement.matrix()(row, column) = static_cast<double>(transform.m_fFields[row][column]);
  return placement;
}

void add_mesh(void* object, const Placement& placement, Mesh& mesh) {
  auto* piece = static_cast<NMR::PLib3MFModelMeshObject*>(object);
  DWORD vertices = 0;
  DWORD triangles = 0;
  check(NMR::lib3mf_meshobject_getvertexcount(piece, &vertices), object);
  check(NMR::lib3mf_meshobject_gettrianglecount(piece, &triangles), object);
  const int offset = static_cast<int>(mesh.vertices.size());
  for (DWORD i = 0; i < vertices; ++i) {
    NMR::MODELMESHVERTEX vertex;
    check(NMR::lib3mf_meshobject_getvertex(piece, i, &vertex), object);
    mesh.vertices.push_back(placement * Eigen::Vector3f(vertex.m_fPosition).cast<double>());
  }
  const bool mirrored = placement.linear().determinant() < 0;
  for (DWORD i = 0; i < triangles; ++i) {
    NMR::MODELMESHTRIANGLE triangle;
    check(NMR::lib3mf_meshobject_gettriangle(piece, i, &triangle), object);
    const auto corner = [&](int k) { return offset + static_cast<int>(triangle.m_nIndices[k]); };
    mesh.triangles.emplace_back(corner(0), corner(mirrored ? 2 : 1), corner(mirrored ? 1 : 2));
  }
}

std::string name_of(void* object) {
  auto* resource = static_cast<NMR::PLib3MFModelObjectResource*>(object);
  ULONG length = 0;
  if (NMR::lib3mf_object_getnameutf8(resource, nullptr, 0, &length) != LIB3MF_OK || length == 0) return "";
  std::string name(length + 1, '\0');
  if (NMR::lib3mf_object_getnameutf8(resource, name.data(), length + 1, &length) != LIB3MF_OK) return "";
  return name.c_str();
}

/// Whether it only holds other objects up while they are printed.
bool is_support(void* object) {
  DWORD type = NMR::MODELOBJECTTYPE_MODEL;
  check(NMR::lib3mf_object_gettype(static_cast<NMR::PLib3MFModelObjectResource*>(object), &type), object);
  return type == NMR::MODELOBJECTTYPE_SUPPORT || type == NMR::MODELOBJECTTYPE_SOLIDSUPPORT;
}

/// Walks down from the build items: every mesh object but supports is a part, called by its own name or that
/// of the components round it.
class Collector {
 public:
  explicit Collector(std::vector<CadPart>& parts) : parts_(parts) {}
  std::size_t supports() const { return supports_; }

  void add(void* object, const Placement& placement, const std::vector<std::string>& assemblies,
           const std::string& name) {
    if (assemblies.size() > kDeepestNesting)
      throw std::runtime_error("its components contain each other recursively");
    auto* resource = static_cast<NMR::PLib3MFModelObjectResource*>(object);
    BOOL is_mesh = 0;
    check(NMR::lib3mf_object_ismeshobject(resource, &is_mesh), object);
    const std::string own = name_of(object);
    const std::string& called = own.empty() ? name : own;
    if (!is_mesh) return add_components(object, placement, assemblies, called);
    if (is_support(object)) {
      ++supports_;
      return;
    }
    if (parts_.size() == kMaxParts) throw std::runtime_error("its components produce too many parts");
    parts_.push_back({called, {}, {}, assemblies});
    add_mesh(object, placement, parts_.back().mesh);
    corners_ += parts_.back().mesh.vertices.size();
    if (corners_ > kMaxCorners) throw std::runtime_error("its components produce too many corners");
  }

 private:
  void add_components(void* object, const Placement& placement, std::vector<std::string> assemblies,
                      const std::string& name) {
    assemblies.push_back(name + "#" + std::to_string(++places_));
    DWORD components = 0;
    auto* group = static_cast<NMR::PLib3MFModelComponentsObject*>(object);
    check(NMR::lib3mf_componentsobject_getcomponentcount(group, &components), object);
    for (DWORD i = 0; i < components; ++i) {
      NMR::PLib3MFModelComponent* component = nullptr;
      check(NMR::lib3mf_componentsobject_getcomponent(group, i, &component), object);
      const Handle held(component);
      NMR::PLib3MFModelObjectResource* inner = nullptr;
      check(NMR::lib3mf_component_getobjectresource(component, &inner), component);
      const Handle held_inner(inner);
      NMR::MODELTRANSFORM transform;
      check(NMR::lib3mf_component_gettransform(component, &transform), component);
      add(inner, placement * placement_of(transform), assemblies, name);
    }
  }

  std::vector<CadPart>& parts_;
  std::size_t places_ = 0, corners_ = 0, supports_ = 0;
};

void add_item(NMR::PLib3MFModelBuildItem* item, Collector& collector) {
  NMR::PLib3MFModelObjectResource* object = nullptr;
  check(NMR::lib3mf_builditem_getobjectresource(item, &object), item);
  const Handle held(object);
  BOOL is_placed = 0;
  check(NMR::lib3mf_builditem_hasobjecttransform(item, &is_placed), item);
  Placement placement = Placement::Identity();
  if (is_placed) {
    NMR::MODELTRANSFORM transform;
    check(NMR::lib3mf_builditem_getobjecttransform(item, &transform), item);
    placement = placement_of(transform);
  }
  collector.add(object, placement, {}, "");
}

/// The library takes a unit that it does not know for millimetres, with a warning.
void refuse_unknown_unit(NMR::PLib3MFModelReader* reader) {
  DWORD warnings = 0;
  check(NMR::lib3mf_reader_getwarningcount(reader, &warnings), reader);
  for (DWORD i = 0; i < warnings; ++i) {
    DWORD code = 0;
    ULONG length = 0;
    check(NMR::lib3mf_reader_getwarningutf8(reader, i, &code, nullptr, 0, &length), reader);
    if (code == NMR_ERROR_INVALIDMODELUNIT)
      throw std::runtime_error(
          "its unit is unknown, allowed: micron, millimeter, centimeter, inch, foot, meter");
  }
}

double unit_of(NMR::PLib3MFModel* model) {
  DWORD unit = NMR::MODELUNIT_MILLIMETER;
  check(NMR::lib3mf_model_getunit(model, &unit), model);
  switch (unit) {
    case NMR::MODELUNIT_MICROMETER:
      return 1e-6;
    case NMR::MODELUNIT_CENTIMETER:
      return 1e-2;
    case NMR::MODELUNIT_INCH:
      return 0.0254;
    case NMR::MODELUNIT_FOOT:
      return 0.3048;
    case NMR::MODELUNIT_METER:
      return 1;
    default:
      return 1e-3;
  }
}

}  // namespace

CadParts read_3mf(const std::filesystem::path& file) {
  NMR::PLib3MFModel* model = nullptr;
  check(NMR::lib3mf_createmodel(&model), nullptr);
  const Handle held_model(model);
  NMR::PLib3MFModelReader* reader = nullptr;
  check(NMR::lib3mf_model_queryreader(model, "3mf", &reader), model);
  const Handle held_reader(reader);
  check(NMR::lib3mf_reader_readfromfileutf8(reader, file.string().c_str()), reader);
  refuse_unknown_unit(reader);

  CadParts contents;
  Collector collector(contents.parts);
  contents.metres_per_unit = unit_of(model);
  NMR::PLib3MFModelBuildItemIterator* items = nullptr;
  check(NMR::lib3mf_model_getbuilditems(model, &items), model);
  const Handle held_items(items);
  for (BOOL more = 0;;) {
    check(NMR::lib3mf_builditemiterator_movenext(items, &more), items);
    if (!more) break;
    NMR::PLib3MFModelBuildItem* item = nullptr;
    check(NMR::lib3mf_builditemiterator_getcurrent(items, &item), items);
    const Handle held(item);
    add_item(item, collector);
  }
  if (collector.supports() > 0)
    contents.remarks.push_back("supports for printing ignored: " + std::to_string(collector.supports()));
  return contents;
}

}  // namespace diefill::geometry
