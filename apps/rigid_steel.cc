// The steel of the program that knows no elastic one.
#include <filesystem>
#include <stdexcept>

#include "apps/errors.h"
#include "apps/program.h"
#include "apps/steel.h"

namespace apps {
namespace {

// use_program_of has gone on as another program before a scene of elastic steel comes here.
Steel rigid(bool elastic) {
  if (elastic) throw std::logic_error("elastic steel in the program that knows none");
  return nullptr;
}

}  // namespace

Steel make_steel(const std::optional<ElasticHeadScene>& scene, const Machine&, const NumericsScene&,
                 dem::Wall&) {
  return rigid(scene.has_value());
}

Steel make_steel(const std::optional<ElasticMouldScene>& scene, const Machine&,
                 const NumericsScene&, dem::Wall&) {
  return rigid(scene.has_value());
}

void use_program_of(const GyratoryScene& scene, const std::vector<std::string>& command_line) {
  if (!scene.head.elastic && !scene.mould.elastic) return;
  const std::string program =
      std::filesystem::canonical("/proc/self/exe").parent_path() / "gyratory_elastic";
  become(program, command_line);
  throw InputError({scene.where(scene.head.elastic ? "head.elastic" : "mould.elastic") +
                    ": expected rigid steel, as " + program +
                    " cannot be run, found elastic; configure with GYRATORY_WITH_FEM=ON, or set "
                    "head.elastic and mould.elastic to \"none\""});
}

}  // namespace apps
