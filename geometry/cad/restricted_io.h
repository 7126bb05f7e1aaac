// Files that an importer may open: the CAD file and, for formats of several files, those in its folder.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <filesystem>
#include <string>

namespace diefill::geometry {

/// File access for assimp. Other files than the CAD file itself are opened for glTF alone, and only
/// regular ones in the folder of the CAD file or below, wherever links lead.
class RestrictedIo : public Assimp::DefaultIOSystem {
 public:
  /// `ending` as CadFormat has it.
  RestrictedIo(std::filesystem::path file, std::string ending);

  bool Exists(const char* name) const override;
  Assimp::IOStream* Open(const char* name, const char* mode) override;

  /// Why the first file that was needed is not given, the CAD file itself too; empty where all were.
  const std::string& refused() const { return refused_; }

 private:
  std::filesystem::path place_of(const std::string& name) const;
  std::string reason_against(const std::filesystem::path& place) const;
  std::string bytes_of_main() const;

  std::filesystem::path file_;
  std::string ending_, refused_;
};

/// `text` with exponents after E where Fortran programs write D.
std::string with_exponents_behind_e(std::string text);

}  // namespace diefill::geometry
