// The steel of the program that knows no elastic one.
#include <cassert>
#include <filesystem>

#include "apps/errors.h"
#include "apps/program.h"
#include "apps/steel.h"

namespace apps {

Steel make_steel(const ElasticHeadScene&, const Machine&, const NumericsScene&, dem::Wall&) {
  assert(false);  // use_program_of has not come back
  return nullptr;
}

Steel make_steel(const ElasticMouldScene&, const Machine&, const NumericsScene&, dem::Wall&) {
  assert(false);
  return nullptr;
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
