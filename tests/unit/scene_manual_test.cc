#include "apps/scene_manual.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>

#include "apps/sections.h"
#include "apps/text.h"
#include "tests/unit/scene_fixture.h"

namespace {

using nlohmann::json;
using SceneManual = tests::SceneTest;

// What each parameter with a default holds, as the manual would show it.
template <class Scene>
std::vector<std::string> defaults_of(Scene scene) {
  const apps::UnitSystem units;
  std::vector<std::string> lines;
  for (const apps::Section& section : apps::describe(scene)) {
    for (const apps::Parameter& parameter : section.parameters) {
      if (parameter.presence.need == apps::Need::has_default)
        lines.push_back(section.name + '.' + parameter.name + " = " +
                        apps::as_toml(parameter, units));
    }
  }
  return lines;
}

TEST_F(SceneManual, of_gyratory_compaction_is_a_scene_with_every_default) {
  // Printing and reading are inverse: what the manual shows is what a silent scene holds.
  files_.write("gradations/sma11.csv", tests::sieves);
  const auto scene = read(apps::gyratory_scene_manual());
  EXPECT_EQ(defaults_of(scene), defaults_of(apps::GyratoryScene{}));
  EXPECT_TRUE(scene.stones.fracture && scene.binder && scene.mould.elastic && scene.head.elastic);
  EXPECT_NEAR(scene.gyration.pressure, 600e3, 1e-9);
}

TEST_F(SceneManual, of_the_flow_test_is_a_scene_with_every_default) {
  // As above.
  files_.write("gradations/sma11.csv", tests::sieves);
  const auto scene =
      apps::read_flow_scene(files_.write("flow.toml", apps::flow_scene_manual()), {});
  EXPECT_EQ(defaults_of(scene), defaults_of(apps::FlowTestScene{}));
}

TEST_F(SceneManual, has_a_schema_that_knows_the_same_keys) {
  // JSON Schema, draft 2020-12: properties, required, exclusiveMinimum; bare numbers are in SI.
  const json schema = json::parse(apps::gyratory_scene_schema());
  apps::GyratoryScene scene;
  for (const apps::Section& section : apps::describe(scene)) {
    std::string pointer = "/properties/" + section.name;
    if (const auto dot = pointer.find('.'); dot != std::string::npos)
      pointer.replace(dot, 1, "/properties/");
    const json& object = schema.at(json::json_pointer(pointer));
    EXPECT_FALSE(object.at("additionalProperties"));
    for (const apps::Parameter& parameter : section.parameters)
      EXPECT_TRUE(object.at("properties").contains(parameter.name)) << section.name;
  }
  const json& properties = schema.at("properties");
  EXPECT_EQ(schema.at("required"), json::array({"stones"}));
  EXPECT_EQ(properties.at("stones").at("required"), json::array({"count", "gradation"}));
  const json& angle = properties.at("gyration").at("properties").at("angle");
  EXPECT_EQ(angle.at("default"), "1 deg");
  // 5 deg = 5 pi / 180 rad, rounded once.
  EXPECT_NEAR(angle.at("anyOf").at(0).at("maximum").get<double>(), 0.0872664625997165, 1e-16);
}

TEST_F(SceneManual, is_the_reference_page_of_the_docs) {
  // WRITE_PAGES=1 in the environment writes the page anew instead of comparing it.
  const std::string page = SCENES_FOLDER "/../docs/scene_keys.md";
  if (std::getenv("WRITE_PAGES")) std::ofstream(page) << apps::scene_reference();
  EXPECT_EQ(apps::read_text(page).value_or("no page"), apps::scene_reference());
}

}  // namespace
