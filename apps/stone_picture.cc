#include "apps/stone_picture.h"

#include "apps/pictures.h"

namespace apps {

void draw_stones(const std::string& vtp, const dem::ParticleStore& stones,
                 const std::vector<int>& coordination) {
  Eigen::Matrix3Xd place(3, stones.size());
  Array diameter = {"diameter [m]", 1, {}}, shell = {"diameter with shell [m]", 1, {}};
  Array radius = {"radius [m]", 1, {}}, thickness = {"shell thickness [m]", 1, {}};
  Array id = {"id [1]", 1, {}}, broken = {"broken [1]", 1, {}},
        touching = {"coordination [1]", 1, {}};
  Array velocity = {"velocity [m/s]", 3, {}};
  for (std::size_t k = 0; k < stones.size(); ++k) {
    place.col(k) << stones.position[k].x, stones.position[k].y, stones.position[k].z;
    diameter.values.push_back(2 * stones.radius[k]);
    shell.values.push_back(2 * stones.outer_radius(k));
    radius.values.push_back(stones.radius[k]);
    thickness.values.push_back(stones.shell);
    id.values.push_back(stones.id[k]);
    broken.values.push_back(!stones.softness.empty() && stones.softness[k] != 1);
    touching.values.push_back(coordination[k]);
    const dem::Vec3d& v = stones.velocity[k];
    velocity.values.insert(velocity.values.end(), {v.x, v.y, v.z});
  }
  write_points(vtp, place, {diameter, radius, shell, thickness, id, broken, touching, velocity});
}

}  // namespace apps
