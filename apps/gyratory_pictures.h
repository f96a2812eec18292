// The ParaView series of a gyratory run: stones, head and mould, each rigid or bent.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "apps/archive.h"
#include "apps/pictures.h"
#include "apps/steel.h"
#include "dem/particle_store.h"

namespace apps {

// A wall and the elastic steel behind it.
struct MachinePart {
  const dem::Wall& wall;
  const SteelPart* steel;  // none: rigid
};

class GyratoryPictures {
 public:
  explicit GyratoryPictures(const std::string& folder);

  // Adds the pictures of a time [s]; coordination as in draw_stones.
  void draw(double time, const dem::ParticleStore& stones, const std::vector<int>& coordination,
            const MachinePart& head, const MachinePart& mould);

  void visit_state(Archive& item);  // see dem/state.h

 private:
  std::string folder_;
  int drawn_ = 0;
  double last_time_ = -std::numeric_limits<double>::infinity();  // of a picture [s]
  Series stones_, head_, mould_;
};

}  // namespace apps
