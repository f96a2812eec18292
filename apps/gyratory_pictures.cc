#include "apps/gyratory_pictures.h"

#include <fmt/format.h>

#include "apps/stone_picture.h"

namespace apps {
namespace {

constexpr int sides = 64;  // edges that stand for a circle

Surface rigid_plate(const dem::Wall& plate) {
  const dem::Vec3d &o = plate.frame.origin, &n = plate.frame.ez;
  return disc({o.x, o.y, o.z}, {n.x, n.y, n.z}, std::get<dem::Disc>(plate.surface).radius, sides);
}

}  // namespace

GyratoryPictures::GyratoryPictures(const std::string& folder)
    : folder_(folder),
      stones_(folder + "/stones.pvd"),
      head_(folder + "/head.pvd"),
      mould_(folder + "/mould.pvd") {}

void GyratoryPictures::visit_state(Archive& item) {
  item("pictures.drawn", drawn_);
  item("pictures.last_time", last_time_);
  if (!item.restores()) return;
  stones_ = Series(folder_ + "/stones.pvd", last_time_);
  head_ = Series(folder_ + "/head.pvd", last_time_);
  mould_ = Series(folder_ + "/mould.pvd", last_time_);
}

void GyratoryPictures::draw(double time, const dem::ParticleStore& stones,
                            const std::vector<int>& coordination, const MachinePart& head,
                            const MachinePart& mould) {
  const auto named = [this](const char* name, bool steel) {
    return fmt::format("{}_{:04d}.{}", name, drawn_, steel ? "vtu" : "vtp");
  };
  const std::string stone_file = named("stones", false);
  draw_stones(folder_ + "/" + stone_file, stones, coordination);
  stones_.add(time, stone_file);

  const std::string head_file = named("head", head.steel);
  if (head.steel)
    head.steel->draw(folder_ + "/" + head_file, head.wall.frame);
  else
    write_polygons(folder_ + "/" + head_file, rigid_plate(head.wall), {});
  head_.add(time, head_file);

  const std::string mould_file = named("mould", mould.steel);
  if (mould.steel) {
    mould.steel->draw(folder_ + "/" + mould_file, mould.wall.frame);
  } else {
    const double radius = std::get<dem::CylinderInside>(mould.wall.surface).radius;
    write_polygons(folder_ + "/" + mould_file, tube(radius, 0, head.wall.frame.origin.z, sides),
                   {});
  }
  mould_.add(time, mould_file);
  last_time_ = time;
  ++drawn_;
}

}  // namespace apps
